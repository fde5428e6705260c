//! Active-set update of the patches, where strips do not touch all along or bear what the edge of a punch does: shrink,
//! grow, split or merge.

use super::strip_layout::{FEWEST, Units, patches};
use crate::normal::patch::Patch;
use crate::normal::patch_strip::Band;
use crate::normal::strip_system::{Strip, StripFailure};

/// Removes tensile strips at the ends of a patch and shrinks it to the middle of the last one; if only interior strips
/// are tensile, splits the patch there. `None` where that leaves hardly any.
pub(super) fn without_tensile(
    start: &[Patch],
    strips: &[Strip],
    units: Units,
) -> Option<Vec<Patch>> {
    let tips = Tips::of(start, strips);
    let is_kept = |i: usize| strips[i].is_compressive() || !tips.is_outermost(i);
    let kept: Vec<Strip> = (0..strips.len()).filter(|i| is_kept(*i)).map(|i| strips[i]).collect();
    if kept.len() == strips.len() {
        return split(start, strips, |i| !strips[i].is_compressive(), units);
    }
    if !tips.leave_enough(&kept) {
        return None;
    }
    let mut next = patches(start, &kept, units);
    end_at_pulled(&mut next, strips, units);
    Some(next)
}

/// Draws in tips to the middle of the outermost strip where that is pulled.
fn end_at_pulled(start: &mut [Patch], strips: &[Strip], units: Units) {
    for (index, band) in start.iter_mut().flat_map(Patch::bands_mut).enumerate() {
        let mut own = strips.iter().filter(|strip| strip.band == index);
        let outer = [own.next(), own.next_back()];
        let (tips, [low, high]) = (band.tips(), band.y());
        let by = [0, 1].map(|side: usize| match outer[side] {
            Some(strip) if tips[side] && !strip.is_compressive() => {
                let middle = units.origin[1] + strip.y * units.length;
                if side == 0 { middle - low } else { high - middle }
            }
            _ => 0.0,
        });
        *band = band.trimmed(by.map(|by| by.max(0.0)));
    }
}

/// With those tips drawn in by a part of a strip's width whose outermost strip has shrunk, is about
/// to, or is pulled, or else parted where strips within are; `None` if there are none. Strips that had
/// come closer are the start of the next ones.
pub(super) fn shrink(
    start: &[Patch],
    laid: &[Strip],
    stopped: &StripFailure,
    units: Units,
) -> Option<Vec<Patch>> {
    const PART: f64 = 0.6;
    let tips = Tips::of(start, laid);
    let vanishes = |i: usize| vanishes(&laid[i], stopped, i);
    let goes = |i: usize| tips.is_outermost(i) && vanishes(i);
    let left = (0..laid.len()).filter(|i| !goes(*i));
    let left: Vec<Strip> = left.map(|i| stopped.strips[i]).collect();
    if left.len() == laid.len() {
        return split(start, laid, vanishes, units);
    }
    let bands = start.iter().flat_map(Patch::bands).enumerate();
    let wanted: Vec<[f64; 2]> = bands
        .map(|(index, band)| {
            let own = || (0..laid.len()).filter(|i| laid[*i].band == index);
            let [low, high] = band.y();
            let by = |i: Option<usize>| {
                let i = i.filter(|i| goes(*i));
                i.map_or(0.0, |i| PART * 2.0 * laid[i].width * units.length)
            };
            [low + by(own().next()), high - by(own().next_back())]
        })
        .collect();
    let usable =
        stopped.is_closer && left.iter().all(Strip::is_compressive) && tips.leave_enough(&left);
    let mut next = if usable { patches(start, &left, units) } else { start.to_vec() };
    for (band, [low, high]) in next.iter_mut().flat_map(Patch::bands_mut).zip(wanted) {
        let by = [low - band.y()[0], band.y()[1] - high].map(|by| by.max(0.0));
        *band = band.trimmed(by);
    }
    Some(next)
}

/// Whether a strip has shrunk, is about to, or is pulled.
fn vanishes(laid: &Strip, stopped: &StripFailure, i: usize) -> bool {
    const SHRUNK: f64 = 0.6;
    const SHRINKING: f64 = 0.5;
    let shrinking = stopped.shrinking.get(i).is_some_and(|by| *by > SHRINKING);
    let shrunk = stopped.strips[i].half < SHRUNK * laid.half;
    shrinking || shrunk || !stopped.strips[i].is_compressive()
}

/// The tips of bands among their strips.
struct Tips<'a> {
    tips: Vec<[bool; 2]>,
    strips: &'a [Strip],
}

impl<'a> Tips<'a> {
    fn of(start: &[Patch], strips: &'a [Strip]) -> Self {
        Self { tips: start.iter().flat_map(Patch::bands).map(Band::tips).collect(), strips }
    }

