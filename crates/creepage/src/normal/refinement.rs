//! The strip method at two resolutions, whose difference gives the error bar.

use super::contact::{NormalWarmStart, Resolution};
use super::level::NormalProblem;
use super::patch::Patch;
use super::solution::{Prescribed, SolvedPair, SolvedPatches};
use super::strips::{self, StripOptions};

/// Start of the strips: where their areas come from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Start {
    /// A first look, which is to be improved if strips do not settle at once.
    Rough,
    /// Elements or a guess.
    Elements,
    /// A contact so close by that the finer strips may begin there.
    Close,
}

/// Convergence tolerance of the tips, in widths of a strip, on the coarse and the fine pass: the coarse tips decide
/// where the fine strips are laid, which so hardly depend on the start.
const SETTLED: [f64; 2] = [0.05, 0.4];
/// Largest residual over the depth, coarse and fine.
pub(super) const RESIDUAL_TOLERANCES: [f64; 2] = [1e-5, 1e-6];
/// Relative tolerance of the stiffness `dN/d(approach)`: final, and during a search.
pub(super) const STIFFNESS_TOLERANCES: [f64; 2] = [2e-3, 0.05];
/// Strips of the finer solution for each of the coarser.
const HALVES: f64 = 2.0;
/// How much the peak pressure may change with half and with 8/5 of the strips. Where its error falls with the
/// square of their number the second would be 0.004; more strips that served are kept down to half of that.
const UNEVEN: [f64; 2] = [0.02, 0.002];

/// From areas that are rough ones, or so close that the finer strips may begin there.
///
/// `None` when waves along rolling are too short, a strip vanishes, the equations stay unsolved, or the
/// bodies overlap elsewhere: strips that are pressed everywhere and nowhere overlapped beyond solve the
/// problem, whatever they began with.
pub(super) fn by_strips(
    task: NormalProblem<'_>,
    asked: Prescribed,
    near: &NormalWarmStart<'_>,
    resolution: Resolution,
    kind: Start,
) -> Option<SolvedPair> {
    let refinement = RefinementPair::new(task, asked, near, resolution, kind)?;
    if !resolution.with_errors {
        let only = refinement.lay(&near.areas, task.approach, refinement.whole)?;
        return Some(refinement.pair_of_halves(only.clone(), only));
    }
    if let Some(pair) = refinement.downwards_from_more() {
        return Some(pair);
    }
    let (coarse, fine) = match kind {
        Start::Rough => refinement.upwards(),
        Start::Elements => refinement.upwards().or_else(|| refinement.downwards()),
        Start::Close => refinement.downwards().or_else(|| refinement.upwards()),
    }?;
    refinement.answer(coarse, fine)
}

/// Strips in three numbers, and where they begin.
struct RefinementPair<'a> {
    task: NormalProblem<'a>,
    near: &'a NormalWarmStart<'a>,
    /// Half the strips that are asked for.
    half: StripOptions,
    whole: StripOptions,
    /// Where those are not enough.
    more: StripOptions,
}

impl<'a> RefinementPair<'a> {
    /// `None` where waves along rolling are too short for strips.
    fn new(
        task: NormalProblem<'a>,
        asked: Prescribed,
        near: &'a NormalWarmStart<'a>,
        resolution: Resolution,
        kind: Start,
    ) -> Option<Self> {
        let whole = StripOptions {
            load: if let Prescribed::Load(load) = asked { Some(load) } else { None },
            count: resolution.count.min(strips::most(&near.areas)),
            terms: strips::terms(task.gap, &near.areas)?,
            residual_tolerance: RESIDUAL_TOLERANCES[1],
            stiffness_tolerance: STIFFNESS_TOLERANCES[usize::from(!resolution.with_errors)],
            complete: true,
            summit: resolution.with_errors,
            attempts: if kind == Start::Close {
                StripOptions::CLOSE_ATTEMPTS
            } else {
                StripOptions::ATTEMPTS
            },
            settled: SETTLED[1],
        };
        let half = StripOptions {
            count: whole.count.div_ceil(2),
            residual_tolerance: RESIDUAL_TOLERANCES[0],
            // Their stiffness is not used.
            stiffness_tolerance: f64::INFINITY,
            complete: false,
            // Better areas cost less than many attempts, and finer strips tell the error as well.
            attempts: match kind {
                Start::Rough => 1,
                Start::Close => StripOptions::CLOSE_ATTEMPTS,
                Start::Elements => StripOptions::ATTEMPTS,
            },
            settled: SETTLED[usize::from(kind != Start::Rough)],
            ..whole
        };
        let more = StripOptions { count: whole.count * 8 / 5, ..whole };
        Some(Self { task, near, half, whole, more })
    }

