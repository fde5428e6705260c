//! Exact derivatives of the forces against central differences.

use creepage::approximate::fastrip::{Fastrip, Variant};
use creepage::approximate::fastsim::{Fastsim, Flexibility, Settings, TractionBound};
use creepage::approximate::strip::StripTheory;
use creepage::{Creepage, Theory};

use super::cases::{CREEPAGES, array, coefficients, contact, creepage, strip_coefficients};

/// Largest difference of `derivative` at `at` to central differences of step `h`.
fn difference(theory: &impl Theory, derivative: [[f64; 3]; 3], at: Creepage, h: f64) -> f64 {
    let numbers = [at.xi(), at.eta(), at.chi()];
    let mut largest = 0.0_f64;
    for column in 0..3 {
        let side = |step: f64| {
            let mut moved = numbers;
            moved[column] += step;
            array(theory.solve(creepage(moved[0], moved[1], moved[2])).force)
        };
        let (up, down) = (side(h), side(-h));
        for row in 0..3 {
            let slope = (up[row] - down[row]) / (2.0 * h);
            largest = largest.max((slope - derivative[row][column]).abs());
        }
    }
    largest
}

/// Kinks: strip theory has one where the first strips begin to slide, and at zero creepage.
#[test]
fn strip_theory() {
    for (a_over_b, poisson) in [(0.2, 0.28), (1.0, 0.0), (3.0, 0.45)] {
        let theory = StripTheory::new(&contact(a_over_b, poisson));
        for [xi, eta, chi] in CREEPAGES {
            let at = creepage(xi, eta, chi);
            let difference = difference(&theory, theory.jacobian(at).unwrap(), at, 1e-5);
            // h^2 = 1e-10 times third derivatives, which grow towards the kinks.
            assert!(difference < 1e-6, "{a_over_b} {at:?}: {difference}");
        }
    }
}

/// Kinks: FASTSIM's discrete force has one whenever a cell begins to slip, so that the step is
/// short; and at the end of the blending and, with one flexibility, where a creepage is zero
/// while others are not.
#[test]
fn fastsim() {
    for flexibility in [Flexibility::One, Flexibility::Three, Flexibility::Blended] {
        for bound in [TractionBound::Parabolic, TractionBound::Elliptic] {
            let settings = Settings { flexibility, bound, grid: [24, 19], ..Settings::default() };
            let theory = Fastsim::new(&contact(0.5, 0.25), settings).unwrap();
            for [xi, eta, chi] in CREEPAGES.into_iter().filter(|c| c.iter().all(|v| *v != 0.0)) {
                let at = creepage(xi, eta, chi);
                let difference = difference(&theory, theory.jacobian(at).unwrap(), at, 1e-7);
                // Rounding, 1e-15 / 1e-7, and a margin for the sums.
                assert!(difference < 1e-7, "{settings:?} {at:?}: {difference}");
            }
        }
    }
}

/// Kinks: FASTSIM's, and where the border of the slip area meets that of a cell. Also jumps: of
/// the original where a strip begins to take one flexibility, of all variants at the bound in
/// spin.
#[test]
fn fastrip() {
    for variant in [Variant::Original, Variant::Modified, Variant::Consistent] {
        for (a_over_b, poisson) in [(0.5, 0.25), (2.0, 0.25)] {
            let theory = Fastrip::new(&contact(a_over_b, poisson), variant, [24, 19]).unwrap();
            for [xi, eta, chi] in CREEPAGES.into_iter().filter(|c| c.iter().all(|v| *v != 0.0)) {
                let at = creepage(xi, eta, chi);
                let difference = difference(&theory, theory.jacobian(at).unwrap(), at, 1e-7);
                assert!(difference < 1e-6, "{variant:?} {a_over_b} {at:?}: {difference}");
            }
        }
    }
}

/// At zero creepage the derivative is the linear theory's.
#[test]
fn at_zero_creepage() {
    let (a_over_b, poisson) = (0.5, 0.25);
    let kappa = super::cases::kappa(a_over_b, poisson);
    let zero = Creepage::default();
    let strips = strip_coefficients(a_over_b, poisson);
    let derivative = StripTheory::new(&contact(a_over_b, poisson)).jacobian(zero).unwrap();
    let expected =
        [[strips.c11, 0.0, 0.0], [0.0, strips.c22, strips.c23], [0.0, strips.c32, strips.c33]];
    for row in 0..3 {
        for column in 0..3 {
            let slope = derivative[row][column] / kappa;
            assert!((slope - expected[row][column]).abs() < 1e-12, "{row} {column} {slope}");
        }
    }
    let c = coefficients(a_over_b, poisson);
    let check = |derivative: [[f64; 3]; 3], tolerance: f64| {
        for (row, column, expected) in [(0, 0, c.c11), (1, 1, c.c22), (1, 2, c.c23), (0, 1, 0.0)] {
            let slope = derivative[row][column] / kappa;
            assert!((slope - expected).abs() < tolerance, "{row} {column} {slope} {expected}");
        }
    };
    for flexibility in [Flexibility::One, Flexibility::Three, Flexibility::Blended] {
        let settings = Settings { flexibility, grid: [400, 400], ..Settings::default() };
        // The midpoint rule across, of a smooth function: 1/400^2.
        check(
            Fastsim::new(&contact(a_over_b, poisson), settings).unwrap().jacobian(zero).unwrap(),
            3e-5,
        );
    }
    for variant in [Variant::Original, Variant::Modified, Variant::Consistent] {
        let theory = Fastrip::new(&contact(a_over_b, poisson), variant, [400, 400]).unwrap();
        // Of a square root at the ends: 1/400^1.5.
        check(theory.jacobian(zero).unwrap(), 3e-4);
    }
}
