//! Frictional energy per metre rolled, of a contact and of the rows of its elements.

use crate::{SiCreepage, SiForce};

/// T gamma of a whole contact (N = J/m): forces times creepages, each product by its size.
///
/// The frictional power over the rolling velocity is the same sum with the signs of its products,
/// [`TGamma::power_per_metre`]; the two agree when every force has the sense of its own creepage.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TGamma {
    /// `|F_x upsilon_x| + |F_y upsilon_y|`.
    pub without_spin: f64,
    /// The same and `|M_z phi|`.
    pub with_spin: f64,
}

impl TGamma {
    /// From the forces of the upper body on the lower and the creepages that go with them.
    ///
    /// ```
    /// use creepage::damage::TGamma;
    /// use creepage::{SiCreepage, SiForce};
    /// let force = SiForce { longitudinal: -10e3, lateral: 5e3, moment: 10.0 };
    /// let creepage = SiCreepage { longitudinal: -2e-3, lateral: 1e-3, spin: 0.1 };
    /// let work = TGamma::new(force, creepage);
    /// assert!((work.without_spin - 25.0).abs() < 1e-12);
    /// assert!((work.with_spin - 26.0).abs() < 1e-12);
    /// ```
    #[must_use]
    pub fn new(force: SiForce, creepage: SiCreepage) -> Self {
        let without_spin = (force.longitudinal * creepage.longitudinal).abs()
            + (force.lateral * creepage.lateral).abs();
        Self { without_spin, with_spin: without_spin + (force.moment * creepage.spin).abs() }
    }

    /// The frictional power over the rolling velocity (J/m) of steady rolling,
    /// `F_x upsilon_x + F_y upsilon_y + M_z phi`.
    #[must_use]
    pub fn power_per_metre(force: SiForce, creepage: SiCreepage) -> f64 {
        force.longitudinal * creepage.longitudinal
            + force.lateral * creepage.lateral
            + force.moment * creepage.spin
    }
}

/// Traction, slip and pressure of one element of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ElementState {
    /// Mean pressure (Pa).
    pub pressure: f64,
    /// Mean tangential traction of the upper body on the lower (Pa).
    pub traction: [f64; 2],
    /// Slip velocity of the upper body over the lower, over the rolling velocity.
    pub slip: [f64; 2],
    /// Area (m2).
    pub area: f64,
    /// Length in the rolling direction (m), over which the material slides.
    pub length: f64,
}

/// Row of elements through which the material at one place across runs, from the leading edge or to it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Row {
    /// Place across, `y` (m).
    pub y: f64,
    /// Width (m).
    pub width: f64,
    /// Its elements.
    pub elements: Vec<ElementState>,
}

impl ElementState {
    /// Size of the tangential traction (Pa).
    #[must_use]
    pub fn shear(&self) -> f64 {
        self.traction[0].hypot(self.traction[1])
    }

    /// Distance that the surfaces slide over each other while the material is in the element (m).
    #[must_use]
    pub fn slip_distance(&self) -> f64 {
        self.slip[0].hypot(self.slip[1]) * self.length
    }

    /// Frictional work per metre rolled and area (N/m2): the local T gamma over the area.
    #[must_use]
    pub fn work(&self) -> f64 {
        self.traction[0] * self.slip[0] + self.traction[1] * self.slip[1]
    }

    /// Frictional work per metre rolled (J/m), of all elements the T gamma of the contact.
    #[must_use]
    pub fn power_per_metre(elements: &[Self]) -> f64 {
        elements.iter().map(|element| element.work() * element.area).sum()
    }
}
