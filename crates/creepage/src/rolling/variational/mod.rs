//! The numerical theory of chapter 5 (Kalker 1967): any creepage and spin.
//!
//! Tractions `mu Z (X', Y')` with polynomials `X'`, `Y'` of degree `M` minimize the mean `I`
//! of `W T S` over a mesh (5.9). `T` measures how far the traction is from sliding, `S` is the
//! slip squared: where `T < S` a point belongs to the area of slip, elsewhere to that of
//! adhesion.
//!
//! The force errs by some 2 to 10 %, most at small creepage and near the peak of pure spin;
//! the thesis's own test is in [`VariationalSolution::aberrations`].

mod discretization;
mod functional;
mod integrand;
mod newton;
mod newton_1967;
mod settings;
mod solution;
mod start;

pub use newton_1967::{NewtonRun, NewtonStep};
pub use settings::{Settings, TractionBound, VariationalError, Weight};
pub use solution::{MeshPoint, VariationalSolution};
pub use start::Start;

use super::{Creepage, FieldPoint, Region, Solution, Theory};
use crate::check;
use crate::ellipse::Ellipse;
use crate::halfspace::{Polynomial, PolynomialError};
use discretization::{Discretization, SlipResponse};
use functional::Functional;

/// The numerical theory, prepared for one ratio of semi-axes and one Poisson's ratio.
///
/// ```
/// use creepage::rolling::variational::{Settings, Start, Variational};
/// use creepage::rolling::Creepage;
/// // The case of Fig. 12 of the thesis.
/// let (sin, cos) = (-30.0_f64).to_radians().sin_cos();
/// let creepage = Creepage::new(1.7 * cos, 1.7 * sin, 2.0)?;
/// let theory = Variational::new(0.5, 0.28, Settings::default())?;
/// let solution = theory.solve_from(creepage, &Start::FullSliding);
/// assert!((solution.solution.force.fx - 0.6249).abs() < 5e-5);
/// # Ok::<(), creepage::rolling::variational::VariationalError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Variational {
    response: SlipResponse,
    mesh: Discretization,
    weights: Vec<f64>,
    penalized: bool,
}

impl Variational {
    /// Prepares the theory for the ratio `a/b` of the semi-axes and the combined Poisson's
    /// ratio.
    ///
    /// # Errors
    /// [`VariationalError`] when `a_over_b`, `poisson` or a setting is out of range.
    pub fn new(a_over_b: f64, poisson: f64, settings: Settings) -> Result<Self, VariationalError> {
        check::poisson(poisson)?;
        settings.check()?;
        let response = SlipResponse::new(a_over_b, poisson, settings.degree)?;
        let mesh = response.at(response.mesh(&settings));
        let points = mesh.positions().len() as f64;
        let weights = mesh
            .bound_squared()
            .iter()
            .map(|bound_squared| settings.weight.at(1.0 - bound_squared) / points)
            .collect();
        let penalized = settings.bound.penalized(a_over_b);
        Ok(Self { response, mesh, weights, penalized })
    }

    /// The mesh points `(x, y)` in units of `c`.
    #[must_use]
    pub fn mesh(&self) -> &[[f64; 2]] {
        self.mesh.positions()
    }

    /// Whether tractions above their bound are penalized, see [`TractionBound`].
    #[must_use]
    pub fn penalized(&self) -> bool {
        self.penalized
    }

    /// Minimizes `I` from `start`.
    #[must_use]
    pub fn solve_from(&self, creepage: Creepage, start: &Start) -> VariationalSolution {
        let functional = self.functional(creepage);
        let tau = start.tau(&self.mesh, &self.weights, creepage);
        let minimum = newton::minimize(&functional, tau);
        VariationalSolution::new(self, creepage, &minimum)
    }

    /// The traction polynomials `X'`, `Y'` of a solution, with the major semi-axis as unit of
    /// length, as the thesis prints them.
    ///
    /// # Errors
    /// [`PolynomialError`] when `tau` is not of this theory's degree, or not finite.
    pub fn traction_polynomials(&self, tau: &[f64]) -> Result<[Polynomial; 2], PolynomialError> {
        let ellipse = self.response.ellipse();
        let major = ellipse.major();
        let unit = Ellipse::new(ellipse.a() / major, ellipse.b() / major)?;
        let (x, y) = tau.split_at(tau.len() / 2);
        Ok([Polynomial::from_harmonics(unit, x)?, Polynomial::from_harmonics(unit, y)?])
    }

    fn functional(&self, creepage: Creepage) -> Functional<'_> {
        Functional::new(&self.mesh, &self.weights, creepage, self.penalized)
    }
}

impl Theory for Variational {
    fn solve(&self, creepage: Creepage) -> Solution {
        self.solve_from(creepage, &Start::FullSliding).solution
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let tau = self.solve_from(creepage, &Start::FullSliding).tau;
        let points = self.response.at(positions.to_vec());
        let field = solution::mesh_points(&points, creepage, &tau).into_iter();
        field
            .zip(points.bound_squared())
            .map(|(point, bound)| clipped(point.field, *bound))
            .collect()
    }
}

/// A point on or outside the edge bears no traction.
fn clipped(point: FieldPoint, bound_squared: f64) -> FieldPoint {
    if bound_squared > 0.0 {
        return point;
    }
    FieldPoint { traction: [0.0; 2], slip: [0.0; 2], region: Region::Slip, ..point }
}
