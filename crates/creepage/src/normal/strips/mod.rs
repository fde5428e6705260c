//! Contact by strips along rolling whose pressure vanishes as a root at ends that are unknowns
//! themselves. Far fewer unknowns than elements and no staircase; but it needs a start close by,
//! which the elements give, and says so when Newton's method does not arrive.

mod anew;
mod kernel;
mod newton;
mod outside;
mod rules;
mod side;
mod sources;
mod strip;
mod summit;
mod system;
mod waves;

use std::sync::Arc;

use super::band::Band;
use super::contact::Patch;
use super::found::Found;
use super::lattice::whole;
use super::level::Task;
use crate::gap::{Gap, Rectangle};
pub(crate) use kernel::profile;
use newton::Depth;
pub(crate) use newton::{Factors, Question, Touching, solve as touching};
pub(crate) use rules::MOST;
pub(crate) use strip::Strip;
use strip::Units;
use system::CENTRED;
pub(super) use waves::terms;

/// What is asked of strips.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wanted {
    /// The load (N), where that is prescribed and not the approach.
    pub(super) load: Option<f64>,
    /// Strips across the widest patch.
    pub(super) count: usize,
    /// Polynomials in a strip's pressure; with one alone, strips stay where they are laid.
    pub(super) terms: usize,
    /// Largest residual over the depth.
    pub(super) enough: f64,
    /// To which part the stiffness is wanted.
    pub(super) nearly: f64,
    /// Whether the bodies must nowhere overlap beyond the strips.
    pub(super) complete: bool,
    /// Whether the peak pressure is wanted closer than the strips alone tell.
    pub(super) summit: bool,
    /// How often strips may be laid that do not touch all along.
    pub(super) attempts: usize,
    /// Parts of its strip's width that a tip may lie away from where it was laid.
    pub(super) settled: f64,
}

impl Wanted {
    /// Attempts that are worth their cost.
    pub(super) const ATTEMPTS: usize = 6;
}

/// Solves from patches close by.
///
/// A tip laid too far out leaves its strip nothing to touch: the strip shrinks to nothing, and
/// the strips are laid anew with the tip drawn in. One laid too far inwards bears what the edge of a punch
/// does, or the bodies overlap beyond it: it is pushed out. Where the ends found put a tip elsewhere than
/// it was laid, they are laid anew too. Areas that come to touch are joined, and parted at a waist that
/// vanishes.
/// A matrix that is known of like strips close by is where Newton's method begins.
pub(super) fn solve(
    task: Task<'_>,
    start: &[Patch],
    known: Option<&Arc<Factors>>,
    wanted: Wanted,
) -> Option<Found> {
    let Wanted { count, terms, enough, nearly, mut attempts, .. } = wanted;
    let units = units(task, start)?;
    let gap = |x: f64, y: f64| {
        let place = [x, y].map(|at| at * units.length);
        let h = task.gap.at(units.origin[0] + place[0], units.origin[1] + place[1]);
        (task.approach - h) / units.depth
    };
    let load = wanted.load.map(|load| load / units.force());
    let question = Question { depth: &gap, load, enough, nearly, known };
    let (mut start, mut settled, mut is_joined) = (start.to_vec(), 0, false);
    while attempts > 0 {
        let mut laid = laid(&start, count, terms, units)?;
        if terms == CENTRED {
            centre(&mut laid, task.gap, units);
        }
        match touching(laid.clone(), terms, question) {
            Ok(touching) if touching.strips.iter().all(is_pressed) => {
                let strips = &touching.strips;
                let patches = patches(&start, strips, units);
                if settled < SETTLED && moved([&start, &patches], &laid, wanted.settled, units) {
                    settled += 1;
                    start = patches;
                    continue;
                }
                let falls = fall_to_tips(&patches, strips);
                let mut beyond = Vec::new();
                if wanted.complete || !falls {
                    beyond = outside::overlapped(task, &touching, units, terms, &gap)?;
                }
                if !falls || !beyond.is_empty() {
                    attempts -= 1;
                    start = anew::pushed_out(&patches, strips, &beyond, units)?;
                    continue;
                }
                // Once, for a waist without pressure parts them again.
                if !is_joined && let Some(joined) = anew::joined(&patches) {
                    is_joined = true;
                    start = joined;
                    continue;
                }
                return Some(found(task, patches, &touching, wanted, &gap, units));
            }
            Ok(Touching { strips, .. }) => {
                attempts -= 1;
                start = anew::without_pulled(&start, &strips, units)?;
            }
            Err(stopped) => {
                attempts -= 1;
                start = anew::drawn_in(&start, &laid, &stopped, units)?;
            }
        }
    }
    None
}

