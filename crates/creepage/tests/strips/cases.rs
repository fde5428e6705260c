//! The linear theory's coefficients and the reference cases.

use std::f64::consts::PI;

use creepage::Ellipse;
use creepage::rolling::linear::CreepageCoefficients;
use creepage::rolling::{Creepage, Force};
use serde_json::Value;

/// Converged `C11`, `C22`, `C23` for Poisson's ratio 0, 1/4, 1/2: harmonic basis, degree 91, good
/// to the digits shown.
const CONVERGED: [(f64, [[f64; 3]; 3]); 5] = [
    (
        0.2,
        [
            [2.591_414, 2.591_414, 0.483_502],
            [3.375_081, 2.632_568, 0.602_693],
            [4.819_276, 2.663_626, 0.806_294],
        ],
    ),
    (
        0.5,
        [
            [2.882_317, 2.882_317, 0.826_519],
            [3.625_345, 3.012_415, 0.927_978],
            [4.867_805, 3.144_275, 1.072_389],
        ],
    ),
    (
        1.0,
        [
            [3.395_305, 3.395_305, 1.333_333],
            [4.112_819, 3.668_295, 1.466_109],
            [5.204_177, 3.981_143, 1.630_958],
        ],
    ),
    (
        2.0,
        [
            [4.378_748, 4.378_748, 2.349_589],
            [5.100_137, 4.908_938, 2.624_197],
            [6.100_308, 5.579_585, 2.966_578],
        ],
    ),
    (
        5.0,
        [
            [6.997_688, 6.997_688, 5.718_175],
            [7.811_864, 8.190_043, 6.637_253],
            [8.837_854, 9.868_275, 7.901_937],
        ],
    ),
];

/// Between the three Poisson's ratios `1/C` is very nearly a parabola: against the converged
/// values for the circle and 0.28 it is good to 2e-5.
pub(crate) fn coefficients(a_over_b: f64, poisson: f64) -> CreepageCoefficients {
    let (_, rows) = CONVERGED.iter().find(|(ratio, _)| *ratio == a_over_b).unwrap();
    let p = 4.0 * poisson;
    let parabola = [(1.0 - p) * (2.0 - p) / 2.0, p * (2.0 - p), p * (p - 1.0) / 2.0];
    let value = |i| 1.0 / (0..3).map(|k| parabola[k] / rows[k][i]).sum::<f64>();
    let [c11, c22, c23] = [0, 1, 2].map(value);
    // The theories under test do not use C33.
    CreepageCoefficients { c11, c22, c23, c32: -c23, c33: f64::NAN }
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

pub(crate) fn creepage(xi: f64, eta: f64, chi: f64) -> Creepage {
    Creepage { xi, eta, chi }
}

pub(crate) fn array(force: Force) -> [f64; 3] {
    [force.fx, force.fy, force.mz]
}

pub(crate) fn largest_difference(one: [f64; 3], other: [f64; 3]) -> f64 {
    (0..3).map(|i| (one[i] - other[i]).abs()).fold(0.0, f64::max)
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

/// 132 cases of the full theory.
pub(crate) fn steady_rolling() -> Vec<Case> {
    cases(&serde_json::from_str(include_str!("../data/steady_rolling.json")).unwrap())
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
        let error = largest_difference(solve(case), expected);
        compared += 1;
        if error > worst.0 {
            worst = (error, format!("{} {:?} expected {expected:?}", case.id, solve(case)));
        }
    }
    assert!(compared > 10);
    worst
}

/// Root mean square and largest error of `(fx, fy)` against the full theory, and root mean
/// square error of `mz`.
pub(crate) fn error_against_full_theory(solve: impl Fn(&Case) -> [f64; 3]) -> [f64; 3] {
    let (mut squares, mut largest, mut moments) = (0.0, 0.0_f64, 0.0);
    let cases = steady_rolling();
    assert_eq!(cases.len(), 132);
    for case in &cases {
        let exact = ["fx", "fy", "mz"].map(|key| case.json[key].as_f64().unwrap());
        let force = solve(case);
        let error = (force[0] - exact[0]).hypot(force[1] - exact[1]);
        squares += error * error;
        largest = largest.max(error);
        moments += (force[2] - exact[2]).powi(2);
    }
    let mean = |sum: f64| (sum / cases.len() as f64).sqrt();
    [mean(squares), largest, mean(moments)]
}
