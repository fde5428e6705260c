//! What all theories in closed form have in common: exact derivatives, their limits for small
//! and for large creepage, and sense for any input.
// A theory that cannot be prepared fails the test.
#![allow(clippy::unwrap_used)]

mod common;

use std::sync::LazyLock;

use common::{contact, creepage};
use creepage::approximate::linear::Linear;
use creepage::approximate::polach::Polach;
use creepage::approximate::saturated::Saturated;
use creepage::approximate::shen_hedrick_elkins::ShenHedrickElkins;
use creepage::approximate::vermeulen_johnson::VermeulenJohnson;
use creepage::{Creepage, Force, Theory};
use proptest::prelude::*;

const RATIOS: [f64; 7] = [1e-3, 0.02, 0.3, 1.0, 1.7, 40.0, 1e3];

struct Subject {
    name: &'static str,
    theory: Box<dyn Theory>,
}

fn subjects(a_over_b: f64, poisson: f64) -> Vec<Subject> {
    let contact = contact(a_over_b, poisson);
    let polach = Polach::new(&contact).unwrap();
    let reduced = polach.clone().with_reduction(0.7, 0.3).unwrap();
    let theories: [(&str, Box<dyn Theory>); 6] = [
        ("linear", Box::new(Linear::new(&contact).unwrap())),
        ("saturated", Box::new(Saturated::new(&contact).unwrap())),
        ("vermeulen_johnson", Box::new(VermeulenJohnson::new(&contact).unwrap())),
        ("shen_hedrick_elkins", Box::new(ShenHedrickElkins::new(&contact).unwrap())),
        ("polach", Box::new(polach)),
        ("polach, reduced", Box::new(reduced)),
    ];
    theories.into_iter().map(|(name, theory)| Subject { name, theory }).collect()
}

static ALL: LazyLock<Vec<(f64, Vec<Subject>)>> =
    LazyLock::new(|| RATIOS.map(|a_over_b| (a_over_b, subjects(a_over_b, 0.28))).into());

fn array(force: Force) -> [f64; 3] {
    [force.fx, force.fy, force.mz]
}

fn force(theory: &dyn Theory, [xi, eta, chi]: [f64; 3]) -> [f64; 3] {
    array(theory.solve(Creepage::new(xi, eta, chi).unwrap()).force)
}

/// Central differences of step 1e-4 of the creepage, extrapolated: an error of 1e-16 of the
/// fifth derivative, and rounding of 1e-12.
#[test]
fn derivatives_agree_with_differences() {
    for (a_over_b, subjects) in ALL.iter().filter(|(r, _)| (0.1..10.0).contains(r)) {
        for subject in subjects {
            for i in 0..120 {
                let i = f64::from(i);
                let size = 10_f64.powf(0.02 * i - 1.5);
                let at =
                    [(1.1 * i + 0.2).sin(), (2.3 * i).cos(), (0.7 * i).sin()].map(|x| size * x);
                // The kink of Polach's law, and the pole on the edge, where the curvature of
                // the forces has an edge as well.
                let kink = (at[1] + at[2] * a_over_b.sqrt()).abs() - at[1].abs();
                let rim = (at[1] / a_over_b.sqrt()).hypot(at[0] * a_over_b.sqrt()) - at[2].abs();
                if kink.abs() < 0.01 * size || rim.abs() < 0.01 * size {
                    continue;
                }
                let exact =
                    subject.theory.jacobian(Creepage::new(at[0], at[1], at[2]).unwrap()).unwrap();
                for column in 0..3 {
                    let difference = |step: f64| {
                        let [low, high] = [-step, step].map(|step| {
                            let mut at = at;
                            at[column] += step;
                            force(&*subject.theory, at)
                        });
                        [0, 1, 2].map(|row| (high[row] - low[row]) / (2.0 * step))
                    };
                    let step = 1e-3 * size;
                    let (coarse, fine) = (difference(step), difference(0.5 * step));
                    for row in 0..3 {
                        let expected = (4.0 * fine[row] - coarse[row]) / 3.0;
                        let error = (exact[row][column] - expected).abs() * size;
                        assert!(
                            error < 1e-8,
                            "{} {a_over_b} {at:?} [{row}][{column}]: {} {expected}",
                            subject.name,
                            exact[row][column]
                        );
                    }
                }
            }
        }
    }
}

