//! A first guess of the contact areas from a section alone.

use std::f64::consts::FRAC_2_PI;

use super::chord::{Chord, PLACES};
use super::level::NormalProblem;
use super::patch::Patch;
use super::patch_strip::Band;
use super::solution::Asked;
use crate::gap::Gap;
use crate::hertz::{Hertz, Radii};
use crate::solid::SolidPair;

/// Rows at which the section is looked at, and the fewest in an area.
const ROWS: u32 = 160;
const FEWEST: usize = 6;
/// Contact is where the undeformed bodies come nearer than this part of the approach (Kik and
/// Piotrowski 1996).
const VIRTUAL: f64 = 0.55;

/// A place across, and the parabola along x there: height, half its curvature, locus.
type Row = (f64, [f64; 3]);

/// Where a section and a radius along rolling would touch by virtual penetration; `None` for other
/// gaps, at the end of the section, and where an area has few rows.
pub(super) fn by_virtual_penetration(task: NormalProblem<'_>) -> Option<Vec<Patch>> {
    let (rows, least) = rows(task)?;
    let depth = task.approach - least;
    let inside = |(_, [height, ..]): &Row| least + VIRTUAL * depth - height;
    if rows.first().or(rows.last()).is_none_or(|row| inside(row) > 0.0) || depth <= 0.0 {
        return None;
    }
    virtual_patches(&rows, &inside, task.modulus * depth)
}

/// The part of the plane where the undeformed bodies come nearer than that part of the approach, as one band: gaps
/// between its parts are bridged. `None` as above, but at the section's end.
pub(super) fn overlap(task: NormalProblem<'_>) -> Option<Band> {
    let (rows, least) = rows(task)?;
    let depth = task.approach - least;
    let inside = |(_, [height, ..]): &Row| least + VIRTUAL * depth - height;
    let run: Vec<_> = rows.into_iter().filter(|row| inside(row) > 0.0).collect();
    let patch = patch(&run, &inside, task.modulus * depth)?;
    patch.bands().first().cloned()
}

/// The approach and the areas of a smooth contact whose sections along x are parabolas: of each overlap of the
/// undeformed bodies what Hertz's ellipse is of that of two paraboloids. Where a load is asked for, the approach is
/// that at which all together carry it. `None` for other gaps, where bodies do not touch, and at the end of
/// the known section.
pub(super) fn by_hertz(gap: &Gap, pair: SolidPair, asked: Asked) -> Option<(f64, Vec<Patch>)> {
    /// Looks that close in on the overlap, and on the depth.
    const LOOKS: usize = 12;
    /// What part of the rows the overlap is to fill, and how nearly a depth is to carry its load.
    const FILLED: f64 = 0.5;
    const SAME: f64 = 0.01;
    gap.parabola(0.0)?;
    let domain = gap.domain().y;
    let (height, mut depth) = match asked {
        Asked::Approach(approach) => (approach, None),
        Asked::Load(load) => {
            let height = gap.likely_height(load * (1.0 - pair.poisson()) / pair.shear_modulus());
            (height, Some(height))
        }
    };
    let mut range = gap.reach(height)?.y;
    for look in 0..LOOKS {
        let rows = rows_between(gap, range)?;
        let lowest = rows.iter().min_by(|a, b| a.1[0].total_cmp(&b.1[0]))?;
        // A height at first, then a depth.
        let top = match depth {
            Some(depth) if look > 0 => lowest.1[0] + depth,
            _ => height,
        };
        let step = (range[1] - range[0]) / f64::from(ROWS_OF_LOOK);
        let inside: Vec<_> = rows.iter().filter(|(_, [height, ..])| *height < top).collect();
        let near = match inside[..] {
            [first, .., last] => [first.0 - step, last.0 + step],
            _ => [lowest.0 - step, lowest.0 + step],
        };
        let near = [near[0].max(domain[0]), near[1].min(domain[1])];
        if depth.is_some() {
            depth = Some(top - lowest.1[0]);
        }
        if inside.len() < 2 || near[1] - near[0] < FILLED * (range[1] - range[0]) {
            range = near;
            continue;
        }
        let hills = hills(&rows, top, pair)?;
        let Asked::Load(load) = asked else {
            return areas(gap, &hills).map(|areas| (top, areas));
        };
        let carried: f64 = hills.iter().map(|hill| hill.hertz.normal_force()).sum();
        let times = (load / carried).powf(2.0 / 3.0);
        if (times - 1.0).abs() < SAME {
            return areas(gap, &hills).map(|areas| (top, areas));
        }
        // The rows that are inside then.
        let half = 0.6 * times.sqrt() * (near[1] - near[0]);
        let middle = f64::midpoint(near[0], near[1]);
        range = [(middle - half).max(domain[0]), (middle + half).min(domain[1])];
        depth = depth.map(|depth| times * depth);
    }
    None
}

