//! The coefficients E and F and the integrals I and J, against tables, closed forms, and the
//! equations in harmonics.

use creepage::Ellipse;
use creepage::halfspace::closed_forms;
use creepage::halfspace::coefficients::{MAX_ORDER, e, f, integral_i, integral_j};
use creepage::halfspace::{Edge, LoadDisplacement, Polynomial, Traction};
use creepage::special::CompleteIntegrals;
use proptest::prelude::*;
use serde_json::Value;

use super::support::{Random, largest};

fn data(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn number(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap()
}

fn index(row: &Value, key: &str) -> usize {
    row[key].as_u64().unwrap() as usize
}

/// The ellipse with minor semi-axis `s`, along `x` or `y`.
fn ellipse(s: f64, g: f64, minor_along_x: bool) -> Ellipse {
    if minor_along_x { Ellipse::new(s, s / g).unwrap() } else { Ellipse::new(s / g, s).unwrap() }
}

/// 84 coefficients in 30-digit arithmetic, by the thesis's double sums.
#[test]
fn reference_table_of_e_and_f() {
    let table = data(include_str!("../data/halfspace.json"));
    let rows = table["EF"].as_array().unwrap();
    assert_eq!(rows.len(), 84);
    for row in rows {
        let shape = ellipse(number(row, "s"), number(row, "g"), number(row, "e_sign") > 0.0);
        let (from, to) = ([index(row, "p"), index(row, "q")], [index(row, "m"), index(row, "n")]);
        let h = index(row, "h");
        for (found, expected) in [
            (e(h, from, to, shape).unwrap(), number(row, "E")),
            (f(h, from, to, shape).unwrap(), number(row, "F")),
        ] {
            assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{row}: {found}");
        }
    }
}

#[test]
fn reference_table_of_elliptic_integrals() {
    let table = data(include_str!("../data/halfspace.json"));
    for (g, row) in table["elliptic"].as_object().unwrap() {
        let found = CompleteIntegrals::new(g.parse().unwrap());
        for (found, key) in
            [(found.k, "K"), (found.e, "E"), (found.b, "B"), (found.c, "C"), (found.d, "D")]
        {
            assert!((found / number(row, key) - 1.0).abs() < 1e-14, "{g} {key}");
        }
    }
}

/// The accuracy that the documentation of `f` promises.
#[test]
fn high_orders_against_50_digits() {
    let table = data(include_str!("../data/coefficients.json"));
    for row in table["rows"].as_array().unwrap() {
        let at = |i: usize| row[i].as_u64().unwrap() as usize;
        let shape = ellipse(1.0, row[0].as_f64().unwrap(), true);
        let found = f(at(1), [at(2), at(3)], [at(4), at(5)], shape).unwrap();
        let error = (found / row[6].as_f64().unwrap() - 1.0).abs();
        let tolerance = match at(2) + at(3) {
            0..=8 => 3e-13,
            9..=12 => 1e-10,
            _ => 1e-8,
        };
        assert!(error < tolerance, "{row}: {error:e}");
    }
}

/// All 15 of (3.21), and (3.14).
#[test]
fn closed_forms_of_j() {
    for g in [1e-3, 0.05, 0.3, 0.7, 1.0] {
        let orders = (-2..4).flat_map(|d| (0..4).flat_map(move |i| (0..4).map(move |j| (d, i, j))));
        let mut compared = 0;
        for (d, i, j) in orders {
            let Some(closed) = closed_forms::j(d, i, j, g) else { continue };
            let found = integral_j(d, i, j, g).unwrap();
            // The closed forms cancel for slender ellipses.
            let tolerance = 1e-14 * (CompleteIntegrals::new(g).k / found.abs()).max(1.0);
            assert!((found / closed - 1.0).abs() < tolerance, "{g} {d} {i} {j}");
            let other = integral_i(d, i, j, g).unwrap();
            assert!((other - 2.0 * f64::from(d + 1) * found).abs() <= 1e-15 * found.abs());
            compared += 1;
        }
        assert_eq!(compared, 15);
        assert!(integral_j(-2, 0, 0, g).unwrap().abs() < f64::MIN_POSITIVE);
    }
}

/// All 28 of (3.22), with `g^2` where the print has `e^2` by mistake; the other orientation of
/// the ellipse by exchange (3.8).
#[test]
fn closed_forms_of_f() {
    let powers = || (0..3).flat_map(|p| (0..3).map(move |q| [p, q]));
    for (g, minor_along_x) in [(0.05, true), (0.3, false), (0.8, true), (1.0, true)] {
        let shape = ellipse(1.7, g, minor_along_x);
        let mut compared = 0;
        for (h, pq) in (0..3).flat_map(|h| powers().map(move |pq| (h, pq))) {
            for mn in (0..6).flat_map(|m| (0..6).map(move |n| [m, n])) {
                let Some(closed) = closed_forms::f(h, pq, mn, shape) else { continue };
                let found = f(h, pq, mn, shape).unwrap();
                assert!((found / closed - 1.0).abs() < 1e-13, "{g}: {h} {pq:?} {mn:?} {found}");
                compared += 1;
            }
        }
        assert_eq!(compared, 28);
    }
}

/// (2.47) and (3.5) in coefficients make the same displacement as the harmonics.
#[test]
fn equations_in_monomials_and_in_harmonics() {
    let (mut random, degree, poisson) = (Random(7), 4, 0.28);
    for shape in [ellipse(1.0, 0.3, true), ellipse(0.5, 0.6, false)] {
        for edge in [Edge::Singular, Edge::Vanishing] {
            let coefficient = if edge == Edge::Singular { e } else { f };
            let [x, y, z] = random.polynomials(shape, degree);
            let traction = Traction::new(shape, edge, [&x, &y, &z]).unwrap();
            let equations = LoadDisplacement::new(shape, poisson, degree + 2).unwrap();
            let displacement = equations.displacement(&traction).unwrap();
            let top = displacement[0].degree();
            let factorial = |n: usize| (1..=n).map(|i| i as f64).product::<f64>();
            let terms = |h, polynomial: &Polynomial, to: [usize; 2]| -> f64 {
                let from = (0..=degree).flat_map(|p| (0..=degree - p).map(move |q| [p, q]));
                from.map(|[p, q]| {
                    polynomial.coefficient(p, q) * coefficient(h, [p, q], to, shape).unwrap()
                })
                .sum()
            };
            for m in 0..=top {
                for n in 0..=top - m {
                    let scale = 2.0 / (factorial(m) * factorial(n));
                    let xx = terms(0, &x, [m, n]) - poisson * terms(1, &x, [m + 2, n]);
                    let yy = terms(0, &y, [m, n]) - poisson * terms(1, &y, [m, n + 2]);
                    let [yx, xy] = [&y, &x].map(|t| -poisson * terms(1, t, [m + 1, n + 1]));
                    let zz = (1.0 - poisson) * terms(0, &z, [m, n]);
                    let unit = shape.a().powi(m as i32) * shape.b().powi(n as i32);
                    for (sum, polynomial) in [xx + yx, yy + xy, zz].iter().zip(&displacement) {
                        let size = largest(polynomial.coefficients().iter().copied());
                        let error = scale * sum - polynomial.coefficient(m, n);
                        // Monomials of degree six cost two digits.
                        assert!((error * unit).abs() < 1e-12 * size.max(1.0), "{edge:?} {m}{n}");
                    }
                }
            }
        }
    }
}

proptest! {
    /// (3.15), the parity zeros of (2.53), (3.6b), and the zeros by order (3.6a).
    #[test]
    fn e_is_a_multiple_of_f_and_both_vanish_by_parity_and_order(
        h in 0_usize..=1, p in 0_usize..7, q in 0_usize..7, m in 0_usize..9, n in 0_usize..9,
        log_ratio in -1.0_f64..1.0,
    ) {
        let shape = Ellipse::from_ratio(10.0_f64.powf(log_ratio)).unwrap();
        let (e, f) = (e(h, [p, q], [m, n], shape).unwrap(), f(h, [p, q], [m, n], shape).unwrap());
        let twice_d = (2 * h + p + q) as f64 - (m + n) as f64;
        prop_assert!((e - (twice_d + 2.0) * f).abs() <= 1e-15 * e.abs());
        let odd = (p + m) % 2 == 1 || (q + n) % 2 == 1;
        prop_assert!(f.is_finite());
        prop_assert_eq!(f == 0.0, odd || twice_d < -2.0);
        if twice_d < 0.0 {
            prop_assert!(e == 0.0);
        }
    }

    /// (3.4): F is the difference of three E; it is not how F is computed.
    #[test]
    fn f_is_a_difference_of_e(
        h in 0_usize..=1, p in 0_usize..4, q in 0_usize..4, m in 0_usize..5, n in 0_usize..5,
        g in 0.2_f64..1.0, along_x: bool,
    ) {
        let shape = ellipse(1.0, g, along_x);
        let e = |p, q| e(h, [p, q], [m, n], shape).unwrap();
        let terms = [
            e(p, q),
            -e(p + 2, q) / shape.a().powi(2),
            -e(p, q + 2) / shape.b().powi(2),
        ];
        let found = f(h, [p, q], [m, n], shape).unwrap();
        let difference: f64 = terms.iter().sum();
        prop_assert!((found - difference).abs() <= 1e-12 * largest(terms));
    }
}

#[test]
fn orders_out_of_range_are_errors() {
    let shape = Ellipse::new(1.0, 1.0).unwrap();
    assert_eq!(f(2, [0, 0], [0, 0], shape).unwrap_err().quantity, "h");
    assert_eq!(f(0, [MAX_ORDER, 1], [0, 0], shape).unwrap_err().quantity, "p + q");
    assert_eq!(e(0, [0, 0], [usize::MAX, 2], shape).unwrap_err().quantity, "m + n");
    assert_eq!(integral_j(0, 0, 0, 0.0).unwrap_err().quantity, "g");
    assert_eq!(integral_i(i32::MIN, 0, 0, 0.5).unwrap_err().quantity, "d");
    assert_eq!(integral_j(0, 11, 10, 0.5).unwrap_err().quantity, "i + j");
}
