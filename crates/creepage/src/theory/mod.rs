//! Traits of every theory of rolling contact: [`Theory`], prepared for a contact, and [`Solved`], its solution.
//!
//! A theory is prepared once for a [`Contact`] and asked many times: [`Theory::solve`] gives a
//! [`Solution`], [`Theory::solved`] keeps the solved contact for further questions ([`Solved`]).

mod areas;
mod constraints;
mod facts;
pub(crate) mod field;
mod spec;

pub use areas::AreaTheory;
pub use constraints::{Constraints, InverseError};
pub use facts::TheoryFacts;
pub use field::{FieldPoint, Patch, Region};
pub use spec::{
    ExactOptions, FastripOptions, NamedResolution, NoOptions, PolachOptions, ResolutionSpec,
    TheoryError, TheorySpec, UnknownTheory, VariationalOptions,
};

use crate::contact::Contact;
use crate::coulomb::ElementField;
use crate::creepage::{Creepage, Force};

/// Trustworthiness of a force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Status {
    /// The theory's equations are solved, within the range where the theory holds.
    Solved,
    /// The iteration ended before its tolerance was met; the force is that of the last iterate.
    NotConverged,
    /// Solved, but the creepage is too small for the theory's resolution: its slip area is
    /// narrower than the theory can represent, and the force is too small. Use linear theory.
    CreepageTooSmall,
    /// Solved, but the spin is beyond the bound up to which the theory holds.
    SpinTooLarge,
    /// Solved from friction at rest, but friction falls with the speed of slip so steeply that another
    /// solution exists, with more slip and less force.
    SeveralSolutions,
    /// Nothing presses the bodies together: there is no contact, and no force.
    NoContact,
}

impl Status {
    /// One word for tables: `solved`, `not_converged`, `creepage_too_small`, `spin_too_large`,
    /// `several_solutions`, `no_contact`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::NotConverged => "not_converged",
            Self::CreepageTooSmall => "creepage_too_small",
            Self::SpinTooLarge => "spin_too_large",
            Self::SeveralSolutions => "several_solutions",
            Self::NoContact => "no_contact",
        }
    }
}

/// Cost of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Statistics {
    /// Steps of the theory's iteration: sweeps over the strips, Newton steps. Zero for a theory in
    /// closed form.
    pub iterations: usize,
    /// Matrices factored.
    pub factorizations: usize,
}

/// A theory's force at one creepage, how far it may be off, and whether it may be trusted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution {
    /// Force and moment on the lower body.
    pub force: Force,
    /// Error bars of `force`, where the theory knows them.
    pub error: Option<Force>,
    /// Outcome of the solution.
    pub status: Status,
    /// What it cost.
    pub statistics: Statistics,
}

impl Solution {
    /// No force, for nothing presses the bodies together.
    #[must_use]
    pub fn no_contact() -> Self {
        Self::closed_form(Force::default(), Status::NoContact)
    }

    /// The solution of a theory in closed form, without error bars.
    pub(crate) fn closed_form(force: Force, status: Status) -> Self {
        Self { force, error: None, status, statistics: Statistics::default() }
    }
}

/// Derivative of the force by the creepage: rows `fx`, `fy`, `mz`; columns `xi`, `eta`, `chi`.
pub type Jacobian = [[f64; 3]; 3];

/// A theory prepared for one contact.
///
/// Prepare once, ask many times; a theory is shared freely between threads.
///
/// [`Theory::solve`], [`Theory::jacobian`] and [`Theory::field`] ask the contact that [`Theory::solved`]
/// solves. A theory that keeps nothing from a solve gives these three, and [`Stateless::boxed`] for
/// [`Theory::solved`].
pub trait Theory: Send + Sync {
    /// The contact that the theory is prepared for.
    fn contact(&self) -> &Contact;

    /// Force and moment at `creepage`.
    fn solve(&self, creepage: Creepage) -> Solution {
        self.solved(creepage).solution()
    }

    /// Derivative of the force at `creepage`, one-sided where the force has a kink; `None` for a
    /// theory without a derivative.
    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        self.solved(creepage).jacobian()
    }

    /// Traction and slip at `positions` `(x, y)` in units of `c`; those outside the contact are
    /// [`Region::Outside`].
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.solved(creepage).field(positions)
    }

    /// Stick, slip or outside at `positions`, as [`Theory::field`] has it: for a theory that knows
    /// them without a traction.
    fn regions(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<Region> {
        self.field(creepage, positions).iter().map(|point| point.region).collect()
    }

    /// The contact solved at `creepage`, for further questions.
    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_>;

    /// The contact solved at the creepage that meets the constraints; `None` for a theory that does
    /// not find creepages.
    ///
    /// # Errors
    /// [`InverseError`] within the `Option`, unless three quantities are given, all finite, and
    /// within reach.
    fn solved_for(&self, _: Constraints) -> Option<Result<Box<dyn Solved + '_>, InverseError>> {
        None
    }
}

