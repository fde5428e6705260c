//! Interpolation between two nodes from values and slopes.
//!
//! Along an angle the functions are `1, s, sin s, cos s`: a force that is linear in the creepage,
//! as all are near zero, depends on the angles as sines and cosines, and is met exactly. Hence
//! slopes do not jump at zero creepage nor on the axis of pure spin, where coordinates break down.

/// Weights of `[value, slope]` at the nodes before and after, for the value there.
pub(crate) type Weights = [[f64; 2]; 2];

/// Evenly spaced nodes on an angle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Angle {
    first: f64,
    step: f64,
    per_step: f64,
    intervals: usize,
    /// Slope of the function by a difference of its neighbours at one and at two steps.
    stencil: [f64; 2],
    /// What `1 - cos s` and `s - sin s` add for the value at the end, for the slope at the start
    /// and for the slope at the end.
    closing: [[f64; 2]; 3],
}

impl Angle {
    pub(crate) fn new([first, last]: [f64; 2], intervals: usize) -> Self {
        let step = (last - first) / intervals as f64;
        let (sin, cos) = step.sin_cos();
        let [v, w] = remainders(step);
        let [_, double] = remainders(2.0 * step);
        // Exact for s and for sin s: 2 p h + 4 q h = 1, 2 p sin h + 2 q sin 2h = 1.
        let q = -w / (2.0 * step * (double - 2.0 * w));
        let p = 0.5 / step - 2.0 * q;
        // p0 + m0 sin s + c (1 - cos s) + d (s - sin s), with c and d from the end.
        let determinant = v * v - w * sin;
        let factors = |value: f64, slope: f64| {
            [(value * v - slope * w) / determinant, (slope * v - value * sin) / determinant]
        };
        let closing = [factors(1.0, 0.0), factors(-sin, -cos), factors(0.0, 1.0)];
        Self { first, step, per_step: step.recip(), intervals, stencil: [p, q], closing }
    }

    pub(crate) fn node(&self, index: usize) -> f64 {
        self.first + self.step * index as f64
    }

    /// Slope at a node from the values one and two steps ahead and behind.
    pub(crate) fn slope(&self, behind: [f64; 2], ahead: [f64; 2]) -> f64 {
        self.stencil[0] * (ahead[0] - behind[0]) + self.stencil[1] * (ahead[1] - behind[1])
    }

    /// The node before `angle`, weights of the value and of the slope there.
    pub(crate) fn weights(&self, angle: f64) -> (usize, Weights, Weights) {
        let (index, s) = cell((angle - self.first) * self.per_step, self.intervals);
        let s = s * self.step;
        let [v, w] = remainders(s);
        let (sin, cos) = (s - w, 1.0 - v);
        let [end, start_slope, end_slope] = self.closing;
        let value = |[c, d]: [f64; 2]| c * v + d * w;
        let slope = |[c, d]: [f64; 2]| c * sin + d * v;
        (
            index,
            [[1.0 - value(end), sin + value(start_slope)], [value(end), value(end_slope)]],
            [[-slope(end), cos + slope(start_slope)], [slope(end), slope(end_slope)]],
        )
    }
}

/// `1 - cos s` and `s - sin s` by their series, without cancellation; to rounding up to a right
/// angle, and no slower than sine and cosine.
fn remainders(s: f64) -> [f64; 2] {
    /// One over the product of each number and the next.
    const EVEN: [f64; 8] = [
        1.0 / 12.0,
        1.0 / 30.0,
        1.0 / 56.0,
        1.0 / 90.0,
        1.0 / 132.0,
        1.0 / 182.0,
        1.0 / 240.0,
        1.0 / 306.0,
    ];
    const ODD: [f64; 8] = [
        1.0 / 20.0,
        1.0 / 42.0,
        1.0 / 72.0,
        1.0 / 110.0,
        1.0 / 156.0,
        1.0 / 210.0,
        1.0 / 272.0,
        1.0 / 342.0,
    ];
    let x = s * s;
    let series = |terms: [f64; 8]| terms.iter().rev().fold(1.0, |sum, term| 1.0 - x * term * sum);
    [0.5 * x * series(EVEN), s * x * (1.0 / 6.0) * series(ODD)]
}

/// Cubic weights on `intervals` of [0, 1]: the node before, for the value and for the slope.
pub(crate) fn cubic(t: f64, intervals: usize) -> (usize, Weights, Weights) {
    let count = intervals as f64;
    let (index, s) = cell(t * count, intervals);
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

/// The interval of a place given in intervals, and the place within it.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // not negative
fn cell(place: f64, intervals: usize) -> (usize, f64) {
    let index = (place.max(0.0) as usize).min(intervals - 1);
    (index, place - index as f64)
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
    fn sines_and_lines_are_met_exactly() {
        let angle = Angle::new([-1.0, 1.5], 12);
        let known: [(Function, Function); 4] =
            [(|_| 1.0, |_| 0.0), (|s| s, |_| 1.0), (f64::sin, f64::cos), (f64::cos, |s| -s.sin())];
        for (function, slope) in known {
            for s in [-1.0, -0.93, 0.4, 1.31, 1.5] {
                let (node, value, change) = angle.weights(s);
                let at = [node, node + 1].map(|k| angle.node(k));
                let nodes = at.map(|s| [function(s), slope(s)]);
                assert!((interpolated(&value, nodes) - function(s)).abs() < 1e-11);
                assert!((interpolated(&change, nodes) - slope(s)).abs() < 1e-10);
                let side = |k: f64| function(at[0] + k * angle.step);
                let found = angle.slope([side(-1.0), side(-2.0)], [side(1.0), side(2.0)]);
                assert!((found - slope(at[0])).abs() < 1e-11);
            }
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
