//! The solution of one elliptic contact, kept for fields, derivatives and further solves.

use super::Exact;
use super::dissipation::{self, Unresolved};
use super::extrapolation::{Extrapolation, extrapolate};
use super::field_interpolation::{ElementField, FieldInterpolation};
use super::grid::Grid;
use super::solver::State;
use super::workspace::Workspace;
use crate::theory::field::mean;
use crate::theory::{
    Diagnostic, FieldPoint, Jacobian, Patch, Solution, Solved, Status, differences,
};
use crate::{Contact, Creepage, Force};

/// The reflections that make `xi` and `chi` (or `eta`, without spin) positive: the contact has
/// the symmetries (4.22)-(4.28), and with these they hold to the last bit. The one that changes the
/// sign of `xi` turns all vectors about and leaves the pressure, and so exchanges dissimilar bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mirror {
    pub(super) x: f64,
    pub(super) y: f64,
}

impl Mirror {
    fn in_contact(contact: &Contact, creepage: Creepage) -> Self {
        if is_symmetric(contact) { Self::of(creepage) } else { Self { x: 1.0, y: 1.0 } }
    }

    pub(super) fn of(creepage: Creepage) -> Self {
        let negative = creepage.chi < 0.0 || (creepage.chi == 0.0 && creepage.eta < 0.0);
        let sign = |negative| if negative { -1.0 } else { 1.0 };
        Self { x: sign(creepage.xi < 0.0), y: sign(negative) }
    }

    /// Signs of `xi`, `eta`, `chi`, and of `fx`, `fy`, `mz`.
    pub(super) fn signs(self) -> [f64; 3] {
        [self.x, self.y, self.y]
    }

    pub(super) fn creepage(self, Creepage { xi, eta, chi }: Creepage) -> Creepage {
        Creepage { xi: self.x * xi, eta: self.y * eta, chi: self.y * chi }
    }

    pub(super) fn force(self, Force { fx, fy, mz }: Force) -> Force {
        Force { fx: self.x * fx, fy: self.y * fy, mz: self.y * mz }
    }

    pub(super) fn vector(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.x * x, self.y * y]
    }

    pub(super) fn position(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x, self.x * self.y * y]
    }

    pub(super) fn element(self, element: ElementField) -> ElementField {
        let point = FieldPoint {
            position: self.position(element.point.position),
            traction: self.vector(element.point.traction),
            slip: self.vector(element.point.slip),
            ..element.point
        };
        let corners = element.corners.map(|corner| self.position(corner));
        ElementField { point, corners, ..element }
    }
}

/// Change of the creepage to differentiate by, where friction depends on the slip.
const CREEPAGE_STEP: f64 = 1e-4;

/// What a solve gives.
#[derive(Debug, Clone, Copy)]
struct Answer {
    creepage: Creepage,
    mirror: Mirror,
    extrapolation: Extrapolation,
    /// Those of the coarser and the finer grid, mirrored.
    forces: [Force; 2],
    solution: Solution,
    power: f64,
    dissipation: f64,
    /// What the tractions of the finer grid's elements give of it.
    by_elements: f64,
}

impl Answer {
    /// Solves from scratch, or from the tractions of the last case.
    fn new(exact: &Exact, workspace: &mut Workspace, creepage: Creepage, warm: bool) -> Self {
        let mirror = Mirror::in_contact(&exact.contact, creepage);
        let mirrored = mirror.creepage(creepage);
        workspace.solve(&exact.grids, warm, |k, forcing| {
            exact.grids[k].set_forcing(mirrored, mirror.x, forcing);
            forcing.add(&exact.added[k]);
        });
        let [coarse, fine] = workspace.sums(&exact.grids, mirror.x);
        let extrapolation = Extrapolation::new(&exact.contact, mirrored);
        let forces = [coarse.force, fine.force];
        let force = mirror.force(extrapolation.force(forces));
        let force = without_rounding(&exact.contact, creepage, force);
        let error = extrapolation.error_bar(forces, exact.grids[1].mesh.len());
        let states = workspace.states();
        let [on_coarse, on_fine] =
            [0, 1].map(|k: usize| states[k].work(&exact.grids[k], forces[k], &exact.added[k]));
        let power = power_of(force, creepage)
            + extrapolate(coarse.by_pressure, fine.by_pressure)
            + extrapolate(on_coarse, on_fine);
        let work = power_of(fine.force, mirrored) + on_fine;
        let dissipation = dissipation::dissipation(power, &fine, work);
        let by_elements = fine.dissipation;
        let solution = workspace.solution(force, error);
        Self { creepage, mirror, extrapolation, forces, solution, power, dissipation, by_elements }
    }