    fn lay(&self, start: &[Patch], approach: f64, options: StripOptions) -> Option<SolvedPatches> {
        strips::solve(NormalProblem { approach, ..self.task }, start, self.near.factors, options)
    }

    fn lay_into(&self, found: &SolvedPatches, options: StripOptions) -> Option<SolvedPatches> {
        self.lay(&found.patches, found.approach, options)
    }

    /// Half the strips, and all into their areas.
    fn upwards(&self) -> Option<(Option<SolvedPatches>, SolvedPatches)> {
        let coarse = self.lay(&self.near.areas, self.task.approach, self.half)?;
        let fine = self.lay_into(&coarse, self.whole)?;
        Some((Some(coarse), fine))
    }

    /// All strips at once, and half of them into their areas, if these settle.
    fn downwards(&self) -> Option<(Option<SolvedPatches>, SolvedPatches)> {
        let fine = self.lay(&self.near.areas, self.task.approach, self.whole)?;
        Some((self.lay_into(&fine, self.half), fine))
    }

    /// The same from more strips, where the contact close by took them.
    fn downwards_from_more(&self) -> Option<SolvedPair> {
        if self.near.taken != Some(self.more.count) {
            return None;
        }
        let finer = self.lay(&self.near.areas, self.task.approach, self.more)?;
        let fine = self.lay_into(&finer, self.whole)?;
        let is_even = !is_uneven(&fine, &finer, UNEVEN[1]);
        let coarse = if is_even { self.lay_into(&fine, self.half) } else { None };
        Some(match coarse {
            Some(coarse) if !is_uneven(&fine, &coarse, UNEVEN[0]) => {
                self.pair_of_halves(coarse, fine)
            }
            _ => self.pair_with_more(fine, finer),
        })
    }

    /// By half of the strips and all, if these are enough, else by more; `None` where more do not settle and
    /// waves across are too short for those.
    fn answer(&self, coarse: Option<SolvedPatches>, fine: SolvedPatches) -> Option<SolvedPair> {
        /// Of the peak pressure between strips.
        const UNSEEN: f64 = 0.02;
        match coarse {
            Some(coarse) if !is_uneven(&fine, &coarse, UNEVEN[0]) => {
                Some(self.pair_of_halves(coarse, fine))
            }
            coarse => match self.lay_into(&fine, self.more) {
                Some(finer) => Some(self.pair_with_more(fine, finer)),
                None if fine.unseen > UNSEEN * fine.peak => None,
                None => coarse.map(|coarse| self.pair_of_halves(coarse, fine)),
            },
        }
    }

    fn pair_of_halves(&self, coarse: SolvedPatches, fine: SolvedPatches) -> SolvedPair {
        SolvedPair::of_strips(coarse, (fine, self.whole.count), HALVES)
    }

    fn pair_with_more(&self, fine: SolvedPatches, finer: SolvedPatches) -> SolvedPair {
        let times = self.more.count as f64 / self.whole.count as f64;
        SolvedPair::of_strips(fine, (finer, self.more.count), times)
    }
}

/// Whether more strips are needed than found a contact: the peak pressure changes with their number or where they
/// are cut at the summit, waves across put a part of it between them, or the area is so skew that its edge is a
/// stair.
fn is_uneven(found: &SolvedPatches, by_others: &SolvedPatches, most: f64) -> bool {
    let change = |other: f64| (found.peak / other - 1.0).abs();
    change(by_others.peak) > most
        || change(found.summit) > 0.005
        || found.unseen > 0.005 * found.peak
        || found.stairs > 0.1
}
