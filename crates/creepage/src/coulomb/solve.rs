//! From any tractions to those that obey friction.
//!
//! Sweeps come near: a sweep solves the friction problem of each strip with the other strips
//! held, for strips act on one another more weakly than elements of a strip do. Newton in all
//! strips at once ends it; where one of its steps must be shortened, a pair of sweeps comes first
//! again, but not for ever: where sweeps swing between states, shortened steps go on.

use super::grid::Grid;
use super::linear::Linear;
use super::newton::Newton;
use super::state::State;
use super::unlike::Drive;
use crate::Creepage;

/// Largest lack of friction's equation `p = P(p + r s)` in a solution, over the traction bound, or
/// over the creepage where that is smaller than one: then tractions are as small as the creepage.
const TOLERANCE: f64 = 1e-8;
/// Tractions so many times larger than the creepage are no start: it is far smaller than the last.
const FORGET: f64 = 1e6;
/// Slip whose square is lost to rounding counts as none.
const NOTHING: f64 = 1e-140;
const ROUNDS: usize = 60;
/// Rounds in which Newton is left as soon as one of its steps must be shortened.
const HASTY: usize = 3;

/// How an iteration ended.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outcome {
    pub converged: bool,
    pub sweeps: usize,
}

impl State {
    /// Improves the tractions until they obey friction at the slip that `drive` causes.
    pub(super) fn solve(&mut self, grid: &Grid, linear: &mut Linear, drive: Drive) -> Outcome {
        let strips = grid.elements.strips;
        let (drive, scale) = match scale(grid, drive) {
            lost if lost < NOTHING => (Drive { creepage: Creepage::default(), side: 0.0 }, 0.0),
            scale => (drive, scale),
        };
        if self.traction.largest() > FORGET * scale {
            self.reset();
        }
        let tolerance = TOLERANCE * scale.min(1.0);
        linear.sweeps = 0;
        for round in 1..=ROUNDS {
            for strip in (0..strips).chain((0..strips).rev()) {
                self.solve_strip(grid, drive, strip, tolerance);
            }
            self.update_slip(grid, drive, 0..grid.elements.len());
            if self.newton(grid, linear, tolerance, round <= HASTY) == Newton::Converged {
                return Outcome { converged: true, sweeps: 2 * round + linear.sweeps };
            }
        }
        Outcome { converged: false, sweeps: 2 * ROUNDS + linear.sweeps }
    }
}

/// Largest slip in the contact before any traction, in the unit in which tractions at their bound
/// give slip.
fn scale(grid: &Grid, drive: Drive) -> f64 {
    (0..grid.elements.len())
        .map(|element| {
            let slip = grid.driven_slip(drive, element);
            slip[0].hypot(slip[1])
        })
        .fold(0.0, f64::max)
}