/// Rows of a look.
const ROWS_OF_LOOK: u32 = 40;
/// How far an overlap may differ from that of paraboloids, over its depth: strips beside the ends of others are to be
/// laid anew, and elements are the better start.
const UNLIKE: f64 = 0.03;

/// An overlap of the undeformed bodies.
struct Hill {
    top: f64,
    /// Its middle and half its width across, and half its length along.
    middle: f64,
    half: [f64; 2],
    /// The contact of two paraboloids with such an overlap.
    hertz: Hertz,
}

/// The overlaps on some rows, the outermost of which must be outside; `None` where one is unlike that of
/// paraboloids.
fn hills(rows: &[Row], top: f64, pair: SolidPair) -> Option<Vec<Hill>> {
    let depth = |row: &Row| top - row.1[0];
    let mut hills = Vec::new();
    let mut first = 0;
    for run in rows.chunk_by(|a, b| (depth(a) > 0.0) == (depth(b) > 0.0)) {
        let (from, to) = (first, first + run.len());
        first = to;
        if depth(run.first()?) <= 0.0 {
            continue;
        }
        // The ends, between the last row inside and the next.
        let end = |inner: usize, outer: Option<usize>| {
            let (inner, outer) = (&rows[inner], rows.get(outer?)?);
            Some(inner.0 + depth(inner) / (depth(inner) - depth(outer)) * (outer.0 - inner.0))
        };
        let (low, high) = (end(from, from.checked_sub(1))?, end(to - 1, Some(to))?);
        let deepest = run.iter().map(depth).fold(0.0, f64::max);
        let long = run.iter().map(|row| (depth(row) / row.1[1]).sqrt()).fold(0.0, f64::max);
        let half = [long, 0.5 * (high - low)];
        // Half the way out a paraboloid is three quarters as deep.
        let middle = f64::midpoint(low, high);
        let is_like = |side: f64| {
            let at = middle + side * 0.5 * half[1];
            let nearest = run.iter().min_by(|a, b| (a.0 - at).abs().total_cmp(&(b.0 - at).abs()));
            nearest.is_some_and(|row| {
                let expected = 1.0 - ((row.0 - middle) / half[1]).powi(2);
                (depth(row) / deepest - expected).abs() < UNLIKE
            })
        };
        if !(is_like(-1.0) && is_like(1.0)) {
            return None;
        }
        let [rolling, lateral] = half.map(|half| half * half / (2.0 * deepest));
        let flat = Radii { rolling: f64::INFINITY, lateral: f64::INFINITY };
        let unit = Hertz::new(pair, Radii { rolling, lateral }, flat, 0.0, 1.0).ok()?;
        let hertz = unit.under((deepest / unit.approach_constant()).powf(1.5)).ok()?;
        hills.push(Hill { top, middle, half, hertz });
    }
    (!hills.is_empty()).then_some(hills)
}

