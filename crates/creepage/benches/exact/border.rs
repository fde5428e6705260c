//! The border of adhesion, against that of many elements.

use creepage::coulomb::{Exact, Resolution};
use creepage::theory::Solved;
use creepage::{Contact, Creepage, Ellipse, Region, Status};

use crate::random::Random;
use crate::{RESOLUTIONS, finest};

/// Creepages of each contact, which is prepared once.
const PER_CONTACT: usize = 6;
/// Lines along the rolling direction, of equal distance.
const LINES: usize = 24;
/// Points of each.
const POINTS: usize = 6000;

/// Prints by how much borders differ over so many random cases (a/b .15-6; half of them with creepage to
/// 3 and spin to 8, half to 1.5 and 2), on lines with the same number of them: along the lines, and normal
/// to the border, for one that is nearly along a line moves far along it with little.
pub(crate) fn print(count: usize, truth: Resolution) {
    let mut random = Random::new(0x5851_f42d_4c95_7f2d);
    let [fast, standard, fine] = RESOLUTIONS;
    let all = [fast, standard, fine, ("96 x 80 elements", finest())];
    // Those that stand for the truth as a rule tell nothing of themselves.
    let measured = if truth == finest() { &all[..3] } else { &all };
    let mut errors: Vec<Errors> = measured.iter().map(|_| Errors::default()).collect();
    for _ in 0..count.div_ceil(PER_CONTACT) {
        measure(&mut random, measured, truth, &mut errors);
    }
    for ((name, _), errors) in measured.iter().zip(&mut errors) {
        let others = errors.others;
        println!("{name}: {} borders; {others} lines with another number", errors.along.len());
        print_one("along x", &mut errors.along);
        print_one("normal to the border", &mut errors.normal);
    }
}

fn print_one(name: &str, errors: &mut [f64]) {
    errors.sort_by(f64::total_cmp);
    let n = errors.len();
    let square: f64 = errors.iter().map(|error| error * error).sum();
    println!(
        "  error in c {name}: median {:.4}, 90 % {:.4}, rms {:.4}",
        errors[n / 2],
        errors[n * 9 / 10],
        (square / n as f64).sqrt()
    );
}

/// By how much borders are off, along lines and normal to the border.
#[derive(Default)]
struct Errors {
    along: Vec<f64>,
    normal: Vec<f64>,
    /// Lines with another number of borders.
    others: usize,
}

impl Errors {
    /// Borders of all lines, which are `apart`, against the true ones.
    fn add(&mut self, found: &[Vec<f64>], truth: &[Vec<f64>], apart: f64) {
        for (k, (own, there)) in found.iter().zip(truth).enumerate() {
            if own.len() != there.len() {
                self.others += 1;
                continue;
            }
            for (i, (own, there)) in own.iter().zip(there).enumerate() {
                let off = (own - there).abs();
                self.along.push(off);
                self.normal.push(off / slope(truth, k, i, apart).hypot(1.0));
            }
        }
    }
}

/// The smaller slope, `x` by `y`, of a border towards the lines beside with as many of them; none where
/// there is no such line.
fn slope(borders: &[Vec<f64>], line: usize, i: usize, apart: f64) -> f64 {
    let own = &borders[line];
    let beside = [line.wrapping_sub(1), line + 1].into_iter().filter_map(|k| borders.get(k));
    let alike = beside.filter(|other| other.len() == own.len());
    alike.map(|other| (other[i] - own[i]).abs() / apart).reduce(f64::min).unwrap_or(0.0)
}

fn measure(
    random: &mut Random,
    measured: &[(&str, Resolution)],
    truth: Resolution,
    errors: &mut [Errors],
) {
    let ellipse = Ellipse::from_ratio(random.of_any_size(0.15, 6.0).abs()).unwrap();
    let contact = Contact::new(ellipse, random.between(0.0, 0.5)).unwrap();
    let theory = |resolution| Exact::new(&contact, resolution).unwrap();
    let theories: Vec<Exact> = measured.iter().map(|(_, named)| theory(*named)).collect();
    let finest = theory(truth);
    for k in 0..PER_CONTACT {
        let [creepage, spin] = if k % 2 == 0 { [3.0, 8.0] } else { [1.5, 2.0] };
        let size = random.between(0.0, creepage);
        let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
        let creepage = Creepage::new(size * cos, size * sin, random.between(-spin, spin)).unwrap();
        let Some(truth) = borders(&finest, ellipse, creepage) else { continue };
        for (theory, errors) in theories.iter().zip(&mut *errors) {
            let Some(found) = borders(theory, ellipse, creepage) else { continue };
            errors.add(&found, &truth, 2.0 * ellipse.b() / LINES as f64);
        }
    }
}

/// Where adhesion begins or ends along each line; `None` where the contact is not solved.
fn borders(theory: &Exact, ellipse: Ellipse, creepage: Creepage) -> Option<Vec<Vec<f64>>> {
    let solved = theory.solve_contact(creepage);
    if solved.solution().status != Status::Solved {
        return None;
    }
    let line = |k: usize| {
        let t = (2.0 * k as f64 + 1.0) / LINES as f64 - 1.0;
        let half = ellipse.a() * (1.0 - t * t).sqrt();
        let at = |i: usize| half * (1.0 - (2.0 * i as f64 + 1.0) / POINTS as f64);
        let points: Vec<[f64; 2]> = (0..POINTS).map(|i| [at(i), ellipse.b() * t]).collect();
        let adheres: Vec<bool> =
            solved.field(&points).iter().map(|p| p.region == Region::Adhesion).collect();
        let changes = (1..POINTS).filter(|i| adheres[i - 1] != adheres[*i]);
        changes.map(|i| 0.5 * (at(i - 1) + at(i))).collect()
    };
    Some((0..LINES).map(line).collect())
}
