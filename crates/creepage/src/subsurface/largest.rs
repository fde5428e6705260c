//! Search for the largest value of a measure of stress in a block, and its place.

use rayon::prelude::*;

use super::interior::Interior;
use super::stress::Stress;
use crate::check::{self, InvalidValue};

/// Points of the first look at each side of the block.
const SCAN_POINTS: usize = 9;
/// How many of the best of them are looked at closer.
const FOLLOWED: usize = 3;
/// Points of a closer look, either way along each axis.
const REFINED_REACH: i32 = 2;
/// Closer looks, each of half the size.
const REFINEMENTS: usize = 18;

/// The largest value of a measure and its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Largest {
    /// The value.
    pub value: f64,
    /// `[x, y, z]`, `z` into the body.
    pub point: [f64; 3],
    /// The stress there.
    pub stress: Stress,
}

/// The largest `measure` in the block from `low` to `high`, `[x, y, z]` each: a look at points that
/// crowd towards the surface, then ever closer looks at the best of them, to `1e-6` of the block. On
/// the sharp ridge that runs along the edge of a sliding contact, at the surface, the value is right
/// to some 1e-3.
///
/// Points are computed on all cores; the result does not depend on how many there are. It is the largest
/// for fields with hills wider than an eighth of the block, such as those below
/// a contact as wide as the block.
///
/// # Errors
/// [`InvalidValue`] unless the block is finite, in the body, and `low <= high`.
pub fn largest(
    interior: &Interior,
    [low, high]: [[f64; 3]; 2],
    measure: impl Fn(&Stress) -> f64 + Sync,
) -> Result<Largest, InvalidValue> {
    for axis in 0..3 {
        check::finite("low", low[axis])?;
        let valid = "finite and not below the low end of the block";
        check::require(
            high[axis].is_finite() && high[axis] >= low[axis],
            "high",
            high[axis],
            valid,
        )?;
    }
    let of = |point: [f64; 3], stress: Stress| Largest { value: measure(&stress), point, stress };
    let quick = |point: [f64; 3]| Ok(of(point, interior.at(point)?.stress));
    let at = |point: [f64; 3]| Ok(of(point, interior.stress(point)?));
    let side = |axis: usize, k: usize| {
        let t = k as f64 / (SCAN_POINTS - 1) as f64;
        low[axis] + (high[axis] - low[axis]) * if axis == 2 { t * t } else { t }
    };
    let first = (0..SCAN_POINTS.pow(3)).into_par_iter().map(|k| {
        let place = [k % SCAN_POINTS, k / SCAN_POINTS % SCAN_POINTS, k / SCAN_POINTS.pow(2)];
        quick([0, 1, 2].map(|axis| side(axis, place[axis])))
    });
    let mut seen = first.collect::<Result<Vec<_>, _>>()?;
    seen.sort_by(|one, two| two.value.total_cmp(&one.value));
    // Elements far away are taken together until it is known which hill is the highest.
    let (mut first, mut best) = (seen[0], seen[0]);
    for start in seen.into_iter().take(FOLLOWED) {
        let top = refine_maximum(start, [low, high], &quick)?;
        if top.value > best.value {
            (first, best) = (start, top);
        }
    }
    refine_maximum(at(first.point)?, [low, high], &at)
}

/// Looks at the points around the best, and again around the best of these at half the distance.
fn refine_maximum(
    start: Largest,
    [low, high]: [[f64; 3]; 2],
    at: &(impl Fn([f64; 3]) -> Result<Largest, InvalidValue> + Sync),
) -> Result<Largest, InvalidValue> {
    let (mut best, mut step) = (start, 0.5 / (SCAN_POINTS - 1) as f64);
    let side = 2 * REFINED_REACH + 1;
    for _ in 0..REFINEMENTS {
        let centre = best.point;
        let around = (0..side.pow(3)).into_par_iter().map(|k| {
            let place = [k % side, k / side % side, k / side.pow(2)];
            at([0, 1, 2].map(|axis| {
                let moved =
                    f64::from(place[axis] - REFINED_REACH) * step * (high[axis] - low[axis]);
                (centre[axis] + moved).clamp(low[axis], high[axis])
            }))
        });
        for next in around.collect::<Result<Vec<_>, _>>()? {
            if next.value > best.value {
                best = next;
            }
        }
        step *= 0.5;
    }
    Ok(best)
}
