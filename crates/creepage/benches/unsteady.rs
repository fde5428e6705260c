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

/// A step of an even march in which the creepage, or the force, swings.
fn march(motion: impl Fn(f64) -> Motion) -> Rolling {
    const STEPS: i32 = 20;
    let mut rolling = Rolling::new(&contact(), Resolution::STANDARD).unwrap();
    rolling.start_steady(&motion(0.0)).unwrap();
    for k in 1..=STEPS {
        rolling.advance(0.05, &motion(0.05 * f64::from(k))).unwrap();
    }
    rolling
}

/// 20 such steps at a creepage, from preparation on.
#[divan::bench(sample_count = 5, sample_size = 1)]
fn march_of_20_steps_at_a_creepage(bencher: Bencher) {
    let creepage = |q: f64| Creepage::new(0.5 + 0.3 * (2.0 * q).sin(), 0.2, 0.3).unwrap();
    bencher.bench(|| march(|q| Motion::from(creepage(q))));
}

/// 20 such steps at a force.
#[divan::bench(sample_count = 5, sample_size = 1)]
fn march_of_20_steps_at_a_force(bencher: Bencher) {
    bencher.bench(|| march(|q| Motion::forces(0.4 + 0.2 * (2.0 * q).sin(), 0.1)));
}

/// What is prepared once.
#[divan::bench(sample_count = 10, sample_size = 1)]
fn prepare(bencher: Bencher) {
    bencher.bench(|| Rolling::new(&contact(), Resolution::STANDARD).unwrap());
}

#[divan::bench(sample_count = 20)]
fn coefficients_of_a_wave(bencher: Bencher) {
    let harmonic = HarmonicCreepage::new(&contact()).unwrap();
    bencher.bench(|| harmonic.coefficients(4.0));
}
