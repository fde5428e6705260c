//! From a gap to its contact: the overlap, elements on two lattices, and strips laid into what
//! these find. Each way checks the other; where the strips do not settle, finer elements speak.

use crate::gap::Gap;
use crate::solid::SolidPair;

use super::contact::{Estimate, Method, NormalContact, Patch, Resolution, Status};
use super::elements;
use super::error::NormalError;
use super::level::{Level, Task};
use super::load;
use super::outline;
use super::overlap::Overlap;
use super::strips;

/// What is prescribed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Asked {
    Approach(f64),
    Load(f64),
}

/// A solution of either kind.
#[derive(Debug, Clone)]
pub(super) struct Found {
    pub(super) patches: Vec<Patch>,
    pub(super) load: f64,
    pub(super) peak: f64,
    pub(super) stiffness: f64,
}

impl Found {
    fn by_elements(level: &Level) -> Self {
        let patches = outline::patches(level).into_iter().map(Patch::new).collect();
        Self { patches, load: level.load(), peak: peak(level), stiffness: level.stiffness }
    }

    fn area(&self) -> f64 {
        self.patches.iter().map(Patch::area).sum()
    }

    /// Whether two solutions agree as well as coarse ones can; a summit of pressure as narrow as
    /// an element is off by a tenth and more.
    fn agrees_with(&self, other: &Self) -> bool {
        let near = |one: f64, other: f64, part: f64| (one / other - 1.0).abs() < part;
        near(self.load, other.load, 0.02)
            && near(self.peak, other.peak, 0.25)
            && near(self.area(), other.area(), 0.08)
    }
}

/// A solution, a coarser one, and what they belong to.
struct Pair<'a> {
    task: Task<'a>,
    coarse: Found,
    fine: Found,
    method: Method,
    residual: f64,
}

pub(super) fn solve(
    gap: &Gap,
    pair: SolidPair,
    asked: Asked,
    resolution: Resolution,
) -> Result<NormalContact, NormalError> {
    const COARSE: f64 = 10.0;
    let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
    let (task, first) = match asked {
        Asked::Approach(approach) => {
            let task = Task { gap, modulus, approach };
            (task, elements::first(task, &Overlap::find(gap, approach)?)?)
        }
        Asked::Load(load) => load::first(gap, modulus, load)?,
    };
    let coarse = elements::refined(task, &first, COARSE, true)?;
    let (task, coarse) = load::corrected(task, asked, coarse)?;
    if let Some(side) = coarse.side_reached(gap) {
        return Err(elements::edge_error(task, &coarse, side));
    }
    let found = match by_strips(task, asked, &Found::by_elements(&coarse), resolution) {
        Some(found) => found,
        None => by_elements(task, asked, &coarse, resolution)?,
    };
    Ok(contact(pair, asked, found))
}

fn by_elements<'a>(
    task: Task<'a>,
    asked: Asked,
    coarse: &Level,
    resolution: Resolution,
) -> Result<Pair<'a>, NormalError> {
    const COARSER: f64 = 0.6;
    let count = resolution.count as f64;
    let coarse = elements::refined(task, coarse, COARSER * count, true)?;
    let (task, coarse) = load::corrected(task, asked, coarse)?;
    let fine = elements::refined(task, &coarse, count, true)?;
    let (task, fine) = load::corrected(task, asked, fine)?;
    if let Some(side) = fine.side_reached(task.gap) {
        return Err(elements::edge_error(task, &fine, side));
    }
    Ok(Pair {
        task,
        coarse: Found::by_elements(&coarse),
        fine: Found::by_elements(&fine),
        method: Method::Elements,
        residual: fine.residual,
    })
}

