//! Linear theory (4.3): creepage and spin so small that slip is confined to the trailing edge.
//!
//! Without slip the displacement differences are, in the units of the scaling (4.31),
//!
//! ```math
//! u = -\xi x + \chi x y + f(y), \qquad v = -\eta x - \tfrac12 \chi x^2 + g(y)
//! ```
//!
//! The functions `f` and `g` follow from the demand that the traction be finite on the leading
//! edge, where unstrained material enters (4.35). At the trailing edge the traction is infinite,
//! which the theory takes for slip. Forces are proportional to creepage and spin (4.86):
//!
//! ```math
//! F_x = G c^2 C_{11} \upsilon_x, \qquad
//! F_y = G c^2 (C_{22} \upsilon_y + C_{23} c \phi), \qquad
//! M_z = G c^3 (C_{32} \upsilon_y + C_{33} c \phi)
//! ```
//!
//! `f` and `g` are sums of Legendre polynomials up to some degree. The thesis used degree 5 and
//! the criterion (4.36), [`CreepageCoefficients::of_degree`]; [`CreepageCoefficients::new`]
//! takes a criterion that converges much faster, and the degree that the shape needs.

mod compensation;
mod edge;
mod edge_energy;
mod interpolated;
mod theory;
mod traction;
mod waves;

use compensation::{Compensated, Criterion, Edge, Symmetry};

pub use edge_energy::EdgeEnergy;
pub use theory::Linear;
pub(super) use theory::{linear_force, slip_unit};

use crate::Creepage;
use crate::check::{self, InvalidValue};
use crate::contact::Contact;
use crate::ellipse::Ellipse;

/// Creepage and spin coefficients `C_ij` (Table 3).
///
/// `F_x = G c^2 C11 upsilon_x`, `F_y = G c^2 (C22 upsilon_y + C23 c phi)`,
/// `M_z = G c^3 (C32 upsilon_y + C33 c phi)` (4.86).
///
/// ```
/// use creepage::approximate::linear::CreepageCoefficients;
/// use creepage::{Contact, Ellipse};
/// let circle = CreepageCoefficients::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.0)?)?;
/// // For circles and sigma = 0: 32/(3 pi), 4/3 and 512/(135 pi).
/// assert!((circle.c11 - 32.0 / (3.0 * std::f64::consts::PI)).abs() < 1e-12);
/// assert!((circle.c23 - 4.0 / 3.0).abs() < 1e-12);
/// assert!((circle.c33 - 512.0 / (135.0 * std::f64::consts::PI)).abs() < 1e-12);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepageCoefficients {
    /// Longitudinal force by longitudinal creepage.
    pub c11: f64,
    /// Lateral force by lateral creepage.
    pub c22: f64,
    /// Lateral force by spin.
    pub c23: f64,
    /// Moment by lateral creepage; `-c23` in the limit of infinite degree.
    pub c32: f64,
    /// Moment by spin.
    pub c33: f64,
}

impl CreepageCoefficients {
    /// Range of `a_over_b` in which the coefficients were examined, and are given.
    pub const RATIO_RANGE: [f64; 2] = [1e-3, 1e3];

    /// The coefficients to a relative accuracy of 1e-6 or better, for any shape and any
    /// Poisson's ratio, continuous in both. (Measured against twice the degree: 3e-7 at worst,
    /// in `c23` of shapes slender across; 1e-8 for the others.)
    ///
    /// By reciprocity `C32 = -C23`. At finite degree the two err by opposite amounts, far more
    /// than their mean does, so the mean is given as either.
    ///
    /// Costs 0.4 ms for round shapes and 17 ms at `a_over_b = 1e-3`;
    /// [`CreepageCoefficients::interpolated`] is quicker by far.
    ///
    /// # Errors
    /// [`InvalidValue`] unless the ratio `a/b` lies within [`CreepageCoefficients::RATIO_RANGE`].
    pub fn new(contact: &Contact) -> Result<Self, InvalidValue> {
        let (ellipse, poisson) = (checked(contact)?, contact.poisson());
        let degree = sufficient_degree(ellipse);
        Ok(Self::raw(ellipse, poisson, degree, Criterion::Energy).reciprocal())
    }

    /// The coefficients as the thesis calculates them: displacements with polynomials of
    /// `degree` in `y`, compensated by least squares (4.36). Table 3 is of degree 5.
    ///
    /// # Errors
    /// As [`CreepageCoefficients::new`], and unless `2 <= degree <= 100`.
    pub fn of_degree(contact: &Contact, degree: usize) -> Result<Self, InvalidValue> {
        let (ellipse, poisson) = (checked(contact)?, contact.poisson());
        check::require((2..=100).contains(&degree), "degree", degree as f64, "between 2 and 100")?;
        Ok(Self::raw(ellipse, poisson, degree, Criterion::Thesis))
    }

