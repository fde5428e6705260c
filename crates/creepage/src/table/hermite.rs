//! Hermite interpolation between two nodes from values and slopes.
//!
//! Along an angle, measured by `s` from the middle of an interval, the functions are
//! `1, cos s, sin s, sin 2s`: a force that is linear in the creepage, as all are near zero, depends
//! on the angles as sines and cosines, and is met exactly. Hence slopes do not jump at zero
//! creepage nor on the axis of pure spin, where coordinates break down. And the angle itself is
//! never needed: its sine and cosine, ratios of creepages, are enough.

/// Weights of `[value, slope]` at the nodes before and after, for the value there.
pub(crate) type Weights = [[f64; 2]; 2];

/// Nodes on an angle between two right angles, the last `wide` intervals twice as wide as others.
#[derive(Debug, Clone)]
pub(crate) struct Angle {
    nodes: Vec<f64>,
    intervals: Vec<Interval>,
    /// Of each node: slope of the function from its values there and three nodes either way.
    stencils: Vec<[f64; 7]>,
    per_step: f64,
    /// Number of intervals that are not wide.
    narrow: f64,
}

/// What weights of an interval depend on.
#[derive(Debug, Clone, Copy)]
struct Interval {
    /// Sine and cosine of the middle.
    middle: [f64; 2],
    /// Cosine of half the width.
    cos_half: f64,
    /// With `S` and `C` sine and cosine of half the width: `1/2S`, `C/2S^3` and `1/2S^2`.
    closing: [f64; 3],
}

impl Angle {
    pub(crate) fn new([first, last]: [f64; 2], intervals: usize, wide: usize) -> Self {
        let step = (last - first) / (intervals + wide) as f64;
        let narrow = intervals - wide;
        let node = |k: usize| first + step * (k + k.saturating_sub(narrow)) as f64;
        let nodes: Vec<f64> = (0..=intervals).map(node).collect();
        let beyond = |k: usize, offset: isize| {
            let (inside, outside) = reflect(k.cast_signed() + offset, intervals);
            let end = if offset < 0 { nodes[0] } else { nodes[intervals] };
            if outside { 2.0 * end - nodes[inside] } else { nodes[inside] }
        };
        let around = |k| [-3, -2, -1, 0, 1, 2, 3].map(|offset| beyond(k, offset));
        Self {
            intervals: nodes.windows(2).map(|ends| Interval::new(ends[0], ends[1])).collect(),
            stencils: (0..=intervals).map(|k| stencil(around(k))).collect(),
            nodes,
            per_step: step.recip(),
            narrow: narrow as f64,
        }
    }

    pub(crate) fn node(&self, index: usize) -> f64 {
        self.nodes[index]
    }

    /// Slope at a node from the values there and three nodes either way.
    pub(crate) fn slope(&self, node: usize, values: [f64; 7]) -> f64 {
        self.stencils[node].iter().zip(values).map(|(weight, value)| weight * value).sum()
    }

    /// The node before the angle of this sine and cosine, weights of the value and of the slope
    /// there.
    #[inline]
    pub(crate) fn weights(&self, [sin, cos]: [f64; 2]) -> (usize, Weights, Weights) {
        let place = (rough_angle(sin, cos) - self.nodes[0]) * self.per_step;
        let wide = 0.5 * (place - self.narrow).max(0.0);
        let index = cell(place - wide, self.intervals.len());
        let Interval { middle, cos_half, closing } = self.intervals[index];
        let z = sin * middle[1] - cos * middle[0];
        let c = cos * middle[1] + sin * middle[0];
        // Zero at the nodes; `odd` is a half there, with slope zero, and minus a half.
        let q = c - cos_half;
        let (bow, bow_slope) = (z * q, c * q - z * z);
        let [k1, k2, k3] = closing;
        let (odd, odd_slope) = (k1 * z + k2 * bow, k1 * c + k2 * bow_slope);
        (
            index,
            [[0.5 - odd, k1 * q - k3 * bow], [0.5 + odd, -k1 * q - k3 * bow]],
            [[-odd_slope, -k1 * z - k3 * bow_slope], [odd_slope, k1 * z - k3 * bow_slope]],
        )
    }
}

impl Interval {
    fn new(first: f64, last: f64) -> Self {
        let (sin, cos) = (0.5 * (last - first)).sin_cos();
        let closing = [0.5 / sin, 0.5 * cos / (sin * sin * sin), 0.5 / (sin * sin)];
        Self { middle: (0.5 * (first + last)).sin_cos().into(), cos_half: cos, closing }
    }
}

/// An index reflected into `0..=last`, and whether it was outside.
pub(crate) fn reflect(index: isize, last: usize) -> (usize, bool) {
    let last = last.cast_signed();
    let inside = if index > last { 2 * last - index } else { index.abs() };
    (inside.unsigned_abs(), inside != index)
}

