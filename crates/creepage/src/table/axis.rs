//! Axes of a table along `a/b` and along Poisson's ratio, and interpolation over them.

use crate::InvalidValue;

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

/// Nodes that follow each other, and the weights of their values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Window {
    pub(crate) first: usize,
    pub(crate) count: usize,
    /// Of the first `count` nodes; zero beyond.
    pub(crate) weights: [f64; 4],
}

/// What places values along an axis in equal ratios, prepared once.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Logarithms {
    low: f64,
    per_range: f64,
}

impl Window {
    /// One node.
    pub(crate) fn only(node: usize) -> Self {
        Self { first: node, count: 1, weights: [1.0, 0.0, 0.0, 0.0] }
    }

    /// Each node with its weight.
    pub(crate) fn parts(self) -> impl Iterator<Item = (usize, f64)> {
        (self.first..).zip(self.weights).take(self.count)
    }
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

    /// Half-way between the nodes, from 0 to 1 between the ends; of one node itself.
    pub(crate) fn middles(self) -> impl Iterator<Item = f64> + Clone {
        let intervals = self.nodes.saturating_sub(1);
        let middle = move |k: usize| (k as f64 + 0.5) / intervals as f64;
        (0..intervals.max(1)).map(move |k| if intervals == 0 { 0.0 } else { middle(k) })
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

    /// The nodes that count for the value at `share`.
    pub(crate) fn window(self, share: f64) -> Window {
        match self.nodes {
            1 => Window::only(0),
            2 => Window { first: 0, count: 2, weights: [1.0 - share, share, 0.0, 0.0] },
            _ => self.convolution(share),
        }
    }

    /// Cubic convolution (Keys 1981), once differentiable; beyond the ends a parabola goes on.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
    fn convolution(self, share: f64) -> Window {
        let place = share * (self.nodes - 1) as f64;
        // A node, but for rounding: no other counts.
        if (place - place.round()).abs() < 1e-12 {
            return Window::only(place.round() as usize);
        }
        let node = (place.max(0.0) as usize).min(self.nodes - 2);
        let s = place - node as f64;
        let r = 1.0 - s;
        let [p, q, u, v] = [
            -0.5 * s * r * r,
            1.0 + s * s * (1.5 * s - 2.5),
            1.0 + r * r * (1.5 * r - 2.5),
            -0.5 * r * s * s,
        ];
        if node == 0 {
            return Window { first: 0, count: 3, weights: [q + 3.0 * p, u - 3.0 * p, v + p, 0.0] };
        }
        let first = node - 1;
        if node + 2 == self.nodes {
            return Window { first, count: 3, weights: [p + v, q - 3.0 * v, u + 3.0 * v, 0.0] };
        }
        Window { first, count: 4, weights: [p, q, u, v] }
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
    #[inline]
    pub(crate) fn share_geometric(
        self,
        quantity: &'static str,
        value: f64,
        logarithms: Logarithms,
    ) -> Result<f64, InvalidValue> {
        self.check(quantity, value)?;
        let share = || (value.ln() - logarithms.low) * logarithms.per_range;
        Ok(if self.nodes == 1 { 0.0 } else { share() })
    }

    /// Of an axis in equal ratios.
    pub(crate) fn logarithms(self) -> Logarithms {
        Logarithms { low: self.low.ln(), per_range: (self.high / self.low).ln().recip() }
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
        let values: Vec<f64> = axis.shares().map(function).collect();
        axis.window(share).parts().map(|(node, weight)| weight * values[node]).sum()
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
        let share = |value| axis.share_geometric("a_over_b", value, axis.logarithms());
        assert!((share(1.0).unwrap() - 0.5).abs() < 1e-15);
        assert!((axis.geometric(0.5) - 1.0).abs() < 1e-15);
        for wrong in [0.19, 5.1, f64::NAN, f64::INFINITY, -1.0, 0.0] {
            assert_eq!(share(wrong).unwrap_err().quantity, "a_over_b");
        }
        assert!(Axis::fixed(0.28).share_even("poisson", 0.3).is_err());
    }
}
