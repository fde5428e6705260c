//! The graph of a polynomial `z(y)`.

use super::{CurvePoint, Piece};

/// Nodes of the map from arc length to `y`; cubic between them.
const NODES: usize = 48;

/// The graph `z(y)` of a polynomial between two values of `y`, in either sense.
#[derive(Debug, Clone, PartialEq)]
pub struct Graph {
    /// Coefficients of rising powers of `y - centre`.
    coefficients: Vec<f64>,
    centre: f64,
    /// `y` at evenly spaced arc lengths, and its change over a spacing there.
    nodes: Vec<[f64; 2]>,
    spacing: f64,
    sense: f64,
}

impl Graph {
    /// The polynomial with `coefficients` of rising powers of `y - centre` (m), from `start` to
    /// `end`.
    #[must_use]
    pub fn between(coefficients: Vec<f64>, centre: f64, [start, end]: [f64; 2]) -> Piece {
        let sense = (end - start).signum();
        let mut graph = Self { coefficients, centre, nodes: Vec::new(), spacing: 0.0, sense };
        graph.spacing = graph.measure(start, end) / NODES as f64;
        let nodes = graph.walk(start, end);
        let rate = |y: f64| sense * graph.spacing / graph.value(y)[1].hypot(1.0);
        graph.nodes = nodes.into_iter().map(|y| [y, rate(y)]).collect();
        Piece::Graph(graph)
    }

    pub(super) fn length(&self) -> f64 {
        self.spacing * NODES as f64
    }

    /// Value, slope and second derivative at `y`.
    fn value(&self, y: f64) -> [f64; 3] {
        let t = y - self.centre;
        self.coefficients
            .iter()
            .rev()
            .fold([0.0; 3], |[p, d, c], &a| [p * t + a, d * t + p, c * t + 2.0 * d])
    }

    /// Length between two values of `y`, by Gauss's rule of 5 points on 64 parts.
    fn measure(&self, start: f64, end: f64) -> f64 {
        let step = (end - start) / 64.0;
        (0..64).map(|i| self.stretch(start + f64::from(i) * step, step)).sum::<f64>().abs()
    }

    fn stretch(&self, start: f64, step: f64) -> f64 {
        super::cubic::gauss(|t| self.value(start + t * step)[1].hypot(1.0)) * step
    }

    /// `y` at the nodes: each from the one before by Newton's method on the length between.
    fn walk(&self, start: f64, end: f64) -> Vec<f64> {
        let mut nodes = vec![start];
        let mut y = start;
        for _ in 1..NODES {
            let from = y;
            y += self.sense * self.spacing / self.value(y)[1].hypot(1.0);
            for _ in 0..4 {
                let excess = self.stretch(from, y - from) - self.sense * self.spacing;
                y -= excess / self.value(y)[1].hypot(1.0);
            }
            nodes.push(y);
        }
        nodes.push(end);
        nodes
    }

    pub(super) fn at(&self, s: f64) -> CurvePoint {
        let place = (s / self.spacing).clamp(0.0, NODES as f64);
        let index = super::whole(place).min(NODES - 1);
        let node = |i: usize| self.nodes.get(i).copied().unwrap_or([self.centre, 0.0]);
        let ([a, rate_a], [b, rate_b]) = (node(index), node(index + 1));
        let y = super::cubic::hermite(place - index as f64, [a, b], [rate_a, rate_b]);
        let [z, first, second] = self.value(y);
        let stretch = first.hypot(1.0);
        CurvePoint {
            y,
            z,
            tangent: [self.sense / stretch, self.sense * first / stretch],
            curvature: self.sense * second / stretch.powi(3),
        }
    }
}