/// Weights of the slope in the middle of seven nodes: that of the trigonometric polynomial of
/// degree three through their values, in the form of Lagrange and Gauss.
fn stencil(nodes: [f64; 7]) -> [f64; 7] {
    let half_sine = |j: usize, m: usize| (0.5 * (nodes[j] - nodes[m])).sin();
    let others = |j: usize| (0..7).filter(move |m| *m != j);
    [0, 1, 2, 3, 4, 5, 6].map(|j| {
        if j == 3 {
            return others(3).map(|m| 0.5 / (0.5 * (nodes[3] - nodes[m])).tan()).sum();
        }
        let above: f64 = others(j).filter(|m| *m != 3).map(|m| half_sine(3, m)).product();
        let below: f64 = others(j).map(|m| half_sine(j, m)).product();
        0.5 * above / below
    })
}

/// The angle to 2e-5 (Abramowitz, Stegun 4.4.49 for half of it), near enough to find its interval:
/// an interpolation goes on smoothly so little beyond its end.
#[inline]
fn rough_angle(sin: f64, cos: f64) -> f64 {
    let half = sin / (1.0 + cos);
    let x = half * half;
    let series = 0.180_141 + x * (-0.085_133 + x * 0.020_835_1);
    2.0 * half * (0.999_866 + x * (-0.330_299_5 + x * series))
}

/// Cubic weights on `intervals` of [0, 1]: the node before, for the value and for the slope.
#[inline]
pub(crate) fn cubic(t: f64, intervals: usize) -> (usize, Weights, Weights) {
    let count = intervals as f64;
    let index = cell(t * count, intervals);
    let s = t * count - index as f64;
    let rest = 1.0 - s;
    let (start, end) = (rest * rest * (1.0 + 2.0 * s), s * s * (3.0 - 2.0 * s));
    let step = count.recip();
    let change = 6.0 * s * rest * count;
    (
        index,
        [[start, rest * rest * s * step], [end, -s * s * rest * step]],
        [[-change, rest * (1.0 - 3.0 * s)], [change, s * (3.0 * s - 2.0)]],
    )
}

/// The interval of a place given in intervals.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // not negative
fn cell(place: f64, intervals: usize) -> usize {
    (place.max(0.0) as usize).min(intervals - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    type Function = fn(f64) -> f64;

    fn interpolated(weights: &Weights, nodes: [[f64; 2]; 2]) -> f64 {
        (0..2).map(|i| weights[i][0] * nodes[i][0] + weights[i][1] * nodes[i][1]).sum()
    }

    /// To rounding, amplified by `step^-3`.
    #[test]
    fn sines_and_cosines_are_met_exactly() {
        let angle = Angle::new([-1.0, 1.5], 12, 3);
        let known: [(Function, Function); 3] =
            [(|_| 1.0, |_| 0.0), (f64::sin, f64::cos), (f64::cos, |s| -s.sin())];
        for (function, slope) in known {
            for s in [-1.0, -0.93, 0.4, 1.31, 1.5_f64] {
                let (node, value, change) = angle.weights(s.sin_cos().into());
                let at = [node, node + 1].map(|k| angle.node(k));
                let nodes = at.map(|s| [function(s), slope(s)]);
                assert!((interpolated(&value, nodes) - function(s)).abs() < 1e-12);
                assert!((interpolated(&change, nodes) - slope(s)).abs() < 1e-11);
            }
        }
    }

    /// Sixth order: exact up to the third harmonic, to rounding over the step.
    #[test]
    fn slopes_of_three_harmonics_are_met_exactly() {
        for (intervals, wide) in [(8, 0), (16, 4), (400, 100)] {
            let angle = Angle::new([0.0, std::f64::consts::FRAC_PI_2], intervals, wide);
            for node in [3, intervals / 2, intervals - 3] {
                for harmonic in [1.0, 2.0, 3.0] {
                    let value = |k: usize| (harmonic * angle.node(node + k - 3) + 0.3).sin();
                    let found = angle.slope(node, [0, 1, 2, 3, 4, 5, 6].map(value));
                    let right = harmonic * (harmonic * angle.node(node) + 0.3).cos();
                    assert!((found - right).abs() < 1e-12 * angle.per_step, "{found} {right}");
                }
            }
        }
    }

    /// In the interval of the angle, or so little beside it that it does not matter.
    #[test]
    fn an_angle_is_found_by_its_sine_and_cosine() {
        let quarter = std::f64::consts::FRAC_PI_2;
        for k in 0..=1000 {
            let angle = quarter * (f64::from(k) / 500.0 - 1.0);
            let (sin, cos) = angle.sin_cos();
            assert!((rough_angle(sin, cos) - angle).abs() < 2.5e-5, "{angle}");
        }
    }

    #[test]
    fn cubics_are_met_exactly() {
        let (function, slope): (Function, Function) =
            (|t| t * t * (t - 0.3), |t| t * (3.0 * t - 0.6));
        for t in [0.0, 0.13, 0.5, 0.99, 1.0] {
            let (node, value, change) = cubic(t, 7);
            let nodes = [node, node + 1].map(|k| k as f64 / 7.0).map(|t| [function(t), slope(t)]);
            assert!((interpolated(&value, nodes) - function(t)).abs() < 1e-14);
            assert!((interpolated(&change, nodes) - slope(t)).abs() < 1e-13);
        }
    }
}
