//! Solution of the normal problem, from strips or elements to a contact: extrapolated values with error bars.

use std::sync::Arc;

use crate::gap::Gap;
use crate::solid::SolidPair;

use super::contact::{ElementRule, Estimate, Method, NormalContact, Status, StripRule};
use super::lattice::Lattice;
use super::level::{Accuracy, ElementGrid, NormalProblem};
use super::outline;
use super::patch::Patch;
use super::strip_system::Factors;

/// Normal constraint: load or approach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Prescribed {
    Approach(f64),
    Load(f64),
}

/// Patches solved by strips or by elements.
#[derive(Debug, Clone)]
pub(super) struct SolvedPatches {
    pub(super) patches: Vec<Patch>,
    pub(super) approach: f64,
    pub(super) load: f64,
    /// The greatest pressure by the strips or elements as they are, and the summit between them.
    pub(super) peak: f64,
    pub(super) summit: f64,
    /// What a summit or waves as narrow as strips or elements may add to the greatest pressure.
    pub(super) unseen: f64,
    pub(super) stiffness: f64,
    /// [`Band::stairs`](super::patch_strip::Band::stairs) of the worst band, in the axes in which it was pressed; 0 for elements.
    pub(super) stairs: f64,
    /// The matrix of strips.
    pub(super) factors: Option<Arc<Factors>>,
}

impl SolvedPatches {
    pub(super) fn by_elements(task: NormalProblem<'_>, level: &ElementGrid) -> Self {
        let [peak, fall] = summit(level);
        Self {
            patches: areas(level),
            approach: task.approach,
            load: level.load(),
            peak,
            summit: peak,
            unseen: 0.5 * fall,
            stiffness: level.stiffness,
            stairs: 0.0,
            factors: None,
        }
    }

    pub(super) fn area(&self) -> f64 {
        self.patches.iter().map(Patch::area).sum()
    }

    /// Whether two solutions agree as well as coarse ones can; a summit of pressure as narrow as
    /// an element is off by a tenth and more.
    pub(super) fn agrees_with(&self, other: &Self) -> bool {
        let near = |one: f64, other: f64, part: f64| (one / other - 1.0).abs() < part;
        let load = self.load + self.stiffness * (other.approach - self.approach);
        near(load, other.load, 0.02)
            && near(self.peak, other.peak, 0.25)
            && near(self.area(), other.area(), 0.15)
    }
}

/// The areas that elements found.
pub(super) fn areas(level: &ElementGrid) -> Vec<Patch> {
    outline::patches(level).into_iter().map(Patch::new).collect()
}

/// Coarse and fine solution, for extrapolation and error bars.
pub(super) struct SolvedPair {
    pub(super) coarse: SolvedPatches,
    pub(super) fine: SolvedPatches,
    pub(super) method: Method,
    /// The finer one's number of strips across or elements along, and the same over the coarser one's.
    pub(super) count: usize,
    pub(super) finer: f64,
    pub(super) residual: f64,
    /// By what part elements may carry too much in either solution: zero for strips.
    pub(super) excess: f64,
    /// The lattice of the finer elements.
    pub(super) lattice: Option<Lattice>,
}

impl SolvedPair {
    pub(super) fn of_strips(
        coarse: SolvedPatches,
        (fine, count): (SolvedPatches, usize),
        finer: f64,
    ) -> Self {
        let (method, lattice) = (Method::Strips, None);
        Self { coarse, fine, method, count, finer, residual: 0.0, excess: 0.0, lattice }
    }

    /// What the finer one lacks, over what it differs by, of what falls with the square of their number.
    fn lacking(&self) -> f64 {
        1.0 / (self.finer * self.finer - 1.0)
    }
}

