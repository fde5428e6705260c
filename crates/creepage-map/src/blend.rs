//! Interpolation over nodes with a continuous first derivative.

use crate::scalar::Scalar;

/// The cell of a grid in which a place lies; the last one begins before the last node.
pub(crate) fn cell(grid: &[f64], at: f64) -> usize {
    let last = grid.len().saturating_sub(2);
    grid.partition_point(|node| *node <= at).saturating_sub(1).min(last)
}

/// Weights of Hermite's cubic between two neighbours that know their slopes, `sum w_k (f_k + d_k f_k')`.
///
/// The weights `w_k` are not negative, so that a bound on both neighbours is one on the blend, and level at the
/// nodes; each neighbour is asked not as far away as the place lies, but at `d_k`, by which the cubic's terms of the
/// slopes come out: `w_0 d_0 = t (1 - t)^2 h`. Polynomials of third degree are met where slopes are right, and
/// first derivatives do not jump.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hermite<S> {
    /// The first of both nodes.
    pub(crate) first: usize,
    /// `w_k`.
    pub(crate) weights: [S; 2],
    /// `d_k`, in the grid's unit.
    pub(crate) away: [S; 2],
}

impl<S: Scalar> Hermite<S> {
    /// On a grid of at least two rising nodes, within its ends or hardly beyond.
    pub(crate) fn at(grid: &[f64], place: S) -> Self {
        let first = cell(grid, place.value());
        let width = grid[first + 1] - grid[first];
        let part = (place - grid[first]) * width.recip();
        let t = part.value().clamp(0.0, 1.0);
        let after = part.chain(t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t));
        let (low, high) = (1.0 + 2.0 * t, 3.0 - 2.0 * t);
        let away = [
            part.chain(t / low * width, width / (low * low)),
            part.chain((t - 1.0) / high * width, width / (high * high)),
        ];
        Self { first, weights: [-after + 1.0, after], away }
    }
}

/// The first of up to four nodes, and their weights: the cubic through two neighbours whose slopes there
/// are those of the parabolas through three nodes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cubic<S> {
    pub(crate) first: usize,
    pub(crate) weights: [S; 4],
}

impl<S: Scalar> Cubic<S> {
    /// On a grid of at least three rising nodes.
    pub(crate) fn at(grid: &[f64], place: S) -> Self {
        let cell = cell(grid, place.value());
        let first = cell.saturating_sub(1).min(grid.len().saturating_sub(4));
        let nodes = &grid[first..grid.len().min(first + 4)];
        let spread = |k: usize| nodes.get(k).copied().unwrap_or(f64::INFINITY);
        let places = [0, 1, 2, 3].map(|k| S::constant(spread(k)));
        let weights = cubic_weights(&places, nodes.len(), cell - first, place);
        Self { first, weights }
    }

    /// The interpolated value.
    pub(crate) fn of(&self, value: impl Fn(usize) -> f64) -> S {
        let mut sum = S::constant(0.0);
        for (k, weight) in self.weights.iter().enumerate() {
            if k == 3 && weight.value() == 0.0 {
                continue;
            }
            sum = sum + *weight * value(self.first + k);
        }
        sum
    }
}

/// The value at a place between values at the nodes of a rising grid, as maps interpolate: the cubic through
/// neighbours with the slopes of parabolas; NaN on fewer than three nodes.
#[must_use]
pub fn interpolated(grid: &[f64], values: &[f64], place: f64) -> f64 {
    if grid.len() < 3 || values.len() != grid.len() {
        return f64::NAN;
    }
    Cubic::at(grid, place).of(|k| values.get(k).copied().unwrap_or(f64::NAN))
}

