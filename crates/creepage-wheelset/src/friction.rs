//! Friction on a rail: a number, a law by the speed of slip, or by the place on the rail.

use std::f64::consts::FRAC_PI_2;

use creepage::friction_law::{FrictionAcross, FrictionLaw, FrictionMemory, RollingFriction};
use creepage_rail::{Contact, Side};

use crate::error::{WheelsetError, checked};

const SECTION: &str = "contact friction";

/// Friction on a rail.
#[derive(Debug, Clone, PartialEq)]
pub enum RailFriction {
    /// Coulomb's.
    Constant(f64),
    /// By the speed of slip.
    Law(FrictionLaw, Option<FrictionMemory>),
    /// By the place on the rail.
    Place(FrictionOfPlace),
}

/// Friction that is linear between control points, constant beyond them.
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionOfPlace {
    by: PlaceOnRail,
    /// Angle (rad) or position (m), rising, and the coefficient there.
    points: Vec<[f64; 2]>,
}

/// Coordinate of a place on the rail, in the axes of its profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaceOnRail {
    /// Inclination of the surface (rad): negative on the gauge face, positive on the field side.
    Angle,
    /// The profile's `y` (m), to the field side.
    Position,
}

impl RailFriction {
    /// The largest coefficient: at rest, of all places.
    #[must_use]
    pub fn largest(&self) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Law(law, _) => law.at_rest(),
            Self::Place(of) => of.points.iter().fold(0.0, |most, [_, value]| value.max(most)),
        }
    }

    /// The least coefficient of all places; of a law by the speed of slip that at rest.
    #[must_use]
    pub fn least(&self) -> f64 {
        match self {
            Self::Place(of) => {
                of.points.iter().fold(f64::INFINITY, |most, [_, value]| value.min(most))
            }
            other => other.largest(),
        }
    }

    /// The largest coefficient on a contact and how friction varies on it, where wheels roll at `speed` (m/s).
    pub(crate) fn on(
        &self,
        contact: &Contact<'_>,
        speed: f64,
    ) -> Result<(f64, Option<RollingFriction>), WheelsetError> {
        let wrong = WheelsetError::invalid(SECTION);
        match self {
            Self::Constant(value) => Ok((*value, None)),
            Self::Law(law, memory) => {
                let rolling = RollingFriction::new(*law, *memory, speed).map_err(wrong)?;
                Ok((law.at_rest(), Some(rolling)))
            }
            Self::Place(of) => {
                let points = of.across(contact);
                let across = FrictionAcross::new(&points).map_err(&wrong)?;
                let rolling = RollingFriction::across(across).map_err(&wrong)?;
                Ok((across.largest(), Some(rolling)))
            }
        }
    }
}

impl FrictionOfPlace {
    /// Linear between `places` (rad or m), which rise, with the coefficients `values` there.
    ///
    /// # Errors
    /// [`WheelsetError::Invalid`] for fewer than two places, another number of values, places that do not
    /// rise, or coefficients that are not positive and finite.
    pub fn new(by: PlaceOnRail, places: &[f64], values: &[f64]) -> Result<Self, WheelsetError> {
        let count = values.len();
        let is_valid = count == places.len() && count >= 2;
        let valid = "as many as places, two at least";
        checked(SECTION, "number of values", count as f64, is_valid, valid)?;
        let (reach, valid) = match by {
            PlaceOnRail::Angle => (FRAC_PI_2, "above the one before, from -pi/2 to pi/2 (rad)"),
            PlaceOnRail::Position => (1.0, "above the one before, from -1 to 1 m"),
        };
        let mut points = Vec::with_capacity(count);
        for (&place, &value) in places.iter().zip(values) {
            let last = points.last().map_or(f64::NEG_INFINITY, |[place, _]: &[f64; 2]| *place);
            let is_valid = place > last && place.abs() <= reach;
            checked(SECTION, "place", place, is_valid, valid)?;
            let is_valid = value > 0.0 && value.is_finite();
            checked(SECTION, "value", value, is_valid, "positive and finite")?;
            points.push([place, value]);
        }
        Ok(Self { by, points })
    }

    /// Across a contact, as a theory of rolling takes it: by lines between few places, the next of which is always
    /// where these miss most.
    fn across(&self, contact: &Contact<'_>) -> Vec<[f64; 2]> {
        const LOOKED_UP: u32 = 64;
        /// Of the coefficient: as lines miss no result by more.
        const COEFFICIENT_TOLERANCE: f64 = 1e-4;
        let [low, high] = contact.extent[1];
        let inclination = contact.rail_inclination();
        let sense = contact.side.sense();
        let value = |k: u32| {
            let s = low + (high - low) * f64::from(k) / f64::from(LOOKED_UP);
            let across = contact.at(s)?;
            let place = match self.by {
                PlaceOnRail::Position => across.y_rail,
                PlaceOnRail::Angle => sense * (contact.angle + across.tilt) - inclination,
            };
            Some([s, self.at(place)])
        };
        let all: Vec<[f64; 2]> = (0..=LOOKED_UP).filter_map(value).collect();
        let ([first, .., last], 2..) = (all.as_slice(), all.len()) else {
            let place = match self.by {
                PlaceOnRail::Position => contact.y_rail,
                PlaceOnRail::Angle => sense * contact.angle - inclination,
            };
            return vec![[low, self.at(place)], [high, self.at(place)]];
        };
        let mut taken = vec![*first, *last];
        while taken.len() < FrictionAcross::MAX_PLACES {
            let missed = |point: &&[f64; 2]| (linear(&taken, point[0]) - point[1]).abs();
            let worst = all.iter().max_by(|a, b| missed(a).total_cmp(&missed(b)));
            let Some(worst) = worst.filter(|worst| missed(worst) > COEFFICIENT_TOLERANCE) else {
                break;
            };
            let place = taken.partition_point(|[s, _]| *s < worst[0]);
            taken.insert(place, *worst);
        }
        taken
    }

    /// The coefficient at an angle or a position.
    fn at(&self, place: f64) -> f64 {
        linear(&self.points, place)
    }
}

/// Linear between points that rise, constant beyond them.
fn linear(points: &[[f64; 2]], place: f64) -> f64 {
    let after = points.partition_point(|[at, _]| *at <= place);
    let before = after.checked_sub(1).and_then(|i| points.get(i));
    match (before, points.get(after)) {
        (Some([from, low]), Some([to, high])) => low + (high - low) * (place - from) / (to - from),
        (Some([_, value]), None) | (None, Some([_, value])) => *value,
        (None, None) => f64::NAN,
    }
}

/// Of one side.
pub(crate) fn of_side(friction: &[RailFriction; 2], side: Side) -> &RailFriction {
    let [left, right] = friction;
    if side == Side::Left { left } else { right }
}
