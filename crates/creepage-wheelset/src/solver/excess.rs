//! Excess of a contact's gap beyond parabolas along rolling.
//!
//! Under a line along `x` the profile of a wheel turned against the rail passes sideways, on a flange by as much
//! as the contact is wide. The gap along that line is no parabola then: where that matters, a grid of what the
//! true gap has beyond one is added. The parabolas are chords of the true gap and not its osculating ones, whose
//! radii jump where two arcs of the profile meet.

use creepage_rail::{Across, Contact};

/// Places across and along at which it is looked for.
const PROBES: [usize; 2] = [9, 6];
/// Places along, and every which place of the section across, at which it is taken.
const ALONG: usize = 24;
const EVERY: usize = 3;
/// Parts of the approach below which it counts as nothing, and from which it counts in full: a thousandth of
/// the approach is some .15 % of the load. Between them it fades in.
const MATTERS: [f64; 2] = [3e-4, 1e-3];
/// Half length of the chords, over that of the overlap: where contact ends.
const CHORD: f64 = 0.7;

/// Excess of a gap over parabolas along `x`.
#[derive(Debug, Clone)]
pub(super) struct Excess {
    /// Radii (m) of the parabolas at all places of the section.
    pub(super) radius: Vec<f64>,
    /// Distances from their lowest places (m).
    pub(super) d: Vec<f64>,
    /// Places across (m).
    pub(super) s: Vec<f64>,
    /// The excess (m) in rows of one `s`.
    pub(super) values: Vec<f64>,
}

impl Excess {
    /// `None` where parabolas will do.
    pub(super) fn of(contact: &Contact<'_>, section: &[Across]) -> Option<Self> {
        let half = |across: &Across| {
            (2.0 * across.rolling_radius * (contact.approach - across.gap)).max(0.0).sqrt()
        };
        let longest = section.iter().map(half).fold(0.0, f64::max);
        let first = section.iter().position(|across| across.gap < contact.approach)?;
        let last = section.iter().rposition(|across| across.gap < contact.approach)?;
        let inside = &section[first..=last];
        // Every so many of them, and the last.
        let rows = |every: usize| -> Vec<Across> {
            let (every, end) = (every.max(1), inside.len() - 1);
            let at = (0..end).step_by(every).chain(std::iter::once(end));
            at.map(|index| inside[index]).collect()
        };
        // Where the bodies overlap, for there alone can they touch.
        let probes = rows(inside.len() / PROBES[0]);
        let d = even(longest, PROBES[1]);
        let found = contact.beyond_parabola(&places(&probes), &d)?;
        // Its odd part: without yaw there is none, and sections along rolling are as even as parabolas.
        let largest = found.chunks(d.len()).zip(&probes).fold(0.0_f64, |largest, (row, across)| {
            let odd = row.iter().zip(row.iter().rev()).map(|(one, other)| 0.5 * (one - other));
            let within = odd.zip(&d).filter(|(_, d)| d.abs() <= half(across));
            within.fold(largest, |largest, (excess, _)| largest.max(excess.abs()))
        });
        let [least, full] = MATTERS.map(|part| part * contact.approach);
        let part = ((largest - least) / (full - least)).clamp(0.0, 1.0);
        let part = part * part * (3.0 - 2.0 * part);
        if part == 0.0 {
            return None;
        }
        // Half the curvature of the chords over that of the parabolas.
        let chord = CHORD * longest;
        let more = |of: &[Across]| -> Option<Vec<f64>> {
            let ends = contact.beyond_parabola(&places(of), &[-chord, chord])?;
            Some(ends.chunks(2).map(|ends| (ends[0] + ends[1]) / (2.0 * chord * chord)).collect())
        };
        let bends = more(inside)?;
        let bend = |index: usize| bends[index.clamp(first, last) - first];
        let radius = section
            .iter()
            .enumerate()
            .map(|(index, across)| 1.0 / (1.0 / across.rolling_radius + 2.0 * part * bend(index)));
        let radius: Vec<f64> = radius.collect();
        let (taken, d) = (rows(EVERY), even(longest, ALONG));
        let mut values = contact.beyond_parabola(&places(&taken), &d)?;
        for (row, bend) in values.chunks_mut(d.len()).zip(more(&taken)?) {
            for (excess, d) in row.iter_mut().zip(&d) {
                *excess = part * (*excess - bend * d * d);
            }
        }
        let bends_up = radius.iter().all(|radius| *radius > 0.0 && radius.is_finite());
        bends_up.then(|| Self { radius, d, s: places(&taken), values })
    }
}

fn places(of: &[Across]) -> Vec<f64> {
    of.iter().map(|across| across.s).collect()
}

/// Even places over a half length on both sides of 0.
fn even(half: f64, count: usize) -> Vec<f64> {
    let part = |i: usize| i as f64 / (count - 1) as f64;
    (0..count).map(|i| (2.0 * part(i) - 1.0) * half).collect()
}
