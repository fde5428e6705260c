//! Rails without mass on springs: they move until the springs carry what the wheels press on them.
//!
//! The unknowns are the deviations of the sprung rails, the residual what the wheel presses on its rail, less
//! what its springs carry, plus what else acts on it. Newton's method with a line search, its Jacobian by
//! differences and then by Broyden's updates: contacts are a hundred times stiffer than springs, so that a fixed
//! point of force over stiffness diverges.

use creepage_rail::{Deviation, Side};
use nalgebra::{DMatrix, DVector};

use crate::error::WheelsetError;
use crate::pose::{Load, WheelsetPose, WheelsetVelocity};
use crate::solved::SolvedWheelset;
use crate::solver::WheelsetSolver;

/// Springs of a rail, across and down, and forces that act on it beside the wheel's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RailSprings {
    /// Stiffness (N/m).
    pub stiffness: [f64; 2],
    /// Forces (N).
    pub force: [f64; 2],
}

const SIDES: [Side; 2] = [Side::Left, Side::Right];
/// Step of the differences (m).
const STEP: f64 = 5e-7;
/// Longest step of a rail against its wheel (m): contacts change their shape beyond.
const LONGEST: f64 = 5e-5;
/// Part of the wheel's force to which springs carry it.
const MET: f64 = 1e-5;
const ROUNDS: usize = 80;

/// A wheelset on rails of which some lie on springs.
struct Sprung<'a> {
    solver: &'a WheelsetSolver<'a>,
    rails: Vec<(Side, RailSprings)>,
    pose: &'a WheelsetPose,
    velocity: &'a WheelsetVelocity,
}

impl WheelsetSolver<'_> {
    /// Solves the wheelset with its left and right rail where their springs carry them; a rail without is rigid.
    ///
    /// # Errors
    /// As [`WheelsetSolver::solve`], and [`WheelsetError::RailNotFound`] where no place of the rails is found.
    pub fn solve_on_springs(
        &self,
        springs: &[Option<RailSprings>; 2],
        pose: &WheelsetPose,
        velocity: &WheelsetVelocity,
    ) -> Result<SolvedWheelset, WheelsetError> {
        let is_there = |side: &Side| pose.side.is_none_or(|alone| alone == *side);
        let of = |side: Side| Some((side, springs[usize::from(side == Side::Right)]?));
        let rails = SIDES.into_iter().filter(is_there).filter_map(of).collect();
        Sprung { solver: self, rails, pose, velocity }.solve()
    }
}

