//! The last steps to the position at which the rails carry the load: by the fine pressures
//! themselves and their stiffness, without a search.

use creepage_rail::{Position, Side};

use super::normal_contact::PressedWheel;
use crate::warm_start::LateralForceRatios;
use crate::{Load, WheelsetPose};

/// A wheel's position and what it is expected to carry there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub(crate) side: Side,
    pub(crate) position: Position,
    /// As of [`PressedWheel::depth`].
    pub(crate) depth: f64,
    /// Vertical force on the rail (N).
    pub(crate) expected: f64,
    /// How far the step went down (m) and rolled (rad) that led here.
    moved: [f64; 2],
    /// How the force changes as the wheelset goes down (N/m) and rolls (N/rad), where that is known.
    by: Option<[f64; 2]>,
}

impl Place {
    /// Those of wheels that nearly carry their load.
    pub(crate) fn of(
        wheels: &[PressedWheel<'_>],
        stance: &WheelsetPose,
        load: Load,
        shares: &LateralForceRatios,
    ) -> Vec<Self> {
        let sum = wheels.iter().map(|wheel| wheel.expected(shares)).sum();
        let place = |wheel: &PressedWheel<'_>| {
            let &PressedWheel { side, position, depth, .. } = wheel;
            let of = [sum, wheels.len() as f64];
            Self::new(
                side,
                position,
                depth,
                wanted((stance, side), load, wheel.expected(shares), of),
            )
        };
        wheels.iter().map(place).collect()
    }

    pub(crate) fn new(side: Side, position: Position, depth: f64, expected: f64) -> Self {
        Self { side, position, depth, expected, moved: [0.0; 2], by: None }
    }

    /// The same with how the force is known to change.
    pub(crate) fn changing(self, by: Option<[f64; 2]>) -> Self {
        Self { by, ..self }
    }

    /// How the force changes as the wheelset goes down (N/m) and rolls (N/rad), where that is known.
    pub(crate) fn by(&self) -> Option<[f64; 2]> {
        self.by
    }

    /// How the force changes here: what is known of it, changed by what the step that led here missed, as
    /// far as that is believed and was no trifle; the stiffness where nothing is known.
    pub(crate) fn learn(
        &mut self,
        wheel: &PressedWheel<'_>,
        shares: &LateralForceRatios,
        belief: BroydenPolicy,
    ) {
        /// Parts of the force by which it scatters, as friction and the tips of areas do.
        const SCATTER: f64 = 3e-4;
        let shares = shares.of_fine();
        let missed = wheel.vertical(&shares) - self.expected;
        let [down, turn] = self.moved;
        let tells = |by: [f64; 2]| {
            let change = (by[0] * down + by[1] * turn).abs();
            belief != BroydenPolicy::None && change.max(missed.abs()) > SCATTER * self.expected
        };
        let change = |by| if tells(by) { learnt(by, self.moved, missed, belief) } else { Some(by) };
        let stiffness = || [wheel.stiffness(&shares), wheel.stiffness_by_roll(&shares)];
        self.by = Some(self.by.and_then(change).unwrap_or_else(stiffness));
    }
}

/// How far a step is believed that tells how a force changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum BroydenPolicy {
    /// Not at all: it compares other things.
    None,
    /// Unless the change would be another one altogether.
    WithinReason,
    /// Whatever it tells: on what was known before, steps lead farther away, as on a flange that climbs.
    Whole,
}

/// How a force changes as the wheelset goes down and rolls, from how it was thought to and what the step
/// `moved` missed (Broyden 1965): the plane of two areas turns as the load shifts, and friction
/// changes, which no stiffness knows. `None` where that is not believed.
pub(crate) fn learnt(
    by: [f64; 2],
    moved: [f64; 2],
    missed: f64,
    belief: BroydenPolicy,
) -> Option<[f64; 2]> {
    let ([by_down, by_turn], [down, turn]) = (by, moved);
    // Rolling by an angle is as much as going down by it times the wheel's lever.
    let square = (by_turn / by_down).powi(2);
    let part = missed / (down * down + square * turn * turn);
    let changed = by_down + part * down;
    let is_sound = changed > 0.5 * by_down && changed < 2.0 * by_down;
    (is_sound || belief == BroydenPolicy::Whole)
        .then_some([changed, by_turn + part * square * turn])
}

