//! Carter's theory.

use std::f64::consts::PI;

use creepage::Region;
use creepage::approximate::carter::{Carter, LineContact};
use creepage::{Solid, SolidPair};

use super::plane::principal_value;

/// Slip in units of `mu a / rho` by the plane half-space: half-width `a` and peak pressure of
/// Hertz's line contact make the kernel's factor `4 / pi`.
fn slip(carter: Carter, creepage: f64, x: f64) -> f64 {
    let mut breaks = vec![-1.0, 1.0];
    if carter.trailing_edge().abs() < 1.0 {
        breaks.insert(1, carter.trailing_edge());
    }
    creepage - 4.0 / PI * principal_value(|t| carter.at(t).traction[0], &breaks, x)
}

#[test]
fn slip_vanishes_in_adhesion_and_follows_the_traction_in_slip() {
    for creepage in [0.1, 1.0, -2.0, 3.9, -4.0, 5.5] {
        let carter = Carter::new(creepage).unwrap();
        for x in [-0.97, -0.6, -0.3, 0.05, 0.4, 0.93, 0.99] {
            let at = carter.at(x);
            let slip = slip(carter, creepage, x);
            // The quadrature's rounding stays below.
            assert!((slip - at.slip[0]).abs() < 1e-12, "{creepage} {x}: {slip} {at:?}");
            match at.region {
                Region::Adhesion => {
                    assert!(slip.abs() < 1e-12);
                    assert!(at.traction[0].abs() < (1.0 - x * x).sqrt());
                }
                Region::Outside => panic!("{x} is inside"),
                Region::Slip => {
                    assert!(at.slip[0] * at.traction[0] > 0.0, "{creepage} {x} {at:?}");
                    assert!((at.traction[0].abs() - (1.0 - x * x).sqrt()).abs() < 1e-15);
                }
            }
        }
    }
}

/// (1.3), by integrating the traction.
#[test]
fn force_is_the_sum_of_the_tractions() {
    for creepage in [-0.5, 1.0, 2.0, 3.5, 4.0, 7.0] {
        let carter = Carter::new(creepage).unwrap();
        let points = 20_000;
        // Midpoint rule in the angle: square roots at the ends become smooth, that at the
        // trailing edge of adhesion leaves an error of order (1/points)^1.5.
        let step = PI / f64::from(points);
        let sum: f64 = (0..points)
            .map(|i| {
                let (sin, cos) = ((f64::from(i) + 0.5) * step).sin_cos();
                carter.at(cos).traction[0] * sin * step
            })
            .sum();
        assert!((sum * 2.0 / PI - carter.force()).abs() < 2e-6, "{creepage}");
    }
}

#[test]
fn from_free_rolling_to_gross_sliding() {
    let free = Carter::new(0.0).unwrap();
    assert_eq!(free.force(), 0.0);
    assert_eq!(free.adhesion_half_width(), 1.0);
    assert_eq!(free.derivative(), 0.5);
    assert_eq!(free.at(0.3).traction[0], 0.0);
    let sliding = Carter::new(Carter::GROSS_SLIDING).unwrap();
    assert_eq!([sliding.force(), sliding.trailing_edge(), sliding.derivative()], [1.0, 1.0, 0.0]);
    assert_eq!(Carter::new(-1e300).unwrap().force(), -1.0);
    assert_eq!(sliding.at(1.5).traction, [0.0; 2]);
    assert!(Carter::new(f64::NAN).is_err());
}

/// A quadratic: central differences are exact but for rounding, 1e-16 / 1e-4.
#[test]
fn derivative_agrees_with_central_differences() {
    for creepage in [-3.0, -0.4, 0.7, 2.9] {
        let at = |k| Carter::new(k).unwrap();
        let difference = (at(creepage + 1e-4).force() - at(creepage - 1e-4).force()) / 2e-4;
        assert!((difference - at(creepage).derivative()).abs() < 1e-11);
    }
}

/// Hertz's line contact in its usual form: `a^2 = 4 N R / (pi E*)`, `p0^2 = N E* / (pi R)`.
#[test]
fn line_contact_follows_hertz() {
    let (upper, lower) = (Solid::new(82e9, 0.28).unwrap(), Solid::new(30e9, 0.4).unwrap());
    let (r1, r2, load) = (0.46, 2.0, 3e6);
    let contact = LineContact::new(SolidPair::new(upper, lower), [r1, r2], load).unwrap();
    let modulus = 1.0 / ((1.0 - 0.28) / (2.0 * 82e9) + (1.0 - 0.4) / (2.0 * 30e9));
    let radius = 1.0 / (1.0 / r1 + 1.0 / r2);
    let half_width = (4.0 * load * radius / (PI * modulus)).sqrt();
    let pressure = (load * modulus / (PI * radius)).sqrt();
    assert!((contact.half_width() / half_width - 1.0).abs() < 1e-14);
    assert!((contact.peak_pressure() / pressure - 1.0).abs() < 1e-14);
    assert!((contact.rho() / (4.0 * radius) - 1.0).abs() < 1e-14);
}

/// Chapter 1's example: equal cylinders, `rho/a = 200`, `mu = 0.3`: half of the contact adheres
/// at a creepage of 0.003, and gross sliding sets in at 0.006.
#[test]
fn example_of_the_thesis() {
    let steel = Solid::new(80e9, 0.3).unwrap();
    let pair = SolidPair::new(steel, steel);
    // rho = 1 m; the load that makes a = rho/200.
    let load = PI * 80e9 * 0.005_f64.powi(2) / 0.7;
    let contact = LineContact::new(pair, [0.5, 0.5], load).unwrap();
    assert!((contact.rho() / contact.half_width() - 200.0).abs() < 1e-10);
    let half = contact.carter(0.003, 0.3).unwrap();
    assert!((half.adhesion_half_width() - 0.5).abs() < 1e-12);
    assert!((contact.carter(0.006, 0.3).unwrap().force() - 1.0).abs() < 1e-12);
}

#[test]
fn line_contact_refuses_nonsense() {
    let steel = Solid::new(80e9, 0.3).unwrap();
    let new = |radii, load| LineContact::new(SolidPair::new(steel, steel), radii, load);
    assert_eq!(new([0.5, 0.5], -1.0).unwrap_err().quantity, "load");
    assert_eq!(new([0.5, 0.0], 1.0).unwrap_err().quantity, "radius");
    assert_eq!(new([0.5, -0.4], 1.0).unwrap_err().quantity, "rho");
    assert_eq!(new([f64::INFINITY; 2], 1.0).unwrap_err().quantity, "rho");
    assert!(new([0.5, f64::INFINITY], 1.0).unwrap().carter(f64::NAN, 0.3).is_err());
}
