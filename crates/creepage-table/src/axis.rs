//! The nodes along `a/b` and along Poisson's ratio, and interpolation over them.

use creepage::InvalidValue;

/// Nodes from one value to another: along `a/b` in equal ratios, along Poisson's ratio evenly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// First node.
    pub low: f64,
    /// Last node.
    pub high: f64,
    /// Number of nodes; one for a fixed value, then `low` and `high` are the same.
    pub nodes: usize,
}

impl Axis {
    /// Just one value.
    #[must_use]
    pub fn fixed(value: f64) -> Self {
        Self { low: value, high: value, nodes: 1 }
    }

    /// The value at a node, from 0 to 1 between the ends.
    pub(crate) fn shares(self) -> impl Iterator<Item = f64> {
        let last = (self.nodes - 1).max(1) as f64;
        (0..self.nodes).map(move |k| k as f64 / last)
    }

    /// A value between the ends, in equal steps.
    pub(crate) fn even(self, share: f64) -> f64 {
        self.low + share * (self.high - self.low)
    }

    /// A value between the ends, in equal ratios.
    pub(crate) fn geometric(self, share: f64) -> f64 {
        if share >= 1.0 {
            self.high
        } else {
            self.low * (share * (self.high / self.low).ln()).exp()
        }
    }

    /// Nodes and their weights for the value at `share`.
    pub(crate) fn weights(self, share: f64) -> ([usize; 4], [f64; 4]) {
        match self.nodes {
            1 => ([0; 4], [1.0, 0.0, 0.0, 0.0]),
            2 => ([0, 1, 0, 0], [1.0 - share, share, 0.0, 0.0]),
            _ => self.convolution(share),
        }
    }

    /// Cubic convolution (Keys 1981), once differentiable; beyond the ends a parabola goes on.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
    fn convolution(self, share: f64) -> ([usize; 4], [f64; 4]) {
        let place = share * (self.nodes - 1) as f64;
        let cell = place.floor().clamp(0.0, (self.nodes - 2) as f64);
        let (s, first) = (place - cell, cell as usize);
        let r = 1.0 - s;
        let [p, q, u, v] = [
            -0.5 * s * r * r,
            1.0 + s * s * (1.5 * s - 2.5),
            1.0 + r * r * (1.5 * r - 2.5),
            -0.5 * r * s * s,
        ];
        if first == 0 && self.nodes == 3 {
            return ([0, 1, 2, 0], [q + 3.0 * p, u - 3.0 * p, v + p, 0.0]);
        }
        if first == 0 {
            return ([0, 1, 2, 3], [q + 3.0 * p, u - 3.0 * p, v + p, 0.0]);
        }
        if first + 2 == self.nodes {
            let back = first - 1;
            return ([back, first, first + 1, first], [p + v, q - 3.0 * v, u + 3.0 * v, 0.0]);
        }
        ([first - 1, first, first + 1, first + 2], [p, q, u, v])
    }

    /// Where `value` lies between the ends, in equal steps.
    pub(crate) fn share_even(
        self,
        quantity: &'static str,
        value: f64,
    ) -> Result<f64, InvalidValue> {
        self.check(quantity, value)?;
        Ok(if self.nodes == 1 { 0.0 } else { (value - self.low) / (self.high - self.low) })
    }

    /// Where `value` lies between the ends, in equal ratios.
    pub(crate) fn share_geometric(
        self,
        quantity: &'static str,
        value: f64,
    ) -> Result<f64, InvalidValue> {
        self.check(quantity, value)?;
        let share = || (value / self.low).ln() / (self.high / self.low).ln();
        Ok(if self.nodes == 1 { 0.0 } else { share() })
    }

    fn check(self, quantity: &'static str, value: f64) -> Result<(), InvalidValue> {
        // Rounding on the way here is not another value.
        let slack = 1e-9 * self.high;
        if (self.low - slack..=self.high + slack).contains(&value) {
            return Ok(());
        }
        Err(InvalidValue { quantity, value, valid: "within the range of the table" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn interpolated(axis: Axis, share: f64, function: impl Fn(f64) -> f64) -> f64 {
        let (nodes, weights) = axis.weights(share);
        let values: Vec<f64> = axis.shares().map(function).collect();
        (0..4).map(|k| weights[k] * values[nodes[k]]).sum()
    }

    #[test]
    fn parabolas_are_met_exactly_and_lines_by_two_nodes() {
        for nodes in [2, 3, 4, 9] {
            let axis = Axis { low: 0.2, high: 5.0, nodes };
            let square = if nodes > 2 { 1.0 } else { 0.0 };
            let function = |x: f64| 0.3 - x + square * x * x;
            for share in [0.0, 0.03, 0.4, 0.77, 1.0] {
                assert!((interpolated(axis, share, function) - function(share)).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn only_values_of_the_range_have_a_place() {
        let axis = Axis { low: 0.2, high: 5.0, nodes: 7 };
        assert!((axis.share_geometric("a_over_b", 1.0).unwrap() - 0.5).abs() < 1e-15);
        assert!((axis.geometric(0.5) - 1.0).abs() < 1e-15);
        for wrong in [0.19, 5.1, f64::NAN, f64::INFINITY, -1.0, 0.0] {
            assert_eq!(axis.share_geometric("a_over_b", wrong).unwrap_err().quantity, "a_over_b");
        }
        assert!(Axis::fixed(0.28).share_even("poisson", 0.3).is_err());
    }
}
