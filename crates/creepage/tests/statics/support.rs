//! What the tests of the classical problems share.

use std::f64::consts::PI;

use creepage::{Ellipse, Solid, SolidPair};
use gauss_quad::GaussLegendre;

/// Asserts a relative difference below `tolerance`.
pub(crate) fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} against {expected}");
}

pub(crate) fn pair(poisson: f64) -> SolidPair {
    let solid = Solid::new(82e9, poisson).unwrap();
    SolidPair::new(solid, solid)
}

/// Point at `(r, f)` on the disc of an ellipse.
pub(crate) fn point(ellipse: Ellipse, r: f64, f: f64) -> [f64; 2] {
    [ellipse.a() * r * f.cos(), ellipse.b() * r * f.sin()]
}

/// The integral of `f` times `(1 - r^2)^(1/2)` over the ellipse, without that factor's root.
pub(crate) fn over_ellipse(ellipse: Ellipse, f: impl Fn([f64; 2]) -> f64) -> f64 {
    let (rays, radial) = (48, GaussLegendre::new(24.try_into().unwrap()));
    let sum: f64 = (0..rays)
        .map(|ray| {
            let angle = 2.0 * PI * (f64::from(ray) + 0.5) / f64::from(rays);
            radial.integrate(0.0, 1.0, |z| z * f(point(ellipse, (1.0 - z * z).sqrt(), angle)))
        })
        .sum();
    sum * ellipse.a() * ellipse.b() * 2.0 * PI / f64::from(rays)
}
