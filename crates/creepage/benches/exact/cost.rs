//! Failures and costs over the whole range.

use std::time::Instant;

use creepage::coulomb::{Exact, Resolution};
use creepage::{Creepage, Solution, Status, Theory};

use crate::random::Random;
use crate::{RESOLUTIONS, exact};

/// A random case and what it costs.
struct Cost {
    contact: (f64, f64),
    creepage: Creepage,
    sweeps: usize,
    milliseconds: f64,
}

/// Other work on the machine disturbs single runs: the smallest of two counts, of six for the
/// hundred of highest cost.
pub(crate) fn print(count: usize) {
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
    let mut random = Random::new(88_172_645_463_325_252);
    let (mut costs, mut failures) = (Vec::with_capacity(count), 0);
    for _ in 0..count.div_ceil(PER_CONTACT) {
        let contact = (random.of_any_size(0.02, 50.0).abs(), 0.5 * random.uniform());
        let theory = exact(contact.0, contact.1, resolution);
        for _ in 0..PER_CONTACT {
            let creepage = creepage(&mut random, contact.0);
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

/// Pure creepages of any size, mixtures of any size, a spin pole in or near the contact, and
/// the everyday range.
fn creepage(random: &mut Random, a_over_b: f64) -> Creepage {
    let [p, q, r] = [0; 3].map(|_| random.of_any_size(1e-6, 1e3));
    let [xi, eta, chi] = match (6.0 * random.uniform()).floor() {
        0.0 => [p, 0.0, 0.0],
        1.0 => [0.0, p, 0.0],
        2.0 => [0.0, 0.0, p],
        3.0 => [p, q, r],
        4.0 => {
            let spin = random.of_any_size(0.05, 20.0);
            let x = random.between(-1.2, 1.2) * a_over_b.sqrt();
            let y = random.between(-1.2, 1.2) / a_over_b.sqrt();
            [spin * y, -spin * x, spin]
        }
        _ => [random.between(-3.0, 3.0), random.between(-3.0, 3.0), random.between(-8.0, 8.0)],
    };
    Creepage::new(xi, eta, chi).unwrap()
}
