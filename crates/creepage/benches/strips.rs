//! Time of one solution: strip theory, FASTSIM and FaStrip.

#![allow(clippy::unwrap_used)] // the inputs are constants

use creepage::approximate::fastrip::{Fastrip, Variant};
use creepage::approximate::fastsim::{Fastsim, Settings};
use creepage::approximate::linear::CreepageCoefficients;
use creepage::approximate::strip::StripTheory;
use creepage::{Creepage, Theory};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// Circle, Poisson's ratio 0.25.
const COEFFICIENTS: CreepageCoefficients =
    CreepageCoefficients { c11: 4.1128, c22: 3.6683, c23: 1.4661, c32: -1.4661, c33: 1.1843 };

/// Longitudinal, lateral and spin; pure longitudinal; small; with the spin pole inside.
const CREEPAGES: [Creepage; 4] = [
    Creepage { xi: 0.5, eta: 0.3, chi: 0.5 },
    Creepage { xi: 0.7, eta: 0.0, chi: 0.0 },
    Creepage { xi: 0.01, eta: 0.02, chi: 0.01 },
    Creepage { xi: 0.5, eta: -0.8, chi: 2.0 },
];

fn solve(bencher: Bencher, theory: &impl Theory, case: usize) {
    bencher.bench_local(|| theory.solve(black_box(CREEPAGES[case])));
}

#[divan::bench(args = [0, 1, 2, 3])]
fn strip_theory(bencher: Bencher, case: usize) {
    solve(bencher, &StripTheory::new(1.0, 0.25).unwrap(), case);
}

fn fastsim(n: usize) -> Fastsim {
    let settings = Settings { grid: [n, n], ..Settings::default() };
    Fastsim::new(1.0, 0.25, &COEFFICIENTS, settings).unwrap()
}

#[divan::bench(args = [10, 50])]
fn fastsim_of_size(bencher: Bencher, n: usize) {
    solve(bencher, &fastsim(n), 0);
}

#[divan::bench(args = [10, 50])]
fn fastsim_derivative(bencher: Bencher, n: usize) {
    let theory = fastsim(n);
    bencher.bench_local(|| theory.derivative(black_box(CREEPAGES[0])));
}

#[divan::bench(args = [10, 50])]
fn fastrip_of_size(bencher: Bencher, n: usize) {
    let theory = Fastrip::new(1.0, 0.25, &COEFFICIENTS, Variant::default(), [n, n]).unwrap();
    solve(bencher, &theory, 0);
}
