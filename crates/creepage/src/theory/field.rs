//! Field at one point of the contact: traction, slip, and whether the surface sticks.

/// State of the surface at a point: stick or slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Region {
    /// Area of adhesion: no slip, traction below the bound.
    Adhesion,
    /// Area of slip: traction at the bound, in the direction of the slip.
    Slip,
    /// Outside the contact, or on its edge: neither traction nor slip is given.
    Outside,
}

impl Region {
    /// `"adhesion"`, `"slip"` or `"outside"`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Adhesion => "adhesion",
            Self::Slip => "slip",
            Self::Outside => "outside",
        }
    }
}

/// Traction and slip at a point of the contact, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldPoint {
    /// `(x, y)` in units of `c = sqrt(a b)`.
    pub position: [f64; 2],
    /// Traction on the lower body in units of the largest traction bound, `mu` times the peak
    /// pressure.
    pub traction: [f64; 2],
    /// Slip of the upper body relative to the lower in units of `mu c / rho`, as `xi` and
    /// `eta`. NaN where the theory does not give it.
    pub slip: [f64; 2],
    /// Stick or slip. A theory without areas calls all of the contact adhesion.
    pub region: Region,
}

impl FieldPoint {
    /// A position outside the contact: no traction, no slip.
    #[must_use]
    pub fn outside(position: [f64; 2]) -> Self {
        Self { position, traction: [0.0; 2], slip: [0.0; 2], region: Region::Outside }
    }
}

/// A quadrilateral of the contact with a constant tangential traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// Corners, all around, in units of `c`.
    pub corners: [[f64; 2]; 4],
    /// Traction on the lower body, in the unit of [`FieldPoint::traction`].
    pub traction: [f64; 2],
}

/// The middle of some points.
pub(crate) fn mean(points: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / points.len() as f64)
}
