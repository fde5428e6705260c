//! Friction by the speed of slip: limits, identities, derivatives.
// Tests may fail by unwrapping.
#![allow(clippy::float_cmp, clippy::unwrap_used)]

use creepage::friction_law::{FrictionLaw, FrictionMemory, Shape, Term};
use proptest::prelude::*;

fn law() -> impl Strategy<Value = FrictionLaw> {
    let shape = prop::sample::select(vec![Shape::Exponential, Shape::Linear, Shape::Rational]);
    let term =
        (0.0..0.3_f64, 0.01..2.0_f64).prop_map(|(drop, half_speed)| Term { drop, half_speed });
    (shape, 0.05..0.5_f64, prop::collection::vec(term, 0..3))
        .prop_map(|(shape, kinetic, terms)| FrictionLaw::new(shape, kinetic, &terms).unwrap())
}

proptest! {
    /// From rest to the kinetic value, downwards, without a jump.
    #[test]
    fn laws_fall_from_rest_to_the_kinetic_value(law in law(), speed in 0.0..5.0_f64) {
        prop_assert!((law.at(0.0) - law.at_rest()).abs() < 1e-15);
        prop_assert!((law.at(1e9) - law.kinetic()).abs() < 1e-7);
        prop_assert!(law.at(speed) <= law.at_rest() + 1e-15 && law.at(speed) >= law.kinetic());
        let next = law.at(speed + 1e-9);
        // The steepest term falls by .3 over the half speed .01.
        prop_assert!(next <= law.at(speed) + 1e-15 && law.at(speed) - next < 1e-7);
    }

    /// The derivative is that of the values; at the kink of a linear law it is one-sided.
    #[test]
    fn the_slope_is_the_derivative(law in law(), speed in 0.01..5.0_f64) {
        let step = 1e-6;
        let kink = |term: &Term| (speed - 2.0 * term.half_speed).abs() < 2.0 * step;
        prop_assume!(law.shape() != Shape::Linear || !law.terms().iter().any(kink));
        let expected = (law.at(speed + step) - law.at(speed - step)) / (2.0 * step);
        // The third derivative times the square of the step, and rounding over the step.
        prop_assert!((law.with_slope(speed)[1] - expected).abs() < 1e-5);
    }

    /// Polach's law is an exponential one.
    #[test]
    fn polach_is_a_special_case(
        at_rest in 0.1..0.7_f64, ratio in 0.0..1.0_f64, rate in 0.01..5.0_f64, speed in 0.0..10.0_f64,
    ) {
        let law = FrictionLaw::polach(at_rest, ratio, rate).unwrap();
        let expected = at_rest * ((1.0 - ratio) * (-rate * speed).exp() + ratio);
        prop_assert!((law.at(speed) - expected).abs() < 3e-16);
    }

    /// Memory steps between what was and what the law says; at constant speed it is the solution of
    /// the equation, `exp(-s t/d)`.
    #[test]
    fn memory_solves_its_equation(law in law(), speed in 0.0..3.0_f64, before in 0.1..0.8_f64) {
        let memory = FrictionMemory::new(0.02, 1e-3).unwrap();
        let time = 0.01;
        let found = memory.step(&law, before, [speed; 2], time);
        let target = law.at(speed);
        let decay = (-speed.max(1e-3) * time / 0.02).exp();
        prop_assert!((found - target - (before - target) * decay).abs() < 1e-14);
    }

    /// While the speed changes a step errs by the third power of its length: many by the second.
    #[test]
    fn memory_is_of_second_order(law in law(), before in 0.1..0.8_f64) {
        prop_assume!(law.shape() != Shape::Linear);
        let memory = FrictionMemory::new(0.02, 1e-3).unwrap();
        let after = |steps: u32| {
            let step = 0.05 / f64::from(steps);
            let speed = |k: u32| 1.0 + (20.0 * f64::from(k) * step).sin();
            (0..steps).fold(before, |friction, k| {
                memory.step(&law, friction, [speed(k), speed(k + 1)], step)
            })
        };
        let [coarse, fine, finest] = [32, 64, 2048].map(after);
        prop_assert!((fine - finest).abs() < 0.3 * (coarse - finest).abs() + 1e-6);
    }
}

/// Half is left at the half speed, by every shape.
#[test]
fn half_at_the_half_speed() {
    for shape in [Shape::Exponential, Shape::Linear, Shape::Rational] {
        let term = Term { drop: 0.2, half_speed: 0.3 };
        let law = FrictionLaw::new(shape, 0.1, &[term, term]).unwrap();
        assert!((law.at(0.3) - 0.3).abs() < 1e-15, "{shape:?}");
    }
    assert_eq!(FrictionLaw::constant(0.3).unwrap().with_slope(7.0), [0.3, 0.0]);
}

#[test]
fn nonsense_is_an_error_that_names_the_quantity() {
    let term = |drop, half_speed| vec![Term { drop, half_speed }];
    let law = |kinetic, terms: Vec<Term>| FrictionLaw::new(Shape::Linear, kinetic, &terms);
    assert_eq!(
        law(0.1, vec![Term { drop: 0.1, half_speed: 1.0 }; 5]).unwrap_err().quantity,
        "terms"
    );
    assert_eq!(law(-0.1, vec![]).unwrap_err().quantity, "kinetic");
    assert_eq!(law(0.1, term(-0.1, 1.0)).unwrap_err().quantity, "drop");
    assert_eq!(law(0.1, term(0.1, 0.0)).unwrap_err().quantity, "half_speed");
    assert_eq!(law(0.0, vec![]).unwrap_err().quantity, "friction at rest");
    assert_eq!(FrictionLaw::polach(0.3, 1.2, 1.0).unwrap_err().quantity, "ratio");
    assert_eq!(FrictionMemory::new(0.0, 1.0).unwrap_err().quantity, "memory_distance");
}
