//! Cost of the full theory. With an argument it prints instead, over random cases that are the same
//! on every machine,
//!
//! - `cargo bench --bench exact -- random 100000`: failures and costs over the whole range,
//! - `cargo bench --bench exact -- accuracy 300`: errors and error bars against 96 x 80 elements, over the whole
//!   range and at small creepage, of other cases with a further number, against others with two more
//!   (`accuracy 150 7 72 60`),
//! - `cargo bench --bench exact -- smoothness 50`: ripples along lines of creepage, with further numbers those
//!   of so many elements along and across (`smoothness 50 40 34`: what of them is in the force itself),
//! - `cargo bench --bench exact -- border 60`: the border of adhesion against 96 x 80 elements, with further
//!   numbers against others (`border 24 109 91`: how sure those of 96 x 80 are).
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout)]

mod accuracy;
mod border;
mod cost;
mod random;
mod smoothness;

use creepage::coulomb::{Exact, Resolution};
use creepage::theory::Solved;
use creepage::{Contact, Creepage, Ellipse, Jacobian, Solution, Theory};
use divan::{Bencher, black_box};

fn main() {
    let named = |argument: &String| !argument.starts_with("--");
    let arguments: Vec<String> = std::env::args().skip(1).filter(named).collect();
    let count = || arguments[1].parse().unwrap();
    let elements_from = |first: usize, named: Resolution| {
        let at = |k: usize| arguments.get(k).map(|n| n.parse().unwrap());
        let given = at(first).zip(at(first + 1));
        given.map_or(named, |(along, across)| Resolution::new(along, across).unwrap())
    };
    let elements = |named: Resolution| elements_from(2, named);
    match arguments.first().map(String::as_str) {
        Some("random") => cost::print(count()),
        Some("accuracy") => {
            let draw = arguments.get(2).map_or(0, |draw| draw.parse().unwrap());
            let finest = elements_from(3, finest());
            accuracy::print(count(), draw, finest);
        }
        Some("border") => border::print(count(), elements(finest())),
        Some("smoothness") => smoothness::print(count(), elements(Resolution::STANDARD)),
        _ => divan::main(),
    }
}

const RESOLUTIONS: [(&str, Resolution); 3] =
    [("fast", Resolution::FAST), ("standard", Resolution::STANDARD), ("fine", Resolution::FINE)];

/// What stands for the truth.
fn finest() -> Resolution {
    Resolution::new(96, 80).unwrap()
}

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

/// Just below and just above the `kappa/mu` from which there are half as many more elements along.
const UNLIKE: [f64; 2] = [0.09, 0.11];

fn unlike(kappa_over_mu: f64) -> Exact {
    let contact = Contact::new(Ellipse::from_ratio(0.5).unwrap(), 0.28).unwrap();
    let contact = contact.with_kappa_over_mu(kappa_over_mu).unwrap();
    Exact::new(&contact, Resolution::STANDARD).unwrap()
}

#[divan::bench(args = UNLIKE, sample_count = 20)]
fn prepare_unlike(kappa_over_mu: f64) -> Exact {
    unlike(kappa_over_mu)
}

#[divan::bench(args = UNLIKE, sample_count = 20)]
fn solve_unlike(bencher: Bencher, kappa_over_mu: f64) {
    let theory = unlike(kappa_over_mu);
    bencher.bench_local(|| -> Solution { theory.solve(black_box(figure_12(1.7))) });
}
