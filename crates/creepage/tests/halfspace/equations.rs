//! The load-displacement equations as a whole: inverses, reciprocity, scaling, errors.

use std::f64::consts::{FRAC_PI_2, PI};

use creepage::halfspace::{Edge, LoadDisplacement, Polynomial, ResponseError, Traction, harmonics};
use creepage::{Ellipse, Hertz, Solid, SolidPair};
use gauss_quad::GaussLegendre;

use super::support::{Random, largest};

fn table(random: &mut Random, degree: usize) -> Vec<f64> {
    (0..harmonics::polynomial_count(degree)).map(|_| random.next()).collect()
}

#[test]
fn round_trip_at_degree_40() {
    let (mut random, degree, mut worst) = (Random(40), 40, 0.0_f64);
    for ratio in [1e-6, 0.05, 1.0, 20.0] {
        for poisson in [0.0, 0.28, 0.5] {
            let ellipse = Ellipse::from_ratio(ratio).unwrap();
            let equations = LoadDisplacement::new(ellipse, poisson, degree).unwrap();
            let inverse = equations.inverse().unwrap();
            let [x, y, z] = [0; 3].map(|_| table(&mut random, degree));
            let [u, v] = equations.tangential([&x, &y]);
            let back = inverse.tangential([&u, &v]);
            let pressure = inverse.normal(&equations.normal(&z));
            for (there, back) in [(&x, &back[0]), (&y, &back[1]), (&z, &pressure)] {
                let error = largest(there.iter().zip(back).map(|(a, b)| a - b));
                // Rounding only: the blocks are well conditioned.
                assert!(error < 1e-12, "a/b = {ratio}, sigma = {poisson}: {error:e}");
                worst = worst.max(error);
            }
        }
    }
}

#[test]
fn traction_from_displacement_in_polynomials() {
    let mut random = Random(5);
    for (degree, ratio) in [(0, 1.0), (1, 0.2), (4, 5.0), (6, 0.7)] {
        let ellipse = Ellipse::new(ratio, 1.0).unwrap();
        let equations = LoadDisplacement::new(ellipse, 0.28, degree + 2).unwrap();
        let inverse = equations.inverse().unwrap();
        for edge in [Edge::Singular, Edge::Vanishing] {
            let polynomials = random.polynomials(ellipse, degree);
            let traction = Traction::new(ellipse, edge, polynomials.each_ref()).unwrap();
            let displacement = equations.displacement(&traction).unwrap();
            let found = match edge {
                Edge::Singular => inverse.singular(displacement.each_ref()),
                Edge::Vanishing => inverse.vanishing(displacement.each_ref()),
            }
            .unwrap();
            assert_eq!(found.edge(), edge);
            assert_eq!(found.degree(), degree);
            for (found, given) in found.harmonics().iter().zip(traction.harmonics()) {
                // Monomials of degree 8 cost three digits.
                let error = largest(found.iter().zip(given).map(|(a, b)| a - b));
                assert!(error < 1e-12, "degree {degree} {edge:?}: {error:e}");
            }
        }
    }
}

#[test]
fn an_unreachable_displacement_is_an_error_that_says_how_far_off() {
    let ellipse = Ellipse::new(1.0, 2.0).unwrap();
    let equations = LoadDisplacement::new(ellipse, 0.28, 2).unwrap();
    let inverse = equations.inverse().unwrap();
    let (zero, one) = (Polynomial::zero(2), Polynomial::new(vec![1.0]).unwrap());
    let shift = inverse.vanishing([&one, &zero, &zero]).unwrap_err();
    assert!(matches!(shift, ResponseError::Unreachable { residual } if residual > 0.1));
    assert!(inverse.vanishing([&zero, &zero, &zero]).is_ok());
    // Hertz's paraboloid is reached, a slightly different one is missed by as little.
    let none = Polynomial::zero(0);
    let f00 = Traction::new(ellipse, Edge::Vanishing, [&none, &none, &one]).unwrap();
    let [_, _, w] = equations.displacement(&f00).unwrap();
    assert!(inverse.vanishing([&zero, &zero, &w]).is_ok());
    let mut coefficients = w.coefficients().to_vec();
    coefficients[0] *= 1.0 + 1e-6;
    let other = Polynomial::new(coefficients).unwrap();
    let missed = inverse.vanishing([&zero, &zero, &other]).unwrap_err();
    assert!(matches!(missed, ResponseError::Unreachable { residual } if residual < 2e-6));
}