    fn raw(ellipse: Ellipse, poisson: f64, degree: usize, criterion: Criterion) -> Self {
        let edge = Edge::new(ellipse, poisson, degree);
        Self::from_solutions(
            &edge.compensate(Symmetry::Longitudinal, criterion),
            &edge.compensate(Symmetry::Lateral, criterion),
        )
    }

    fn from_solutions(longitudinal: &Compensated, lateral: &Compensated) -> Self {
        Self {
            c11: longitudinal.longitudinal_force(),
            c22: lateral.lateral_force(0),
            c23: lateral.lateral_force(1),
            c32: lateral.moment(0),
            c33: lateral.moment(1),
        }
    }

    /// With the mean of `C23` and `-C32` for both.
    fn reciprocal(self) -> Self {
        let c23 = 0.5 * (self.c23 - self.c32);
        Self { c23, c32: -c23, ..self }
    }
}

/// The ellipse, if the coefficients are given for it.
pub(super) fn checked(contact: &Contact) -> Result<Ellipse, InvalidValue> {
    let range = CreepageCoefficients::RATIO_RANGE;
    let ellipse = contact.hertz_ellipse()?;
    check::ratio(ellipse.ratio(), range, "between 1e-3 and 1e3")?;
    Ok(ellipse)
}

/// The degree at which the coefficients have converged to 1e-6: the more slender the ellipse
/// is across, the sharper `f` and `g` turn towards its ends.
// A small positive number by construction.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn sufficient_degree(ellipse: Ellipse) -> usize {
    56 + (12.0 * ellipse.ratio().recip().ln().max(0.0)) as usize
}

/// Creepage that overflows nowhere: any component beyond 1e100 counts as 1e100.
pub(super) fn bounded(creepage: Creepage) -> Creepage {
    let bound = |component: f64| component.clamp(-1e100, 1e100);
    Creepage { xi: bound(creepage.xi), eta: bound(creepage.eta), chi: bound(creepage.chi) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `C32 = -C23` is not imposed on the solution before the mean is taken: what is left of
    /// it measures the error of both.
    #[test]
    fn reciprocity_holds_before_the_mean_is_taken() {
        for poisson in [0.0, 0.25, 0.5] {
            for (a_over_b, bound) in
                [(0.1, 1e-6), (0.3, 1e-6), (1.0, 1e-6), (3.0, 1e-7), (10.0, 1e-9), (1e3, 1e-12)]
            {
                let ellipse = Ellipse::from_ratio(a_over_b).unwrap();
                let degree = sufficient_degree(ellipse);
                let raw = CreepageCoefficients::raw(ellipse, poisson, degree, Criterion::Energy);
                let defect = (raw.c32 / raw.c23 + 1.0).abs();
                assert!(defect < bound, "{a_over_b} {poisson}: {defect:e}");
            }
        }
    }

    /// Twice the degree changes nothing that is promised.
    #[test]
    fn the_degree_suffices() {
        for a_over_b in [1e-3, 0.01, 0.1, 1.0, 30.0, 1e3] {
            let ellipse = Ellipse::from_ratio(a_over_b).unwrap();
            let degree = 2 * sufficient_degree(ellipse);
            let fine = CreepageCoefficients::raw(ellipse, 0.5, degree, Criterion::Energy);
            let usual = CreepageCoefficients::new(&Contact::new(ellipse, 0.5).unwrap()).unwrap();
            for (usual, fine) in [
                (usual.c11, fine.c11),
                (usual.c22, fine.c22),
                (usual.c23, 0.5 * (fine.c23 - fine.c32)),
                (usual.c33, fine.c33),
            ] {
                assert!((usual / fine - 1.0).abs() < 5e-7, "{a_over_b}: {usual} {fine}");
            }
        }
    }

    /// Theory: with the energy criterion the error falls as the fifth power of the degree,
    /// with the thesis's as the third.
    #[test]
    fn orders_of_convergence() {
        let ellipse = Ellipse::from_ratio(1.0).unwrap();
        let c22 =
            |degree, criterion| CreepageCoefficients::raw(ellipse, 0.25, degree, criterion).c22;
        let limit = c22(120, Criterion::Energy);
        for (criterion, order) in [(Criterion::Energy, 4.5), (Criterion::Thesis, 2.7)] {
            let error = |degree| (c22(degree, criterion) - limit).abs();
            let measured = (error(8) / error(32)).log2() / 2.0;
            assert!(measured > order, "{criterion:?}: {measured}");
        }
    }
}
