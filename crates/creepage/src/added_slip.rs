//! Rigid slip that differs from place to place, beside creepage and spin.

use crate::gap::{GapError, in_rows};

/// Rigid slip of the upper body relative to the lower over the rolling velocity, at the places of a contact: added
/// to that of creepage and spin, as surfaces have it whose rolling radius or direction is not the same everywhere.
///
/// It stands still in the contact while the bodies roll through it. Between the points of its grid it is linear in
/// each coordinate, and goes on unchanged beyond them. It does nothing in a shift, which is no rolling.
///
/// ```
/// use creepage::AddedSlip;
/// // Faster outside, as of a wheel whose tread is hollow: places (m), then slips along and across.
/// let slip = AddedSlip::new(&[[0.0, -0.01, 1e-3, 0.0], [0.0, 0.0, 0.0, 0.0], [0.0, 0.01, 1e-3, 0.0]])?;
/// assert_eq!(slip.at(0.002, 0.005), [5e-4, 0.0]);
/// assert_eq!(slip.at(0.0, 0.03), [1e-3, 0.0]);
/// # Ok::<(), creepage::gap::GapError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct AddedSlip {
    x: Vec<f64>,
    y: Vec<f64>,
    /// In rows of one `y`.
    slips: Vec<[f64; 2]>,
}

impl AddedSlip {
    /// By the points `[x, y, along, across]` of a rectangular grid, in any order: places from the origin of the
    /// contact (m), slips over the rolling velocity.
    ///
    /// # Errors
    /// [`GapError`] for numbers that are not finite, no points, and points that are no such grid.
    pub fn new(points: &[[f64; 4]]) -> Result<Self, GapError> {
        let part = |k: usize| -> Vec<_> { points.iter().map(|p| [p[0], p[1], p[k]]).collect() };
        let [x, y, along] = in_rows(&part(2), "longitudinal", 1)?;
        let [_, _, across] = in_rows(&part(3), "lateral", 1)?;
        let slips = along.into_iter().zip(across).map(|(along, across)| [along, across]).collect();
        Ok(Self { x, y, slips })
    }

    /// The slip at a place (m).
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> [f64; 2] {
        let (columns, rows) = (between(&self.x, x), between(&self.y, y));
        let mut sum = [0.0; 2];
        for (row, by_row) in rows {
            for (column, by_column) in columns {
                let [along, across] =
                    self.slips.get(row * self.x.len() + column).copied().unwrap_or_default();
                sum[0] += by_row * by_column * along;
                sum[1] += by_row * by_column * across;
            }
        }
        sum
    }

    /// First and last place of its points along `x` and along `y` (m).
    #[must_use]
    pub fn extent(&self) -> [[f64; 2]; 2] {
        [&self.x, &self.y].map(|places| [places[0], places[places.len() - 1]])
    }

    /// The largest size of the slip.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.slips.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max)
    }
}

/// The two values about a place, by their indices with their weights.
fn between(values: &[f64], at: f64) -> [(usize, f64); 2] {
    let above = values.partition_point(|value| *value <= at).min(values.len().saturating_sub(1));
    let below = above.saturating_sub(1);
    let (Some(low), Some(high)) = (values.get(below), values.get(above)) else {
        return [(0, 0.0); 2];
    };
    let part = if high > low { ((at - low) / (high - low)).clamp(0.0, 1.0) } else { 0.0 };
    [(below, 1.0 - part), (above, part)]
}

#[cfg(test)]
// What stands at a point, or beyond the last one, is given back as it is.
#[allow(clippy::float_cmp)]
mod tests {
    use super::*;

    #[test]
    fn a_bilinear_slip_is_itself_between_its_points() {
        let slip = |x: f64, y: f64| [1.0 + 2.0 * x - y + 3.0 * x * y, x];
        let mut points = Vec::new();
        for x in [-1.0, 0.2, 0.5, 2.0] {
            for y in [-0.7, 0.1, 1.0] {
                let [along, across] = slip(x, y);
                points.push([x, y, along, across]);
            }
        }
        points.reverse();
        let added = AddedSlip::new(&points).unwrap();
        for (x, y) in [(-1.0, -0.7), (0.0, 0.0), (1.9, 0.99), (2.0, 1.0), (0.3, -0.5)] {
            let (found, expected) = (added.at(x, y), slip(x, y));
            for k in 0..2 {
                // A handful of roundings.
                assert!((found[k] - expected[k]).abs() < 1e-14, "{x} {y}: {found:?}");
            }
        }
        assert_eq!(added.at(5.0, 4.0), added.at(2.0, 1.0));
        assert_eq!(AddedSlip::new(&[[0.0, 0.0, 1e-3, 2e-3]]).unwrap().at(1.0, -1.0), [1e-3, 2e-3]);
    }

    #[test]
    fn what_is_no_grid_is_told() {
        let of = |points: &[[f64; 4]]| AddedSlip::new(points).unwrap_err().to_string();
        assert!(of(&[]).contains("at least 1"), "{}", of(&[]));
        assert!(of(&[[0.0, 0.0, f64::NAN, 0.0]]).starts_with("longitudinal"));
        assert!(of(&[[0.0, 0.0, 0.0, f64::INFINITY]]).starts_with("lateral"));
        assert!(of(&[[0.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0]]).contains("no point at"));
    }
}
