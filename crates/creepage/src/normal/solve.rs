//! From a gap to its contact: overlap, a coarse lattice, and two finer ones that bound the error.

use crate::gap::Gap;
use crate::solid::SolidPair;

use super::contact::{Estimate, NormalContact, Patch, Resolution, Status};
use super::elements;
use super::error::NormalError;
use super::level::{Level, Task};
use super::load;
use super::outline;
use super::overlap::Overlap;

/// What is prescribed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Asked {
    Approach(f64),
    Load(f64),
}

pub(super) fn solve(
    gap: &Gap,
    pair: SolidPair,
    asked: Asked,
    resolution: Resolution,
) -> Result<NormalContact, NormalError> {
    const COARSER: f64 = 0.6;
    let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
    let (task, first) = match asked {
        Asked::Approach(approach) => {
            let task = Task { gap, modulus, approach };
            (task, elements::first(task, &Overlap::find(gap, approach)?)?)
        }
        Asked::Load(load) => load::first(gap, modulus, load)?,
    };
    let check = elements::refined(task, &first, COARSER * resolution.per_chord, true)?;
    let (task, check) = load::corrected(task, asked, check)?;
    let fine = elements::refined(task, &check, resolution.per_chord, true)?;
    let (task, fine) = load::corrected(task, asked, fine)?;
    if let Some(side) = fine.side_reached(gap) {
        return Err(elements::edge_error(task, &fine, side));
    }
    Ok(contact(gap, pair, asked, task, &Summary::new(&check), fine))
}

/// What two resolutions are compared by.
struct Summary {
    load: f64,
    peak: f64,
    area: f64,
    patches: Vec<Patch>,
}

impl Summary {
    fn new(level: &Level) -> Self {
        let patches: Vec<Patch> = outline::patches(level).into_iter().map(Patch::new).collect();
        let area = patches.iter().map(Patch::area).sum();
        Self { load: level.load(), peak: peak(level), area, patches }
    }
}

fn contact(
    gap: &Gap,
    pair: SolidPair,
    asked: Asked,
    task: Task<'_>,
    check: &Summary,
    fine: Level,
) -> NormalContact {
    let found = Summary::new(&fine);
    let load_error = error(found.load, check.load, 5e-4);
    let (approach_error, load_error, load) = match asked {
        Asked::Approach(_) => (0.0, load_error, found.load),
        Asked::Load(load) => (load_error / fine.stiffness, 0.0, load),
    };
    let mut patches = found.patches;
    for band in patches.iter_mut().flat_map(Patch::bands_mut) {
        band.scale(load / found.load);
    }
    let residual = fine.residual;
    let converged = residual <= Level::TOLERANCE;
    NormalContact {
        pair,
        approach: Estimate { value: task.approach, error: approach_error },
        load: Estimate { value: load, error: load_error },
        peak: Estimate { value: found.peak, error: error(found.peak, check.peak, 1e-3) },
        area: Estimate { value: found.area, error: error(found.area, check.area, 3e-3) },
        stiffness: fine.stiffness,
        status: if converged { Status::Converged } else { Status::NotConverged { residual } },
        gap_points: gap_points(gap, &patches),
        patches,
    }
}

/// The error bar of a number known at two resolutions, and at least a part of it: the levels of
/// a lattice scatter, so their difference may be small by chance.
fn error(fine: f64, coarse: f64, least: f64) -> f64 {
    (fine - coarse).abs().max(least * fine.abs())
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
