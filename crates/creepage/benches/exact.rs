//! Cost of the full theory. `cargo bench --bench exact -- random 100000` solves that many random
//! cases over the whole range instead, and prints failures and costs.
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout)]

use std::time::Instant;

use creepage::coulomb::{Exact, Resolution};
use creepage::theory::Solved;
use creepage::{Contact, Creepage, Ellipse, Jacobian, Solution, Status, Theory};
use divan::{Bencher, black_box};

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    match arguments.iter().position(|argument| argument == "random") {
        Some(at) => random_cases(arguments[at + 1].parse().unwrap()),
        None => divan::main(),
    }
}

const RESOLUTIONS: [(&str, Resolution); 3] =
    [("fast", Resolution::FAST), ("standard", Resolution::STANDARD), ("fine", Resolution::FINE)];

fn theory(name: &str) -> Exact {
    let (_, resolution) = RESOLUTIONS.iter().find(|(known, _)| *known == name).unwrap();
    exact(black_box(0.5), black_box(0.28), *resolution)
}

fn exact(a_over_b: f64, poisson: f64, resolution: Resolution) -> Exact {
    let contact = Contact::new(Ellipse::from_ratio(a_over_b).unwrap(), poisson).unwrap();
    Exact::new(&contact, resolution).unwrap()
}

/// The spin of Fig. 12 of the thesis and creepage of the given size at -30 degrees.
fn figure_12(size: f64) -> Creepage {
    let (sin, cos) = (-30.0_f64).to_radians().sin_cos();
    Creepage::new(size * cos, size * sin, 2.0).unwrap()
}

#[divan::bench(args = ["fast", "standard", "fine"], sample_count = 20)]
fn prepare(name: &str) -> Exact {
    theory(name)
}

#[divan::bench(args = ["fast", "standard", "fine"], sample_count = 20)]
fn solve(bencher: Bencher, name: &str) {
    let theory = theory(name);
    bencher.bench_local(|| -> Solution { theory.solve(black_box(figure_12(1.7))) });
}

#[divan::bench(args = ["fast", "standard", "fine"], sample_count = 20)]
fn solve_a_neighbour(bencher: Bencher, name: &str) {
    let theory = theory(name);
    let mut solved = Some(theory.solve_contact(figure_12(1.7)));
    let mut step = 0.0;
    bencher.bench_local(|| {
        step = 0.01 - step;
        let last = solved.take().unwrap();
        solved.insert(last.next(black_box(figure_12(1.7 + step)))).solution()
    });
}

#[divan::bench(args = ["fast", "standard", "fine"], sample_count = 20)]
fn derivative(bencher: Bencher, name: &str) {
    let theory = theory(name);
    let mut solved = theory.solve_contact(figure_12(1.7));
    bencher.bench_local(|| -> Option<Jacobian> { solved.jacobian() });
}

/// A small generator of random numbers, the same on every machine.
struct Random(u64);

impl Random {
    fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// Of any size between the two, and of either sign.
    fn of_any_size(&mut self, low: f64, high: f64) -> f64 {
        let sign = if self.uniform() < 0.5 { -1.0 } else { 1.0 };
        sign * self.between(low.ln(), high.ln()).exp()
    }

    /// Pure creepages of any size, mixtures of any size, a spin pole in or near the contact, and
    /// the everyday range.
    fn creepage(&mut self, a_over_b: f64) -> Creepage {
        let [p, q, r] = [0; 3].map(|_| self.of_any_size(1e-6, 1e3));
        let [xi, eta, chi] = match (6.0 * self.uniform()).floor() {
            0.0 => [p, 0.0, 0.0],
            1.0 => [0.0, p, 0.0],
            2.0 => [0.0, 0.0, p],
            3.0 => [p, q, r],
            4.0 => {
                let spin = self.of_any_size(0.05, 20.0);
                let x = self.between(-1.2, 1.2) * a_over_b.sqrt();
                let y = self.between(-1.2, 1.2) / a_over_b.sqrt();
                [spin * y, -spin * x, spin]
            }
            _ => [self.between(-3.0, 3.0), self.between(-3.0, 3.0), self.between(-8.0, 8.0)],
        };
        Creepage::new(xi, eta, chi).unwrap()
    }
}

/// A random case and what it costs.
struct Cost {
    contact: (f64, f64),
    creepage: Creepage,
    sweeps: usize,
    milliseconds: f64,
}

/// Other work on the machine disturbs single runs: the smallest of two counts, of six for the
/// hundred of highest cost.
fn random_cases(count: usize) {
    for (name, resolution) in &RESOLUTIONS[..2] {
        let (mut costs, failures) = costs(count, *resolution);
        costs.sort_by(|a, b| a.milliseconds.total_cmp(&b.milliseconds));
        for cost in costs.iter_mut().rev().take(100) {
            let theory = exact(cost.contact.0, cost.contact.1, *resolution);
            for _ in 0..4 {
                let again = timed(&theory, cost.creepage).1;
                cost.milliseconds = cost.milliseconds.min(again);
            }
        }
        let n = costs.len();
        let mut times: Vec<f64> = costs.iter().map(|cost| cost.milliseconds).collect();
        let mut sweeps: Vec<usize> = costs.iter().map(|cost| cost.sweeps).collect();
        times.sort_by(f64::total_cmp);
        sweeps.sort_unstable();
        println!(
            "{name}: {n} cases, {failures} failed; ms: median {:.3}, 99 % {:.3}, worst {:.3}, {:.1} \
             times the median; sweeps: median {}, 99 % {}, worst {}",
            times[n / 2],
            times[n * 99 / 100],
            times[n - 1],
            times[n - 1] / times[n / 2],
            sweeps[n / 2],
            sweeps[n * 99 / 100],
            sweeps[n - 1]
        );
    }
}

/// Of random cases, and how many of them failed.
fn costs(count: usize, resolution: Resolution) -> (Vec<Cost>, usize) {
    const PER_CONTACT: usize = 100;
    let mut random = Random(88_172_645_463_325_252);
    let (mut costs, mut failures) = (Vec::with_capacity(count), 0);
    for _ in 0..count.div_ceil(PER_CONTACT) {
        let contact = (random.of_any_size(0.02, 50.0).abs(), 0.5 * random.uniform());
        let theory = exact(contact.0, contact.1, resolution);
        for _ in 0..PER_CONTACT {
            let creepage = random.creepage(contact.0);
            let (solution, first) = timed(&theory, creepage);
            let second = timed(&theory, creepage).1;
            let (sweeps, milliseconds) = (solution.statistics.iterations, first.min(second));
            costs.push(Cost { contact, creepage, sweeps, milliseconds });
            let force = solution.force;
            let finite = (force.fx + force.fy + force.mz).is_finite();
            failures += usize::from(solution.status != Status::Solved || !finite);
        }
    }
    (costs, failures)
}

/// A solution and its cost in milliseconds.
fn timed(theory: &Exact, creepage: Creepage) -> (Solution, f64) {
    let start = Instant::now();
    let solution = theory.solve(creepage);
    (solution, start.elapsed().as_secs_f64() * 1e3)
}
