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
pub use unlike::check_unlikeness;

use super::{Creepage, FieldPoint, Force, Region, Solution, Status, Theory};
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;
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
/// use creepage::rolling::exact::{Exact, Resolution};
/// use creepage::rolling::Creepage;
/// let theory = Exact::new(1.0, 0.28, Resolution::FAST)?;
/// let solution = theory.solve_with(Creepage::new(0.9, 0.0, 0.0)?, &mut theory.workspace());
/// assert!((solution.force.fx - 0.733).abs() < solution.error.fx + 0.002);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Exact {
    ellipse: Ellipse,
    kappa_over_mu: f64,
    /// The coarser grid, then the finer with twice its elements along and across.
    grids: [Grid; 2],
}

impl Exact {
    /// Smallest and largest `a/b`: beyond, strip theory or a line contact is the better model.
    pub const RATIO_RANGE: [f64; 2] = [1.0 / 64.0, 64.0];

    /// Prepares the theory for the ratio `a/b` of the semi-axes and the combined Poisson's ratio.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `a_over_b` lies within [`Exact::RATIO_RANGE`] and `poisson`
    /// between 0 and 0.5.
    pub fn new(a_over_b: f64, poisson: f64, resolution: Resolution) -> Result<Self, InvalidValue> {
        let [low, high] = Self::RATIO_RANGE;
        let valid = "between 1/64 and 64";
        check::require((low..=high).contains(&a_over_b), "a_over_b", a_over_b, valid)?;
        check::poisson(poisson)?;
        Ok(Self::prepare(Ellipse::from_ratio(a_over_b)?, poisson, resolution))
    }

    /// [`Exact::new`] for values that have been checked.
    fn prepare(ellipse: Ellipse, poisson: f64, resolution: Resolution) -> Self {
        let [along, across] = resolution.coarse(ellipse.ratio());
        let grids = [1, 2].map(|k| Grid::new(ellipse, poisson, k * along, k * across));
        Self { ellipse, kappa_over_mu: 0.0, grids }
    }

    /// The same between unlike bodies: their pressure adds to the slip (6.4). `kappa_over_mu` is
    /// [`SolidPair::kappa`](crate::SolidPair::kappa) over the coefficient of friction.
    ///
    /// Contact area and pressure stay those of Hertz: what the tangential traction adds to the
    /// normal displacement (2.15c) is neglected. Without creepage there is a force then, and it
    /// makes a difference whether the upper body pulls or brakes. For large creepage the pressure's
    /// slip does not matter.
    ///
    /// ```
    /// use creepage::rolling::exact::{Exact, Resolution};
    /// use creepage::rolling::Creepage;
    /// // Rubber with a hard body below, as a ball on a plate: kappa < 0 unless incompressible.
    /// let theory = Exact::new(1.0, 0.45, Resolution::FAST)?.with_unlikeness(-0.05)?;
    /// let solution = theory.solve_with(Creepage::default(), &mut theory.workspace());
    /// assert!(solution.force.fx > 0.0 && solution.force.fy.abs() < 1e-9);
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidValue`] unless `kappa_over_mu` lies between -1e6 and 1e6.
    pub fn with_unlikeness(mut self, kappa_over_mu: f64) -> Result<Self, InvalidValue> {
        check_unlikeness(kappa_over_mu)?;
        self.set_unlikeness(kappa_over_mu);
        Ok(self)
    }

    fn set_unlikeness(&mut self, kappa_over_mu: f64) {
        self.kappa_over_mu = kappa_over_mu;
        for grid in &mut self.grids {
            grid.set_unlikeness(self.ellipse, kappa_over_mu);
        }
    }

    /// How unlike the bodies are: kappa over the coefficient of friction.
    #[must_use]
    pub fn kappa_over_mu(&self) -> f64 {
        self.kappa_over_mu
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
        positions.iter().map(|at| workspace.field_at(&self.grids[1], self.ellipse, *at)).collect()
    }
}

impl Theory for Exact {
    fn solve(&self, creepage: Creepage) -> Solution {
        let solution = self.solve_with(creepage, &mut self.workspace());
        Solution { force: solution.force, status: solution.status }
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let mut workspace = self.workspace();
        self.solve_with(creepage, &mut workspace);
        self.field_of(&workspace, positions)
    }
}
