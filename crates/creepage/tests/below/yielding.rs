//! First yield below a circle that slides: peak pressure over the shear yield stress.

use creepage::subsurface::{Body, Largest, Stress, largest};

use crate::support::sliding;

/// Peak pressure over the shear yield stress of von Mises's law, and where.
fn first_yield(mu: f64) -> (f64, Largest) {
    let interior = sliding(1.0, 0.3, [mu, 0.0], Body::Lower);
    let block = [[-1.1, -0.5, 0.0], [1.1, 0.5, 1.0]];
    let found = largest(&interior, block, Stress::von_mises).unwrap();
    (3.0_f64.sqrt() / found.value, found)
}

/// 2.80 and 2.63 on a coarse grid of points, below the surface.
#[test]
fn little_friction_yields_below() {
    for (mu, expected, depth) in [(0.0, 2.80, 0.481), (0.3, 2.63, 0.428)] {
        let (ratio, found) = first_yield(mu);
        assert!((ratio - expected).abs() < 0.02, "mu = {mu}: {ratio} {found:?}");
        assert!((found.point[2] - depth).abs() < 1e-3, "mu = {mu}: {found:?}");
    }
}

/// With more friction the trailing end of the edge yields first, at the surface, where
/// `xx = mu pi (4 + sigma)/8 + (1 - 2 sigma)/3` and `yy = 3 pi sigma mu/8 - (1 - 2 sigma)/3`. It is
/// the top of a cusp, 2.15 at mu = .4, which a coarse grid of points (2.39) overlooks.
#[test]
fn much_friction_yields_at_the_trailing_edge() {
    use std::f64::consts::PI;
    for mu in [0.4, 0.5] {
        let (ratio, found) = first_yield(mu);
        let side = (1.0 - 0.6) / 3.0;
        let (xx, yy) = (mu * PI * 4.3 / 8.0 + side, 3.0 * PI * 0.3 * mu / 8.0 - side);
        let expected = 3.0_f64.sqrt() / (xx * xx - xx * yy + yy * yy).sqrt();
        // A sharp ridge along the edge, on which the search may stop beside the top.
        assert!((ratio - expected).abs() < 3e-3, "{ratio} {expected} {found:?}");
        let [x, y, z] = found.point;
        assert!(x < -0.99 && (x.hypot(y) - 1.0).abs() < 1e-3 && z < 1e-3, "{found:?}");
    }
}
