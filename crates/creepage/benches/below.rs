//! Cost of stresses inside the bodies, and of the numbers made from forces.
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout)]

use creepage::coulomb::{Exact, Resolution};
use creepage::damage::{ShakedownBlock, TGamma, Usfd, Wlrm, shakedown, surface_index};
use creepage::subsurface::{Body, Element, Grid, Interior, Stress};
use creepage::{Creepage, Ellipse, Hertz, Solid, SolidPair, Theory};
use creepage::{SiCreepage, SiForce};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

fn hertz() -> Interior {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let ellipse = Ellipse::new(6e-3, 4e-3).unwrap();
    let contact = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3).unwrap();
    Interior::sliding(&contact, [0.3, 0.0], steel, Body::Lower).unwrap()
}

/// 20 by 15 rectangles, every one with its own traction.
fn elements() -> Interior {
    let rectangle = |k: u32| {
        let middle = [f64::from(k % 20) - 9.5, f64::from(k / 20) - 7.0];
        let traction = [0.3, 0.1, 1.0].map(|t| t * (1.0 + (f64::from(k) * 0.7).sin()));
        Element::rectangle(middle, [1.0, 1.0], traction).unwrap()
    };
    let elements: Vec<_> = (0..300).map(rectangle).collect();
    Interior::new(Solid::new(82e9, 0.28).unwrap(), Body::Lower).with_elements(&elements)
}

fn sum(interior: &Interior, unit: f64) -> f64 {
    let at =
        |k: u32| [f64::from(k % 10) - 4.5, f64::from(k / 10 % 10) - 4.5, f64::from(1 + k / 100)];
    let stress = |k| interior.stress(at(k).map(|x| unit * x)).unwrap_or_default();
    (0..1000).map(|k| stress(k).xx).sum()
}

/// What the standard resolution makes of a rolling contact.
fn rolling() -> Interior {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let ellipse = Ellipse::new(6e-3, 4e-3).unwrap();
    let hertz = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3).unwrap();
    let contact = hertz.with_friction(0.3).unwrap();
    let theory = Exact::new(&contact, Resolution::STANDARD).unwrap();
    let solved = theory.solved(Creepage::new(0.5, 0.2, 0.3).unwrap());
    println!("{} elements", solved.patches().unwrap_or_default().len());
    Interior::rolling(&hertz, &contact, &*solved, steel, Body::Lower).unwrap()
}

/// Ten planes of 10 x 10 points from .6 to 8 mm below a rolling contact.
fn below_rolling() -> Vec<[f64; 3]> {
    let at =
        |k: u32| [f64::from(k % 10) - 4.5, f64::from(k / 10 % 10) - 4.5, f64::from(k / 100) + 0.75];
    (0..1000).map(|k| at(k).map(|x| 8e-4 * x)).collect()
}

/// Stresses and displacements at 1,000 points below a rolling contact, element by element.
#[divan::bench(sample_count = 3, sample_size = 1)]
fn rolling_element_by_element(bencher: Bencher) {
    let (interior, points) = (rolling(), below_rolling());
    let at = |point: &[f64; 3]| {
        (interior.stress(*point).unwrap(), interior.displacement(*point).unwrap())
    };
    bencher.bench_local(|| black_box(&points).iter().map(at).collect::<Vec<_>>());
}

/// The same, elements far from a point taken together.
#[divan::bench(sample_count = 20, sample_size = 1)]
fn rolling_together(bencher: Bencher) {
    let (interior, points) = (rolling(), below_rolling());
    let at = |point: &[f64; 3]| interior.at(*point).unwrap();
    bencher.bench_local(|| black_box(&points).iter().map(at).collect::<Vec<_>>());
}

/// The same on all cores.
#[divan::bench(sample_count = 20, sample_size = 1)]
fn rolling_on_all_cores(bencher: Bencher) {
    let (interior, points) = (rolling(), below_rolling());
    bencher.bench_local(|| interior.at_all(black_box(&points)).unwrap());
}

/// The pressure's part of it, in closed form.
#[divan::bench(sample_count = 20, sample_size = 1)]
fn hertz_pressure_together(bencher: Bencher) {
    let (interior, points) = (hertz(), below_rolling());
    let at = |point: &[f64; 3]| interior.at(*point).unwrap();
    bencher.bench_local(|| black_box(&points).iter().map(at).collect::<Vec<_>>());
}

/// Preparing the elements of a rolling contact.
#[divan::bench(sample_count = 10, sample_size = 1)]
fn prepare_rolling(bencher: Bencher) {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let ellipse = Ellipse::new(6e-3, 4e-3).unwrap();
    let hertz = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3).unwrap();
    let contact = hertz.with_friction(0.3).unwrap();
    let theory = Exact::new(&contact, Resolution::STANDARD).unwrap();
    let solved = theory.solved(Creepage::new(0.5, 0.2, 0.3).unwrap());
    bencher
        .bench_local(|| Interior::rolling(&hertz, &contact, &*solved, steel, Body::Lower).unwrap());
}

/// 1,000 points below 300 elements.
#[divan::bench(sample_count = 20)]
fn thousand_points_below_300_elements(bencher: Bencher) {
    let interior = elements();
    bencher.bench_local(|| sum(black_box(&interior), 1.0));
}

/// 1,000 points below a polynomial traction.
#[divan::bench(sample_count = 20)]
fn thousand_points_below_a_polynomial(bencher: Bencher) {
    let interior = hertz();
    bencher.bench_local(|| sum(black_box(&interior), 8e-4));
}

/// 64 planes of 64 x 64 points below as many rectangles.
#[divan::bench(sample_count = 3, sample_size = 1)]
fn block_of_64(bencher: Bencher) {
    let grid = Grid::new([64, 64], [1.0, 1.0], 0.28, Body::Lower).unwrap();
    let traction = |k: u32| [0.3, 0.1, 1.0].map(|t| t * (1.0 + (f64::from(k) * 0.7).sin()));
    let tractions: Vec<_> = (0..64 * 64).map(traction).collect();
    let load = grid.load(&tractions).unwrap();
    bencher.bench_local(|| -> Vec<Vec<Stress>> {
        (0..64).map(|k| load.stress(black_box(0.5 + f64::from(k))).unwrap()).collect()
    });
}

/// T gamma, wear, cracks and the surface index from the forces of a contact.
#[divan::bench]
fn numbers_from_forces() -> [f64; 4] {
    let force = SiForce { longitudinal: -10e3, lateral: 5e3, moment: 10.0 };
    let creepage = SiCreepage { longitudinal: -2e-3, lateral: 1e-3, spin: 0.1 };
    let work = TGamma::new(black_box(force), black_box(creepage));
    [
        work.with_spin,
        Usfd::default().rate(work.with_spin / 75e-6),
        Wlrm::default().directed_damage(work.with_spin, force.longitudinal),
        surface_index(11e3, black_box(80e3), 1.6e9, 300e6),
    ]
}

/// Melan's bound at the usual fineness.
#[divan::bench(sample_count = 3, sample_size = 1)]
fn shakedown_limit(bencher: Bencher) {
    let interior = hertz();
    let block = ShakedownBlock::of([6e-3, 4e-3]);
    bencher.bench_local(|| shakedown(black_box(&interior), &block).unwrap());
}
