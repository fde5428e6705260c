//! How often error bars cover, and how wide they are: ellipses of like and unlike bodies, gaps, and wheelsets at random,
//! at the standard resolution against a finer one.
//!
//!     cargo bench -p creepage-wheelset --bench coverage -- 150 [SEED]
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout)]

use std::f64::consts::TAU;

use creepage::coulomb::{Exact, NonHertzian, Resolution};
use creepage::gap::{Gap, Rectangle};
use creepage::normal::{self, NormalContact};
use creepage::theory::{AreaTheory, ExactOptions, NamedResolution, ResolutionSpec, Solved};
use creepage::{Contact, Creepage, Ellipse, Solid, SolidPair, Status, Theory};
use creepage_rail::{Place, Standard, Track, Wheelset, WheelsetOnTrack};
use creepage_wheelset::{Load, RailFriction, WheelsetPose, WheelsetSolver, WheelsetVelocity};

const FRICTION: f64 = 0.3;
const FORCES: [&str; 3] = ["f_x", "f_y", "m_z"];

/// Splitmix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// Of any size between the two.
    fn of_size(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// Creepage and spin of any size: down to a thousandth of what slides.
    fn creepage(&mut self) -> Creepage {
        let (size, spin) = (self.of_size(1e-3, 3.0), self.of_size(1e-3, 8.0));
        let (sin, cos) = self.between(0.0, TAU).sin_cos();
        let sign = if self.next() < 0.5 { -1.0 } else { 1.0 };
        Creepage::new(size * cos, size * sin, sign * spin).unwrap()
    }
}

/// Errors and their bars of one quantity.
struct Bars {
    kind: &'static str,
    quantity: &'static str,
    pairs: Vec<(f64, f64)>,
}

/// Bars of several quantities of one kind.
fn bars<const N: usize>(kind: &'static str, quantities: [&'static str; N]) -> [Bars; N] {
    quantities.map(|quantity| Bars { kind, quantity, pairs: Vec::new() })
}

impl Bars {
    fn print(&self) {
        let count = self.pairs.len();
        if count == 0 {
            return;
        }
        let covered = self.pairs.iter().filter(|(error, bar)| error <= bar).count();
        let sorted = |mut values: Vec<f64>| {
            values.sort_by(f64::total_cmp);
            values
        };
        let over = sorted(self.pairs.iter().map(|(error, bar)| bar / error.max(1e-13)).collect());
        let widths = sorted(self.pairs.iter().map(|(_, bar)| *bar).collect());
        let errors = sorted(self.pairs.iter().map(|(error, _)| *error).collect());
        println!(
            "| {} | {} | {count} | {:.1} | {:.1} | {:.1} | {:.2} | {:.4} | {:.4} |",
            self.kind,
            self.quantity,
            100.0 * covered as f64 / count as f64,
            over[count / 2],
            over[count * 9 / 10],
            over[0],
            100.0 * errors[count * 95 / 100],
            100.0 * widths[count * 95 / 100],
        );
    }
}

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|word| word.parse::<u64>().ok());
    let (count, seed) = (numbers.next().unwrap_or(150), numbers.next().unwrap_or(1));
    println!(
        "| kind | quantity | cases | covered, % | bar/error: median | 90 % | least | error, 95 %: % | bar, 95 %: % |"
    );
    println!("|---|---|--:|--:|--:|--:|--:|--:|--:|");
    ellipses("ellipse", 0.0, &mut Random(seed), count);
    ellipses("unlike ellipse", 3.0, &mut Random(!seed), count);
    gaps(&mut Random(seed.wrapping_mul(0x1234_5679)), count);
    wheelsets(&mut Random(seed ^ 0xABCD_EF01), count);
}

/// Against 72 x 60 elements; in parts of `mu N` and `mu N c`.
fn ellipses(kind: &'static str, dissimilarity: f64, random: &mut Random, count: u64) {
    let mut all = bars(kind, FORCES);
    let finest = Resolution::new(72, 60).unwrap();
    for _ in 0..count {
        let ratio = random.of_size(0.15, 6.0);
        let (poisson, kappa) =
            (random.between(0.0, 0.5), random.between(-dissimilarity, dissimilarity));
        let contact = Contact::new(Ellipse::from_ratio(ratio).unwrap(), poisson).unwrap();
        let contact = contact.with_kappa_over_mu(kappa).unwrap();
        let creepage = random.creepage();
        let solved = |resolution| Some(Exact::new(&contact, resolution).ok()?.solve(creepage));
        // Contacts so long that they have too many elements then are left out.
        let Some((found, truth)) = solved(Resolution::STANDARD).zip(solved(finest)) else {
            continue;
        };
        if truth.status != Status::Solved || found.status != Status::Solved {
            continue;
        }
        let parts =
            [found.force, truth.force, found.error.unwrap()].map(|force| force.components());
        for (k, bars) in all.iter_mut().enumerate() {
            bars.pairs.push(((parts[0][k] - parts[1][k]).abs(), parts[2][k]));
        }
    }
    all.iter().for_each(Bars::print);
}

