//! Equilibrium of a wheelset on a map: height, roll and pitch rate by Newton's method, and their implicit derivatives by
//! what is given.

use creepage::numerics::largest_magnitude;

use crate::answer::{HeightOrLoad, State};
use crate::error::MapError;
use crate::map::{ContactMap, Derivatives, SIDES, VARIABLES, numbers};
use crate::scalar::{Dual, Scalar};
use crate::wheel::WheelActs;

/// The numbers that a wheelset may find for itself.
pub(crate) const Z: usize = 1;
pub(crate) const ROLL: usize = 2;
pub(crate) const PITCH: usize = 5;

/// Free variables of a wheelset's equilibrium.
pub(crate) struct Unknowns {
    /// Their places among the variables.
    open: Few,
}

/// Up to three numbers.
#[derive(Default)]
struct Few {
    all: [usize; 3],
    count: usize,
}

impl Few {
    fn push(&mut self, one: usize) {
        self.all[self.count] = one;
        self.count += 1;
    }

    fn iter(&self) -> std::slice::Iter<'_, usize> {
        self.all[..self.count].iter()
    }
}

impl Unknowns {
    pub(crate) fn of(state: &State) -> Self {
        let mut open = Few::default();
        if matches!(state.pressed, HeightOrLoad::AxleLoad(_)) {
            open.push(Z);
        }
        if state.roll.is_none() {
            open.push(ROLL);
        }
        if state.pitch_rate.is_none() {
            open.push(PITCH);
        }
        Self { open }
    }

    /// Newton's method from a start, each step no longer than the map believes in.
    pub(crate) fn find(
        &self,
        map: &ContactMap,
        state: &State,
        start: [f64; 3],
    ) -> Result<[f64; 3], MapError> {
        const MAX_NEWTON_STEPS: usize = 40;
        /// Of the load, and of the load times a metre.
        const RESIDUAL_TOLERANCE: f64 = 1e-9;
        let count = self.open.count;
        let mut at = start;
        if count == 0 {
            return Ok(at);
        }
        // Longest steps: 20 um, .1 mrad, .5 % of the rate.
        let longest = [20e-6, 1e-4, 5e-3 * state.speed / map.head.radius];
        let mut left = f64::INFINITY;
        for _ in 0..MAX_NEWTON_STEPS {
            let mut numbers = numbers::<Dual<3>>(state, at);
            for (k, open) in self.open.iter().enumerate() {
                match *open {
                    Z => numbers.z = Dual::variable(at[0], k),
                    ROLL => numbers.roll = Dual::variable(at[1], k),
                    _ => numbers.pitch_rate = Dual::variable(at[2], k),
                }
            }
            let [one, other] = SIDES.map(|side| map.on_rail(side, &numbers));
            let wheels = [one?, other?];
            let (mut residuals, mut filled) = ([Dual::<3>::constant(0.0); 3], 0);
            residuals_of(state, &wheels, |residual| {
                residuals[filled] = residual;
                filled += 1;
            });
            left = largest_magnitude(&residuals.map(|residual| residual.v)[..count]);
            if left < RESIDUAL_TOLERANCE {
                return Ok(at);
            }
            let Some(step) = newton_step(&residuals, count) else { break };
            let place = |open: usize| match open {
                Z => 0,
                ROLL => 1,
                _ => 2,
            };
            let over =
                self.open.iter().zip(step).map(|(k, step)| (step / longest[place(*k)]).abs());
            let shorten = over.fold(1.0, f64::max).recip();
            for (open, step) in self.open.iter().zip(step) {
                at[place(*open)] += shorten * step;
            }
        }
        // Rounding of large heights is no failure.
        if left < 1e-6 { Ok(at) } else { Err(MapError::NotFound { left }) }
    }
}

/// What the unknowns make zero: forces over the load, and friction's moment about the axle over load and
/// metre.
fn kept<S: Scalar>(state: &State, wheels: &[WheelActs<S>; 2]) -> Vec<S> {
    let mut kept = Vec::with_capacity(3);
    residuals_of(state, wheels, |residual| kept.push(residual));
    kept
}

fn residuals_of<S: Scalar>(state: &State, wheels: &[WheelActs<S>; 2], mut add: impl FnMut(S)) {
    let [left, right] = wheels;
    let sum = left.force[2] + right.force[2];
    if let HeightOrLoad::AxleLoad(load) = state.pressed {
        add((sum - load) * load.recip());
    }
    let scale = match state.pressed {
        HeightOrLoad::AxleLoad(load) => load,
        HeightOrLoad::Height(_) => sum.value().max(1.0),
    };
    if state.roll.is_none() {
        add((right.force[2] - left.force[2]) * scale.recip());
    }
    if state.pitch_rate.is_none() {
        add((left.axle + right.axle) * scale.recip());
    }
}

/// The step that makes up to three residuals zero.
fn newton_step(residuals: &[Dual<3>; 3], count: usize) -> Option<[f64; 3]> {
    // Unused rows are those of the identity.
    let matrix = nalgebra::Matrix3::from_fn(|i, j| {
        if i < count && j < count { residuals[i].d[j] } else { f64::from(u8::from(i == j)) }
    });
    let right = nalgebra::Vector3::from_fn(|i, _| if i < count { -residuals[i].v } else { 0.0 });
    let step = matrix.lu().solve(&right)?;
    let step = [step[0], step[1], step[2]];
    step.iter().all(|part| part.is_finite()).then_some(step)
}

/// Lets what is found follow what is given.
pub(crate) fn implicit_derivatives(
    state: &State,
    wheels: &[WheelActs<Dual<VARIABLES>>; 2],
    all: &mut Derivatives,
) -> Result<(), MapError> {
    let unknowns = Unknowns::of(state);
    let kept: Vec<[f64; VARIABLES]> = kept(state, wheels).into_iter().map(|kept| kept.d).collect();
    let open: Vec<usize> = unknowns.open.iter().copied().collect();
    if open.is_empty() {
        return Ok(());
    }
    let by = nalgebra::DMatrix::from_fn(open.len(), open.len(), |i, j| kept[i][open[j]]).lu();
    for given in 0..VARIABLES {
        let is_open = open.contains(&given);
        let right = nalgebra::DVector::from_fn(open.len(), |i, _| -kept[i][given]);
        let moved = by.solve(&right).ok_or(MapError::NotDifferentiable)?;
        for row in all.as_flattened_mut() {
            let follow: f64 = open.iter().zip(&moved).map(|(k, moved)| row[*k] * moved).sum();
            // The columns of what is found are needed until the last.
            if !is_open {
                row[given] += follow;
            }
        }
    }
    for row in all.as_flattened_mut() {
        for k in &open {
            row[*k] = f64::NAN;
        }
    }
    Ok(())
}
