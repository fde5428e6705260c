//! Cost of normal contact of any shape. `cargo bench --bench normal`
#![allow(missing_docs, clippy::unwrap_used)]

use creepage::gap::{Gap, Rectangle, Rolling, Term};
use creepage::normal::{NormalContact, Resolution};
use creepage::{Solid, SolidPair};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

fn steel() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

/// Shapes by name, with an approach (m): a smooth ellipse, a ring, a crowned roller, two bumps, a
/// flange contact of 15:1.
fn shape(name: &str) -> (Gap, f64) {
    let term = |x, y, coefficient| Term { x, y, coefficient };
    match name {
        "ellipse" => {
            (Gap::polynomial(&[term(2, 0, 0.5 / 0.46), term(0, 2, 0.5 / 0.3)]).unwrap(), 50e-6)
        }
        // h = 1e5 (r^2 - 9 mm^2)^2 - 8.1 um
        "ring" => {
            let quartic = [term(4, 0, 1e5), term(2, 2, 2e5), term(0, 4, 1e5)];
            let dip = [term(2, 0, -1.8), term(0, 2, -1.8)];
            (Gap::polynomial(&[quartic.as_slice(), &dip].concat()).unwrap(), 20e-6)
        }
        "crowned" => (Gap::polynomial(&[term(2, 0, 0.5 / 0.46), term(0, 4, 5e4)]).unwrap(), 50e-6),
        "flange" => {
            (Gap::polynomial(&[term(2, 0, 0.5 / 0.46), term(0, 2, 0.5 / 4e-3)]).unwrap(), 30e-6)
        }
        _ => {
            let bump = |x: f64, y: f64| (x * x + y * y) / 0.4;
            let domain = Rectangle { x: [-8e-3, 8e-3], y: [-4e-3, 4e-3] };
            let gap = Gap::function(domain, move |x, y| bump(x + 3e-3, y).min(bump(x - 3e-3, y)));
            (gap.unwrap(), 20e-6)
        }
    }
}

const SHAPES: [&str; 4] = ["ellipse", "crowned", "two bumps", "flange"];

fn at(bencher: Bencher, name: &str, resolution: Resolution) {
    let (gap, approach) = shape(name);
    bencher.bench_local(|| {
        NormalContact::at_approach(black_box(&gap), steel(), approach, resolution).unwrap()
    });
}

#[divan::bench(args = SHAPES, sample_count = 20)]
fn fast(bencher: Bencher, name: &str) {
    at(bencher, name, Resolution::FAST);
}

#[divan::bench(args = SHAPES, sample_count = 20)]
fn standard(bencher: Bencher, name: &str) {
    at(bencher, name, Resolution::STANDARD);
}

#[divan::bench(args = SHAPES, sample_count = 10)]
fn standard_under_load(bencher: Bencher, name: &str) {
    let (gap, _) = shape(name);
    bencher.bench_local(|| {
        NormalContact::under_load(black_box(&gap), steel(), 1e4, Resolution::STANDARD).unwrap()
    });
}

/// Growth with the number of strips.
#[divan::bench(args = [8, 16, 32, 64], sample_count = 5)]
fn strips(bencher: Bencher, count: usize) {
    at(bencher, "ellipse", Resolution::new(count).unwrap());
}

/// Growth with the number of elements, on a ring, which strips do not describe: 1.4 times the square of
/// what is asked for.
#[divan::bench(args = [10, 20, 40, 80, 120], sample_count = 5)]
fn elements(bencher: Bencher, count: usize) {
    at(bencher, "ring", Resolution::new(count).unwrap());
}

/// What a section of 200 points costs to prepare.
#[divan::bench(sample_count = 20)]
fn prepare_section(bencher: Bencher) {
    let y: Vec<f64> = (0..200).map(|i| f64::from(i) * 1e-4 - 1e-2).collect();
    let h: Vec<f64> = y.iter().map(|y| y * y / 0.6).collect();
    bencher
        .bench_local(|| Gap::section(black_box(&y), black_box(&h), Rolling::Radius(0.46)).unwrap());
}
