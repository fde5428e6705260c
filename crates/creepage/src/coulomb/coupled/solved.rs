//! One coupled contact solved, kept for further questions.

use super::level::{Settled, Start};
use super::{Coupled, Prepared};
use crate::coulomb::extrapolation::{Extrapolation, extrapolate};
use crate::coulomb::inverse::Trial;
use crate::coulomb::quadrature::Sum;
use crate::coulomb::solution::{ElementField, Mirror, between, quarters};
use crate::theory::field::mean;
use crate::theory::{
    Diagnostic, FieldPoint, Jacobian, Patch, Region, Solution, Solved, Statistics, Status,
};
use crate::{Creepage, Force, Theory};

/// One contact of unlike bodies solved by [`Coupled`].
///
/// Its [`jacobian`](Solved::jacobian) holds area and pressure: what comes of their motion, a part of
/// order `kappa mu`, is left out.
#[derive(Debug)]
pub struct CoupledSolved<'a> {
    theory: &'a Coupled,
    prepared: &'a Prepared,
    creepage: Creepage,
    mirror: Mirror,
    /// On the coarser and the finer grid; `None` where the strips of the normal problem fail.
    settled: Option<[Settled; 2]>,
    solution: Solution,
    power: f64,
    dissipation: f64,
}

impl<'a> CoupledSolved<'a> {
    /// From the pressures of a solution close by, or from Hertz's.
    pub(super) fn new(
        theory: &'a Coupled,
        prepared: &'a Prepared,
        creepage: Creepage,
        near: Option<&Self>,
    ) -> Self {
        let mirror = Mirror::of(creepage);
        let near =
            near.filter(|near| near.mirror.x * mirror.x > 0.0 && near.mirror.y * mirror.y > 0.0);
        let near = near.and_then(|near| near.settled.as_ref());
        let settled = settle(theory, prepared, (creepage, mirror), near);
        let Some(levels) = &settled else {
            return Self::one_way(theory, prepared, creepage, mirror);
        };
        let sum = |k: usize| levels[k].state.sum(&levels[k].grid, mirror.x);
        let [first, second] = [sum(0), sum(1)];
        let extrapolation = Extrapolation::new(&theory.contact, mirror.creepage(creepage));
        let forces = [first.force, second.force];
        let force = mirror.force(extrapolation.force(forces));
        let rigid = force.fx * creepage.xi + force.fy * creepage.eta + force.mz * creepage.chi;
        let value = |of: fn(&Sum) -> f64| extrapolate(of(&first), of(&second));
        let elements = levels[1].grid.mesh.len();
        let error = extrapolation.error_bar(forces, elements);
        Self {
            solution: solution(force, error, levels),
            power: rigid + value(|sum| sum.by_pressure),
            dissipation: value(|sum| sum.dissipation).max(0.0),
            theory,
            prepared,
            creepage,
            mirror,
            settled,
        }
    }

    /// Not coupled, and therefore not a solution.
    fn one_way(
        theory: &'a Coupled,
        prepared: &'a Prepared,
        creepage: Creepage,
        mirror: Mirror,
    ) -> Self {
        let solved = prepared.exact.solve_contact(creepage);
        let solution = Solution { status: Status::NotConverged, ..solved.solution() };
        let (power, dissipation) = (solved.power(), solved.dissipation().unwrap_or(f64::NAN));
        let settled = None;
        Self { theory, prepared, creepage, mirror, settled, solution, power, dissipation }
    }

