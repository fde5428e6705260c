//! The full theory of steady rolling: Coulomb's law holds at every element, no shape of the
//! traction is assumed.
//!
//! Elements fit the ellipse, the slip of each is an upstream difference of displacements of
//! second order, friction is a projection, and Newton solves it, strip by strip at first, then in
//! all strips at once. Every force and the frictional power come from two grids: their difference
//! gives the extrapolated value and its error bar.
//!
//! With `P` the projection on the disc whose radius is the traction bound, Coulomb's law for a
//! traction `p` and slip `s` is one equation, for any `r > 0`:
//!
//! ```math
//! p = P(p + r s)
//! ```

mod automatic;
mod dense;
mod derivative;
mod elements;
mod ends;
mod friction;
mod gmres;
mod grid;
mod influence;
mod inverse;
mod linear;
mod load;
mod newton;
mod resolution;
mod row;
mod sampling;
mod solution;
mod solve;
mod state;
mod strip;
mod tractions;
mod unlike;

pub use automatic::Automatic;
pub use inverse::{Found, InverseError, Known};
pub use resolution::Resolution;
pub use solution::{ElementField, ExactSolution, Workspace};

use crate::check::{self, InvalidValue};
use crate::theory::{Diagnostic, Jacobian, Solved, Statistics};
use crate::{Contact, Creepage, FieldPoint, Force, Solution, Theory};
use grid::Grid;

/// The full theory, prepared for one ratio of semi-axes and one Poisson's ratio.
///
/// Error of `(fx, fy)` in parts of `mu N` beyond the uncertainty of the 132 reference cases of
/// `creepage-validation`, and the cost of a case and of preparation on one core:
///
/// | resolution | median | rms | worst | case | preparation |
/// |---|---|---|---|---|---|
/// | [`Resolution::FAST`] | 0.03 % | 0.22 % | 1.2 % | 0.5 ms | 2 ms |
/// | [`Resolution::STANDARD`] | 0.00 % | 0.06 % | 0.32 % | 2 ms | 10 ms |
/// | [`Resolution::FINE`] | 0.00 % | 0.01 % | 0.03 % | 25 ms | 0.1 s |
///
/// Errors are largest with a pole of strong spin inside the contact. At the fine resolution the
/// limit of small creepage is met to 0.2 % in every coefficient for `a/b` from 0.1 to 10, and full
/// sliding to 0.05 % of `mu N`; beyond `a/b = 10` small creepage is resolved less well, which
/// shows in the error bar.
///
/// ```
/// use creepage::coulomb::{Exact, Resolution};
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let contact = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
/// let theory = Exact::new(&contact, Resolution::FAST)?;
/// let solution = theory.solve(Creepage::new(0.9, 0.0, 0.0)?);
/// let error = solution.error.map_or(f64::NAN, |error| error.fx);
/// assert!((solution.force.fx - 0.733).abs() < error + 0.002);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Exact {
    contact: Contact,
    /// The coarser grid, then the finer with twice its elements along and across.
    grids: [Grid; 2],
}

impl Exact {
    /// Smallest and largest `a/b`: beyond, strip theory or a line contact is the better model.
    pub const RATIO_RANGE: [f64; 2] = [1.0 / 64.0, 64.0];