/// Diagnostic number that only one theory gives, such as the value of its functional.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Diagnostic {
    /// Its key in `report.json`.
    pub key: &'static str,
    /// Its name in words.
    pub label: &'static str,
    /// The number.
    pub value: f64,
}

/// One contact solved: what can be asked after a solve, of that solve and no other.
pub trait Solved: Send + Sync {
    /// The creepage.
    fn creepage(&self) -> Creepage;

    /// Force, error bars, status.
    fn solution(&self) -> Solution;

    /// As [`Theory::jacobian`].
    fn jacobian(&mut self) -> Option<Jacobian>;

    /// As [`Theory::field`].
    fn field(&self, positions: &[[f64; 2]]) -> Vec<FieldPoint>;

    /// As [`Theory::regions`].
    fn regions(&self, positions: &[[f64; 2]]) -> Vec<Region> {
        self.field(positions).iter().map(|point| point.region).collect()
    }

    /// Traction and slip at the points of the theory's own mesh; `None` for a theory without one.
    fn points(&self) -> Option<Vec<FieldPoint>> {
        None
    }

    /// The elements of a theory that has them, strip by strip, each from the leading edge, with the heat of
    /// each; `None` for a theory without elements.
    fn elements(&self) -> Option<Vec<ElementField>> {
        None
    }

    /// The traction as constant on quadrilaterals that fill the contact, for the stresses below; `None`
    /// for a theory without elements.
    fn patches(&self) -> Option<Vec<Patch>> {
        None
    }

    /// Frictional power over `mu N mu c V / rho` from force and creepage: `fx xi + fy eta + mz chi`,
    /// and between dissimilar bodies what the pressure adds.
    fn power(&self) -> f64 {
        let [force, creepage] = [self.solution().force.components(), self.creepage().components()];
        force.iter().zip(creepage).map(|(force, creepage)| force * creepage).sum()
    }

    /// The same power as the integral of traction times slip over the contact, where the theory
    /// has it.
    fn dissipation(&self) -> Option<f64> {
        None
    }

    /// Contact area over `pi a b`: one unless the theory finds the area.
    fn relative_area(&self) -> f64 {
        1.0
    }

    /// Where a position of the ellipse has moved with the contact area.
    fn moved(&self, position: [f64; 2]) -> [f64; 2] {
        position
    }

    /// The theory's own figures.
    fn diagnostics(&self) -> Vec<Diagnostic> {
        Vec::new()
    }
}

/// The solved contact of a theory that keeps nothing from a solve.
#[derive(Debug, Clone, Copy)]
pub struct Stateless<'t, T: ?Sized> {
    theory: &'t T,
    creepage: Creepage,
    solution: Solution,
}

impl<'t, T: Theory> Stateless<'t, T> {
    /// Solves; what is asked afterwards is asked of the theory again.
    #[must_use]
    pub fn boxed(theory: &'t T, creepage: Creepage) -> Box<dyn Solved + 't> {
        Box::new(Self { theory, creepage, solution: theory.solve(creepage) })
    }
}

impl<T: Theory> Solved for Stateless<'_, T> {
    fn creepage(&self) -> Creepage {
        self.creepage
    }

    fn solution(&self) -> Solution {
        self.solution
    }

    fn jacobian(&mut self) -> Option<Jacobian> {
        self.theory.jacobian(self.creepage)
    }

    fn field(&self, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.theory.field(self.creepage, positions)
    }

    fn regions(&self, positions: &[[f64; 2]]) -> Vec<Region> {
        self.theory.regions(self.creepage, positions)
    }
}

/// The derivative of a force by central differences of `part` of each component of the creepage, or of
/// one where that is smaller.
pub(crate) fn differences(
    creepage: Creepage,
    part: f64,
    force: impl Fn(Creepage) -> [f64; 3],
) -> Jacobian {
    let at = creepage.components();
    let columns = [0, 1, 2].map(|k| {
        let step = part * at[k].abs().max(1.0);
        let [ahead, behind] = [step, -step].map(|step| {
            let mut moved = at;
            moved[k] += step;
            let [xi, eta, chi] = moved;
            force(Creepage { xi, eta, chi })
        });
        [0, 1, 2].map(|i| (ahead[i] - behind[i]) / (2.0 * step))
    });
    std::array::from_fn(|i| std::array::from_fn(|k| columns[k][i]))
}
