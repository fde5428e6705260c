//! Error bars on areas of any shape, against three times as many strips and a finer rolling grid:
//! how often they cover, and how wide they are. `CREEPAGE_RANDOM_BARS=200` asks for more gaps,
//! `CREEPAGE_BARS_FROM` for others.

use creepage::coulomb::{self, NonHertzian};
use creepage::normal::{NormalContact, Resolution};
use creepage::theory::{Solved, Status};
use creepage::{Creepage, Force, SiCreepage};

use crate::random::random_gap;
use crate::support::{MM, Sequence, function, number, steel};

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
        let name = self.name;
        println!("{name:6} {count:4} covered {share:.3} median {median:.2} worst {worst:.2?}");
        share
    }
}

#[test]
fn error_bars_cover() {
    let (from, count) = (number("CREEPAGE_BARS_FROM", 0), number("CREEPAGE_RANDOM_BARS", 12));
    let mut ratios = ["load", "peak", "area", "force", "fx", "fy", "mz"].map(Ratios::new);
    for seed in from..from + count {
        // Other gaps than those of the random series.
        let mut sequence = Sequence(!seed.wrapping_mul(0x1234_5678_9ABC_DEF1));
        let gap = random_gap(&mut sequence);
        let approach = 1e-6 * 10.0_f64.powf(sequence.between(0.0, 2.0));
        let at = |count| {
            let resolution = Resolution::new(count).unwrap();
            NormalContact::at_approach(&gap, steel(), approach, resolution)
        };
        // Standard, fine, finest.
        let [Ok(contact), Ok(fine), Ok(finest)] = [20, 32, 60].map(at) else { continue };
        let (normal, forces) = ratios.split_at_mut(3);
        push_normal(normal, seed, &contact, &finest);
        let creepage = [(); 3].map(|()| sequence.between(-1.0, 1.0));
        push_forces(forces, seed, [&fine, &finest], creepage);
    }
    let shares = ratios.each_mut().map(Ratios::covered);
    // 95 % of many; of twelve, two may lie outside.
    assert!(shares.iter().all(|share| *share >= 0.8), "{shares:?}");
}

/// Load, peak pressure, area.
fn push_normal(ratios: &mut [Ratios], seed: u64, found: &NormalContact, best: &NormalContact) {
    let numbers = |c: &NormalContact| [c.load(), c.peak_pressure(), c.area()];
    for (ratio, (found, best)) in
        ratios.iter_mut().zip(numbers(found).into_iter().zip(numbers(best)))
    {
        ratio.push(seed, found.error, found.value - best.value);
    }
}

/// The size of the force, its components, the moment; as the doors roll by `exact`.
fn push_forces(
    ratios: &mut [Ratios],
    seed: u64,
    [contact, finest]: [&NormalContact; 2],
    [xi, eta, chi]: [f64; 3],
) {
    let unit = contact.scaling(FRICTION).unwrap();
    let creepage = unit.si_creepage(Creepage::new(xi, eta, chi).unwrap());
    let rolled = |contact, resolution| rolled(contact, resolution, creepage, unit.length);
    let found = rolled(contact, coulomb::Resolution::STANDARD);
    let Some(((found, bar), (best, _))) = found.zip(rolled(finest, coulomb::Resolution::FINE))
    else {
        return;
    };
    let [x, y, z] = [0, 1, 2].map(|k| found[k] - best[k]);
    let pairs = [(bar[0].hypot(bar[1]), x.hypot(y)), (bar[0], x), (bar[1], y), (bar[2], z)];
    for (ratio, (bar, error)) in ratios.iter_mut().zip(pairs) {
        ratio.push(seed, bar, error);
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

/// Waves of 2 to 40 mm that turn half of the pressure and more, along rolling, across and askew: each
/// number within its bars of that by three times as many strips or elements.
#[test]
fn corrugated_bodies() {
    let mut sequence = Sequence(2026);
    let mut ratios = ["load", "peak", "area"].map(Ratios::new);
    for seed in 0..number("CREEPAGE_RANDOM_WAVES", 24) {
        let radii = [(); 2].map(|()| 1e3 * 0.06 * 20.0_f64.powf(sequence.next()));
        let (length, phase) = (2.0 * 20.0_f64.powf(sequence.next()), sequence.between(0.0, 6.3));
        let angle = [0.0, 90.0, sequence.between(0.0, 180.0)][seed as usize % 3].to_radians();
        // Waves carry `E* pi amplitude/length` at most, 50 to 500 MPa here.
        let amplitude =
            (sequence.between(0.05, 0.5) * length / (114.0 * std::f64::consts::PI)).min(0.01);
        let gap = function([-40.0, 40.0], [-40.0, 40.0], move |x, y| {
            let along = x * angle.cos() + y * angle.sin();
            let wave = (std::f64::consts::TAU * along / length + phase).cos();
            0.5 * (x * x / radii[0] + y * y / radii[1]) + amplitude * wave
        });
        let approach = MM * sequence.between(0.04, 0.09);
        let [found, best] = [20, 60].map(|count| {
            let resolution = Resolution::new(count).unwrap();
            NormalContact::at_approach(&gap, steel(), approach, resolution).unwrap()
        });
        push_normal(&mut ratios, seed, &found, &best);
    }
    let shares = ratios.each_mut().map(Ratios::covered);
    // As above.
    assert!(shares.iter().all(|share| *share >= 0.8), "{shares:?}");
}
