//! Track: two rails, canted, set in place and deviating.
//!
//! A side is held as a right-hand one: `y` to the field side. The left side is its mirror image.

mod from_above;
mod guard;

use crate::curve::CurvePoint;
use crate::search::threshold;
use crate::slices::SliceSurface;
use crate::variation::RailVariation;
use crate::{GeometryError, Profile, Role, Roller, Side};

use from_above::{Station, Stretches};

/// Spacing of the stations between which a rail is looked up (m).
const STATION_SPACING: f64 = 2.5e-4;
/// A head further than this from the profile's origin is already in its place in the track (m).
const FAR: f64 = 0.2;

/// Position of a rail across the track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// The head's nearest point to the track centre, down to `height` (m) below its highest
    /// point, lies at half of `gauge` (m).
    Gauge {
        /// Distance between the two rails' nearest points (m).
        gauge: f64,
        /// Depth down to which they are looked for (m).
        height: f64,
    },
    /// The profile's origin lies that far from the track centre (m).
    Origin(f64),
    /// The profile's origin lies that far from the track centre and that far below the track plane (m),
    /// wherever the highest point is.
    At([f64; 2]),
}

impl Place {
    /// By the gauge (m) and the depth (m) above which it is measured.
    #[must_use]
    pub fn gauge(gauge: f64, height: f64) -> Self {
        Self::Gauge { gauge, height }
    }
}

/// Deviation of a rail from where it was laid, as irregular or yielding track has it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Deviation {
    /// Shift to the right (m).
    pub y: f64,
    /// Shift downwards (m).
    pub z: f64,
    /// Turn about the track's `x` through the profile's origin (rad); positive by the right-hand rule,
    /// which lowers what lies to the right.
    pub roll: f64,
}

/// A rail, canted and set in place, raised until its highest point touches the plane `z = 0` unless its
/// height is given.
#[derive(Debug, Clone, PartialEq)]
pub struct Rail {
    profile: Profile,
    rotation: (f64, f64),
    shift: [f64; 2],
    /// The part of the profile that it is, by arc length (m): all of it, but of grooved rails.
    part: [f64; 2],
    /// The part of that that a wheel can see from above, `y` rising.
    visible: Vec<Station>,
    /// Whether it ends at walls, on the track side and on the field side.
    walls: [bool; 2],
    variation: Option<RailVariation>,
    /// Whether it is a roller's rim.
    roller: Option<Roller>,
    /// A second rail beside it, on which the flange's back runs.
    guard: Option<Box<Rail>>,
    /// Of slices what a wheel can see: patch by patch, slice by slice the stretches on which `y` rises.
    seen: Vec<Vec<Stretches>>,
}

/// A turn, as cosine and sine, after another.
fn turned((cos, sin): (f64, f64), (turn_cos, turn_sin): (f64, f64)) -> (f64, f64) {
    (cos * turn_cos - sin * turn_sin, sin * turn_cos + cos * turn_sin)
}

impl Rail {
    /// Sets a rail's `profile` in place. A positive `cant` (rad) inclines the head towards the
    /// track centre.
    ///
    /// # Errors
    /// [`GeometryError`] for a wheel's profile, values not finite, and a head too low or too
    /// short for its gauge to be measured.
    pub fn new(profile: &Profile, cant: f64, place: Place) -> Result<Self, GeometryError> {
        Self::of_part(profile, [0.0, profile.curve().length()], cant, place)
    }

    fn of_part(
        profile: &Profile,
        part: [f64; 2],
        cant: f64,
        place: Place,
    ) -> Result<Self, GeometryError> {
        if profile.role() != Role::Rail {
            return Err(GeometryError::NotA { role: Role::Rail });
        }
        if cant.is_nan() || cant.abs() >= 1.0 {
            return Err(GeometryError::Value { name: "cant", value: cant, range: "-1 to 1 rad" });
        }
        let (sin, cos) = (-cant).sin_cos();
        let mut rail = Self {
            profile: profile.clone(),
            rotation: (cos, sin),
            shift: [0.0; 2],
            part,
            visible: vec![],
            walls: [false; 2],
            variation: None,
            roller: None,
            guard: None,
            seen: vec![],
        };
        let stations = rail.stations();
        rail.shift[1] = match place {
            Place::At([_, z]) if z.is_finite() => z,
            Place::At([_, value]) => {
                return Err(GeometryError::Value { name: "rail_height", value, range: "finite" });
            }
            _ => -rail.highest(&stations).z,
        };
        rail.shift[0] = rail.offset(&stations, place)?;
        rail.look()?;
        Ok(rail)
    }

    /// Arc lengths at which it is looked at.
    fn stations(&self) -> Vec<f64> {
        let [from, to] = self.part;
        let stations = self.profile.curve().stations(STATION_SPACING);
        stations.into_iter().filter(|s| (from..=to).contains(s)).collect()
    }