    /// Whether a strip is the outermost one at a tip.
    fn is_outermost(&self, i: usize) -> bool {
        let own = |other: Option<usize>| {
            let other = other.and_then(|i| self.strips.get(i));
            other.is_some_and(|other| other.band == self.strips[i].band)
        };
        let outermost = [!own(i.checked_sub(1)), !own(Some(i + 1))];
        let tips = self.tips[self.strips[i].band];
        (0..2).any(|side| outermost[side] && tips[side])
    }

    /// Whether every band has enough of some strips.
    fn leave_enough(&self, strips: &[Strip]) -> bool {
        let left = |band: usize| strips.iter().filter(|strip| strip.band == band).count();
        (0..self.tips.len()).all(|band| left(band) >= FEWEST)
    }
}

/// Areas of one band in two where strips within vanish: a waist has no pressure left. `None` where
/// there is no such one.
fn split(
    start: &[Patch],
    strips: &[Strip],
    vanishes: impl Fn(usize) -> bool,
    units: Units,
) -> Option<Vec<Patch>> {
    let mut index = 0;
    let parts = start.iter().flat_map(|patch| {
        let own: Vec<usize> = (0..strips.len()).filter(|i| strips[*i].band == index).collect();
        index += patch.bands().len();
        let inner = own.get(FEWEST..own.len().saturating_sub(FEWEST)).unwrap_or_default();
        let first = inner.iter().find(|i| vanishes(**i));
        let last = first
            .and_then(|first| inner.iter().take_while(|i| *i <= first || vanishes(**i)).last());
        let halves = first.zip(last).and_then(|(first, last)| {
            let [band] = patch.bands() else { return None };
            let border = |i: usize, side: f64| {
                units.origin[1] + (strips[i].y + side * strips[i].width) * units.length
            };
            let ([low, high], [below, above]) = (band.y(), band.tips());
            let lower = band.between([low, border(*first, -1.0)], [below, true])?;
            let upper = band.between([border(*last, 1.0), high], [true, above])?;
            Some([lower, upper].map(|half| Patch::new(vec![half])).to_vec())
        });
        halves.unwrap_or_else(|| vec![patch.clone()])
    });
    let parts: Vec<Patch> = parts.collect();
    (parts.len() > start.len()).then_some(parts)
}

/// With tips pushed out to where the bodies overlap beyond, and at least by the width of their outermost strip
/// where that bears more than the one beside it, as the edge of a punch does; `None` where they overlap far
/// from all tips.
pub(super) fn grow(
    start: &[Patch],
    strips: &[Strip],
    beyond: &[[f64; 2]],
    units: Units,
) -> Option<Vec<Patch>> {
    let bands: Vec<&Band> = start.iter().flat_map(Patch::bands).collect();
    let widths = |(index, band): (usize, &&Band)| widths_at_punches(band, index, strips, units);
    let mut out: Vec<[f64; 2]> = bands.iter().enumerate().map(widths).collect();
    for place in beyond {
        let [x, y] = [0, 1].map(|k| units.origin[k] + place[k] * units.length);
        let tips = bands.iter().enumerate();
        let tips = tips.filter_map(|(index, band)| Some((index, band.beyond_tip(x, y)?)));
        let (index, (side, by)) = tips.min_by(|one, other| one.1.1.total_cmp(&other.1.1))?;
        out[index][side] = out[index][side].max(by);
    }
    let mut next = start.to_vec();
    for (band, out) in next.iter_mut().flat_map(Patch::bands_mut).zip(out) {
        *band = band.trimmed(out.map(|out| -out));
    }
    Some(merge(&next).unwrap_or(next))
}

/// Width of the outermost strip at each tip of a band where that bears more than the one beside it (m), else
/// zero.
fn widths_at_punches(band: &Band, index: usize, strips: &[Strip], units: Units) -> [f64; 2] {
    let own: Vec<&Strip> = strips.iter().filter(|strip| strip.band == index).collect();
    let (outer, bears) = ([own.first(), own.last()], bears_at_tips(band, &own));
    [0, 1].map(|side: usize| match outer[side] {
        Some(strip) if bears[side] => 2.0 * strip.width * units.length,
        _ => 0.0,
    })
}

/// With areas of one band that touch as one; `None` where there are none.
pub(super) fn merge(areas: &[Patch]) -> Option<Vec<Patch>> {
    let mut next: Vec<Patch> = Vec::new();
    for area in areas {
        match next.last_mut().and_then(|last| Some((last.merged(area)?, last))) {
            Some((merged, last)) => *last = merged,
            None => next.push(area.clone()),
        }
    }
    (next.len() < areas.len()).then_some(next)
}

/// Whether the outermost strip of a band at each of its tips bears more than the one beside it.
pub(super) fn bears_at_tips(band: &Band, own: &[&Strip]) -> [bool; 2] {
    let [low, high] = band.tips();
    match own {
        [first, second, .., before, last] => {
            [low && first.peak() >= second.peak(), high && last.peak() >= before.peak()]
        }
        _ => [false; 2],
    }
}
