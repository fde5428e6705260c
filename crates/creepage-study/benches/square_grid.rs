//! Cost of the full theory on a plain grid, to compare with `exact`'s own benchmark.
#![allow(missing_docs, clippy::unwrap_used)]

use creepage::{Contact, Creepage, Ellipse};
use creepage_study::SquareGrid;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// The case of the benchmark `exact` on 40 x 40 equal cells, to the same tolerance.
#[divan::bench(sample_count = 20)]
fn solve(bencher: Bencher) {
    let (sin, cos) = (-30.0_f64).to_radians().sin_cos();
    let creepage = Creepage::new(1.7 * cos, 1.7 * sin, 2.0).unwrap();
    let ellipse = Ellipse::from_ratio(black_box(0.5)).unwrap();
    let grid = SquareGrid::new(&Contact::new(ellipse, black_box(0.28)).unwrap(), 40);
    bencher.bench_local(|| grid.force(black_box(creepage)).unwrap());
}
