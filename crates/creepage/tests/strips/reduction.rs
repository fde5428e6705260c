//! FASTSIM on surfaces that are not clean and dry: Kalker's reduction factor.

use std::f64::consts::FRAC_PI_4;

use creepage::approximate::fastsim::{Fastsim, Flexibility, Settings, TractionBound};
use creepage::friction_law::{FrictionLaw, RollingFriction, Shape, Term};
use creepage::{Contact, Ellipse, Hertz, SiCreepage, Solid, SolidPair, Theory};

use super::cases::{CREEPAGES, array, coefficients, contact, creepage, kappa};

/// Of an Eurosprinter locomotive (Spiryagin, Polach and Cole 2013).
const WET: [f64; 3] = [0.54, 0.02, 0.62];

fn reduced(contact: &Contact, settings: Settings, reduction: [f64; 3]) -> Fastsim {
    Fastsim::new(contact, Settings { reduction, ..settings }).unwrap()
}

fn every_kind() -> impl Iterator<Item = Settings> {
    let kinds = [Flexibility::One, Flexibility::Three, Flexibility::Blended];
    kinds.into_iter().flat_map(|flexibility| {
        [TractionBound::Elliptic, TractionBound::Parabolic].map(|bound| Settings {
            flexibility,
            bound,
            grid: [20, 15],
            ..Settings::default()
        })
    })
}

#[test]
fn factors_of_one_change_no_bit() {
    let contact = contact(0.5, 0.28);
    for settings in every_kind() {
        let clean = Fastsim::new(&contact, settings).unwrap();
        // Without a fall it does not matter how fast it would be.
        let one = reduced(&contact, settings, [1.0, 1.0, 7.0]);
        for [xi, eta, chi] in CREEPAGES {
            let at = creepage(xi, eta, chi);
            assert_eq!(array(clean.solve(at).force), array(one.solve(at).force));
            assert_eq!(clean.jacobian(at), one.jacobian(at));
        }
    }
}

/// Springs softer by a factor everywhere are loaded as the others by so much less creepage.
#[test]
fn a_constant_factor_is_one_of_the_creepage() {
    let contact = contact(1.6, 0.3);
    let settings =
        Settings { flexibility: Flexibility::Three, grid: [20, 15], ..Settings::default() };
    let clean = Fastsim::new(&contact, settings).unwrap();
    let soft = reduced(&contact, settings, [0.4, 1.0, 0.0]);
    for [xi, eta, chi] in CREEPAGES {
        let there = array(soft.solve(creepage(xi, eta, chi)).force);
        let here = array(clean.solve(creepage(0.4 * xi, 0.4 * eta, 0.4 * chi)).force);
        for (there, here) in there.into_iter().zip(here) {
            // Rounding, summed over 300 cells.
            assert!((there - here).abs() < 1e-13, "{there} {here}");
        }
    }
}

/// `k` from the definition, with the linear theory's own coefficients.
#[test]
fn the_factor_falls_as_defined() {
    let (a_over_b, poisson) = (0.5, 0.28);
    let contact = contact(a_over_b, poisson);
    let settings =
        Settings { flexibility: Flexibility::Three, grid: [40, 40], ..Settings::default() };
    let clean = Fastsim::new(&contact, settings).unwrap();
    let wet = reduced(&contact, settings, WET);
    let [at_rest, left, fall] = WET;
    let (c11, unit) = (coefficients(a_over_b, poisson).c11, kappa(a_over_b, poisson));
    for xi in [1e-6, 0.03, 0.4, 2.0, 30.0] {
        let gradient = FRAC_PI_4 * at_rest * unit * c11 * xi;
        let factor = at_rest * (left + (1.0 - left) / (1.0 + fall * gradient));
        let there = wet.solve(creepage(xi, 0.0, 0.0)).force.fx;
        let here = clean.solve(creepage(factor * xi, 0.0, 0.0)).force.fx;
        // Rounding, summed over 1600 cells.
        assert!((there / here - 1.0).abs() < 1e-11, "{xi}: {there} {here}");
    }
    // In the limits: k0 at rest, k0 alpha at the end, where nothing holds any more.
    let slope = |theory: &Fastsim| theory.solve(creepage(1e-9, 0.0, 0.0)).force.fx;
    assert!((slope(&wet) / slope(&clean) - at_rest).abs() < 1e-7);
    assert!(wet.solve(creepage(1e6, 0.0, 0.0)).force.fx > 0.999);
}

