//! Hertz contact against reference values, published tables and its own limits.

#![allow(clippy::panic, clippy::unwrap_used)]

use std::f64::consts::PI;

use creepage::{Ellipse, Hertz, HertzError, Radii, Solid, SolidPair};
use proptest::prelude::*;
use serde_json::Value;

fn pair(shear_modulus: f64, poisson: f64) -> SolidPair {
    let solid = Solid::new(shear_modulus, poisson).unwrap();
    SolidPair::new(solid, solid)
}

fn flat_lower() -> Radii {
    Radii { rolling: f64::INFINITY, lateral: f64::INFINITY }
}

fn close(actual: f64, expected: f64, tolerance: f64) {
    assert!((actual / expected - 1.0).abs() < tolerance, "{actual} is not {expected}");
}

/// Values in 30-digit arithmetic: from semi-axes and from the curvatures alike.
#[test]
fn reference_contacts() {
    let data: Value = serde_json::from_str(include_str!("data/hertz.json")).unwrap();
    for case in data["hertz"].as_array().unwrap() {
        let number = |key: &str| case[key].as_f64().unwrap();
        let solids = pair(number("G"), number("sigma"));
        let (along, across) = (number("A"), number("B"));
        let upper = Radii { rolling: 0.5 / along, lateral: 0.5 / across };
        let ellipse = Ellipse::new(number("a"), number("b")).unwrap();
        let contacts = [
            Hertz::new(solids, upper, flat_lower(), 0.0, number("N")).unwrap(),
            Hertz::from_ellipse(solids, ellipse, number("N")).unwrap(),
        ];
        for contact in contacts {
            close(contact.ellipse().a(), number("a"), 1e-12);
            close(contact.ellipse().b(), number("b"), 1e-12);
            close(contact.rho(), number("rho"), 1e-12);
            close(contact.approach(), number("alpha"), 1e-12);
            close(contact.peak_pressure(), number("Zmax"), 1e-12);
            close(contact.relative_curvatures()[0], along, 1e-12);
            close(contact.relative_curvatures()[1], across, 1e-12);
        }
    }
}

/// Roark's Formulas for Stress and Strain, general case of two bodies in contact: `cos theta`
/// and the coefficients alpha, beta, lambda of the semi-axes and the approach. Print: three
/// decimals.
const ROARK: [[f64; 4]; 12] = [
    [0.00, 1.000, 1.000, 0.750],
    [0.10, 1.070, 0.936, 0.748],
    [0.20, 1.150, 0.878, 0.743],
    [0.30, 1.242, 0.822, 0.734],
    [0.40, 1.351, 0.769, 0.721],
    [0.50, 1.486, 0.717, 0.703],
    [0.60, 1.661, 0.664, 0.678],
    [0.70, 1.905, 0.608, 0.644],
    [0.80, 2.292, 0.544, 0.594],
    [0.90, 3.093, 0.461, 0.510],
    [0.94, 3.824, 0.412, 0.452],
    [0.98, 5.937, 0.328, 0.345],
];

#[test]
fn published_coefficients() {
    let (load, young, poisson) = (1000.0, 207e9, 0.29);
    let steel = Solid::from_young_modulus(young, poisson).unwrap();
    let solids = SolidPair::new(steel, steel);
    // Four curvatures that sum to 100 1/m; those of the lower body are zero.
    let (sum, compliance) = (100.0, 2.0 * (1.0 - poisson * poisson) / young);
    let k_d = 1.5 / sum;
    for [cosine, alpha, beta, lambda] in ROARK {
        let upper = Radii {
            rolling: 1.0 / (0.5 * sum * (1.0 - cosine)),
            lateral: 1.0 / (0.5 * sum * (1.0 + cosine)),
        };
        let contact = Hertz::new(solids, upper, flat_lower(), 0.0, load).unwrap();
        let unit = (load * k_d * compliance).cbrt();
        // Half a unit of the last printed digit, rounded with the slide rules of its time.
        assert!((contact.ellipse().a() / unit - alpha).abs() < 0.0006, "alpha at {cosine}");
        assert!((contact.ellipse().b() / unit - beta).abs() < 0.0006, "beta at {cosine}");
        let approach = (load * load * compliance * compliance / k_d).cbrt();
        assert!((contact.approach() / approach - lambda).abs() < 0.0006, "lambda at {cosine}");
    }
}

