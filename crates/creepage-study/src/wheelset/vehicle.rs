//! A rigid vehicle in a canted curve: what its wheels carry at a speed.

use creepage_wheelset::Load;

use super::error::{WheelsetFileError, checked};

const WHEELSET: &str = "wheelset";
const GRAVITY: f64 = 9.806_65;

/// Mass and height of what a wheelset carries, and the cant of its track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VehicleInCurve {
    mass: f64,
    centre_height: f64,
    superelevation: f64,
    tapes: f64,
}

impl VehicleInCurve {
    /// `mass` (kg) whose centre stands `centre_height` (m) above the rails, on a track whose outer rail stands
    /// `superelevation` (m) higher; the wheels' running circles are `tapes` (m) apart.
    pub(super) fn new(
        [mass, centre_height, superelevation]: [f64; 3],
        tapes: f64,
    ) -> Result<Self, WheelsetFileError> {
        for (key, value) in [("mass", mass), ("centre_height", centre_height)] {
            let is_valid = value > 0.0 && value.is_finite();
            checked(WHEELSET, key, value, is_valid, "positive and finite")?;
        }
        let is_valid = superelevation.abs() < 0.5 * tapes;
        let valid = "less than half of the distance between the wheels' running circles";
        checked("track", "superelevation", superelevation, is_valid, valid)?;
        Ok(Self { mass, centre_height, superelevation, tapes })
    }

    /// The loads of both wheels at a speed (m/s) in a curve (1/m): it leans outwards by the acceleration in the plane of
    /// its track.
    pub(super) fn load(&self, speed: f64, curvature: f64) -> Result<Load, WheelsetFileError> {
        let tilt = (self.superelevation / self.tapes).asin();
        let outward = speed * speed * curvature.abs();
        let aside = outward * tilt.cos() - GRAVITY * tilt.sin();
        let down = GRAVITY * tilt.cos() + outward * tilt.sin();
        let (half, more) =
            (0.5 * self.mass * down, self.mass * aside * self.centre_height / self.tapes);
        let [outer, inner] = [half + more, half - more];
        let least = outer.min(inner);
        let valid = "positive: the vehicle overturns at this speed, radius and superelevation";
        checked(WHEELSET, "load of the lighter wheel in the curve", least, least > 0.0, valid)?;
        Ok(Load::Wheels(if curvature < 0.0 { [inner, outer] } else { [outer, inner] }))
    }
}
