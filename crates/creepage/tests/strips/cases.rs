//! The linear theory's coefficients and the reference cases.

use std::f64::consts::PI;

use creepage::Ellipse;
use creepage::approximate::linear::CreepageCoefficients;
use creepage::{Creepage, Force, Theory};
use serde_json::Value;

pub(crate) fn coefficients(a_over_b: f64, poisson: f64) -> CreepageCoefficients {
    CreepageCoefficients::new(&contact(a_over_b, poisson)).unwrap()
}

/// Those of narrow strips in plane strain, the limit of `a/b -> 0` (for `nu = 0`; strips cannot
/// see how `C23` grows for others).
pub(crate) fn strip_coefficients(a_over_b: f64, poisson: f64) -> CreepageCoefficients {
    let c23 = PI / 3.0 * a_over_b.sqrt();
    let (c22, c33) = (PI * PI / 4.0, PI * PI / (16.0 * (1.0 - poisson)) / a_over_b);
    CreepageCoefficients { c11: c22 / (1.0 - poisson), c22, c23, c32: -c23, c33 }
}

/// The linear theory's factor, `3 (1 - nu) E / (4 pi sqrt(g))`.
pub(crate) fn kappa(a_over_b: f64, poisson: f64) -> f64 {
    let ellipse = Ellipse::from_ratio(a_over_b).unwrap();
    3.0 * (1.0 - poisson) * ellipse.integrals().e / (4.0 * PI * ellipse.g().sqrt())
}

use crate::common::steady_rolling;
pub(crate) use crate::common::{contact, creepage};

pub(crate) fn array(force: Force) -> [f64; 3] {
    [force.fx, force.fy, force.mz]
}

pub(crate) fn largest_difference(one: [f64; 3], other: [f64; 3]) -> f64 {
    (0..3).map(|i| (one[i] - other[i]).abs()).fold(0.0, f64::max)
}

/// Force and moment as the sums of the field's tractions over `n` strips of `n` cells.
pub(crate) fn sum_of_field(
    theory: &dyn Theory,
    a_over_b: f64,
    n: usize,
    creepage: Creepage,
) -> [f64; 3] {
    let (a, b) = (f64::sqrt(a_over_b), f64::sqrt(a_over_b).recip());
    let mut sum = [0.0; 3];
    for j in 0..n {
        let t = (2 * j + 1) as f64 / n as f64 - 1.0;
        let half_length = a * f64::sqrt(1.0 - t * t);
        let x = |i: usize| half_length * (1.0 - (2 * i + 1) as f64 / n as f64);
        let positions: Vec<_> = (0..n).map(|i| [x(i), b * t]).collect();
        let area = 4.0 * half_length * b / (n * n) as f64;
        for point in theory.field(creepage, &positions) {
            let [tx, ty] = point.traction.map(|v| v * 1.5 / PI * area);
            sum[0] += tx;
            sum[1] += ty;
            sum[2] += point.position[0] * ty - point.position[1] * tx;
        }
    }
    sum
}

/// Creepages within the usual range, and some far beyond, of every sign.
pub(crate) const CREEPAGES: [[f64; 3]; 10] = [
    [0.2, 0.0, 0.0],
    [0.0, -0.9, 0.0],
    [0.0, 0.0, 0.7],
    [0.6, 0.4, 0.0],
    [0.5, -0.866, 0.5],
    [-0.3, 0.2, 0.9],
    [-1.4, -0.5, 0.3],
    [0.3, 0.7, -0.6],
    [0.8, -0.2, -2.0],
    [2.0, 1.0, 5.0],
];

/// A case of a reference file.
pub(crate) struct Case {
    pub(crate) id: String,
    pub(crate) a_over_b: f64,
    pub(crate) poisson: f64,
    pub(crate) creepage: Creepage,
    pub(crate) json: Value,
}

fn cases(list: &Value) -> Vec<Case> {
    let number = |case: &Value, key: &str| case[key].as_f64().unwrap();
    list.as_array()
        .unwrap()
        .iter()
        .map(|case| Case {
            id: case["id"].as_str().unwrap().to_owned(),
            a_over_b: number(case, "a_over_b"),
            poisson: number(case, "poisson"),
            creepage: creepage(number(case, "xi"), number(case, "eta"), number(case, "chi")),
            json: case.clone(),
        })
        .collect()
}

/// 40 cases by the approximate theories.
pub(crate) fn approximate() -> Vec<Case> {
    let file: Value = serde_json::from_str(include_str!("../data/approximate.json")).unwrap();
    cases(&file["cases"])
}

/// The largest difference to `variant` of the approximate cases of which `select` is true, and
/// the case's name.
pub(crate) fn largest_error(
    variant: &str,
    select: impl Fn(&Case) -> bool,
    solve: impl Fn(&Case) -> [f64; 3],
) -> (f64, String) {
    let mut worst = (0.0, String::new());
    let mut compared = 0;
    for case in approximate().iter().filter(|case| select(case)) {
        let expected = [0, 1, 2].map(|i| case.json["own"][variant][i].as_f64().unwrap());
        let expected = if variant.starts_with("fastsim") { bounded(expected) } else { expected };
        let error = largest_difference(solve(case), expected);
        compared += 1;
        if error > worst.0 {
            worst = (error, format!("{} {:?} expected {expected:?}", case.id, solve(case)));
        }
    }
    assert!(compared > 10);
    worst
}

/// The other implementation's sum of the bound over cells is a little beyond `mu N`, where forces here end.
fn bounded([fx, fy, mz]: [f64; 3]) -> [f64; 3] {
    let size = fx.hypot(fy).max(1.0);
    [fx / size, fy / size, mz]
}

/// Root mean square and largest error of `(fx, fy)` against 132 cases of the full theory, and
/// root mean square error of `mz`.
pub(crate) fn error_against_full_theory<T: Theory + 'static>(
    prepare: impl Fn(f64, f64) -> T,
) -> [f64; 3] {
    let cases = steady_rolling();
    let (mut squares, mut worst) = ([0.0; 2], 0.0_f64);
    for case in &cases {
        let force = prepare(case.a_over_b, case.poisson).solve(case.creepage()).force;
        let error = (force.fx - case.fx).hypot(force.fy - case.fy);
        squares[0] += error * error;
        squares[1] += (force.mz - case.mz).powi(2);
        worst = worst.max(error);
    }
    let [force, moment] = squares.map(|sum| (sum / cases.len() as f64).sqrt());
    [force, worst, moment]
}
