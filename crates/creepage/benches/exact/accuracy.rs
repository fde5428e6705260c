//! Errors and error bars over random cases, like bodies and unlike, over the whole range and at small creepage.

use creepage::coulomb::{Exact, Resolution};
use creepage::{Contact, Creepage, Ellipse, Status, Theory};

use crate::RESOLUTIONS;
use crate::random::Random;

/// Creepages of each contact, which is prepared once.
const PER_CONTACT: usize = 10;

/// Prints the statistics of so many cases of each kind against `finest`, of those that it solves; another `draw`
/// has others.
pub(crate) fn print(count: usize, draw: u64, finest: Resolution) {
    println!(
        "| bodies | creepage, spin | resolution | of | cases | error, rms: % | worst: % | covered: % | bar/error, median |"
    );
    println!("|---|---|---|---|--:|--:|--:|--:|--:|");
    for kind in [
        Kind { bodies: "like", dissimilarity: 0.0, range: "whole range", small: false },
        Kind { bodies: "unlike", dissimilarity: 3.0, range: "whole range", small: false },
        Kind { bodies: "like", dissimilarity: 0.0, range: ".01 to 1", small: true },
        Kind { bodies: "unlike", dissimilarity: 3.0, range: ".01 to 1", small: true },
    ] {
        let seed =
            if kind.dissimilarity == 0.0 { 0xac40_4849_0d4f_655b } else { 0x2309_5609_6379_fe33 };
        let mut random = Random::new(seed ^ draw);
        let mut errors = RESOLUTIONS.map(|_| Errors::default());
        for _ in 0..count.div_ceil(PER_CONTACT) {
            kind.measure(&mut random, finest, &mut errors);
        }
        for ((name, _), errors) in RESOLUTIONS.iter().zip(&errors) {
            errors.print(&kind, name);
        }
    }
}

/// Contacts of `a/b` .15 to 6 with `kappa/mu` up to `dissimilarity`.
struct Kind {
    bodies: &'static str,
    dissimilarity: f64,
    range: &'static str,
    small: bool,
}

impl Kind {
    /// One contact and some creepages, at each resolution.
    fn measure(&self, random: &mut Random, finest: Resolution, errors: &mut [Errors]) {
        let ellipse = Ellipse::from_ratio(random.of_any_size(0.15, 6.0).abs()).unwrap();
        let poisson = random.between(0.0, 0.5);
        let kappa_over_mu = random.between(-self.dissimilarity, self.dissimilarity);
        let contact =
            Contact::new(ellipse, poisson).unwrap().with_kappa_over_mu(kappa_over_mu).unwrap();
        let theory = |resolution| Exact::new(&contact, resolution).unwrap();
        let creepages: [Creepage; PER_CONTACT] = std::array::from_fn(|_| self.creepage(random));
        let finest = theory(finest);
        let truth = creepages.map(|creepage| finest.solve(creepage));
        for ((_, resolution), errors) in RESOLUTIONS.iter().zip(errors) {
            let theory = theory(*resolution);
            let solved =
                truth.iter().zip(&creepages).filter(|(truth, _)| truth.status == Status::Solved);
            for (truth, creepage) in solved {
                let (found, truth) = (theory.solve(*creepage), truth.force.components());
                let (force, bar) = (found.force.components(), found.error.unwrap().components());
                for (k, pairs) in errors.pairs.iter_mut().enumerate() {
                    pairs.push(((force[k] - truth[k]).abs(), bar[k]));
                }
            }
        }
    }

    /// Creepage to 3 with spin to 8, or both of any size from .01 to 1.
    fn creepage(&self, random: &mut Random) -> Creepage {
        let size =
            if self.small { random.of_any_size(0.01, 1.0) } else { random.between(0.0, 3.0) };
        let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
        let spin =
            if self.small { random.of_any_size(0.01, 1.0) } else { random.between(-8.0, 8.0) };
        Creepage::new(size * cos, size * sin, spin).unwrap()
    }
}

/// Errors of `fx`, `fy` and `mz` of each case with their bars.
#[derive(Default)]
struct Errors {
    pairs: [Vec<(f64, f64)>; 3],
}

impl Errors {
    fn print(&self, kind: &Kind, name: &str) {
        for (pairs, of) in self.pairs.iter().zip(["f_x", "f_y", "m_z"]) {
            let n = pairs.len() as f64;
            let square: f64 = pairs.iter().map(|(error, _)| error * error).sum();
            let worst = pairs.iter().fold(0.0, |worst: f64, (error, _)| worst.max(*error));
            let covered = pairs.iter().filter(|(error, bar)| error <= bar).count();
            let mut over: Vec<f64> = pairs.iter().map(|(e, bar)| bar / e.max(1e-12)).collect();
            over.sort_by(f64::total_cmp);
            println!(
                "| {} | {} | {name} | {of} | {} | {:.3} | {:.3} | {:.1} | {:.1} |",
                kind.bodies,
                kind.range,
                pairs.len(),
                100.0 * (square / n).sqrt(),
                100.0 * worst,
                100.0 * covered as f64 / n,
                over[over.len() / 2],
            );
        }
    }
}
