//! Gross sliding of unlike bodies against its expansion in `q`, and against cylinders.

use std::f64::consts::{FRAC_PI_2, PI};

use creepage::Ellipse;
use creepage::coulomb::GrossSliding;

fn circle(q: f64, angle: f64) -> GrossSliding {
    GrossSliding::new(Ellipse::from_ratio(1.0).unwrap(), q, angle).unwrap()
}

/// Shift at first order, ellipticity and approach at second. The strips' pressure, a polynomial, lacks
/// the logarithm at the ends: 0.3 % of the shift, 3 % of the small growth.
#[test]
fn proposition_iii() {
    for q in [0.05, 0.15] {
        let sliding = circle(q, 0.0);
        let ([x, y], [a, b]) = (sliding.shift(), sliding.semi_axes());
        assert!((x / q / GrossSliding::SHIFT - 1.0).abs() < 0.005, "{q}: {x}");
        assert!(y.abs() < 1e-9, "{y}");
        let longer = (a - 1.0) / (q * q);
        assert!((longer / GrossSliding::LENGTHENING - 1.0).abs() < 0.05, "{q}: {longer}");
        assert!(((b - 1.0) / (q * q)).abs() < 0.005, "{q}: {b}");
        let deeper = (sliding.approach() - 1.0) / (q * q);
        assert!((deeper / GrossSliding::DEEPENING - 1.0).abs() < 0.01, "{q}: {deeper}");
    }
}

/// The strips lie along `x`; what they find must not depend on it.
#[test]
fn any_direction_is_alike() {
    for (q, angle) in [(0.2, FRAC_PI_2), (0.2, 0.7), (0.2, -2.0), (0.5, FRAC_PI_2)] {
        let (along, turned) = (circle(q, 0.0), circle(q, angle));
        let [x, y] = turned.shift();
        let (sin, cos) = angle.sin_cos();
        let across = y * cos - x * sin;
        // The tips are where the outermost two strips point to: a twentieth of the shift.
        assert!((x * cos + y * sin - along.shift()[0]).abs() < 4e-3, "{angle}: {x} {y}");
        assert!(across.abs() < 4e-3, "{angle}: {across}");
        assert!((turned.approach() - along.approach()).abs() < 1e-4, "{angle}");
        // Thirty-two strips: what they miss grows with q.
        assert!((turned.peak() - along.peak()).abs() < 5e-3 * q, "{angle}");
    }
}

/// Sliding along cylinders: `Z = (1 + s)^(1/2 + e) (1 - s)^(1/2 - e)`, `tan(pi e) = -q`; the middle
/// moves by `2 e l`, the half-width at the same load is `l = (1 - 4 e^2)^(-1/2)`. In the middle of a long
/// ellipse it is so, up to terms of order `a/b`.
#[test]
fn a_long_ellipse_slides_as_cylinders() {
    let q: f64 = 0.2;
    let e = -q.atan() / PI;
    let apart = [0.2, 0.05].map(|ratio| {
        let ellipse = Ellipse::from_ratio(ratio).unwrap();
        let sliding = GrossSliding::new(ellipse, q, 0.0).unwrap();
        let ([shift, _], [half, _]) = (sliding.shift(), sliding.semi_axes());
        let wider = (half / ellipse.a() - 1.0) / ((1.0 - 4.0 * e * e).powf(-0.5) - 1.0);
        [(shift / half / (2.0 * e) - 1.0).abs(), (wider - 1.0).abs()]
    });
    for k in 0..2 {
        assert!(apart[1][k] < 0.1 && apart[1][k] < 0.5 * apart[0][k], "{apart:?}");
    }
}