    /// Elements on the finer grid, along and across.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        self.prepared.exact.elements()
    }

    /// Turns between friction and normal contact, on the coarser and the finer grid.
    #[must_use]
    pub fn turns(&self) -> [usize; 2] {
        self.settled.as_ref().map_or([0; 2], |levels| levels.each_ref().map(|level| level.turns))
    }

    /// A quantity of both grids, extrapolated; one where nothing is coupled.
    fn value(&self, of: impl Fn(&Settled) -> f64) -> f64 {
        let levels = self.settled.as_ref();
        levels.map_or(1.0, |[coarse, fine]| extrapolate(of(coarse), of(fine)))
    }

    /// Load over that of the frictionless contact.
    #[must_use]
    pub fn load(&self) -> f64 {
        self.value(|level| level.pressed.load / level.frictionless.load)
    }

    /// Approach over that of the frictionless contact.
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.value(|level| level.pressed.approach / level.frictionless.approach)
    }

    /// Contact area over that of the frictionless contact.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.value(|level| level.shape.area())
    }

    /// Largest pressure over that of the frictionless contact.
    #[must_use]
    pub fn peak(&self) -> f64 {
        self.value(|level| level.shape.peak())
    }

    /// The ends of the area along `x` at half its width, and its tips in `y`, in units of `c`.
    #[must_use]
    pub fn extents(&self) -> [[f64; 2]; 2] {
        let Some([_, fine]) = &self.settled else {
            let ellipse = self.theory.contact.ellipse();
            return [[-ellipse.a(), ellipse.a()], [-ellipse.b(), ellipse.b()]];
        };
        let [x, [low, high]] = fine.shape.extents();
        if self.mirror.x * self.mirror.y < 0.0 { [x, [-high, -low]] } else { [x, [low, high]] }
    }

    /// The elements of the finer grid, strip by strip from negative `y`, each from the leading edge.
    #[must_use]
    pub fn elements(&self) -> Vec<ElementField> {
        let Some([_, fine]) = &self.settled else {
            return self.prepared.exact.solve_contact(self.creepage).elements();
        };
        let strips = fine.grid.mesh.strips.len();
        let flips = self.mirror.x * self.mirror.y < 0.0;
        let place = |strip: usize| if flips { strips - 1 - strip } else { strip };
        fine.grid.mesh.all().map(|(strip, i)| self.element(fine, place(strip), i)).collect()
    }

    fn element(
        &self,
        Settled { grid, state, .. }: &Settled,
        strip: usize,
        i: usize,
    ) -> ElementField {
        let (pressure, mirror) = (&grid.pressure, self.mirror);
        let element = grid.mesh.elements(strip).start + i;
        let bound = pressure.bounds[element];
        let (traction, slip) = state.visible(grid, element);
        ElementField {
            point: FieldPoint {
                position: mirror.position(pressure.centroids[element]),
                traction: mirror.vector(traction.map(|t| bound * t)),
                slip: mirror.vector(slip.unwrap_or_default()),
                region: if slip.is_some() { Region::Slip } else { Region::Adhesion },
            },
            bound,
            share: pressure.shares[element],
            power: state.power(grid, element),
            corners: grid.mesh.strips[strip].corners(i).map(|corner| mirror.position(corner)),
        }
    }

    fn at(&self, level: &Settled, position: [f64; 2]) -> FieldPoint {
        let (mirror, mesh) = (self.mirror, &level.grid.mesh);
        let there = mirror.position(position);
        let Some([s, t]) = level.shape.place(there) else {
            return FieldPoint::outside(position);
        };
        let below = mesh.strips.partition_point(|strip| strip.borders()[1] <= there[1]);
        let around = mesh.around(below.min(mesh.strips.len() - 1), there[1], s);
        let point =
            between(&level.grid, &level.state, around, position, level.shape.pressure([s, t]));
        let (traction, slip) = (mirror.vector(point.traction), mirror.vector(point.slip));
        FieldPoint { traction, slip, ..point }
    }

    /// By how much coupling moved the force.
    #[must_use]
    pub fn force_moved(&self) -> Force {
        let one_way = self.prepared.exact.solve(self.creepage).force;
        let Force { fx, fy, mz } = self.solution.force;
        Force { fx: fx - one_way.fx, fy: fy - one_way.fy, mz: mz - one_way.mz }
    }
}

fn settle(
    theory: &Coupled,
    Prepared { exact, levels }: &Prepared,
    (creepage, mirror): (Creepage, Mirror),
    near: Option<&[Settled; 2]>,
) -> Option<[Settled; 2]> {
    let [coarse, fine] = levels.as_ref()?;
    let at = (mirror.creepage(creepage), mirror.x);
    let [hertz, hertz_fine] = &exact.grids;
    let (coupling, prescribed) = (theory.coupling, theory.prescribed);
    let pressed = near.map_or(&coarse.normal.frictionless, |near| &near[0].pressed).clone();
    let start = Start { pressed, coarser: None };
    let first = coarse.settle(hertz, coupling, prescribed, at, start);
    let pressed = match near {
        Some(near) => near[1].pressed.clone(),
        None => fine.normal.shaped(&first.shape, &first.pressed, &first.frictionless),
    };
    let start = Start { pressed, coarser: Some(&first.state) };
    let second = fine.settle(hertz_fine, coupling, prescribed, at, start);
    Some([first, second])
}

