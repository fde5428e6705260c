//! Vertical load balance: Newton's step in height and roll that meets the prescribed vertical forces.
//!
//! The load of a wheel rises with its depth to the power 3/2 (Hertz 1882). Newton's method therefore acts on forces to
//! the power 2/3, which are nearly linear in height and roll: one step from a third or from three times the load
//! comes near it, and a wheel that hangs above its rail goes on the same line below zero.

use creepage_rail::Side;

use crate::{Load, WheelsetError, WheelsetPose};

/// A wheel's vertical force to the power 2/3, and its change as the wheelset goes down (1/m) and rolls (1/rad).
/// Below zero where the wheel hangs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LoadLine {
    pub(crate) root: f64,
    pub(crate) by: [f64; 2],
}

impl LoadLine {
    /// Of a force (N) with its changes (N/m and N/rad).
    pub(crate) fn of_force(force: f64, by: [f64; 2]) -> Self {
        let per_force = if force > 0.0 { 2.0 / 3.0 / force.cbrt() } else { 0.0 };
        Self { root: root(force), by: by.map(|by| per_force * by) }
    }

    /// The force (N); none where the wheel hangs.
    pub(crate) fn force(&self) -> f64 {
        self.root.max(0.0).powf(1.5)
    }

    /// The same after the wheelset went down (m) and rolled (rad).
    pub(crate) fn after(&self, [down, turn]: [f64; 2]) -> Self {
        Self { root: self.root + self.by[0] * down + self.by[1] * turn, ..*self }
    }

    /// With slopes learnt from how far this line lies beside the one that a step `moved` led to expect (Broyden
    /// 1965): friction and the direction of the contact change along with the load, and areas join, which no stiffness
    /// knows. Where the step tells less than the scatter of forces does, those expected; the stiffness where slopes
    /// change too much to be any.
    pub(crate) fn update_slopes(&mut self, expected: &Self, moved: [f64; 2]) {
        let learnt = self.secant(expected, moved).unwrap_or(expected.by);
        if is_sound(learnt, expected.by) && is_sound(learnt, self.by) {
            self.by = learnt;
        }
    }

    /// Slopes that meet this root from the one expected, by Broyden's update: rolling by an angle is as much as going
    /// down by it times the wheel's lever. `None` where the step tells less than the scatter of forces does.
    fn secant(&self, expected: &Self, [down, turn]: [f64; 2]) -> Option<[f64; 2]> {
        /// Parts of the force by which it scatters, as friction and the tips of areas do.
        const SCATTER: f64 = 2e-4;
        let [by_down, by_turn] = expected.by;
        let missed = self.root - expected.root;
        let change = (by_down * down + by_turn * turn).abs();
        let square = (by_turn / by_down).powi(2);
        let size = down * down + square * turn * turn;
        let tells = size > 0.0 && change.max(missed.abs()) >= SCATTER * self.root.abs();
        let part = missed / size;
        tells.then_some([by_down + part * down, by_turn + part * square * turn])
    }
}

/// Whether slopes are within ten times others: beyond, forces jump or scatter.
fn is_sound(by: [f64; 2], other: [f64; 2]) -> bool {
    const SOUND: [f64; 2] = [0.1, 10.0];
    by[0] > SOUND[0] * other[0] && by[0] < SOUND[1] * other[0]
}

/// A force (N) to the power 2/3.
fn root(force: f64) -> f64 {
    force.max(0.0).cbrt().powi(2)
}

/// Prescribed vertical forces on both rails, or on one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Target {
    /// Nothing: height and roll are given.
    Nothing,
    /// Each wheel has its load (N), at a height of its own; one without a load hangs at the other's.
    OwnHeights([f64; 2]),
    /// Each wheel has its load (N), at one height and roll.
    Level([f64; 2]),
    /// All wheels carry this load (N) together, at one height.
    Together(f64),
    /// Both wheels carry alike at a given height, at some roll.
    Alike,
}

impl Target {
    /// What a wheelset carries whose wheels have these levers about `x` (m), by which a moment tells their loads.
    pub(crate) fn new(stance: &WheelsetPose, levers: [f64; 2]) -> Result<Self, WheelsetError> {
        let load = stance.load.ok_or(WheelsetError::NoLoad)?;
        let each = |[left, right]: [f64; 2]| match (stance.roll, stance.side) {
            (None, None) => Self::Level([left, right]),
            _ => Self::OwnHeights([left, right]),
        };
        Ok(match load {
            Load::Height(_) if stance.is_fixed() => Self::Nothing,
            Load::Height(_) => Self::Alike,
            Load::Wheel(load) => each([load; 2]),
            Load::Wheels(loads) => {
                let mut hanging = [Side::Left, Side::Right].into_iter().zip(loads);
                match (each(loads), hanging.find(|(_, load)| *load <= 0.0)) {
                    (Self::Level(_), Some((side, _))) => return Err(WheelsetError::Hangs { side }),
                    (each, _) => each,
                }
            }
            Load::Axle(load) | Load::Loaded { load, .. } if stance.side.is_some() => {
                Self::OwnHeights([load; 2])
            }
            Load::Axle(load) | Load::Loaded { load, .. } if stance.roll.is_some() => {
                Self::Together(load)
            }
            Load::Axle(load) => Self::Level([0.5 * load; 2]),
            Load::Loaded { .. } => {
                let shared = load.by_levers(levers);
                let loads = [Side::Left, Side::Right].map(|side| shared.of_wheel(side));
                for (side, load) in [Side::Left, Side::Right].into_iter().zip(loads) {
                    if let Some(load) = load.filter(|load| load.is_nan() || *load <= 0.0) {
                        return Err(WheelsetError::Lifts { side, load });
                    }
                }
                Self::Level(loads.map(|load| load.unwrap_or(f64::NAN)))
            }
        })
    }

