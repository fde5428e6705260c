//! Newton in all strips at once, with a search along each step.

use super::friction::project;
use super::grid::Grid;
use super::linear::Linear;
use super::state::State;

const STEPS: usize = 12;
/// Accuracy of the linear equations at first; nearer to the solution it pays to solve them better.
const ROUGH: f64 = 0.05;
const FINE: f64 = 1e-6;
/// Accuracy after a step that led nowhere, for it may be to blame.
const BETTER: f64 = 1e-3;
/// Share of what may still be lacking at the end that the linear equations may leave.
const LAST: f64 = 0.3;
/// A strip's factors that were left after a larger step are made anew.
const STALE: f64 = 0.1;
/// Halvings of a step until it makes the tractions better.
const HALVINGS: usize = 5;

/// By how much friction is not obeyed, in parts of the bound: `traction - projection`.
#[derive(Debug, Clone, Copy, Default)]
struct Lack {
    /// Root of the sum of squares over all elements.
    total: f64,
    largest: f64,
}

/// How Newton's method went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Newton {
    Converged,
    /// The tractions are too far off.
    Astray,
}

impl State {
    /// Improves tractions that are near the solution; the slip must be theirs. When `hasty` it ends
    /// as soon as a step must be shortened.
    pub(super) fn newton(
        &mut self,
        grid: &Grid,
        linear: &mut Linear,
        tolerance: f64,
        hasty: bool,
    ) -> Newton {
        linear.clear();
        let mut lack = self.lack_after(grid, linear, 0.0);
        let mut accuracy = ROUGH;
        for _ in 0..STEPS {
            if !self.linearize(grid, linear) {
                break;
            }
            if lack.largest <= tolerance {
                return Newton::Converged;
            }
            linear.solve(grid, self, accuracy.max(LAST * tolerance / lack.largest));
            let Some((share, next)) = self.search(grid, linear, lack) else {
                if accuracy <= BETTER {
                    break;
                }
                accuracy = BETTER;
                continue;
            };
            self.advance(linear, share);
            accuracy = (0.5 * (next.total / lack.total).powi(2)).clamp(FINE, ROUGH);
            lack = next;
            if hasty && share < 1.0 {
                return Newton::Astray;
            }
        }
        self.last_step.fill(f64::INFINITY);
        Newton::Astray
    }

    /// Newton's equations at the present tractions; false when a strip's are singular.
    fn linearize(&mut self, grid: &Grid, linear: &mut Linear) -> bool {
        for strip in 0..grid.elements.strips {
            let switched = self.choose_branches(grid, strip);
            if (switched || self.last_step[strip] > STALE) && !self.factor(grid, strip) {
                return false;
            }
            self.last_step[strip] = 0.0;
        }
        for element in 0..grid.elements.len() {
            linear.right[2 * element..2 * element + 2].copy_from_slice(&self.residual(element));
        }
        true
    }

    /// The largest of the step's halves that makes the tractions better, and what is lacking then.
    fn search(&self, grid: &Grid, linear: &Linear, lack: Lack) -> Option<(f64, Lack)> {
        let mut share = 1.0;
        for _ in 0..=HALVINGS {
            let next = self.lack_after(grid, linear, share);
            if next.total < (1.0 - 0.1 * share) * lack.total {
                return Some((share, next));
            }
            share *= 0.5;
        }
        None
    }

    /// What is lacking after a share of the step.
    fn lack_after(&self, grid: &Grid, linear: &Linear, share: f64) -> Lack {
        let mut lack = Lack::default();
        for element in 0..grid.elements.len() {
            let (t, s) = (self.traction.at(element), self.slip_of(element));
            let (dt, weight) = (linear.change.at(element), grid.weights[element]);
            let traction = [0, 1].map(|k| t[k] + share * dt[k]);
            let slip = [0, 1].map(|k| s[k] + share * linear.slip[k][element]);
            let [x, y] = match project(traction, slip, weight) {
                None => slip.map(|s| weight * s),
                Some(sliding) => [0, 1].map(|k| sliding.traction[k] - traction[k]),
            };
            lack.total += x * x + y * y;
            lack.largest = lack.largest.max(x.hypot(y));
        }
        lack.total = lack.total.sqrt();
        lack
    }

    fn advance(&mut self, linear: &Linear, share: f64) {
        self.traction.add_times(share, &linear.change);
        for (slip, change) in self.slip.iter_mut().zip(&linear.slip) {
            slip.iter_mut().zip(change).for_each(|(slip, change)| *slip += share * change);
        }
    }
}