    /// The same rail shifted and turned from where it was laid: gauge and height are not measured
    /// anew.
    ///
    /// # Errors
    /// [`GeometryError::Value`] for a shift that is not finite or a turn of half a radian and more.
    pub fn displaced(&self, side: Side, deviation: Deviation) -> Result<Self, GeometryError> {
        let Deviation { y, z, roll } = deviation;
        for (name, value) in [("dy", y), ("dz", z)] {
            if !value.is_finite() {
                return Err(GeometryError::Value { name, value, range: "finite" });
            }
        }
        if roll.is_nan() || roll.abs() >= 0.5 {
            let range = "-0.5 to 0.5 rad";
            return Err(GeometryError::Value { name: "droll", value: roll, range });
        }
        let (turn_sin, turn_cos) = (side.sense() * roll).sin_cos();
        let rotation = turned(self.rotation, (turn_cos, turn_sin));
        let shift = [self.shift[0] + side.sense() * y, self.shift[1] + z];
        let roller = match self.roller {
            Some(_) if roll.abs() > 0.0 => {
                let range = "0 on a roller, whose axle lies along y";
                return Err(GeometryError::Value { name: "droll", value: roll, range });
            }
            roller => roller.map(|roller| roller.lowered(z)),
        };
        let mut rail = Self { rotation, shift, roller, ..self.clone() };
        rail.look()?;
        if let Some(guard) = rail.guard.as_deref_mut() {
            guard.go_with((self.shift, shift), (turn_cos, turn_sin))?;
        }
        Ok(rail)
    }

    /// The same rail where it lies with another profile, as it wears: gauge and height are not measured anew.
    ///
    /// # Errors
    /// [`GeometryError`] for a wheel's profile, and one that no wheel can see from above.
    pub fn with_profile(&self, profile: &Profile) -> Result<Self, GeometryError> {
        if profile.role() != Role::Rail {
            return Err(GeometryError::NotA { role: Role::Rail });
        }
        if self.part[1] - self.part[0] < self.profile.curve().length() {
            return Err(GeometryError::GroovedWears);
        }
        let part = [0.0, profile.curve().length()];
        let mut rail = Self { profile: profile.clone(), part, ..self.clone() };
        rail.look()?;
        Ok(rail)
    }

    /// The same rail with waves or slices along the track. What is of no height changes nothing.
    ///
    /// With slices its own profile, by which it was laid, should be [`SliceSurface::profile`].
    ///
    /// # Errors
    /// [`GeometryError`] for waves that are none.
    pub fn with_variation(self, variation: RailVariation) -> Result<Self, GeometryError> {
        let variation = variation.pruned()?;
        if let (Some(_), Some(roller)) = (&variation, self.roller) {
            let range = "left out where the rail has slices or corrugation";
            return Err(GeometryError::Value {
                name: "roller_radius",
                value: roller.radius(),
                range,
            });
        }
        let mut rail = Self { variation, ..self };
        rail.seen = rail.rising_stretches();
        Ok(rail)
    }

    /// How it varies along the track; `None` where it is a prism.
    #[must_use]
    pub fn variation(&self) -> Option<&RailVariation> {
        self.variation.as_ref()
    }

    /// The same profile as the rim of a roller, on whose top it lies.
    ///
    /// # Errors
    /// [`GeometryError::Value`] where the rail has slices or waves along it, or its profile reaches to the axle.
    pub fn on_roller(self, roller: Roller) -> Result<Self, GeometryError> {
        let value = roller.radius();
        let name = "roller_radius";
        if self.variation.is_some() {
            let range = "left out where the rail has slices or corrugation";
            return Err(GeometryError::Value { name, value, range });
        }
        let reaches = |station: &Station| (roller.axle() - station.z) * value <= 0.0;
        if self.visible.iter().any(reaches) {
            let range = "larger than the profile is deep";
            return Err(GeometryError::Value { name, value, range });
        }
        Ok(Self { roller: Some(roller), ..self })
    }

    /// The roller of whose rim it is the profile; `None` where it is a rail.
    #[must_use]
    pub fn roller(&self) -> Option<Roller> {
        self.roller
    }

    /// Whether its height changes along the track.
    pub(crate) fn varies(&self) -> bool {
        self.variation.is_some() || self.roller.is_some()
    }

    pub(crate) fn slices(&self) -> Option<&SliceSurface> {
        self.variation.as_ref()?.slices.as_deref()
    }

    /// What waves add to its height (m, down) at a place along the track, and the slope.
    pub(crate) fn down(&self, u: f64) -> [f64; 2] {
        self.variation.as_ref().map_or([0.0; 2], |variation| variation.down(u))
    }

    /// The shortest wave along the track (m).
    pub(crate) fn shortest(&self) -> f64 {
        self.variation.as_ref().map_or(f64::INFINITY, RailVariation::shortest)
    }

