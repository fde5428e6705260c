//! What Rust needs for the cases of `python/benchmarks/overhead.py`: a line a measurement.
//!
//! Each line is a name and seconds: the best of many runs, of one force and of 100,000.

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use creepage::{Contact, Creepage, Ellipse, Theory, TheorySpec};
use rayon::prelude::*;

const CASES: usize = 100_000;

fn main() -> Result<(), Box<dyn Error>> {
    let contact = Contact::new(Ellipse::from_ratio(1.5)?, 0.28)?;
    for (name, calls, batches) in [("linear", 100_000, 100), ("fastsim", 1000, 2)] {
        report(name, &*TheorySpec::named(name)?.prepare(&contact)?, calls, batches)?;
    }
    Ok(())
}

#[allow(clippy::print_stdout)] // the program's purpose
fn report(
    name: &str,
    theory: &dyn Theory,
    calls: u32,
    batches: usize,
) -> Result<(), Box<dyn Error>> {
    let creepages: Vec<_> = (0..calls)
        .map(|k| Creepage::new(f64::from(k) / f64::from(calls), 0.1, 0.2))
        .collect::<Result<_, _>>()?;
    let one = best(20, || {
        for creepage in &creepages {
            black_box(theory.solve(black_box(*creepage)));
        }
    });
    println!("{name} one {:e}", one / f64::from(calls));
    let columns: [Vec<f64>; 3] = [1.0, 0.5, 0.2]
        .map(|scale| (0..CASES).map(|k| scale * (k as f64 / CASES as f64 - 0.5)).collect());
    let many = best(batches, || batch(theory, &columns));
    println!("{name} many {many:e}");
    Ok(())
}

/// Forces and statuses of all cases as columns, by all cores; invalid creepage is looked for.
fn batch(theory: &dyn Theory, [xi, eta, chi]: &[Vec<f64>; 3]) -> Option<[Vec<f64>; 3]> {
    const PIECE: usize = 1024;
    let mut columns = [(); 3].map(|()| vec![0.0; xi.len()]);
    let mut statuses = vec![0_u8; xi.len()];
    let [fx, fy, mz] = &mut columns;
    (fx.par_chunks_mut(PIECE), fy.par_chunks_mut(PIECE), mz.par_chunks_mut(PIECE))
        .into_par_iter()
        .zip(statuses.par_chunks_mut(PIECE))
        .enumerate()
        .try_for_each(|(piece, ((fx, fy, mz), statuses))| {
            for k in 0..fx.len() {
                let at = piece * PIECE + k;
                let found = theory.solve(Creepage::new(xi[at], eta[at], chi[at]).ok()?);
                (fx[k], fy[k], mz[k]) = (found.force.fx, found.force.fy, found.force.mz);
                statuses[k] = found.status as u8;
            }
            Some(())
        })?;
    black_box(&statuses);
    Some(columns)
}

fn best<T>(runs: usize, work: impl Fn() -> T) -> f64 {
    let seconds = (0..runs).map(|_| {
        let start = Instant::now();
        black_box(work());
        start.elapsed().as_secs_f64()
    });
    seconds.fold(f64::INFINITY, f64::min)
}
