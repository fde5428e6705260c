//! Tables of cheap theories: order of convergence, symmetry, derivative, smoothness, monotony,
//! files.

// What symmetry gives is exact; statics and a constant theory are fixtures.
#![allow(clippy::float_cmp, clippy::unwrap_used, clippy::unnecessary_wraps)]

mod common;

use std::sync::LazyLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use common::{contact, creepage};
use creepage::InvalidValue;
use creepage::approximate::fastsim::{Fastsim, Settings};
use creepage::approximate::linear::Linear;
use creepage::approximate::saturated::Saturated;
use creepage::approximate::vermeulen_johnson::VermeulenJohnson;
use creepage::coulomb::{Exact, Resolution};
use creepage::table::{Axis, BuildError, FileError, Intervals, Provenance, Spec, Table, build};
use creepage::theory::Evaluated;
use creepage::{
    Contact, Creepage, FieldPoint, Force, Jacobian, Solution, Solved, Statistics, Status, Theory,
};
use proptest::prelude::*;

type Prepared = Result<Box<dyn Theory>, InvalidValue>;

/// A force that saturates as `tanh` does, with a pole of spin that weakens it: analytic, so that
/// the order of convergence shows, and with the symmetries of the contact.
struct Smooth(Contact);

impl Theory for Smooth {
    fn contact(&self) -> &Contact {
        &self.0
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        let [xi, eta, chi] = creepage.components();
        let per_size = (1.0 + xi * xi + eta * eta + 0.5 * chi * chi).sqrt().recip();
        let force = Force {
            fx: xi * per_size,
            fy: (eta + 0.4 * chi) * per_size * (1.0 + xi * xi * per_size * per_size) * 0.5,
            mz: (chi - 0.4 * eta) * per_size,
        };
        let statistics = Statistics::default();
        Solution { force, error: None, status: Status::Solved, statistics }
    }

    fn jacobian(&self, _: Creepage) -> Option<Jacobian> {
        None
    }

    fn field(&self, _: Creepage, _: &[[f64; 2]]) -> Vec<FieldPoint> {
        Vec::new()
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Evaluated::boxed(self, creepage)
    }
}

fn smooth(contact: &Contact) -> Prepared {
    Ok(Box::new(Smooth(*contact)))
}

fn fastsim(contact: &Contact) -> Prepared {
    let settings = Settings { grid: [30; 2], ..Settings::default() };
    Ok(Box::new(Fastsim::new(contact, settings)?))
}

fn spec(intervals: [usize; 3], places: usize) -> Spec {
    let [theta, phi, t] = intervals;
    let provenance = Provenance {
        theory: "fastsim".into(),
        options: "grid = [30, 30]".into(),
        program: "test".into(),
    };
    Spec {
        a_over_b: Axis::fixed(1.0),
        poisson: Axis::fixed(0.28),
        intervals: Intervals { theta, phi, t },
        places,
        provenance,
    }
}

fn quiet() {}

static FASTSIM: LazyLock<Table> =
    LazyLock::new(|| build(&spec([8, 12, 20], 500), fastsim, &quiet).unwrap());

/// A range of both: some hundredths of a second.
static RANGES: LazyLock<Table> = LazyLock::new(|| {
    let ranges = Spec {
        a_over_b: Axis { low: 0.5, high: 2.0, nodes: 5 },
        poisson: Axis { low: 0.0, high: 0.5, nodes: 3 },
        ..spec([6, 8, 12], 240)
    };
    let cubic = |contact: &Contact| -> Prepared {
        let law = creepage::approximate::shen_hedrick_elkins::ShenHedrickElkins::new(contact);
        Ok(Box::new(law?))
    };
    build(&ranges, cubic, &quiet).unwrap()
});

/// Fourth order: halving all steps divides the error by 16; 10 leaves room for the coarse table's
/// being not quite in the asymptotic range.
#[test]
fn the_error_falls_with_the_fourth_power_of_the_step() {
    let worst = |n: usize| {
        let accuracy = build(&spec([n, 2 * n, 2 * n], 1000), smooth, &quiet).unwrap().accuracy();
        [accuracy.force, accuracy.moment].map(|spread| spread.p95)
    };
    let [coarse, fine] = [worst(8), worst(16)];
    for i in 0..2 {
        assert!(coarse[i] > 10.0 * fine[i], "{coarse:?} {fine:?}");
        assert!(fine[i] < 1e-4, "{fine:?}");
    }
}

