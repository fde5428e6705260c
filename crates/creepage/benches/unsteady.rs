//! Cost of a step of rolling that is not steady, beside that of a steady solution.
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout)]

use creepage::coulomb::{Exact, Resolution};
use creepage::unsteady::{HarmonicCreepage, Motion, Rolling};
use creepage::{Contact, Creepage, Ellipse, Theory};
use divan::Bencher;

fn main() {
    let bytes = rolled().save().to_bytes().len();
    println!("state of the standard resolution: {bytes} bytes");
    divan::main();
}

fn contact() -> Contact {
    Contact::new(Ellipse::from_ratio(1.0).unwrap(), 0.28).unwrap()
}

fn creepage() -> Creepage {
    Creepage::new(0.5, 0.2, 0.3).unwrap()
}

/// A contact that has rolled a semi-axis.
fn rolled() -> Rolling {
    let mut rolling = Rolling::new(&contact(), Resolution::STANDARD).unwrap();
    rolling.step(1.0, &Motion::from(creepage())).unwrap();
    rolling
}

#[divan::bench(sample_count = 20)]
fn steady_solution(bencher: Bencher) {
    let exact = Exact::new(&contact(), Resolution::STANDARD).unwrap();
    bencher.bench(|| exact.solve(creepage()));
}

/// A single step of a twentieth of the semi-axis.
#[divan::bench(sample_count = 20)]
fn step_at_a_creepage(bencher: Bencher) {
    let rolling = rolled();
    let motion = Motion::from(creepage());
    bencher.with_inputs(|| rolling.clone()).bench_values(|mut one| one.advance(0.05, &motion));
}

/// The same with a force that is held.
#[divan::bench(sample_count = 20)]
fn step_at_a_force(bencher: Bencher) {
    let mut rolling = rolled();
    let motion = Motion::forces(0.4, 0.1);
    rolling.advance(0.05, &motion).unwrap();
    bencher.with_inputs(|| rolling.clone()).bench_values(|mut one| one.advance(0.05, &motion));
}

#[divan::bench(sample_count = 20)]
fn coefficients_of_a_wave(bencher: Bencher) {
    let harmonic = HarmonicCreepage::new(&contact()).unwrap();
    bencher.bench(|| harmonic.coefficients(4.0));
}
