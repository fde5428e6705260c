//! Proposition II of the thesis: on a circle the potentials separate in oblate spheroidal
//! coordinates, `x + i y = sqrt((1 - w^2)(1 + n^2)) e^{i psi}`, `z = w n`, into
//! `P_n^m(w) Q_n^m(i n) e^{i m psi}`. An independent road to the first invariant of the stress,
//! `(1 + sigma)/pi` times the divergence of the potentials of the three tractions.

use creepage::halfspace::{Edge, Traction, harmonics};
use creepage::subsurface::{Body, Interior};
use creepage::{Ellipse, Solid};

/// `w` and `n` of a point.
fn spheroidal([x, y, z]: [f64; 3]) -> [f64; 2] {
    let square = x * x + y * y + z * z - 1.0;
    let n = (0.5 * (square + (square * square + 4.0 * z * z).sqrt())).sqrt();
    [z / n, n]
}

/// `Q_n^m(i n)` over its value at `n = 0`, by the integral of Laplace's kind
/// `Q_n^m ~ (1 + n^2)^(m/2) int_0^inf (n + sqrt(1 + n^2) cosh t)^(-k-1) cosh m t dt`, `k` the degree.
fn second_kind(degree: usize, order: usize, n: f64) -> f64 {
    // A smooth integrand that falls as e^-t at least: the trapezoidal rule.
    const STEP: f64 = 1.0 / 32.0;
    let at = |n: f64| -> f64 {
        (-1600..=1600)
            .map(|i| {
                let t = STEP * f64::from(i);
                let base = (t.cosh() * (1.0 + n * n).sqrt() + n).ln();
                let grow = (order as f64 * t).cosh().ln();
                (grow - (degree as f64 + 1.0) * base).exp()
            })
            .sum()
    };
    at(n) / at(0.0)
}

/// The potential of `(1 - r^2)^(-1/2) Y_nm`, continued from the circle: there it is a polynomial,
/// `Y_nm` times a number that the load-displacement equations give; `r^m`'s place in `Y_nm` is taken
/// by the functions of `w`.
fn potential(degree: usize, order: isize, point: [f64; 3]) -> f64 {
    let [w, n] = spheroidal(point);
    let azimuth = point[1].atan2(point[0]);
    // On the unit disc with sqrt(1 - r^2) = w the harmonic is P_n^m(w) e^{i m psi}.
    let disc = (1.0 - w * w).sqrt();
    let mut values = vec![0.0; harmonics::count(degree)];
    harmonics::evaluate(degree, disc * azimuth.cos(), disc * azimuth.sin(), &mut values);
    // Surface value of the potential of a harmonic: (2 pi/(2n + 1)) times the sum over orders at the
    // edge, which on a circle is diagonal: pi^2 ((n+m-1)!! (n-m-1)!!)/((n+m)!! (n-m)!!).
    let m = order.unsigned_abs();
    let surface = std::f64::consts::PI.powi(2) * (central(degree + m)) * (central(degree - m));
    surface * values[harmonics::index(degree, order)] * second_kind(degree, m, n)
}

/// `(k - 1)!!/k!!` for even `k`.
fn central(k: usize) -> f64 {
    (1..=k / 2).map(|i| (2 * i - 1) as f64 / (2 * i) as f64).product()
}

#[test]
fn the_first_invariant_is_that_of_the_spheroidal_potentials() {
    let circle = Ellipse::new(1.0, 1.0).unwrap();
    let (poisson, step) = (0.28, 1e-3);
    let solid = Solid::new(1.0, poisson).unwrap();
    for (degree, order) in
        [(0, 0), (1, 1), (1, -1), (2, 0), (2, 2), (2, -2), (3, 1), (3, -3), (5, 1), (6, -4)]
    {
        for axis in 0..3 {
            let mut tables = [0, 1, 2].map(|_| vec![0.0; harmonics::polynomial_count(degree)]);
            tables[axis][harmonics::position(degree, order)] = 1.0;
            let traction = Traction::from_harmonics(circle, Edge::Singular, tables).unwrap();
            let interior = Interior::new(solid, Body::Lower).with_traction(&traction, 1.0).unwrap();
            for point in [[0.3, 0.2, 0.4], [-0.7, 0.5, 0.6], [0.9, -1.1, 0.3], [0.2, 0.1, 2.5]] {
                let at = |steps: f64| {
                    let mut moved = point;
                    moved[axis] += steps * step;
                    potential(degree, order, moved)
                };
                let slope = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step);
                let expected = (1.0 + poisson) / std::f64::consts::PI * slope;
                let found = interior.stress(point).unwrap().trace();
                // The difference's error, step^4 over the depth to the fifth.
                assert!(
                    (found - expected).abs() < 1e-8,
                    "{degree} {order} {axis} {point:?}: {found} {expected}"
                );
            }
        }
    }
}
