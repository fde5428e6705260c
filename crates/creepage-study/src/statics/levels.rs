//! Round levels between which a field is shaded alike.

use std::f64::consts::TAU;

use super::StaticsReport;
use crate::format::floor_log10;
use crate::scene::Point;

/// Most levels; there is one band more.
pub(super) const MOST: usize = 7;
/// Rings of equal area, and points on each, that tell the range of the field.
const RINGS: u32 = 25;
const POINTS: u32 = 48;
/// Share of the area below the highest level of a field that has no largest value.
const SHOWN: f64 = 0.9;

impl StaticsReport<'_> {
    /// The field's intensity at `(x/a, y/b)` (Pa).
    pub(super) fn intensity(&self, disc: Point) -> f64 {
        self.field.intensity([disc[0] * self.ellipse.a(), disc[1] * self.ellipse.b()])
    }

    /// Round intensities in ascending order, at most [`MOST`] (Pa).
    pub(super) fn levels(&self) -> Vec<f64> {
        let mut values: Vec<f64> = rings().map(|point| self.intensity(point)).collect();
        values.retain(|value| value.is_finite());
        values.sort_unstable_by(f64::total_cmp);
        // What has a largest value vanishes at the edge.
        let (least, share) = if self.field.is_singular() { (1.0, SHOWN) } else { (0.0, 1.0) };
        match (values.first(), values.get(last(values.len(), share))) {
            (Some(&low), Some(&high)) => round_levels(least * low, high),
            _ => vec![],
        }
    }
}

/// Position of the value below which a share of all lies.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // some thousand values
fn last(count: usize, share: f64) -> usize {
    ((count as f64 * share) as usize).min(count.saturating_sub(1))
}

fn rings() -> impl Iterator<Item = Point> {
    (0..RINGS).flat_map(|ring| {
        let radius = ((f64::from(ring) + 0.5) / f64::from(RINGS)).sqrt();
        (0..POINTS).map(move |k| {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(POINTS)).sin_cos();
            [radius * cos, radius * sin]
        })
    })
}

/// Multiples of a round step strictly between `low` and `high`.
fn round_levels(low: f64, high: f64) -> Vec<f64> {
    let width = (high - low) / MOST as f64;
    if !(width > 0.0 && width > 1e-9 * high) {
        return vec![];
    }
    let power = 10f64.powi(floor_log10(width));
    let steps = [1.0, 2.0, 2.5, 5.0].map(|factor| factor * power);
    let step = steps.into_iter().find(|step| *step >= width).unwrap_or(10.0 * power);
    let first = (low / step).floor() + 1.0;
    (0..MOST).map(|k| (first + k as f64) * step).take_while(|level| *level < high).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn levels_are_few_ascending_and_inside(low in 0.0..1e9_f64, width in 1.0..1e9_f64) {
            let levels = round_levels(low, low + width);
            // Steps are at most 2.5 sevenths of the range, so that two fit at least.
            prop_assert!((2..=MOST).contains(&levels.len()), "{levels:?}");
            prop_assert!(levels.windows(2).all(|pair| pair[0] < pair[1]));
            prop_assert!(levels.iter().all(|level| (low..low + width).contains(level)));
        }
    }

    #[test]
    fn nothing_to_tell_apart_has_no_levels() {
        assert!(round_levels(5.0, 5.0).is_empty());
        assert!(round_levels(0.0, 0.0).is_empty());
    }
}