pub(super) fn contact(
    gap: &Gap,
    pair: SolidPair,
    asked: Prescribed,
    found: SolvedPair,
) -> NormalContact {
    let lacking = found.lacking();
    let bars = Bars::new(&found);
    let SolvedPair { coarse, mut fine, method, residual, count, lattice, .. } = found;
    let area = fine.area();
    // Where strips scatter, as slender ones do that lie hardly askew, the summit that they are cut for does too.
    let scatter = if fine.stairs > 0.0 { (fine.summit - fine.peak).abs() } else { 0.0 };
    let peak_error = bars.peak.of(fine.summit, coarse.summit).max(fine.unseen).max(scatter);
    let area_error = bars.area.of(area, coarse.area());
    // What the coarser would carry at the finer one's approach.
    let carried = coarse.load + fine.stiffness * (fine.approach - coarse.approach);
    let load_error = bars.load.of(fine.load, carried);
    let by_strips = method == Method::Strips;
    let at_limit = fine.load + if by_strips { lacking * (fine.load - carried) } else { 0.0 };
    let rule = StripRule { count, load: at_limit / fine.load, origin: [at_limit, area] };
    let rule = by_strips.then_some(rule);
    let (approach, load) = match asked {
        Prescribed::Load(load) => {
            let value = fine.approach + (fine.load - at_limit) / fine.stiffness;
            (
                Estimate { value, error: load_error / fine.stiffness },
                Estimate { value: load, error: 0.0 },
            )
        }
        Prescribed::Approach(value) => {
            (Estimate { value, error: 0.0 }, Estimate { value: at_limit, error: load_error })
        }
    };
    scale(&mut fine.patches, load.value);
    let converged = residual <= Accuracy::ANSWER.residual;
    NormalContact {
        pair,
        approach,
        load,
        peak: Estimate { value: fine.summit, error: peak_error },
        area: Estimate { value: area, error: area_error },
        stiffness: fine.stiffness,
        status: if converged { Status::Converged } else { Status::NotConverged { residual } },
        method,
        gap_points: gap_points(gap, &fine.patches),
        patches: fine.patches,
        rule,
        elements: lattice.map(|lattice| ElementRule { lattice, origin: [at_limit, area] }),
        factors: fine.factors,
    }
}

/// Scales the pressures of some areas to their load.
pub(super) fn scale(patches: &mut [Patch], load: f64) {
    let carried: f64 = patches.iter().map(Patch::load).sum();
    for band in patches.iter_mut().flat_map(Patch::bands_mut) {
        band.scale(load / carried);
    }
}

/// How the error bar of a number follows from its value at two resolutions: a part of their
/// difference, and a part of the number.
#[derive(Clone, Copy)]
struct Bar {
    of_difference: f64,
    least: f64,
    stairs: f64,
}

impl Bar {
    fn of(self, fine: f64, coarse: f64) -> f64 {
        let by_difference = self.of_difference * (fine - coarse).abs();
        by_difference.max(self.least * fine.abs()) + self.stairs * fine.abs()
    }
}

/// Factors of the error bars, from random gaps against three times as many strips (`tests/normal/bars.rs`).
struct Bars {
    load: Bar,
    peak: Bar,
    area: Bar,
}

impl Bars {
    fn new(found: &SolvedPair) -> Self {
        // Elements scatter, and may agree by chance.
        let (of_difference, stairs) = match found.method {
            Method::Strips => (found.lacking(), found.fine.stairs.powi(2)),
            Method::Elements => (1.0, 0.0),
        };
        let is_strips = found.method == Method::Strips;
        let bar = |safety: f64, least: f64, by_stairs: f64| Bar {
            of_difference: of_difference * if is_strips { safety } else { 1.0 },
            least,
            stairs: by_stairs * stairs,
        };
        let least = found.excess.max(3e-4);
        Self { load: bar(1.5, least, 0.03), peak: bar(3.0, 4e-3, 0.8), area: bar(3.0, 3e-3, 0.8) }
    }
}

pub(super) fn gap_points(gap: &Gap, patches: &[Patch]) -> [Option<usize>; 2] {
    let counts: Vec<[Option<usize>; 2]> =
        patches.iter().map(|patch| gap.points_within(&patch.extent())).collect();
    [0, 1].map(|axis| counts.iter().filter_map(|count| count[axis]).min())
}

/// The top of the parabolas along x and y through the greatest pressure and its neighbours, and
/// how much the lowest of these lacks.
fn summit(level: &ElementGrid) -> [f64; 2] {
    let [columns, rows] = level.lattice.count;
    let at = |index: usize| level.pressures.get(index).copied().unwrap_or(0.0);
    let highest = |&one: &usize, &other: &usize| at(one).total_cmp(&at(other));
    let top = (0..level.pressures.len()).max_by(highest).unwrap_or(0);
    let (column, row, middle) = (top % columns, top / columns, at(top));
    let along = |step: usize, inside: bool| {
        let (true, Some(below)) = (inside, top.checked_sub(step)) else { return [0.0, middle] };
        let [low, high] = [below, top + step].map(at);
        let (slope, bend) = (0.5 * (high - low), low + high - 2.0 * middle);
        let is_smooth = low > 0.0 && high > 0.0 && bend < 0.0;
        let rise = if is_smooth { -0.5 * slope * slope / bend } else { 0.0 };
        [rise, middle - low.min(high)]
    };
    let [x, y] =
        [along(1, column > 0 && column + 1 < columns), along(columns, row > 0 && row + 1 < rows)];
    [middle + x[0] + y[0], x[1].max(y[1])]
}