#[test]
fn another_ellipse_or_too_high_a_degree_is_an_error() {
    let [one, two] = [1.0, 2.0].map(|b| Ellipse::new(1.0, b).unwrap());
    let equations = LoadDisplacement::new(one, 0.28, 1).unwrap();
    let zero = Polynomial::zero(0);
    let elsewhere = Traction::new(two, Edge::Singular, [&zero; 3]).unwrap();
    assert!(matches!(equations.displacement(&elsewhere), Err(ResponseError::OtherEllipse { .. })));
    let vanishing = Traction::new(one, Edge::Vanishing, [&zero; 3]).unwrap();
    assert_eq!(
        equations.displacement(&vanishing),
        Err(ResponseError::Degree { needed: 2, prepared: 1 })
    );
    let square = Polynomial::zero(2);
    assert!(equations.inverse().unwrap().singular([&square; 3]).is_err());
    assert_eq!(LoadDisplacement::new(one, 0.6, 1).unwrap_err().quantity, "poisson");
    assert_eq!(LoadDisplacement::new(one, 0.3, usize::MAX).unwrap_err().quantity, "degree");
}

/// The integral of `(1 - r^2)^(-1/2) f` over the ellipse.
fn over_ellipse(ellipse: Ellipse, f: impl Fn([f64; 2]) -> f64) -> f64 {
    let (rays, radial) = (24, GaussLegendre::new(12.try_into().unwrap()));
    let mut sum = 0.0;
    for ray in 0..rays {
        let (sin, cos) = (2.0 * PI * f64::from(ray) / f64::from(rays)).sin_cos();
        sum += radial.integrate(0.0, 1.0, |z| {
            let r = (1.0 - z * z).sqrt();
            f([ellipse.a() * r * cos, ellipse.b() * r * sin])
        });
    }
    // z dz = -r dr, so that the weight leaves dz.
    sum * ellipse.a() * ellipse.b() * 2.0 * PI / f64::from(rays)
}

/// Betti: the work of traction 1 on displacement 2 is that of 2 on 1, by quadrature.
#[test]
fn reciprocity_of_200_random_pairs() {
    let (mut random, mut worst) = (Random(200), 0.0_f64);
    for _ in 0..200 {
        let ellipse = Ellipse::from_ratio(10.0_f64.powf(1.3 * random.next())).unwrap();
        let poisson = 0.25 * (1.0 + random.next());
        let equations = LoadDisplacement::new(ellipse, poisson, 6).unwrap();
        let cases = [(Edge::Singular, 4), (Edge::Vanishing, 3)].map(|(edge, degree)| {
            let polynomials = random.polynomials(ellipse, degree);
            let traction = Traction::new(ellipse, edge, polynomials.each_ref()).unwrap();
            let displacement = equations.displacement(&traction).unwrap();
            (edge, polynomials, displacement)
        });
        let work = |i: usize, j: usize| {
            over_ellipse(ellipse, |[x, y]| {
                let (edge, traction, _) = &cases[i];
                let square = 1.0 - (x / ellipse.a()).powi(2) - (y / ellipse.b()).powi(2);
                let factor = if *edge == Edge::Vanishing { square } else { 1.0 };
                let pairs = traction.iter().zip(&cases[j].2);
                factor * pairs.map(|(t, u)| t.at([x, y]) * u.at([x, y])).sum::<f64>()
            })
        };
        let size = (work(0, 0) * work(1, 1)).sqrt();
        assert!(size > 0.0, "elastic energy is positive");
        worst = worst.max((work(0, 1) - work(1, 0)).abs() / size);
        // Rounding, of monomials of degree six too.
        assert!(worst < 1e-12, "{worst:e}");
    }
}

