//! The error falls as it should, and is no larger than a table says.

use creepage::Contact;
use creepage::Theory;
use creepage::approximate::fastsim::{Fastsim, Settings};
use creepage::coulomb::{Exact, Resolution};
use creepage::table::{Axis, Intervals, Spec, Table, build};

use super::common::{contact, creepage};
use super::fixtures::{FASTSIM, Prepared, fastsim, quiet, smooth, spec};

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
