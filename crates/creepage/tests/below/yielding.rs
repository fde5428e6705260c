//! First yield below a circle that slides: peak pressure over the shear yield stress.

use creepage::below::{Body, Stress, largest};

use crate::support::sliding;

/// Coarse grids of points gave 2.80, 2.63 and 2.39 for von Mises's law; the depth for no friction is
/// .48 of the radius, and for mu = .4 the surface.
#[test]
fn first_yield_of_a_sliding_circle() {
    for (mu, expected, depth) in [(0.0, 2.80, 0.48), (0.3, 2.63, 0.41), (0.4, 2.39, 0.0)] {
        let interior = sliding(1.0, 0.3, [mu, 0.0], Body::Lower);
        let block = [[-1.1, -0.5, 0.0], [1.1, 0.5, 1.0]];
        let found = largest(&interior, block, Stress::von_mises).unwrap();
        let ratio = 3.0_f64.sqrt() / found.value;
        assert!((ratio - expected).abs() < 0.02, "mu = {mu}: {ratio} {found:?}");
        assert!((found.point[2] - depth).abs() < 0.03, "mu = {mu}: {found:?}");
        println!("mu {mu}: p0/k = {ratio:.5} at {:?}", found.point);
    }
}
