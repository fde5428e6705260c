//! The overlap of a section by virtual penetration: which way a contact area lies.

use std::f64::consts::FRAC_2_PI;

use super::chord::{Chord, PLACES};
use super::level::NormalProblem;
use super::patch::Patch;
use super::patch_strip::Band;

/// Rows at which the section is looked at, and the fewest in an area.
const ROWS: u32 = 160;
const FEWEST: usize = 6;
/// Contact is where the undeformed bodies come nearer than this part of the approach (Kik and
/// Piotrowski 1996).
const VIRTUAL: f64 = 0.55;

/// A place across, and the parabola along x there: height, half its curvature, locus.
type Row = (f64, [f64; 3]);

/// The part of the plane where the undeformed bodies come nearer than that part of the approach, as one band: gaps
/// between its parts are bridged. `None` for other gaps and where it has few rows.
pub(super) fn overlap(task: NormalProblem<'_>) -> Option<Band> {
    let (rows, least) = rows(task)?;
    let depth = task.approach - least;
    let inside = |(_, [height, ..]): &Row| least + VIRTUAL * depth - height;
    let run: Vec<_> = rows.into_iter().filter(|row| inside(row) > 0.0).collect();
    let patch = patch(&run, &inside, task.modulus * depth)?;
    patch.bands().first().cloned()
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