/// Small creepage of one kind at a time. Vermeulen and Johnson claim a limit of their own;
/// Polach's spin alone is right, but has no moment.
#[test]
fn small_creepage_is_linear() {
    let tiny = 1e-7;
    for a_over_b in [0.2, 1.0, 5.0] {
        let subjects = subjects(a_over_b, 0.28);
        let gains = subjects[0].theory.jacobian(Creepage::default()).unwrap();
        for (name, rows) in [("shen_hedrick_elkins", 3), ("polach", 2)] {
            let subject = subjects.iter().find(|subject| subject.name == name).unwrap();
            for column in 0..3 {
                let mut at = [0.0; 3];
                at[column] = tiny;
                let force = force(&*subject.theory, at);
                let slope = subject.theory.jacobian(Creepage::default()).unwrap();
                for row in 0..rows {
                    // The deviation is of second order in creepage.
                    let expected = gains[row][column];
                    assert!((force[row] / tiny - expected).abs() < 1e-5, "{name} {column} {row}");
                    assert!(
                        (slope[row][column] - expected).abs() < 1e-12 * expected.abs().max(1.0)
                    );
                }
            }
        }
    }
}

#[test]
fn large_creepage_is_friction() {
    for (a_over_b, subjects) in ALL.iter() {
        for subject in &subjects[1..] {
            for angle in 0..24 {
                let (sin, cos) = (f64::from(angle) * 0.27).sin_cos();
                let [fx, fy, mz] = force(&*subject.theory, [1e9 * cos, 1e9 * sin, 0.0]);
                // Polach tends to mu N as one over creepage.
                let case = format!("{} {a_over_b} {angle}", subject.name);
                assert!((fx.hypot(fy) - 1.0).abs() < 1e-6, "{case}");
                // Shen's moment is a makeshift that does not vanish.
                assert!(mz.abs() < 1e-12 || subject.name == "shen_hedrick_elkins", "{case}");
                // Vermeulen-Johnson's and Shen's direction is that of linear theory.
                assert!(fx * cos >= 0.0 && fy * sin >= 0.0, "{case}");
                if subject.name == "saturated" || subject.name.starts_with("polach") {
                    assert!((fx * sin - fy * cos).abs() < 1e-9, "{case}");
                }
            }
        }
    }
}

fn component() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => Just(0.0),
        1 => Just(-0.0),
        1 => prop_oneof![Just(1e-300), Just(-1e-300), Just(5e-324), Just(-5e-324)],
        1 => prop_oneof![Just(1e6), Just(-1e6), Just(f64::MAX), Just(f64::MIN)],
        2 => -3.0..3.0,
        2 => (-20.0..20.0, any::<bool>())
            .prop_map(|(exponent, minus)| 10_f64.powf(exponent) * if minus { -1.0 } else { 1.0 }),
        1 => any::<f64>().prop_filter("finite", |x| x.is_finite()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(10_000) })]

    #[test]
    fn never_nan(
        shape in 0..RATIOS.len(),
        xi in component(),
        eta in component(),
        chi in component(),
        x in -1.1..1.1,
        y in -1.1..1.1,
    ) {
        let [xi, eta, chi] = [xi, eta, chi].map(|v| v.clamp(-Creepage::MAX, Creepage::MAX));
        let creepage = creepage(xi, eta, chi);
        let (a_over_b, subjects) = &ALL[shape];
        let position = [x * a_over_b.sqrt(), y / a_over_b.sqrt()];
        for Subject { name, theory } in subjects {
            let force = theory.solve(creepage).force;
            prop_assert!(array(force).iter().all(|f| f.is_finite()), "{name}: {force:?}");
            let derivative = theory.jacobian(creepage).unwrap();
            prop_assert!(
                derivative.iter().flatten().all(|d| !d.is_nan()),
                "{name}: {derivative:?}"
            );
            if *name != "linear" {
                prop_assert!(force.magnitude() < 1.0 + 1e-12, "{name}: {force:?}");
            }
            let point = theory.field(creepage, &[position])[0];
            prop_assert!(point.traction.iter().all(|t| t.is_finite()), "{name}: {point:?}");
            if !name.starts_with("polach") && *name != "shen_hedrick_elkins" {
                prop_assert!(point.slip.iter().all(|s| s.is_finite()), "{name}: {point:?}");
            }
        }
    }
}