    /// A direction of the profile's axes in those of the track.
    pub(crate) fn rotated(&self, [y, z]: [f64; 2]) -> [f64; 2] {
        let (cos, sin) = self.rotation;
        [cos * y - sin * z, sin * y + cos * z]
    }

    /// A place of the profile in the track.
    pub(crate) fn placed(&self, place: [f64; 2]) -> [f64; 2] {
        let [y, z] = self.rotated(place);
        [y + self.shift[0], z + self.shift[1]]
    }

    /// The profile as given.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// Turn of the profile against its own axes (rad), on a right-hand rail: cant and what it was turned by.
    #[must_use]
    pub fn inclination(&self) -> f64 {
        let (cos, sin) = self.rotation;
        sin.atan2(cos)
    }

    /// Distance of the profile's origin from the track centre, and its `z` in the track (m).
    #[must_use]
    pub fn origin(&self) -> [f64; 2] {
        self.shift
    }

    /// The point at arc length `s`, in track coordinates of a right-hand rail.
    pub(crate) fn at(&self, s: f64) -> CurvePoint {
        self.profile.curve().at(s).moved(self.rotation, self.shift)
    }

    /// The highest point: where the tangent is level, else the highest station.
    fn highest(&self, stations: &[f64]) -> CurvePoint {
        let lowest = |a: CurvePoint, b: CurvePoint| if b.z < a.z { b } else { a };
        let level = stations.windows(2).filter_map(|pair| {
            let rises = |s: f64| self.at(s).tangent[1] < 0.0;
            let inside = rises(pair[0]) && !rises(pair[1]);
            inside.then(|| self.at(threshold([pair[0], pair[1]], rises)[1]))
        });
        stations.iter().map(|&s| self.at(s)).chain(level).fold(self.at(0.0), lowest)
    }

    /// How far the origin stands from the track centre.
    fn offset(&self, stations: &[f64], place: Place) -> Result<f64, GeometryError> {
        let (gauge, height) = match place {
            Place::Origin(position) | Place::At([position, _]) if position.is_finite() => {
                let head = self.highest(stations).y;
                if head.min(position) > FAR {
                    return Err(GeometryError::RailOff { head, position });
                }
                return Ok(position);
            }
            Place::Origin(value) | Place::At([value, _]) => {
                return Err(GeometryError::Value { name: "rail_position", value, range: "finite" });
            }
            Place::Gauge { gauge, height } => (gauge, height),
        };
        if !(gauge > 0.0 && gauge.is_finite()) {
            return Err(GeometryError::Value { name: "gauge", value: gauge, range: "above 0 m" });
        }
        if !(height > 0.0 && height.is_finite()) {
            let range = "above 0 m";
            return Err(GeometryError::Value { name: "gauge_height", value: height, range });
        }
        let lowest = stations.first().map_or(0.0, |&s| self.at(s).z);
        if lowest < height {
            return Err(GeometryError::HeadTooLow { depth: lowest, height });
        }
        Ok(0.5 * gauge - self.nearest(stations, height))
    }

    /// Least `y` down to the given depth, on the track side of the highest point.
    fn nearest(&self, stations: &[f64], height: f64) -> f64 {
        let deep = |s: f64| self.at(s).z > height;
        let overhangs = |s: f64| self.at(s).tangent[0] < 0.0;
        let mut nearest = f64::INFINITY;
        for pair in stations.windows(2) {
            let ends = [pair[0], pair[1]];
            let mut count = |s: f64| {
                if !deep(s) {
                    nearest = nearest.min(self.at(s).y);
                }
            };
            count(ends[1]);
            if deep(ends[0]) && !deep(ends[1]) {
                count(threshold(ends, deep)[1]);
            }
            if overhangs(ends[0]) && !overhangs(ends[1]) {
                count(threshold(ends, overhangs)[1]);
            }
        }
        nearest
    }
}

/// Two rails.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    /// The left rail, as its mirror image on the right.
    pub left: Rail,
    /// The right rail.
    pub right: Rail,
}

impl Track {
    /// Two like rails.
    ///
    /// # Errors
    /// [`GeometryError`] as by [`Rail::new`].
    pub fn new(profile: &Profile, cant: f64, place: Place) -> Result<Self, GeometryError> {
        let right = Rail::new(profile, cant, place)?;
        Ok(Self { left: right.clone(), right })
    }

    /// The rail of a side.
    #[must_use]
    pub fn rail(&self, side: Side) -> &Rail {
        match side {
            Side::Left => &self.left,
            Side::Right => &self.right,
        }
    }

    /// The same track with one rail shifted and turned from where it was laid.
    ///
    /// # Errors
    /// As by [`Rail::displaced`].
    pub fn displaced(self, side: Side, deviation: Deviation) -> Result<Self, GeometryError> {
        Ok(match side {
            Side::Left => Self { left: self.left.displaced(side, deviation)?, ..self },
            Side::Right => Self { right: self.right.displaced(side, deviation)?, ..self },
        })
    }
}
