//! Whether strips are all the contact there is: nowhere else may the deformed bodies overlap.

use std::f64::consts::PI;

use pulp::{Arch, Simd, WithSimd};

use crate::normal::level::Task;

use super::kernel::{MOST, RULES, View};
use super::newton::{Depth, Touching};
use super::strip::{Strip, Units};
use super::system::CENTRED;

/// Rows, and columns where the gap is not a parabola along them.
const ROWS: u32 = 160;
const COLUMNS: u32 = 40;
/// An overlap in parts of the greatest depth that counts: strips end where the pressure does to
/// about that.
const LEAST: f64 = 2e-3;

/// Whether the bodies stay apart beyond the strips, and the strips within the known gap.
pub(super) fn stays_open(
    task: Task<'_>,
    touching: &Touching,
    units: Units,
    terms: usize,
    depth: Depth<'_>,
) -> bool {
    let Some(points) = points(task, &touching.strips, units) else { return false };
    let (strips, arch) = (&touching.strips[..], Arch::new());
    let places: Vec<[f64; 2]> = points.into_iter().filter(|[x, y]| depth(*x, *y) > LEAST).collect();
    let displaced = match terms {
        CENTRED => arch.dispatch(Displaced::<1> { strips, places: &places }),
        2 => arch.dispatch(Displaced::<2> { strips, places: &places }),
        4 => arch.dispatch(Displaced::<4> { strips, places: &places }),
        _ => arch.dispatch(Displaced::<MOST> { strips, places: &places }),
    };
    places.iter().zip(displaced).all(|([x, y], by)| depth(*x, *y) - by < LEAST)
}

/// Places beyond the strips where the bodies might touch, in the solver's units; `None` where
/// strips leave the gap's domain.
fn points(task: Task<'_>, strips: &[Strip], units: Units) -> Option<Vec<[f64; 2]>> {
    let reach = task.gap.reach(task.approach)?;
    let inward = |at: f64, k: usize| (at - units.origin[k]) / units.length;
    let [low, high] = reach.y.map(|y| inward(y, 1));
    let [from, to] = reach.x.map(|x| inward(x, 0));
    let known = |strip: &Strip| strip.y - strip.width > low && strip.y + strip.width < high;
    let even = |[a, b]: [f64; 2], i: u32, count: u32| a + (b - a) * f64::from(i) / f64::from(count);
    let mut points = Vec::new();
    for y in (0..=ROWS).map(|row| even([low, high], row, ROWS)) {
        match task.gap.parabola(units.origin[1] + y * units.length) {
            Some([_, _, locus]) => points.push([inward(locus, 0), y]),
            None => points.extend((0..=COLUMNS).map(|i| [even([from, to], i, COLUMNS), y])),
        }
    }
    points.retain(|place| !strips.iter().any(|strip| covers(strip, *place)));
    strips.iter().all(known).then_some(points)
}

/// Whether a place lies in a strip, or no further from it than a strip is wide: the outermost ends
/// short of the tip.
fn covers(strip: &Strip, [x, y]: [f64; 2]) -> bool {
    const BESIDE: f64 = 3.0;
    const BEYOND: f64 = 1.05;
    (y - strip.y).abs() <= BESIDE * strip.width && (x - strip.centre).abs() <= BEYOND * strip.half
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
        let rules = &*RULES;
        let mut sums = vec![0.0; self.places.len()];
        for (sum, [x, y]) in sums.iter_mut().zip(self.places) {
            for strip in self.strips {
                let across = y - strip.y;
                let view = View {
                    x: (x - strip.centre) / strip.half,
                    low: (across - strip.width) / strip.half,
                    high: (across + strip.width) / strip.half,
                    own: false,
                };
                let integrals = view.integrals::<T, false>(rules, &strip.pressure);
                let parts = integrals.value.iter().zip(&strip.pressure);
                *sum += strip.half / PI * parts.map(|(value, p)| value * p).sum::<f64>();
            }
        }
        sums
    }
}
