//! Cost of the half-space: preparing its equations, and evaluating slip.
#![allow(missing_docs, clippy::unwrap_used)] // A benchmark is no interface.

use creepage::Ellipse;
use creepage::halfspace::{
    DisplacementField, DisplacementLoad, Edge, LoadDisplacement, Polynomial, Traction, harmonics,
};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

fn ellipse() -> Ellipse {
    Ellipse::from_ratio(2.0).unwrap()
}

#[divan::bench(args = [5, 20, 40])]
fn prepare(degree: usize) -> LoadDisplacement {
    LoadDisplacement::new(black_box(ellipse()), black_box(0.28), degree).unwrap()
}

#[divan::bench(args = [5, 20])]
fn prepare_inverse(bencher: Bencher, degree: usize) {
    let equations = prepare(degree);
    bencher.bench_local(|| -> DisplacementLoad { black_box(&equations).inverse().unwrap() });
}

/// The elastic part of the slip in steady rolling, `du/dx` and `dv/dx`.
fn slip(degree: usize) -> DisplacementField {
    let table = |shift: f64| {
        (0..harmonics::polynomial_count(degree)).map(|i| (i as f64 + shift).sin()).collect()
    };
    let traction =
        Traction::from_harmonics(ellipse(), Edge::Vanishing, [table(0.0), table(0.5), vec![0.0]])
            .unwrap();
    DisplacementField::new(&traction.x_derivative().unwrap(), 0.28, 0.0).unwrap()
}

fn points(scale: f64) -> Vec<[f64; 2]> {
    let point = |i: u32| {
        let (r, f) = (scale * (f64::from(i) / 1000.0).sqrt(), 2.4 * f64::from(i));
        [r * ellipse().a() * f.cos(), r * ellipse().b() * f.sin()]
    };
    (0..1000).map(point).collect()
}

#[divan::bench(args = [3, 5, 20])]
fn slip_at_1000_points(bencher: Bencher, degree: usize) {
    let (field, points) = (slip(degree), points(1.0));
    bencher.bench_local(|| {
        black_box(&points).iter().fold([0.0; 2], |sum, point| {
            let [x, y, _] = field.at(*point);
            [sum[0] + x, sum[1] + y]
        })
    });
}

#[divan::bench(args = [3, 20])]
fn displacement_at_one_point_outside(bencher: Bencher, degree: usize) {
    let field = slip(degree);
    bencher.bench_local(|| field.at(black_box([2.0, 1.0])));
}

/// Hertz's pressure on unlike bodies, (6.4).
#[divan::bench]
fn coupling_at_one_point(bencher: Bencher) {
    let (none, one) = (Polynomial::zero(0), Polynomial::new(vec![1.0]).unwrap());
    let hertz = Traction::new(ellipse(), Edge::Vanishing, [&none, &none, &one]).unwrap();
    let field = DisplacementField::new(&hertz.x_derivative().unwrap(), 0.28, 0.1).unwrap();
    bencher.bench_local(|| field.at(black_box([0.3, 0.2])));
}
