//! The half-space against Boussinesq's and Cerruti's integrals (2.11c), (2.15a,b), done
//! directly: inside in polar coordinates about the field point, monomial by monomial, with
//! Gauss-Legendre along every ray; outside in polar coordinates about the centre.

use std::f64::consts::{FRAC_PI_2, PI};

use creepage::Ellipse;
use creepage::halfspace::{DisplacementField, Edge, LoadDisplacement, Polynomial, Traction};
use gauss_quad::GaussLegendre;

use super::support::{Random, largest};

/// The kernels on a traction `[X, Y, Z]` at a distance in true direction `(cos, sin)`, times
/// the distance.
fn kernels(poisson: f64, [cos, sin]: [f64; 2], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [
        x * (1.0 - poisson + poisson * cos * cos) + y * poisson * sin * cos,
        y * (1.0 - poisson + poisson * sin * sin) + x * poisson * sin * cos,
        z * (1.0 - poisson),
    ]
}

fn add(sum: &mut [f64; 3], weight: f64, values: [f64; 3]) {
    for (sum, value) in sum.iter_mut().zip(values) {
        *sum += weight * value;
    }
}

/// `[u, v, w]` inside: rays at true angles `psi`, `R + D = B sin t` along each (2.27).
fn inside(
    ellipse: Ellipse,
    edge: Edge,
    polynomials: &[Polynomial; 3],
    poisson: f64,
    [x, y]: [f64; 2],
) -> [f64; 3] {
    let (a2, b2) = (ellipse.a().powi(2), ellipse.b().powi(2));
    // The integrand's poles are about g away from the real axis.
    let rays = 2 * (40.0 / ellipse.g()) as u32 + 120;
    let along = GaussLegendre::new(20.try_into().unwrap());
    let mut sum = [0.0; 3];
    for ray in 0..rays {
        let (sin, cos) = (2.0 * PI * f64::from(ray) / f64::from(rays)).sin_cos();
        let quadratic = cos * cos / a2 + sin * sin / b2;
        let d = (x * cos / a2 + y * sin / b2) / quadratic;
        let b_squared = (1.0 - x * x / a2 - y * y / b2) / quadratic + d * d;
        let b = b_squared.sqrt();
        for component in 0..3 {
            let integral = along.integrate((d / b).asin(), FRAC_PI_2, |t| {
                let r = b * t.sin() - d;
                let weight = match edge {
                    Edge::Singular => 1.0,
                    Edge::Vanishing => quadratic * b_squared * t.cos().powi(2),
                };
                weight * polynomials[component].at([x + r * cos, y + r * sin])
            });
            let mut traction = [0.0; 3];
            traction[component] = integral / quadratic.sqrt();
            add(&mut sum, 2.0 / f64::from(rays), kernels(poisson, [cos, sin], traction));
        }
    }
    sum
}

/// `[u, v, w]` outside: `x' = a sin t cos f`, `y' = b sin t sin f`.
fn outside(
    traction: &Traction,
    polynomials: &[Polynomial; 3],
    poisson: f64,
    [x, y]: [f64; 2],
) -> [f64; 3] {
    let (ellipse, radial) = (traction.ellipse(), GaussLegendre::new(80.try_into().unwrap()));
    let rays = 400;
    let mut sum = [0.0; 3];
    for ray in 0..rays {
        let (sin, cos) = (2.0 * PI * f64::from(ray) / f64::from(rays)).sin_cos();
        for component in 0..3 {
            let integral = |result: usize| {
                radial.integrate(0.0, FRAC_PI_2, |t| {
                    let from = [ellipse.a() * t.sin() * cos, ellipse.b() * t.sin() * sin];
                    let (dx, dy) = (x - from[0], y - from[1]);
                    let distance = dx.hypot(dy);
                    let root = match traction.edge() {
                        Edge::Singular => 1.0,
                        Edge::Vanishing => t.cos().powi(2),
                    };
                    let mut value = [0.0; 3];
                    value[component] = root * polynomials[component].at(from) * t.sin() / distance;
                    kernels(poisson, [dx / distance, dy / distance], value)[result]
                })
            };
            let area = ellipse.a() * ellipse.b() * 2.0 / f64::from(rays);
            add(&mut sum, area, [integral(0), integral(1), integral(2)]);
        }
    }
    sum
}

