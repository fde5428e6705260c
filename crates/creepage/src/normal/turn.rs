//! Rotation of the axes along a contact area that lies askew.
//!
//! Strips are rectangles: in an area that lies askew to rolling, as that of a flange of a yawed wheel, their
//! ends are stairs, and so slender ones err by per cents. Elastic half-spaces have no direction: such an area
//! is pressed in axes turned along it, and its bands are taken along rolling again afterwards.

use super::chord::{Chord, PLACES, place};
use super::level::NormalProblem;
use super::patch::Patch;
use super::patch_strip::Band;
use crate::gap::{Gap, Rectangle};
use crate::numerics::bisect;
use std::cmp::Ordering;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, TAU};

/// Axes turned about a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Turn {
    about: [f64; 2],
    angle: f64,
}

impl Turn {
    /// [`Band::stairs`] from which axes are turned.
    pub(super) const MIN_STAIRS: f64 = 5e-3;
    /// The same of the undeformed bodies' overlap, in its many rows: lower, for turning is a jump in the load.
    const LEAST_OF_OVERLAP: f64 = 5e-4;

    /// Along areas of one band each; `None` where they lie along rolling nearly enough.
    ///
    /// Where sections along x have one lowest place the angle is that of the undeformed bodies' overlap, so that
    /// it depends on nothing but the gap and goes smoothly with it.
    pub(super) fn along(task: NormalProblem<'_>, areas: &[Patch]) -> Option<Self> {
        let bands = areas.iter().map(|patch| match patch.bands() {
            [band] if band.tips() == [true; 2] => Some(band),
            _ => None,
        });
        let bands: Vec<&Band> = bands.collect::<Option<_>>()?;
        let overlap = task.gap.domain().y.iter().all(|y| y.is_finite());
        let overlap = if overlap { section_overlap(task) } else { None };
        let (band, least) = match (&overlap, &bands[..]) {
            (Some(overlap), _) => (overlap, Self::LEAST_OF_OVERLAP),
            (None, [band]) => (*band, Self::MIN_STAIRS),
            _ => return None,
        };
        if band.stairs() < least {
            return None;
        }
        let (about, [xx, xy, yy]) = band.second_moments();
        // The axis nearer to rolling.
        let angle = 0.5 * (2.0 * xy / (xx - yy)).atan();
        (angle.is_finite() && angle != 0.0).then_some(Self { about, angle })
    }

    /// Whether the angle is known beforehand, and does not depend on the areas found.
    pub(super) fn is_of_overlap(task: NormalProblem<'_>) -> bool {
        task.gap.domain().y.iter().all(|y| y.is_finite()) && task.gap.has_locus()
    }

    /// The gap in these axes, where it is looked at around an area.
    pub(super) fn gap(&self, gap: &Gap, areas: &[Patch]) -> Gap {
        let extents = areas.iter().map(Patch::extent);
        let extent = extents.reduce(|one, other| Rectangle {
            x: [one.x[0].min(other.x[0]), one.x[1].max(other.x[1])],
            y: [one.y[0].min(other.y[0]), one.y[1].max(other.y[1])],
        });
        gap.turned(self.about, self.angle, &extent.unwrap_or(Rectangle::PLANE))
    }

    /// Areas in these axes.
    pub(super) fn inwards(&self, areas: &[Patch]) -> Option<Vec<Patch>> {
        Self { angle: -self.angle, ..*self }.outwards(areas)
    }

    /// Areas of these axes in those along rolling; `None` unless each is one band.
    pub(super) fn outwards(&self, areas: &[Patch]) -> Option<Vec<Patch>> {
        let turned = areas.iter().map(|area| match area.bands() {
            [band] => Some(Patch::new(vec![self.turned(band)?])),
            _ => None,
        });
        turned.collect()
    }