/// 2.43: with all lengths times lambda, `d_pq` times `lambda^-(p+q)` gives `a_mn` times
/// `lambda^(1-m-n)`.
#[test]
fn scaling_law() {
    let (mut random, degree, lambda) = (Random(43), 5, 3.7_f64);
    let ellipse = Ellipse::new(0.4, 1.1).unwrap();
    let scaled = Ellipse::new(lambda * 0.4, lambda * 1.1).unwrap();
    let powers = |polynomial: &Polynomial, first: i32| {
        let mut coefficients = polynomial.coefficients().to_vec();
        for p in 0..=polynomial.degree() {
            for q in 0..=polynomial.degree() - p {
                coefficients[Polynomial::index(p, q)] *= lambda.powi(first - (p + q) as i32);
            }
        }
        Polynomial::new(coefficients).unwrap()
    };
    for edge in [Edge::Singular, Edge::Vanishing] {
        let small = random.polynomials(ellipse, degree);
        let large = small.each_ref().map(|polynomial| powers(polynomial, 0));
        let displacement = |ellipse, polynomials: &[Polynomial; 3]| {
            let traction = Traction::new(ellipse, edge, polynomials.each_ref()).unwrap();
            let equations = LoadDisplacement::new(ellipse, 0.28, degree + 2).unwrap();
            equations.displacement(&traction).unwrap()
        };
        let there = displacement(scaled, &large);
        let here = displacement(ellipse, &small);
        for (there, here) in there.iter().zip(here.each_ref().map(|p| powers(p, 1))) {
            let size = largest(here.coefficients().iter().copied());
            for (there, here) in there.coefficients().iter().zip(here.coefficients()) {
                assert!((there - here).abs() < 1e-12 * size);
            }
        }
    }
}

#[test]
fn resultants_by_quadrature() {
    let mut random = Random(9);
    for (ratio, edge) in [(0.3, Edge::Singular), (2.0, Edge::Vanishing)] {
        let ellipse = Ellipse::from_ratio(ratio).unwrap();
        let polynomials = random.polynomials(ellipse, 5);
        let traction = Traction::new(ellipse, edge, polynomials.each_ref()).unwrap();
        let component = |i: usize, arm: &dyn Fn([f64; 2]) -> f64| {
            over_ellipse(ellipse, |point| {
                let root =
                    (1.0 - (point[0] / ellipse.a()).powi(2) - (point[1] / ellipse.b()).powi(2))
                        .sqrt();
                root * arm(point) * traction.at(point)[i]
            })
        };
        let found = traction.resultants();
        let moment = component(1, &|[x, _]| x) - component(0, &|[_, y]| y);
        for (found, expected) in [
            (found.fx, component(0, &|_| 1.0)),
            (found.fy, component(1, &|_| 1.0)),
            (found.n, component(2, &|_| 1.0)),
            (found.mz, moment),
        ] {
            assert!((found - expected).abs() < 1e-13, "{found} {expected}");
        }
    }
}

