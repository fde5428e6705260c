//! How fast errors fall.

use creepage::coulomb::Resolution;
use creepage::unsteady::Rolling;

use super::support::{circle, coarse, contact, creeping};

/// Force after a creepage that comes and goes smoothly, each step with its mean.
fn force(mut rolling: Rolling, steps: u32) -> f64 {
    let length = 2.0 / f64::from(steps);
    // Mean over a step of sin^2(pi q / 4).
    let risen = |q: f64| 0.5 * q - (0.5 * std::f64::consts::PI * q).sin() / std::f64::consts::PI;
    let mut force = 0.0;
    for k in 0..steps {
        let [from, to] = [k, k + 1].map(|k| risen(f64::from(k) * length));
        let motion = creeping(0.8 * (to - from) / length, 0.0, 0.2);
        force = rolling.advance(length, &motion).unwrap().solution.force.fx;
    }
    force
}

/// Second order at least: halving the step takes three quarters off the error.
#[test]
fn errors_fall_with_the_square_of_the_step() {
    let truth = force(circle(coarse()), 320);
    let errors = [10, 20, 40, 80].map(|steps| (force(circle(coarse()), steps) - truth).abs());
    assert!(errors.windows(2).all(|pair| pair[1] < pair[0] / 4.0), "{errors:?}");
    assert!(errors[3] < 1e-5, "{errors:?}");
}

#[test]
fn errors_fall_with_the_size_of_elements() {
    let of = |n: usize| {
        let resolution = Resolution::new(n, n).unwrap();
        force(Rolling::new(&contact(1.0, 0.28), resolution).unwrap(), 40)
    };
    let truth = of(32);
    let errors = [8, 16].map(|n| (of(n) - truth).abs());
    assert!(errors[1] < errors[0] / 2.0 && errors[1] < 1e-3, "{errors:?}");
}

/// Steps much shorter than elements: the force goes on smoothly, and so does every traction.
#[test]
fn short_steps_make_no_wiggles() {
    let mut rolling = circle(coarse());
    let motion = creeping(0.5, 0.0, 0.0);
    let mut forces = Vec::new();
    for _ in 0..80 {
        forces.push(rolling.advance(0.005, &motion).unwrap().solution.force.fx);
    }
    let bends = forces.windows(3).map(|f| (f[2] - 2.0 * f[1] + f[0]).abs());
    let step = forces[1] - forces[0];
    let largest = bends.fold(0.0, f64::max);
    assert!(largest < 0.1 * step, "{largest} {step}");
    // Along the middle strip the traction of adhesion rises from the leading edge without ups and downs.
    let middle = rolling.elements().into_iter().filter(|e| e.point.position[1].abs() < 0.15);
    let adhering = middle.filter(|e| e.point.region == creepage::Region::Adhesion);
    let tractions: Vec<f64> = adhering.map(|e| e.point.traction[0]).collect();
    let bends = tractions.windows(3).map(|p| p[2] - 2.0 * p[1] + p[0]);
    let turns = bends.collect::<Vec<_>>();
    let alternating = turns.windows(3).filter(|b| b[0] * b[1] < -1e-6 && b[1] * b[2] < -1e-6);
    assert!(alternating.count() == 0, "{tractions:?}");
}
