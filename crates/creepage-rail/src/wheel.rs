//! Wheels on an axle, and the outline of a yawed or rolled wheel against the rail.

use crate::curve::CurvePoint;
use crate::slices::SliceSurface;
use crate::variation::WheelVariation;
use crate::{GeometryError, Profile, Role, Side};

/// Spacing of the stations at which the outline is looked at (m).
const STATION_SPACING: f64 = 2.5e-4;

/// Where the tape circle and the flange's tip lie from its back (m), mostly.
const TAPE: f64 = 0.070;
const TIP: f64 = 0.015;
/// A flange is higher than the first, and its tip nearer than the second to the profile's end (m).
const FLANGE: f64 = 0.012;
const END: f64 = 0.045;
/// Further than this from its place a tread, and a flange, is another's (m).
const FAR: f64 = 0.1;
const SHIFTED: f64 = 0.03;

/// A wheel.
#[derive(Debug, Clone, PartialEq)]
pub struct Wheel {
    profile: Profile,
    radius: f64,
    flange_back: f64,
    stations: Vec<(f64, CurvePoint)>,
    variation: Option<WheelVariation>,
}

impl Wheel {
    /// The largest nominal radius (m): a number above it is in another unit.
    const LARGEST: f64 = 10.0;

    /// A wheel from its profile and nominal radius (m); its flange back lies at the profile's
    /// `y = -0.070`.
    ///
    /// # Errors
    /// [`GeometryError`] for a rail's profile or a radius too small for it.
    pub fn new(profile: &Profile, radius: f64) -> Result<Self, GeometryError> {
        if profile.role() != Role::Wheel {
            return Err(GeometryError::NotA { role: Role::Wheel });
        }
        let stations = profile.curve().stations(STATION_SPACING).into_iter();
        let stations: Vec<_> = stations.map(|s| (s, profile.curve().at(s))).collect();
        let least = stations.iter().map(|(_, point)| point.z).fold(0.0, f64::min);
        if !(radius + least > 0.0 && radius <= Self::LARGEST) {
            let range = "large enough for the profile, at most 10 m";
            return Err(GeometryError::Value { name: "radius", value: radius, range });
        }
        let variation = None;
        Ok(Self { profile: profile.clone(), radius, flange_back: -0.070, stations, variation })
    }

    /// The same with flats, harmonics or slices. What is of no depth changes nothing.
    ///
    /// With slices its profile, of which stations and pictures are, should be that of
    /// [`SliceSurface::profile`].
    ///
    /// # Errors
    /// [`GeometryError::Value`] for harmonics that are none.
    pub fn with_variation(self, variation: WheelVariation) -> Result<Self, GeometryError> {
        Ok(Self { variation: variation.pruned(self.radius)?, ..self })
    }

    /// How it varies around the axle; `None` where it is a body of revolution.
    #[must_use]
    pub fn variation(&self) -> Option<&WheelVariation> {
        self.variation.as_ref()
    }

    pub(crate) fn varies(&self) -> bool {
        self.variation.is_some()
    }

    pub(crate) fn slices(&self) -> Option<&SliceSurface> {
        self.variation.as_ref()?.slices.as_deref()
    }

    /// What flats and harmonics add to the radius (m) at a material angle (rad), and its derivative.
    pub(crate) fn radial(&self, th: f64) -> [f64; 2] {
        self.variation.as_ref().map_or([0.0; 2], |variation| variation.radial(th, self.radius))
    }

    /// The shortest wave or feature along the circle (m).
    pub(crate) fn shortest(&self) -> f64 {
        let variation = self.variation.as_ref();
        variation.map_or(f64::INFINITY, |variation| variation.shortest(self.radius))
    }

    /// The same with its flange back at another `y` of the profile (m).
    ///
    /// # Errors
    /// [`GeometryError::Value`] unless finite.
    pub fn with_flange_back(self, flange_back: f64) -> Result<Self, GeometryError> {
        if flange_back.is_finite() {
            return Ok(Self { flange_back, ..self });
        }
        Err(GeometryError::Value { name: "flange_back", value: flange_back, range: "finite" })
    }

