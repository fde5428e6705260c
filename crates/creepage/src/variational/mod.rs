//! The numerical theory of chapter 5 (Kalker 1967): any creepage and spin.
//!
//! Tractions `mu Z (X', Y')` with polynomials `X'`, `Y'` of degree `M` minimize the mean `I`
//! of `W T S` over a mesh (5.9). `T` measures how far the traction is from sliding, `S` is the
//! slip squared: where `T < S` a point belongs to the area of slip, elsewhere to that of
//! adhesion.
//!
//! ```math
//! T = \left| (X', Y') - \frac{s}{|s|} \right|^2, \quad S = |s|^2 \quad (5.6), \qquad
//! T S = \big| |s| (X', Y') - s \big|^2
//! ```
//!
//! Between dissimilar bodies the slip has the known function of (6.6) added to it, as 6.2 proposes: the
//! slip by Hertz's pressure.
//!
//! Where the contact is long in the rolling direction, `a/b >= 3`, the mean of `W T S` has several
//! minima. There the least loss of power, which has one, takes its place: see [`TractionBound`].
//!
//! Error of the force in per cent of `mu N` over the 132 reference cases of
//! `creepage-study`; it is largest at small creepage and in strong pure spin:
//!
//! | `M` | median | rms | worst |
//! |---|---|---|---|
//! | 3 | 1.8 | 5.8 | 23 |
//! | 4 | 1.5 | 3.7 | 14 |
//! | 6 | 1.0 | 2.3 | 9.4 |
//! | 8 | 0.7 | 1.7 | 7.5 |
//! | 12 | 0.4 | 1.0 | 4.3 |
//!
//! The thesis's own test of a solution is in [`VariationalSolution::aberrations`].

mod chain;
mod changing;
mod discretization;
mod functional;
mod integrand;
mod method;
mod newton;
mod newton_1967;
mod own_integrand;
mod polynomials;
mod power;
mod power_integrand;
mod settings;
mod solution;
mod start;

pub use chain::{Chain, ChainCase};
pub use integrand::IntegrandTerms;
pub use method::{Method, Procedure};
pub use newton_1967::NewtonStep;
pub use own_integrand::IntegrandArguments;
pub use settings::{Limits, Settings, TractionBound, VariationalError, Weight};
pub use solution::{MeshPoint, VariationalSolution};
pub use start::Start;

use std::sync::Arc;

use crate::contact::Contact;
use crate::ellipse::Ellipse;
use crate::theory::{Diagnostic, Jacobian, Solved};
use crate::{Creepage, FieldPoint, Solution, Theory};
pub(crate) use changing::{Changing, Rubbing};
pub(crate) use discretization::Change;
use discretization::{Discretization, SlipResponse};
use functional::{ElasticPower, Form, Functional};
use own_integrand::OwnIntegrand;

/// The numerical theory, prepared for one ratio of semi-axes and one Poisson's ratio.
///
/// ```
/// use creepage::variational::{Settings, Start, Variational};
/// use creepage::{Contact, Creepage, Ellipse};
/// // The case of Fig. 12 of the thesis.
/// let (sin, cos) = (-30.0_f64).to_radians().sin_cos();
/// let creepage = Creepage::new(1.7 * cos, 1.7 * sin, 2.0)?;
/// let theory = Variational::new(&Contact::new(Ellipse::from_ratio(0.5)?, 0.28)?, Settings::default())?;
/// let solution = theory.solve_from(creepage, &Start::FullSliding);
/// assert!((solution.solution.force.fx - 0.6249).abs() < 5e-5);
/// # Ok::<(), creepage::variational::VariationalError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Variational {
    contact: Contact,
    response: SlipResponse,
    mesh: Discretization,
    /// `W` over the number of points.
    weights: Vec<f64>,
    /// `Z` over the number of points.
    power_weights: Vec<f64>,
    /// `W3/W2` of (5.15).
    area_weights: Vec<f64>,
    weight: Weight,
    keeps_bound: bool,
    own_integrand: Option<OwnIntegrand>,
    /// Where the elastic energy changes.
    elastic: Option<ElasticPower>,
}