    /// The same with a look at what kinetic friction leads to, on the coarser grid.
    fn with_other(
        exact: &Exact,
        workspace: &mut Workspace,
        creepage: Creepage,
        warm: bool,
    ) -> Self {
        let mut answer = Self::new(exact, workspace, creepage, warm);
        let is_solved = answer.solution.status == Status::Solved;
        if is_solved && workspace.has_another(&exact.grids, answer.mirror.x) {
            answer.solution.status = Status::SeveralSolutions;
        }
        answer
    }

    /// The derivative where the bounds follow the slip, by differences of solutions.
    fn differences(&self, exact: &Exact, workspace: &Workspace) -> Jacobian {
        differences(self.creepage, CREEPAGE_STEP, |creepage| {
            // Another mirror image would be a start from the wrong side.
            let warm = Mirror::in_contact(&exact.contact, creepage) == self.mirror;
            let answer = Self::new(exact, &mut workspace.clone(), creepage, warm);
            answer.solution.force.components()
        })
    }
}

/// The force, what the symmetries (4.22)-(4.28) make vanish being zero rather than the rounding of sums.
fn without_rounding(contact: &Contact, creepage: Creepage, force: Force) -> Force {
    let vanish = |components: &[f64]| components.iter().all(|component| *component == 0.0);
    let Creepage { xi, eta, chi } = creepage;
    let mut force = force;
    if !is_symmetric(contact) {
        return force;
    }
    if vanish(&[eta, chi]) {
        (force.fy, force.mz) = (0.0, 0.0);
    }
    if vanish(&[xi, contact.kappa_over_mu()]) {
        force.fx = 0.0;
    }
    force
}

/// Whether the contact has the symmetries (4.22)-(4.28): friction that differs across it, or a slip beside creepage
/// and spin, leave none of them.
fn is_symmetric(contact: &Contact) -> bool {
    let differs_across =
        contact.rolling_friction().is_some_and(|friction| friction.by_place().is_some());
    !differs_across && contact.added_slip().is_none()
}

pub(super) fn power_of(Force { fx, fy, mz }: Force, Creepage { xi, eta, chi }: Creepage) -> f64 {
    fx * xi + fy * eta + mz * chi
}

/// One contact solved by [`Exact`]; made by [`Exact::solve_contact`].
#[derive(Debug)]
pub struct ExactSolved<'a> {
    exact: &'a Exact,
    workspace: Workspace,
    answer: Answer,
}

impl<'a> ExactSolved<'a> {
    pub(super) fn new(exact: &'a Exact, creepage: Creepage) -> Self {
        let mut workspace = exact.pool.take(&exact.grids);
        let answer = Answer::with_other(exact, &mut workspace, creepage, false);
        Self { exact, workspace, answer }
    }

    /// The theory that solved it.
    #[must_use]
    pub fn theory(&self) -> &'a Exact {
        self.exact
    }

    /// Solves for another creepage, from these tractions: quicker along a curve.
    #[must_use]
    pub fn next(mut self, creepage: Creepage) -> Self {
        self.answer = Answer::with_other(self.exact, &mut self.workspace, creepage, true);
        self
    }

    /// The elements of the finer grid, strip by strip from negative `y`, each from the leading
    /// edge.
    #[must_use]
    pub fn elements(&self) -> Vec<ElementField> {
        let mesh = &self.exact.grids[1].mesh;
        let (strips, mirror) = (mesh.strips.len(), self.answer.mirror);
        let flips = mirror.x * mirror.y < 0.0;
        let place = |strip: usize| if flips { strips - 1 - strip } else { strip };
        let ([_, (grid, state)], [_, view]) = (self.levels(), self.views());
        let unresolved =
            Unresolved::new(grid, state, self.answer.dissipation, self.answer.by_elements);
        let element = |(strip, i): (usize, usize)| {
            let strip = place(strip);
            let power = unresolved.power(grid, state, strip, i);
            mirror.element(ElementField { power, ..view.element(strip, i) })
        };
        mesh.all().map(element).collect()
    }

    /// The coarser and the finer grid, each with its state.
    fn levels(&self) -> [(&Grid, &State); 2] {
        let ([coarse, fine], states) = (&self.exact.grids, self.workspace.states());
        [(coarse, states[0]), (fine, states[1])]
    }

    /// The same as they are seen.
    fn views(&self) -> [FieldInterpolation<'_>; 2] {
        self.levels().map(|(grid, state)| FieldInterpolation::new(grid, state))
    }

    fn at(&self, level: usize, view: &FieldInterpolation, position: [f64; 2]) -> FieldPoint {
        let (mirror, mesh) = (self.answer.mirror, &self.exact.grids[level].mesh);
        let ellipse = self.exact.contact.ellipse();
        let [x, y] = mirror.position(position);
        let left = 1.0 - (x / ellipse.a()).powi(2) - (y / ellipse.b()).powi(2);
        if left <= 0.0 {
            return FieldPoint::outside(position);
        }
        let length = ellipse.a() * (1.0 - (y / ellipse.b()).powi(2)).max(0.0).sqrt();
        let along = x / length.max(f64::MIN_POSITIVE);
        let below = mesh.strips.partition_point(|strip| strip.borders()[1] <= y);
        let strip = below.min(mesh.strips.len() - 1);
        let point = view.at(strip, [x, y], along, left.sqrt());
        let (traction, slip) = (mirror.vector(point.traction), mirror.vector(point.slip));
        FieldPoint { position, traction, slip, ..point }
    }
}