/// The weights of up to four nodes, of which `count` exist, in the cell after node `cell`.
pub(crate) fn cubic_weights<S: Scalar>(
    nodes: &[S; 4],
    count: usize,
    cell: usize,
    place: S,
) -> [S; 4] {
    let zero = S::constant(0.0);
    let mut weights = [zero; 4];
    let width = nodes[cell + 1] - nodes[cell];
    let t = (place - nodes[cell]) / width;
    let rest = -t + 1.0;
    let end = t * t * (-t * 2.0 + 3.0);
    weights[cell] = -end + 1.0;
    weights[cell + 1] = end;
    let slopes = [t * rest * rest * width, -t * t * rest * width];
    for (side, slope) in slopes.into_iter().enumerate() {
        let node = cell + side;
        let (centre, by) = parabola(nodes, count, node);
        for (k, by) in by.into_iter().enumerate() {
            weights[centre - 1 + k] = weights[centre - 1 + k] + slope * by;
        }
    }
    weights
}

/// The slope at a node of the parabola through three: the middle one of these, and their weights.
fn parabola<S: Scalar>(nodes: &[S; 4], count: usize, node: usize) -> (usize, [S; 3]) {
    let centre = node.clamp(1, count - 2);
    let (before, after) = (nodes[centre] - nodes[centre - 1], nodes[centre + 1] - nodes[centre]);
    let both = before + after;
    let by = match node {
        node if node < centre => [
            -(before * 2.0 + after) / (before * both),
            both / (before * after),
            -before / (after * both),
        ],
        node if node > centre => [
            after / (before * both),
            -both / (before * after),
            (after * 2.0 + before) / (after * both),
        ],
        _ => {
            [-after / (before * both), (after - before) / (before * after), before / (after * both)]
        }
    };
    (centre, by)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Dual;

    /// Parabolas are met to rounding, and so are their slopes.
    #[test]
    fn parabolas_are_met() {
        for grid in [vec![0.0, 0.3, 1.0], vec![0.0, 0.3, 1.0, 1.2, 2.0]] {
            let value = |x: f64| 0.3 - x + 2.0 * x * x;
            for at in [0.0, 0.1, 0.3, 0.7, 1.0] {
                let found = Cubic::at(&grid, Dual::<1>::variable(at, 0)).of(|k| value(grid[k]));
                assert!((found.v - value(at)).abs() < 1e-14, "{found:?}");
                assert!((found.d[0] - (4.0 * at - 1.0)).abs() < 1e-13, "{found:?}");
            }
        }
    }

    /// Cubics are met to rounding with the right slopes at two nodes, and no node is asked farther away than a third
    /// of the cell.
    #[test]
    fn cubics_are_met_by_two_slopes() {
        let grid = [-1.0, 0.3, 1.0];
        let value = |x: f64| 0.3 - x + 2.0 * x * x - 0.7 * x * x * x;
        let slope = |x: f64| -1.0 + 4.0 * x - 2.1 * x * x;
        for at in [-1.0, -0.4, 0.29, 0.3, 0.31, 0.9, 1.0] {
            let blend = Hermite::at(&grid, Dual::<1>::variable(at, 0));
            let mut sum = Dual::constant(0.0);
            for k in 0..2 {
                let node = grid[blend.first + k];
                sum = sum + blend.weights[k] * (blend.away[k] * slope(node) + value(node));
                assert!(blend.away[k].v.abs() <= (1.3 + 1e-12) / 3.0 && blend.weights[k].v >= 0.0);
            }
            assert!((sum.v - value(at)).abs() < 1e-14, "{sum:?}");
            assert!((sum.d[0] - slope(at)).abs() < 1e-13, "{sum:?}");
        }
    }

    /// Neither values nor slopes jump at a node.
    #[test]
    fn slopes_are_continuous() {
        let grid = [0.0, 0.3, 1.0, 1.2, 2.0];
        let values = [1.0, -2.0, 0.5, 3.0, 2.0];
        for node in [0.3, 1.0, 1.2] {
            let at = |x| Cubic::at(&grid, Dual::<1>::variable(x, 0)).of(|k| values[k]);
            let (before, after) = (at(node - 1e-12), at(node + 1e-12));
            assert!((before.v - after.v).abs() < 1e-9 && (before.d[0] - after.d[0]).abs() < 1e-9);
        }
    }
}
