//! Slopes at the nodes of a table, from its forces: along the three coordinates and their mixed derivatives.
//!
//! Beyond the ends of the angles the nodes go on as mirror images, so that slopes there are as
//! good as inside. Without spin, slopes along `t` are held so small that the force between
//! nodes rises where it rises from node to node (Fritsch and Carlson 1980).

use super::coordinates::Coordinates;
use super::hermite::{Angle, reflect};
use super::values::{Intervals, MIRROR_X, MIRROR_Y, Values};

/// Of `fx`, `fy` and `mz`: the force, then its derivative by `t`; each derived by the angles,
/// number `2 i + j` being derived `i` times by `theta` and `j` times by `phi`.
pub(crate) type Node = [[[f32; 4]; 2]; 3];

/// The nodes of one block, ready for interpolation.
pub(crate) fn nodes(values: &Values, coordinates: &Coordinates, intervals: Intervals) -> Vec<Node> {
    let by_t = along_t(values, coordinates, intervals);
    let mut nodes = vec![Node::default(); intervals.nodes()];
    for (k, plain) in [&values.forces, &by_t].into_iter().enumerate() {
        let by_phi = along_phi(plain, intervals);
        let mut by_theta = along_theta(plain, intervals, 1.0);
        let mut mixed = along_theta(&by_phi, intervals, -1.0);
        smooth_axis(&mut by_theta, &mut mixed, intervals);
        for (node, at) in nodes.iter_mut().enumerate() {
            for (derived, field) in [plain, &by_phi, &by_theta, &mixed].into_iter().enumerate() {
                for (component, value) in at.iter_mut().zip(field[node]) {
                    component[k][derived] = narrowed(value);
                }
            }
        }
    }
    nodes
}

#[allow(clippy::cast_possible_truncation)] // seven digits, far beyond a table's error
fn narrowed(value: f64) -> f32 {
    value as f32
}

/// Slopes along `t`; at zero creepage those of linear theory.
fn along_t(values: &Values, coordinates: &Coordinates, intervals: Intervals) -> Vec<[f64; 3]> {
    let mut slopes = vec![[0.0; 3]; intervals.nodes()];
    let [theta_axis, phi_axis] = [intervals.theta_axis(), intervals.phi_axis()];
    for theta in 0..=intervals.theta {
        for phi in 0..=intervals.phi {
            let departure = coordinates.departure(theta_axis.node(theta), phi_axis.node(phi));
            let start = intervals.index(theta, phi, 0);
            let line = start..=start + intervals.t;
            for i in 0..3 {
                let first = (0..3).map(|k| values.gains[i][k] * departure[k]).sum();
                let forces: Vec<f64> = values.forces[line.clone()].iter().map(|f| f[i]).collect();
                let mut found = line_slopes(&forces, first);
                if theta == intervals.theta && i < 2 {
                    keep_monotone(&forces, &mut found);
                }
                for (slope, found) in slopes[line.clone()].iter_mut().zip(found) {
                    slope[i] = found;
                }
            }
        }
    }
    slopes
}

/// Slopes of a line of values on [0, 1], those of the cubic spline with the first slope given: of
/// fourth order, and an end of the same order.
fn line_slopes(values: &[f64], first: f64) -> Vec<f64> {
    let last = values.len() - 1;
    let per_step = last as f64;
    // Each slope is `right - share * next`, from the node before to the one after.
    let mut solved = Vec::with_capacity(last);
    let (mut share, mut right) = (0.0, first);
    for k in 1..last {
        let sum = 3.0 * per_step * (values[k + 1] - values[k - 1]);
        let pivot = 1.0 / (4.0 - share);
        (share, right) = (pivot, pivot * (sum - right));
        solved.push([share, right]);
    }
    let end = |back: usize| values[last - back];
    let sum = per_step / 6.0 * (17.0 * end(0) - 9.0 * (end(1) + end(2)) + end(3));
    let mut slopes = vec![first; last + 1];
    slopes[last] = (sum - 3.0 * right) / (1.0 - 3.0 * share);
    for k in (1..last).rev() {
        let [share, right] = solved[k - 1];
        slopes[k] = right - share * slopes[k + 1];
    }
    slopes
}

