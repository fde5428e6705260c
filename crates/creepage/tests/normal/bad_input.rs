//! What makes no sense is an error that says what and where.

use creepage::gap::{Gap, GapError, Rolling, Term};
use creepage::normal::{NormalContact, NormalError, Resolution, Side};

use crate::support::{MM, function, polynomial, steel};

fn solve(gap: &Gap, approach: f64) -> Result<NormalContact, NormalError> {
    NormalContact::at_approach(gap, steel(), approach, Resolution::FAST)
}

#[test]
fn gaps_that_never_touch() {
    let gap = polynomial(&[(0, 0, 0.01), (2, 0, 1e-3), (0, 2, 1e-3)]);
    match solve(&gap, 9e-6) {
        Err(NormalError::NoContact { least_gap, .. }) => {
            assert!((least_gap - 10e-6).abs() < 1e-9, "{least_gap}");
        }
        other => panic!("{other:?}"),
    }
    let negative = solve(&polynomial(&[(2, 0, 1e-3), (0, 2, 1e-3)]), -1e-6);
    assert!(matches!(negative, Err(NormalError::NoContact { .. })), "{negative:?}");
}

/// A section on one locus, as of a wheel that others hold off its rail.
#[test]
fn sections_that_never_touch() {
    let y: Vec<f64> = (-10..=10).map(|i| f64::from(i) * MM).collect();
    let gap: Vec<f64> = y.iter().map(|y| 5e-6 + y * y).collect();
    let gap = Gap::section(&y, &gap, Rolling::Radius(0.46)).unwrap();
    match solve(&gap, 4e-6) {
        Err(NormalError::NoContact { least_gap, .. }) => {
            assert!((least_gap - 5e-6).abs() < 1e-9, "{least_gap}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn lines_and_conformal_bodies() {
    for gap in [
        polynomial(&[(2, 0, 1e-3)]),
        polynomial(&[(0, 0, 0.0)]),
        polynomial(&[(1, 0, 1e-3)]),
        polynomial(&[(2, 0, 1e-3), (0, 2, -1e-3)]),
    ] {
        let found = solve(&gap, 1e-5);
        assert!(matches!(found, Err(NormalError::Unbounded { .. })), "{found:?}");
    }
}

/// The error says how much further the grid must go: with that much more it is solved.
#[test]
fn contact_at_the_side_of_the_grid() {
    let h = |x: f64, y: f64| (x * x + (y - 1.0).powi(2)) / 400.0;
    let gap = function([-4.0, 4.0], [-4.0, 2.0], h);
    match solve(&gap, 20e-6) {
        Err(NormalError::ReachesEdge { side: Side::HighY, beyond }) => {
            let high = 2.0 + beyond / MM;
            assert!(beyond > 0.5 * MM && beyond < 4.0 * MM, "{beyond}");
            assert!(solve(&function([-4.0, 4.0], [-4.0, high], h), 20e-6).is_ok());
        }
        other => panic!("{other:?}"),
    }
    let loaded = NormalContact::under_load(&gap, steel(), 1e9, Resolution::FAST);
    assert!(matches!(loaded, Err(NormalError::ReachesEdge { .. })), "{loaded:?}");
}

#[test]
fn gaps_that_are_not_numbers() {
    let gap = function([-4.0, 4.0], [-4.0, 4.0], |x, y| if x > 1.0 { f64::NAN } else { x * x + y });
    assert!(matches!(solve(&gap, 1e-5), Err(NormalError::NotFinite { .. })));
    let round = polynomial(&[(2, 0, 1e-3), (0, 2, 1e-3)]);
    assert!(matches!(solve(&round, f64::NAN), Err(NormalError::Invalid(_))));
    let load = NormalContact::under_load(&round, steel(), -1.0, Resolution::FAST);
    assert!(matches!(load, Err(NormalError::Invalid(_))));
}

#[test]
fn points_that_make_no_section() {
    let section = |y: &[f64], h: &[f64]| Gap::section(y, h, Rolling::Radius(0.5)).unwrap_err();
    let twice = section(&[0.0, 1.0, 2.0, 1.0], &[0.0; 4]);
    assert_eq!(twice, GapError::SameY { y: 1.0 });
    assert!(matches!(section(&[0.0, 1.0], &[0.0; 2]), GapError::TooFew { count: 2, .. }));
    assert!(matches!(section(&[0.0, 1.0, 2.0], &[0.0; 2]), GapError::Lengths { count: 2, .. }));
    let nan = section(&[0.0, 1.0, 2.0], &[0.0, f64::NAN, 0.0]);
    assert!(matches!(nan, GapError::NotFinite { quantity: "gap", index: 1, .. }));
    let radius = Gap::section(&[0.0, 1.0, 2.0], &[0.0; 3], Rolling::Radius(-1.0));
    assert!(matches!(radius, Err(GapError::Invalid(_))));
}

#[test]
fn points_that_make_no_grid() {
    let full: Vec<[f64; 3]> =
        (0..12).map(|i| [f64::from(i % 4), f64::from(i / 4), 0.1 * f64::from(i)]).collect();
    assert!(Gap::grid(&full).is_ok());
    let mut twice = full.clone();
    twice[5] = twice[6];
    assert_eq!(Gap::grid(&twice).unwrap_err(), GapError::SamePlace { x: 2.0, y: 1.0 });
    let hole = Gap::grid(&full[..11]).unwrap_err();
    assert!(matches!(hole, GapError::Hole { columns: 4, rows: 3, count: 11, .. }), "{hole:?}");
    assert!(matches!(Gap::grid(&full[..8]), Err(GapError::TooFew { quantity: "y", .. })));
    assert!(matches!(Gap::grid(&[]), Err(GapError::TooFew { .. })));
    let scattered: Vec<[f64; 3]> =
        (0..2000).map(|i| [f64::from(i), f64::from(i * 7 % 2000), 0.0]).collect();
    assert!(matches!(Gap::grid(&scattered), Err(GapError::Hole { .. })));
}

#[test]
fn terms_that_make_no_polynomial() {
    let term = |x, y, coefficient| Term { x, y, coefficient };
    let twice = Gap::polynomial(&[term(2, 0, 1.0), term(2, 0, 1.0)]).unwrap_err();
    assert_eq!(twice, GapError::SameTerm { x: 2, y: 0 });
    assert!(matches!(Gap::polynomial(&[term(99, 0, 1.0)]), Err(GapError::Power { .. })));
    assert!(matches!(Gap::polynomial(&[term(1, 0, f64::NAN)]), Err(GapError::Invalid(_))));
}
