//! Cost of the limiting theories and of the laws in closed form.

use creepage::Theory;
use creepage::approximate::linear::{CreepageCoefficients, Linear};
use creepage::approximate::polach::Polach;
use creepage::approximate::saturated::Saturated;
use creepage::approximate::shen_hedrick_elkins::ShenHedrickElkins;
use creepage::approximate::vermeulen_johnson::VermeulenJohnson;
use divan::{Bencher, black_box};

#[path = "../tests/common/mod.rs"]
mod common;
use common::{at, contact};

fn main() {
    divan::main();
}

const POISSON: f64 = 0.28;
const CREEPAGE: [f64; 3] = [0.4, 0.3, 0.2];
/// The spin pole in the contact.
const SPIN: [f64; 3] = [0.02, 0.01, 2.0];

/// Preparation: the coefficients of one shape.
#[divan::bench(args = [1e-3, 0.1, 1.0, 10.0, 1e3])]
fn coefficients(bencher: Bencher<'_, '_>, a_over_b: f64) {
    bencher.bench(|| CreepageCoefficients::new(&contact(black_box(a_over_b), black_box(POISSON))));
}

/// The same by their series.
#[divan::bench]
fn interpolated_coefficients() -> Option<CreepageCoefficients> {
    CreepageCoefficients::interpolated(&contact(black_box(1.5), black_box(POISSON))).ok()
}

/// The thesis's own calculation.
#[divan::bench]
fn coefficients_of_degree_5() -> Option<CreepageCoefficients> {
    CreepageCoefficients::of_degree(&contact(black_box(0.5), black_box(POISSON)), 5).ok()
}

#[divan::bench]
fn linear(bencher: Bencher<'_, '_>) {
    force(bencher, Linear::new(&contact(1.5, POISSON)).ok(), CREEPAGE);
}

#[divan::bench]
fn vermeulen_johnson(bencher: Bencher<'_, '_>) {
    force(bencher, VermeulenJohnson::new(&contact(1.5, POISSON)).ok(), CREEPAGE);
}

#[divan::bench]
fn shen_hedrick_elkins(bencher: Bencher<'_, '_>) {
    force(bencher, ShenHedrickElkins::new(&contact(1.5, POISSON)).ok(), CREEPAGE);
}

#[divan::bench]
fn polach(bencher: Bencher<'_, '_>) {
    force(bencher, Polach::new(&contact(1.5, POISSON)).ok(), CREEPAGE);
}

#[divan::bench(args = [1e-3, 0.1, 1.0, 10.0, 1e3])]
fn saturated_pole_outside(bencher: Bencher<'_, '_>, a_over_b: f64) {
    force(bencher, Saturated::new(&contact(a_over_b, 0.28)).ok(), [0.4, 0.3, 1e-4]);
}

#[divan::bench]
fn saturated_pole_inside(bencher: Bencher<'_, '_>) {
    force(bencher, Saturated::new(&contact(1.5, 0.28)).ok(), SPIN);
}

fn force<T: Theory>(bencher: Bencher<'_, '_>, theory: Option<T>, creepage: [f64; 3]) {
    let creepage = at(creepage);
    if let Some(theory) = theory {
        bencher.bench_local(|| theory.solve(black_box(creepage)).force);
    }
}
