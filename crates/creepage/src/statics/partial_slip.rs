//! Tangential shift of two bodies in contact with slip at the edge (3.222), after Cattaneo and Mindlin.

use super::shift_compliances;
use crate::Region;
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;
use crate::halfspace::{
    DisplacementField, Edge, Polynomial, PolynomialError, ResponseError, Traction, coefficients,
};
use crate::hertz::Hertz;

/// Error of a contact without partial slip.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PartialSlipError {
    /// A number is outside its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The half-space gives no answer.
    #[error(transparent)]
    Response(#[from] ResponseError),
    /// The force reaches the limit of friction: the bodies slide.
    #[error(
        "the bodies slide: the tangential force {force} N reaches the friction limit {limit} N"
    )]
    Sliding {
        /// Magnitude of the tangential force (N).
        force: f64,
        /// Coefficient of friction times normal force (N).
        limit: f64,
    },
}

/// Cattaneo's and Mindlin's contact with slip: a Hertz contact under a tangential force that
/// grew from zero, below the limit of friction.
///
/// The traction has the direction of the force everywhere. Slip has it too only for
/// `sigma = 0`; [`PartialSlip::disagreement`] tells by which angle it misses.
///
/// ```
/// use creepage::statics::PartialSlip;
/// use creepage::{Ellipse, Hertz, Solid, SolidPair};
/// let steel = Solid::new(82e9, 0.28)?;
/// let ellipse = Ellipse::new(6e-3, 4e-3)?;
/// let contact = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3)?;
/// let partial = PartialSlip::new(&contact, 0.3, [21e3, 0.0])?;
/// // Seven eighths of the limit leave half the axes for adhesion (3.62).
/// assert!((partial.adhesion().a() / 3e-3 - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct PartialSlip {
    contact: Ellipse,
    adhesion: Ellipse,
    direction: [f64; 2],
    bound: f64,
    /// One less the ratio of the adhesion ellipse's axes to the contact's.
    gap: f64,
    shift: [f64; 2],
    sliding: DisplacementField,
    relief: DisplacementField,
    largest_disagreement: f64,
}

impl PartialSlip {
    /// The Hertz contact `contact` with coefficient of friction `friction` under the tangential
    /// force `force` `[F_x, F_y]` (N), along the axes of its ellipse.
    ///
    /// # Errors
    /// [`PartialSlipError::Sliding`] when the force reaches the limit of friction;
    /// [`PartialSlipError::Invalid`] unless the numbers are finite and `friction` positive.
    pub fn new(contact: &Hertz, friction: f64, force: [f64; 2]) -> Result<Self, PartialSlipError> {
        let limit = check::positive("friction", friction)? * contact.normal_force();
        let fx = check::finite("force_x", force[0])?;
        let fy = check::finite("force_y", force[1])?;
        let size = fx.hypot(fy);
        if size >= limit {
            return Err(PartialSlipError::Sliding { force: size, limit });
        }
        let direction = if size > 0.0 { [fx / size, fy / size] } else { [1.0, 0.0] };
        Ok(Self::below_the_limit(contact, friction, size / limit, direction)?)
    }

    /// For a force of `share` of the limit in `direction`.
    fn below_the_limit(
        contact: &Hertz,
        friction: f64,
        share: f64,
        direction: [f64; 2],
    ) -> Result<Self, ResponseError> {
        let (pair, ellipse) = (contact.pair(), contact.ellipse());
        // (3.62), (3.61): the relief acts on an ellipse smaller by 1 - gap, and is as much less.
        let gap = power_deficit(share, 1.0 / 3.0);
        let adhesion = Ellipse::new((1.0 - gap) * ellipse.a(), (1.0 - gap) * ellipse.b())?;
        let bound = friction * contact.peak_pressure();
        let peak = bound / pair.shear_modulus();
        let field = |ellipse, peak| -> Result<DisplacementField, ResponseError> {
            let traction = along(direction, ellipse, peak)?;
            Ok(DisplacementField::new(&traction, pair.poisson(), pair.kappa())?)
        };
        // (3.65), with mu 3N/(2 pi) = a b times the peak.
        let unit = power_deficit(share, 2.0 / 3.0) * peak * ellipse.minor();
        let [cx, cy] = shift_compliances(ellipse, pair.poisson());
        Ok(Self {
            contact: ellipse,
            adhesion,
            direction,
            bound,
            gap,
            shift: [unit * cx * direction[0], unit * cy * direction[1]],
            sliding: field(ellipse, peak)?,
            relief: field(adhesion, (1.0 - gap) * peak)?,
            largest_disagreement: largest_disagreement(ellipse, pair.poisson(), direction)?,
        })
    }

    /// The area of adhesion, similar to the contact ellipse (3.62).
    #[must_use]
    pub fn adhesion(&self) -> Ellipse {
        self.adhesion
    }

    /// Shift `[delta_x, delta_y]` of the upper body relative to the lower (m) (3.65).
    #[must_use]
    pub fn shift(&self) -> [f64; 2] {
        self.shift
    }

    /// Stick or slip at `[x, y]`; `None` outside the contact.
    #[must_use]
    pub fn region(&self, point: [f64; 2]) -> Option<Region> {
        if radius(self.contact, point) > 1.0 {
            None
        } else if radius(self.adhesion, point) > 1.0 {
            Some(Region::Slip)
        } else {
            Some(Region::Adhesion)
        }
    }

