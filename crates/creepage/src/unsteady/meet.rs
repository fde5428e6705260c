//! The creepage at which a step gives the prescribed forces, for theories without derivatives.

use std::convert::Infallible;

use nalgebra::DVector;

use super::history::Creep;
use super::motion::Prescribed;
use crate::numerics::{NewtonLimits, newton};

const MAX_STEPS: usize = 40;
const MAX_HALVINGS: usize = 40;

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
    let mut from = |start: Creep| found(prescribed, start, accuracy, &mut solve);
    let found = from(start);
    let began_at_rest = start.iter().all(|part| *part == 0.0);
    if found.2 || began_at_rest { found } else { from([0.0; 3]) }
}

fn found<T>(
    prescribed: [Prescribed; 3],
    start: Creep,
    Accuracy { tolerance, difference }: Accuracy,
    mut solve: impl FnMut(Creep) -> (T, [f64; 3]),
) -> (Creep, T, bool) {
    let unknown: Vec<(usize, f64)> =
        (0..3).filter_map(|k| Some((k, prescribed[k].force()?))).collect();
    let creep = |at: &DVector<f64>| {
        let mut creep: Creep = [0, 1, 2].map(|k: usize| prescribed[k].creepage().unwrap_or(0.0));
        unknown.iter().zip(at).for_each(|((k, _), at)| creep[*k] = *at);
        creep
    };
    let over = |at: &DVector<f64>| -> Result<_, Infallible> {
        let (value, force) = solve(creep(at));
        let over = unknown.iter().map(|(k, wanted)| force[*k] - wanted);
        Ok((value, DVector::from_iterator(unknown.len(), over)))
    };
    let first = DVector::from_iterator(unknown.len(), unknown.iter().map(|(k, _)| start[*k]));
    let differences = DVector::from_element(unknown.len(), difference);
    let limits = NewtonLimits {
        tolerance,
        max_steps: MAX_STEPS,
        max_halvings: MAX_HALVINGS,
        least_decrease: 0.0,
    };
    let Ok(found) = newton(first, &differences, limits, over);
    {
        let is_met = found.largest() <= tolerance;
        (creep(&found.at), found.value, is_met)
    }
}
