//! Cost of finding the contacts of a wheelset, on one core.

#![allow(clippy::unwrap_used)]

use creepage_rail::{Place, Position, Side, Standard, Track, Wheelset, WheelsetOnTrack};
use divan::Bencher;

fn main() {
    divan::main();
}

fn running() -> WheelsetOnTrack {
    let rail = Standard::Uic60.profile();
    let track = Track::new(&rail, 0.025f64.atan(), Place::gauge(1.435, 0.014)).unwrap();
    Wheelset::like(&Standard::S1002.profile(), 0.46, 1.36).unwrap().on(track)
}

/// Yawed, on the tread and (7 mm) on the flange.
fn pressed(running: &WheelsetOnTrack, y: f64) -> Position {
    let rest = running.resting(y, 0.003, None).unwrap();
    Position { z: rest.z + 40e-6, ..rest }
}

#[divan::bench(args = [0.001, 0.007])]
fn contacts_of_one_wheel(bencher: Bencher, y: f64) {
    let running = running();
    let position = pressed(&running, y);
    bencher.bench(|| running.contacts_of(Side::Right, &position).unwrap().len());
}

#[divan::bench(args = [0.001, 0.007])]
fn touch_of_one_wheel(bencher: Bencher, y: f64) {
    let running = running();
    bencher.bench(|| running.touch(Side::Right, y, 0.0, 0.003).unwrap());
}

#[divan::bench]
fn rest_with_free_roll(bencher: Bencher) {
    let running = running();
    bencher.bench(|| running.resting(0.003, 0.003, None).unwrap());
}

#[divan::bench]
fn section_of_100(bencher: Bencher) {
    let running = running();
    let position = pressed(&running, 0.003);
    let contact = running.contacts_of(Side::Right, &position).unwrap()[0];
    bencher.bench(|| contact.section(100, 0.1));
}

#[divan::bench]
fn row_of_100(bencher: Bencher) {
    let running = running();
    let position = pressed(&running, 0.003);
    let contact = running.contacts_of(Side::Right, &position).unwrap()[0];
    let [low, high] = contact.extent[0];
    let x: Vec<f64> = (0..100).map(|i| low + (high - low) * f64::from(i) / 99.0).collect();
    bencher.bench(|| contact.row(0.0, &x).unwrap());
}