    /// Traction `[X, Y]` at `[x, y]` (Pa) (3.57).
    #[must_use]
    pub fn traction(&self, point: [f64; 2]) -> [f64; 2] {
        let root = |ellipse| {
            let r = radius(ellipse, point);
            ((1.0 - r) * (1.0 + r)).max(0.0).sqrt()
        };
        let (full, relief) = (root(self.contact), (1.0 - self.gap) * root(self.adhesion));
        // In the area of adhesion the difference of the roots, without cancellation.
        let size = if relief > 0.0 { self.gap * (2.0 - self.gap) / (full + relief) } else { full };
        self.direction.map(|component| self.bound * size * component)
    }

    /// Largest traction that friction allows at `[x, y]`, `mu Z` (Pa).
    #[must_use]
    pub fn bound(&self, point: [f64; 2]) -> f64 {
        let r = radius(self.contact, point);
        self.bound * ((1.0 - r) * (1.0 + r)).max(0.0).sqrt()
    }

    /// Displacement difference `[u, v, w]` at `[x, y]` (m); `w` differs from zero for unlike
    /// bodies only.
    #[must_use]
    pub fn displacement(&self, point: [f64; 2]) -> [f64; 3] {
        let (sliding, relief) = (self.sliding.at(point), self.relief.at(point));
        [0, 1, 2].map(|i| sliding[i] - relief[i])
    }

    /// Slip `[x, y]` of the upper body over the lower at a point, since the force was zero (m);
    /// zero in the area of adhesion but for rounding. `None` outside the contact.
    #[must_use]
    pub fn slip(&self, point: [f64; 2]) -> Option<[f64; 2]> {
        self.region(point)?;
        let [u, v, _] = self.displacement(point);
        Some([self.shift[0] - u, self.shift[1] - v])
    }

    /// Angle from the traction to the slip at a point (rad), by which this solution fails the
    /// law of friction. `None` outside the area of slip.
    #[must_use]
    pub fn disagreement(&self, point: [f64; 2]) -> Option<f64> {
        if self.region(point)? == Region::Adhesion {
            return None;
        }
        let [sx, sy] = self.slip(point)?;
        let [cos, sin] = self.direction;
        Some((cos * sy - sin * sx).atan2(cos * sx + sin * sy))
    }

    /// The largest angle between slip and traction when the force, in this direction, comes to
    /// the limit of friction (rad): 4.1 and 9.6 degrees on a circle for `sigma` 1/4 and 1/2.
    #[must_use]
    pub fn largest_disagreement(&self) -> f64 {
        self.largest_disagreement
    }
}

/// `1 - (1 - share)^power`, exact for small shares too.
pub(super) fn power_deficit(share: f64, power: f64) -> f64 {
    -(power * (-share).ln_1p()).exp_m1()
}

/// `(x/a, y/b)` as a distance from the centre.
pub(super) fn radius(ellipse: Ellipse, [x, y]: [f64; 2]) -> f64 {
    (x / ellipse.a()).hypot(y / ellipse.b())
}

/// The traction `peak (1 - r^2)^(1/2)` in `direction`.
fn along(direction: [f64; 2], ellipse: Ellipse, peak: f64) -> Result<Traction, PolynomialError> {
    let x = Polynomial::new(vec![peak * direction[0]])?;
    let y = Polynomial::new(vec![peak * direction[1]])?;
    Traction::new(ellipse, Edge::Vanishing, [&x, &y, &Polynomial::zero(0)])
}

/// In complete sliding the slip is a quadratic form in `x`, `y` (3.58a), along the traction and
/// across it; the extreme ratio of the two forms is an eigenvalue.
fn largest_disagreement(
    ellipse: Ellipse,
    poisson: f64,
    [cos, sin]: [f64; 2],
) -> Result<f64, InvalidValue> {
    let f = |h, mn| coefficients::f(h, [0, 0], mn, ellipse);
    let mixed = poisson * f(1, [2, 2])?;
    let (xx, yy) = (f(0, [2, 0])?, f(0, [0, 2])?);
    // (3.59) as [x^2, xy/2, y^2]; lengths over a and b keep slender ellipses in range.
    let (a, b) = (ellipse.a(), ellipse.b());
    let scaled = |[xx, xy, yy]: [f64; 3]| [xx * a * a, xy * a * b, yy * b * b];
    let u = scaled([cos * (xx - poisson * f(1, [4, 0])?), -sin * mixed, cos * (yy - mixed)]);
    let v = scaled([sin * (xx - mixed), -cos * mixed, sin * (yy - poisson * f(1, [0, 4])?)]);
    let along = [0, 1, 2].map(|i| cos * u[i] + sin * v[i]);
    let across = [0, 1, 2].map(|i| cos * v[i] - sin * u[i]);
    let det = |[xx, xy, yy]: [f64; 3]| xx * yy - xy * xy;
    let trace = across[0] * along[2] + across[2] * along[0] - 2.0 * across[1] * along[1];
    let root = (trace * trace - 4.0 * det(along) * det(across)).max(0.0).sqrt();
    Ok(((trace.abs() + root) / (2.0 * det(along))).atan())
}
