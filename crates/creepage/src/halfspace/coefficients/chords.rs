//! Influence coefficients along the chords of the ellipse, as in the fundamental lemma (2.28).
//!
//! The mean of `x^p y^q` over a chord is a polynomial in the chord's distance `h` from the
//! centre, `h = -(x/a) sin f + (y/b) cos f` for the chords through `(x, y)`; its coefficient of
//! `h^(m+n)` makes `x^m y^n`.

use super::super::elliptic;
use super::{Sum, power};
use crate::ellipse::Ellipse;

/// `F^{h;pq}_{mn}`, for parities and orders where it does not vanish; `None` for `h = 1` and
/// `m + n` below two, where the kernel is no second derivative of `r`.
pub(super) fn f(h: usize, [p, q]: [usize; 2], [m, n]: [usize; 2], ellipse: Ellipse) -> Option<Sum> {
    // (2.34): sin^2/r, cos^2/r and -sin cos/r are the second derivatives of r.
    let (kernel, [m, n]): (fn([f64; 2]) -> f64, _) = match (h, m, n) {
        (0, ..) => (|_| 1.0, [m, n]),
        (_, 2.., _) => (|[_, sin]| sin * sin, [m - 2, n]),
        (_, _, 2..) => (|[cos, _]| cos * cos, [m, n - 2]),
        (_, 1, 1) => (|[cos, sin]| -sin * cos, [0, 0]),
        _ => return None,
    };
    let (g, k) = (ellipse.g(), ellipse.integrals().k);
    let count = elliptic::node_count(k, p + q + m + n + 4);
    let sum: Sum = elliptic::nodes(g, count)
        .map(|node| {
            let ([cos, sin], true_direction) = node.directions(ellipse);
            let factor = kernel(true_direction) * (-sin).powi(power(m)) * cos.powi(power(n));
            chord_mean([p, q], m + n, [cos, sin]).scaled(factor)
        })
        .sum();
    let factorial: f64 = (1..=m + n).map(|i| i as f64).product();
    let unit = ellipse.a().powi(power(p) - power(m)) * ellipse.b().powi(power(q) - power(n));
    // E where it does not vanish by its order, then (3.15).
    let share = 2.0 + (p + q) as f64 - (m + n) as f64;
    let share = if share == 0.0 { 1.0 } else { share };
    Some(sum.scaled(factorial * unit * k * ellipse.minor() / (count as f64 * share)))
}

/// The coefficient of `h^order` in the mean of `(x/a)^p (y/b)^q` over the chord in `direction`
/// at distance `h`; of `1 - r^2` times it where the order is higher than `p + q`.
fn chord_mean([p, q]: [usize; 2], order: usize, [cos, sin]: [f64; 2]) -> Sum {
    // In the powers of (distance along the chord)/h.
    let mut powers = vec![1.0];
    let factors = std::iter::repeat_n([-sin, cos], p).chain(std::iter::repeat_n([cos, sin], q));
    for [across, along] in factors {
        powers.push(0.0);
        for j in (0..powers.len()).rev() {
            powers[j] = across * powers[j] + if j > 0 { along * powers[j - 1] } else { 0.0 };
        }
    }
    // The mean of the even powers is (1 - h^2)^k (1/2)_k / k!.
    let (skipped, first, [above, below]) = if order > p + q {
        (0, -0.5, [0.5, 2.0])
    } else {
        let skipped = (p + q - order) / 2;
        let first = (1..=skipped).map(|i| 1.0 - 0.5 / i as f64).product();
        (skipped, first, [0.5 + skipped as f64, 1.0])
    };
    let mut factor: f64 = first;
    let terms = powers.iter().skip(2 * skipped).step_by(2).enumerate().map(|(j, value)| {
        let term = Sum::of(value * factor);
        factor *= -(above + j as f64) / (below + j as f64);
        term
    });
    terms.sum()
}
