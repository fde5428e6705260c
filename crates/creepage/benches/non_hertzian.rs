//! Cost of the full theory on contact areas of any shape.
#![allow(missing_docs, clippy::unwrap_used)]

use creepage::approximate::non_hertzian::{NonHertzianSimplified, Simplified};
use creepage::coulomb::{NonHertzian, Resolution};
use creepage::gap::{Gap, Term};
use creepage::normal::{self, NormalContact};
use creepage::theory::Solved;
use creepage::{Creepage, Solid, SolidPair};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// A crowned roller under 40 kN: `h = x^2/920 + y^4/20000` in millimetres.
fn contact() -> NormalContact {
    let term = |x, y, coefficient| Term { x, y, coefficient };
    let gap = Gap::polynomial(&[term(2, 0, 1e3 / 920.0), term(0, 4, 1e9 / 20_000.0)]).unwrap();
    let steel = Solid::new(82e9, 0.28).unwrap();
    let pair = SolidPair::new(steel, steel);
    NormalContact::under_load(&gap, pair, 40e3, normal::Resolution::STANDARD).unwrap()
}

fn resolution(name: &str) -> Resolution {
    if name == "fast" { Resolution::FAST } else { Resolution::STANDARD }
}

#[divan::bench(args = ["fast", "standard"], sample_count = 20)]
fn prepare(bencher: Bencher, name: &str) {
    let contact = contact();
    bencher.bench_local(|| NonHertzian::new(black_box(&contact), 0.3, resolution(name)).unwrap());
}

#[divan::bench(args = ["fast", "standard"], sample_count = 20)]
fn solve(bencher: Bencher, name: &str) {
    let theory = NonHertzian::new(&contact(), 0.3, resolution(name)).unwrap();
    let creepage = Creepage::new(0.6, -0.3, 1.0).unwrap();
    bencher.bench_local(|| theory.solve(black_box(creepage)).solution());
}

/// FASTSIM on the same pressure, 50 x 50 cells.
#[divan::bench(sample_count = 20)]
fn prepare_fastsim(bencher: Bencher) {
    let contact = contact();
    let cells = [50, 50];
    bencher.bench_local(|| {
        NonHertzianSimplified::new(black_box(&contact), 0.3, Simplified::Fastsim, cells).unwrap()
    });
}

/// Force, and force with its derivatives.
#[divan::bench(args = [false, true], sample_count = 20)]
fn solve_fastsim(bencher: Bencher, with_derivatives: bool) {
    let contact = contact();
    let theory = NonHertzianSimplified::new(&contact, 0.3, Simplified::Fastsim, [50, 50]).unwrap();
    let creepage = Creepage::new(0.6, -0.3, 1.0).unwrap();
    bencher.bench_local(|| {
        let mut solved = theory.solve(black_box(creepage));
        (solved.solution(), with_derivatives.then(|| solved.jacobian()))
    });
}
