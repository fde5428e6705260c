//! The last steps to the position at which the rails carry the load: by the fine pressures
//! themselves and their stiffness, without a search.

use creepage_rail::{Position, Side};

use super::pressed::{PressedWheel, Shares};
use crate::{Load, Stance};

/// A wheel's position and what it is expected to carry there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) side: Side,
    pub(super) position: Position,
    /// As of [`PressedWheel::depth`].
    pub(super) depth: f64,
    /// Vertical force on the rail (N).
    pub(super) expected: f64,
}

impl Place {
    /// That of a wheel as it is.
    pub(super) fn of(wheel: &PressedWheel<'_>, shares: &Shares) -> Self {
        let &PressedWheel { side, position, depth, .. } = wheel;
        Self { side, position, depth, expected: wheel.expected(shares) }
    }
}

/// Vertical forces (N), and how they change as the wheelset goes down (N/m) and rolls (N/rad).
struct Line {
    force: f64,
    by: [f64; 2],
}

/// Where wheels with fine pressures should go, in a straight line; `None` where that is too far for
/// one, or nothing presses.
pub(super) fn places(
    wheels: &[PressedWheel<'_>],
    stance: &Stance,
    load: Load,
    shares: &Shares,
) -> Option<Vec<Place>> {
    /// Of a wheel's load: beyond, a step has less left of it than a search.
    const FARTHEST: f64 = 0.1;
    let shares = shares.of_fine();
    let lines: Vec<Line> = wheels
        .iter()
        .map(|wheel| Line {
            force: wheel.vertical(&shares),
            by: [wheel.stiffness(&shares), wheel.stiffness_by_roll(&shares)],
        })
        .collect();
    let moves = moves(&lines, stance.roll.or(stance.side.map(|_| 0.0)), load)?;
    let place = |((wheel, line), [down, turn]): ((&PressedWheel<'_>, &Line), [f64; 2])| {
        let more = line.by[0] * down + line.by[1] * turn;
        let Position { y, z, roll, yaw } = wheel.position;
        let position = Position { y, z: z + down, roll: roll + turn, yaw };
        let depth = if wheel.depth > 0.0 { wheel.depth + more / line.by[0] } else { 0.0 };
        let is_near = more.abs() < FARTHEST * line.force && depth >= 0.0;
        is_near.then_some(Place { side: wheel.side, position, depth, expected: line.force + more })
    };
    wheels.iter().zip(&lines).zip(moves).map(place).collect()
}

/// How far each wheel goes down and rolls.
fn moves(lines: &[Line], roll: Option<f64>, load: Load) -> Option<Vec<[f64; 2]>> {
    let down = |line: &Line, load: f64| [(load - line.force) / line.by[0], 0.0];
    match (lines, roll, load) {
        ([line], _, Load::Axle(load) | Load::Wheel(load)) => Some(vec![down(line, load)]),
        ([_, _], Some(_), Load::Wheel(load)) => {
            Some(lines.iter().map(|line| down(line, load)).collect())
        }
        ([left, right], Some(_), Load::Axle(load)) => {
            let by = left.by[0] + right.by[0];
            Some(vec![[(load - left.force - right.force) / by, 0.0]; 2])
        }
        ([left, right], None, Load::Height(_)) => {
            Some(vec![[0.0, (left.force - right.force) / (right.by[1] - left.by[1])]; 2])
        }
        ([left, right], None, Load::Axle(load)) => Some(vec![level(left, right, 0.5 * load); 2]),
        ([left, right], None, Load::Wheel(load)) => Some(vec![level(left, right, load); 2]),
        _ => None,
    }
}

/// Down and roll at which both wheels carry `load`.
fn level(left: &Line, right: &Line, load: f64) -> [f64; 2] {
    let [a, b] = [load - left.force, load - right.force];
    let determinant = left.by[0] * right.by[1] - left.by[1] * right.by[0];
    [a * right.by[1] - b * left.by[1], b * left.by[0] - a * right.by[0]].map(|n| n / determinant)
}
