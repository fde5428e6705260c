//! Below rolling contacts: the tractions of the full theory as elements.

use creepage::coulomb::{Exact, Resolution};
use creepage::subsurface::{Body, Interior, Stress};
use creepage::{Creepage, Theory};

use crate::support::{contact, rows};

/// The field below the fine resolution's tractions.
fn interior(a_over_b: f64, creepage: Creepage) -> Interior {
    let (hertz, solid) = contact(a_over_b, 0.28);
    let contact = hertz.with_friction(0.3).unwrap();
    let theory = Exact::new(&contact, Resolution::FINE).unwrap();
    let solved = theory.solved(creepage);
    Interior::rolling(&hertz, &contact, &*solved, solid, Body::Lower).unwrap()
}

/// 36 points: within 1e-3 of the peak pressure beyond the reference's uncertainty.
#[test]
fn reference_points() {
    let rows = rows(include_str!("rolling.csv"));
    assert_eq!(rows.len(), 36);
    for case in rows.chunk_by(|one, two| one[..4] == two[..4]) {
        let [a_over_b, xi, eta, chi] = [0, 1, 2, 3].map(|i| case[0][i]);
        let interior = interior(a_over_b, Creepage::new(xi, eta, chi).unwrap());
        let minor = (1.0 / a_over_b).min(1.0);
        let mut worst = 0.0_f64;
        for row in case {
            let point = [row[4], row[5] / a_over_b, row[6] * minor];
            let found = interior.stress(point).unwrap();
            let expected = Stress::from_components([7, 8, 9, 10, 11, 12].map(|i| row[i]));
            let apart = found.plus(-1.0, &expected).components();
            for (k, apart) in apart.into_iter().enumerate() {
                worst = worst.max(apart.abs() - row[13 + k]);
            }
        }
        assert!(worst < 1e-3, "{a_over_b} {xi} {eta} {chi}: {worst:e}");
    }
}
