//! Linear theory as a [`Theory`](crate::Theory): forces by the coefficients, tractions by the strengths.

use std::f64::consts::PI;
use std::sync::OnceLock;

use super::compensation::{Criterion, Edge, Symmetry};
use super::edge::Strength;
use super::traction::Traction;
use super::{CreepageCoefficients, bounded, checked, sufficient_degree};
use crate::check::InvalidValue;
use crate::contact::Contact;
use crate::ellipse::Ellipse;
use crate::theory::{Jacobian, Solved, Stateless};
use crate::{Creepage, FieldPoint, Force, Region, Solution, Status, Theory};

/// Linear theory (4.3): no slip, and forces proportional to creepage and spin (4.87).
///
/// It holds for vanishing creepage and spin, and knows no bound: forces beyond `mu N` come out
/// as they are, and every status is [`Status::Solved`].
///
/// ```
/// use creepage::approximate::linear::Linear;
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let linear = Linear::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?)?;
/// let force = linear.solve(Creepage::new(0.0, 0.0, 0.01)?).force;
/// assert!((force.fy / force.mz - 1.48397 / 1.1814).abs() < 1e-4); // C23/C33
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Linear {
    contact: Contact,
    coefficients: CreepageCoefficients,
    gains: [[f64; 3]; 3],
    /// Of unit `xi`, `eta`, `chi`, once they are asked for.
    strengths: OnceLock<[Vec<Strength>; 3]>,
}

impl Linear {
    /// Takes the interpolated coefficients; tractions are solved for when a field is asked for.
    ///
    /// # Errors
    /// As [`CreepageCoefficients::new`].
    pub fn new(contact: &Contact) -> Result<Self, InvalidValue> {
        let (ellipse, poisson) = (checked(contact)?, contact.poisson());
        let coefficients = CreepageCoefficients::interpolated(contact)?;
        let gains = coefficients.gains(ellipse, poisson);
        Ok(Self { contact: contact.clone(), coefficients, gains, strengths: OnceLock::new() })
    }

    /// Of unit `xi`, `eta`, `chi`.
    fn strengths(&self) -> &[Vec<Strength>; 3] {
        self.strengths.get_or_init(|| {
            let (ellipse, poisson) = (self.contact.ellipse(), self.contact.poisson());
            let edge = Edge::new(ellipse, poisson, sufficient_degree(ellipse));
            let solved = |symmetry| edge.compensate(symmetry, Criterion::Energy).problems;
            let along = solved(Symmetry::Longitudinal).into_iter();
            let mut strengths = along.chain(solved(Symmetry::Lateral));
            std::array::from_fn(|_| strengths.next().unwrap_or_default())
        })
    }

    /// Of unit `xi`, `eta`, `chi`, in units of the scaling.
    pub(super) fn tractions(&self) -> [Traction; 3] {
        let slip = slip_unit(self.contact.ellipse(), self.contact.poisson());
        let [xi, eta, chi] = self.strengths();
        [
            Traction::new(xi, Symmetry::Longitudinal, slip),
            Traction::new(eta, Symmetry::Lateral, slip),
            Traction::new(chi, Symmetry::Lateral, slip),
        ]
    }

    /// The creepage and spin coefficients.
    #[must_use]
    pub fn coefficients(&self) -> CreepageCoefficients {
        self.coefficients
    }
}

impl Theory for Linear {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    /// Components beyond 1e100 count as 1e100, so that nothing overflows.
    fn solve(&self, creepage: Creepage) -> Solution {
        Solution::closed_form(linear_force(&self.gains, creepage), Status::Solved)
    }

    /// The traction is infinite on the trailing edge and, but for the error of finite degree,
    /// zero on the leading edge; both edges count as outside. There is no slip.
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let Creepage { xi, eta, chi } = bounded(creepage);
        let traction = Traction::sum(&self.tractions(), [xi, eta, chi]);
        let mut evaluate = traction.evaluator();
        let point = |&position: &[f64; 2]| {
            let [x, y] = [
                position[0] / self.contact.ellipse().a(),
                position[1] / self.contact.ellipse().b(),
            ];
            let inside = x * x + y * y < 1.0;
            FieldPoint {
                position,
                traction: if inside { evaluate(x, y) } else { [0.0; 2] },
                slip: [0.0; 2],
                region: if inside { Region::Adhesion } else { Region::Outside },
            }
        };
        positions.iter().map(point).collect()
    }

    /// No slip anywhere.
    fn regions(&self, _: Creepage, positions: &[[f64; 2]]) -> Vec<Region> {
        let [a, b] = [self.contact.ellipse().a(), self.contact.ellipse().b()];
        let region = |[x, y]: &[f64; 2]| {
            let inside = (x / a) * (x / a) + (y / b) * (y / b) < 1.0;
            if inside { Region::Adhesion } else { Region::Outside }
        };
        positions.iter().map(region).collect()
    }

    /// The same everywhere: `3 (1 - sigma) E/(4 pi sqrt g) C_ij` (4.87).
    fn jacobian(&self, _: Creepage) -> Option<Jacobian> {
        Some(self.gains)
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Stateless::boxed(self, creepage)
    }
}

impl CreepageCoefficients {
    /// Derivative of the dimensionless forces by the dimensionless creepages (4.87).
    pub(crate) fn gains(&self, ellipse: Ellipse, poisson: f64) -> [[f64; 3]; 3] {
        // 3/(2 pi) is the unit of traction over the mean traction of mu N, for ab = 1.
        let factor = 3.0 / (2.0 * PI) * slip_unit(ellipse, poisson);
        [
            [factor * self.c11, 0.0, 0.0],
            [0.0, factor * self.c22, factor * self.c23],
            [0.0, factor * self.c32, factor * self.c33],
        ]
    }
}

/// Creepage over (traction over `G`) for unit `xi` and unit traction: `(1 - sigma) E/(2 sqrt g)`.
pub(crate) fn slip_unit(ellipse: Ellipse, poisson: f64) -> f64 {
    (1.0 - poisson) * ellipse.integrals().e / (2.0 * ellipse.g().sqrt())
}

/// Forces of linear theory by its derivative. Components of creepage beyond 1e100 count as 1e100.
pub(crate) fn linear_force(gains: &[[f64; 3]; 3], creepage: Creepage) -> Force {
    let Creepage { xi, eta, chi } = bounded(creepage);
    let &[[by_xi, ..], [_, by_eta, by_chi], [_, moment_by_eta, moment_by_chi]] = gains;
    Force {
        fx: by_xi * xi,
        fy: by_eta * eta + by_chi * chi,
        mz: moment_by_eta * eta + moment_by_chi * chi,
    }
}