impl Sprung<'_> {
    /// Solves this wheelset with its rails where their springs carry them.
    fn solve(&self) -> Result<SolvedWheelset, WheelsetError> {
        let sprung = &self.rails;
        let mut at = self.start_of_springs(sprung)?;
        let (mut solved, mut left) = self.left_over(sprung, &at)?;
        let mut jacobian: Option<DMatrix<f64>> = None;
        for _ in 0..ROUNDS {
            if is_met(sprung, &solved, &left) {
                for (k, (side, _)) in sprung.iter().enumerate() {
                    solved.deflect(*side, [at[2 * k], at[2 * k + 1]]);
                }
                return Ok(solved);
            }
            let slopes = match jacobian.take() {
                Some(known) => known,
                None => self.slopes(sprung, &at, &left)?,
            };
            let step = slopes.clone().lu().solve(&-&left);
            let mut step = step.ok_or(WheelsetError::RailNotFound)?;
            let longest = step.amax();
            if longest > LONGEST {
                step *= LONGEST / longest;
            }
            let Some(taken) = self.line_search(sprung, (&at, &left), &step) else {
                // Learnt slopes may mislead: once more by differences, unless these did.
                jacobian = Some(self.slopes(sprung, &at, &left)?);
                let fresh = jacobian.as_ref().is_some_and(|fresh| (fresh - &slopes).amax() == 0.0);
                if fresh {
                    return Err(WheelsetError::RailNotFound);
                }
                continue;
            };
            let (moved, next, over) = taken;
            // Broyden (1965).
            let missed = &over - &left - &slopes * &moved;
            let learnt = &slopes + missed * moved.transpose() / moved.norm_squared();
            at += moved;
            (solved, left, jacobian) = (next, over, Some(learnt));
        }
        Err(WheelsetError::RailNotFound)
    }

    /// The first of some ever shorter steps that leaves less; `None` where none does.
    #[allow(clippy::type_complexity)]
    fn line_search(
        &self,
        sprung: &[(Side, RailSprings)],
        (at, left): (&DVector<f64>, &DVector<f64>),
        step: &DVector<f64>,
    ) -> Option<(DVector<f64>, SolvedWheelset, DVector<f64>)> {
        const SHORTEST: u32 = 8;
        for halving in 0..SHORTEST {
            let moved = step * 0.5f64.powi(halving.cast_signed());
            // A step too far may leave the profiles: a shorter one does not.
            let Ok((solved, over)) = self.left_over(sprung, &(at + &moved)) else { continue };
            if over.norm() < left.norm() {
                return Some((moved, solved, over));
            }
        }
        None
    }

    /// Where rails lie at first: their springs under the load, or, at a given height, just below the wheel.
    fn start_of_springs(
        &self,
        sprung: &[(Side, RailSprings)],
    ) -> Result<DVector<f64>, WheelsetError> {
        const DEEP: f64 = 5e-5;
        let mut at = DVector::zeros(2 * sprung.len());
        for (k, (side, springs)) in sprung.iter().enumerate() {
            let load = self.pose.load.ok_or(WheelsetError::NoLoad)?;
            let carried = match load {
                Load::Height(z) => {
                    let (y, yaw) = (self.pose.y, self.pose.yaw);
                    let roll = self.pose.roll.unwrap_or(0.0);
                    let touch = self.solver.running().touch(*side, y, roll, yaw);
                    let side = *side;
                    let touch = touch.map_err(|source| WheelsetError::Position { side, source })?;
                    at[2 * k + 1] = (z - touch.z - DEEP).max(0.0);
                    continue;
                }
                Load::Axle(load) | Load::Loaded { load, .. } if self.pose.side.is_none() => {
                    0.5 * load
                }
                Load::Axle(load) | Load::Loaded { load, .. } => load,
                other => other.of_wheel(*side).unwrap_or(0.0),
            };
            at[2 * k + 1] = (carried + springs.force[1]) / springs.stiffness[1];
        }
        Ok(at)
    }

    /// The wheelset on rails that stand so, and what their springs do not carry (N).
    fn left_over(
        &self,
        sprung: &[(Side, RailSprings)],
        at: &DVector<f64>,
    ) -> Result<(SolvedWheelset, DVector<f64>), WheelsetError> {
        let mut track = self.solver.running().track().clone();
        for (k, (side, _)) in sprung.iter().enumerate() {
            let deviation = Deviation { y: at[2 * k], z: at[2 * k + 1], roll: 0.0 };
            track = track.displaced(*side, deviation).map_err(WheelsetError::geometry("rail"))?;
        }
        let running = self.solver.running().on_track(track);
        let solved = self.solver.on(&running).solve(self.pose, self.velocity)?;
        let mut left = DVector::zeros(at.len());
        for (k, (side, springs)) in sprung.iter().enumerate() {
            let wheel = solved.wheels().find(|wheel| wheel.side == *side);
            let force = wheel.map_or([0.0; 3], |wheel| wheel.on_rail().force);
            for axis in 0..2 {
                let carried = springs.stiffness[axis] * at[2 * k + axis] - springs.force[axis];
                left[2 * k + axis] = force[1 + axis] - carried;
            }
        }
        Ok((solved, left))
    }

    fn slopes(
        &self,
        sprung: &[(Side, RailSprings)],
        at: &DVector<f64>,
        left: &DVector<f64>,
    ) -> Result<DMatrix<f64>, WheelsetError> {
        let mut slopes = DMatrix::zeros(at.len(), at.len());
        for k in 0..at.len() {
            let mut moved = at.clone();
            moved[k] += STEP;
            let (_, over) = self.left_over(sprung, &moved)?;
            slopes.set_column(k, &((over - left) / STEP));
        }
        Ok(slopes)
    }
}

/// Whether springs carry what wheels press on their rails, to [`MET`] of it and the larger force on the springs.
fn is_met(sprung: &[(Side, RailSprings)], solved: &SolvedWheelset, left: &DVector<f64>) -> bool {
    sprung.iter().enumerate().all(|(k, (side, springs))| {
        let wheel = solved.wheels().find(|wheel| wheel.side == *side);
        let force = wheel.map_or([0.0; 3], |wheel| wheel.on_rail().force);
        let [_, y, z] = force.map(f64::abs);
        let size = y.max(z).max(springs.force[0].abs()).max(springs.force[1].abs());
        left[2 * k].abs().max(left[2 * k + 1].abs()) <= MET * size
    })
}
