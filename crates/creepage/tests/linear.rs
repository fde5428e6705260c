//! Creepage and spin coefficients against closed forms and a converged solution. Table 3 itself is
//! compared in `creepage-1967`.

mod common;

use std::f64::consts::PI;

use common::{at, contact, creepage, try_contact};
use creepage::approximate::linear::{CreepageCoefficients, Linear};
use creepage::special::CompleteIntegrals;
use creepage::{Creepage, Region, Theory};
use serde_json::Value;

const CONVERGED: &str = include_str!("data/creepage_coefficients_converged.json");

fn ratio(kind: &str, g: f64) -> f64 {
    if kind == "a/b" { g } else { g.recip() }
}

/// The reference is a solution of degree 91 with another criterion; its stated error is
/// absolute, and below rounding (a few units of 1e-15) for `sigma = 0`.
#[test]
fn converged_values() {
    let cases: Vec<Value> = serde_json::from_str(CONVERGED).unwrap();
    assert_eq!(cases.len(), 57);
    for case in &cases {
        let number = |name: &str| case[name].as_f64().unwrap();
        let a_over_b = ratio(case["ratio"].as_str().unwrap(), number("g"));
        let c = CreepageCoefficients::new(&contact(a_over_b, number("sigma"))).unwrap();
        for (value, name) in
            [(c.c11, "C11"), (c.c22, "C22"), (c.c23, "C23"), (c.c32, "C32"), (c.c33, "C33")]
        {
            let error = (value - number(name)).abs();
            let bound = number("est_abs_err") + 1e-14 * value.abs();
            assert!(error <= bound, "{name} at a/b = {a_over_b}: off by {error:e} > {bound:e}");
        }
    }
}

/// `C23` for `sigma = 0` in terms of `B` and `D` (section 4.3).
#[test]
fn c23_without_poisson_contraction() {
    for a_over_b in [1e-3, 0.03, 0.4, 1.0, 2.0, 50.0, 1e3] {
        let g = f64::min(a_over_b, 1.0 / a_over_b);
        let integrals = CompleteIntegrals::new(g);
        let expected = if a_over_b <= 1.0 {
            PI * g.sqrt() / (3.0 * integrals.b)
        } else {
            PI / (3.0 * g.powf(1.5) * integrals.d)
        };
        let c = CreepageCoefficients::new(&contact(a_over_b, 0.0)).unwrap();
        // Rounding, of a hundred terms and a system of condition 1/g.
        assert!((c.c23 / expected - 1.0).abs() < 1e-12, "{a_over_b}");
        assert!((c.c32 / expected + 1.0).abs() < 1e-12, "{a_over_b}");
    }
}

/// For `sigma = 0` the strengths of `P_n(y/b)` are orthogonal on the leading edge, and `C11 =
/// C22 = pi a int sin^3 W / (int sin^2 W)^2` over its quarter, `W = 1/Q`, `c = 1`. The second
/// integral is `B/b` or `D/a`, the first elementary.
#[test]
fn c11_without_poisson_contraction() {
    for a_over_b in [1e-3, 0.03, 0.4, 1.5, 50.0, 1e3] {
        let (a, b) = (f64::sqrt(a_over_b), f64::sqrt(1.0 / a_over_b));
        let integrals = CompleteIntegrals::new(f64::min(a_over_b, 1.0 / a_over_b));
        let k2 = a_over_b * a_over_b - 1.0;
        let k = k2.abs().sqrt();
        let arc = if k2 > 0.0 { k.asinh() } else { k.asin() };
        let third = (arc / k * (1.0 + 0.5 / k2) - a_over_b * 0.5 / k2) / b;
        let second = if k2 > 0.0 { integrals.d / a } else { integrals.b / b };
        let expected = PI * a * third / (second * second);
        let c = CreepageCoefficients::new(&contact(a_over_b, 0.0)).unwrap();
        // Rounding, of a hundred terms and a system of condition 1/g.
        assert!((c.c11 / expected - 1.0).abs() < 1e-12, "{a_over_b}: {} {expected}", c.c11);
        assert!((c.c22 / expected - 1.0).abs() < 1e-12, "{a_over_b}: {} {expected}", c.c22);
    }
}

/// The first row of Table 3. The distance from the limit falls with `g`, `C33` slowest.
#[test]
fn limits_of_slender_ellipses() {
    let quarter = PI * PI / 4.0;
    for poisson in [0.0, 0.25, 0.5] {
        let c = CreepageCoefficients::new(&contact(1e-3, poisson)).unwrap();
        assert!((c.c11 * (1.0 - poisson) / quarter - 1.0).abs() < 1e-4);
        assert!((c.c22 / quarter - 1.0).abs() < 1e-4);
        assert!((c.c33 * 1e-3 * (1.0 - poisson) / (quarter / 4.0) - 1.0).abs() < 1e-3);
    }
}

#[test]
fn continuous_across_the_circle() {
    for poisson in [0.0, 0.28, 0.5] {
        let [below, above] = [1.0 - 1e-9, 1.0 + 1e-9]
            .map(|r| CreepageCoefficients::new(&contact(r, poisson)).unwrap());
        for (below, above) in [
            (below.c11, above.c11),
            (below.c22, above.c22),
            (below.c23, above.c23),
            (below.c33, above.c33),
        ] {
            // The slope by a/b is of order one.
            assert!((below - above).abs() < 1e-8);
        }
    }
}

