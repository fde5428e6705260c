//! `creepage stresses`: stresses inside the bodies.

use std::f64::consts::PI;

use crate::place::{Place, json};

const HEADER: &str = "x,y,z,sxx,syy,szz,sxy,syz,sxz,von_mises,tresca,s1,s2,s3,u,v,w";
const PEAK: f64 = 1.025e9;

/// A contact with these semi-axes and the peak pressure [`PEAK`].
fn case([a, b]: [f64; 2], friction: f64, longitudinal: f64, theory: &str) -> String {
    let force = 2.0 / 3.0 * PI * a * b * PEAK;
    format!(
        "upper = {{ shear_modulus = 82e9, poisson = 0.28 }}
        lower = {{ shear_modulus = 82e9, poisson = 0.28 }}
        [contact]
        normal_force = {force:?}
        friction = {friction:?}
        semi_axis_rolling = {a:?}
        semi_axis_lateral = {b:?}
        [creepage]
        longitudinal = {longitudinal:?}
        [solve]
        theory = \"{theory}\""
    )
}

fn rows(csv: &str) -> Vec<Vec<f64>> {
    assert_eq!(csv.lines().next(), Some(HEADER));
    let lines = csv.lines().skip(1);
    lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect()
}

/// Quadrature of the Boussinesq and Cerruti point forces to 1e-13, ten digits kept: semi-axes,
/// friction, then `x/a, y/b, z/s` with `s` the smaller semi-axis, and the stresses over the peak pressure
/// with that of von Mises.
type Reference = ([f64; 2], f64, &'static [[f64; 10]]);
const REFERENCE: [Reference; 2] = [
    (
        [5e-3, 5e-3],
        1e-9,
        &[
            [
                0.0,
                0.0,
                0.1,
                -0.596_646_152_7,
                -0.596_646_152_7,
                -0.990_099_009_9,
                0.0,
                0.0,
                0.0,
                0.393_452_857_2,
            ],
            [
                0.0,
                0.0,
                1.0,
                -0.024_690_350_85,
                -0.024_690_350_85,
                -0.5,
                0.0,
                0.0,
                0.0,
                0.475_309_649_1,
            ],
            [
                0.5,
                0.0,
                0.25,
                -0.308_222_244_8,
                -0.315_905_654_6,
                -0.792_959_034_5,
                0.0,
                0.0,
                -0.119_235_368_5,
                0.523_407_659_4,
            ],
        ],
    ),
    (
        [3.535_533_905_932_738e-3, 7.071_067_811_865_476e-3],
        0.3,
        &[
            [
                0.0,
                0.0,
                1.0,
                -0.042_303_330_99,
                -0.113_049_246_9,
                -0.632_455_532,
                0.0,
                0.0,
                -0.029_717_703_88,
                0.560_520_448_2,
            ],
            [
                0.5,
                0.0,
                0.25,
                -0.532_813_841_2,
                -0.434_546_888_8,
                -0.853_131_769_4,
                0.0,
                0.0,
                -0.266_910_598_5,
                0.597_879_953_3,
            ],
        ],
    ),
];

#[test]
fn full_sliding_is_that_of_the_point_forces() {
    for (axes, friction, points) in REFERENCE {
        let place = Place::new();
        place.write("case.toml", case(axes, friction, 1e-3, "saturated"));
        let minor = axes[0].min(axes[1]);
        let lines = points.iter().map(|[x, y, z, ..]| {
            format!("some,{:e},{:e},{:e}\n", z * minor, y * axes[1], x * axes[0])
        });
        let table = ["note,z,y,x\n".into()].into_iter().chain(lines).collect::<String>();
        place.write("points.csv", table);
        let found = rows(&place.run(&["stresses", "case.toml", "--points", "points.csv"]).done());
        assert_eq!(found.len(), points.len());
        for (row, [x, .., von_mises]) in found.iter().zip(points) {
            assert!((row[0] - x * axes[0]).abs() < 1e-18);
            assert!((row[9] / PEAK - von_mises).abs() < 1e-9, "{row:?}");
        }
        for (row, expected) in found.iter().zip(points) {
            for (found, expected) in row[3..9].iter().zip(&expected[3..9]) {
                // What friction of 1e-9 adds, and the digits of the reference.
                assert!((found / PEAK - expected).abs() < 1e-9, "{row:?} {expected}");
            }
            let [tresca, s1, s3] = [row[10], row[11], row[13]];
            assert!(s1 >= row[12] && row[12] >= s3 && (tresca - (s1 - s3)).abs() <= 1e-6);
        }
    }
}

const POINTS: &str = "x,y,z\n1e-3,2e-3,1e-3\n-4e-3,0,5e-4\n6e-3,-1e-3,3e-3\n0,0,0\n";

fn stresses(theory: &str, longitudinal: f64, body: &str) -> Vec<Vec<f64>> {
    let place = Place::new();
    place.write("case.toml", case([6e-3, 4e-3], 0.3, longitudinal, theory));
    place.write("points.csv", POINTS);
    let run = ["stresses", "case.toml", "--points", "points.csv", "--body", body];
    rows(&place.run(&run).done())
}

/// The reaction acts on the upper body; of the same material, it has the stresses of the lower one pushed
/// the other way.
#[test]
fn the_upper_body_is_pushed_the_other_way() {
    for theory in ["saturated", "fastsim"] {
        let lower = stresses(theory, -1e-3, "lower");
        for (one, other) in stresses(theory, 1e-3, "upper").iter().zip(lower) {
            for (one, other) in one.iter().zip(other) {
                // Rounding; fastsim's sweeps are mirror images.
                assert!((one - other).abs() < 1e-12 * PEAK, "{theory}: {one} {other}");
            }
        }
    }
}

/// Large creepage: elements against the closed form. The first three points lie below an eighth of
/// the smaller semi-axis, where the elements of the standard resolution are not seen any more.
#[test]
fn exact_at_large_creepage_is_full_sliding() {
    let closed = stresses("saturated", 0.1, "lower");
    for (one, other) in stresses("exact", 0.1, "lower").iter().zip(closed).take(3) {
        for (one, other) in one.iter().zip(other).skip(3) {
            assert!((one - other).abs() < 1e-3 * PEAK, "{one} {other}");
        }
    }
}

#[test]
fn without_points_the_largest_is_reported_and_drawn() {
    let place = Place::new();
    place.write("case.toml", case([5e-3, 5e-3], 1e-9, 1e-3, "saturated"));
    let text = place.run(&["stresses", "case.toml", "--out", "out"]).done();
    assert!(text.contains("Largest equivalent stress in the lower body"), "{text}");
    let files = ["stresses.csv", "stresses.png", "stresses.svg", "stresses.vtk"];
    assert_eq!(place.files_in("out"), files);
    let vtk = place.read("out/stresses.vtk");
    assert!(vtk.contains("DIMENSIONS 41 21 21\n") && vtk.contains("TENSORS stress_pa float\n"));
    // Nine lines of head, two of each scalar, one of the tensors.
    assert_eq!(vtk.lines().count(), 8 + 5 + (1 + 1 + 3) * 41 * 21 * 21);
    let section = rows(&place.read("out/stresses.csv"));
    assert_eq!(section.len(), 81 * 41);
    let report = json(&place.run(&["stresses", "case.toml", "--json"]).done());
    let largest = &report["largest_von_mises"][0];
    let number = |key: &str| largest[key].as_f64().unwrap();
    // On the axis of a circle `szz - sxx` is largest, .6295 at z = .4714 a for Poisson's ratio .28.
    assert!((number("von_mises") / PEAK - on_the_axis(number("z") / 5e-3)).abs() < 1e-6);
    for step in [-0.02, 0.02] {
        assert!(on_the_axis(number("z") / 5e-3 + step) < number("von_mises") / PEAK);
    }
    assert!(number("x").abs() < 1e-5 && number("y").abs() < 1e-5, "{largest}");
}

/// Von Mises over the peak pressure on the axis of a circle, at a depth over its radius.
fn on_the_axis(z: f64) -> f64 {
    let below = 1.0 / (1.0 + z * z);
    (-1.28 * (1.0 - z * (1.0 / z).atan()) + 1.5 * below).abs()
}

#[track_caller]
fn refused(points: &str, parts: &[&str]) {
    let place = Place::new();
    place.write("case.toml", case([5e-3, 5e-3], 0.3, 1e-3, "saturated"));
    place.write("points.csv", points);
    let run = ["stresses", "case.toml", "--points", "points.csv", "--out", "out"];
    place.run(&run).refused(&[parts, &["points.csv: "]].concat());
    assert_eq!(place.files(), ["case.toml", "points.csv"]);
}

#[test]
fn wrong_points_are_refused_with_row_and_column() {
    refused("", &["column x is missing"]);
    refused("x,y\n0,0\n", &["column z is missing"]);
    refused("x,y,z,x\n0,0,0,0\n", &["column x is there twice"]);
    refused("x,y,z\n0,0,0\n0,NaN,0\n", &["row 2, column y: `NaN` is not a finite number"]);
    refused("x,y,z\n0,,0\n", &["row 1, column y: `` is not a finite number"]);
    refused("x,y,z\n0,0,inf\n", &["row 1, column z: `inf`"]);
    refused("x,y,z\n0,0,0\n0,0,0\n0,0,-1e-3\n", &["row 3, column z: -0.001 is above the surface"]);
    refused("x,y,z\n0,0\n", &["2 fields"]);
}

#[test]
fn a_spreadsheets_separators_are_those_of_points() {
    let place = Place::new();
    place.write("case.toml", case([5e-3, 5e-3], 0.3, 1e-3, "saturated"));
    let printed = |points: &str| {
        place.write("points.csv", points);
        place.run(&["stresses", "case.toml", "--points", "points.csv"]).done()
    };
    let expected = printed("x,y,z\n0.001,0,0.002\n");
    assert_eq!(printed("x;y;z\n0,001;0;0,002\n"), expected);
    assert_eq!(printed("\u{feff}x\ty\tz\n0.001\t0\t0.002\n"), expected);
    assert_eq!(printed("x,y,z,note; more\n0.001,0,0.002,a\n"), expected);
}

#[test]
fn wrong_commands_are_refused() {
    let place = Place::new();
    place.write("case.toml", case([5e-3, 5e-3], 0.3, 1e-3, "saturated"));
    let run = ["stresses", "case.toml", "--points", "nowhere.csv"];
    place.run(&run).refused(&["cannot read nowhere.csv"]);
    place.run(&["stresses", "case.toml", "--theory", "exakt"]).refused(&["did you mean `exact`?"]);
    place.write("wanted.toml", case([5e-3, 5e-3], f64::NAN, 1e-3, "saturated"));
    place.run(&["stresses", "wanted.toml"]).refused(&["friction"]);
}

/// However far away, the stress is a number: that of a point force, and at last zero.
#[test]
fn no_place_is_without_a_stress() {
    let place = Place::new();
    place.write("case.toml", case([6e-3, 4e-3], 0.3, 1e-3, "fastsim"));
    place.write(
        "far.csv",
        "x,y,z\n0,0,10\n0,0,100\n-1e60,3,1e-3\n2,1e300,0\n1e-300,0,1e-300\n-1e308,1e308,1e308\n",
    );
    let found = rows(&place.run(&["stresses", "case.toml", "--points", "far.csv"]).done());
    assert!(found.iter().flatten().all(|value| value.is_finite()), "{found:?}");
    // Boussinesq: -3 N/(2 pi z^2) beneath, but for the tangential tractions' moment.
    let force = 2.0 / 3.0 * PI * 6e-3 * 4e-3 * PEAK;
    let right = -3.0 * force / (2.0 * PI * 100.0_f64.powi(2));
    assert!((found[1][5] / right - 1.0).abs() < 1e-4, "{:e} {right:e}", found[1][5]);
    assert!((found[0][5] / found[1][5] / 100.0 - 1.0).abs() < 1e-3, "{found:?}");
    assert!(found[2][3..14].iter().all(|value| value.abs() < 1e-100));
    // Displacements fall with the distance, stresses with its square.
    assert!(found[2][14..].iter().all(|value| value.abs() < 1e-50));
}
