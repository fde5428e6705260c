//! The numerical theory of chapter 5 where the contact is long in the rolling direction: the least
//! loss of power keeps tractions within their bound, and has one minimum.
#![allow(clippy::unwrap_used)]

mod common;

use common::contact;
use creepage::coulomb::{Exact, Resolution};
use creepage::variational::{Chain, Procedure, Settings, Start, TractionBound, Variational};
use creepage::{Creepage, Status, Theory};
use proptest::prelude::*;

fn of_degree(degree: usize, a_over_b: f64) -> Variational {
    Variational::new(&contact(a_over_b, 0.28), Settings::of_degree(degree)).unwrap()
}

fn spin(chi: f64) -> Creepage {
    Creepage::new(0.0, 0.0, chi).unwrap()
}

/// The largest change of the lateral force from one spin to the next.
fn largest_step(theory: &Variational, step: f64, count: u32) -> f64 {
    let force =
        |k: u32| theory.solve_from(spin(step * f64::from(k)), &Start::Zero).solution.force.fy;
    let forces: Vec<f64> = (0..=count).map(force).collect();
    forces.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max)
}

/// Pure spin on a/b = 5, where the programme of 1967 gave up (5.33), chi = 0.05 to 10.
#[test]
fn pure_spin_is_one_curve_from_three_starts() {
    for (a_over_b, degree) in [(5.0, 3), (5.0, 2), (5.0, 4), (3.0, 3), (8.0, 3)] {
        let theory = of_degree(degree, a_over_b);
        assert!(theory.keeps_bound());
        let mut chain = Chain::new(&theory, Procedure::default());
        for k in 1..=200 {
            let creepage = spin(0.05 * f64::from(k));
            let found = theory.solve_from(creepage, &Start::FullSliding);
            let place = format!("a/b {a_over_b}, M {degree}, chi {}", creepage.chi());
            assert_ne!(found.solution.status, Status::NotConverged, "{place}");
            let force = found.solution.force;
            assert!(force.fy > 0.0 && force.fy < 0.95, "{place}: {force:?}");
            // Convergence is to 1e-9 in the unknowns.
            for start in [Start::Adhesion, Start::Zero] {
                assert!(theory.check_by(creepage, &found, &start) < 1e-8, "{place}: {start:?}");
            }
            let case = chain.solve(creepage, None);
            assert_eq!(case.steps_from_previous, 1, "{place}");
            let apart = (case.found.solution.force.fy - force.fy).abs();
            assert!(apart < 1e-8, "{place}: {apart}");
        }
    }
}

/// No jump: ten times smaller steps in spin change the force ten times less, and nowhere is the
/// curve steeper than the full theory is at its steepest, which is at the beginning.
#[test]
fn the_curve_of_pure_spin_is_continuous() {
    let exact = Exact::new(&contact(5.0, 0.28), Resolution::STANDARD).unwrap();
    let steepest = exact.solve(spin(0.05)).force.fy;
    for degree in [3, 4] {
        let theory = of_degree(degree, 5.0);
        let [coarse, fine] = [largest_step(&theory, 0.05, 60), largest_step(&theory, 0.005, 600)];
        assert!(coarse < 1.05 * steepest, "M {degree}: {coarse}, {steepest}");
        assert!(fine < 0.15 * steepest, "M {degree}: {fine}, {steepest}");
    }
}

/// Root mean square of the error of the lateral force for spins up to 1, around the peak, and
/// from there to 10.
fn errors(theory: &Variational, exact: &[[f64; 2]]) -> [f64; 2] {
    let mean = |cases: &[[f64; 2]]| {
        let squares = cases.iter().map(|[chi, fy]| {
            (theory.solve_from(spin(*chi), &Start::Zero).solution.force.fy - fy).powi(2)
        });
        (squares.sum::<f64>() / cases.len() as f64).sqrt()
    };
    let (low, high) = exact.split_at(20);
    [mean(low), mean(high)]
}

/// Pure spin on a/b = 5 against the full theory. Up to the peak and behind it degree 3 is right to
/// some hundredths. Beyond chi = 1.1 the direction of sliding turns within a small part of the
/// contact, which polynomials of degree 3 do not resolve; more degree does.
#[test]
fn pure_spin_approaches_the_full_theory() {
    let full = Exact::new(&contact(5.0, 0.28), Resolution::STANDARD).unwrap();
    let low = (1..=20).map(|k| 0.05 * f64::from(k));
    let spins = low.chain([1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 7.0, 10.0]);
    let exact: Vec<_> = spins.map(|chi| [chi, full.solve(spin(chi)).force.fy]).collect();
    for (degree, bounds) in [(3, [0.05, 0.22]), (6, [0.06, 0.08]), (8, [0.05, 0.06])] {
        let kept = errors(&of_degree(degree, 5.0), &exact);
        // A fifth above what was measured.
        assert!(kept[0] < bounds[0] && kept[1] < bounds[1], "M {degree}: {kept:?}");
        let settings = Settings { bound: TractionBound::Unchecked, ..Settings::of_degree(degree) };
        let unchecked = errors(&Variational::new(&contact(5.0, 0.28), settings).unwrap(), &exact);
        assert!(kept[0] < unchecked[0], "M {degree}: {kept:?}, {unchecked:?}");
    }
}

#[test]
fn full_sliding_is_exact() {
    let theory = of_degree(3, 5.0);
    let force = |size: f64| {
        let creepage = Creepage::new(0.6 * size, -0.8 * size, 0.0).unwrap();
        let force = theory.solve_from(creepage, &Start::FullSliding).solution.force;
        (force.fx - 0.6).hypot(force.fy + 0.8)
    };
    // The slip of elastic bodies turns the traction by about 1/|creepage|.
    assert!(force(1e2) < 0.02 && force(1e4) < 2e-4, "{} {}", force(1e2), force(1e4));
    let none = theory.solve_from(Creepage::default(), &Start::FullSliding);
    assert_eq!(none.solution.status, Status::Solved);
    assert!(none.solution.force.magnitude() < f64::MIN_POSITIVE);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// A convex functional: any start ends in the same minimum, below the friction force.
    #[test]
    fn any_start_finds_the_one_minimum(
        a_over_b in 3.0..12.0_f64, size in 0.0..4.0_f64, angle in -3.2..3.2_f64,
        chi in -5.0..5.0_f64, seed in prop::collection::vec(-3.0..3.0_f64, 20),
    ) {
        let theory = of_degree(3, a_over_b);
        let creepage = Creepage::new(size * angle.cos(), size * angle.sin(), chi).unwrap();
        let found = theory.solve_from(creepage, &Start::FullSliding);
        prop_assert!(found.solution.status != Status::NotConverged);
        // Convergence is to 1e-9 in the unknowns.
        prop_assert!(theory.check_by(creepage, &found, &Start::From(&seed)) < 1e-7);
        // The penalty lets single points pass the bound, but not their sum.
        prop_assert!(found.solution.force.magnitude() < 1.0 + 1e-6);
    }
}
