//! Check for missed contact: outside the strips the deformed bodies may not overlap.

use pulp::{Arch, Simd, WithSimd};

use super::strip_layout::Units;
use crate::normal::level::NormalProblem;
use crate::normal::overlap::Overlap;
use crate::normal::strip_system::{CENTRED, Depth, MAX_TERMS, Sources, Strip, StripSolution};

/// Rows, and columns where the gap is not a parabola along them.
const ROWS: u32 = 160;
const COLUMNS: usize = 40;
/// An overlap in parts of the greatest depth that counts: strips end where the pressure does to
/// about that.
const OVERLAP_TOLERANCE: f64 = 2e-3;

/// Places beyond the strips at which the bodies overlap, in the solver's units; `None` where strips leave
/// the known gap.
pub(super) fn overlapped(
    task: NormalProblem<'_>,
    touching: &StripSolution,
    units: Units,
    terms: usize,
    depth: Depth<'_>,
) -> Option<Vec<[f64; 2]>> {
    let (strips, arch) = (&touching.strips[..], Arch::new());
    let depth = |[x, y]: [f64; 2]| depth(x, y) + touching.deeper;
    let mut places = points(task, strips, units, &depth)?;
    places.retain(|at| depth(*at) > OVERLAP_TOLERANCE);
    let displaced = match terms {
        CENTRED => arch.dispatch(Displaced::<1> { strips, places: &places }),
        2 => arch.dispatch(Displaced::<2> { strips, places: &places }),
        4 => arch.dispatch(Displaced::<4> { strips, places: &places }),
        _ => arch.dispatch(Displaced::<MAX_TERMS> { strips, places: &places }),
    };
    let pairs = places.into_iter().zip(displaced);
    Some(pairs.filter(|(at, by)| depth(*at) - by >= OVERLAP_TOLERANCE).map(|(at, _)| at).collect())
}

/// Places beyond the strips where the bodies might touch, in the solver's units: the deepest ones of
/// each row. `None` where strips leave the gap's domain.
fn points(
    task: NormalProblem<'_>,
    strips: &[Strip],
    units: Units,
    depth: &impl Fn([f64; 2]) -> f64,
) -> Option<Vec<[f64; 2]>> {
    let domain = task.gap.domain();
    let is_bounded = domain.y.iter().all(|end| end.is_finite());
    let domain = if is_bounded { domain } else { task.gap.reach(task.approach)? };
    let inward = |at: f64, k: usize| (at - units.origin[k]) / units.length;
    let known = |strip: &Strip| {
        let [low, high] = domain.y.map(|y| inward(y, 1));
        strip.y - strip.width > low && strip.y + strip.width < high
    };
    let along = task.gap.has_locus();
    let possible =
        if along { domain } else { Overlap::find(task.gap, task.approach).ok()?.rectangle };
    let [low, high] = possible.y.map(|y| inward(y, 1));
    let [from, to] = possible.x.map(|x| inward(x, 0));
    let rows = (0..=ROWS).map(|row| low + (high - low) * f64::from(row) / f64::from(ROWS));
    let columns = std::array::from_fn(|i| from + (to - from) * (i as f64 + 0.5) / COLUMNS as f64);
    let mut points = Vec::new();
    for y in rows {
        match task.gap.locus(units.origin[1] + y * units.length) {
            Some(locus) => points.push([inward(locus, 0), y]),
            None => points.extend(tops(&columns, |x| depth([x, y])).map(|x| [x, y])),
        }
    }
    points.retain(|place| !strips.iter().any(|strip| covers(strip, *place)));
    strips.iter().all(known).then_some(points)
}

/// The columns no less deep than those beside them.
fn tops(columns: &[f64; COLUMNS], depth: impl Fn(f64) -> f64) -> impl Iterator<Item = f64> {
    let depths = columns.map(depth);
    (0..COLUMNS).filter_map(move |i| {
        let beside = [i.saturating_sub(1), (i + 1).min(COLUMNS - 1)];
        beside.into_iter().all(|other| depths[other] <= depths[i]).then_some(columns[i])
    })
}

/// Whether a place lies in a strip, or no further from it than a strip is wide: the outermost ends
/// short of the tip.
fn covers(strip: &Strip, [x, y]: [f64; 2]) -> bool {
    const MARGIN: f64 = 3.0;
    const BEYOND: f64 = 1.05;
    (y - strip.y).abs() <= MARGIN * strip.width && (x - strip.centre).abs() <= BEYOND * strip.half
}

/// Displacements at places by strips whose pressures have `T` terms.
struct Displaced<'a, const T: usize> {
    strips: &'a [Strip],
    places: &'a [[f64; 2]],
}

impl<const T: usize> WithSimd for Displaced<'_, T> {
    type Output = Vec<f64>;

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Vec<f64> {
        let all = Sources::<T>::all(self.strips);
        let mut sums = vec![0.0; self.places.len()];
        for (sum, at) in sums.iter_mut().zip(self.places) {
            for some in &all {
                *sum += some.displacement(*at);
            }
        }
        sums
    }
}