/// Complete integrals by the arithmetic-geometric mean: K and K - E.
fn by_agm(g: f64) -> [f64; 2] {
    let (mut a, mut b, mut c) = (1.0, g, ((1.0 - g) * (1.0 + g)).sqrt());
    let (mut sum, mut power) = (0.5 * c * c, 0.5);
    for _ in 0..12 {
        (a, b, c) = (f64::midpoint(a, b), (a * b).sqrt(), 0.5 * (a - b));
        power *= 2.0;
        sum += power * c * c;
    }
    let k = PI / (2.0 * a);
    [k, k * sum]
}

#[test]
fn axis_ratio_to_the_last_digits_up_to_a_curvature_ratio_of_a_million() {
    let mut largest = 0.0;
    for exponent in 0..35 {
        let g = 0.9 * 10f64.powf(-0.1 * f64::from(exponent));
        let [k, k_minus_e] = by_agm(g);
        // (3.48): the curvatures are as (E/g^2 - K) to (K - E).
        let ratio = ((k - k_minus_e) / (g * g) - k) / k_minus_e;
        let upper = Radii { rolling: 1.0, lateral: ratio };
        let contact = Hertz::new(pair(1.0, 0.3), upper, flat_lower(), 0.0, 1e-9).unwrap();
        close(contact.ellipse().ratio(), g, 1e-12);
        largest = ratio;
    }
    assert!(largest > 9e5);
}

#[test]
fn sphere_on_plane_in_closed_form() {
    let (radius, load, sigma, shear) = (0.02, 50.0, 0.3, 80e9);
    let upper = Radii { rolling: radius, lateral: radius };
    let contact = Hertz::new(pair(shear, sigma), upper, flat_lower(), 0.0, load).unwrap();
    // Two like bodies: a^3 = 3/4 N R (1 - sigma)/G, approach a^2/R.
    let a = (0.75 * load * radius * (1.0 - sigma) / shear).cbrt();
    close(contact.ellipse().a(), a, 1e-14);
    close(contact.ellipse().b(), a, 1e-14);
    close(contact.approach(), a * a / radius, 1e-14);
}

proptest! {
    /// The corrected (3.38): 4 (A-B)^2 = d1^2 + d2^2 + 2 d1 d2 cos 2 omega, A + B unchanged.
    #[test]
    fn curvatures_at_an_angle(
        radii in prop::array::uniform4(0.1..10.0_f64), omega in -7.0..7.0_f64,
    ) {
        let upper = Radii { rolling: radii[0], lateral: radii[1] };
        let lower = Radii { rolling: radii[2], lateral: radii[3] };
        let contact = Hertz::new(pair(1.0, 0.3), upper, lower, omega, 1e-6).unwrap();
        let [a, b] = contact.relative_curvatures();
        let (d1, d2) = (1.0 / radii[0] - 1.0 / radii[1], 1.0 / radii[2] - 1.0 / radii[3]);
        let expected = (d1 * d1 + d2 * d2 + 2.0 * d1 * d2 * (2.0 * omega).cos()).max(0.0);
        let sum: f64 = radii.iter().map(|r| 0.5 / r).sum();
        // Rounding in a difference of curvatures up to 20.
        prop_assert!((4.0 * (a - b).powi(2) - expected).abs() < 1e-9 * sum * sum);
        prop_assert!((a + b - sum).abs() < 1e-12 * sum);
        prop_assert!(contact.angle().abs() <= PI / 4.0 + 1e-12);
    }

    /// Exchange of the directions exchanges the axes; N to the third root is the size.
    #[test]
    fn exchange_and_load(along in 0.01..10.0_f64, across in 0.01..10.0_f64, load in 1.0..1e6_f64) {
        let contact = |rolling, lateral, load| {
            let upper = Radii { rolling, lateral };
            Hertz::new(pair(82e9, 0.28), upper, flat_lower(), 0.0, load).unwrap()
        };
        let (one, two) = (contact(along, across, load), contact(across, along, load));
        let heavy = contact(along, across, 8.0 * load);
        prop_assert!((one.ellipse().a() / two.ellipse().b() - 1.0).abs() < 1e-13);
        prop_assert!((heavy.ellipse().a() / one.ellipse().a() - 2.0).abs() < 1e-12);
        prop_assert!((heavy.approach() / one.approach() - 4.0).abs() < 1e-12);
    }
}