/// The measured bound is of places of its own: others, of another distribution, err no more.
#[test]
fn the_measured_error_holds_elsewhere() {
    let accuracy = FASTSIM.accuracy();
    // The theory's own ripple, of strong spin over 30 x 30 cells, is a per cent or two.
    assert!([accuracy.places, accuracy.hard_places] == [500; 2] && accuracy.force.median < 0.001);
    assert!(accuracy.force.worst < 0.02, "{accuracy:?}");
    holds_elsewhere(&FASTSIM, &*fastsim(&contact(1.0, 0.28)).unwrap(), 2000);
}

/// The error at `count` places from small creepage to large is less than the table says.
fn holds_elsewhere(table: &Table, theory: &dyn Theory, count: i32) {
    let slice = table.at(table.a_over_b().low, 0.28).unwrap();
    let bound = table.accuracy().force.worst;
    for k in 0..count {
        let step = 4.0 / f64::from(count);
        let (size, angle) = (10_f64.powf(-2.0 + step * f64::from(k)), 0.1 + f64::from(k));
        let (sin, cos) = angle.sin_cos();
        let spin = size * (0.3 * f64::from(k)).sin();
        let creepage = creepage(size * cos, size * sin, spin);
        let (found, right) = (slice.force(creepage), theory.solve(creepage).force);
        let error = (found.fx - right.fx).hypot(found.fy - right.fy);
        assert!(error < bound, "{creepage:?}: {error}");
    }
}

/// FASTSIM on a grid so fine that its ripple does not count: half a per cent of `mu N`, the aim of
/// a table at the default intervals.
#[test]
fn the_default_intervals_are_good_for_half_a_per_cent() {
    let fine = |contact: &Contact| -> Prepared {
        let settings = Settings { grid: [200; 2], ..Settings::default() };
        Ok(Box::new(Fastsim::new(contact, settings)?))
    };
    for ratio in [0.2, 1.0] {
        let default = Spec { intervals: Intervals::default(), ..spec([4, 4, 4], 500) };
        let default = Spec { a_over_b: Axis::fixed(ratio), ..default };
        let table = build(&default, fine, &quiet).unwrap();
        let force = table.accuracy().force;
        assert!(force.worst < 0.005 && force.p99 < 0.002 && force.median < 1e-5, "{force:?}");
        holds_elsewhere(&table, &*fine(&contact(ratio, 0.28)).unwrap(), 1000);
    }
}

/// The full theory in a long contact, where its force turns most sharply, with its fewest elements
/// for speed: their ripple under strong spin is one per cent to two.
#[test]
fn a_table_of_the_full_theory_errs_no_more_than_it_says() {
    let exact =
        |contact: &Contact| -> Prepared { Ok(Box::new(Exact::new(contact, Resolution::FAST)?)) };
    let long = Spec { a_over_b: Axis::fixed(2.0), ..spec([12, 12, 24], 300) };
    let table = build(&long, exact, &quiet).unwrap();
    let force = table.accuracy().force;
    assert!(force.worst < 0.025 && force.p95 < 0.005 && force.median < 5e-4, "{force:?}");
    assert_eq!(table.doubtful(), 0);
    holds_elsewhere(&table, &*exact(&contact(2.0, 0.28)).unwrap(), 600);
}

#[test]
fn at_a_node_the_table_is_the_theory() {
    let theory = fastsim(&contact(1.0, 0.28)).unwrap();
    let slice = FASTSIM.at(1.0, 0.28).unwrap();
    // By the scales of a circle t = 1/2 and phi = 0, pi/2; pi/4 is a node of both angles, too.
    let (pure, half) = (2.0, 2.0_f64.sqrt());
    for [xi, eta, chi] in [[pure, 0.0, 0.0], [0.0, pure, 0.0], [0.0, 0.0, pure], [half, 0.0, half]]
    {
        let creepage = creepage(xi, eta, chi);
        let (found, right) = (slice.force(creepage), theory.solve(creepage).force);
        let off = [found.fx - right.fx, found.fy - right.fy, found.mz - right.mz];
        // Nodes are kept to seven digits.
        assert!(off.iter().all(|off| off.abs() < 1e-6), "{off:?}");
    }
}