impl Variational {
    /// Prepares the theory for a contact.
    ///
    /// # Errors
    /// [`VariationalError`] when a setting is out of range.
    pub fn new(contact: &Contact, settings: Settings) -> Result<Self, VariationalError> {
        settings.check()?;
        let response = SlipResponse::new(contact, settings.degree)?;
        let mesh = response.at(response.mesh(&settings));
        let points = mesh.positions().len() as f64;
        let squared = mesh.bound_squared().iter();
        let weights = squared.clone().map(|z| settings.weight.at(1.0 - z) / points).collect();
        let power_weights = squared.clone().map(|z| z.sqrt() / points).collect();
        let weight = settings.weight;
        let of_adhesion = settings.adhesion_weight.unwrap_or(weight);
        let ratio = |z: &f64| of_adhesion.at(1.0 - z) / weight.at(1.0 - z);
        let area_weights = squared.map(ratio).collect();
        let keeps_bound = settings.bound.is_kept(contact.ellipse().ratio());
        let (own_integrand, elastic) = (None, None);
        let contact = contact.clone();
        Ok(Self {
            contact,
            response,
            mesh,
            weights,
            power_weights,
            area_weights,
            weight,
            keeps_bound,
            own_integrand,
            elastic,
        })
    }

    /// As [`Variational::new`], with the mean of `W f(x, y, a, b, T, S)` in place of that of
    /// `W T S`; with [`Weight::Uniform`] the mean of `f` itself (5.22).
    ///
    /// ```
    /// use creepage::variational::{IntegrandTerms, Settings, Variational};
    /// use creepage::{Contact, Ellipse};
    /// let circle = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
    /// // S counts less where it is large.
    /// let theory = Variational::with_integrand(&circle, Settings::default(), |at| {
    ///     let (t, s, rest) = (at.t, at.s, 1.0 + at.s);
    ///     IntegrandTerms {
    ///         f: t * s / rest,
    ///         t: s / rest,
    ///         s: t / (rest * rest),
    ///         tt: 0.0,
    ///         ts: 1.0 / (rest * rest),
    ///         ss: -2.0 * t / (rest * rest * rest),
    ///     }
    /// });
    /// assert!(theory.is_ok());
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    ///
    /// # Errors
    /// Also [`VariationalError::Derivative`] when a derivative disagrees with differences of
    /// the function, which are tried at points of the mesh for small and large `T` and `S`.
    pub fn with_integrand(
        contact: &Contact,
        settings: Settings,
        integrand: impl Fn(IntegrandArguments) -> IntegrandTerms + Send + Sync + 'static,
    ) -> Result<Self, VariationalError> {
        let theory = Self::new(contact, settings)?;
        let ellipse = theory.response.ellipse();
        let positions: Vec<_> = theory.mesh.positions().iter().copied().step_by(7).collect();
        let semi_axes = [ellipse.a(), ellipse.b()];
        let own = OwnIntegrand::new(Arc::new(integrand), semi_axes, &positions)?;
        Ok(Self { own_integrand: Some(own), keeps_bound: false, ..theory })
    }

    /// The contact ellipse, in units of `c`.
    #[must_use]
    pub fn ellipse(&self) -> Ellipse {
        self.response.ellipse()
    }

    /// `A = (1 - sigma) E / (2 sqrt g)` of (5.3): a slip in units of `mu f00`, as in `P`, `Q`
    /// and `S`, over the same in units of `mu c / rho`.
    #[must_use]
    pub fn slip_scale(&self) -> f64 {
        self.mesh.slip_scale()
    }

    /// The mesh points `(x, y)` in units of `c`.
    #[must_use]
    pub fn mesh(&self) -> &[[f64; 2]] {
        self.mesh.positions()
    }

    /// Whether [`Method::Damped`] keeps tractions within their bound, see [`TractionBound`].
    #[must_use]
    pub fn keeps_bound(&self) -> bool {
        self.keeps_bound
    }

    /// Minimizes `I` from `start`.
    #[must_use]
    pub fn solve_from(&self, creepage: Creepage, start: &Start) -> VariationalSolution {
        self.solve_by(Procedure::default(), creepage, start, None)
    }

