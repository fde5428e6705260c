//! The solution of one coupled contact, kept for fields, derivatives and further solves.

use super::level::{CoupledProblem, CoupledState, CoupledWarmStart};
use super::peak_pressure::{PressurePeak, pressure_peak};
use super::{Coupled, Prepared};
use crate::coulomb::dissipation::{self, Unresolved};
use crate::coulomb::extrapolation::{Extrapolation, extrapolate};
use crate::coulomb::field_interpolation::{ElementField, FieldInterpolation};
use crate::coulomb::inverse::Resolve;
use crate::coulomb::solution::{Mirror, power_of, quarters};
use crate::theory::field::mean;
use crate::theory::{
    Diagnostic, FieldPoint, Jacobian, Patch, Solution, Solved, Statistics, Status,
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
    /// On the coarser and the finer grid; `None` where the strips of the normal problem fail, or
    /// turns between friction and normal contact lead to no numbers.
    settled: Option<[CoupledState; 2]>,
    solution: Solution,
    power: f64,
    dissipation: f64,
    /// What the tractions of the finer grid's elements give of it.
    by_elements: f64,
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
        let (sums, mirrored) = ([0, 1].map(sum), mirror.creepage(creepage));
        let extrapolation = Extrapolation::new(&theory.contact, mirrored);
        let forces = sums.each_ref().map(|sum| sum.force);
        let force = mirror.force(extrapolation.force(forces));
        let error = extrapolation.error_bar(forces, levels[1].grid.mesh.len());
        let [coarse, fine] = sums;
        let power = power_of(force, creepage) + extrapolate(coarse.by_pressure, fine.by_pressure);
        // Rolling freely, power is a small difference of large parts: the elements' heat is the least.
        let slipping = extrapolate(coarse.dissipation, fine.dissipation);
        let dissipation =
            dissipation::dissipation(power, &fine, power_of(fine.force, mirrored)).max(slipping);
        if !are_numbers(levels, &[power, dissipation], force, error) {
            return Self::one_way(theory, prepared, creepage, mirror);
        }
        let (solution, by_elements) = (solution(force, error, levels), fine.dissipation);
        Self {
            theory,
            prepared,
            creepage,
            mirror,
            settled,
            solution,
            power,
            dissipation,
            by_elements,
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
        let (power, dissipation) = (solved.power(), solved.dissipation().unwrap_or_default());
        let (settled, by_elements) = (None, dissipation);
        Self {
            theory,
            prepared,
            creepage,
            mirror,
            settled,
            solution,
            power,
            dissipation,
            by_elements,
        }
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
    fn value(&self, of: impl Fn(&CoupledState) -> f64) -> f64 {
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
        let rise = self
            .pressure_peak()
            .map_or(0.0, |(pressure_peak, polynomials)| pressure_peak.peak - polynomials);
        self.value(|level| level.shape.peak()) + rise
    }

    /// Error bar of [`CoupledSolved::peak`]: half of what the strips' polynomials lack at the border of
    /// adhesion, and half the difference of the grids. One where nothing is coupled.
    #[must_use]
    pub fn peak_error(&self) -> f64 {
        /// Lower bound of the relative error, where both grids agree by chance.
        const MIN_PEAK_ERROR: f64 = 5e-4;
        let (Some([coarse, _]), Some((pressure_peak, polynomials))) =
            (&self.settled, self.pressure_peak())
        else {
            return 1.0;
        };
        let apart = (polynomials - coarse.shape.peak()).abs();
        MIN_PEAK_ERROR + 0.5 * (pressure_peak.lacking + apart)
    }

    /// The finer grid's pressure peak at the border of adhesion, and its peak by the strips' polynomials alone.
    fn pressure_peak(&self) -> Option<(PressurePeak, f64)> {
        let q = self.mirror.x * self.theory.coupling.q;
        self.settled.as_ref().map(|[_, fine]| (pressure_peak(fine, q), fine.shape.peak()))
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
        let unresolved =
            Unresolved::new(&fine.grid, &fine.state, self.dissipation, self.by_elements);
        let view = FieldInterpolation::new(&fine.grid, &fine.state);
        let element = |(strip, i): (usize, usize)| {
            let strip = place(strip);
            let power = unresolved.power(&fine.grid, &fine.state, strip, i);
            self.mirror.element(ElementField { power, ..view.element(strip, i) })
        };
        fine.grid.mesh.all().map(element).collect()
    }

    fn at(
        &self,
        level: &CoupledState,
        view: &FieldInterpolation,
        position: [f64; 2],
    ) -> FieldPoint {
        let (mirror, mesh) = (self.mirror, &level.grid.mesh);
        let there = mirror.position(position);
        let Some([s, t]) = level.shape.place(there) else {
            return FieldPoint::outside(position);
        };
        let below = mesh.strips.partition_point(|strip| strip.borders()[1] <= there[1]);
        let strip = below.min(mesh.strips.len() - 1);
        let point = view.at(strip, there, s, level.shape.pressure([s, t]));
        let (traction, slip) = (mirror.vector(point.traction), mirror.vector(point.slip));
        FieldPoint { position, traction, slip, ..point }
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
    near: Option<&[CoupledState; 2]>,
) -> Option<[CoupledState; 2]> {
    let [coarse, fine] = levels.as_ref()?;
    let case = |level: usize| CoupledProblem {
        hertz: &exact.grids[level],
        coupling: theory.coupling,
        prescribed: theory.prescribed,
        creepage: mirror.creepage(creepage),
        side: mirror.x,
    };
    let pressed = near.map_or(&coarse.normal.frictionless, |near| &near[0].pressed).clone();
    let start = CoupledWarmStart { pressed, coarser: None };
    let first = coarse.settle(case(0), start);
    let pressed = match near {
        Some(near) => near[1].pressed.clone(),
        None => first.shape.start(&fine.normal, &first.pressed, &first.frictionless),
    };
    let start = CoupledWarmStart { pressed, coarser: Some(&first.state) };
    let second = fine.settle(case(1), start);
    Some([first, second])
}

/// Whether a solution has numbers at all.
fn are_numbers(levels: &[CoupledState; 2], powers: &[f64], force: Force, error: Force) -> bool {
    let shapes = levels.iter().flat_map(|level| [level.shape.area(), level.pressed.approach]);
    let forces = [force, error].into_iter().flat_map(|force| force.components());
    powers.iter().copied().chain(shapes).chain(forces).all(f64::is_finite)
}

fn solution(force: Force, error: Force, levels: &[CoupledState; 2]) -> Solution {
    let converged = levels.iter().all(|level| level.converged);
    let sum = |of: fn(&CoupledState) -> usize| levels.iter().map(of).sum();
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

impl Resolve for CoupledSolved<'_> {
    fn resolve(&self, creepage: Creepage) -> Self {
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
            Some([_, fine]) => {
                let view = FieldInterpolation::new(&fine.grid, &fine.state);
                positions.iter().map(|at| self.at(fine, &view, *at)).collect()
            }
            None => self.prepared.exact.field(self.creepage, positions),
        }
    }

    fn points(&self) -> Option<Vec<FieldPoint>> {
        Some(self.elements().iter().map(|element| element.point).collect())
    }

    /// The quarters of the finer grid's elements, with its traction.
    fn patches(&self) -> Option<Vec<Patch>> {
        let elements = self.elements().into_iter();
        let quarters: Vec<_> = elements.flat_map(|element| quarters(element.corners)).collect();
        let middles: Vec<_> = quarters.iter().map(|corners| mean(corners)).collect();
        let patch = |(corners, point): ([[f64; 2]; 4], FieldPoint)| Patch {
            corners,
            traction: point.traction,
        };
        Some(quarters.into_iter().zip(self.field(&middles)).map(patch).collect())
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
            ("peak_error", "error bar of the peak", self.peak_error()),
            ("shift_x", "area moved along, in c", along),
            ("shift_y", "area moved across, in c", across),
            ("fx_moved", "f_x moved by coupling", moved.fx),
            ("fy_moved", "f_y moved by coupling", moved.fy),
            ("mz_moved", "m_z moved by coupling", moved.mz),
        ];
        all.map(|(key, label, value)| Diagnostic { key, label, value }).into()
    }
}