/// Holds slopes within three times those of the chords at either side, and at zero where these
/// differ in sign. The first, of linear theory, stays.
fn keep_monotone(values: &[f64], slopes: &mut [f64]) {
    let count = (values.len() - 1) as f64;
    let chords: Vec<f64> = values.windows(2).map(|pair| (pair[1] - pair[0]) * count).collect();
    for k in 1..values.len() {
        let before = chords[k - 1];
        let after = chords.get(k).copied().unwrap_or(before);
        let bound = 3.0 * before.abs().min(after.abs());
        let agree = before * after > 0.0 && slopes[k] * before > 0.0;
        slopes[k] = if agree { slopes[k].clamp(-bound, bound) } else { 0.0 };
    }
}

/// Slopes along `phi`; beyond pure `eta` the sign of `xi` changes.
fn along_phi(field: &[[f64; 3]], intervals: Intervals) -> Vec<[f64; 3]> {
    let last = intervals.phi;
    let seen = |theta, phi: isize, t| {
        let inside = reflect(phi, last);
        let value = field[intervals.index(theta, inside.0, t)];
        if inside.1 { mirrored(value, MIRROR_X) } else { value }
    };
    slopes(intervals, 1, &intervals.phi_axis(), |[theta, phi, t], step| {
        seen(theta, phi.cast_signed() + step, t)
    })
}

/// Slopes along `theta`; beyond pure spin lies the opposite `phi`, as is beyond no spin, where the
/// spin's sign changes. `parity` is -1 for a field whose sign changes with that of `phi`.
fn along_theta(field: &[[f64; 3]], intervals: Intervals, parity: f64) -> Vec<[f64; 3]> {
    let seen = |theta: isize, phi: usize, t| {
        let (inside, beyond) = reflect(theta, intervals.theta);
        let phi = if beyond { intervals.phi - phi } else { phi };
        let value = field[intervals.index(inside, phi, t)];
        let mirror = if theta < 0 { MIRROR_X } else { MIRROR_Y };
        if beyond { mirrored(value, mirror).map(|v| parity * v) } else { value }
    };
    slopes(intervals, 0, &intervals.theta_axis(), |[theta, phi, t], step| {
        seen(theta.cast_signed() + step, phi, t)
    })
}

/// Slopes along `theta` (axis 0) or `phi` (1).
fn slopes(
    intervals: Intervals,
    axis: usize,
    angle: &Angle,
    near: impl Fn([usize; 3], isize) -> [f64; 3],
) -> Vec<[f64; 3]> {
    let mut slopes = Vec::with_capacity(intervals.nodes());
    for theta in 0..=intervals.theta {
        for phi in 0..=intervals.phi {
            for t in 0..=intervals.t {
                let around = [-3, -2, -1, 0, 1, 2, 3].map(|step| near([theta, phi, t], step));
                let node = [theta, phi][axis];
                let slope = |i| angle.slope(node, around.map(|force| force[i]));
                slopes.push([0, 1, 2].map(slope));
            }
        }
    }
    slopes
}

fn mirrored(value: [f64; 3], mirror: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| mirror[i] * value[i])
}

/// On the axis of spin a smooth function's slope by `theta` is a cosine or a sine of `phi`: so
/// that of `fx`, as its sign changes with that of `xi`, and these those of `fy` and `mz`.
fn smooth_axis(by_theta: &mut [[f64; 3]], mixed: &mut [[f64; 3]], intervals: Intervals) {
    let phi_axis = intervals.phi_axis();
    let waves: Vec<[f64; 2]> = (0..=intervals.phi)
        .map(|phi| phi_axis.node(phi).sin_cos())
        .map(|(sin, cos)| [sin, cos])
        .collect();
    for t in 0..=intervals.t {
        for i in 0..3 {
            let wave = usize::from(i == 0);
            let at = |phi: usize| intervals.index(0, phi, t);
            let size = (0..=intervals.phi).map(|phi| by_theta[at(phi)][i] * waves[phi][wave]);
            let norm: f64 = waves.iter().map(|both| both[wave] * both[wave]).sum();
            let amplitude = size.sum::<f64>() / norm;
            let change = if i == 0 { -amplitude } else { amplitude };
            for phi in 0..=intervals.phi {
                by_theta[at(phi)][i] = amplitude * waves[phi][wave];
                mixed[at(phi)][i] = change * waves[phi][1 - wave];
            }
        }
    }
}
