//! Cost of the numerical theory of chapter 5.
#![allow(missing_docs, clippy::unwrap_used)]

use creepage::Creepage;
use creepage::variational::{Settings, Start, Variational, VariationalSolution};
use divan::{Bencher, black_box};

#[path = "../tests/common/mod.rs"]
mod common;
use common::contact;

fn main() {
    divan::main();
}

/// Fig. 12: a/b = 0.5, sigma = 0.28, spin 2, creepage of the given size at -30 degrees.
fn figure_12(size: f64) -> Creepage {
    let (sin, cos) = (-30.0_f64).to_radians().sin_cos();
    Creepage::new(size * cos, size * sin, 2.0).unwrap()
}

#[divan::bench(args = [3, 4, 8])]
fn prepare(degree: usize) -> Variational {
    Variational::new(&contact(black_box(0.5), black_box(0.28)), Settings::of_degree(degree))
        .unwrap()
}

#[divan::bench(args = [2, 3, 4, 8])]
fn solve_from_full_sliding(bencher: Bencher, degree: usize) {
    let theory = prepare(degree);
    let creepage = figure_12(1.7);
    bencher.bench_local(|| -> VariationalSolution {
        theory.solve_from(black_box(creepage), &Start::FullSliding)
    });
}

#[divan::bench(args = [2, 3, 4, 8])]
fn solve_in_a_chain(bencher: Bencher, degree: usize) {
    let theory = prepare(degree);
    let previous = theory.solve_from(figure_12(2.0), &Start::FullSliding).tau;
    let creepage = figure_12(1.7);
    bencher.bench_local(|| -> VariationalSolution {
        theory.solve_from(black_box(creepage), &Start::From(&previous))
    });
}