    /// The load (N) of a wheel where it is asked for.
    pub(crate) fn of_wheel(&self, side: Side) -> Option<f64> {
        match self {
            Self::OwnHeights(loads) | Self::Level(loads) => {
                Some(loads[usize::from(side == Side::Right)])
            }
            Self::Nothing | Self::Together(_) | Self::Alike => None,
        }
    }

    /// All that is asked for (N), as wheels carry it that are `sides`.
    pub(crate) fn sum(&self, sides: &[Side]) -> Option<f64> {
        match self {
            Self::Together(load) => Some(*load),
            Self::OwnHeights(_) | Self::Level(_) => {
                sides.iter().map(|side| self.of_wheel(*side)).sum()
            }
            Self::Nothing | Self::Alike => None,
        }
    }

    /// What wheels that carry such forces (N) miss of it each (N).
    pub(crate) fn missed(&self, forces: &[(Side, f64)]) -> Vec<f64> {
        let sum: f64 = forces.iter().map(|(_, force)| force).sum();
        let missed = |&(side, force): &(Side, f64)| match self {
            Self::Nothing => 0.0,
            Self::OwnHeights(_) | Self::Level(_) => force - self.of_wheel(side).unwrap_or(force),
            // Each its part of what all of them miss.
            Self::Together(load) => (sum - load) * if sum > 0.0 { force / sum } else { 1.0 },
            Self::Alike => force - 0.5 * sum,
        };
        forces.iter().map(missed).collect()
    }

    /// How far each wheel should go down (m) and roll (rad); `None` where nothing presses or slopes are no use.
    pub(crate) fn step(&self, lines: &[(Side, LoadLine)]) -> Option<Vec<[f64; 2]>> {
        let short =
            |line: &LoadLine, side: Side| root(self.of_wheel(side).unwrap_or(0.0)) - line.root;
        let step = match (self, lines) {
            (Self::Nothing, _) => vec![[0.0; 2]; lines.len()],
            (Self::OwnHeights(loads), _) => {
                let down = |(side, line): &(Side, LoadLine)| short(line, *side) / line.by[0];
                let carries = lines.iter().find(|(side, _)| self.of_wheel(*side) > Some(0.0))?;
                let hangs = loads.contains(&0.0).then(|| down(carries));
                lines.iter().map(|line| [hangs.unwrap_or_else(|| down(line)), 0.0]).collect()
            }
            (Self::Together(load), _) => {
                let all = together(lines);
                vec![[(root(*load) - all.root) / all.by[0], 0.0]; lines.len()]
            }
            (Self::Level(_), [(_, left), (_, right)]) => {
                let [a, b] = [short(left, Side::Left), short(right, Side::Right)];
                let determinant = left.by[0] * right.by[1] - left.by[1] * right.by[0];
                let step = [a * right.by[1] - b * left.by[1], b * left.by[0] - a * right.by[0]];
                vec![step.map(|part| part / determinant); 2]
            }
            (Self::Alike, [(_, left), (_, right)]) => {
                vec![[0.0, (left.root - right.root) / (right.by[1] - left.by[1])]; 2]
            }
            _ => return None,
        };
        step.iter().flatten().all(|part| part.is_finite()).then_some(step)
    }

    /// The residual: the largest deviation of what is carried from what is asked for, both to the power 2/3 and in
    /// parts of the latter.
    pub(crate) fn residual(&self, lines: &[(Side, LoadLine)]) -> f64 {
        match (self, lines) {
            (Self::Nothing, _) => 0.0,
            (Self::Together(load), _) => (together(lines).root / root(*load) - 1.0).abs(),
            (Self::Alike, [(_, left), (_, right)]) => {
                let size = left.root.max(right.root);
                // A wheelset that hangs above its rails carries nothing and misses nothing.
                if size > 0.0 { (right.root - left.root).abs() / size } else { 0.0 }
            }
            _ => {
                let wheels = lines.iter().filter_map(|(side, line)| {
                    let load = self.of_wheel(*side).filter(|load| *load > 0.0)?;
                    Some((line.root / root(load) - 1.0).abs())
                });
                wheels.fold(0.0, f64::max)
            }
        }
    }

