//! Rails without mass on springs, by Newton's method: they move until the springs carry what the wheels press on them.
//!
//! The unknowns are the deviations of the sprung rails, the residual what the wheel presses on its rail, less
//! what its springs carry, plus what else acts on it. Newton's method with a line search, its Jacobian by
//! differences and then by Broyden's updates: contacts are a hundred times stiffer than springs, so that a fixed
//! point of force over stiffness diverges. Where forces do not fall as a rail recedes, as when a wheel climbs, each
//! deviation is bracketed. A rail under a given load goes down by what that takes: no unknown. Under a wheel of given
//! height the search begins where the wheel alone stands so high: its load is sought, under which its rail is easily found.

use std::cell::Cell;

use creepage::numerics::{Root, broyden_update};
use creepage_rail::{Deviation, Side};
use nalgebra::{DMatrix, DVector};

use crate::error::WheelsetError;
use crate::pose::{Load, WheelsetPose, WheelsetVelocity};
use crate::solved::SolvedWheelset;
use crate::solver::{Target, WheelsetSolver};

/// Springs of a rail, across and down, and forces that act on it beside the wheel's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RailSprings {
    /// Stiffness (N/m).
    pub stiffness: [f64; 2],
    /// Forces (N).
    pub force: [f64; 2],
}

const SIDES: [Side; 2] = [Side::Left, Side::Right];
/// Steps of the differences across and down (m): forces scatter by some newtons, and contacts are stiff.
const DIFFERENCE_STEPS: [f64; 2] = [5e-6, 5e-7];
/// First radius of the trust region (m): contacts change their shape within it.
const FIRST_RADIUS: f64 = 5e-5;
/// It doubles where the change of forces was foreseen but for this part.
const GOOD: f64 = 0.25;
/// Longest step (m) from which a wheelset is solved beside the last position.
const MAX_WARM_STEP: f64 = 1e-4;
/// Part of the wheel's force to which springs carry it; by which loads are met at least; and below which each position
/// is solved by itself.
const SPRING_TOLERANCE: f64 = 1e-5;
const LOAD_TOLERANCE: f64 = 1e-4;
const ALONE_BELOW: f64 = 1e-3;
/// Part of their error bars to which loads are met.
const PART_OF_ERROR: f64 = 0.2;
/// The narrowest bracket (m): forces jump in it.
const NARROW: f64 = 1e-11;
const MAX_STEPS: usize = 40;
/// Positions that are solved at most: seconds.
const MAX_POSITIONS: usize = 200;
/// Of all rails, in turn; and how often a bracket may grow.
const MAX_SWEEPS: usize = 6;
const MAX_EXPANSIONS: usize = 8;

/// A wheelset on rails of which some lie on springs.
struct Sprung<'a> {
    solver: &'a WheelsetSolver<'a>,
    rails: Vec<(Side, RailSprings)>,
    pose: &'a WheelsetPose,
    velocity: &'a WheelsetVelocity,
    /// Where the left and the right rail lie across at first (m).
    across: [f64; 2],
    /// How many positions may still be solved.
    budget: Cell<usize>,
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
        let (across, budget) = ([0.0; 2], Cell::new(MAX_POSITIONS));
        Sprung { solver: self, rails, pose, velocity, across, budget }.solve()
    }
}

