//! Displacement under a rectangle of constant pressure (Love 1929).

/// Displacements at the centres of a lattice, by how many columns and rows they lie from a
/// rectangle of unit pressure: `1/pi` times the integral of `1/distance`, in the steps' unit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Love {
    columns: usize,
    values: Vec<f64>,
}

impl Love {
    /// For a lattice of the given steps and numbers of cells.
    pub(super) fn new(step: [f64; 2], [columns, rows]: [usize; 2]) -> Self {
        let corner = |i: usize, j: usize| {
            let place = |k: usize, step: f64| (k as f64 - 0.5) * step;
            corner(place(i, step[0]), place(j, step[1]))
        };
        let corners: Vec<f64> =
            (0..=rows).flat_map(|j| (0..=columns).map(move |i| corner(i, j))).collect();
        let at = |i: usize, j: usize| corners[j * (columns + 1) + i];
        let sum = |i, j| at(i + 1, j + 1) - at(i, j + 1) - at(i + 1, j) + at(i, j);
        let values = (0..rows)
            .flat_map(|j| (0..columns).map(move |i| sum(i, j) / std::f64::consts::PI))
            .collect();
        Self { columns, values }
    }

    /// The displacement `i` columns and `j` rows away.
    pub(super) fn at(&self, i: usize, j: usize) -> f64 {
        self.values[j * self.columns + i]
    }
}

/// `x asinh(y/|x|) + y asinh(x/|y|)`: Love's `x ln(y+r) + y ln(x+r)` without the terms that
/// cancel between corners; no digits are lost on the side of negative x or y.
fn corner(x: f64, y: f64) -> f64 {
    x * (y / x.abs()).asinh() + y * (x / y.abs()).asinh()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_displaces_its_own_centre_by_the_closed_form() {
        let own = Love::new([2.0, 2.0], [1, 1]).at(0, 0);
        let expected = 8.0 * 1.0_f64.asinh() / std::f64::consts::PI;
        assert!((own - expected).abs() < 1e-14);
    }

    #[test]
    fn far_away_a_rectangle_acts_as_a_point() {
        let love = Love::new([1.0, 0.5], [60, 80]);
        for (i, j) in [(50, 0), (0, 79), (40, 60)] {
            let (x, y) = (i as f64, 0.5 * j as f64);
            let point = 0.5 / (std::f64::consts::PI * x.hypot(y));
            assert!((love.at(i, j) / point - 1.0).abs() < 1e-4, "{i} {j}");
        }
    }
}