/// `None` when a strip vanishes, the equations stay unsolved, or elements disagree.
fn by_strips<'a>(
    mut task: Task<'a>,
    asked: Asked,
    elements: &Found,
    resolution: Resolution,
) -> Option<Pair<'a>> {
    const CORRECTIONS: usize = 4;
    /// A peak pressure that still changes by more has a summit as narrow as the strips.
    const UNEVEN: f64 = 0.02;
    const ENOUGH: f64 = 1e-6;
    let terms = if task.gap.is_parabola_along() { 2 } else { 4 };
    let mut count = resolution.count;
    let mut coarse = strips::solve(task, &elements.patches, count.div_ceil(2), terms)?;
    let mut fine = strips::solve(task, &coarse.patches, count, terms)?;
    if (fine.peak / coarse.peak - 1.0).abs() > UNEVEN {
        let more = count * 8 / 5;
        if let Some(finer) = strips::solve(task, &fine.patches, more, terms) {
            (coarse, fine, count) = (fine, finer, more);
        }
    }
    if !fine.agrees_with(elements) {
        return None;
    }
    let limit = limit(fine.load, coarse.load) - fine.load;
    if let Asked::Load(load) = asked {
        for _ in 0..CORRECTIONS {
            let lacking = load - fine.load - limit;
            if lacking.abs() < ENOUGH * load {
                break;
            }
            task.approach += lacking / fine.stiffness;
            fine = strips::solve(task, &fine.patches, count, terms)?;
        }
    }
    Some(Pair { task, coarse, fine, method: Method::Strips, residual: 0.0 })
}

/// The limit of a quantity whose error falls with the square of the number of strips.
fn limit(fine: f64, coarse: f64) -> f64 {
    fine + (fine - coarse) / 3.0
}

fn contact(pair: SolidPair, asked: Asked, found: Pair<'_>) -> NormalContact {
    let Pair { task, coarse, mut fine, method, residual } = found;
    let error = |fine: f64, coarse: f64, least: f64| error(method, fine, coarse, least);
    let area = fine.area();
    let peak_error = error(fine.peak, coarse.peak, 1e-3);
    let area_error = error(area, coarse.area(), 3e-3);
    let load_error = error(fine.load, coarse.load, 3e-4);
    let (approach_error, load_error, load) = match (asked, method) {
        (Asked::Load(load), _) => (load_error / fine.stiffness, 0.0, load),
        (_, Method::Strips) => (0.0, load_error, limit(fine.load, coarse.load)),
        (_, Method::Elements) => (0.0, load_error, fine.load),
    };
    let carried: f64 = fine.patches.iter().map(Patch::load).sum();
    for band in fine.patches.iter_mut().flat_map(Patch::bands_mut) {
        band.scale(load / carried);
    }
    let converged = residual <= Level::TOLERANCE;
    NormalContact {
        pair,
        approach: Estimate { value: task.approach, error: approach_error },
        load: Estimate { value: load, error: load_error },
        peak: Estimate { value: fine.peak, error: peak_error },
        area: Estimate { value: area, error: area_error },
        stiffness: fine.stiffness,
        status: if converged { Status::Converged } else { Status::NotConverged { residual } },
        method,
        gap_points: gap_points(task.gap, &fine.patches),
        patches: fine.patches,
    }
}

/// The error bar of a number known at two resolutions, and at least a part of it: strips differ
/// by three times what the finer lack, elements scatter and may agree by chance.
fn error(method: Method, fine: f64, coarse: f64, least: f64) -> f64 {
    let difference = match method {
        Method::Strips => 0.5 * (fine - coarse).abs(),
        Method::Elements => (fine - coarse).abs(),
    };
    difference.max(least * fine.abs())
}

fn gap_points(gap: &Gap, patches: &[Patch]) -> [Option<usize>; 2] {
    let counts: Vec<[Option<usize>; 2]> =
        patches.iter().map(|patch| gap.points_within(&patch.extent())).collect();
    [0, 1].map(|axis| counts.iter().filter_map(|count| count[axis]).min())
}

/// The top of the parabolas along x and y through the greatest pressure and its neighbours.
fn peak(level: &Level) -> f64 {
    let [columns, rows] = level.lattice.count;
    let top = (0..level.pressures.len())
        .max_by(|&one, &other| level.pressures[one].total_cmp(&level.pressures[other]))
        .unwrap_or(0);
    let rise = |step: usize, inside: bool| {
        let (true, Some(below)) = (inside, top.checked_sub(step)) else { return 0.0 };
        let [low, middle, high] =
            [below, top, top + step].map(|at| level.pressures.get(at).copied().unwrap_or(0.0));
        let (slope, bend) = (0.5 * (high - low), low + high - 2.0 * middle);
        if low > 0.0 && high > 0.0 && bend < 0.0 { -0.5 * slope * slope / bend } else { 0.0 }
    };
    let (column, row) = (top % columns, top / columns);
    level.pressures.get(top).copied().unwrap_or(0.0)
        + rise(1, column > 0 && column + 1 < columns)
        + rise(columns, row > 0 && row + 1 < rows)
}