    /// The largest difference of a force or moment between `found` and the solution from
    /// another start: what a check by a second start (5.12) has to say.
    #[must_use]
    pub fn check_by(&self, creepage: Creepage, found: &VariationalSolution, start: &Start) -> f64 {
        let [one, two] = [found.solution.force, self.solve_from(creepage, start).solution.force];
        (one.fx - two.fx).abs().max((one.fy - two.fy).abs()).max((one.mz - two.mz).abs())
    }

    /// Traction, slip and their judgement at `positions` in units of `c`, all inside the
    /// ellipse, for the unknowns of a solution; missing ones count as zero.
    #[must_use]
    pub fn points(
        &self,
        creepage: Creepage,
        tau: &[f64],
        positions: &[[f64; 2]],
    ) -> Vec<MeshPoint> {
        let mut tau = tau.to_vec();
        tau.resize(self.mesh.unknowns(), 0.0);
        solution::mesh_points(self, &self.response.at(positions.to_vec()), creepage, &tau)
    }

    /// Whether anything slips without traction.
    fn is_driven(&self, creepage: Creepage) -> bool {
        creepage != Creepage::default() || self.contact.kappa_over_mu() != 0.0
    }

    /// Power of the tractions on the slip by the pressure, over `mu N mu c V / rho`.
    fn power_by_pressure(&self, tau: &[f64]) -> f64 {
        let still = Creepage::default();
        let scale = 1.5 / self.mesh.slip_scale();
        let power = |(point, weight): (usize, &f64)| {
            let [x, y, ..] = self.mesh.state(still, tau, point);
            let [p, q] = self.mesh.rigid_slip(still, point);
            scale * weight * (x * p + y * q)
        };
        self.power_weights.iter().enumerate().map(power).sum()
    }

    fn functional_of<'a>(&'a self, creepage: Creepage, form: Form<'a>) -> Functional<'a> {
        let is_power = matches!(form, Form::Power { .. });
        let weights = if is_power { &self.power_weights } else { &self.weights };
        Functional::new(&self.mesh, weights, creepage, form)
    }
}

impl Theory for Variational {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        self.solve_from(creepage, &Start::FullSliding).solution
    }

    /// The theory has no derivative.
    fn jacobian(&self, _: Creepage) -> Option<Jacobian> {
        None
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.solved(creepage).field(positions)
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        let found = self.solve_from(creepage, &Start::FullSliding);
        Box::new(SolvedVariational { theory: self, creepage, found })
    }
}

/// A minimum of `I`, for further questions.
struct SolvedVariational<'t> {
    theory: &'t Variational,
    creepage: Creepage,
    found: VariationalSolution,
}

impl Solved for SolvedVariational<'_> {
    fn creepage(&self) -> Creepage {
        self.creepage
    }

    fn solution(&self) -> Solution {
        self.found.solution
    }

    fn jacobian(&mut self) -> Option<Jacobian> {
        None
    }

    fn field(&self, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let points = self.theory.response.at(positions.to_vec());
        let field = solution::mesh_points(self.theory, &points, self.creepage, &self.found.tau);
        let clipped = |(point, bound): (MeshPoint, &f64)| {
            let inside = *bound > 0.0;
            if inside { point.field } else { FieldPoint::outside(point.field.position) }
        };
        field.into_iter().zip(points.bound_squared()).map(clipped).collect()
    }

    fn power(&self) -> f64 {
        let force = self.found.solution.force.components().into_iter();
        let rigid = force.zip(self.creepage.components()).map(|(force, creepage)| force * creepage);
        rigid.sum::<f64>() + self.theory.power_by_pressure(&self.found.tau)
    }

    fn points(&self) -> Option<Vec<FieldPoint>> {
        Some(self.found.points.iter().map(|point| point.field).collect())
    }

    fn diagnostics(&self) -> Vec<Diagnostic> {
        let found = &self.found;
        let diagnostic = |key, label, value| Diagnostic { key, label, value };
        vec![
            diagnostic("iterations", "iterations", found.iterations() as f64),
            diagnostic("mean_integrand", "mean of W T S", found.mean_integrand),
            diagnostic("residual", "residual", found.residual),
            diagnostic("aberrations", "aberrant points", found.aberrations as f64),
        ]
    }
}