/// A quadrilateral cut at the middles of its sides.
pub(super) fn quarters(corners: [[f64; 2]; 4]) -> [[[f64; 2]; 4]; 4] {
    let side = |k: usize| mean(&[corners[k % 4], corners[(k + 1) % 4]]);
    [0, 1, 2, 3].map(|k| [corners[k], side(k), mean(&corners), side(k + 3)])
}

impl Drop for ExactSolved<'_> {
    fn drop(&mut self) {
        self.exact.pool.give_back(std::mem::take(&mut self.workspace));
    }
}

impl Solved for ExactSolved<'_> {
    fn creepage(&self) -> Creepage {
        self.answer.creepage
    }

    fn solution(&self) -> Solution {
        self.answer.solution
    }

    /// That of the extrapolated force; where friction depends on the slip by differences, to some 1e-3.
    fn jacobian(&mut self) -> Option<Jacobian> {
        if self.exact.grids[1].resistance.is_some() {
            return Some(self.answer.differences(self.exact, &self.workspace));
        }
        let Answer { mirror, extrapolation, forces, .. } = self.answer;
        let by = self.workspace.derivatives(&self.exact.grids);
        let columns = extrapolation.derivative(forces, by).map(|force| force.components());
        let signs = mirror.signs();
        let entry = |i: usize, k: usize| signs[i] * signs[k] * columns[k][i];
        Some(std::array::from_fn(|i| std::array::from_fn(|k| entry(i, k))))
    }

    fn field(&self, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let [_, fine] = self.views();
        positions.iter().map(|at| self.at(1, &fine, *at)).collect()
    }

    /// The quarters of the finer grid's elements. The traction is extrapolated from the two grids, as
    /// the force is.
    fn patches(&self) -> Option<Vec<Patch>> {
        let views = self.views();
        let quarters = self.elements().into_iter().flat_map(|element| quarters(element.corners));
        let patch = |corners: [[f64; 2]; 4]| {
            let at = |k: usize| self.at(k, &views[k], mean(&corners)).traction;
            let [coarse, fine] = [0, 1].map(at);
            Patch { corners, traction: [0, 1].map(|k| extrapolate(coarse[k], fine[k])) }
        };
        Some(quarters.map(patch).collect())
    }

    fn points(&self) -> Option<Vec<FieldPoint>> {
        Some(self.elements().iter().map(|element| element.point).collect())
    }

    /// Between dissimilar bodies with the power of the tractions on the slip that the pressure causes,
    /// which comes from the resistance to rolling.
    fn power(&self) -> f64 {
        self.answer.power
    }

    /// The power, and what traction times slip gives beyond it on the finer grid. What it falls short
    /// there is the heat of slip areas narrower than an element, along the trailing edge, and is added
    /// there.
    fn dissipation(&self) -> Option<f64> {
        Some(self.answer.dissipation)
    }

    fn elements(&self) -> Option<Vec<ElementField>> {
        Some(Self::elements(self))
    }

    fn diagnostics(&self) -> Vec<Diagnostic> {
        let elements = self.exact.grids[1].mesh.len();
        let contact = &self.exact.contact;
        let mut diagnostics = error_bars_and_elements(
            &self.exact.added[1],
            contact,
            self.answer.solution.error,
            elements,
        );
        let kappa_over_mu = contact.kappa_over_mu();
        if kappa_over_mu != 0.0 {
            let (key, label) = ("kappa_over_mu", "unlike bodies, kappa/mu");
            diagnostics.push(Diagnostic { key, label, value: kappa_over_mu });
        }
        diagnostics
    }
}

/// What the full theory says on any contact: its error bars, how many elements it took, and the largest slip (over the
/// rolling velocity) of those that are added element by element, where they are.
pub(super) fn error_bars_and_elements(
    added: &[[f64; 2]],
    contact: &Contact,
    error: Option<Force>,
    elements: usize,
) -> Vec<Diagnostic> {
    let error = error.unwrap_or_default();
    let diagnostic = |key, label, value| Diagnostic { key, label, value };
    let largest = added.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
    let slip = contact
        .added_slip()
        .map(|_| diagnostic("added_slip", "added slip, largest", contact.scaling().slip * largest));
    let all = [
        diagnostic("fx_error", "error bar of f_x", error.fx),
        diagnostic("fy_error", "error bar of f_y", error.fy),
        diagnostic("mz_error", "error bar of m_z", error.mz),
        diagnostic("elements", "elements", elements as f64),
    ];
    all.into_iter().chain(slip).collect()
}
