//! The strip method: contact by strips along rolling whose pressure vanishes as a root at ends that are unknowns
//! themselves. Far fewer unknowns than elements and no staircase; but it needs a start close by,
//! which the elements give, and says so when Newton's method does not arrive.

mod overlap_check;
mod patch_update;
mod strip_layout;
mod waves;

use std::sync::Arc;

use super::level::NormalProblem;
use super::patch::Patch;
use super::patch_strip::Band;
use super::solution::SolvedPatches;
use super::strip_system::{self, CENTRED, Depth, Factors, Strip, StripProblem, StripSolution};
use super::turn::Turn;
use strip_layout::{Units, centre, laid, patches};

pub(super) use strip_layout::most;
pub(super) use waves::terms;

/// Options of the strip method.
#[derive(Debug, Clone, Copy)]
pub(super) struct StripOptions {
    /// The load (N), where that is prescribed and not the approach.
    pub(super) load: Option<f64>,
    /// Strips across the widest patch.
    pub(super) count: usize,
    /// Polynomials in a strip's pressure; with one alone, strips stay where they are laid.
    pub(super) terms: usize,
    /// Largest residual over the depth.
    pub(super) residual_tolerance: f64,
    /// Relative tolerance of the stiffness.
    pub(super) stiffness_tolerance: f64,
    /// Whether the bodies must nowhere overlap beyond the strips.
    pub(super) complete: bool,
    /// Whether the peak pressure is wanted closer than the strips alone tell.
    pub(super) summit: bool,
    /// How often strips may be laid that do not touch all along.
    pub(super) attempts: usize,
    /// Parts of its strip's width that a tip may lie away from where it was laid.
    pub(super) settled: f64,
}

impl StripOptions {
    /// Attempts that are worth their cost.
    pub(super) const ATTEMPTS: usize = 6;
    /// The same from a contact close by: where that is not close enough, elements are a better start.
    pub(super) const CLOSE_ATTEMPTS: usize = 2;
}

/// Solves from patches close by.
///
/// Active-set iteration over the patches. Where a tip lies too far out, its strip shrinks to nothing: the patch is
/// shrunk, and the strips are laid again. Where a tip lies too far inwards, its strip bears the pressure of a punch's
/// edge, or the bodies overlap beyond it: the patch is grown. Strips are laid again too where their ends put a tip
/// elsewhere than it was laid. Patches that come to touch are merged, and split at a waist that vanishes.
/// Newton's method begins with the matrix of like strips close by, where one is known.
///
/// An area that lies askew is pressed in axes along it.
pub(super) fn solve(
    task: NormalProblem<'_>,
    start: &[Patch],
    known: Option<&Arc<Factors>>,
    options: StripOptions,
) -> Option<SolvedPatches> {
    /// How often the axes are turned further along the area that was found, where that tells them.
    const ROUNDS: usize = 3;
    let rounds = if Turn::is_of_overlap(task) { 1 } else { ROUNDS };
    let mut turned: Option<SolvedPatches> = None;
    for _ in 0..rounds {
        let (own, known) = match &turned {
            Some(found) => (&found.patches[..], found.factors.as_ref()),
            None => (start, known),
        };
        let Some(turn) = Turn::along(task, own) else { break };
        let gap = turn.gap(task.gap, own);
        let inner = NormalProblem { gap: &gap, ..task };
        let found = solve_along_x(inner, &turn.inwards(own)?, known, options)?;
        let is_along = found.stairs < Turn::MIN_STAIRS;
        turned = Some(SolvedPatches { patches: turn.outwards(&found.patches)?, ..found });
        if is_along {
            break;
        }
    }
    turned.or_else(|| solve_along_x(task, start, known, options))
}

