//! Unlike bodies: what pressure adds to `u` and `v` (2.11a,b), (6.4), and tangential traction
//! to `w` (2.15c). All by the operator `T f = 1/pi int f (x' - x)/R^2`, the gradient of a
//! logarithmic potential.

use std::f64::consts::{FRAC_PI_2, PI};

use creepage::Ellipse;
use creepage::halfspace::{DisplacementField, Edge, Polynomial, Traction};
use gauss_quad::GaussLegendre;

use super::support::{Random, largest};

const KAPPA: f64 = 0.3;

/// What dissimilar bodies add to the displacement at a point, over kappa.
fn addition(traction: &Traction, point: [f64; 2]) -> [f64; 3] {
    let like = DisplacementField::new(traction, 0.28, 0.0).unwrap().at(point);
    let unlike = DisplacementField::new(traction, 0.28, KAPPA).unwrap().at(point);
    [0, 1, 2].map(|i| (unlike[i] - like[i]) / KAPPA)
}

fn pressure(ellipse: Ellipse, edge: Edge, polynomial: &Polynomial) -> Traction {
    let none = Polynomial::zero(0);
    Traction::new(ellipse, edge, [&none, &none, polynomial]).unwrap()
}

/// On a circle the flux of the field is the load within: `T_r = -M(r)/(pi r)`.
#[test]
fn circle_by_gauss_law() {
    let circle = Ellipse::new(1.0, 1.0).unwrap();
    let one = Polynomial::new(vec![1.0]).unwrap();
    for r in [0.01_f64, 0.5, 0.9, 0.999, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.5, 30.0] {
        let rest = ((1.0 - r) * (1.0 + r)).max(0.0).sqrt();
        // -expm1 and the like are not needed: M(0.01) loses four digits at most.
        for (edge, load) in [
            (Edge::Singular, 2.0 * PI * (1.0 - rest)),
            (Edge::Vanishing, 2.0 * PI / 3.0 * (1.0 - rest.powi(3))),
        ] {
            let [u, v, w] = addition(&pressure(circle, edge, &one), [0.6 * r, -0.8 * r]);
            let expected = -load / (PI * r);
            // Next to the edge the singular load has a slope like 1/rest.
            let tolerance = if (r - 1.0).abs() < 1e-8 { 1e-9 } else { 1e-11 };
            assert!((u - 0.6 * expected).abs() < tolerance, "{edge:?} {r}: {u}");
            assert!((v + 0.8 * expected).abs() < tolerance, "{edge:?} {r}: {v}");
            assert!(w.abs() < 1e-15);
        }
    }
}

/// Rays about the field point, `R + D = B sin t` along each, at true angles.
fn rays(ellipse: Ellipse, edge: Edge, polynomial: &Polynomial, [x, y]: [f64; 2]) -> [f64; 2] {
    let (a2, b2) = (ellipse.a().powi(2), ellipse.b().powi(2));
    let (rays, along) = (2400, GaussLegendre::new(20.try_into().unwrap()));
    let mut sum = [0.0; 2];
    for ray in 0..rays {
        let (sin, cos) = (2.0 * PI * f64::from(ray) / f64::from(rays)).sin_cos();
        let quadratic = cos * cos / a2 + sin * sin / b2;
        let d = (x * cos / a2 + y * sin / b2) / quadratic;
        let b_squared = (1.0 - x * x / a2 - y * y / b2) / quadratic + d * d;
        let integral = along.integrate((d / b_squared.sqrt()).asin(), FRAC_PI_2, |t| {
            let r = b_squared.sqrt() * t.sin() - d;
            let weight = match edge {
                Edge::Singular => 1.0,
                Edge::Vanishing => quadratic * b_squared * t.cos().powi(2),
            };
            weight * polynomial.at([x + r * cos, y + r * sin])
        });
        let weight = 2.0 / f64::from(rays) / quadratic.sqrt();
        sum = [sum[0] + weight * cos * integral, sum[1] + weight * sin * integral];
    }
    sum
}

#[test]
fn inside_by_direct_quadrature() {
    let (mut random, mut worst) = (Random(21), 0.0_f64);
    for (degree, ratio, edge) in [
        (0, 0.3, Edge::Vanishing),
        (1, 2.0, Edge::Singular),
        (3, 1.0, Edge::Vanishing),
        (6, 0.5, Edge::Singular),
        (8, 3.0, Edge::Vanishing),
    ] {
        let ellipse = Ellipse::from_ratio(ratio).unwrap();
        let polynomial = random.polynomial(ellipse, degree);
        let normal = pressure(ellipse, edge, &polynomial);
        let none = Polynomial::zero(0);
        let along = Traction::new(ellipse, edge, [&polynomial, &none, &none]).unwrap();
        let across = Traction::new(ellipse, edge, [&none, &polynomial, &none]).unwrap();
        for _ in 0..3 {
            let (r, f) = (0.8 * random.next(), PI * random.next());
            let point = [ellipse.a() * r * f.cos(), ellipse.b() * r * f.sin()];
            let [tx, ty] = rays(ellipse, edge, &polynomial, point);
            let [u, v, _] = addition(&normal, point);
            let size = largest([tx, ty]).max(0.01);
            for (found, expected) in [
                (u, tx),
                (v, ty),
                (addition(&along, point)[2], -tx),
                (addition(&across, point)[2], -ty),
            ] {
                worst = worst.max((found - expected).abs() / size);
            }
            // Also the difference of two fields in `addition` rounds.
            assert!(worst < 1e-11, "{degree} {ratio} {point:?}: {worst:e}");
        }
    }
}

