//! The creepage at which a step gives the prescribed forces, for theories without derivatives.

use nalgebra::{DMatrix, DVector};

use super::history::Creep;
use super::motion::Prescribed;

const NEWTON: usize = 40;
/// Halvings of a step that leads farther away.
const HALVINGS: usize = 40;

/// How exactly a force is met, and by what step of the creepage its derivative is taken.
#[derive(Debug, Clone, Copy)]
pub(super) struct Accuracy {
    pub tolerance: f64,
    pub difference: f64,
}

/// Newton's method with differences and a line search: the last solution and whether it meets the
/// forces. Where that fails, far in full sliding where the force does not change, it starts again without
/// creepage: from below, steps along a force that saturates do not overshoot.
pub(super) fn meet<T>(
    prescribed: [Prescribed; 3],
    start: Creep,
    accuracy: Accuracy,
    mut solve: impl FnMut(Creep) -> (T, [f64; 3]),
) -> (Creep, T, bool) {
    let mut from = |start: Creep| {
        let mut creep = start;
        for (creep, prescribed) in creep.iter_mut().zip(prescribed) {
            *creep = prescribed.creepage().unwrap_or(*creep);
        }
        newton(prescribed, creep, accuracy, &mut solve)
    };
    let found = from(start);
    let began_at_rest = start.iter().all(|part| *part == 0.0);
    if found.2 || began_at_rest { found } else { from([0.0; 3]) }
}

fn newton<T>(
    prescribed: [Prescribed; 3],
    mut creep: Creep,
    Accuracy { tolerance, difference }: Accuracy,
    mut solve: impl FnMut(Creep) -> (T, [f64; 3]),
) -> (Creep, T, bool) {
    let unknown: Vec<usize> = (0..3).filter(|k| prescribed[*k].force().is_some()).collect();
    let off = |force: &[f64; 3], k: usize| match prescribed[k] {
        Prescribed::Force(value) => value - force[k],
        Prescribed::Creepage(_) => 0.0,
    };
    let (mut found, mut force) = solve(creep);
    for _ in 0..NEWTON {
        if unknown.iter().all(|k| off(&force, *k).abs() < tolerance) {
            return (creep, found, true);
        }
        let n = unknown.len();
        let columns = unknown.iter().map(|k| {
            let mut moved = creep;
            moved[*k] += difference;
            solve(moved).1
        });
        let columns: Vec<[f64; 3]> = columns.collect();
        let entry = |i: usize, k: usize| (columns[k][unknown[i]] - force[unknown[i]]) / difference;
        let residual = DVector::from_iterator(n, unknown.iter().map(|k| off(&force, *k)));
        let step = DMatrix::from_fn(n, n, entry).lu().solve(&residual);
        let Some(step) = step.filter(|s| s.iter().all(|s| s.is_finite())) else { break };
        let mut shorter = 1.0;
        let is_nearer = (0..HALVINGS).any(|_| {
            let mut moved = creep;
            unknown.iter().zip(step.iter()).for_each(|(k, s)| moved[*k] += shorter * s);
            let (at, there) = solve(moved);
            let next = unknown.iter().map(|k| off(&there, *k).powi(2)).sum::<f64>().sqrt();
            shorter *= 0.5;
            let is_nearer = next < residual.norm();
            if is_nearer {
                (creep, found, force) = (moved, at, there);
            }
            is_nearer
        });
        if !is_nearer {
            break;
        }
    }
    let solved = unknown.iter().all(|k| off(&force, *k).abs() < tolerance);
    (creep, found, solved)
}