impl Sprung<'_> {
    /// By Newton's method, and where forces do not fall as a rail recedes by brackets.
    fn solve(&self) -> Result<SolvedWheelset, WheelsetError> {
        let (at, unknown) = self.first_place()?;
        let first = self.left_over(&at, None, &unknown)?;
        // A rail that slides away under its wheel says nothing of the profiles.
        match self.by_newton(at.clone(), first.clone(), &unknown) {
            Ok(Some(solved)) => Ok(solved),
            Ok(None) | Err(_) => self.by_brackets(at, first, &unknown),
        }
        .map_err(|_| WheelsetError::RailNotFound)
    }

    /// Newton's method; `None` where it stagnates.
    fn by_newton(
        &self,
        mut at: DVector<f64>,
        (mut solved, mut left): (SolvedWheelset, DVector<f64>),
        unknown: &[bool],
    ) -> Result<Option<SolvedWheelset>, WheelsetError> {
        let mut jacobian: Option<DMatrix<f64>> = None;
        let mut radius = FIRST_RADIUS;
        for _ in 0..MAX_STEPS {
            if self.is_met(&solved, &left) {
                return Ok(Some(self.deflected(solved, &at)));
            }
            let mut slopes = match jacobian.take() {
                Some(known) => known,
                None => self.slopes(&at, &left, &solved, unknown)?,
            };
            let step = slopes.clone().lu().solve(&-&left);
            let Some(mut step) = step.filter(|_| self.falls(&slopes, unknown)) else {
                return Ok(None);
            };
            let length = step.amax();
            step *= (radius / length).min(1.0);
            let next = self.line_search((&at, &left), &step, &solved, unknown);
            let Some((moved, next, over)) = next else {
                if self.is_met_within_errors(&solved, &left) {
                    return Ok(Some(self.deflected(solved, &at)));
                }
                return Ok(None);
            };
            let change = &over - &left;
            let missed = broyden_update(&mut slopes, &moved, &change);
            let is_foreseen = missed < GOOD * change.norm();
            radius = if is_foreseen { 2.0 * radius } else { moved.amax().min(radius) };
            at += moved;
            (solved, left, jacobian) = (next, over, Some(slopes));
        }
        Ok(None)
    }

    /// Whether what springs do not carry falls as each rail under a given load gives way, by half of what the spring
    /// alone does at least.
    fn falls(&self, slopes: &DMatrix<f64>, unknown: &[bool]) -> bool {
        self.rails.iter().enumerate().all(|(k, (_, springs))| {
            let (across, down) = (2 * k, 2 * k + 1);
            unknown[down] || slopes[(across, across)] < -0.5 * springs.stiffness[0]
        })
    }

    /// Each deviation by a bracketed root, in turn until all springs carry what presses on them.
    fn by_brackets(
        &self,
        mut at: DVector<f64>,
        mut last: (SolvedWheelset, DVector<f64>),
        unknown: &[bool],
    ) -> Result<SolvedWheelset, WheelsetError> {
        for _ in 0..MAX_SWEEPS {
            // The worst first: mirror images go the same way.
            let mut columns: Vec<usize> = (0..at.len()).filter(|column| unknown[*column]).collect();
            columns.sort_by(|a, b| last.1[*b].abs().total_cmp(&last.1[*a].abs()));
            for column in columns {
                last = self.crossing(&mut at, last, column, unknown)?;
            }
            if self.is_met_within_errors(&last.0, &last.1) {
                return Ok(self.deflected(last.0, &at));
            }
        }
        Err(WheelsetError::RailNotFound)
    }

    /// Moves one deviation to where its spring carries what presses on it: between here and where the spring carries
    /// what presses here, or farther.
    fn crossing(
        &self,
        at: &mut DVector<f64>,
        (mut solved, mut left): (SolvedWheelset, DVector<f64>),
        column: usize,
        unknown: &[bool],
    ) -> Result<(SolvedWheelset, DVector<f64>), WheelsetError> {
        let stiffness = self.rails[column / 2].1.stiffness[column % 2];
        let (mut near, value) = (at[column], left[column]);
        let mut far = near;
        for _ in 0..MAX_EXPANSIONS {
            if self.is_alone_met(&solved, &left, column) {
                return Ok((solved, left));
            }
            if left[column] * value <= 0.0 {
                break;
            }
            near = at[column];
            let step = left[column] / stiffness;
            let mut found = None;
            // Too far the profiles end.
            for halving in 0..MAX_EXPANSIONS {
                at[column] = near + step * 0.5f64.powi(i32::try_from(halving).unwrap_or(i32::MAX));
                found = self.left_over(at, None, unknown).ok();
                if found.is_some() {
                    break;
                }
            }
            far = at[column];
            (solved, left) = found.ok_or(WheelsetError::RailNotFound)?;
        }
        if left[column] * value > 0.0 {
            return Err(WheelsetError::RailNotFound);
        }
        let mut root = Root::new(far, [near.min(far), near.max(far)]);
        for _ in 0..MAX_STEPS {
            let from = ((root.at - at[column]).abs() < MAX_WARM_STEP
                && !self.is_close(&solved, &left))
            .then_some(&solved);
            at[column] = root.at;
            (solved, left) = self.left_over(at, from, unknown)?;
            if self.is_alone_met(&solved, &left, column) || root.is_spent(NARROW) {
                break;
            }
            root.next(-left[column], None);
        }
        Ok((solved, left))
    }

    fn deflected(&self, mut solved: SolvedWheelset, at: &DVector<f64>) -> SolvedWheelset {
        for (k, (side, _)) in self.rails.iter().enumerate() {
            solved.deflect(*side, [at[2 * k], at[2 * k + 1]]);
        }
        solved
    }

    /// The first of some ever shorter steps that leaves less; `None` where none does.
    #[allow(clippy::type_complexity)]
    fn line_search(
        &self,
        (at, left): (&DVector<f64>, &DVector<f64>),
        step: &DVector<f64>,
        from: &SolvedWheelset,
        unknown: &[bool],
    ) -> Option<(DVector<f64>, SolvedWheelset, DVector<f64>)> {
        const SHORTEST: u32 = 8;
        // Close to the solution forces must not depend on the way there.
        let from = (!self.is_close(from, left) && step.amax() < MAX_WARM_STEP).then_some(from);
        for halving in 0..SHORTEST {
            let moved = step * 0.5f64.powi(halving.cast_signed());
            // A step too far may leave the profiles: a shorter one does not.
            let Ok((solved, over)) = self.left_over(&(at + &moved), from, unknown) else {
                continue;
            };
            if over.norm() < left.norm() {
                return Some((moved, solved, over));
            }
        }
        None
    }

    /// Where rails lie at first: their springs under the load, or, at a given height, just below the wheel.
    ///
    /// And which deviations are unknown: a rail under a wheel whose load is given goes down by so much as that takes.
    fn first_place(&self) -> Result<(DVector<f64>, Vec<bool>), WheelsetError> {
        const DEEP: f64 = 5e-5;
        let mut unknown = vec![true; 2 * self.rails.len()];
        let mut at = DVector::zeros(2 * self.rails.len());
        for (k, (side, springs)) in self.rails.iter().enumerate() {
            let load = self.pose.load.ok_or(WheelsetError::NoLoad)?;
            at[2 * k] = self.across[usize::from(*side == Side::Right)];
            if let Load::Height(z) = load {
                if let Some(place) = self.place_at_height(*side, *springs, z) {
                    (at[2 * k], at[2 * k + 1]) = (place[0], place[1]);
                    continue;
                }
                let (y, yaw) = (self.pose.y, self.pose.yaw);
                let roll = self.pose.roll.unwrap_or(0.0);
                let touch = self.solver.running().touch(*side, y, roll, yaw);
                let side = *side;
                let touch = touch.map_err(|source| WheelsetError::Position { side, source })?;
                at[2 * k + 1] = (z - touch.z - DEEP).max(0.0);
                continue;
            }
            let levers = self.solver.start().levers;
            let target = Target::new(self.pose, levers)?;
            let all = target.sum(&[*side]).unwrap_or(0.0);
            let carried = target.of_wheel(*side).unwrap_or(0.5 * all);
            at[2 * k + 1] = (carried + springs.force[1]) / springs.stiffness[1];
            unknown[2 * k + 1] = match load {
                Load::Loaded { .. } => self.pose.side.is_none(),
                _ => target.of_wheel(*side).is_none(),
            };
        }
        Ok((at, unknown))
    }

    /// Where a rail lies under a wheel alone whose height is `z` (m): a bracketed root in the load, up to which rail and
    /// contact give way. `None` where none is found.
    fn place_at_height(&self, side: Side, springs: RailSprings, z: f64) -> Option<[f64; 2]> {
        let unloaded = [0, 1].map(|axis: usize| springs.force[axis] / springs.stiffness[axis]);
        let roll = self.pose.roll.unwrap_or(0.0);
        let touch = self.solver.running().touch(side, self.pose.y, roll, self.pose.yaw).ok()?;
        let given_way = z - touch.z - unloaded[1];
        if given_way <= 0.0 {
            return Some(unloaded);
        }
        let under = |load: f64, across: f64| -> Option<([f64; 2], f64)> {
            let pose =
                WheelsetPose { side: Some(side), load: Some(Load::Wheel(load)), ..*self.pose };
            let budget = Cell::new(self.budget.get());
            let (rails, across) = (vec![(side, springs)], [across; 2]);
            let alone = Sprung { rails, pose: &pose, across, budget, ..*self };
            let solved = alone.solve();
            self.budget.set(alone.budget.get());
            let solved = solved.ok()?;
            let wheel = solved.wheels().find(|wheel| wheel.side == side)?;
            Some((wheel.deflection?, solved.position().z - z))
        };
        // The contact gives way too: the rail alone would carry more.
        let most = springs.stiffness[1] * given_way;
        let mut root = Root::new(0.9 * most, [0.0, 2.0 * most]);
        let mut found = under(root.at, 0.0)?;
        for _ in 0..MAX_STEPS {
            if found.1.abs() <= SPRING_TOLERANCE * given_way
                || root.is_spent(SPRING_TOLERANCE * most)
            {
                break;
            }
            root.next_by_chord(found.1, springs.stiffness[1].recip());
            found = under(root.at, found.0[0])?;
        }
        Some(found.0)
    }

    /// The wheelset on rails that stand so, and what their springs do not carry (N); from a solved place beside it.
    fn left_over(
        &self,
        at: &DVector<f64>,
        from: Option<&SolvedWheelset>,
        unknown: &[bool],
    ) -> Result<(SolvedWheelset, DVector<f64>), WheelsetError> {
        let budget = self.budget.get().checked_sub(1).ok_or(WheelsetError::RailNotFound)?;
        self.budget.set(budget);
        let mut track = self.solver.running().track().clone();
        for (k, (side, _)) in self.rails.iter().enumerate() {
            let deviation = Deviation { y: at[2 * k], z: at[2 * k + 1], roll: 0.0 };
            track = track.displaced(*side, deviation).map_err(WheelsetError::geometry("rail"))?;
        }
        let running = self.solver.running().on_track(track);
        let solver = self.solver.on(&running);
        let solved = match from {
            Some(from) => solver.next(from, self.pose, self.velocity)?,
            None => solver.solve(self.pose, self.velocity)?,
        };
        let mut left = DVector::zeros(at.len());
        for (k, (side, springs)) in self.rails.iter().enumerate() {
            let force = on_rail(&solved, *side);
            for axis in 0..2 {
                let carried = springs.stiffness[axis] * at[2 * k + axis] - springs.force[axis];
                let missed = force[1 + axis] - carried;
                left[2 * k + axis] = if unknown[2 * k + axis] { missed } else { 0.0 };
            }
        }
        Ok((solved, left))
    }

    /// Changes of what springs do not carry as each rail moves across and down, by differences.
    fn slopes(
        &self,
        at: &DVector<f64>,
        left: &DVector<f64>,
        from: &SolvedWheelset,
        unknown: &[bool],
    ) -> Result<DMatrix<f64>, WheelsetError> {
        let mut slopes = DMatrix::zeros(at.len(), at.len());
        for (k, (_, springs)) in self.rails.iter().enumerate() {
            for (axis, step) in DIFFERENCE_STEPS.into_iter().enumerate() {
                let column = 2 * k + axis;
                if !unknown[column] {
                    slopes[(column, column)] = -springs.stiffness[axis];
                    continue;
                }
                let mut moved = at.clone();
                moved[column] += step;
                let (_, over) = self.left_over(&moved, Some(from), unknown)?;
                slopes.set_column(column, &((over - left) / step));
            }
        }
        // What is known is no residual.
        for row in (0..at.len()).filter(|row| !unknown[*row]) {
            for column in (0..at.len()).filter(|column| *column != row) {
                slopes[(row, column)] = 0.0;
            }
        }
        Ok(slopes)
    }

    /// What a spring does not carry, over the larger of what presses on the rail and acts on the springs.
    fn missed(&self, solved: &SolvedWheelset, left: &DVector<f64>, column: usize) -> f64 {
        let (side, springs) = &self.rails[column / 2];
        let [_, y, z] = on_rail(solved, *side).map(f64::abs);
        let size = y.max(z).max(springs.force[0].abs()).max(springs.force[1].abs());
        left[column].abs() / size
    }

    fn worst(&self, solved: &SolvedWheelset, left: &DVector<f64>) -> f64 {
        (0..left.len()).map(|column| self.missed(solved, left, column)).fold(0.0, f64::max)
    }

    fn is_met(&self, solved: &SolvedWheelset, left: &DVector<f64>) -> bool {
        self.worst(solved, left) <= SPRING_TOLERANCE
    }

    fn is_close(&self, solved: &SolvedWheelset, left: &DVector<f64>) -> bool {
        self.worst(solved, left) <= ALONE_BELOW
    }

    fn is_alone_met(&self, solved: &SolvedWheelset, left: &DVector<f64>, column: usize) -> bool {
        self.missed(solved, left, column) <= SPRING_TOLERANCE
    }

    /// Whether springs carry what presses on their rails to within what forces scatter: as loads are met, to a part and
    /// a fifth of their error bars.
    fn is_met_within_errors(&self, solved: &SolvedWheelset, left: &DVector<f64>) -> bool {
        (0..left.len()).all(|column| {
            let side = self.rails[column / 2].0;
            let wheel = solved.wheels().find(|wheel| wheel.side == side);
            let error = wheel.and_then(|wheel| wheel.on_rail().force_error);
            let error = error.map_or(0.0, |error| error[1 + column % 2]);
            left[column].abs() <= PART_OF_ERROR * error
                || self.missed(solved, left, column) <= LOAD_TOLERANCE
        })
    }
}

/// Force of a wheel on its rail (N); none of a wheel that was not solved.
fn on_rail(solved: &SolvedWheelset, side: Side) -> [f64; 3] {
    let wheel = solved.wheels().find(|wheel| wheel.side == side);
    wheel.map_or([0.0; 3], |wheel| wheel.on_rail().force)
}
