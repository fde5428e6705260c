//! Time of one solution: strip theory, FASTSIM and FaStrip.

#![allow(clippy::unwrap_used)] // the inputs are constants

use creepage::Theory;
use creepage::approximate::fastrip::{Fastrip, Variant};
use creepage::approximate::fastsim::{Fastsim, Settings};
use creepage::approximate::strip::StripTheory;
use divan::{Bencher, black_box};

#[path = "../tests/common/mod.rs"]
mod common;
use common::{at, contact};

fn main() {
    divan::main();
}

/// Longitudinal, lateral and spin; pure longitudinal; small; with the spin pole inside.
const CREEPAGES: [[f64; 3]; 4] =
    [[0.5, 0.3, 0.5], [0.7, 0.0, 0.0], [0.01, 0.02, 0.01], [0.5, -0.8, 2.0]];

fn solve(bencher: Bencher, theory: &impl Theory, case: usize) {
    let creepage = at(CREEPAGES[case]);
    bencher.bench_local(|| theory.solve(black_box(creepage)));
}

#[divan::bench(args = [0, 1, 2, 3])]
fn strip_theory(bencher: Bencher, case: usize) {
    solve(bencher, &StripTheory::new(&contact(1.0, 0.25)), case);
}

fn fastsim(n: usize) -> Fastsim {
    let settings = Settings { grid: [n, n], ..Settings::default() };
    Fastsim::new(&contact(1.0, 0.25), settings).unwrap()
}

#[divan::bench(args = [10, 50])]
fn fastsim_of_size(bencher: Bencher, n: usize) {
    solve(bencher, &fastsim(n), 0);
}

#[divan::bench(args = [10, 50])]
fn fastsim_derivative(bencher: Bencher, n: usize) {
    let theory = fastsim(n);
    let creepage = at(CREEPAGES[0]);
    bencher.bench_local(|| theory.jacobian(black_box(creepage)));
}

#[divan::bench(args = [10, 50])]
fn fastrip_of_size(bencher: Bencher, n: usize) {
    let theory = Fastrip::new(&contact(1.0, 0.25), Variant::default(), [n, n]).unwrap();
    solve(bencher, &theory, 0);
}