fn any_creepage() -> impl Strategy<Value = Creepage> {
    let size = || (-3.0..3.0_f64, any::<bool>());
    let signed = |(power, negative): (f64, bool)| {
        if negative { -(10_f64.powf(power)) } else { 10_f64.powf(power) }
    };
    (size(), size(), size()).prop_map(move |(x, y, z)| creepage(signed(x), signed(y), signed(z)))
}

proptest! {
    /// (4.28), to the last bit.
    #[test]
    fn mirror_images_have_mirror_forces(at in any_creepage()) {
        for table in [&FASTSIM, &RANGES] {
            let slice = table.at(1.0, 0.28).unwrap();
            let force = slice.force(at);
            let along = slice.force(creepage(-at.xi(), at.eta(), at.chi()));
            prop_assert_eq!(along, Force { fx: -force.fx, ..force });
            let across = slice.force(creepage(at.xi(), -at.eta(), -at.chi()));
            prop_assert_eq!(across, Force { fy: -force.fy, mz: -force.mz, ..force });
        }
    }

    /// Central differences; their own error is of order `h^2` times the third derivative, which
    /// jumps from cell to cell, but for creepages near zero a relative step keeps it small.
    #[test]
    fn the_derivative_is_that_of_the_force(at in any_creepage()) {
        for table in [&FASTSIM, &RANGES] {
            let slice = table.at(1.0, 0.28).unwrap();
            let (force, derivative) = slice.force_and_derivative(at);
            prop_assert_eq!(force, slice.force(at));
            let v = [at.xi(), at.eta(), at.chi()];
            for k in 0..3 {
                let h = 1e-5 * v[k].abs();
                let side = |h: f64| {
                    let mut moved = v;
                    moved[k] += h;
                    let f = slice.force(creepage(moved[0], moved[1], moved[2]));
                    [f.fx, f.fy, f.mz]
                };
                let (ahead, behind) = (side(h), side(-h));
                for i in 0..3 {
                    let difference = (ahead[i] - behind[i]) / (2.0 * h);
                    let off = (derivative[i][k] - difference).abs() * v[k].abs();
                    prop_assert!(off < 1e-4, "{i} {k} {} {difference}", derivative[i][k]);
                }
            }
        }
    }

    /// A continuous derivative: across the planes without spin and without `xi`, and across the
    /// axis of pure spin, it is the same from either side.
    #[test]
    fn the_derivative_does_not_jump(x in 0.01..20.0_f64, y in 0.01..20.0_f64, angle in 0.0..6.2_f64) {
        let slice = FASTSIM.at(1.0, 0.28).unwrap();
        let small = 1e-9;
        let (sin, cos) = angle.sin_cos();
        for [one, two] in [
            [[x, y, small], [x, y, -small]],
            [[small, x, y], [-small, x, y]],
            [[small * cos, small * sin, x], [small, 0.0, x]],
            // At zero.
            [[small * cos, small * sin, small], [small, 0.0, -small]],
        ] {
            let [one, two] = [one, two].map(|[xi, eta, chi]| {
                slice.force_and_derivative(creepage(xi, eta, chi)).1
            });
            for (one, two) in one.as_flattened().iter().zip(two.as_flattened()) {
                // Nodes are kept to seven digits; near zero slopes are divided by t.
                prop_assert!((one - two).abs() < 2e-5 * (1.0 + one.abs()), "{one} {two}");
            }
        }
    }

    #[test]
    fn any_creepage_has_a_finite_force(
        xi in -Creepage::MAX..Creepage::MAX, eta in -1e-300..1e-300_f64, chi in -1e9..1e9_f64,
    ) {
        let slice = FASTSIM.at(1.0, 0.28).unwrap();
        for at in [[xi, eta, chi], [eta, xi, chi], [eta, chi, xi], [0.0, eta, 0.0]] {
            let at = creepage(at[0], at[1], at[2]);
            let (force, derivative) = slice.force_and_derivative(at);
            prop_assert!(force.magnitude() < 1.01 && force.mz.abs() < 2.0);
            prop_assert!(derivative.as_flattened().iter().all(|d| d.is_finite()));
        }
    }
}

