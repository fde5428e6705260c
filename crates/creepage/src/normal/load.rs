//! Root search for the approach that carries a given load.

use crate::gap::Gap;

use super::elements;
use super::error::NormalError;
use super::level::{Accuracy, ElementGrid, NormalProblem};
use super::overlap::Overlap;
use super::solution::Prescribed;

/// The approach of a load to about a percent, and the coarse solution there.
///
/// Load over depth rises as a power near 3/2; the power is learnt from the last two approaches,
/// inside a bracket.
pub(super) fn first(
    gap: &Gap,
    modulus: f64,
    load: f64,
) -> Result<(NormalProblem<'_>, ElementGrid), NormalError> {
    /// Evaluations in the search for the approach.
    const MAX_ROOT_STEPS: usize = 60;
    const LOAD_TOLERANCE: f64 = 0.02;
    let mut search = Search::start(gap, load / modulus)?;
    for _ in 0..MAX_ROOT_STEPS {
        let approach = search.least_gap + search.depth;
        let task = NormalProblem { gap, modulus, approach };
        let overlap = Overlap::find(gap, approach)?;
        let level = elements::first(task, &overlap)?;
        let ratio = level.load() / load;
        if (ratio - 1.0).abs() < LOAD_TOLERANCE {
            return Ok((task, level));
        }
        if ratio < 1.0
            && let Some(side) = level.side_reached(gap)
        {
            return Err(elements::edge_error(task, &level, side));
        }
        search.next(ratio.ln());
    }
    Err(NormalError::LoadNotFound { load, approach: search.least_gap + search.depth })
}

struct Search {
    least_gap: f64,
    depth: f64,
    /// Depths with too little and too much load, and the logarithm of what they carry.
    below: Option<(f64, f64)>,
    above: Option<(f64, f64)>,
    last: Option<(f64, f64)>,
}

impl Search {
    /// From the overlap alone: load is about `E* depth sqrt(area)`.
    fn start(gap: &Gap, compliance_force: f64) -> Result<Self, NormalError> {
        const LOOKS: usize = 6;
        const FACTOR: f64 = 0.5;
        let mut approach = gap.likely_height(compliance_force);
        let mut found = Overlap::find(gap, approach);
        for _ in 0..LOOKS {
            // Too far at first: a gap may be bounded only near its least value.
            if !matches!(found, Err(NormalError::Unbounded { .. })) {
                break;
            }
            let lowest = gap.least().unwrap_or_else(|| gap.at(0.0, 0.0));
            approach = lowest + 0.1 * (approach - lowest);
            found = Overlap::find(gap, approach);
        }
        let mut overlap = found?;
        let least_gap = approach - overlap.depth;
        let mut depth = overlap.depth;
        for _ in 0..LOOKS {
            let carried = FACTOR * depth * overlap.area.sqrt();
            let factor = (compliance_force / carried).powf(2.0 / 3.0);
            depth *= factor.clamp(1e-9, 10.0);
            match Overlap::find(gap, least_gap + depth) {
                Ok(next) => overlap = next,
                Err(NormalError::NoContact { .. }) => break,
                Err(other) => return Err(other),
            }
            if (0.7..1.4).contains(&factor) {
                break;
            }
        }
        Ok(Self { least_gap, depth, below: None, above: None, last: None })
    }

    /// The next depth, from the logarithm of carried over wanted load.
    fn next(&mut self, excess: f64) {
        let here = (self.depth.ln(), excess);
        let power = self.last.map_or(1.5, |(depth, last)| {
            let power = (excess - last) / (here.0 - depth);
            if power.is_finite() { power.clamp(0.8, 8.0) } else { 1.5 }
        });
        *(if excess < 0.0 { &mut self.below } else { &mut self.above }) = Some(here);
        self.last = Some(here);
        let mut next = here.0 - (excess / power).clamp(-3.0, 6.0);
        if let (Some((low, _)), Some((high, _))) = (self.below, self.above) {
            let margin = 0.05 * (high - low);
            if !(next > low + margin && next < high - margin) {
                next = f64::midpoint(low, high);
            }
        }
        self.depth = next.exp();
    }
}

/// Moves the approach until the level carries the load asked for; a level at a prescribed
/// approach stays as it is.
pub(super) fn corrected(
    mut task: NormalProblem<'_>,
    asked: Prescribed,
    mut level: ElementGrid,
    accuracy: Accuracy,
) -> Result<(NormalProblem<'_>, ElementGrid), NormalError> {
    /// Corrections of the approach on the finer grid.
    const MAX_CORRECTIONS: usize = 8;
    let tolerance = 10.0 * accuracy.residual;
    let Prescribed::Load(load) = asked else { return Ok((task, level)) };
    for _ in 0..MAX_CORRECTIONS {
        let carried = level.load();
        if (carried / load - 1.0).abs() < tolerance {
            break;
        }
        let change = (load - carried) / level.stiffness;
        task.approach += change;
        level = ElementGrid::solve(task, level.lattice, Some(&level), accuracy)?;
    }
    Ok((task, level))
}