    /// The force (N) to the power 2/3 by which changes of a wheel's line are measured.
    pub(crate) fn scale(&self, side: Side, lines: &[(Side, LoadLine)]) -> f64 {
        match self {
            Self::Together(load) => root(*load),
            Self::OwnHeights(_) | Self::Level(_) => root(self.of_wheel(side).unwrap_or(0.0)),
            Self::Nothing | Self::Alike => {
                lines.iter().map(|(_, line)| line.root).fold(0.0, f64::max)
            }
        }
    }
}

/// The line of the sum of all forces; that of the wheel nearest to its rail where all hang.
fn together(lines: &[(Side, LoadLine)]) -> LoadLine {
    let force: f64 = lines.iter().map(|(_, line)| line.force()).sum();
    if force > 0.0 {
        // From roots to forces: dF = 3/2 F^(1/3) d(F^(2/3)).
        let by = |k: usize| -> f64 {
            lines.iter().map(|(_, line)| 1.5 * line.force().cbrt() * line.by[k]).sum()
        };
        return LoadLine::of_force(force, [by(0), by(1)]);
    }
    let nearest = lines.iter().max_by(|a, b| a.1.root.total_cmp(&b.1.root));
    nearest.map_or(LoadLine::of_force(0.0, [0.0; 2]), |(_, line)| *line)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// Hertz's springs of both wheels, `lever` to the sides: forces by height and roll.
    fn lines(z: f64, roll: f64, stiff: [f64; 2]) -> Vec<(Side, LoadLine)> {
        const LEVER: f64 = 0.75;
        let line = |(side, stiff): (Side, f64)| {
            let lever = if side == Side::Left { -LEVER } else { LEVER };
            let depth = z + lever * roll;
            let by = 1.5 * stiff * depth.max(0.0).sqrt();
            let force = stiff * depth.max(0.0).powf(1.5);
            let line = LoadLine::of_force(force, [by, by * lever]);
            // A wheel that hangs: the line goes on.
            let slope = stiff.cbrt().powi(2);
            let by = [slope, slope * lever];
            let hangs = LoadLine { root: slope * depth, by };
            (side, if depth > 0.0 { line } else { hangs })
        };
        [(Side::Left, stiff[0]), (Side::Right, stiff[1])].map(line).to_vec()
    }

    /// Springs of Hertz have straight lines, so one step arrives from anywhere: to rounding.
    #[test]
    fn one_step_meets_hertzian_loads_from_anywhere() {
        let stiff = [9e10, 7e10];
        for target in [Target::Level([60e3, 45e3]), Target::OwnHeights([60e3, 45e3]), Target::Alike]
        {
            for (z, roll) in [(5e-5, 0.0), (3e-6, 1e-6), (1e-3, -2e-4), (1e-5, 1e-4)] {
                let here = lines(z, roll, stiff);
                let step = target.step(&here).unwrap();
                let there: Vec<_> = here
                    .iter()
                    .zip(&step)
                    .map(|((side, line), moved)| (*side, line.after(*moved)))
                    .collect();
                assert!(target.residual(&there) < 1e-12, "{target:?} {z} {roll}");
                if target != Target::Alike {
                    let forces: Vec<_> =
                        there.iter().map(|(side, line)| (*side, line.force())).collect();
                    let missed = target.missed(&forces);
                    assert!(missed.iter().all(|force| force.abs() < 1e-6), "{missed:?}");
                }
            }
        }
    }

    /// The slope of a sum is that of its difference, to the square of the step.
    #[test]
    fn slope_of_both_wheels_together_is_that_of_a_difference() {
        let at = |z: f64| together(&lines(z, 2e-5, [9e10, 7e10]));
        let (low, high) = (at(4.999e-5), at(5.001e-5));
        let difference = (high.root - low.root) / 2e-8;
        assert!((at(5e-5).by[0] / difference - 1.0).abs() < 1e-6);
    }

    /// Broyden's update meets the secant of the step, and keeps the slope across it.
    #[test]
    fn learnt_slopes_meet_the_secant() {
        let before = LoadLine { root: 1500.0, by: [2e7, 1.5e7] };
        let moved = [1e-6, -2e-6];
        let expected = before.after(moved);
        let mut found = LoadLine { root: expected.root + 3.0, by: [2.1e7, 1.6e7] };
        found.update_slopes(&expected, moved);
        let secant = found.by[0] * moved[0] + found.by[1] * moved[1];
        assert!((secant - (found.root - before.root)).abs() < 1e-9);
    }

    /// A root that jumps by two per cent along a nanometre teaches nothing, nor does a slope from there serve on.
    #[test]
    fn a_jump_leaves_the_stiffness() {
        let before = LoadLine { root: 1500.0, by: [2e7, 1.5e7] };
        let (moved, stiffness) = ([1e-9, 0.0], [2.1e7, 1.6e7]);
        let mut found = LoadLine { root: 1530.0, by: stiffness };
        found.update_slopes(&before.after(moved), moved);
        assert_eq!(found.by.map(f64::to_bits), stiffness.map(f64::to_bits));
        let steep = LoadLine { by: [3e8, 2e8], ..before };
        found.update_slopes(&steep, [0.0; 2]);
        assert_eq!(found.by.map(f64::to_bits), stiffness.map(f64::to_bits));
    }
}