#[test]
fn inside_by_direct_quadrature() {
    let mut random = Random(1);
    let mut worst = 0.0_f64;
    for degree in 0..=8 {
        for ratio in [0.05, 0.3, 1.0, 4.0, 20.0] {
            for poisson in [0.0, 0.28, 0.5] {
                for edge in [Edge::Singular, Edge::Vanishing] {
                    let ellipse = Ellipse::new(ratio, 1.0).unwrap();
                    let polynomials = random.polynomials(ellipse, degree);
                    let traction = Traction::new(ellipse, edge, polynomials.each_ref()).unwrap();
                    let equations = LoadDisplacement::new(ellipse, poisson, degree + 2).unwrap();
                    let displacement = equations.displacement(&traction).unwrap();
                    let field = DisplacementField::new(&traction, poisson, 0.0).unwrap();
                    let (r, f) = (0.95 * random.next(), PI * random.next());
                    let point = [ellipse.a() * r * f.cos(), ellipse.b() * r * f.sin()];
                    let expected = inside(ellipse, edge, &polynomials, poisson, point);
                    let scale = largest(expected);
                    let by_polynomial = displacement.each_ref().map(|p| p.at(point));
                    let by_field = field.at(point);
                    for i in 0..3 {
                        worst = worst.max((by_polynomial[i] - expected[i]).abs() / scale);
                        worst = worst.max((by_field[i] - expected[i]).abs() / scale);
                    }
                    assert!(worst < 1e-11, "{degree} {ratio} {poisson} {edge:?}: {worst:e}");
                }
            }
        }
    }
}

#[test]
fn outside_by_direct_quadrature() {
    let mut random = Random(2);
    let mut worst = 0.0_f64;
    for (degree, ratio, poisson, edge) in [
        (0, 1.0, 0.28, Edge::Singular),
        (1, 0.4, 0.5, Edge::Vanishing),
        (3, 3.0, 0.0, Edge::Singular),
        (5, 0.5, 0.28, Edge::Vanishing),
        (8, 2.0, 0.5, Edge::Singular),
    ] {
        let ellipse = Ellipse::from_ratio(ratio).unwrap();
        let polynomials = random.polynomials(ellipse, degree);
        let traction = Traction::new(ellipse, edge, polynomials.each_ref()).unwrap();
        let field = DisplacementField::new(&traction, poisson, 0.0).unwrap();
        for _ in 0..4 {
            let (r, f) = (2.4 + 0.9 * random.next(), PI * random.next());
            let point = [ellipse.a() * r * f.cos(), ellipse.b() * r * f.sin()];
            let expected = outside(&traction, &polynomials, poisson, point);
            let (scale, actual) = (largest(expected), field.at(point));
            for i in 0..3 {
                worst = worst.max((actual[i] - expected[i]).abs() / scale);
            }
            // Direct quadrature is good to some 1e-13 at these distances.
            assert!(worst < 1e-11, "{degree} {ratio} {edge:?} {point:?}: {worst:e}");
        }
    }
}

/// Beside a flat die on a circle `w/w0 = (2/pi) asin(a/r)`, and beside Hertz's pressure
/// `w/w0 = ((2 - r^2) asin(1/r) + sqrt(r^2 - 1))/pi`, also in the last digits of the edge.
#[test]
fn just_outside_the_edge() {
    let circle = Ellipse::new(1.0, 1.0).unwrap();
    let (none, one) = (Polynomial::zero(0), Polynomial::new(vec![1.0]).unwrap());
    for r in [1.0 + 1e-14_f64, 1.0 + 1e-9, 1.0001, 1.01, 1.3, 10.0, 1e6] {
        let (rim, arc) = (((r - 1.0) * (r + 1.0)).sqrt(), (1.0 / r).asin());
        // asin(1/r) loses digits next to the edge.
        let arc = if r < 1.1 { FRAC_PI_2 - rim.atan() } else { arc };
        for (edge, expected) in
            [(Edge::Singular, 2.0 / PI * arc), (Edge::Vanishing, ((2.0 - r * r) * arc + rim) / PI)]
        {
            let traction = Traction::new(circle, edge, [&none, &none, &one]).unwrap();
            let field = DisplacementField::new(&traction, 0.3, 0.0).unwrap();
            let centre = field.at([0.0, 0.0])[2];
            let ratio = field.at([0.6 * r, 0.8 * r])[2] / centre;
            // The reference itself cancels like r^4 for Hertz; close to the edge the rounding
            // of r counts as its square root.
            let tolerance = 1e-12 + if r < 1.0 + 1e-8 { 1e-8 } else { 0.0 };
            if edge == Edge::Singular || r < 20.0 {
                assert!(
                    (ratio / expected - 1.0).abs() < tolerance,
                    "{edge:?} {r}: {ratio} {expected}"
                );
            }
        }
    }
}