#[test]
fn a_right_angle_exchanges_the_lower_body_s_radii() {
    let upper = Radii { rolling: 0.5, lateral: f64::INFINITY };
    let lower = Radii { rolling: 0.3, lateral: f64::INFINITY };
    let turned = Hertz::new(pair(1.0, 0.3), upper, lower, PI / 2.0, 1e-6).unwrap();
    let swapped = Radii { rolling: lower.lateral, lateral: lower.rolling };
    let straight = Hertz::new(pair(1.0, 0.3), upper, swapped, 0.0, 1e-6).unwrap();
    close(turned.ellipse().a(), straight.ellipse().a(), 1e-14);
    close(turned.ellipse().b(), straight.ellipse().b(), 1e-14);
}

#[test]
fn bodies_that_cannot_make_an_ellipse_are_errors() {
    let contact = |upper: [f64; 2], lower: [f64; 2], load| {
        let [upper, lower] = [upper, lower].map(|[rolling, lateral]| Radii { rolling, lateral });
        Hertz::new(pair(82e9, 0.28), upper, lower, 0.0, load)
    };
    let flat = f64::INFINITY;
    let hollow = contact([-0.5, -0.5], [-0.5, -0.5], 1.0).unwrap_err();
    assert!(
        matches!(hollow, HertzError::Hollow { relative_curvature, .. } if relative_curvature < 0.0)
    );
    let line = contact([0.5, flat], [flat, flat], 1.0).unwrap_err();
    assert!(matches!(line, HertzError::Line { .. }));
    assert!(line.to_string().starts_with("line contact"));
    let planes = contact([flat, flat], [flat, flat], 1.0).unwrap_err();
    assert!(matches!(planes, HertzError::Line { .. }));
    for (upper, load, field) in [
        ([0.0, 1.0], 1.0, "radius_rolling"),
        ([1.0, f64::NAN], 1.0, "radius_lateral"),
        ([1.0, 1.0], 0.0, "normal_force"),
        ([1.0, 1.0], f64::INFINITY, "normal_force"),
    ] {
        match contact(upper, [flat, flat], load).unwrap_err() {
            HertzError::Invalid(invalid) => assert_eq!(invalid.quantity, field),
            other => panic!("{other:?} does not name {field}"),
        }
    }
}

/// The moment of the front half of the pressure, summed over the ellipse.
#[test]
fn hysteresis_is_that_of_the_front_half() {
    let solid = Solid::new(80e9, 0.3).unwrap();
    let ellipse = Ellipse::new(2e-3, 5e-3).unwrap();
    let hertz = Hertz::from_ellipse(SolidPair::new(solid, solid), ellipse, 1e4).unwrap();
    // Work by rolling through an angle: the integral of x Z over x > 0, by midpoints.
    let (n, [a, b]) = (800, [ellipse.a(), ellipse.b()]);
    let (dx, dy) = (a / f64::from(n), 2.0 * b / f64::from(n));
    let mut moment = 0.0;
    for i in 0..n {
        for j in 0..n {
            let (x, y) = (dx * (f64::from(i) + 0.5), dy * (f64::from(j) + 0.5) - b);
            let z = (1.0 - (x / a).powi(2) - (y / b).powi(2)).max(0.0).sqrt();
            moment += x * hertz.peak_pressure() * z * dx * dy;
        }
    }
    let found = hertz.hysteresis_moment(0.02).unwrap();
    // Midpoints of 800 cells beside a root at the edge.
    assert!((found / (0.02 * moment) - 1.0).abs() < 1e-4, "{found}");
    assert!(hertz.hysteresis_moment(1.5).is_err() && hertz.hysteresis_moment(f64::NAN).is_err());
}
