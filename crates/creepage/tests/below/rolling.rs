//! Below rolling contacts: the tractions of the full theory as elements.

use creepage::below::{Body, Element, Interior, Stress};
use creepage::coulomb::{Exact, Resolution};
use creepage::{Contact, Creepage, Ellipse, Solved};

use crate::support::{contact, rows};

/// The pressure is Hertz's. The tangential tractions are those of the fine resolution, extrapolated from
/// its two grids as the theory does its forces, in quarters of the finer grid's elements.
fn interior(a_over_b: f64, creepage: Creepage) -> Interior {
    let (contact, solid) = contact(a_over_b, 0.28);
    let shape = Contact::new(Ellipse::from_ratio(a_over_b).unwrap(), 0.28).unwrap();
    let theory = Exact::new(&shape, Resolution::FINE).unwrap();
    let coarser = Exact::new(&shape, Resolution::new(20, 16).unwrap()).unwrap();
    let [fine, coarse] = [&theory, &coarser].map(|theory| theory.solve_contact(creepage));
    let quarters: Vec<_> =
        fine.elements().iter().flat_map(|element| quarters(element.corners)).collect();
    let middles: Vec<_> = quarters.iter().map(|corners| mean(corners)).collect();
    let tractions = fine.field(&middles).into_iter();
    let c = contact.ellipse().c();
    let elements: Vec<_> = tractions
        .zip(coarse.field(&middles))
        .zip(&quarters)
        .map(|((fine, coarse), corners)| {
            let beyond = |k: usize| (4.0 * fine.traction[k] - coarse.traction[k]) / 3.0;
            let corners = corners.map(|corner| corner.map(|length| c * length));
            Element::new(&corners, [0.3 * beyond(0), 0.3 * beyond(1), 0.0]).unwrap()
        })
        .collect();
    let pressure = Interior::sliding(&contact, [0.0, 0.0], solid, Body::Lower).unwrap();
    pressure.with_elements(&elements)
}

fn mean(points: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / points.len() as f64)
}

/// A quadrilateral cut at the middles of its sides.
fn quarters(corners: [[f64; 2]; 4]) -> [[[f64; 2]; 4]; 4] {
    let side = |k: usize| mean(&[corners[k % 4], corners[(k + 1) % 4]]);
    [0, 1, 2, 3].map(|k| [corners[k], side(k), mean(&corners), side(k + 3)])
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
