//! Random ellipses by the road of any shape, against `exact` on Hertz's ellipse: forces within the
//! sum of the error bars. `CREEPAGE_RANDOM_ELLIPSES=200` asks for more; the largest difference over that
//! sum is printed, and the worst time.
// Tests may fail by unwrapping.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

mod common;

use std::time::Instant;

use common::creepage;
use creepage::coulomb::{Exact, NonHertzian, Resolution};
use creepage::gap::{Gap, Term};
use creepage::normal::{self, NormalContact};
use creepage::theory::{Solved, Status};
use creepage::{Creepage, Force, Hertz, Radii, Solid, SolidPair, Theory};

const FRICTION: f64 = 0.3;
const LOAD: f64 = 50e3;
const ROLLING_RADIUS: f64 = 0.4;

/// Numbers that look random, the same in every run (splitmix64).
struct Sequence(u64);

impl Sequence {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        low + (high - low) * ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// By both roads: the largest difference of a force component over the sum of its error bars.
fn apart(lateral: f64, at: Creepage) -> f64 {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let pair = SolidPair::new(steel, steel);
    let flat = f64::INFINITY;
    let upper = Radii { rolling: ROLLING_RADIUS, lateral: flat };
    let hertz = Hertz::new(pair, upper, Radii { rolling: flat, lateral }, 0.0, LOAD).unwrap();
    let contact = hertz.with_friction(FRICTION).unwrap();
    let there = Exact::new(&contact, Resolution::STANDARD).unwrap().solve(at);
    let term = |x, y, radius: f64| Term { x, y, coefficient: 0.5 / radius };
    let gap = Gap::polynomial(&[term(2, 0, ROLLING_RADIUS), term(0, 2, lateral)]).unwrap();
    let normal = NormalContact::under_load(&gap, pair, LOAD, normal::Resolution::FINE).unwrap();
    let theory = NonHertzian::new(&normal, FRICTION, Resolution::STANDARD).unwrap();
    let (one, other) = (contact.scaling(), theory.scaling());
    let here = theory.solve(other.creepage(one.si_creepage(at)).unwrap()).solution();
    assert_eq!([here.status, there.status], [Status::Solved; 2], "{lateral} {at:?}");
    let moment = other.length / one.length;
    let unit = |Force { fx, fy, mz }: Force| [fx, fy, mz * moment];
    let (found, bar) = (unit(here.force), unit(here.error.unwrap()));
    let (expected, other_bar) = (there.force.components(), there.error.unwrap().components());
    (0..3).map(|k| (found[k] - expected[k]).abs() / (bar[k] + other_bar[k])).fold(0.0, f64::max)
}

/// Ratios of semi-axes from 1/5 to 5, and creepage and spin up to saturation.
#[test]
fn random_ellipses_are_hertzs_case() {
    let count = std::env::var("CREEPAGE_RANDOM_ELLIPSES").ok().and_then(|n| n.parse().ok());
    let count: u64 = count.unwrap_or(12);
    let (mut most, mut slowest, mut beyond) = (0.0_f64, 0.0_f64, Vec::new());
    for seed in 0..count {
        let mut sequence = Sequence(seed);
        // The axes' ratio goes about as the radii's to the power 2/3.
        let lateral = ROLLING_RADIUS * 5.0_f64.powf(1.5 * sequence.between(-1.0, 1.0));
        let [xi, eta] = [sequence.between(-2.0, 2.0), sequence.between(-2.0, 2.0)];
        let at = creepage(xi, eta, sequence.between(-2.0, 2.0));
        let start = Instant::now();
        let apart = apart(lateral, at);
        slowest = slowest.max(start.elapsed().as_secs_f64());
        most = most.max(apart);
        if apart > 1.0 {
            beyond.push((seed, lateral, at, apart));
        }
    }
    println!("{count} ellipses, at most {most:.2} of the error bars apart, worst {slowest:.3} s");
    assert!(beyond.is_empty(), "{} beyond: {beyond:?}", beyond.len());
}