#[test]
fn nonsense_is_an_error() {
    for (a_over_b, poisson) in
        [(0.0, 0.3), (-1.0, 0.3), (f64::NAN, 0.3), (1e4, 0.3), (1.0, 0.51), (1.0, f64::NAN)]
    {
        assert!(
            try_contact(a_over_b, poisson).and_then(|c| CreepageCoefficients::new(&c)).is_err()
        );
        let of_degree = |c| CreepageCoefficients::of_degree(&c, 5);
        assert!(try_contact(a_over_b, poisson).and_then(of_degree).is_err());
    }
    for degree in [0, 1, 101, usize::MAX] {
        let error = CreepageCoefficients::of_degree(&contact(1.0, 0.3), degree).unwrap_err();
        assert_eq!(error.quantity, "degree");
    }
}

const CREEPAGE: [f64; 3] = [0.2, -0.3, 0.5];

/// Over the hemisphere above the ellipse the integrand is a polynomial of the degree of the
/// solution, times `x` or `y`: Gauss nodes in height and the midpoint rule around are exact.
#[test]
fn tractions_add_up_to_the_force() {
    for a_over_b in [0.3, 1.0, 4.0] {
        let linear = Linear::new(&contact(a_over_b, 0.28)).unwrap();
        let (a, b) = (f64::sqrt(a_over_b), f64::sqrt(1.0 / a_over_b));
        let heights = gauss_quad::GaussLegendre::new(80.try_into().unwrap());
        let around = 200;
        let mut total = [0.0; 3];
        for (node, weight) in &heights {
            let (z, weight) = (0.5 * (1.0 + node), 0.5 * weight * 2.0 * PI / f64::from(around));
            let positions: Vec<[f64; 2]> = (0..around)
                .map(|i| (f64::from(i) * 2.0 * PI / f64::from(around)).sin_cos())
                .map(|(sin, cos)| [a * cos, b * sin].map(|x| x * (1.0 - z * z).sqrt()))
                .collect();
            for point in linear.field(at(CREEPAGE), &positions) {
                let ([x, y], [p, q]) = (point.position, point.traction);
                for (total, part) in total.iter_mut().zip([p, q, x * q - y * p]) {
                    *total += weight * z * part * 3.0 / (2.0 * PI);
                }
            }
        }
        let force = linear.solve(at(CREEPAGE)).force;
        // C23 and C32 of the force are means over two values that differ by 1e-7.
        for (total, force) in total.iter().zip([force.fx, force.fy, force.mz]) {
            assert!((total - force).abs() < 1e-7, "{a_over_b}: {total} {force}");
        }
    }
}

/// The strength of the singularity, `traction (1 - r^2)^(1/2)`, all along both edges.
#[test]
fn traction_is_singular_on_the_trailing_edge_only() {
    let linear = Linear::new(&contact(0.5, 0.28)).unwrap();
    let (a, b) = (f64::sqrt(0.5), f64::sqrt(2.0));
    let strength = |psi: f64| {
        let r: f64 = 1.0 - 1e-9;
        let point = linear.field(at(CREEPAGE), &[[a * r * psi.cos(), b * r * psi.sin()]])[0];
        assert_eq!(point.region, Region::Adhesion);
        assert!(point.slip.iter().all(|&slip| slip == 0.0));
        (1.0 - r * r).sqrt() * point.traction[0].hypot(point.traction[1])
    };
    for i in -9..=9 {
        let psi = f64::from(i) * 0.16;
        // The rest at finite degree is of order 1e-3 near the ends of the leading edge.
        assert!(strength(psi) < 2e-3, "{psi}: {}", strength(psi));
        assert!(strength(psi + PI) > 0.02, "{psi}: {}", strength(psi + PI));
    }
}

#[test]
fn no_traction_outside() {
    let linear = Linear::new(&contact(2.0, 0.28)).unwrap();
    for position in [[1.5, 0.0], [0.0, 0.8], [f64::sqrt(2.0), 0.0], [f64::NAN, 0.0]] {
        let point = linear.field(at(CREEPAGE), &[position])[0];
        assert_eq!((point.traction, point.region), ([0.0; 2], Region::Outside));
    }
}

#[test]
fn force_is_linear_and_never_nan() {
    let linear = Linear::new(&contact(1e-3, 0.5)).unwrap();
    let (force, gains) = (linear.solve(at(CREEPAGE)).force, linear.jacobian(at(CREEPAGE)).unwrap());
    let [xi, eta, chi] = CREEPAGE;
    for (force, [by_xi, by_eta, by_chi]) in [force.fx, force.fy, force.mz].iter().zip(gains) {
        let product = by_xi * xi + by_eta * eta + by_chi * chi;
        assert!((force - product).abs() < 1e-12 * force.abs());
    }
    let huge = creepage(Creepage::MAX, Creepage::MAX, -Creepage::MAX);
    let force = linear.solve(huge).force;
    assert!(force.fx.is_finite() && force.fy.is_finite() && force.mz.is_finite());
    assert!(linear.field(huge, &[[0.0, 0.0]])[0].traction.iter().all(|t| t.is_finite()));
}
