//! Cost of a thousand look-ups, at places all over a table as large as those of the full theory:
//! microseconds a thousand are nanoseconds each.
#![allow(missing_docs, clippy::unwrap_used)]

use creepage::InvalidValue;
use creepage::approximate::polach::Polach;
use creepage::table::{Axis, Intervals, Provenance, Slice, Spec, Table, build};
use creepage::{Contact, Creepage, Theory};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// Nodes along `a/b` and Poisson's ratio.
const SIZES: [[usize; 2]; 4] = [[1, 1], [5, 1], [9, 1], [9, 5]];

fn table([shapes, materials]: [usize; 2]) -> Table {
    let axis =
        |low, high, nodes| if nodes == 1 { Axis::fixed(low) } else { Axis { low, high, nodes } };
    let spec = Spec {
        a_over_b: axis(0.2, 5.0, shapes),
        poisson: axis(0.0, 0.5, materials),
        intervals: Intervals::default(),
        places: 1,
        provenance: Provenance::default(),
    };
    let prepare = |contact: &Contact| -> Result<Box<dyn Theory>, InvalidValue> {
        Ok(Box::new(Polach::new(contact)?))
    };
    build(&spec, prepare, &|| {}).unwrap()
}

/// 1000 creepages in every direction, from 0.01 to 100.
fn creepages() -> Vec<Creepage> {
    let size = |k: u32| 10_f64.powf(-2.0 + 4.0 * (0.618_034 * f64::from(k)).fract());
    (0..1000)
        .map(|k| {
            let (sin, cos) = (2.4 * f64::from(k)).sin_cos();
            let spin = (0.7 * f64::from(k)).sin();
            Creepage::new(size(k) * cos, size(k) * sin, size(k) * spin).unwrap()
        })
        .collect()
}

/// Between the nodes.
fn slice(table: &Table) -> Slice<'_> {
    let middle = |low: f64, high: f64| low + 0.37 * (high - low);
    let (shape, material) = (table.a_over_b(), table.poisson());
    table.at(middle(shape.low, shape.high), middle(material.low, material.high)).unwrap()
}

/// Shape and Poisson's ratio as before.
#[divan::bench(args = SIZES)]
fn force(bencher: Bencher, size: [usize; 2]) {
    let table = table(size);
    let (slice, places) = (slice(&table), creepages());
    bencher.bench_local(|| places.iter().map(|at| slice.force(black_box(*at)).fx).sum::<f64>());
}

/// The same with the derivative.
#[divan::bench(args = SIZES)]
fn force_and_derivative(bencher: Bencher, size: [usize; 2]) {
    let table = table(size);
    let (slice, places) = (slice(&table), creepages());
    bencher.bench_local(|| {
        let found = places.iter().map(|at| slice.force_and_derivative(black_box(*at)));
        found.map(|(force, derivative)| force.fx + derivative[0][0]).sum::<f64>()
    });
}

/// A new shape every time, as a wheel's contact has.
#[divan::bench(args = SIZES)]
fn slice_and_force(bencher: Bencher, size: [usize; 2]) {
    let table = table(size);
    let shape = shapes(&table);
    let places = creepages();
    bencher.bench_local(|| {
        let found = places.iter().map(|at| shape(black_box(at)).force(*at));
        found.map(|force| force.fx).sum::<f64>()
    });
}

/// The same with the derivative.
#[divan::bench(args = SIZES)]
fn slice_and_derivative(bencher: Bencher, size: [usize; 2]) {
    let table = table(size);
    let shape = shapes(&table);
    let places = creepages();
    bencher.bench_local(|| {
        let found = places.iter().map(|at| shape(black_box(at)).force_and_derivative(*at));
        found.map(|(force, derivative)| force.fx + derivative[0][0]).sum::<f64>()
    });
}

/// A shape for each creepage, at the first Poisson's ratio.
fn shapes<'t>(table: &'t Table) -> impl Fn(&Creepage) -> Slice<'t> {
    let (low, high, poisson) = (table.a_over_b().low, table.a_over_b().high, table.poisson().low);
    move |at| table.at((low * (1.0 + at.xi().abs())).min(high), poisson).unwrap()
}
