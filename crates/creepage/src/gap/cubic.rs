//! Piecewise cubics with continuous slope through points on a line.
//!
//! The slope at a point is a weighted mean of the slopes of the three parabolas through it and
//! its neighbours. On smooth data the weights are those of the five-point formula, so values are
//! accurate to fourth order. A parabola across a kink bends much more than those two points to
//! either side; it loses its weight, so a kink stays within the intervals next to it and does not
//! ring. A step of curvature, as between two arcs, is no such case.

/// A curve through points of increasing abscissa; beyond them the outer parabolas continue it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Cubic {
    x: Vec<f64>,
    value: Vec<f64>,
    slope: Vec<f64>,
}

impl Cubic {
    /// `x` increases strictly and is as long as `value`.
    pub(crate) fn new(x: Vec<f64>, value: Vec<f64>) -> Self {
        let slope = slopes(&x, &value);
        Self { x, value, slope }
    }

    pub(crate) fn at(&self, x: f64) -> f64 {
        let Some(last) = self.x.len().checked_sub(1) else { return f64::NAN };
        if last == 0 {
            return self.value[0];
        }
        self.in_cell(&Cell::new(&self.x, x))
    }

    /// At a place in a cell of its own abscissae.
    pub(super) fn in_cell(&self, cell: &Cell) -> f64 {
        let (low, high) = (cell.index, cell.index + 1);
        cell.mix([self.value[low], self.value[high]], [self.slope[low], self.slope[high]])
    }
}

impl Cubic {
    /// Its value, where that is the same everywhere but for rounding of lengths like the abscissae.
    pub(super) fn constant(&self) -> Option<f64> {
        const ROUNDING: f64 = 1e-13;
        let (first, span) = (*self.value.first()?, self.x.last()? - self.x.first()?);
        let is_same = |value: &f64| (value - first).abs() <= ROUNDING * span;
        self.value.iter().all(is_same).then_some(first)
    }
}

/// A place inside one interval of the abscissae: the weights of values and slopes there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    pub(super) index: usize,
    values: [f64; 2],
    slopes: [f64; 2],
}

impl Cell {
    /// There must be two abscissae or more.
    pub(super) fn new(abscissae: &[f64], x: f64) -> Self {
        let last = abscissae.len() - 2;
        let index = abscissae.partition_point(|&a| a <= x).saturating_sub(1).min(last);
        let (low, width) = (abscissae[index], abscissae[index + 1] - abscissae[index]);
        let t = (x - low) / width;
        let (values, slopes) = if t < 0.0 {
            mirrored(beyond(1.0 - t))
        } else if t > 1.0 {
            beyond(t)
        } else {
            let rise = t * t * (3.0 - 2.0 * t);
            ([1.0 - rise, rise], [t * (1.0 - t) * (1.0 - t), t * t * (t - 1.0)])
        };
        Self { index, values, slopes: slopes.map(|s| s * width) }
    }

    pub(super) fn mix(&self, value: [f64; 2], slope: [f64; 2]) -> f64 {
        self.values[0] * value[0]
            + self.values[1] * value[1]
            + self.slopes[0] * slope[0]
            + self.slopes[1] * slope[1]
    }
}

/// Weights beyond the upper end, `t > 1`: value, slope and curvature go on.
fn beyond(t: f64) -> ([f64; 2], [f64; 2]) {
    let d = t - 1.0;
    let half = 0.5 * d * d;
    ([6.0 * half, 1.0 - 6.0 * half], [2.0 * half, d + 4.0 * half])
}

/// The same weights with the interval turned round.
fn mirrored((values, slopes): ([f64; 2], [f64; 2])) -> ([f64; 2], [f64; 2]) {
    ([values[1], values[0]], [-slopes[1], -slopes[0]])
}

/// Slopes at all points.
pub(super) fn slopes(x: &[f64], value: &[f64]) -> Vec<f64> {
    let rise: Vec<f64> =
        x.windows(2).zip(value.windows(2)).map(|(x, v)| (v[1] - v[0]) / (x[1] - x[0])).collect();
    let bend: Vec<f64> =
        rise.windows(2).zip(x.windows(3)).map(|(r, x)| (r[1] - r[0]) / (x[2] - x[0])).collect();
    let trust: Vec<f64> = (0..bend.len()).map(|j| trust(&bend, j)).collect();
    (0..x.len()).map(|i| slope(x, &rise, &bend, &trust, i)).collect()
}