/// What strips that are all the contact there is found.
fn found(
    task: Task<'_>,
    patches: Vec<Patch>,
    touching: &Touching,
    Wanted { terms, summit, .. }: Wanted,
    depth: Depth<'_>,
    units: Units,
) -> Found {
    let strips = &touching.strips;
    let peak = strip::peak(strips);
    let summit = summit.then(|| summit::height(touching, terms, depth)).flatten();
    Found {
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

/// How often strips are laid anew because a tip lies elsewhere.
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
        anew::bears_at_tips(band, &own) == [false; 2]
    })
}

/// Strips across the widest band, so that none becomes so slender that its ends follow those of its
/// neighbours by chance.
pub(super) fn most(start: &[Patch]) -> usize {
    const SLENDEREST: f64 = 200.0;
    const LEAST: usize = 6;
    let bands = || start.iter().flat_map(Patch::bands);
    let widest = bands().map(width).fold(0.0, f64::max);
    let most = bands().map(|band| {
        let [from, to] = band.x();
        SLENDEREST * (width(band) * widest).sqrt() / (0.5 * (to - from))
    });
    whole(most.fold(f64::INFINITY, f64::min).min(f64::from(u16::MAX))).max(LEAST)
}

/// Strips in all bands, more in the wider ones; `None` if they are too many.
fn laid(start: &[Patch], count: usize, terms: usize, units: Units) -> Option<Vec<Strip>> {
    let bands: Vec<&Band> = start.iter().flat_map(Patch::bands).collect();
    let widest = bands.iter().map(|band| width(band)).fold(0.0, f64::max);
    let strips = bands.iter().enumerate().flat_map(|(index, band)| {
        let share = (width(band) / widest).sqrt();
        let strips = whole((count as f64 * share).round()).clamp(FEWEST.min(count), count);
        strip::lay(band, index, strips, terms, units)
    });
    let strips: Vec<Strip> = strips.collect();
    let usable = strips.len() <= MOST_STRIPS && strips.iter().all(|strip| strip.half > 0.0);
    usable.then_some(strips)
}

/// Lays strips about the x that all sections are symmetric about.
fn centre(laid: &mut [Strip], gap: &Gap, units: Units) {
    let Some(axis) = gap.axis() else { return };
    for strip in laid {
        strip.centre = (axis - units.origin[0]) / units.length;
    }
}

/// Strips of the narrowest band.
const FEWEST: usize = 4;
/// Newton's matrix has six rows a strip at most.
const MOST_STRIPS: usize = 120;

fn width(band: &Band) -> f64 {
    band.y()[1] - band.y()[0]
}

/// Lengths by the root of the area, depths by the greatest at the strips.
fn units(task: Task<'_>, start: &[Patch]) -> Option<Units> {
    let area: f64 = start.iter().map(Patch::area).sum();
    let Rectangle { x, y } = start.first()?.extent();
    let origin = [x, y].map(|[low, high]| f64::midpoint(low, high));
    let depth = start
        .iter()
        .flat_map(Patch::bands)
        .flat_map(|band| band.rows().map(|y| (band.ends(y), y)).collect::<Vec<_>>())
        .filter_map(|(ends, y)| ends.map(|[from, to]| (f64::midpoint(from, to), y)))
        .map(|(x, y)| task.approach - task.gap.at(x, y))
        .fold(0.0, f64::max);
    let length = area.sqrt();
    let pressure = task.modulus * depth / length;
    (depth > 0.0 && length > 0.0).then_some(Units { origin, length, depth, pressure })
}

/// No tension anywhere in a strip.
fn is_pressed(strip: &Strip) -> bool {
    const POINTS: i32 = 8;
    (-POINTS..=POINTS).all(|i| profile(&strip.pressure, f64::from(i) / f64::from(POINTS)) >= 0.0)
}

fn patches(start: &[Patch], strips: &[Strip], units: Units) -> Vec<Patch> {
    let mut index = 0;
    start
        .iter()
        .map(|patch| {
            let bands = patch.bands().iter().map(|laid| {
                let own: Vec<Strip> =
                    strips.iter().filter(|strip| strip.band == index).copied().collect();
                index += 1;
                strip::band(&own, units, laid, laid.tips())
            });
            Patch::new(bands.collect())
        })
        .collect()
}
