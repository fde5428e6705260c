//! Anderson's acceleration of the sweeps: what the last few changes had in common is taken out of
//! the next in one go. Long, slender contacts need it: their strips act strongly on one another.

use nalgebra::{SMatrix, SVector};

/// Number of earlier changes that are remembered.
const WINDOW: usize = 5;

/// Memory of the iterates after each round of sweeps.
#[derive(Debug, Clone)]
pub(super) struct Acceleration {
    /// Iterate before the round.
    start: Vec<f64>,
    /// Iterate after the last round, and by how much the round changed it.
    last: [Vec<f64>; 2],
    /// Differences of these two between successive rounds.
    differences: [[Vec<f64>; 2]; WINDOW],
    rounds: usize,
}

impl Acceleration {
    pub(super) fn new(unknowns: usize) -> Self {
        let zeros = || vec![0.0; unknowns];
        Self {
            start: zeros(),
            last: [zeros(), zeros()],
            differences: std::array::from_fn(|_| [zeros(), zeros()]),
            rounds: 0,
        }
    }

    /// Forgets all rounds.
    pub(super) fn restart(&mut self) {
        self.rounds = 0;
    }

    /// Notes the iterate before a round.
    pub(super) fn begin(&mut self, iterate: &[Vec<f64>; 2]) {
        self.start.clear();
        self.start.extend(iterate.iter().flatten());
    }

    /// Moves the iterate after a round to where the remembered rounds, combined, change least.
    pub(super) fn finish(&mut self, iterate: &mut [Vec<f64>; 2]) {
        self.remember(iterate);
        let window = (self.rounds - 1).min(WINDOW);
        let Some(weights) = self.weights(window) else {
            self.rounds = 0;
            return;
        };
        for (weight, [after, _]) in weights.iter().zip(&self.differences).take(window) {
            for (x, d) in iterate.iter_mut().flatten().zip(after) {
                *x -= weight * d;
            }
        }
    }

    fn remember(&mut self, iterate: &[Vec<f64>; 2]) {
        let [after, change] = &mut self.last;
        let [after_difference, change_difference] =
            &mut self.differences[(self.rounds + WINDOW - 1) % WINDOW];
        for (k, x) in iterate.iter().flatten().enumerate() {
            let moved = x - self.start[k];
            after_difference[k] = x - after[k];
            change_difference[k] = moved - change[k];
            after[k] = *x;
            change[k] = moved;
        }
        self.rounds += 1;
    }

    /// Least-squares weights of the remembered differences of change against the last change.
    fn weights(&self, window: usize) -> Option<SVector<f64, WINDOW>> {
        let mut matrix = SMatrix::<f64, WINDOW, WINDOW>::identity();
        let mut right = SVector::<f64, WINDOW>::zeros();
        for i in 0..window {
            let own = &self.differences[i][1];
            let size = dot(own, own);
            for j in 0..i {
                matrix[(i, j)] = dot(own, &self.differences[j][1]);
                matrix[(j, i)] = matrix[(i, j)];
            }
            // A trace of regularization, for differences that are almost parallel.
            matrix[(i, i)] = size * (1.0 + 1e-12) + f64::MIN_POSITIVE;
            right[i] = dot(own, &self.last[1]);
        }
        let weights = matrix.cholesky()?.solve(&right);
        weights.iter().all(|w| w.is_finite()).then_some(weights)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear iteration in two unknowns is solved once two differences are known.
    #[test]
    fn a_linear_iteration_ends_at_once() {
        let mut acceleration = Acceleration::new(2);
        let mut x = [vec![1.0], vec![0.0]];
        for _ in 0..4 {
            acceleration.begin(&x);
            let (a, b) = (x[0][0], x[1][0]);
            x = [vec![0.9 * a + 0.2 * b + 1.0], vec![-0.1 * a + 0.8 * b + 2.0]];
            acceleration.finish(&mut x);
        }
        // The fixed point of the iteration; rounding and regularization leave 1e-9.
        let expected = [(0.2 + 0.4) / 0.04, (0.2 - 0.1) / 0.04];
        assert!((x[0][0] - expected[0]).abs() < 1e-7, "{x:?}");
        assert!((x[1][0] - expected[1]).abs() < 1e-7, "{x:?}");
    }
}
