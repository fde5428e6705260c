//! Planes by Fourier transform: the same sums as element by element.

use creepage::Solid;
use creepage::subsurface::{Body, Element, Grid, GridError, Interior};

use crate::support::apart;

#[test]
fn a_plane_is_its_points() {
    let (counts, steps) = ([7, 4], [0.3, 0.2]);
    let grid = Grid::new(counts, steps, 0.28, Body::Upper).unwrap();
    let traction = |k: usize| [0.2, 0.9, 2.3].map(|phase| (1.3 * k as f64 + phase).sin());
    let tractions: Vec<_> = (0..28).map(traction).collect();
    let middle = |k: usize| [(k % 7) as f64 * steps[0] - 0.8, (k / 7) as f64 * steps[1] + 0.1];
    let elements: Vec<_> =
        (0..28).map(|k| Element::rectangle(middle(k), steps, tractions[k]).unwrap()).collect();
    let interior =
        Interior::new(Solid::new(1.0, 0.28).unwrap(), Body::Upper).with_elements(&elements);
    let load = grid.load(&tractions).unwrap();
    for depth in [0.0, 0.05, 0.3, 2.0] {
        let plane = load.stress(depth).unwrap();
        assert_eq!(plane.len(), 28);
        for (k, found) in plane.iter().enumerate() {
            let [x, y] = middle(k);
            let expected = interior.stress([x, y, depth]).unwrap();
            // Rounding of the transform and of sides that do not join to the last bit.
            assert!(apart(found, &expected) < 1e-13, "{depth} {k}: {found:?} {expected:?}");
        }
    }
}

#[test]
fn nonsense_is_an_error() {
    assert!(matches!(
        Grid::new([0, 3], [1.0, 1.0], 0.3, Body::Lower),
        Err(GridError::Size { along: 0, across: 3 })
    ));
    assert!(matches!(Grid::new([1, 3], [1.0, 0.0], 0.3, Body::Lower), Err(GridError::Invalid(_))));
    let grid = Grid::new([1, 1], [1.0, 1.0], 0.3, Body::Lower).unwrap();
    assert!(matches!(grid.load(&[]), Err(GridError::Count { given: 0, needed: 1 })));
    assert!(grid.load(&[[0.0; 3]]).unwrap().stress(-1.0).is_err());
}