/// The same by strips along x, whichever way the area lies.
fn solve_along_x(
    task: NormalProblem<'_>,
    start: &[Patch],
    known: Option<&Arc<Factors>>,
    options: StripOptions,
) -> Option<SolvedPatches> {
    let StripOptions {
        count, terms, residual_tolerance, stiffness_tolerance, mut attempts, ..
    } = options;
    let units = Units::of(task, start)?;
    let gap = |x: f64, y: f64| {
        let place = [x, y].map(|at| at * units.length);
        let h = task.gap.at(units.origin[0] + place[0], units.origin[1] + place[1]);
        (task.approach - h) / units.depth
    };
    let load = options.load.map(|load| load / units.force());
    let problem =
        StripProblem { depth: &gap, load, residual_tolerance, stiffness_tolerance, known };
    let (mut start, mut settled, mut is_joined) = (start.to_vec(), 0, false);
    while attempts > 0 {
        let mut laid = laid(&start, count, terms, units)?;
        if terms == CENTRED {
            centre(&mut laid, task.gap, units);
        }
        match strip_system::solve(laid.clone(), terms, problem) {
            Ok(touching) if touching.strips.iter().all(Strip::is_compressive) => {
                let strips = &touching.strips;
                let patches = patches(&start, strips, units);
                if settled < SETTLED && moved([&start, &patches], &laid, options.settled, units) {
                    settled += 1;
                    start = patches;
                    continue;
                }
                let falls = fall_to_tips(&patches, strips);
                let mut beyond = Vec::new();
                if options.complete || !falls {
                    beyond = overlap_check::overlapped(task, &touching, units, terms, &gap)?;
                }
                if !falls || !beyond.is_empty() {
                    attempts -= 1;
                    start = patch_update::grow(&patches, strips, &beyond, units)?;
                    continue;
                }
                // Once, for a waist without pressure parts them again.
                if !is_joined && let Some(merged) = patch_update::merge(&patches) {
                    is_joined = true;
                    start = merged;
                    continue;
                }
                return Some(found(task, patches, &touching, options, &gap, units));
            }
            Ok(StripSolution { strips, .. }) => {
                attempts -= 1;
                start = patch_update::without_tensile(&start, &strips, units)?;
            }
            Err(stopped) => {
                attempts -= 1;
                start = patch_update::shrink(&start, &laid, &stopped, units)?;
            }
        }
    }
    None
}

/// What strips that are all the contact there is found.
fn found(
    task: NormalProblem<'_>,
    patches: Vec<Patch>,
    touching: &StripSolution,
    StripOptions { terms, summit, .. }: StripOptions,
    depth: Depth<'_>,
    units: Units,
) -> SolvedPatches {
    let strips = &touching.strips;
    let peak = strip_system::peak(strips);
    let summit = summit.then(|| strip_system::height(touching, terms, depth)).flatten();
    SolvedPatches {
        stairs: patches.iter().flat_map(Patch::bands).map(Band::stairs).fold(0.0, f64::max),
        patches,
        approach: task.approach + units.depth * touching.deeper,
        load: units.force() * strips.iter().map(Strip::load).sum::<f64>(),
        peak: units.pressure * peak,
        summit: units.pressure * summit.unwrap_or(peak),
        unseen: units.pressure * peak * waves::missed_across(strips, depth),
        stiffness: units.force() / units.depth * touching.stiffness,
        factors: Some(touching.factors.clone()),
    }
}

/// Most re-layouts of the strips because a tip lies elsewhere.
const SETTLED: usize = 2;

/// Whether a tip that was found lies away from where it was laid by a part of its strip's width.
fn moved([start, found]: [&[Patch]; 2], laid: &[Strip], part: f64, units: Units) -> bool {
    let bands = |patches: &[Patch]| -> Vec<[f64; 2]> {
        patches.iter().flat_map(Patch::bands).map(Band::y).collect()
    };
    bands(start).into_iter().zip(bands(found)).enumerate().any(|(index, (start, found))| {
        let mut own = laid.iter().filter(|strip| strip.band == index);
        let outer = [own.next(), own.next_back()];
        (0..2).any(|side| {
            outer[side].is_some_and(|strip| {
                (found[side] - start[side]).abs() > part * 2.0 * strip.width * units.length
            })
        })
    })
}

/// Whether pressures fall towards tips: where one was laid too far inwards, as between two crests of a
/// wave, the outermost strip bears what the edge of a punch does.
fn fall_to_tips(start: &[Patch], strips: &[Strip]) -> bool {
    start.iter().flat_map(Patch::bands).enumerate().all(|(index, band)| {
        let own: Vec<&Strip> = strips.iter().filter(|strip| strip.band == index).collect();
        patch_update::bears_at_tips(band, &own) == [false; 2]
    })
}
