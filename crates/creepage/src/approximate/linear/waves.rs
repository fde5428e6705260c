//! Trigonometric polynomials at the nodes of the edge.

use nalgebra::Matrix2;

use super::edge::{Node, Strength};

/// `sin mt` and `cos mt` at all nodes, one frequency after the other.
pub(super) struct Waves {
    count: usize,
    sin: Vec<f64>,
    cos: Vec<f64>,
}

impl Waves {
    /// Frequencies up to `most`, each by one turn from the one before.
    pub(super) fn new(nodes: &[Node], most: usize) -> Self {
        let count = nodes.len();
        let (mut sin, mut cos) = (vec![0.0; count], vec![1.0; count]);
        let turns: Vec<_> = nodes.iter().map(|node| node.angle.sin_cos()).collect();
        for m in 1..=most {
            for (k, (turn_sin, turn_cos)) in turns.iter().enumerate() {
                let (s, c) = (sin[(m - 1) * count + k], cos[(m - 1) * count + k]);
                sin.push(s * turn_cos + c * turn_sin);
                cos.push(c * turn_cos - s * turn_sin);
            }
        }
        Self { count, sin, cos }
    }

    /// `(sin mt, cos mt)` at each node.
    pub(super) fn of(&self, m: usize) -> impl Iterator<Item = (f64, f64)> {
        let nodes = m * self.count..(m + 1) * self.count;
        self.sin[nodes.clone()].iter().copied().zip(self.cos[nodes].iter().copied())
    }

    /// Fourier coefficients `W_2j` of the compliance over half the edge, `j` from 0 to `degree`; `W_-2j`
    /// is the transpose.
    pub(super) fn moments(&self, nodes: &[Node], degree: usize) -> Vec<Matrix2<f64>> {
        let moment = |j: usize| {
            let part = |(node, (sin, cos)): (&Node, (f64, f64))| {
                let w = node.compliance * (2.0 * node.weight);
                Matrix2::new(w.m11 * cos, w.m12 * sin, -w.m12 * sin, w.m22 * cos)
            };
            nodes.iter().zip(self.of(2 * j)).map(part).sum()
        };
        (0..=degree).map(moment).collect()
    }

    /// Adds `(X', Y')` of a strength at each node; frequencies `m` and `-m` are one wave.
    pub(super) fn add(&self, strength: &Strength, u_even_in_x: bool, [x, y]: [&mut [f64]; 2]) {
        let Some(degree) = strength.len().checked_sub(1) else { return };
        for m in (degree % 2..=degree).step_by(2) {
            let (below, above) = (strength[(degree - m) / 2], strength[usize::midpoint(degree, m)]);
            let even = |i: usize| if m == 0 { above[i] } else { above[i] + below[i] };
            let odd = |i: usize| above[i] - below[i];
            let nodes = m * self.count..(m + 1) * self.count;
            let (sin, cos) = (&self.sin[nodes.clone()], &self.cos[nodes]);
            if u_even_in_x {
                add_times(x, even(0), cos);
                add_times(y, -odd(1), sin);
            } else {
                add_times(x, odd(0), sin);
                add_times(y, even(1), cos);
            }
        }
    }
}

fn add_times(to: &mut [f64], factor: f64, wave: &[f64]) {
    for (to, wave) in to.iter_mut().zip(wave) {
        *to += factor * wave;
    }
}
