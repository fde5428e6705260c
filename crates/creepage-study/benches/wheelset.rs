//! Cost of a wheelset on its track, on one core: cold, from the neighbouring position, and along a walk; on the
//! fine grid, and followed on a coarse one.
#![allow(missing_docs, clippy::unwrap_used)]

use std::path::Path;

use creepage_study::{Load, WheelsetCase, WheelsetFile, WheelsetPose, theory_spec};
use divan::Bencher;

fn main() {
    // Unless more are asked for; with two cores both wheels are solved at a time.
    let threads = usize::from(std::env::var_os("RAYON_NUM_THREADS").is_none());
    rayon::ThreadPoolBuilder::new().num_threads(threads).build_global().unwrap();
    divan::main();
}

/// Lateral shifts: straight track, two areas at the gauge corner, the flange.
const SHIFTS: [f64; 3] = [0.002, 0.0055, 0.0065];
/// From one position to the next (m).
const STEP: f64 = 1e-5;

/// By the full theory, or by `fastsim` on the same pressure.
const THEORIES: [&str; 2] = ["exact", "fastsim"];

fn case(theory: &str) -> WheelsetCase {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/wheelset");
    let text = std::fs::read_to_string(examples.join("s1002-on-uic60.toml")).unwrap();
    let text = format!("{text}\n[solve]\ntheory = \"{theory}\"\n");
    WheelsetFile::read(&text).unwrap().case(&examples).unwrap()
}

fn cases() -> impl Iterator<Item = (&'static str, f64)> {
    THEORIES.into_iter().flat_map(|theory| SHIFTS.map(|y| (theory, y)))
}

#[divan::bench(args = cases(), sample_count = 10)]
fn cold(bencher: Bencher, (theory, y): (&str, f64)) {
    let case = case(theory);
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    bencher.bench_local(|| solver.solve(&WheelsetPose { y, ..case.stance }, &travel).unwrap());
}

/// From nothing under 10 kN a wheel on the fast grid, as far as the flange.
#[divan::bench(args = [0.0, 0.002, 0.005, 0.0055, 0.0065], sample_count = 20)]
fn cold_and_light_on_the_fast_grid(bencher: Bencher, y: f64) {
    let theory = theory_spec("exact", &["resolution=fast"]).unwrap();
    let case = WheelsetCase { theory, ..case("exact") };
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let pose = WheelsetPose { y, load: Some(Load::Axle(20e3)), ..case.stance };
    bencher.bench_local(|| solver.solve(&pose, &travel).unwrap());
}

#[divan::bench(args = cases(), sample_count = 10)]
fn from_the_neighbour(bencher: Bencher, (theory, y): (&str, f64)) {
    let case = case(theory);
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let before = solver.solve(&WheelsetPose { y: y - STEP, ..case.stance }, &travel).unwrap();
    bencher
        .bench_local(|| solver.next(&before, &WheelsetPose { y, ..case.stance }, &travel).unwrap());
}

/// From a neighbour that was found from a neighbour of its own.
#[divan::bench(args = cases(), sample_count = 10)]
fn along_a_walk(bencher: Bencher, (theory, y): (&str, f64)) {
    let case = case(theory);
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let at = |steps: f64| WheelsetPose { y: y - steps * STEP, ..case.stance };
    let before = solver.solve(&at(2.0), &travel).unwrap();
    let before = solver.next(&before, &at(1.0), &travel).unwrap();
    bencher.bench_local(|| solver.next(&before, &at(0.0), &travel).unwrap());
}

/// Followed from a neighbour that was solved by itself, and from one that was followed.
#[divan::bench(args = SHIFTS, sample_count = 10)]
fn followed(bencher: Bencher, y: f64) {
    let case = case("exact");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let before = solver.solve(&WheelsetPose { y: y - STEP, ..case.stance }, &travel).unwrap();
    bencher.bench_local(|| {
        solver.follow(&before, &WheelsetPose { y, ..case.stance }, &travel).unwrap()
    });
}

#[divan::bench(args = SHIFTS, sample_count = 10)]
fn followed_along_a_walk(bencher: Bencher, y: f64) {
    let case = case("exact");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let at = |steps: f64| WheelsetPose { y: y - steps * STEP, ..case.stance };
    let before = solver.solve(&at(2.0), &travel).unwrap();
    let before = solver.follow(&before, &at(1.0), &travel).unwrap();
    bencher.bench_local(|| solver.follow(&before, &at(0.0), &travel).unwrap());
}

/// A walk from 0 to 8 mm on the fine grid, and followed.
#[divan::bench(args = ["fine grid", "followed"], sample_count = 1)]
fn a_whole_walk(bencher: Bencher, how: &str) {
    let case = case("exact");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    bencher.bench_local(|| {
        let mut walked = solver.solve(&WheelsetPose { y: 0.0, ..case.stance }, &travel).unwrap();
        for step in 1..=800 {
            let stance = WheelsetPose { y: STEP * f64::from(step), ..case.stance };
            let next = match how {
                "followed" => solver.follow(&walked, &stance, &travel),
                _ => solver.next(&walked, &stance, &travel),
            };
            walked = next.unwrap();
        }
    });
}