    /// Prepares the theory for a contact. Between dissimilar bodies the pressure adds to the slip
    /// (6.4).
    ///
    /// Contact area and pressure stay those of Hertz: what the tangential traction adds to the
    /// normal displacement (2.15c) is neglected. Without creepage there is a force then, and it
    /// makes a difference whether the upper body pulls or brakes. For large creepage the pressure's
    /// slip does not matter.
    ///
    /// ```
    /// use creepage::coulomb::{Exact, Resolution};
    /// use creepage::{Contact, Creepage, Ellipse, Theory};
    /// // Rubber with a hard body below, as a ball on a plate: kappa < 0 unless incompressible.
    /// let contact = Contact::new(Ellipse::from_ratio(1.0)?, 0.45)?.with_kappa_over_mu(-0.05)?;
    /// let solution = Exact::new(&contact, Resolution::FAST)?.solve(Creepage::default());
    /// assert!(solution.force.fx > 0.0 && solution.force.fy.abs() < 1e-9);
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidValue`] unless the ratio `a/b` lies within [`Exact::RATIO_RANGE`].
    pub fn new(contact: &Contact, resolution: Resolution) -> Result<Self, InvalidValue> {
        check::ratio(contact.ellipse().ratio(), Self::RATIO_RANGE, "between 1/64 and 64")?;
        Ok(Self::prepare(contact, resolution))
    }

    /// [`Exact::new`] for a contact that has been checked.
    fn prepare(contact: &Contact, resolution: Resolution) -> Self {
        let (ellipse, poisson) = (contact.ellipse(), contact.poisson());
        let [along, across] = resolution.coarse(ellipse.ratio());
        let mut grids = [1, 2].map(|k| Grid::new(ellipse, poisson, k * along, k * across));
        for grid in &mut grids {
            grid.set_unlikeness(ellipse, contact.kappa_over_mu());
        }
        Self { contact: *contact, grids }
    }

    /// Elements along and across on the finer grid.
    #[must_use]
    pub fn elements(&self) -> [usize; 2] {
        [self.grids[1].elements.along, self.grids[1].elements.strips]
    }

    /// Room for solutions, to be used again from case to case.
    #[must_use]
    pub fn workspace(&self) -> Workspace {
        Workspace::new(&self.grids)
    }

    /// Solves from scratch.
    pub fn solve_with(&self, creepage: Creepage, workspace: &mut Workspace) -> ExactSolution {
        workspace.solve(&self.grids, creepage, false);
        workspace.finish(&self.grids, creepage)
    }

    /// Solves from the tractions that `workspace` holds: quicker along a curve of creepages.
    pub fn solve_next(&self, creepage: Creepage, workspace: &mut Workspace) -> ExactSolution {
        workspace.solve(&self.grids, creepage, true);
        workspace.finish(&self.grids, creepage)
    }

    /// Solves along a curve of creepages, each from the one before.
    #[must_use]
    pub fn curve(&self, creepages: &[Creepage]) -> Vec<ExactSolution> {
        let mut workspace = self.workspace();
        creepages.iter().map(|creepage| self.solve_next(*creepage, &mut workspace)).collect()
    }

    /// Derivative of the force last solved in `workspace`, by `xi`, `eta` and `chi`: row `i`,
    /// column `k` is the derivative of `(fx, fy, mz)[i]` by `(xi, eta, chi)[k]`.
    ///
    /// It is the derivative of the extrapolated force. Where an element is about to change
    /// between adhesion and slip it is one-sided.
    #[must_use]
    pub fn derivative(&self, workspace: &mut Workspace) -> [[f64; 3]; 3] {
        workspace.derivative(&self.grids)
    }

    /// The elements of the finer grid as last solved in `workspace`, strip by strip from
    /// negative `y`, each from the leading edge.
    #[must_use]
    pub fn element_fields(&self, workspace: &Workspace) -> Vec<ElementField> {
        workspace.element_fields(&self.grids[1])
    }

    /// Traction and slip at positions, as last solved in `workspace`.
    #[must_use]
    pub fn field_of(&self, workspace: &Workspace, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        positions
            .iter()
            .map(|at| workspace.field_at(&self.grids[1], self.contact.ellipse(), *at))
            .collect()
    }
}

impl Theory for Exact {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        self.solve_with(creepage, &mut self.workspace()).into()
    }

    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        self.solve_contact(creepage).jacobian()
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.solve_contact(creepage).field(positions)
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Box::new(self.solve_contact(creepage))
    }

    fn solved_for(&self, known: Known) -> Option<Result<Box<dyn Solved + '_>, InverseError>> {
        let found = self.find(known, &mut self.workspace());
        Some(found.map(|found| self.solved(found.creepage)))
    }
}

impl From<ExactSolution> for Solution {
    fn from(found: ExactSolution) -> Self {
        let iterations = found.sweeps.iter().sum();
        Self {
            force: found.force,
            error: Some(found.error),
            status: found.status,
            statistics: Statistics { iterations, factorizations: 0 },
        }
    }
}

/// One contact solved by the full theory, for further questions.
#[derive(Debug, Clone)]
pub struct ExactSolved<'t> {
    theory: &'t Exact,
    workspace: Workspace,
    creepage: Creepage,
    found: ExactSolution,
}

impl Exact {
    /// Solves, and keeps what was solved.
    #[must_use]
    pub fn solve_contact(&self, creepage: Creepage) -> ExactSolved<'_> {
        let mut workspace = self.workspace();
        let found = self.solve_with(creepage, &mut workspace);
        ExactSolved { theory: self, workspace, creepage, found }
    }
}

impl ExactSolved<'_> {
    /// The elements of the finer grid, strip by strip from negative `y`, each from the leading
    /// edge.
    #[must_use]
    pub fn elements(&self) -> Vec<ElementField> {
        self.theory.element_fields(&self.workspace)
    }
}

impl Solved for ExactSolved<'_> {
    fn creepage(&self) -> Creepage {
        self.creepage
    }

    fn solution(&self) -> Solution {
        self.found.into()
    }

    fn jacobian(&mut self) -> Option<Jacobian> {
        Some(self.theory.derivative(&mut self.workspace))
    }

    fn field(&self, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.theory.field_of(&self.workspace, positions)
    }

    fn points(&self) -> Option<Vec<FieldPoint>> {
        Some(self.elements().iter().map(|element| element.point).collect())
    }

    fn power(&self) -> f64 {
        self.found.power
    }

    fn dissipation(&self) -> Option<f64> {
        Some(self.found.dissipation)
    }

    fn diagnostics(&self) -> Vec<Diagnostic> {
        let (error, [along, across]) = (self.found.error, self.theory.elements());
        let diagnostic = |key, label, value| Diagnostic { key, label, value };
        let mut diagnostics = vec![
            diagnostic("fx_error", "error bar of f_x", error.fx),
            diagnostic("fy_error", "error bar of f_y", error.fy),
            diagnostic("mz_error", "error bar of m_z", error.mz),
            diagnostic("elements", "elements", (along * across) as f64),
        ];
        let kappa_over_mu = self.theory.contact.kappa_over_mu();
        if kappa_over_mu != 0.0 {
            diagnostics.push(diagnostic("kappa_over_mu", "unlike bodies, kappa/mu", kappa_over_mu));
        }
        diagnostics
    }
}