/// Without spin the force along a ray rises to full sliding: between nodes too.
#[test]
fn without_spin_the_force_rises_with_creepage() {
    let slice = FASTSIM.at(1.0, 0.28).unwrap();
    let mut last = [0.0; 2];
    for k in 1..20_000 {
        let size = 0.0005 * f64::from(k);
        let along = slice.force(creepage(size, 0.0, 0.0));
        let across = slice.force(creepage(0.0, size, 0.0));
        assert!([along.fy, along.mz, across.fx].iter().all(|zero| *zero == 0.0));
        // Rounding of a sum of terms of order one.
        assert!(along.fx > last[0] - 1e-15 && across.fy > last[1] - 1e-15, "{size}");
        last = [along.fx, across.fy];
    }
    let end = creepage(10.0, 0.0, 0.0);
    let right = fastsim(&contact(1.0, 0.28)).unwrap().solve(end).force.fx;
    // The slope of the error between nodes, here where the force hardly changes.
    assert!((last[0] - right).abs() < 1e-4, "{last:?} {right}");
}

/// For vanishing creepage a table of FASTSIM is linear theory, whose coefficients are FASTSIM's
/// to the error of its cells.
#[test]
fn near_zero_the_derivative_is_that_of_linear_theory() {
    let linear = Linear::new(&contact(1.0, 0.28)).unwrap().jacobian(Creepage::default()).unwrap();
    let slice = FASTSIM.at(1.0, 0.28).unwrap();
    let (force, found) = slice.force_and_derivative(Creepage::default());
    assert_eq!(force, Force::default());
    for [i, k] in [[0, 0], [1, 1], [1, 2]] {
        assert!((found[i][k] / linear[i][k] - 1.0).abs() < 0.01, "{found:?} {linear:?}");
    }
}

/// The table of ranges at a node agrees with one that is built for it alone; between nodes, and
/// between shapes, with its own measure of error.
#[test]
fn a_table_of_ranges_holds_the_tables_of_its_nodes() {
    let one = Spec { a_over_b: Axis::fixed(2.0), ..spec([6, 8, 12], 0) };
    let one = Spec { poisson: Axis::fixed(0.25), ..one };
    let cubic = |contact: &Contact| -> Prepared {
        let law = creepage::approximate::shen_hedrick_elkins::ShenHedrickElkins::new(contact);
        Ok(Box::new(law?))
    };
    let alone = build(&one, cubic, &quiet).unwrap();
    let at = creepage(0.4, -0.3, 0.1);
    let found = RANGES.at(2.0, 0.25).unwrap().force(at);
    let right = alone.at(2.0, 0.25).unwrap().force(at);
    assert!((found.fx - right.fx).abs() < 1e-6 && (found.fy - right.fy).abs() < 1e-6);
    let accuracy = RANGES.accuracy();
    assert!(accuracy.places == 240 && accuracy.force.p95 < 0.02, "{accuracy:?}");
    // 24 theories at random, and 8 half-way between the nodes.
    assert_eq!(accuracy.hard_places, 240);
    assert_eq!(RANGES.at(2.1, 0.25).unwrap_err().quantity, "a_over_b");
    assert_eq!(RANGES.at(1.0, f64::NAN).unwrap_err().quantity, "poisson");
}

/// Without spin the bounds of slopes are found anew, which may move them a little; else the table
/// for one Poisson's ratio is the same to the seven digits of its nodes.
#[test]
fn a_table_for_one_material_is_the_table_there() {
    let one = RANGES.with_poisson(0.31).unwrap();
    for k in 0..200 {
        let (sin, cos) = (0.7 * f64::from(k)).sin_cos();
        let at = creepage(0.01 * f64::from(k) * cos, 0.5 * sin, 2.0);
        let [found, right] = [&one, &*RANGES].map(|table| table.at(0.8, 0.31).unwrap().force(at));
        assert!((found.fx - right.fx).abs() < 1e-6 && (found.fy - right.fy).abs() < 1e-6);
    }
    assert_eq!(one.poisson(), Axis::fixed(0.31));
    assert!(one.at(0.8, 0.28).is_err());
    assert_eq!(RANGES.with_poisson(0.51).unwrap_err().quantity, "poisson");
}