/// The overlaps shrunk to what is in contact, with Hertz's pressures.
fn areas(gap: &Gap, hills: &[Hill]) -> Option<Vec<Patch>> {
    const CHORDS: u32 = 24;
    let area = |hill: &Hill| {
        let ellipse = hill.hertz.ellipse();
        let (a, b) = (ellipse.a(), ellipse.b());
        let density = [hill.hertz.peak_pressure() / a; PLACES];
        let chord = |k: u32| {
            let t = (2.0 * f64::from(k) + 1.0) / f64::from(CHORDS) - 1.0;
            let [height, half, _] = gap.parabola(hill.middle + t * hill.half[1])?;
            let y = hill.middle + t * b;
            let [_, _, centre] = gap.parabola(y)?;
            let half = a / hill.half[0] * ((hill.top - height) / half).max(0.0).sqrt();
            Some(Chord { y, half, centre, density })
        };
        let chords = (0..CHORDS).map(chord).collect::<Option<Vec<_>>>()?;
        let usable = chords.iter().all(|chord| chord.half > 0.0 && chord.half.is_finite());
        let sides = [hill.middle - b, hill.middle + b];
        usable.then(|| Patch::new(vec![Band::new(chords, sides, [true; 2])]))
    };
    hills.iter().map(area).collect()
}

/// Rows at even steps.
fn rows_between(gap: &Gap, [low, high]: [f64; 2]) -> Option<Vec<Row>> {
    if !(high - low).is_finite() {
        return None;
    }
    let y = |row: u32| low + (high - low) * f64::from(row) / f64::from(ROWS_OF_LOOK);
    (0..=ROWS_OF_LOOK).map(|row| Some((y(row), gap.parabola(y(row))?))).collect()
}

/// An area for each run of rows that are inside.
fn virtual_patches(rows: &[Row], inside: &impl Fn(&Row) -> f64, force: f64) -> Option<Vec<Patch>> {
    let mut patches = Vec::new();
    for run in rows.chunk_by(|a, b| (inside(a) > 0.0) == (inside(b) > 0.0)) {
        if run.first().is_some_and(|row| inside(row) > 0.0) {
            patches.push(patch(run, inside, force)?);
        }
    }
    (!patches.is_empty()).then_some(patches)
}

/// The section's rows, each with its parabola along x, and its least height.
fn rows(task: NormalProblem<'_>) -> Option<(Vec<Row>, f64)> {
    let [low, high] = task.gap.domain().y;
    if !(high - low).is_finite() {
        return None;
    }
    let y = |row: u32| low + (high - low) * f64::from(row) / f64::from(ROWS);
    let rows = (0..=ROWS).map(|row| Some((y(row), task.gap.parabola(y(row))?)));
    let rows: Vec<Row> = rows.collect::<Option<_>>()?;
    let least = rows.iter().map(|(_, row)| row[0]).fold(f64::INFINITY, f64::min);
    Some((rows, least))
}

/// An area on neighbouring rows, with pressures about those of Hertz.
fn patch(run: &[Row], inside: &impl Fn(&Row) -> f64, force: f64) -> Option<Patch> {
    let [(first, _), .., (last, _)] = run else { return None };
    let half = |row: &Row| (inside(row) / row.1[1]).sqrt();
    let longest = run.iter().map(half).fold(0.0, f64::max);
    let step = (last - first) / (run.len() - 1) as f64;
    let width = 0.5 * (last - first + step);
    let density = [FRAC_2_PI * force / (longest * width).sqrt() / longest; PLACES];
    let chord = |row: &Row| {
        let (y, [_, _, centre]) = *row;
        Chord { y, half: half(row), centre, density }
    };
    let sides = [first - 0.5 * step, last + 0.5 * step];
    let usable = run.len() >= FEWEST && longest.is_finite();
    usable.then(|| Patch::new(vec![Band::new(run.iter().map(chord).collect(), sides, [true; 2])]))
}
