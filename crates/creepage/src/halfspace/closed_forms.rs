//! The coefficients `J` and `F` of low degree in closed form (3.21), (3.22).
//!
//! In (3.22) the thesis prints `e^2` for `g^2` in seven entries; they are mended here. The
//! functions of [`coefficients`](super::coefficients) hold for any degree and agree with these.

use crate::ellipse::Ellipse;
use crate::special::CompleteIntegrals;

/// `J(d, i, j, |e|)` (3.21) by the axis ratio `g`; `None` where the thesis gives no closed form.
///
/// For slender ellipses the terms of `d = -1` cancel: they lose digits as `log(1/g)` grows.
///
/// ```
/// use creepage::halfspace::closed_forms;
/// assert_eq!(closed_forms::j(0, 0, 0, 1.0), Some(std::f64::consts::FRAC_PI_4)); // K/2
/// assert_eq!(closed_forms::j(7, 0, 0, 1.0), None);
/// ```
#[must_use]
pub fn j(d: i32, i: usize, j: usize, g: f64) -> Option<f64> {
    let CompleteIntegrals { k, e, c, d: int_d, b: _ } = CompleteIntegrals::new(g);
    let (g2, e2) = (g * g, (1.0 - g) * (1.0 + g));
    Some(match (d, i, j) {
        (-1, 0, 0) => e / 2.0,
        (-1, 0, 1) => -(3.0 - 2.0 * e2) * int_d / 4.0 + e2 * c / 4.0,
        (-1, 1, 0) => -(3.0 - e2) * int_d / 4.0 + e2 * c / 2.0,
        (-1, 0, 2) => ((11.0 - 8.0 * e2) * int_d + (1.0 - 4.0 * e2) * c) / 8.0,
        (-1, 1, 1) => (2.0 - e2) * int_d / 4.0 - (1.0 + e2) * c / 8.0,
        (-1, 2, 0) => ((11.0 - 3.0 * e2) * int_d + (1.0 - 9.0 * e2) * c) / 8.0,
        (0, 0, 0) => k / 2.0,
        (0, 0, 1) => -int_d / 4.0,
        (0, 1, 0) => -(int_d - e2 * c) / 4.0,
        (0, 0, 2) => int_d / 4.0 + c / 8.0,
        (0, 1, 1) => (int_d - c) / 8.0,
        (0, 2, 0) => int_d / 4.0 + (1.0 - 3.0 * e2) * c / 8.0,
        (1, 0, 0) => e / (4.0 * g2),
        (1, 0, 1) => (int_d - e2 * c) / (8.0 * g2),
        (1, 1, 0) => int_d / 8.0,
        _ => return None,
    })
}

/// `F^{h;pq}_{mn}` (3.22); `None` where the thesis gives no closed form.
///
/// For `a > b` the axes exchange (3.8).
///
/// ```
/// use creepage::Ellipse;
/// use creepage::halfspace::{closed_forms, coefficients};
/// let ellipse = Ellipse::new(2.0, 1.0)?;
/// let closed = closed_forms::f(0, [1, 0], [1, 2], ellipse).unwrap_or(f64::NAN);
/// let general = coefficients::f(0, [1, 0], [1, 2], ellipse)?;
/// assert!((closed - general).abs() < 1e-15);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[must_use]
pub fn f(h: usize, pq: [usize; 2], mn: [usize; 2], ellipse: Ellipse) -> Option<f64> {
    let (s, integrals) = (ellipse.minor(), ellipse.integrals());
    let turn = |[one, other]: [usize; 2]| {
        if ellipse.a() > ellipse.b() { [other, one] } else { [one, other] }
    };
    let ([p, q], [m, n]) = (turn(pq), turn(mn));
    let shape = Shape { s, g2: ellipse.g().powi(2), e2: ellipse.e().powi(2), integrals };
    match h {
        0 => shape.of_one_over_r([p, q, m, n]),
        1 => shape.of_r([p, q, m, n]),
        _ => None,
    }
}

/// An ellipse with `a <= b`.
struct Shape {
    s: f64,
    g2: f64,
    e2: f64,
    integrals: CompleteIntegrals,
}

impl Shape {
    /// `h = 0`.
    fn of_one_over_r(&self, order: [usize; 4]) -> Option<f64> {
        let Self { s, g2, e2, integrals: CompleteIntegrals { k, b, c, d, .. } } = *self;
        Some(match order {
            [0, 0, 0, 0] => s * k / 2.0,
            [0, 0, 2, 0] => -b / s,
            [0, 0, 0, 2] => -g2 * d / s,
            [1, 0, 1, 0] => s * b / 2.0,
            [1, 0, 3, 0] => (d - 3.0 * b - c) / s,
            [1, 0, 1, 2] => -g2 * (d - c) / s,
            [0, 1, 0, 1] => s * d / 2.0,
            [0, 1, 2, 1] => -(d - c) / s,
            [0, 1, 0, 3] => -g2 * (2.0 * d + c) / s,
            [2, 0, 0, 0] => s.powi(3) * d / 8.0,
            [2, 0, 2, 0] => s * (d + (1.0 - 2.0 * e2) * c) / 2.0,
            [2, 0, 0, 2] => -s * g2 * c / 2.0,
            [1, 1, 1, 1] => s * (d - c) / 2.0,
            [0, 2, 0, 0] => s.powi(3) * b / (8.0 * g2),
            [0, 2, 2, 0] => -s * c / 2.0,
            [0, 2, 0, 2] => s * (d + c) / 2.0,
            _ => return None,
        })
    }

    /// `h = 1`.
    fn of_r(&self, order: [usize; 4]) -> Option<f64> {
        let Self { s, g2, integrals: CompleteIntegrals { e, b, c, d, .. }, .. } = *self;
        Some(match order {
            [0, 0, 0, 0] => s.powi(3) * e / (8.0 * g2),
            [0, 0, 2, 0] => s * d / 2.0,
            [1, 0, 3, 0] | [0, 1, 0, 3] => s * (d - c) / 2.0,
            [0, 0, 0, 2] => s * b / 2.0,
            [0, 0, 4, 0] => -(d - c) / s,
            [0, 0, 2, 2] => -g2 * c / s,
            [0, 0, 0, 4] => -g2 * (d - c) / s,
            [1, 0, 1, 0] => -s.powi(3) * d / 8.0,
            [1, 0, 1, 2] => g2 * s * c / 2.0,
            [0, 1, 0, 1] => -s.powi(3) * b / (8.0 * g2),
            [0, 1, 2, 1] => s * c / 2.0,
            _ => return None,
        })
    }
}
