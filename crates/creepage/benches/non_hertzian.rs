//! Cost of the full theory on contact areas of any shape.
#![allow(missing_docs, clippy::unwrap_used)]

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