/// How far a parabola is trusted: little if it bends much more than those two points away.
fn trust(bend: &[f64], j: usize) -> f64 {
    const USUAL: f64 = 1.5;
    const SHARPNESS: i32 = 8;
    const FLOOR: f64 = 1e-3;
    let away = [j.checked_sub(2), Some(j + 2)];
    let around = away.into_iter().flatten().filter_map(|at| bend.get(at));
    let Some(most) = around.map(|bend| bend.abs()).reduce(f64::max) else { return 1.0 };
    let here = bend[j].abs();
    let ratio = here / (most + FLOOR * here + f64::MIN_POSITIVE);
    1.0 / (1.0 + (ratio / USUAL).powi(SHARPNESS))
}

fn slope(x: &[f64], rise: &[f64], bend: &[f64], trust: &[f64], i: usize) -> f64 {
    let last = x.len() - 1;
    if last < 2 {
        return rise.first().copied().unwrap_or(0.0);
    }
    let [to_left, to_right] = smooth_weights(x, i);
    let (mut sum, mut total) = (0.0, 0.0);
    let mut add = |weight: f64, at: usize, slope: f64| {
        sum += weight * trust[at] * slope;
        total += weight * trust[at];
    };
    if i >= 2 {
        add(to_left, i - 2, rise[i - 1] + bend[i - 2] * (x[i] - x[i - 1]));
    }
    if i >= 1 && i < last {
        let weight = 1.0 - to_left - to_right;
        add(weight, i - 1, rise[i - 1] + bend[i - 1] * (x[i] - x[i - 1]));
    }
    if i + 2 <= last {
        add(to_right, i, rise[i] - bend[i] * (x[i + 1] - x[i]));
    }
    sum / total
}

/// Weights of the left and right parabola that make the formula of highest order.
fn smooth_weights(x: &[f64], i: usize) -> [f64; 2] {
    let last = x.len() - 1;
    let left4 =
        if i >= 2 && i < last { (x[i + 1] - x[i]) / (x[i + 1] - x[i - 2]) } else { f64::NAN };
    let right4 =
        if i >= 1 && i + 2 <= last { (x[i] - x[i - 1]) / (x[i + 2] - x[i - 1]) } else { f64::NAN };
    match (i, i + 2 <= last, left4.is_nan(), right4.is_nan()) {
        (0, ..) => [0.0, 1.0],
        (at, ..) if at == last => [1.0, 0.0],
        (_, _, false, false) => {
            let whole = x[i + 2] - x[i - 2];
            [left4 * (x[i + 2] - x[i]) / whole, right4 * (x[i] - x[i - 2]) / whole]
        }
        (_, _, false, true) => [left4, 0.0],
        (_, _, true, false) => [0.0, right4],
        _ => [0.0, 0.0],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(x: &[f64], f: impl Fn(f64) -> f64) -> Cubic {
        Cubic::new(x.to_vec(), x.iter().map(|&x| f(x)).collect())
    }

    #[test]
    fn a_parabola_on_uneven_points_is_exact_inside_and_beyond() {
        let f = |x: f64| 3.0 - 2.0 * x + 0.7 * x * x;
        let curve = curve(&[-1.0, -0.4, 0.1, 0.2, 1.5, 2.0], f);
        for x in [-3.0, -1.0, -0.7, 0.15, 1.0, 1.9, 4.0] {
            assert!((curve.at(x) - f(x)).abs() < 1e-12, "{x}");
        }
    }

    /// Halving the steps divides the error of a smooth curve by 16 (four times by 8 is third
    /// order, which the limiter would leave).
    #[test]
    fn smooth_data_converge_with_order_four() {
        let error = |n: i32| {
            let x: Vec<f64> = (0..=n).map(|i| 3.0 * f64::from(i) / f64::from(n)).collect();
            let curve = curve(&x, f64::sin);
            let inner = |x: f64| 0.6 + 1.8 * x;
            (0..1000)
                .map(|i| inner(f64::from(i) / 1e3))
                .fold(0.0, |worst: f64, x| worst.max((curve.at(x) - x.sin()).abs()))
        };
        let rate = (error(32) / error(64)).log2();
        assert!(rate > 3.6, "{rate}");
    }

    #[test]
    fn a_kink_does_not_ring() {
        let f = |x: f64| x.powi(2).min((x - 3.3).powi(2));
        let x: Vec<f64> = (-8..=20).map(|i| 0.25 * f64::from(i)).collect();
        let curve = curve(&x, f);
        // The kink at 1.65 lies between 1.5 and 1.75; one interval further on the curve is exact
        // but for what weight a bent parabola keeps (it errs by 1.3 and 2 in slope).
        for i in 0..600 {
            let x = -2.0 + f64::from(i) * 0.01;
            if !(1.25..=2.0).contains(&x) {
                assert!((curve.at(x) - f(x)).abs() < 1e-4, "{x}: {}", curve.at(x) - f(x));
            }
        }
    }
}
