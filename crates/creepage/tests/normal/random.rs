//! Random gaps: every one is solved, or the error says why not. `CREEPAGE_RANDOM_GAPS=10000`
//! asks for more, `CREEPAGE_GAPS_FROM` for others; what each way solved and the worst times are
//! printed.

use std::time::Instant;

use creepage::gap::{Gap, Rolling};
use creepage::normal::{Method, NormalContact, NormalError, Patch, Resolution, Status};

use crate::support::{MM, Sequence, function, number, polynomial, steel};

#[test]
fn every_random_gap_is_solved() {
    let (from, count) = (number("CREEPAGE_GAPS_FROM", 0), number("CREEPAGE_RANDOM_GAPS", 60));
    let (mut tally, mut wrong) = (Tally::default(), Vec::new());
    for seed in from..from + count {
        let mut sequence = Sequence(seed.wrapping_mul(0x1234_5678_9ABC_DEF1));
        let gap = random_gap(&mut sequence);
        let start = Instant::now();
        let found = pressed(&gap, &mut sequence);
        tally.times.push((start.elapsed().as_secs_f64(), seed));
        match found {
            Ok(contact) => {
                wrong.extend(fault(&contact).map(|fault| format!("{seed}: {fault}")));
                match contact.method() {
                    Method::Strips => tally.by_strips += 1,
                    Method::Elements => tally.by_elements.push(seed),
                }
            }
            Err(NormalError::NoContact { .. }) => tally.apart += 1,
            Err(NormalError::ReachesEdge { .. }) => tally.beyond += 1,
            Err(other) => wrong.push(format!("{seed}: {other}")),
        }
    }
    println!("{tally}");
    assert!(wrong.is_empty(), "{wrong:#?}");
}

fn pressed(gap: &Gap, sequence: &mut Sequence) -> Result<NormalContact, NormalError> {
    if sequence.next() < 0.7 {
        let approach = 1e-6 * 10.0_f64.powf(sequence.between(0.0, 2.0));
        NormalContact::at_approach(gap, steel(), approach, Resolution::STANDARD)
    } else {
        let load = 10.0_f64.powf(sequence.between(2.0, 4.5));
        NormalContact::under_load(gap, steel(), load, Resolution::STANDARD)
    }
}

/// What became of the gaps: seconds with seeds, the seeds that elements solved.
#[derive(Default)]
struct Tally {
    by_strips: usize,
    by_elements: Vec<u64>,
    apart: usize,
    beyond: usize,
    times: Vec<(f64, u64)>,
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { by_strips, by_elements, apart, beyond, times } = self;
        let mut times = times.clone();
        times.sort_by(|(one, _), (other, _)| other.total_cmp(one));
        let mean = times.iter().map(|(time, _)| time).sum::<f64>() / times.len() as f64;
        writeln!(
            f,
            "{} gaps: {by_strips} by strips, {} by elements",
            times.len(),
            by_elements.len()
        )?;
        writeln!(f, "{apart} do not touch, {beyond} reach the edge; mean {mean:.2e} s")?;
        writeln!(f, "worst seconds and their seeds {:.3?}", &times[..times.len().min(10)])?;
        write!(f, "by elements {by_elements:?}")
    }
}

/// What is wrong with a contact.
fn fault(contact: &NormalContact) -> Option<String> {
    let numbers = [
        contact.load().value,
        contact.peak_pressure().value,
        contact.area().value,
        contact.stiffness(),
    ];
    let carried: f64 = contact.patches().iter().map(Patch::load).sum();
    let mean = contact.load().value / contact.area().value;
    let wrong = [
        (contact.status() != Status::Converged, "not converged"),
        (!numbers.iter().all(|n| n.is_finite() && *n > 0.0), "not finite and positive"),
        // Patches are scaled to carry the load, up to rounding.
        ((carried / contact.load().value - 1.0).abs() > 1e-6, "patches do not carry the load"),
        (contact.peak_pressure().value <= mean, "no peak above the mean pressure"),
    ];
    let found = wrong.iter().find(|(is_wrong, _)| *is_wrong);
    found.map(|(_, name)| format!("{name}: {numbers:?} {carried} {:?}", contact.status()))
}

/// A skew ellipse to 50:1 with higher terms, one to four bumps, or a section of arcs.
pub(crate) fn random_gap(sequence: &mut Sequence) -> Gap {
    match (sequence.next() * 3.0) as u32 {
        0 => random_polynomial(sequence),
        1 => random_bumps(sequence),
        _ => random_section(sequence),
    }
}

fn random_polynomial(sequence: &mut Sequence) -> Gap {
    // The axes' ratio is about the curvatures' to the power 2/3.
    let ratio = 500.0_f64.powf(sequence.between(-1.0, 1.0));
    let (along, across) = (2e-3 * ratio.sqrt(), 2e-3 / ratio.sqrt());
    let (sin, cos) = sequence.between(-0.7, 0.7).sin_cos();
    let quartic = 1e-5 * sequence.next();
    polynomial(&[
        (2, 0, along * cos * cos + across * sin * sin),
        (1, 1, 2.0 * (along - across) * sin * cos),
        (0, 2, along * sin * sin + across * cos * cos),
        (1, 2, 1e-6 * sequence.between(-1.0, 1.0)),
        (4, 0, quartic),
        (2, 2, 2.0 * quartic),
        (0, 4, quartic + 1e-5 * sequence.next()),
    ])
}

fn random_bumps(sequence: &mut Sequence) -> Gap {
    let count = 1 + (sequence.next() * 4.0) as usize;
    let bumps: Vec<[f64; 5]> = (0..count)
        .map(|_| {
            [
                sequence.between(-6.0, 6.0),
                sequence.between(-6.0, 6.0),
                1.0 / (200.0 * 10.0_f64.powf(sequence.between(-0.5, 0.7))),
                1.0 / (200.0 * 10.0_f64.powf(sequence.between(-0.5, 0.7))),
                0.005 * sequence.next(),
            ]
        })
        .collect();
    function([-12.0, 12.0], [-12.0, 12.0], move |x, y| {
        bumps
            .iter()
            .map(|[x0, y0, a, b, h]| a * (x - x0).powi(2) + b * (y - y0).powi(2) + h)
            .fold(f64::INFINITY, f64::min)
    })
}

/// Curvatures that step at random places, as between the arcs of rails.
fn random_section(sequence: &mut Sequence) -> Gap {
    let points = 121;
    let mut curvature = 1.0 / 200.0;
    let (mut slope, mut height) = (sequence.between(-0.02, -0.06), 0.0);
    let (mut y, mut h) = (Vec::new(), Vec::new());
    for i in 0..points {
        y.push((f64::from(i) * 0.2 - 12.0) * MM);
        h.push(height * MM);
        if sequence.next() < 0.1 {
            curvature = 10.0_f64.powf(sequence.between(-3.0, -1.3));
        }
        height += 0.2 * slope + 0.02 * curvature;
        slope += 0.2 * curvature;
    }
    let least = h.iter().copied().fold(f64::INFINITY, f64::min);
    let h: Vec<f64> = h.iter().map(|h| h - least).collect();
    Gap::section(&y, &h, Rolling::Radius(sequence.between(0.05, 1.0))).unwrap()
}