fn solution(force: Force, error: Force, levels: &[Settled; 2]) -> Solution {
    let converged = levels.iter().all(|level| level.converged);
    let sum = |of: fn(&Settled) -> usize| levels.iter().map(of).sum();
    Solution {
        force,
        error: Some(error),
        status: if converged { Status::Solved } else { Status::NotConverged },
        statistics: Statistics {
            iterations: sum(|level| level.sweeps),
            factorizations: sum(|level| level.factorizations),
        },
    }
}

impl Trial for CoupledSolved<'_> {
    fn again(&self, creepage: Creepage) -> Self {
        Self::new(self.theory, self.prepared, creepage, Some(self))
    }
}

impl Solved for CoupledSolved<'_> {
    fn creepage(&self) -> Creepage {
        self.creepage
    }

    fn solution(&self) -> Solution {
        self.solution
    }

    fn jacobian(&mut self) -> Option<Jacobian> {
        let Some([coarse, fine]) = &mut self.settled else {
            return self.prepared.exact.jacobian(self.creepage);
        };
        let extrapolation =
            Extrapolation::new(&self.theory.contact, self.mirror.creepage(self.creepage));
        let forces =
            [&*coarse, &*fine].map(|level| level.state.sum(&level.grid, self.mirror.x).force);
        let slopes =
            [coarse, fine].map(|level| level.equations.derivative(&level.grid, &level.state));
        let columns = extrapolation.derivative(forces, slopes).map(|slope| slope.components());
        let signs = self.mirror.signs();
        let entry = |i: usize, k: usize| signs[i] * signs[k] * columns[k][i];
        Some(std::array::from_fn(|i| std::array::from_fn(|k| entry(i, k))))
    }

    fn field(&self, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        match &self.settled {
            Some([_, fine]) => positions.iter().map(|at| self.at(fine, *at)).collect(),
            None => self.prepared.exact.field(self.creepage, positions),
        }
    }

    fn points(&self) -> Option<Vec<FieldPoint>> {
        Some(self.elements().iter().map(|element| element.point).collect())
    }

    /// The quarters of the finer grid's elements, with its traction.
    fn patches(&self) -> Option<Vec<Patch>> {
        let quarters = self.elements().into_iter().flat_map(|element| quarters(element.corners));
        let patch = |corners: [[f64; 2]; 4]| {
            let traction = self.field(&[mean(&corners)]).first().map_or([0.0; 2], |p| p.traction);
            Patch { corners, traction }
        };
        Some(quarters.map(patch).collect())
    }

    fn power(&self) -> f64 {
        self.power
    }

    fn dissipation(&self) -> Option<f64> {
        Some(self.dissipation)
    }

    fn relative_area(&self) -> f64 {
        self.area()
    }

    fn moved(&self, position: [f64; 2]) -> [f64; 2] {
        let Some([_, fine]) = &self.settled else { return position };
        self.mirror.position(fine.shape.moved(self.mirror.position(position)))
    }

    fn diagnostics(&self) -> Vec<Diagnostic> {
        let (error, moved) = (self.solution.error.unwrap_or_default(), self.force_moved());
        let [along, across] = self.extents().map(|[low, high]| f64::midpoint(low, high));
        let [coarse, fine] = self.turns().map(|turns| turns as f64);
        let [nx, ny] = self.grid().map(|n| n as f64);
        let all = [
            ("fx_error", "error bar of f_x", error.fx),
            ("fy_error", "error bar of f_y", error.fy),
            ("mz_error", "error bar of m_z", error.mz),
            ("elements", "elements", nx * ny),
            ("kappa_over_mu", "unlike bodies, kappa/mu", self.theory.contact.kappa_over_mu()),
            ("coupling_turns", "turns, both grids", coarse + fine),
            ("load_over_hertz", "load over Hertz", self.load()),
            ("approach_over_hertz", "approach over Hertz", self.approach()),
            ("area_over_hertz", "area over Hertz", self.area()),
            ("peak_over_hertz", "peak over Hertz", self.peak()),
            ("shift_x", "area moved along, in c", along),
            ("shift_y", "area moved across, in c", across),
            ("fx_moved", "f_x moved by coupling", moved.fx),
            ("fy_moved", "f_y moved by coupling", moved.fy),
            ("mz_moved", "m_z moved by coupling", moved.mz),
        ];
        all.map(|(key, label, value)| Diagnostic { key, label, value }).into()
    }
}