#[test]
fn the_derivative_is_that_of_the_force() {
    let contact = contact(0.5, 0.25);
    for settings in every_kind() {
        let wet = reduced(&contact, settings, WET);
        for [xi, eta, chi] in CREEPAGES.into_iter().filter(|c| c.iter().all(|v| *v != 0.0)) {
            let jacobian = wet.jacobian(creepage(xi, eta, chi)).unwrap();
            for column in 0..3 {
                // No kink lies so near.
                let step = 1e-7;
                let force = |sign: f64| {
                    let mut at = [xi, eta, chi];
                    at[column] += sign * step;
                    array(wet.solve(creepage(at[0], at[1], at[2])).force)
                };
                let (ahead, behind) = (force(1.0), force(-1.0));
                for row in 0..3 {
                    let slope = 0.5 * (ahead[row] - behind[row]) / step;
                    // Rounding, 1e-15 / 1e-7, and a margin for the sums.
                    assert!((jacobian[row][column] - slope).abs() < 1e-7, "{settings:?}");
                }
            }
        }
    }
}

/// The program CONTACT's example of a traction curve (its fourth series, "modified Fastsim"): force over
/// `0.36 N`, from its stored output; its grid of 48 x 44 elements leaves .003. Its linear force without reduction,
/// 250.9 N at a creepage of 1e-5 (case 61), is 3 % larger than ours, so that the creepages are made as much larger.
#[test]
fn a_wet_locomotive_pulls_as_in_contact() {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let terms = [Term { drop: 0.2232, half_speed: 0.99 }];
    let law = FrictionLaw::new(Shape::Exponential, 0.1368, &terms).unwrap();
    let ellipse = Ellipse::new(6.304e-3, 12.61e-3).unwrap();
    let hertz = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 106_700.0).unwrap();
    let settings = Settings {
        flexibility: Flexibility::Three,
        bound: TractionBound::Parabolic,
        grid: [44, 40],
        ..Settings::default()
    };
    let force = |speed: f64, reduction: [f64; 3], longitudinal: f64| {
        let friction = RollingFriction::new(law, None, speed).unwrap();
        let contact = hertz.with_friction_law(friction).unwrap();
        let si = SiCreepage { longitudinal, ..SiCreepage::default() };
        let creepage = contact.scaling().creepage(si).unwrap();
        reduced(&contact, settings, reduction).solve(creepage).force.fx
    };
    let stiffer = 250.9 / (force(10.0, Settings::CLEAN, 1e-5) * 0.36 * 106_700.0);
    assert!((stiffer - 1.0).abs() < 0.04, "{stiffer}");
    for (creepage, expected) in [
        (1e-5, 3.526e-3),
        (1e-3, 0.2721),
        (2e-3, 0.4388),
        (4e-3, 0.6224),
        (6e-3, 0.7148),
        (8e-3, 0.7666),
        (0.01, 0.7979),
        (0.016, 0.8375),
        (0.022, 0.8451),
        (0.035, 0.8311),
        (0.065, 0.7654),
        (0.1, 0.6874),
        (0.15, 0.5970),
        (0.25, 0.4877),
    ] {
        // At the same speed of slip.
        let found = force(10.0 / stiffer, WET, stiffer * creepage);
        assert!((found - expected).abs() < 0.006, "{creepage}: {found} {expected}");
    }
}
