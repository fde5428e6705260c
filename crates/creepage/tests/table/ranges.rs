//! Tables over shapes and Poisson's ratios.

use creepage::table::{Axis, Spec, build};

use super::common::creepage;
use super::fixtures::{RANGES, cubic, quiet, spec};

/// The table of ranges at a node agrees with one that is built for it alone; between nodes, and
/// between shapes, with its own measure of error.
#[test]
fn a_table_of_ranges_holds_the_tables_of_its_nodes() {
    let one = Spec { a_over_b: Axis::fixed(2.0), ..spec([6, 8, 12], 1) };
    let one = Spec { poisson: Axis::fixed(0.25), ..one };
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
