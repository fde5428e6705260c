//! Slip beside the contact, and its strength at the edge: (4.39), (4.41), (4.62).

use std::f64::consts::PI;

use super::waves::Waves;
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;
use crate::halfspace::Traction;

/// The part of the slip that the displacement of the surface makes, `d(u, v)/dx`, anywhere on the
/// surface of like bodies: of a traction that is singular at the edge too, where (4.39) holds.
///
/// ```
/// use creepage::subsurface::SurfaceSlip;
/// use creepage::halfspace::{Edge, Polynomial, Traction};
/// use creepage::Ellipse;
/// let (x, none) = (Polynomial::new(vec![1e-3])?, Polynomial::zero(0));
/// let circle = Ellipse::new(1.0, 1.0)?;
/// let slip = SurfaceSlip::new(&Traction::new(circle, Edge::Singular, [&x, &none, &none])?, 0.0)?;
/// // Ahead of the contact the surface is dragged along less and less.
/// let [ahead, _] = slip.slope([1.5, 0.0])?;
/// let expected = -2e-3 / (1.5 * 1.25_f64.sqrt()); // d/dx of 2 asin(1/x) times X/G
/// assert!((ahead - expected).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct SurfaceSlip {
    ellipse: Ellipse,
    poisson: f64,
    waves: Waves,
}

/// Slip (4.41) at one point of the edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgePoint {
    /// The point.
    pub position: [f64; 2],
    /// Unit normal of the edge, into the contact: `(cos psi, sin psi)`.
    pub inward: [f64; 2],
    /// `(X', Y')` over `G`: the traction times `sqrt(1 - r^2)`.
    pub strength: [f64; 2],
    /// The slip outside times the square root of the distance from the edge [sqrt(length)].
    pub slip: [f64; 2],
}

impl SurfaceSlip {
    /// For a traction over the combined `G` and the combined Poisson's ratio.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `0 <= poisson <= 0.5`.
    pub fn new(traction: &Traction, poisson: f64) -> Result<Self, InvalidValue> {
        check::poisson(poisson)?;
        Ok(Self {
            ellipse: traction.ellipse(),
            poisson,
            // Between like bodies the pressure does not move the surfaces apart along themselves.
            waves: Waves::new(traction, [1.0, 1.0, 0.0]),
        })
    }

    /// `(du/dx, dv/dx)` of the displacement differences at `[x, y]`; the relative slip is this
    /// with the creepage and the spin added (4.15).
    ///
    /// # Errors
    /// [`InvalidValue`] unless the coordinates are finite.
    pub fn slope(&self, [x, y]: [f64; 2]) -> Result<[f64; 2], InvalidValue> {
        check::finite("x", x)?;
        check::finite("y", y)?;
        // The difference of like bodies is twice what one of them does.
        Ok(self.waves.surface_slope([x, y], self.poisson).map(|slope| slope / (2.0 * PI)))
    }

    /// The edge's point `(a cos angle, b sin angle)` by (4.41). A traction that vanishes at the
    /// edge has no strength there.
    #[must_use]
    pub fn at_edge(&self, angle: f64) -> EdgePoint {
        let (sin, cos) = angle.sin_cos();
        let (a, b) = (self.ellipse.a(), self.ellipse.b());
        let steepness = (cos / a).hypot(sin / b);
        let [c, s] = [-cos / (a * steepness), -sin / (b * steepness)];
        let [x, y] = self.waves.edge_strength([cos, sin]);
        // B of (4.62): 1 - r^2 is B^2 times the distance from the edge.
        let scale = 2.0 * c / (2.0 * steepness).sqrt();
        let shear = self.poisson * c * s;
        EdgePoint {
            position: [a * cos, b * sin],
            inward: [c, s],
            strength: [x, y],
            slip: [
                scale * ((1.0 - self.poisson * c * c) * x - shear * y),
                scale * ((1.0 - self.poisson * s * s) * y - shear * x),
            ],
        }
    }
}
