//! Errors and error bars over random cases, like bodies and unlike, against 96 x 80 elements.

use creepage::coulomb::Exact;
use creepage::{Contact, Creepage, Ellipse, Status, Theory};

use crate::random::Random;
use crate::{RESOLUTIONS, finest};

/// Creepages of each contact, which is prepared once.
const PER_CONTACT: usize = 10;

/// Prints the statistics of so many cases of either kind, of those that 96 x 80 elements solve; another `draw`
/// has others.
pub(crate) fn print(count: usize, draw: u64) {
    print_kind("like", 0.0, 0xac40_4849_0d4f_655b ^ draw, count);
    print_kind("unlike", 3.0, 0x2309_5609_6379_fe33 ^ draw, count);
}

/// Prints the statistics of cases with `kappa/mu` up to `dissimilarity`.
fn print_kind(kind: &str, dissimilarity: f64, seed: u64, count: usize) {
    let mut random = Random::new(seed);
    let mut errors = RESOLUTIONS.map(|_| Errors::default());
    for _ in 0..count.div_ceil(PER_CONTACT) {
        measure(&mut random, dissimilarity, &mut errors);
    }
    for ((name, _), errors) in RESOLUTIONS.iter().zip(&errors) {
        errors.print(kind, name);
    }
}

/// One contact of `a/b` .15 to 6 and some creepages to 3 with spin to 8, at each resolution.
fn measure(random: &mut Random, dissimilarity: f64, errors: &mut [Errors]) {
    let ellipse = Ellipse::from_ratio(random.of_any_size(0.15, 6.0).abs()).unwrap();
    let poisson = random.between(0.0, 0.5);
    let kappa_over_mu = random.between(-dissimilarity, dissimilarity);
    let contact =
        Contact::new(ellipse, poisson).unwrap().with_kappa_over_mu(kappa_over_mu).unwrap();
    let theory = |resolution| Exact::new(&contact, resolution).unwrap();
    let creepages: [Creepage; PER_CONTACT] = std::array::from_fn(|_| {
        let size = random.between(0.0, 3.0);
        let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
        Creepage::new(size * cos, size * sin, random.between(-8.0, 8.0)).unwrap()
    });
    let finest = theory(finest());
    let truth = creepages.map(|creepage| finest.solve(creepage));
    for ((_, resolution), errors) in RESOLUTIONS.iter().zip(errors) {
        let theory = theory(*resolution);
        let solved =
            truth.iter().zip(&creepages).filter(|(truth, _)| truth.status == Status::Solved);
        for (truth, creepage) in solved {
            let (found, truth) = (theory.solve(*creepage), truth.force.components());
            let (force, bar) = (found.force.components(), found.error.unwrap().components());
            errors.pairs.extend((0..3).map(|k| ((force[k] - truth[k]).abs(), bar[k])));
        }
    }
}

/// Errors with their bars; those of `fx`, `fy` and `mz` of each case in turn.
#[derive(Default)]
struct Errors {
    pairs: Vec<(f64, f64)>,
}

impl Errors {
    fn print(&self, kind: &str, name: &str) {
        let n = self.pairs.len() as f64;
        let square: f64 = self.pairs.iter().map(|(error, _)| error * error).sum();
        let worst = |k: usize| {
            self.pairs.iter().skip(k).step_by(3).fold(0.0, |worst: f64, (e, _)| worst.max(*e))
        };
        let covered = self.pairs.iter().filter(|(error, bar)| error <= bar).count();
        let mut over: Vec<f64> = self.pairs.iter().map(|(e, bar)| bar / e.max(1e-12)).collect();
        over.sort_by(f64::total_cmp);
        println!(
            "{kind}, {name}: {} cases; error in % of mu N (mu N c): rms {:.3}, worst f_x {:.3}, f_y \
             {:.3}, m_z {:.3}; bars cover {:.1} %, {:.1} times the error in the median",
            self.pairs.len() / 3,
            100.0 * (square / n).sqrt(),
            100.0 * worst(0),
            100.0 * worst(1),
            100.0 * worst(2),
            100.0 * covered as f64 / n,
            over[over.len() / 2],
        );
    }
}
