//! Cost of a wheelset on its track, on one core: cold, and from the neighbouring position.
#![allow(missing_docs, clippy::unwrap_used)]

use std::path::Path;

use creepage_study::{Stance, WheelsetCase, WheelsetFile};
use divan::Bencher;

fn main() {
    divan::main();
}

/// Lateral shifts: straight track, two areas at the gauge corner, the flange.
const SHIFTS: [f64; 3] = [0.002, 0.0055, 0.0065];
/// From one position to the next (m).
const STEP: f64 = 1e-5;

fn case() -> WheelsetCase {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/wheelset");
    let text = std::fs::read_to_string(examples.join("s1002-on-uic60.toml")).unwrap();
    WheelsetFile::read(&text).unwrap().case(&examples).unwrap()
}

#[divan::bench(args = SHIFTS, sample_count = 10)]
fn cold(bencher: Bencher, y: f64) {
    let case = case();
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    bencher.bench_local(|| solver.solve(&Stance { y, ..case.stance }, &travel).unwrap());
}

#[divan::bench(args = SHIFTS, sample_count = 10)]
fn from_the_neighbour(bencher: Bencher, y: f64) {
    let case = case();
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let before = solver.solve(&Stance { y: y - STEP, ..case.stance }, &travel).unwrap();
    bencher.bench_local(|| solver.next(&before, &Stance { y, ..case.stance }, &travel).unwrap());
}