    /// Whether radius and flange back are those of the profile.
    fn check_origin(&self) -> Result<(), GeometryError> {
        let tape = self.flange_back + TAPE;
        let off = |(_, point): &&(f64, CurvePoint)| (point.y - tape).abs();
        let Some((_, tread)) = self.stations.iter().min_by(|a, b| off(a).total_cmp(&off(b))) else {
            return Ok(());
        };
        if tread.z.abs() > FAR {
            return Err(GeometryError::TreadOff { z: tread.z });
        }
        // The curve runs to the flange, whose tip is the lowest place near its end.
        let lowest = self.stations.iter().map(|(_, point)| point);
        let Some(tip) = lowest.max_by(|a, b| a.z.total_cmp(&b.z)) else { return Ok(()) };
        let end = self.profile.curve().before(self.profile.curve().length());
        let level = {
            let mut heights: Vec<f64> = self.stations.iter().map(|(_, point)| point.z).collect();
            heights.sort_by(f64::total_cmp);
            heights.get(heights.len() / 2).copied().unwrap_or(0.0)
        };
        let is_flange = tip.z - level > FLANGE && (tip.y - end.y).abs() < END;
        let fitting = tip.y - TIP;
        if is_flange && (fitting - self.flange_back).abs() > SHIFTED {
            let flange_back = self.flange_back;
            return Err(GeometryError::FlangeOff { tip: tip.y, flange_back, fitting });
        }
        Ok(())
    }

    /// Its profile.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// Its nominal radius (m).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// `y` of the profile at which its flange back lies (m).
    #[must_use]
    pub fn flange_back(&self) -> f64 {
        self.flange_back
    }

    /// The same wheel with another profile, as it wears.
    ///
    /// # Errors
    /// [`GeometryError`] as by [`Wheel::new`].
    pub fn with_profile(&self, profile: &Profile) -> Result<Self, GeometryError> {
        let variation = self.variation.clone();
        Ok(Self { flange_back: self.flange_back, variation, ..Self::new(profile, self.radius)? })
    }

    /// Arc lengths at which the outline is looked at, with the points there.
    pub(crate) fn stations(&self) -> &[(f64, CurvePoint)] {
        &self.stations
    }
}

/// Two wheels on an axle.
#[derive(Debug, Clone, PartialEq)]
pub struct Wheelset {
    pub(crate) left: Wheel,
    pub(crate) right: Wheel,
    pub(crate) back_to_back: f64,
}

impl Wheelset {
    /// Two wheels whose flange backs stand `back_to_back` (m) apart.
    ///
    /// # Errors
    /// [`GeometryError::Value`] unless `back_to_back` is positive and finite;
    /// [`GeometryError::TreadOff`], [`GeometryError::FlangeOff`] where the profile's origin is not
    /// that of radius and flange back.
    pub fn new(left: Wheel, right: Wheel, back_to_back: f64) -> Result<Self, GeometryError> {
        if back_to_back >= 0.0 && back_to_back.is_finite() {
            left.check_origin()?;
            right.check_origin()?;
            return Ok(Self { left, right, back_to_back });
        }
        let range = "0 m and above";
        Err(GeometryError::Value { name: "back_to_back", value: back_to_back, range })
    }

    /// Two like wheels.
    ///
    /// # Errors
    /// [`GeometryError`] as by [`Wheel::new`] and [`Wheelset::new`].
    pub fn like(profile: &Profile, radius: f64, back_to_back: f64) -> Result<Self, GeometryError> {
        let wheel = Wheel::new(profile, radius)?;
        Self::new(wheel.clone(), wheel, back_to_back)
    }

    /// Mean of the two nominal radii (m): the height of the axle over the track at `z = 0`.
    #[must_use]
    pub fn radius(&self) -> f64 {
        0.5 * (self.left.radius + self.right.radius)
    }

    /// Whether the left wheel is the mirror image of the right one.
    #[must_use]
    pub fn is_mirrored(&self) -> bool {
        self.left == self.right
    }

    /// The wheel of a side.
    #[must_use]
    pub fn wheel(&self, side: Side) -> &Wheel {
        match side {
            Side::Left => &self.left,
            Side::Right => &self.right,
        }
    }

    /// Distance between the tape circles (m).
    #[must_use]
    pub fn tape_distance(&self) -> f64 {
        self.back_to_back - self.left.flange_back - self.right.flange_back
    }
}

/// Pose of a wheelset in the track.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Position {
    /// Its centre to the right of the track centre (m).
    pub y: f64,
    /// Its centre downwards (m); at 0 the nominal circle touches the track plane.
    pub z: f64,
    /// Turn about the track's `x` (rad); positive lowers the right wheel.
    pub roll: f64,
    /// Turn about the wheelset's own `z`, which rolls with it (rad); positive turns the axle's
    /// right end back. The axle points along `(-sin yaw, cos yaw cos roll, cos yaw sin roll)`.
    pub yaw: f64,
}

impl Position {
    /// Seen in a mirror along the track.
    pub(crate) fn mirrored(self) -> Self {
        Self { y: -self.y, roll: -self.roll, yaw: -self.yaw, ..self }
    }

