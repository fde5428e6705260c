//! Smallest enclosing ball of the states of stress of a passage, by Frank and Wolfe's method: the heart of Melan's and
//! Dang Van's criteria.
//!
//! In the coordinates of [`coordinates`] the distance of two states is von Mises's stress of their
//! difference. A residual stress moves the centre, along the first `FREE` coordinates only. The dual of
//! the problem weighs the states; steps towards the farthest and away from the nearest of the weighed
//! states (Frank and Wolfe, with away steps) converge geometrically, and any centre gives a valid
//! bound.

use crate::subsurface::Stress;

/// A deviator: the square of its length is that of von Mises's stress.
pub(super) type Deviator = [f64; 5];

/// `xx - (yy + zz)/2`, `sqrt(3)/2 (yy - zz)`, then `sqrt 3` times `xy`, `xz`, `yz`: a stress `xx` alone
/// moves the first only, `xx` and `yy` the first two.
pub(super) fn coordinates(stress: &Stress) -> Deviator {
    let root = 3.0_f64.sqrt();
    [
        stress.xx - 0.5 * (stress.yy + stress.zz),
        0.5 * root * (stress.yy - stress.zz),
        root * stress.xy,
        root * stress.xz,
        root * stress.yz,
    ]
}

/// A deviatoric state from its coordinates.
pub(super) fn deviator([first, second, xy, xz, yz]: Deviator) -> Stress {
    let root = 3.0_f64.sqrt();
    Stress {
        xx: 2.0 / 3.0 * first,
        yy: -first / 3.0 + second / root,
        zz: -first / 3.0 - second / root,
        xy: xy / root,
        yz: yz / root,
        xz: xz / root,
    }
}

/// The centre and its largest distance from a state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ball {
    pub centre: Deviator,
    pub radius: f64,
}

const MAX_FRANK_WOLFE_STEPS: usize = 1000;

/// The smallest ball around `states` whose centre has zeros beyond its first `free` coordinates.
pub(super) fn smallest(states: &[Deviator], free: usize) -> Ball {
    let mut weights = vec![0.0; states.len()];
    let mut centre = [0.0; 5];
    let Some(first) = farthest(states, centre) else { return Ball { centre, radius: 0.0 } };
    weights[first] = 1.0;
    centre[..free].copy_from_slice(&states[first][..free]);
    for _ in 0..MAX_FRANK_WOLFE_STEPS {
        let value: f64 = sum_of_squares(states, &weights, centre);
        let Some(far) = farthest(states, centre) else { break };
        let Some(near) = nearest(states, &weights, centre) else { break };
        let ahead = square(states[far], centre) - value;
        let away = value - square(states[near], centre);
        if ahead <= 1e-13 * value {
            break;
        }
        if ahead >= away {
            step(states, &mut weights, &mut centre, free, far, ahead, 1.0);
        } else {
            let most = -weights[near] / (1.0 - weights[near]).max(f64::MIN_POSITIVE);
            step(states, &mut weights, &mut centre, free, near, -away, most);
        }
    }
    let radius = farthest(states, centre).map_or(0.0, |far| square(states[far], centre).sqrt());
    Ball { centre, radius }
}

/// Moves the weight towards a state (or away, for a negative slope), as far as it helps.
fn step(
    states: &[Deviator],
    weights: &mut [f64],
    centre: &mut Deviator,
    free: usize,
    toward: usize,
    slope: f64,
    most: f64,
) {
    let apart: f64 = (0..free).map(|i| (states[toward][i] - centre[i]).powi(2)).sum();
    let best = 0.5 * slope / apart.max(f64::MIN_POSITIVE);
    let share = if most > 0.0 { best.min(most) } else { best.max(most) };
    for weight in weights.iter_mut() {
        *weight *= 1.0 - share;
    }
    weights[toward] = (weights[toward] + share).max(0.0);
    for i in 0..free {
        centre[i] += share * (states[toward][i] - centre[i]);
    }
}

fn square(state: Deviator, centre: Deviator) -> f64 {
    state.iter().zip(centre).map(|(one, two)| (one - two).powi(2)).sum()
}

fn sum_of_squares(states: &[Deviator], weights: &[f64], centre: Deviator) -> f64 {
    states.iter().zip(weights).map(|(state, weight)| weight * square(*state, centre)).sum()
}

fn farthest(states: &[Deviator], centre: Deviator) -> Option<usize> {
    let by_distance = |one: &usize, two: &usize| {
        square(states[*one], centre).total_cmp(&square(states[*two], centre))
    };
    (0..states.len()).max_by(by_distance)
}

fn nearest(states: &[Deviator], weights: &[f64], centre: Deviator) -> Option<usize> {
    let by_distance = |one: &usize, two: &usize| {
        square(states[*one], centre).total_cmp(&square(states[*two], centre))
    };
    (0..states.len()).filter(|&k| weights[k] > 0.0).min_by(by_distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_von_mises_stresses() {
        let stress = Stress { xx: 1.0, yy: -0.4, zz: 0.3, xy: 0.2, yz: -0.7, xz: 0.5 };
        let length = square(coordinates(&stress), [0.0; 5]).sqrt();
        assert!((length - stress.von_mises()).abs() < 1e-15);
        let back = deviator(coordinates(&stress)).plus(-1.0, &stress.deviator());
        assert!(back.components().iter().all(|value| value.abs() < 1e-15));
    }

    #[test]
    fn known_balls() {
        // A triangle in the plane of the first two: its circumscribed circle.
        let corners = [[1.0, 0.0], [-0.5, 0.75_f64.sqrt()], [-0.5, -(0.75_f64.sqrt())]];
        let states = corners.map(|[x, y]| [2.0 + x, y - 1.0, 0.0, 0.3, 0.0]);
        let ball = smallest(&states, 3);
        // The residual of the iteration.
        assert!((ball.radius - (1.09_f64).sqrt()).abs() < 1e-9, "{ball:?}");
        assert!((ball.centre[0] - 2.0).abs() < 1e-9 && (ball.centre[1] + 1.0).abs() < 1e-9);
        // Two states: half their distance; what cannot be moved counts in full.
        let pair = [[1.0, 0.0, 0.0, 0.0, 0.4], [-1.0, 0.0, 0.0, 0.0, 0.4]];
        assert!((smallest(&pair, 1).radius - (1.16_f64).sqrt()).abs() < 1e-12);
        assert!(smallest(&[], 3).radius.abs() < 1e-300);
    }
}
