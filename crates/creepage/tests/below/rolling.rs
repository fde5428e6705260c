//! Below rolling contacts: the tractions of the full theory as elements.

use creepage::below::{Body, Element, Interior, Stress};
use creepage::rolling::Creepage;
use creepage::rolling::exact::{Exact, Resolution};

use crate::support::{contact, rows};

/// The pressure is Hertz's. The tangential tractions are those of the fine resolution, extrapolated as
/// the theory does its forces: four thirds of the finer grid's elements less a third of the coarser's.
fn interior(a_over_b: f64, creepage: Creepage) -> Interior {
    let (contact, solid) = contact(a_over_b, 0.28);
    let coarser = Resolution::new(20, 16).unwrap();
    let mut elements = vec![];
    for (resolution, weight) in [(Resolution::FINE, 4.0 / 3.0), (coarser, -1.0 / 3.0)] {
        let theory = Exact::new(a_over_b, 0.28, resolution).unwrap();
        let mut workspace = theory.workspace();
        theory.solve_with(creepage, &mut workspace);
        let c = contact.ellipse().c();
        for element in theory.element_fields(&workspace) {
            let [x, y] = element.point.traction.map(|part| 0.3 * weight * part);
            let corners = element.corners.map(|corner| corner.map(|length| c * length));
            elements.push(Element::new(&corners, [x, y, 0.0]).unwrap());
        }
    }
    let pressure = Interior::sliding(&contact, [0.0, 0.0], solid, Body::Lower).unwrap();
    pressure.with_elements(&elements)
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
        println!("{a_over_b} {xi} {eta} {chi}: {worst:.2e} beyond uncertainty");
        assert!(worst < 1e-3, "{a_over_b} {xi} {eta} {chi}: {worst:e}");
    }
}
