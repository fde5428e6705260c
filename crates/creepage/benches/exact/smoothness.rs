//! Ripples of the force along lines of creepage.

use creepage::coulomb::Resolution;
use creepage::{Creepage, Theory};

use crate::exact;
use crate::random::Random;

const POINTS: usize = 200;
/// Neighbours on each side.
const REACH: usize = 5;

/// Prints by how much `fx`, `fy` and `mz` differ from a cubic through 11 neighbouring points of 200,
/// along so many lines of creepage .3 to 1.8 (a/b .4-2.5, spin 0-3).
pub(crate) fn print(count: usize, resolution: Resolution) {
    let mut random = Random::new(0xac40_4849_0d4f_655b);
    let ripples: Vec<[f64; 3]> = (0..count).map(|_| ripple(&mut random, resolution)).collect();
    print_one("all", ripples.iter().map(|[x, y, z]| x.max(*y).max(*z)).collect());
    for (k, name) in ["f_x", "f_y", "m_z"].into_iter().enumerate() {
        print_one(name, ripples.iter().map(|ripple| ripple[k]).collect());
    }
}

fn print_one(name: &str, mut ripples: Vec<f64>) {
    ripples.sort_by(f64::total_cmp);
    let n = ripples.len();
    println!(
        "{name}: {n} lines; ripple in 1e-4 of mu N (mu N c): median {:.2}, 90 % {:.2}, 98 % \
         {:.2}, worst {:.2}",
        1e4 * ripples[n / 2],
        1e4 * ripples[n * 9 / 10 - 1],
        1e4 * ripples[n * 49 / 50 - 1],
        1e4 * ripples[n - 1]
    );
}

/// The largest ripple of each component along one line.
fn ripple(random: &mut Random, resolution: Resolution) -> [f64; 3] {
    let a_over_b = random.between(0.4_f64.ln(), 2.5_f64.ln()).exp();
    let theory = exact(a_over_b, random.between(0.0, 0.5), resolution);
    let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
    let spin = random.between(0.0, 3.0);
    let forces: Vec<[f64; 3]> = (0..POINTS)
        .map(|i| {
            let size = 0.3 + 1.5 * i as f64 / (POINTS - 1) as f64;
            let creepage = Creepage::new(size * cos, size * sin, spin).unwrap();
            theory.solve(creepage).force.components()
        })
        .collect();
    let off = |points: &[[f64; 3]], k: usize| {
        let fit: f64 = points.iter().enumerate().map(|(i, f)| savitzky_golay(i) * f[k]).sum();
        (points[REACH][k] - fit).abs()
    };
    let windows = || forces.windows(2 * REACH + 1);
    [0, 1, 2].map(|k| windows().map(|points| off(points, k)).fold(0.0, f64::max))
}

/// Weight of a point in the value of the cubic at the middle one.
fn savitzky_golay(i: usize) -> f64 {
    let apart = i as f64 - REACH as f64;
    (89.0 - 5.0 * apart * apart) / 429.0
}
