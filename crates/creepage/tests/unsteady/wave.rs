//! Linear theory of harmonic creepage.

use std::f64::consts::TAU;

use creepage::approximate::linear::{CreepageCoefficients, Linear};
use creepage::coulomb::Resolution;
use creepage::unsteady::{HarmonicCreepage, Rolling};
use creepage::{Creepage, Theory};

use super::support::{contact, creeping};

/// Long waves are steady at every moment, with a lag: at 400 semi-axes 5 % of a radian at most. The
/// moment of spin overshoots in transients, and leads.
#[test]
fn long_waves_are_steady() {
    for a_over_b in [0.5, 1.0, 2.0] {
        let contact = contact(a_over_b, 0.28);
        let steady = CreepageCoefficients::new(&contact).unwrap();
        let found = HarmonicCreepage::new(&contact).unwrap().coefficients(400.0).unwrap();
        for (found, steady) in
            [(found.c11, steady.c11), (found.c22, steady.c22), (found.c33, steady.c33)]
        {
            assert!((found.real / steady - 1.0).abs() < 2e-3, "{a_over_b}: {found:?} {steady}");
            assert!(found.phase().abs() < 0.05, "{a_over_b}: {found:?}");
        }
        assert!(found.c11.phase() < 0.0 && found.c22.phase() < 0.0, "{a_over_b}: {found:?}");
    }
}

/// The full theory at a hundredth of the creepage that slides, over the last of three waves, by Fourier
/// analysis. It slides at the trailing edge yet: both elements and that take up to 2 %.
#[test]
fn it_is_the_limit_of_the_full_theory() {
    const STEPS: u32 = 40;
    const SIZE: f64 = 1e-3;
    let contact = contact(1.0, 0.28);
    let linear = Linear::new(&contact).unwrap().solve(Creepage::new(SIZE, 0.0, 0.0).unwrap());
    let steady = linear.force.fx / SIZE;
    let harmonic = HarmonicCreepage::new(&contact).unwrap();
    let long = harmonic.coefficients(1e6).unwrap().c11.real;
    for (wavelength, waves) in [(2.0, 6), (4.0, 4), (10.0, 3)] {
        let expected = harmonic.coefficients(wavelength).unwrap().c11;
        let mut rolling = Rolling::new(&contact, Resolution::FAST).unwrap();
        let (mut real, mut imaginary) = (0.0, 0.0);
        for k in 0..waves * STEPS {
            let phase = |k: f64| TAU * k / f64::from(STEPS);
            let [from, to] = [phase(f64::from(k)), phase(f64::from(k + 1))];
            let mean = SIZE * (to.sin() - from.sin()) / (to - from);
            let step = wavelength / f64::from(STEPS);
            let force = rolling.advance(step, &creeping(mean, 0.0, 0.0)).unwrap().solution.force.fx;
            if k >= (waves - 1) * STEPS {
                real += 2.0 * force * to.cos() / f64::from(STEPS) / SIZE;
                imaginary -= 2.0 * force * to.sin() / f64::from(STEPS) / SIZE;
            }
        }
        let unit = long / steady;
        let off = (unit * real - expected.real).hypot(unit * imaginary - expected.imaginary);
        assert!(off < 0.02 * expected.magnitude(), "{wavelength}: {real} {imaginary} {expected:?}");
    }
}

#[test]
fn waves_shorter_than_elements_are_refused() {
    let harmonic = HarmonicCreepage::new(&contact(1.0, 0.28)).unwrap();
    for wavelength in [0.1, 0.0, -1.0, f64::NAN] {
        assert_eq!(harmonic.coefficients(wavelength).unwrap_err().quantity, "wavelength");
    }
}
