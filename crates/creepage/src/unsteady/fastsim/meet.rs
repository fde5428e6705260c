//! The creepage at which FASTSIM gives the prescribed forces.

use super::super::history::{Creep, Level};
use super::super::motion::{Motion, Prescribed};
use super::RollingFastsim;
use super::march::Sum;

const NEWTON: usize = 40;
/// Halvings of a step that leads farther away.
const HALVINGS: usize = 40;
/// Largest difference from a prescribed force, in parts of `mu N`.
const TOLERANCE: f64 = 1e-9;

impl RollingFastsim {
    /// The step at the creepage that meets the prescribed forces: Newton's method from the last
    /// creepage. Where that fails, far in full sliding where the force does not change, it starts again
    /// without creepage: from below, steps along a force that saturates do not overshoot.
    pub(super) fn meet(&self, length: f64, scale: f64, motion: &Motion) -> (Level, Sum, bool) {
        let prescribed = motion.components();
        let from = |start: Creep| {
            let mut creep = start;
            for (creep, prescribed) in creep.iter_mut().zip(prescribed) {
                *creep = prescribed.creepage().unwrap_or(*creep);
            }
            self.newton([length, scale], prescribed, creep)
        };
        let found = from(self.travel.creep);
        let began_at_rest = self.travel.creep.iter().all(|part| *part == 0.0);
        if found.2 || began_at_rest { found } else { from([0.0; 3]) }
    }

    /// Newton's method with differences and a line search, from a creepage.
    fn newton(
        &self,
        [length, scale]: [f64; 2],
        prescribed: [Prescribed; 3],
        mut creep: Creep,
    ) -> (Level, Sum, bool) {
        const DIFFERENCE: f64 = 1e-6;
        let tolerance = TOLERANCE * scale.powi(3);
        let unknown: Vec<usize> = (0..3).filter(|k| prescribed[*k].force().is_some()).collect();
        let off = |sum: &Sum, k: usize| match prescribed[k] {
            Prescribed::Force(value) => value - sum.force[k],
            Prescribed::Creepage(_) => 0.0,
        };
        let (mut level, mut sum) = self.march([length, scale], creep);
        for _ in 0..NEWTON {
            if unknown.iter().all(|k| off(&sum, *k).abs() < tolerance) {
                return (level, sum, true);
            }
            let n = unknown.len();
            let columns = unknown.iter().map(|k| {
                let mut moved = creep;
                moved[*k] += DIFFERENCE;
                self.march([length, scale], moved).1
            });
            let columns: Vec<Sum> = columns.collect();
            let entry = |i: usize, k: usize| {
                (columns[k].force[unknown[i]] - sum.force[unknown[i]]) / DIFFERENCE
            };
            let residual =
                nalgebra::DVector::from_iterator(n, unknown.iter().map(|k| off(&sum, *k)));
            let matrix = nalgebra::DMatrix::from_fn(n, n, entry);
            let step = matrix.lu().solve(&residual);
            let Some(step) = step.filter(|s| s.iter().all(|s| s.is_finite())) else { break };
            let mut shorter = 1.0;
            let is_nearer = (0..HALVINGS).any(|_| {
                let mut moved = creep;
                unknown.iter().zip(step.iter()).for_each(|(k, s)| moved[*k] += shorter * s);
                let (at, found) = self.march([length, scale], moved);
                let next = unknown.iter().map(|k| off(&found, *k).powi(2)).sum::<f64>().sqrt();
                shorter *= 0.5;
                let is_nearer = next < residual.norm();
                if is_nearer {
                    (creep, level, sum) = (moved, at, found);
                }
                is_nearer
            });
            if !is_nearer {
                break;
            }
        }
        let solved = unknown.iter().all(|k| off(&sum, *k).abs() < tolerance);
        (level, sum, solved)
    }
}