/// The field is continuous across the edge, for slender ellipses too.
#[test]
fn no_jump_at_the_edge() {
    let mut random = Random(3);
    for ratio in [1e-4, 0.05, 1.0, 30.0] {
        let ellipse = Ellipse::from_ratio(ratio).unwrap();
        let polynomials = random.polynomials(ellipse, 4);
        let traction = Traction::new(ellipse, Edge::Vanishing, polynomials.each_ref()).unwrap();
        let field = DisplacementField::new(&traction, 0.28, 0.0).unwrap();
        for f in [0.0_f64, 0.7, 1.57, 3.0, -2.0] {
            let at = |r: f64| field.at([ellipse.a() * r * f.cos(), ellipse.b() * r * f.sin()]);
            let (within, beyond) = (at(1.0 - 1e-12), at(1.0 + 1e-12));
            let scale = largest(within).max(largest(at(0.0)));
            for i in 0..3 {
                // The slope is finite: 2e-12 times that, and the accuracy of either side.
                assert!((within[i] - beyond[i]).abs() < 1e-10 * scale, "{ratio} {f}");
            }
        }
    }
}

/// Beside a flat elliptical die `w` is an incomplete elliptic integral of the confocal ellipse
/// through the point: in Carlson's form `R_F(l, a^2 + l, b^2 + l)`, at any slenderness.
#[test]
fn beside_an_elliptical_die() {
    let one = Polynomial::new(vec![1.0]).unwrap();
    let none = Polynomial::zero(0);
    let mut worst = [0.0_f64; 2];
    for ratio in [1e-6, 1e-3, 0.05, 0.5, 1.0, 8.0, 1e3, 1e6] {
        let ellipse = Ellipse::from_ratio(ratio).unwrap();
        let traction = Traction::new(ellipse, Edge::Singular, [&none, &none, &one]).unwrap();
        let field = DisplacementField::new(&traction, 0.28, 0.0).unwrap();
        let (a2, b2) = (ellipse.a().powi(2), ellipse.b().powi(2));
        let carlson = |l: f64| ellip::elliprf(l, a2 + l, b2 + l).unwrap();
        for r in [1.001, 1.1, 2.0, 30.0] {
            for f in [0.0_f64, 0.4, 1.2, FRAC_PI_2, 2.5, 4.0] {
                let (x2, y2) = (a2 * (r * f.cos()).powi(2), b2 * (r * f.sin()).powi(2));
                // l^2 + half l - rest = 0 is x^2/(a^2 + l) + y^2/(b^2 + l) = 1.
                let half = (a2 + b2 - x2 - y2) / 2.0;
                let rest = a2 * b2 * (r * r - 1.0);
                let root = half.hypot(rest.sqrt());
                let l = if half > 0.0 { rest / (half + root) } else { root - half };
                let expected = carlson(l) / carlson(0.0);
                let point = [ellipse.a() * r * f.cos(), ellipse.b() * r * f.sin()];
                let found = field.at(point)[2] / field.at([0.0, 0.0])[2];
                let extreme = usize::from((ratio.ln()).abs() > 7.0);
                worst[extreme] = worst[extreme].max((found / expected - 1.0).abs());
            }
        }
    }
    // As the documentation of the field promises.
    assert!(worst[0] < 1e-12 && worst[1] < 1e-10, "{worst:?}");
}
