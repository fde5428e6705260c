//! Cost of the limiting theories and of the laws in closed form.

use creepage::rolling::linear::CreepageCoefficients;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// Preparation: the coefficients of one shape.
#[divan::bench(args = [1e-3, 0.1, 1.0, 10.0, 1e3])]
fn coefficients(bencher: Bencher<'_, '_>, a_over_b: f64) {
    bencher.bench(|| CreepageCoefficients::new(black_box(a_over_b), black_box(0.28)));
}
