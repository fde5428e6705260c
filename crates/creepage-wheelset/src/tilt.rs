//! Tilt of a contact plane in the track, and the identification of a contact among its neighbours.

use creepage_rail::{Contact, contact_axes};

use crate::solved::SolvedContact;

/// Turn about the track's `x`, then about the plane's own `s` (rad).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tilt {
    pub(crate) angle: f64,
    pub(crate) slope: f64,
}

impl Tilt {
    /// Directions of the plane's `x`, `s` and of its normal into the rail, in track axes.
    pub(crate) fn axes(self) -> [[f64; 3]; 3] {
        contact_axes(self.angle, self.slope)
    }

    /// How steeply the plane's `x`, its `s` and its normal go down.
    pub(crate) fn down(self) -> [f64; 3] {
        self.axes().map(|axis| axis[2])
    }

    /// Cosine of the angle between two normals.
    pub(crate) fn facing(self, other: Self) -> f64 {
        let ((dip, level), (other_dip, other_level)) =
            (self.slope.sin_cos(), other.slope.sin_cos());
        dip * other_dip + level * other_level * (self.angle - other.angle).cos()
    }

    /// A place of the plane in track axes.
    pub(crate) fn place(self, origin: [f64; 3], [x, s]: [f64; 2]) -> [f64; 3] {
        let [along, across, _] = self.axes();
        [0, 1, 2].map(|i: usize| origin[i] + x * along[i] + s * across[i])
    }

    /// Vertical part of a contact's force on the rail over its load, for lateral and longitudinal forces of
    /// `shares` times the load.
    pub(crate) fn vertical_ratio(self, [lateral, longitudinal]: [f64; 2]) -> f64 {
        let [along, across, normal] = self.down();
        normal + lateral * across + longitudinal * along
    }
}

/// Between the spots of contacts on a rail and on the guard rail beside it (m): these are no neighbours.
const TO_GUARD: f64 = 10.0;

/// Identity of a contact, by which it is found again in a position close by: `y` on the rail, and where surfaces
/// vary along rolling the place along the track too (m); those on a guard rail have a `y` of their own, far off.
pub(crate) trait Placed {
    fn tilt(&self) -> Tilt;
    fn spot(&self) -> [f64; 2];
}

impl Placed for Contact<'_> {
    fn tilt(&self) -> Tilt {
        Tilt { angle: self.angle, slope: self.slope }
    }

    fn spot(&self) -> [f64; 2] {
        let y = self.y_rail + if self.is_on_guard { TO_GUARD } else { 0.0 };
        [y, if self.varies() { self.reference[0] } else { 0.0 }]
    }
}

impl Placed for SolvedContact {
    fn tilt(&self) -> Tilt {
        Tilt { angle: self.angle, slope: self.slope }
    }

    fn spot(&self) -> [f64; 2] {
        let y = self.y_rail + if self.is_on_guard { TO_GUARD } else { 0.0 };
        [y, if self.varying.is_some() { self.reference[0] } else { 0.0 }]
    }
}

/// How far two spots lie apart (m).
pub(crate) fn distance(one: [f64; 2], other: [f64; 2]) -> f64 {
    (one[0] - other[0]).abs() + (one[1] - other[1]).abs()
}
