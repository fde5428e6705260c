//! The largest of a measure of stress in a block, and where it sits.

use super::interior::Interior;
use super::stress::Stress;
use crate::check::{self, InvalidValue};

/// Points of the first look at each side of the block.
const POINTS: usize = 9;
/// How many of the best of them are followed uphill.
const FOLLOWED: usize = 4;

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
/// crowd towards the surface, then a climb from the best of them, to `1e-6` of the block.
///
/// It is the largest for fields with hills wider than an eighth of the block, such as those below
/// a contact as wide as the block.
///
/// # Errors
/// [`InvalidValue`] unless the block is finite, in the body, and `low <= high`.
pub fn largest(
    interior: &Interior,
    [low, high]: [[f64; 3]; 2],
    measure: impl Fn(&Stress) -> f64,
) -> Result<Largest, InvalidValue> {
    for axis in 0..3 {
        check::finite("low", low[axis])?;
        let valid = "finite and not below the low end of the block";
        check::require(high[axis].is_finite() && high[axis] >= low[axis], "high", high[axis], valid)?;
    }
    let at = |point: [f64; 3]| -> Result<Largest, InvalidValue> {
        let stress = interior.stress(point)?;
        Ok(Largest { value: measure(&stress), point, stress })
    };
    let side = |axis: usize, k: usize| {
        let t = k as f64 / (POINTS - 1) as f64;
        low[axis] + (high[axis] - low[axis]) * if axis == 2 { t * t } else { t }
    };
    let mut seen = Vec::with_capacity(POINTS.pow(3));
    for k in 0..POINTS.pow(3) {
        let place = [k % POINTS, k / POINTS % POINTS, k / POINTS.pow(2)];
        seen.push(at([0, 1, 2].map(|axis| side(axis, place[axis])))?);
    }
    seen.sort_by(|one, two| two.value.total_cmp(&one.value));
    let mut best = seen[0];
    for start in seen.into_iter().take(FOLLOWED) {
        let top = climb(start, [low, high], &at)?;
        if top.value > best.value {
            best = top;
        }
    }
    Ok(best)
}

/// Steps along the axes, halved when none leads up.
fn climb(
    start: Largest,
    [low, high]: [[f64; 3]; 2],
    at: &impl Fn([f64; 3]) -> Result<Largest, InvalidValue>,
) -> Result<Largest, InvalidValue> {
    let (mut best, mut step) = (start, 0.5 / (POINTS - 1) as f64);
    while step > 5e-7 {
        let before = best.value;
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let mut point = best.point;
                let moved = point[axis] + sign * step * (high[axis] - low[axis]);
                point[axis] = moved.clamp(low[axis], high[axis]);
                let next = at(point)?;
                if next.value > best.value {
                    best = next;
                }
            }
        }
        if best.value <= before {
            step *= 0.5;
        }
    }
    Ok(best)
}
