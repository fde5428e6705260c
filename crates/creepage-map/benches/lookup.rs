//! Cost of a contact map: of one wheel in a given position and motion, with derivatives of both, and of a wheelset
//! that finds height, roll and pitch rate. The map is one of made-up contacts, or one of `creepage map` whose file
//! `CREEPAGE_MAP` names. States lie all over the map; the figures are those of a thousand.
#![allow(missing_docs, clippy::unwrap_used, unreachable_pub)]

#[path = "../tests/common/mod.rs"]
mod common;

use creepage_map::{ContactMap, HeightOrLoad, Side, State};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

fn map() -> ContactMap {
    match std::env::var_os("CREEPAGE_MAP") {
        Some(path) => ContactMap::from_bytes(std::fs::read(path).unwrap()).unwrap(),
        None => common::map(),
    }
}

/// A thousand states that the map has, under their load.
fn states(map: &ContactMap) -> Vec<State> {
    let own = State { speed: 20.0, yaw: 0.0, roll: None, pitch_rate: None, ..map.head().own };
    let load = match own.pressed {
        HeightOrLoad::AxleLoad(load) => load,
        HeightOrLoad::Height(_) => 90e3,
    };
    let [_, high] = map.wheel(Side::Right).range();
    let part = |k: u32, times: f64| 2.0 * (times * f64::from(k)).fract() - 1.0;
    let state = |k: u32| State {
        y: high.min(5e-3) * part(k, 0.618_034),
        yaw: 0.5 * map.head().yaw * part(k, 0.414_214),
        pressed: HeightOrLoad::AxleLoad(load * (1.0 + 0.2 * part(k, 0.732_051))),
        ..own
    };
    (0..100_000).map(state).filter(|state| map.solve(state).is_ok()).take(1000).collect()
}

/// The same with what was found given.
fn given(map: &ContactMap, states: &[State]) -> Vec<State> {
    let give = |state: &State| {
        let found = map.solve(state).unwrap();
        let (z, roll, pitch_rate) = (found.z, Some(found.roll), Some(found.pitch_rate));
        State { pressed: HeightOrLoad::Height(z), roll, pitch_rate, ..*state }
    };
    states.iter().map(give).collect()
}

#[divan::bench]
fn a_wheel(bencher: Bencher) {
    let map = map();
    let states = given(&map, &states(&map));
    let one = |state: &State| map.solve_wheel(Side::Right, black_box(state)).unwrap().force[1];
    bencher.bench_local(|| states.iter().map(one).sum::<f64>());
}

#[divan::bench]
fn a_wheelset(bencher: Bencher) {
    let map = map();
    let states = given(&map, &states(&map));
    bencher.bench_local(|| states.iter().map(|s| map.solve(black_box(s)).unwrap().z).sum::<f64>());
}

#[divan::bench]
fn a_wheelset_with_derivatives(bencher: Bencher) {
    let map = map();
    let states = given(&map, &states(&map));
    let one = |s: &State| map.solve_with_derivatives(black_box(s)).unwrap().1[0][0][0];
    bencher.bench_local(|| states.iter().map(one).sum::<f64>());
}

#[divan::bench]
fn a_wheelset_under_its_load(bencher: Bencher) {
    let map = map();
    let states = states(&map);
    bencher.bench_local(|| states.iter().map(|s| map.solve(black_box(s)).unwrap().z).sum::<f64>());
}
