//! Error bars on areas of any shape, against three times as many strips and a finer rolling grid:
//! how often they cover, and how wide they are. `CREEPAGE_RANDOM_BARS=200` asks for more gaps,
//! `CREEPAGE_BARS_FROM` for others.

use creepage::coulomb::{self, NonHertzian};
use creepage::normal::{Estimate, NormalContact, Resolution};
use creepage::theory::{Solved, Status};
use creepage::{Creepage, Force, SiCreepage};

use crate::random::random_gap;
use crate::support::{Sequence, steel};

const FRICTION: f64 = 0.3;

/// Bar over error of many numbers of one kind.
struct Ratios {
    name: &'static str,
    values: Vec<(f64, u64)>,
}

impl Ratios {
    fn new(name: &'static str) -> Self {
        Self { name, values: Vec::new() }
    }

    fn push(&mut self, seed: u64, bar: f64, error: f64) {
        self.values.push((bar / error.abs().max(1e-12), seed));
    }

    /// The share of errors that their bars cover; printed with the median of bar over error and the
    /// seeds of the worst.
    fn covered(&mut self) -> f64 {
        self.values.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        let count = self.values.len();
        let share =
            self.values.iter().filter(|(ratio, _)| *ratio >= 1.0).count() as f64 / count as f64;
        let worst = &self.values[..count.min(6)];
        let median = self.values[count / 2].0;
        println!(
            "{:10} {count:4} covered {share:.3} median {median:6.2} worst {worst:.2?}",
            self.name
        );
        share
    }
}

fn number(variable: &str, usual: u64) -> u64 {
    std::env::var(variable).ok().and_then(|n| n.parse().ok()).unwrap_or(usual)
}

#[test]
fn error_bars_cover() {
    let (from, count) = (number("CREEPAGE_BARS_FROM", 0), number("CREEPAGE_RANDOM_BARS", 12));
    let names = ["load", "peak", "area", "force", "fx", "fy", "mz"];
    let mut ratios = names.map(Ratios::new);
    for seed in from..from + count {
        // Other gaps than those of the random series.
        let mut sequence = Sequence(!seed.wrapping_mul(0x1234_5678_9ABC_DEF1));
        let gap = random_gap(&mut sequence);
        let approach = 1e-6 * 10.0_f64.powf(sequence.between(0.0, 2.0));
        let at = |resolution| NormalContact::at_approach(&gap, steel(), approach, resolution);
        let finest = Resolution::new(60).unwrap();
        let (Ok(contact), Ok(fine)) = (at(Resolution::STANDARD), at(finest)) else { continue };
        let numbers = |c: &NormalContact| [c.load(), c.peak_pressure(), c.area()];
        for (k, (found, best)) in numbers(&contact).into_iter().zip(numbers(&fine)).enumerate() {
            let Estimate { value, error } = found;
            ratios[k].push(seed, error, value - best.value);
        }
        let Ok(between) = at(Resolution::FINE) else { continue };
        let unit = between.scaling(FRICTION).unwrap();
        let [xi, eta, chi] = [(); 3].map(|()| sequence.between(-1.0, 1.0));
        let creepage = unit.si_creepage(Creepage::new(xi, eta, chi).unwrap());
        let rolled = |contact, resolution| rolled(contact, resolution, creepage, unit.length);
        let Some((found, bar)) = rolled(&between, coulomb::Resolution::STANDARD) else { continue };
        let Some((best, _)) = rolled(&fine, coulomb::Resolution::FINE) else { continue };
        let errors: Vec<f64> = (0..3).map(|k| found[k] - best[k]).collect();
        ratios[3].push(seed, bar[0].hypot(bar[1]), errors[0].hypot(errors[1]));
        for k in 0..3 {
            ratios[4 + k].push(seed, bar[k], errors[k]);
        }
    }
    for ratios in &mut ratios {
        let (name, share) = (ratios.name, ratios.covered());
        assert!(share >= 0.75, "{name} {share}");
    }
}

/// Forces and their bars over `mu N`, moments over that times a length.
fn rolled(
    contact: &NormalContact,
    resolution: coulomb::Resolution,
    creepage: SiCreepage,
    length: f64,
) -> Option<([f64; 3], [f64; 3])> {
    let theory = NonHertzian::new(contact, FRICTION, resolution).unwrap();
    let unit = theory.scaling();
    let solution = theory.solve(unit.creepage(creepage).unwrap()).solution();
    let parts = |Force { fx, fy, mz }: Force| [fx, fy, mz * unit.length / length];
    let solved = solution.status == Status::Solved;
    solved.then(|| (parts(solution.force), parts(solution.error.unwrap_or_default())))
}
