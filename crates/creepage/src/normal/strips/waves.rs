//! Resolution check: whether strips follow the waves of a gap, by enough polynomials along them, and closely enough
//! across.

use std::f64::consts::PI;

use crate::gap::Gap;
use crate::normal::patch::Patch;
use crate::normal::patch_strip::Band;
use crate::normal::strip_system::{self, CENTRED, Depth, MAX_TERMS, Strip};

/// Polynomials that a strip's pressure needs: on a parabola along rolling two, near one too, on other sections four
/// or [`MAX_TERMS`]; `None` where their waves are too short for that. Where all sections are symmetric
/// about one x, so are the pressures.
pub(in crate::normal) fn terms(gap: &Gap, areas: &[Patch]) -> Option<usize> {
    let bands = || areas.iter().flat_map(Patch::bands);
    let lacks = |terms| bands().map(|band| missing(gap, band, terms)).fold(0.0, f64::max);
    match (gap.is_parabola_along(), gap.axis()) {
        (true, Some(_)) => Some(CENTRED),
        (true, None) => Some(2),
        // As near a parabola as that of a wheel turned against the rail: a change of their number is a jump.
        (false, _) if gap.has_locus() && lacks(2) < NEARLY => Some(2),
        (false, _) => {
            [4, MAX_TERMS].into_iter().find(|terms| lacks(*terms) < MISSING_PRESSURE_TOLERANCE)
        }
    }
}

/// The part of the largest pressure that may be missing: half of what is promised of the peak.
const MISSING_PRESSURE_TOLERANCE: f64 = 2.5e-3;
/// The same of sections near a parabola, of whose waves none is short.
const NEARLY: f64 = 1e-2;

/// The pressure that these polynomials miss, over the largest. A strip that sinks by `c T_m(s)`
/// carries `m c/half`; with its ends the polynomials reach one degree further.
fn missing(gap: &Gap, band: &Band, terms: usize) -> f64 {
    let (mut missing, mut largest) = (0.0_f64, 0.0_f64);
    for y in band.rows() {
        let Some([trailing, leading]) = band.ends(y) else { continue };
        let half = 0.5 * (leading - trailing);
        let section = |s: f64| gap.at(f64::midpoint(trailing, leading) + half * s, y);
        let carried = chebyshev(section).map(|(m, c)| m as f64 * c.abs() / half);
        let (kept, lost): (Vec<_>, Vec<_>) = carried.enumerate().partition(|(m, _)| *m < terms + 2);
        let sum = |parts: Vec<(usize, f64)>| parts.into_iter().map(|(_, part)| part).sum::<f64>();
        missing = missing.max(sum(lost));
        largest = largest.max(sum(kept));
    }
    missing / largest
}

/// Degrees and coefficients of Chebyshev's polynomials that give a function.
fn chebyshev(of: impl Fn(f64) -> f64) -> impl Iterator<Item = (usize, f64)> {
    const TERMS: usize = 24;
    let angle = |i: usize| PI * (i as f64 + 0.5) / TERMS as f64;
    let values: [f64; TERMS] = std::array::from_fn(|i| of(angle(i).cos()));
    (0..TERMS).map(move |m| {
        let parts = values.iter().enumerate();
        let sum: f64 = parts.map(|(i, value)| value * (m as f64 * angle(i)).cos()).sum();
        (m, 2.0 / TERMS as f64 * sum)
    })
}

/// The part of the largest pressure, about, that waves across put between the strips at the summit and
/// not into them: what the cubic through four strips lacks halfway between the middle two. Depths are
/// over the greatest one.
pub(super) fn missed_across(strips: &[Strip], depth: Depth<'_>) -> f64 {
    let width: f64 = strips.iter().map(|strip| strip.width).sum();
    let longest = strips.iter().map(|strip| strip.half).fold(0.0, f64::max);
    let top = strip_system::top(strips);
    let is_near = |four: &&[Strip]| {
        let is_one_band = four[0].band == four[3].band;
        is_one_band && (four[0].y..=four[3].y).contains(&strips[top].y)
    };
    let missed = strips.windows(4).filter(is_near).map(|four| {
        let [low, high] = [four[1], four[2]];
        let [x, y] = [f64::midpoint(low.centre, high.centre), f64::midpoint(low.y, high.y)];
        let lacks = (depth(x, y) - cubic(four, y, |strip| depth(x, strip.y))).abs();
        // Waves some three strips long beside a round summit.
        2.0 * lacks * width.min(longest) / (high.y - low.y)
    });
    missed.fold(0.0, f64::max)
}

/// Lagrange's cubic.
fn cubic(four: &[Strip], y: f64, value: impl Fn(&Strip) -> f64) -> f64 {
    let weight = |own: usize| -> f64 {
        let others = (0..four.len()).filter(|other| *other != own);
        others.map(|other| (y - four[other].y) / (four[own].y - four[other].y)).product()
    };
    four.iter().enumerate().map(|(own, strip)| weight(own) * value(strip)).sum()
}
