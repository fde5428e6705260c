//! Anderson acceleration of a fixed-point iteration.
//!
//! D.G. Anderson, Journal of the ACM 12 (1965) 547-560.

use nalgebra::{DMatrix, DVector};

/// Steps that are remembered.
const DEPTH: usize = 4;
/// Directions of the remembered steps that are this much alike count once.
const ALIKE: f64 = 1e-10;

/// Anderson acceleration by the last steps of an iteration `x <- g(x)`.
#[derive(Debug, Clone, Default)]
pub(crate) struct AndersonAcceleration {
    /// `g(x)` and `g(x) - x`, the latest last.
    steps: Vec<[DVector<f64>; 2]>,
}

impl AndersonAcceleration {
    /// Replaces `x` by a better one, given `g(x)`: that whose step would be the smallest, were the
    /// iteration linear.
    pub(crate) fn improve(&mut self, x: &mut [f64], image: &[f64]) {
        let image = DVector::from_column_slice(image);
        let step = &image - DVector::from_column_slice(x);
        let changes: Vec<_> = self.steps.iter().map(|[_, old]| &step - old).collect();
        let mut next = image.clone();
        if let Some(weights) = weights(&changes, &step) {
            for ([old, _], weight) in self.steps.iter().zip(weights.iter()) {
                next -= (&image - old) * *weight;
            }
        }
        x.copy_from_slice(next.as_slice());
        if self.steps.len() == DEPTH {
            self.steps.remove(0);
        }
        self.steps.push([image, step]);
    }
}

/// The weights with which changes come nearest to a step.
fn weights(changes: &[DVector<f64>], step: &DVector<f64>) -> Option<DVector<f64>> {
    if changes.is_empty() {
        return None;
    }
    let matrix = DMatrix::from_columns(changes);
    let svd = matrix.svd(true, true);
    let least = ALIKE * svd.singular_values.max();
    svd.solve(step, least).ok().filter(|weights| weights.iter().all(|w| w.is_finite()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear iteration that diverges by itself, in three directions: four steps end it.
    #[test]
    fn a_linear_iteration_ends() {
        let gains = [0.9, -1.7, 0.2, -1.7, 0.9];
        let (mut x, mut mixing) = ([0.0; 5], AndersonAcceleration::default());
        for _ in 0..6 {
            let image: Vec<f64> = x.iter().zip(gains).map(|(x, gain)| 1.0 + gain * x).collect();
            mixing.improve(&mut x, &image);
        }
        for (x, gain) in x.iter().zip(gains) {
            assert!((x - 1.0 / (1.0 - gain)).abs() < 1e-9, "{x} {gain}");
        }
    }
}