#[test]
fn a_theory_without_a_table_is_refused() {
    let small = spec([4, 4, 4], 10);
    let saturated = |contact: &Contact| -> Prepared { Ok(Box::new(Saturated::new(contact)?)) };
    let error = build(&small, saturated, &quiet).unwrap_err();
    assert!(matches!(error, BuildError::NotLinearAtZero { .. }), "{error}");
    let linear = |contact: &Contact| -> Prepared { Ok(Box::new(Linear::new(contact)?)) };
    let error = build(&small, linear, &quiet).unwrap_err();
    assert!(matches!(error, BuildError::Unbounded { .. }), "{error}");
    let error = build(&Spec { a_over_b: Axis::fixed(-1.0), ..small }, linear, &quiet).unwrap_err();
    assert!(matches!(error, BuildError::Invalid(_)), "{error}");
    for intervals in [[3, 4, 4], [4, 5, 4], [4, 4, 0], [4, 4, 401]] {
        assert!(build(&spec(intervals, 0), linear, &quiet).is_err());
    }
}

/// Vermeulen and Johnson's theory says of itself that it knows no spin.
#[test]
fn nodes_that_the_theory_doubts_are_counted_and_every_step_is_told() {
    let small = spec([4, 4, 4], 10);
    let steps = AtomicUsize::new(0);
    let count = || {
        steps.fetch_add(1, Ordering::Relaxed);
    };
    let law = |contact: &Contact| -> Prepared { Ok(Box::new(VermeulenJohnson::new(contact)?)) };
    let table = build(&small, law, &count).unwrap();
    assert_eq!(steps.into_inner(), small.steps());
    // Of the line of pure spin and three rows of five lines, four nodes each.
    assert_eq!(table.doubtful(), 4 * (1 + 3 * 5));
}

#[test]
fn a_file_gives_the_table_back() {
    for table in [&*FASTSIM, &*RANGES] {
        let again = Table::from_bytes(table.to_bytes().unwrap()).unwrap();
        assert_eq!(again.provenance(), table.provenance());
        assert_eq!(again.accuracy(), table.accuracy());
        assert_eq!(again.intervals(), table.intervals());
        for k in 0..50 {
            let at = creepage(0.1 * f64::from(k), 0.3, -0.7);
            let [one, two] =
                [table, &again].map(|table| table.at(1.0, 0.28).unwrap().force_and_derivative(at));
            assert_eq!(one, two);
        }
    }
}

/// A file of an earlier format, which said nothing of it, or of a later one is refused with the
/// reason.
#[test]
fn a_file_of_another_format_is_refused() {
    let bytes = build(&spec([4, 4, 4], 10), fastsim, &quiet).unwrap().to_bytes().unwrap();
    // Name, padded to four bytes; kind 4, one number, and the number.
    let name = bytes.windows(8).position(|eight| eight == b"format\0\0").unwrap();
    for (at, byte, right) in [(name, b'F', 1), (name + 19, 7, 7)] {
        let mut other = bytes.clone();
        other[at] = byte;
        let body = other.len() - 4;
        let sum = crc32fast::hash(&other[..body]);
        other[body..].copy_from_slice(&sum.to_be_bytes());
        let error = Table::from_bytes(other).unwrap_err();
        assert!(matches!(error, FileError::Format { found } if found == right), "{error}");
        assert!(error.to_string().contains("build the table again"));
    }
}

/// Cut anywhere or with any one bit changed, a file is refused.
#[test]
fn a_damaged_file_is_refused() {
    let small = build(&spec([4, 4, 4], 10), fastsim, &quiet).unwrap();
    let bytes = small.to_bytes().unwrap();
    assert!(Table::from_bytes(bytes.clone()).is_ok());
    for length in (0..bytes.len()).step_by(97) {
        let error = Table::from_bytes(bytes[..length].to_vec()).unwrap_err();
        assert!(matches!(error, FileError::Damaged), "{error}");
    }
    for place in (0..bytes.len()).step_by(53) {
        let mut changed = bytes.clone();
        changed[place] ^= 1 << (place % 8);
        assert!(matches!(Table::from_bytes(changed), Err(FileError::Damaged)));
    }
}
