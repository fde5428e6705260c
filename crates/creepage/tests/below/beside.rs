//! Slip beside the contact: (4.39), (4.41).

use creepage::halfspace::{DisplacementField, Edge};
use creepage::subsurface::SurfaceSlip;

use crate::support::cubic;

/// Times the square root of the distance, the slip outside goes over into (4.41).
#[test]
fn the_slip_near_the_edge_has_the_strength_of_4_41() {
    let slip = SurfaceSlip::new(&cubic(0.7, Edge::Singular), 0.3).unwrap();
    for angle in [0.3, 1.2, 2.2, 3.0, 4.5, 5.6] {
        let edge = slip.at_edge(angle);
        let near = [1e-4, 1e-6].map(|distance| {
            let at = [0, 1].map(|k| edge.position[k] - distance * edge.inward[k]);
            slip.slope(at).unwrap().map(|part| part * f64::sqrt(distance))
        });
        for k in 0..2 {
            let [far, close] = near.map(|slip| (slip[k] - edge.slip[k]).abs());
            // What is left is bounded slip, times the square root of the distance.
            assert!(close < 0.02 && close < 0.2 * far + 1e-6, "{angle}: {near:?} {edge:?}");
        }
    }
}

/// The slope is that of the displacement field, inside and outside.
#[test]
fn the_slope_is_the_derivative_of_the_displacement() {
    for edge in [Edge::Singular, Edge::Vanishing] {
        let traction = cubic(0.7, edge);
        let slip = SurfaceSlip::new(&traction, 0.3).unwrap();
        let field = DisplacementField::new(&traction, 0.3, 0.0).unwrap();
        for [x, y] in [[0.2, 0.3], [-0.6, 0.4], [1.4, 0.2], [-0.3, 2.0], [0.9, -1.3]] {
            let at = |step: f64| field.at([x + step, y]);
            let found = slip.slope([x, y]).unwrap();
            for k in 0..2 {
                let step = 1e-3;
                let near = at(step)[k] - at(-step)[k];
                let far = at(2.0 * step)[k] - at(-2.0 * step)[k];
                let expected = (8.0 * near - far) / (12.0 * step);
                assert!((found[k] - expected).abs() < 1e-7, "{x} {y}: {found:?} {expected}");
            }
        }
    }
}

/// A traction that vanishes at the edge has no strength there.
#[test]
fn no_strength_without_singularity() {
    let slip = SurfaceSlip::new(&cubic(0.7, Edge::Vanishing), 0.3).unwrap();
    assert_eq!(slip.at_edge(1.0).slip, [0.0; 2]);
}
