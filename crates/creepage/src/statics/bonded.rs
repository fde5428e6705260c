//! Tangential shift and torsion of two bodies in contact without slip (3.212).

use std::f64::consts::PI;

use super::shift_compliances;
use crate::SiForce;
use crate::check;
use crate::ellipse::Ellipse;
use crate::halfspace::{DisplacementField, LoadDisplacement, Polynomial, ResponseError, Traction};
use crate::solid::SolidPair;

/// Cattaneo's and Mindlin's contact without slip: a tangential force and a torsional moment on
/// two bodies that stick together all over the contact ellipse.
///
/// The traction is infinite at the edge, where in truth there is slip: see
/// [`PartialSlip`](super::PartialSlip). The influence of the pressure is left out.
///
/// ```
/// use creepage::SiForce;
/// use creepage::statics::Bonded;
/// use creepage::{Ellipse, Solid, SolidPair};
/// let steel = Solid::new(82e9, 0.28)?;
/// let force = SiForce { longitudinal: 1e3, lateral: 0.0, moment: 2.0 };
/// let contact = Ellipse::new(5e-3, 5e-3)?;
/// let bonded = Bonded::new(SolidPair::new(steel, steel), contact, force)?;
/// let [delta, _] = bonded.shift();
/// // Mindlin on a circle: delta = (2 - sigma) F / (4 G a).
/// assert!((delta / (1.72 * 1e3 / (4.0 * 82e9 * 5e-3)) - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Bonded {
    pair: SolidPair,
    shift: [f64; 2],
    twist: f64,
    traction: Traction,
    field: DisplacementField,
}

impl Bonded {
    /// The contact `ellipse` (m) of `pair` under `force`, exerted by the upper body on the
    /// lower.
    ///
    /// # Errors
    /// [`ResponseError`] when a component of the force is not finite.
    pub fn new(pair: SolidPair, ellipse: Ellipse, force: SiForce) -> Result<Self, ResponseError> {
        let fx = check::finite("longitudinal", force.longitudinal)?;
        let fy = check::finite("lateral", force.lateral)?;
        let mz = check::finite("moment", force.moment)?;
        let unit = PI * ellipse.major() * pair.shear_modulus();
        let [along, across] = shift_compliances(ellipse, pair.poisson());
        let shift = [along * fx / unit, across * fy / unit];
        let twist = torsion(ellipse, pair.poisson()) * mz / (unit * ellipse.major().powi(2));
        // (3.30)
        let u = Polynomial::new(vec![shift[0], 0.0, -twist])?;
        let v = Polynomial::new(vec![shift[1], twist, 0.0])?;
        let equations = LoadDisplacement::new(ellipse, pair.poisson(), 1)?;
        let traction = equations.inverse()?.singular([&u, &v, &Polynomial::zero(0)])?;
        let field = DisplacementField::new(&traction, pair.poisson(), pair.kappa())?;
        Ok(Self { pair, shift, twist, traction, field })
    }

    /// Shift `[delta_x, delta_y]` of the upper body relative to the lower (m) (3.34).
    #[must_use]
    pub fn shift(&self) -> [f64; 2] {
        self.shift
    }

    /// Rotation `beta` of the upper body relative to the lower about `z` (rad) (3.34).
    #[must_use]
    pub fn twist(&self) -> f64 {
        self.twist
    }

    /// Traction `[X, Y]` at `[x, y]` (Pa) (3.31a); zero on the edge and beyond.
    #[must_use]
    pub fn traction(&self, point: [f64; 2]) -> [f64; 2] {
        let [x, y, _] = self.traction.at(point);
        [x * self.pair.shear_modulus(), y * self.pair.shear_modulus()]
    }

    /// Displacement difference `[u, v, w]` at `[x, y]` (m), in the contact and beside it; `w`
    /// differs from zero for unlike bodies only.
    #[must_use]
    pub fn displacement(&self, point: [f64; 2]) -> [f64; 3] {
        self.field.at(point)
    }
}

/// The twist per unit of `M_z/(pi l^3 G)`, `l` the major semi-axis (3.34).
fn torsion(ellipse: Ellipse, poisson: f64) -> f64 {
    let (integrals, g2) = (ellipse.integrals(), ellipse.g().powi(2));
    3.0 * (integrals.b * integrals.d - poisson * integrals.e * integrals.c)
        / (integrals.e - 4.0 * poisson * g2 * integrals.c)
}