    fn place(&self, [x, y]: [f64; 2], angle: f64) -> [f64; 2] {
        let (sin, cos) = angle.sin_cos();
        let [x, y] = [x - self.about[0], y - self.about[1]];
        [self.about[0] + cos * x - sin * y, self.about[1] + sin * x + cos * y]
    }

    /// The band, with as many chords along x as it has along its own; `None` for one of no width across.
    fn turned(&self, band: &Band) -> Option<Band> {
        /// As strips are laid: the outermost are a third as wide.
        const CLUSTER: f64 = 0.8 * FRAC_PI_2;
        let [from, to] = band.y();
        if from.partial_cmp(&to) != Some(Ordering::Less) {
            return None;
        }
        // The outline, once around: its upper half rises with the angle between the ends.
        let outline = |t: f64| {
            let y = f64::midpoint(from, to) + 0.5 * (to - from) * t.sin();
            let [trailing, leading] = band.ends(y.clamp(from, to)).unwrap_or([f64::NAN; 2]);
            let x = if t.cos() >= 0.0 { leading } else { trailing };
            self.place([x, y], self.angle)
        };
        let across = |t: f64| outline(t)[1];
        let low = extreme(|t| -across(t), -FRAC_PI_2);
        let high = extreme(across, FRAC_PI_2);
        let y = [across(low), across(high)];
        let count = band.rows().count();
        let row = |i: usize| {
            let t = (2.0 * i as f64 + 1.0) / count as f64 - 1.0;
            f64::midpoint(y[0], y[1]) + 0.5 * (y[1] - y[0]) * (CLUSTER * t).sin() / CLUSTER.sin()
        };
        let chords = (0..count).map(|i| {
            let y = row(i);
            let at = |end: f64| outline(bisect(low, end, ROUNDS, |turn| across(turn) < y))[0];
            let [leading, trailing] = [at(high), at(high - TAU)];
            let (centre, half) = (f64::midpoint(trailing, leading), 0.5 * (leading - trailing));
            let mut density = [0.0; PLACES];
            for (index, density) in density.iter_mut().enumerate() {
                // At the ends it goes on as it is next to them.
                let s = place(index.clamp(1, PLACES - 2));
                let [x, y] = self.place([centre + half * s, y], -self.angle);
                *density = band.pressure_near(x, y) / (half * (1.0 - s * s).sqrt());
            }
            (half > 0.0).then_some(Chord { y, half, centre, density })
        });
        Some(Band::new(chords.collect::<Option<_>>()?, y, [true; 2]))
    }
}

/// Halvings of the angle at which the outline crosses a row.
const ROUNDS: usize = 44;

/// Where a function of an angle that has one maximum in a turn is greatest, near an angle: by golden section.
fn extreme(of: impl Fn(f64) -> f64, near: f64) -> f64 {
    const PART: f64 = 0.618_033_988_749_894_9;
    const SECTIONS: usize = 40;
    let [mut low, mut high] = [near - FRAC_PI_2, near + FRAC_PI_2];
    let mut inner = [high - PART * (high - low), low + PART * (high - low)];
    let mut values = inner.map(&of);
    for _ in 0..SECTIONS {
        if values[0] > values[1] {
            high = inner[1];
            inner = [high - PART * (high - low), inner[0]];
            values = [of(inner[0]), values[0]];
        } else {
            low = inner[0];
            inner = [inner[1], low + PART * (high - low)];
            values = [values[1], of(inner[1])];
        }
    }
    f64::midpoint(low, high)
}

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
fn section_overlap(task: NormalProblem<'_>) -> Option<Band> {
    let (rows, least) = rows(task)?;
    let depth = task.approach - least;
    let inside = |(_, [height, ..]): &Row| least + VIRTUAL * depth - height;
    let run: Vec<_> = rows.into_iter().filter(|row| inside(row) > 0.0).collect();
    let patch = patch_of_rows(&run, &inside, task.modulus * depth)?;
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
fn patch_of_rows(run: &[Row], inside: &impl Fn(&Row) -> f64, force: f64) -> Option<Patch> {
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