/// What a wheel should carry (N) that carries `own`, of the sum of some wheels.
pub(crate) fn wanted(
    (stance, side): (&WheelsetPose, Side),
    load: Load,
    own: f64,
    [sum, count]: [f64; 2],
) -> f64 {
    if let Some(load) = load.of_wheel(side) {
        return load;
    }
    match load {
        Load::Wheel(load) => load,
        Load::Axle(load) | Load::Loaded { load, .. } if stance.roll.is_some() => load * own / sum,
        Load::Axle(load) | Load::Loaded { load, .. } => load / count,
        Load::Wheels([left, right]) => left.midpoint(right),
        Load::Height(_) => sum / count,
    }
}

/// Vertical forces (N), and how they change as the wheelset goes down (N/m) and rolls (N/rad).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Line {
    pub(crate) force: f64,
    pub(crate) by: [f64; 2],
}

/// Where wheels with fine pressures should go, in a straight line; `None` where that is too far for
/// one, or nothing presses.
pub(crate) fn places(
    (here, wheels): (&[Place], &[PressedWheel<'_>]),
    stance: &WheelsetPose,
    load: Load,
    shares: &LateralForceRatios,
) -> Option<Vec<Place>> {
    /// Of a wheel's load: beyond, a step has less left of it than a search.
    const FARTHEST: f64 = 0.1;
    let shares = shares.of_fine();
    let line = |(place, wheel): (&Place, &PressedWheel<'_>)| {
        Some(Line { force: wheel.vertical(&shares), by: place.by? })
    };
    let lines: Vec<Line> = here.iter().zip(wheels).map(line).collect::<Option<_>>()?;
    let moves = moves(&lines, stance.roll.or(stance.side.map(|_| 0.0)), load)?;
    let place = |((wheel, line), [down, turn]): ((&PressedWheel<'_>, &Line), [f64; 2])| {
        let parts = [line.by[0] * down, line.by[1] * turn];
        let more = parts[0] + parts[1];
        let Position { y, z, roll, yaw } = wheel.position;
        let position = Position { y, z: z + down, roll: roll + turn, yaw };
        let depth = if wheel.depth > 0.0 { wheel.depth + more / line.by[0] } else { 0.0 };
        let is_sound = parts.iter().all(|part| part.abs() <= line.force);
        let is_near = more.abs() <= FARTHEST * line.force && is_sound && depth >= 0.0;
        is_near.then(|| Place {
            moved: [down, turn],
            by: Some(line.by),
            ..Place::new(wheel.side, position, depth, line.force + more)
        })
    };
    wheels.iter().zip(&lines).zip(moves).map(place).collect()
}

/// How far each wheel goes down and rolls; `roll` is the given one.
pub(crate) fn moves(lines: &[Line], roll: Option<f64>, load: Load) -> Option<Vec<[f64; 2]>> {
    let down = |line: &Line, load: f64| [(load - line.force) / line.by[0], 0.0];
    match (lines, roll, load) {
        ([line], _, Load::Axle(load) | Load::Wheel(load)) => Some(vec![down(line, load)]),
        ([_, _], Some(_), Load::Wheel(load)) => {
            Some(lines.iter().map(|line| down(line, load)).collect())
        }
        // A lifted wheel stays where it hangs.
        ([left, right], Some(_), Load::Wheels(loads)) => {
            let moves = [left, right].into_iter().zip(loads);
            let moves =
                moves.map(|(line, load)| if load > 0.0 { down(line, load) } else { [0.0; 2] });
            Some(moves.collect())
        }
        ([left, right], Some(_), Load::Axle(load)) => {
            let by = left.by[0] + right.by[0];
            Some(vec![[(load - left.force - right.force) / by, 0.0]; 2])
        }
        ([left, right], None, Load::Height(_)) => {
            Some(vec![[0.0, (left.force - right.force) / (right.by[1] - left.by[1])]; 2])
        }
        ([left, right], None, Load::Axle(load)) => {
            Some(vec![level([left, right], [0.5 * load; 2]); 2])
        }
        ([left, right], None, Load::Wheel(load)) => Some(vec![level([left, right], [load; 2]); 2]),
        ([left, right], None, Load::Wheels(loads)) => Some(vec![level([left, right], loads); 2]),
        _ => None,
    }
}

/// Down and roll at which both wheels carry their loads.
fn level([left, right]: [&Line; 2], loads: [f64; 2]) -> [f64; 2] {
    let [a, b] = [loads[0] - left.force, loads[1] - right.force];
    let determinant = left.by[0] * right.by[1] - left.by[1] * right.by[0];
    [a * right.by[1] - b * left.by[1], b * left.by[0] - a * right.by[0]].map(|n| n / determinant)
}