/// Two curvatures and a wave or a step in curvature; pressed by 20 strips against 60.
fn gaps(random: &mut Random, count: u64) {
    let mut normal_bars = bars("gap", ["load", "peak pressure", "area"]);
    let mut forces = bars("gap", FORCES);
    for _ in 0..count {
        let (gap, approach) = (random_gap(random), 1e-6 * random.of_size(3.0, 100.0));
        let creepage = random.creepage();
        let at = |strips| {
            let resolution = normal::Resolution::new(strips).unwrap();
            NormalContact::at_approach(&gap, steel(), approach, resolution)
        };
        let [Ok(contact), Ok(fine), Ok(finest)] = [20, 32, 60].map(at) else { continue };
        let numbers = |c: &NormalContact| [c.load(), c.peak_pressure(), c.area()];
        for ((bars, found), best) in
            normal_bars.iter_mut().zip(numbers(&contact)).zip(numbers(&finest))
        {
            bars.pairs.push(((found.value / best.value - 1.0).abs(), found.error / best.value));
        }
        let unit = fine.scaling(FRICTION).unwrap();
        let given = unit.si_creepage(creepage);
        let rolled = |contact: &NormalContact, resolution| {
            let theory = NonHertzian::new(contact, FRICTION, resolution).unwrap();
            let solution = theory.solve(theory.scaling().creepage(given).unwrap()).solution();
            let length = theory.scaling().length / unit.length;
            let parts = |force: creepage::Force| [force.fx, force.fy, force.mz * length];
            let is_solved = solution.status == Status::Solved;
            is_solved.then(|| [parts(solution.force), parts(solution.error.unwrap_or_default())])
        };
        let found = rolled(&fine, Resolution::STANDARD).zip(rolled(&finest, Resolution::FINE));
        let Some(([force, bar], [truth, _])) = found else { continue };
        for (k, bars) in forces.iter_mut().enumerate() {
            bars.pairs.push(((force[k] - truth[k]).abs(), bar[k]));
        }
    }
    normal_bars.iter().chain(&forces).for_each(Bars::print);
}

fn random_gap(random: &mut Random) -> Gap {
    let [along, across] = [0, 1].map(|_| random.of_size(0.05, 2.0));
    let (amplitude, length) = (random.of_size(1e-7, 4e-6), random.of_size(4e-3, 30e-3));
    let (phase, turn) = (random.between(0.0, TAU), random.between(0.0, TAU));
    let kink = random.between(-0.5, 0.5);
    let domain = Rectangle { x: [-0.04, 0.04], y: [-0.04, 0.04] };
    let height = move |x: f64, y: f64| {
        let wave = amplitude * (TAU * (x * turn.cos() + y * turn.sin()) / length + phase).cos();
        0.5 * (x * x / along + y * y / across * (1.0 + kink * (y / 2e-3).tanh())) + wave
    };
    Gap::function(domain, height).unwrap()
}

fn steel() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

fn track() -> WheelsetOnTrack {
    let place = Place::gauge(1.435, 0.014);
    let track = Track::new(&Standard::Uic60.profile(), 0.025_f64.atan(), place).unwrap();
    Wheelset::like(&Standard::S1002.profile(), 0.46, 1.360).unwrap().on(track)
}

/// S1002 on UIC 60, 1:40, under a load, against the fine resolution; forces on the rails in parts of a wheel's `mu N`.
fn wheelsets(random: &mut Random, count: u64) {
    let running = track();
    let friction = || [RailFriction::Constant(FRICTION), RailFriction::Constant(FRICTION)];
    let solver = |name| {
        let resolution = ResolutionSpec::Named(name);
        let theory = AreaTheory::Exact(ExactOptions { resolution, ..ExactOptions::default() });
        WheelsetSolver::new(&running, steel(), friction(), theory).unwrap()
    };
    let [standard, fine] = [NamedResolution::Standard, NamedResolution::Fine].map(solver);
    let mut all = bars("wheelset", ["longitudinal", "lateral", "vertical"]);
    let mut normal_bars = bars("wheelset", ["load of a contact", "peak pressure", "area"]);
    for _ in 0..count {
        let (y, yaw) = (random.between(-7e-3, 7e-3), random.between(-8e-3, 8e-3));
        let axle = random.of_size(20e3, 250e3);
        let pose = WheelsetPose { side: None, y, yaw, roll: None, load: Some(Load::Axle(axle)) };
        let lateral_velocity = random.between(-0.1, 0.1);
        let velocity =
            WheelsetVelocity { speed: 30.0, lateral_velocity, ..WheelsetVelocity::default() };
        let solved = [&standard, &fine].map(|solver| solver.solve(&pose, &velocity));
        let [Ok(found), Ok(truth)] = solved else { continue };
        for (wheel, best) in found.wheels().zip(truth.wheels()) {
            let ([one, other], unit) =
                ([wheel, best].map(creepage_wheelset::SolvedWheel::on_rail), FRICTION * 0.5 * axle);
            let Some(bar) = one.force_error else { continue };
            // A wheelset that rolls freely presses with half of the load on each rail.
            let truth = [other.force[0], other.force[1], 0.5 * axle];
            for (k, bars) in all.iter_mut().enumerate() {
                bars.pairs.push(((one.force[k] - truth[k]).abs() / unit, bar[k] / unit));
            }
            let contacts = wheel.contacts().iter().zip(best.contacts());
            for (one, other) in contacts.filter(|_| wheel.contacts().len() == best.contacts().len())
            {
                let (n, m) = (&one.normal, &other.normal);
                let pairs = [
                    (n.load().value, one.load_error, m.load().value),
                    (n.peak_pressure().value, n.peak_pressure().error, m.peak_pressure().value),
                    (n.area().value, n.area().error, m.area().value),
                ];
                for (bars, (value, bar, best)) in normal_bars.iter_mut().zip(pairs) {
                    bars.pairs.push(((value / best - 1.0).abs(), bar / best));
                }
            }
        }
    }
    all.iter().chain(&normal_bars).for_each(Bars::print);
}