    /// # Errors
    /// [`GeometryError::Value`] names what is not finite or turned too far.
    pub(crate) fn check(self) -> Result<Self, GeometryError> {
        let lengths = [("y", self.y), ("z", self.z)];
        if let Some(&(name, value)) = lengths.iter().find(|(_, value)| !value.is_finite()) {
            return Err(GeometryError::Value { name, value, range: "finite" });
        }
        let turns = [("roll", self.roll), ("yaw", self.yaw)];
        match turns.iter().find(|(_, value)| value.is_nan() || value.abs() > 0.5) {
            Some(&(name, value)) => {
                Err(GeometryError::Value { name, value, range: "-0.5 to 0.5 rad" })
            }
            None => Ok(self),
        }
    }
}

/// A right-hand wheel in its position: a surface of revolution in track axes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Posed<'a> {
    pub(crate) wheel: &'a Wheel,
    /// The axle's centre (m).
    pub(crate) centre: [f64; 3],
    /// The tape circle's distance from it along the axle (m).
    arm: f64,
    /// Sine and cosine.
    roll: (f64, f64),
    yaw: (f64, f64),
    /// How far the wheel has rolled on (rad).
    pub(crate) pitch: f64,
}

/// A point of the outline: seen along the track, the wheel ends there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Outline {
    /// Arc length on the wheel's profile, and the angle around the axle (rad).
    pub(crate) s: f64,
    pub(crate) around: f64,
    /// Place in track axes (m).
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) z: f64,
    /// Slope `dz/dy` of the outline.
    pub(crate) slope: f64,
}

impl<'a> Posed<'a> {
    pub(crate) fn new(
        wheel: &'a Wheel,
        wheelset: &Wheelset,
        position: Position,
        pitch: f64,
    ) -> Self {
        Self {
            wheel,
            centre: [0.0, position.y, position.z - wheelset.radius()],
            arm: 0.5 * wheelset.back_to_back - wheel.flange_back,
            roll: position.roll.sin_cos(),
            yaw: position.yaw.sin_cos(),
            pitch,
        }
    }

    /// The tape circle's distance from the centre along the axle (m).
    pub(crate) fn arm(&self) -> f64 {
        self.arm
    }

    /// A vector of the wheelset's axes in those of the track.
    pub(crate) fn turned(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let (x, y) = (x * self.yaw.1 - y * self.yaw.0, x * self.yaw.0 + y * self.yaw.1);
        [x, y * self.roll.1 - z * self.roll.0, y * self.roll.0 + z * self.roll.1]
    }

    /// The point of the surface at an arc length of the profile and an angle around the axle.
    pub(crate) fn surface(&self, point: CurvePoint, around: f64) -> [f64; 3] {
        self.surface_towards(point, around.sin_cos())
    }

    /// The same with the angle's sine and cosine.
    fn surface_towards(&self, point: CurvePoint, (sin, cos): (f64, f64)) -> [f64; 3] {
        let radius = self.wheel.radius + point.z;
        let turned = self.turned([radius * sin, self.arm + point.y, radius * cos]);
        [0, 1, 2].map(|i| turned[i] + self.centre[i])
    }

    /// Derivatives of [`Posed::surface`] by arc length and by the angle.
    pub(crate) fn tangents(&self, point: CurvePoint, around: f64) -> [[f64; 3]; 2] {
        let (sin, cos) = around.sin_cos();
        let radius = self.wheel.radius + point.z;
        let [ty, tz] = point.tangent;
        [self.turned([tz * sin, ty, tz * cos]), self.turned([radius * cos, 0.0, -radius * sin])]
    }

    /// The outline at arc length `s`: where the surface's normal has no part along the track.
    ///
    /// `None` where the surface looks upwards, or turns its side to the track at all angles.
    pub(crate) fn outline(&self, s: f64) -> Option<Outline> {
        self.outline_at(s, self.wheel.profile.curve().at(s))
    }

    /// The same where the profile's point is known.
    pub(crate) fn outline_at(&self, s: f64, point: CurvePoint) -> Option<Outline> {
        let [ny, nz] = point.normal();
        if nz <= 0.0 {
            return None;
        }
        // The normal (n_z sin, n_y, n_z cos), yawed, has the part n_z sin cos_yaw - n_y sin_yaw.
        let sin = ny * self.yaw.0 / (nz * self.yaw.1);
        if sin.abs() >= 1.0 {
            return None;
        }
        let (around, cos) = (sin.asin(), ((1.0 - sin) * (1.0 + sin)).sqrt());
        let [x, y, z] = self.surface_towards(point, (sin, cos));
        let [_, normal_y, normal_z] = self.turned([nz * sin, ny, nz * cos]);
        (normal_z > 0.0).then_some(Outline { s, around, x, y, z, slope: -normal_y / normal_z })
    }
}
