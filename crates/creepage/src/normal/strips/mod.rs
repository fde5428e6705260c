//! Contact by strips along rolling whose pressure vanishes as a root at ends that are unknowns
//! themselves. Far fewer unknowns than elements and no staircase; but it needs a start close by,
//! which the elements give, and says so when Newton's method does not arrive.

mod kernel;
mod newton;
mod strip;

use super::band::Band;
use super::contact::Patch;
use super::lattice::whole;
use super::level::Task;
use super::solve::Found;
use newton::Touching;
use strip::{Strip, Units};

/// Solves with `count` strips across the widest patch, from patches close by.
///
/// A tip laid too far out leaves its strip nothing to touch: the strip shrinks to nothing, and
/// the strips are laid anew with the tip drawn in.
pub(super) fn solve(task: Task<'_>, start: &[Patch], count: usize, terms: usize) -> Option<Found> {
    const ATTEMPTS: usize = 8;
    let (units, depth) = units(task, start)?;
    let gap = |x: f64, y: f64| {
        let place = [x, y].map(|at| at * units.length);
        let h = task.gap.at(units.origin[0] + place[0], units.origin[1] + place[1]);
        (task.approach - h) / depth
    };
    let mut start = start.to_vec();
    for _ in 0..ATTEMPTS {
        let laid = laid(&start, count, terms, units)?;
        match newton::solve(laid.clone(), terms, &gap) {
            Ok(touching) if touching.strips.iter().all(is_pressed) => {
                let force = units.pressure * units.length * units.length;
                return Some(Found {
                    patches: patches(&start, &touching.strips, units),
                    load: force * touching.strips.iter().map(Strip::load).sum::<f64>(),
                    peak: units.pressure * peak(&touching.strips),
                    stiffness: force / depth * touching.stiffness,
                });
            }
            Ok(Touching { strips: stopped, .. }) | Err(stopped) => {
                if !draw_in(&mut start, &laid, &stopped, units) {
                    return None;
                }
            }
        }
    }
    None
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

/// Draws in the tips whose outermost strip has shrunk, by a part of its width; false if there
/// are none.
fn draw_in(start: &mut [Patch], laid: &[Strip], stopped: &[Strip], units: Units) -> bool {
    const SHRUNK: f64 = 0.6;
    const PART: f64 = 0.6;
    let mut drawn = false;
    for (index, band) in start.iter_mut().flat_map(Patch::bands_mut).enumerate() {
        let own = || laid.iter().zip(stopped).filter(|(strip, _)| strip.band == index);
        let tips = band.tips();
        let drawn_by = |end: Option<(&Strip, &Strip)>, tip: bool| match end {
            Some((laid, stopped)) if tip && stopped.half < SHRUNK * laid.half => {
                PART * 2.0 * laid.width * units.length
            }
            _ => 0.0,
        };
        let by = [drawn_by(own().next(), tips[0]), drawn_by(own().next_back(), tips[1])];
        if by.iter().sum::<f64>() > 0.0 {
            *band = band.drawn_in(by);
            drawn = true;
        }
    }
    drawn
}

/// Strips of the narrowest band.
const FEWEST: usize = 4;
/// Newton's matrix has six rows a strip at most.
const MOST_STRIPS: usize = 120;

fn width(band: &Band) -> f64 {
    band.y()[1] - band.y()[0]
}

/// Lengths by the root of the area, depths by the greatest at the strips.
fn units(task: Task<'_>, start: &[Patch]) -> Option<(Units, f64)> {
    let area: f64 = start.iter().map(Patch::area).sum();
    let origin = start.first()?.centroid();
    let deepest = start
        .iter()
        .flat_map(Patch::bands)
        .flat_map(|band| band.rows().map(|y| (band.ends(y), y)).collect::<Vec<_>>())
        .filter_map(|(ends, y)| ends.map(|[from, to]| (f64::midpoint(from, to), y)))
        .map(|(x, y)| task.approach - task.gap.at(x, y))
        .fold(0.0, f64::max);
    let length = area.sqrt();
    let pressure = task.modulus * deepest / length;
    (deepest > 0.0 && length > 0.0).then_some((Units { origin, length, pressure }, deepest))
}

/// No tension anywhere in a strip.
fn is_pressed(strip: &Strip) -> bool {
    const POINTS: i32 = 8;
    (-POINTS..=POINTS)
        .all(|i| kernel::profile(&strip.pressure, f64::from(i) / f64::from(POINTS)) >= 0.0)
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

/// The top of the parabola across through the strip of greatest pressure and its neighbours.
fn peak(strips: &[Strip]) -> f64 {
    let peaks: Vec<f64> = strips.iter().map(Strip::peak).collect();
    let top = (0..peaks.len()).max_by(|&i, &j| peaks[i].total_cmp(&peaks[j])).unwrap_or(0);
    let highest = peaks.get(top).copied().unwrap_or(0.0);
    let neighbour = |at: Option<usize>| {
        let at = at.filter(|&at| at < strips.len() && strips[at].band == strips[top].band)?;
        Some((strips[at].y - strips[top].y, peaks[at] - highest))
    };
    let (Some((low, below)), Some((high, above))) =
        (neighbour(top.checked_sub(1)), neighbour(Some(top + 1)))
    else {
        return highest;
    };
    let bend = (above / high - below / low) / (high - low);
    let slope = above / high - bend * high;
    if bend < 0.0 { highest - 0.25 * slope * slope / bend } else { highest }
}