/// (3.44)-(3.52): Hertz's pressure makes the paraboloid that Hertz theory was asked for.
#[test]
fn hertz_is_a_case_of_the_equations() {
    let pair = SolidPair::new(Solid::new(82e9, 0.28).unwrap(), Solid::new(40e9, 0.4).unwrap());
    for ellipse in [[6e-3, 2e-3], [2e-3, 6e-3], [1e-3, 1e-3], [1e-2, 2e-5]] {
        let ellipse = Ellipse::new(ellipse[0], ellipse[1]).unwrap();
        let contact = Hertz::from_ellipse(pair, ellipse, 5e4).unwrap();
        let peak = contact.peak_pressure() / pair.shear_modulus();
        let (none, f00) = (Polynomial::zero(0), Polynomial::new(vec![peak]).unwrap());
        let traction = Traction::new(ellipse, Edge::Vanishing, [&none, &none, &f00]).unwrap();
        let force = traction.resultants().n * pair.shear_modulus();
        assert!((force / 5e4 - 1.0).abs() < 1e-14);
        let equations = LoadDisplacement::new(ellipse, pair.poisson(), 2).unwrap();
        let [_, _, w] = equations.displacement(&traction).unwrap();
        let [along, across] = contact.relative_curvatures();
        for ([p, q], expected) in
            [([0, 0], contact.approach()), ([2, 0], -along), ([0, 2], -across)]
        {
            assert!((w.coefficient(p, q) / expected - 1.0).abs() < 1e-12, "{ellipse:?} {p}{q}");
        }
        assert!(w.coefficient(1, 1).abs() < 1e-12 * along.max(across));
    }
}

/// The x derivative of a vanishing traction causes the x derivative of the displacement.
#[test]
fn derivative_of_traction_and_displacement() {
    let mut random = Random(11);
    let ellipse = Ellipse::new(0.6, 1.5).unwrap();
    let polynomials = random.polynomials(ellipse, 5);
    let traction = Traction::new(ellipse, Edge::Vanishing, polynomials.each_ref()).unwrap();
    let equations = LoadDisplacement::new(ellipse, 0.3, 7).unwrap();
    let displacement = equations.displacement(&traction).unwrap();
    let slopes = equations.displacement(&traction.x_derivative().unwrap()).unwrap();
    for (slope, displacement) in slopes.iter().zip(&displacement) {
        for p in 0..=6 {
            for q in 0..=6 - p {
                let expected = (p + 1) as f64 * displacement.coefficient(p + 1, q);
                let unit = ellipse.a().powi(p as i32 + 1) * ellipse.b().powi(q as i32);
                // Monomials of degree seven cost three digits.
                assert!(((slope.coefficient(p, q) - expected) * unit).abs() < 1e-11);
            }
        }
    }
    assert!(traction.x_derivative().unwrap().x_derivative().is_none());
}

/// A table that ends within a degree means zeros beyond.
#[test]
fn short_tables_are_padded() {
    let equations = LoadDisplacement::new(Ellipse::new(1.0, 3.0).unwrap(), 0.3, 3).unwrap();
    let mut random = Random(12);
    let short: Vec<f64> = (0..4).map(|_| random.next()).collect();
    let mut long = short.clone();
    long.resize(harmonics::polynomial_count(3), 0.0);
    assert_eq!(equations.tangential([&short, &[]]), equations.tangential([&long, &[0.0; 10]]));
    assert_eq!(equations.normal(&short), equations.normal(&long));
}

#[test]
fn circle_without_poisson_effect_in_closed_form() {
    // (1 - r^2)^(-1/2) Y_nm causes its multiple: the Abel-Fourier eigenvalues of the circle.
    let equations = LoadDisplacement::new(Ellipse::new(1.0, 1.0).unwrap(), 0.0, 4).unwrap();
    for n in 0..=4_usize {
        for m in harmonics::even_orders(n) {
            let mut z = vec![0.0; harmonics::polynomial_count(4)];
            z[harmonics::position(n, m)] = 1.0;
            let w = equations.normal(&z);
            // pi [((n+m-1)!! (n-m-1)!!) / ((n+m)!! (n-m)!!)] for the order m.
            let ratio = |k: usize| (1..=k / 2).map(|i| 1.0 - 0.5 / i as f64).product::<f64>();
            let order = m.unsigned_abs();
            let expected = 2.0 * FRAC_PI_2 * ratio(n + order) * ratio(n - order);
            let found = w[harmonics::position(n, m)];
            assert!((found - expected).abs() < 1e-14, "{n} {m}: {found} {expected}");
        }
    }
}
