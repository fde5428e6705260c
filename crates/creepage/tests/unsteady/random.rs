//! Random histories: smooth, with jumps, reversals, loads that go to zero and back.
//! `CREEPAGE_RANDOM_HISTORIES=1000` asks for more.

use creepage::Status;
use creepage::unsteady::{Motion, Prescribed, Rolling};

use super::support::{coarse, contact};

/// A simple generator (Marsaglia's xorshift), so that a case that fails can be had again.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn signed(&mut self, size: f64) -> f64 {
        self.between(-size, size)
    }
}

/// One history; what went wrong.
fn history(seed: u64) -> Option<String> {
    let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
    let contact = contact(random.between(-1.0, 1.0).exp2(), random.between(0.0, 0.5));
    let mut rolling = Rolling::new(&contact, coarse()).unwrap();
    if random.next() < 0.3 {
        rolling.shift(random.signed(0.6), random.signed(0.6)).unwrap();
    }
    let (mut load, mut creep) = (1.0, [0.0; 3]);
    for row in 0..6 {
        let jumps = random.next() < 0.3;
        for component in &mut creep {
            *component = if jumps { random.signed(2.0) } else { *component + random.signed(0.2) };
        }
        load = match random.next() {
            chance if chance < 0.1 => 0.0,
            chance if chance < 0.4 => random.between(0.02, 2.0),
            chance if chance < 0.7 => (load * random.between(0.95, 1.05)).max(0.02),
            _ => load,
        };
        rolling.press(load).unwrap();
        let mut motion = motion(creep);
        if load > 0.0 && random.next() < 0.3 {
            motion.longitudinal = Prescribed::Force(load * random.signed(0.8));
        }
        let length = random.between(-5.0, 1.0).exp();
        let rolled = rolling.step(length, &motion).unwrap();
        let force = rolled.solution.force;
        // The force of each grid is within friction; extrapolation goes beyond by less than the error bar.
        let bar = rolled.solution.error.map_or(0.0, |error| error.magnitude());
        let sound = rolled.solution.status == Status::Solved
            && force.magnitude() <= load + bar + 1e-9
            && force.mz.is_finite()
            && rolled.dissipation >= 0.0
            && (0.0..=1.0).contains(&rolled.adhesion_share);
        if !sound {
            return Some(format!(
                "{seed} row {row}: {motion:?} load {load} length {length} {rolled:?}"
            ));
        }
    }
    None
}

fn motion([xi, eta, chi]: [f64; 3]) -> Motion {
    let [longitudinal, lateral, spin] = [xi, eta, chi].map(Prescribed::Creepage);
    Motion { longitudinal, lateral, spin }
}

#[test]
fn every_random_history_is_solved() {
    let count = std::env::var("CREEPAGE_RANDOM_HISTORIES").ok().and_then(|n| n.parse().ok());
    let count: u64 = count.unwrap_or(50);
    let wrong: Vec<String> = (1..=count).filter_map(history).collect();
    assert!(wrong.is_empty(), "{} of {count}:\n{}", wrong.len(), wrong.join("\n"));
}