/// The divergence of the field is -2 Z under the load and zero beside it; the x derivative is
/// the field of the load's x derivative (6.4). By central differences.
#[test]
fn hertz_pressure_on_an_ellipse() {
    for ratio in [0.02, 0.5, 1.0, 7.0] {
        let ellipse = Ellipse::from_ratio(ratio).unwrap();
        let hertz = pressure(ellipse, Edge::Vanishing, &Polynomial::new(vec![1.0]).unwrap());
        let slope = hertz.x_derivative().unwrap();
        for [r, f] in [[0.2, 0.3], [0.7, 2.0], [0.95, -1.0], [1.3, 0.9], [4.0, -2.0]] {
            let h = 1e-4 * ellipse.minor();
            let at = |dx: f64, dy: f64| {
                let (sin, cos) = f64::sin_cos(f);
                let point = [ellipse.a() * r * cos + dx, ellipse.b() * r * sin + dy];
                addition(&hertz, point)
            };
            let dx = [0, 1].map(|i| (at(h, 0.0)[i] - at(-h, 0.0)[i]) / (2.0 * h));
            let dy = (at(0.0, h)[1] - at(0.0, -h)[1]) / (2.0 * h);
            let load = (1.0 - r * r).max(0.0).sqrt();
            // h^2 times third derivatives, which grow towards the edge.
            assert!((dx[0] + dy + 2.0 * load).abs() < 1e-5, "{ratio} {r}");
            let (sin, cos) = f64::sin_cos(f);
            let [ux, vx, _] = addition(&slope, [ellipse.a() * r * cos, ellipse.b() * r * sin]);
            assert!((ux - dx[0]).abs() < 1e-5, "{ratio} {r}: {ux} {}", dx[0]);
            assert!((vx - dx[1]).abs() < 1e-5, "{ratio} {r}: {vx} {}", dx[1]);
        }
    }
}

/// Work that pressure does on `w` of the traction is minus that of the traction on `u`, `v`
/// of the pressure: Betti, with the sign of (2.15c), at points of a grid.
#[test]
fn coupling_is_antisymmetric_in_sign_only() {
    let ellipse = Ellipse::new(1.0, 2.0).unwrap();
    let polynomial = Random(4).polynomial(ellipse, 3);
    let none = Polynomial::zero(0);
    let normal = pressure(ellipse, Edge::Singular, &polynomial);
    let along = Traction::new(ellipse, Edge::Singular, [&polynomial, &none, &none]).unwrap();
    for point in [[0.1, 0.2], [-0.5, 1.0], [2.0, 2.0]] {
        let (u, w) = (addition(&normal, point)[0], addition(&along, point)[2]);
        assert!((u + w).abs() < 1e-13);
    }
    assert!(DisplacementField::new(&normal, 0.3, 0.7).is_err());
}

/// Hertz's pressure on ellipses of any slenderness: the load is a pile of similar ellipses, each
/// of which pulls as its confocal one through the point (Newton, Ivory), so that
/// `T_x = -a b x int Z(m(s)) / ((a^2+s)^(3/2) (b^2+s)^(1/2)) ds`,
/// `m^2 = x^2/(a^2+s) + y^2/(b^2+s)`, from the confocal ellipse through the point outward.
#[test]
fn hertz_pressure_by_confocal_ellipses() {
    let mut worst = [0.0_f64; 2];
    for ratio in [1e-6, 1e-3, 0.05, 0.5, 1.0, 8.0, 1e3, 1e6] {
        let ellipse = Ellipse::from_ratio(ratio).unwrap();
        let hertz = pressure(ellipse, Edge::Vanishing, &Polynomial::new(vec![1.0]).unwrap());
        let (a2, b2) = (ellipse.a().powi(2), ellipse.b().powi(2));
        for r in [0.1, 0.9, 0.999, 1.0, 1.001, 1.5, 8.0] {
            for f in [0.0_f64, 0.4, 1.2, FRAC_PI_2, 2.5, 4.0] {
                let [x, y] = [ellipse.a() * r * f.cos(), ellipse.b() * r * f.sin()];
                let half = (a2 + b2 - x * x - y * y) / 2.0;
                let rest = (a2 * b2 * (r - 1.0) * (r + 1.0)).max(0.0);
                let root = half.hypot(rest.sqrt());
                let first = if half > 0.0 { rest / (half + root) } else { root - half };
                // s = first + exp(t): the midpoint rule in t converges geometrically.
                let mut expected = [0.0; 2];
                for i in -1000..1000 {
                    let step = (0.08 * f64::from(i)).exp();
                    let [alpha, beta] = [a2 + first + step, b2 + first + step];
                    // 1 - m^2, outside as a difference from the confocal ellipse.
                    let inner = if r > 1.0 {
                        step * (x * x / (alpha * (a2 + first)) + y * y / (beta * (b2 + first)))
                    } else {
                        1.0 - x * x / alpha - y * y / beta
                    };
                    let ring = inner.max(0.0).sqrt() * step * 0.08 / (alpha * beta).sqrt();
                    expected[0] -= (a2 * b2).sqrt() * x / alpha * ring;
                    expected[1] -= (a2 * b2).sqrt() * y / beta * ring;
                }
                let [u, v, _] = addition(&hertz, [x, y]);
                let extreme = usize::from(ratio.ln().abs() > 7.0);
                for (found, expected) in [(u, expected[0]), (v, expected[1])] {
                    // The larger pull is the scale: across the minor axis it is about s.
                    let error = (found - expected).abs() / ellipse.minor();
                    worst[extreme] = worst[extreme].max(error);
                }
            }
        }
    }
    // As the documentation of the field promises, with a margin.
    assert!(worst[0] < 1e-12 && worst[1] < 1e-10, "{worst:?}");
}
