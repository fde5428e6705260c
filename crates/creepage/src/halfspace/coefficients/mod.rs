//! The coefficients `E` and `F` of the load-displacement equations in monomials, and the
//! elliptic integrals `I` and `J` they are sums of.
//!
//! The thesis's double sums (2.73), (3.12) alternate and lose a digit or more a degree. Here
//! every coefficient is one integral over the directions, taken in two ways, along the
//! rays from the centre and along the chords of the ellipse; of the two results the
//! one that cancels less counts. They complement each other: where a slender ellipse spoils
//! one, the other is good to rounding.

mod chords;
mod rays;

use super::elliptic::{self, Node};
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;

/// Highest order `p + q` of a traction's monomial; `m + n` may be four more.
pub const MAX_ORDER: usize = 20;

/// `E^{h;pq}_{mn}` (2.48), (2.73): what `(1 - r^2)^(-1/2) x^p y^q` contributes to
/// `x^m y^n`, for `h = 0` from `1/r`, for `h = 1` from `r`.
///
/// It is `2 (d + 1)` times [`f`] (3.15), `2 d = 2 h + p + q - m - n`, and zero below `d = 0`;
/// see there for units, range and accuracy.
///
/// # Errors
/// As [`f`].
///
/// ```
/// use creepage::Ellipse;
/// use creepage::halfspace::coefficients;
/// let circle = Ellipse::new(1.0, 1.0)?;
/// let e = coefficients::e(0, [0, 0], [0, 0], circle)?; // s K
/// assert!((e - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
pub fn e(
    h: usize,
    [p, q]: [usize; 2],
    [m, n]: [usize; 2],
    ellipse: Ellipse,
) -> Result<f64, InvalidValue> {
    let f = f(h, [p, q], [m, n], ellipse)?;
    Ok((2.0 + (2 * h + p + q) as f64 - (m + n) as f64) * f)
}

/// `F^{h;pq}_{mn}` (3.4), (3.12): what `(1 - r^2)^(1/2) x^p y^q` contributes to `x^m y^n`.
///
/// Its unit is length to the power `2 d + 1`. It vanishes unless `p + m` and `q + n` are even
/// and `d >= -1`. Relative error, compared with 50-digit arithmetic: below 3e-13 up to
/// `p + q = 8` at ratios from 1e-3 to 1e3; for ratios from 0.05 to 20 below 1e-10 up to
/// `p + q = 12` and below 1e-8 up to 20.
///
/// # Errors
/// [`InvalidValue`] when `p + q` is above [`MAX_ORDER`], `m + n` above that and four, or `h`
/// above 1.
pub fn f(
    h: usize,
    [p, q]: [usize; 2],
    [m, n]: [usize; 2],
    ellipse: Ellipse,
) -> Result<f64, InvalidValue> {
    check::require(h <= 1, "h", h as f64, "0 or 1")?;
    let (from, to) = (p.saturating_add(q), m.saturating_add(n));
    check::require(from <= MAX_ORDER, "p + q", from as f64, "at most 20")?;
    check::require(to <= MAX_ORDER + 4, "m + n", to as f64, "at most 24")?;
    if (p + m) % 2 == 1 || (q + n) % 2 == 1 || 2 * h + from + 2 < to {
        return Ok(0.0);
    }
    let rays = rays::f(h, [p, q], [m, n], ellipse);
    let best = match chords::f(h, [p, q], [m, n], ellipse) {
        Some(chords) if chords.size < rays.size => chords,
        _ => rays,
    };
    check::finite("coefficient of that ellipse", best.value)
}

/// `I(d, i, j, |e|)` (2.74) for the axis ratio `g`; `I(d, i, j, -|e|)` is `I(d, j, i, |e|)`.
///
/// # Errors
/// As [`integral_j`].
pub fn integral_i(d: i32, i: usize, j: usize, g: f64) -> Result<f64, InvalidValue> {
    Ok(2.0 * (f64::from(d) + 1.0) * integral_j(d, i, j, g)?)
}

/// `J(d, i, j, |e|)` (3.13) for the axis ratio `g`; `J(d, i, j, -|e|)` is `J(d, j, i, |e|)`.
/// Its relative error is some 1e-15.
///
/// # Errors
/// [`InvalidValue`] unless `1e-6 <= g <= 1`, `|d|` and `i + j` are at most [`MAX_ORDER`].
///
/// ```
/// use creepage::halfspace::coefficients::integral_j;
/// let k = creepage::special::CompleteIntegrals::new(0.3).k;
/// assert!((integral_j(0, 0, 0, 0.3)? - k / 2.0).abs() < 1e-15); // (3.21)
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
pub fn integral_j(d: i32, i: usize, j: usize, g: f64) -> Result<f64, InvalidValue> {
    let order = i.saturating_add(j);
    check::require((1e-6..=1.0).contains(&g), "g", g, "between 1e-6 and 1")?;
    check::require(d.unsigned_abs() as usize <= MAX_ORDER, "d", f64::from(d), "at most 20")?;
    check::require(order <= MAX_ORDER, "i + j", order as f64, "at most 20")?;
    if d < -1 {
        return Ok(0.0);
    }
    let integral = over_directions(g, 2 * order, d, |node| {
        Sum::of((node.cn * node.cn).powi(power(i)) * (node.sn * node.sn).powi(power(j)))
    });
    // (-1)^(i+j) (1/2 - d)_{i+j} / (2 (d+1)!), and half a turn is twice the quarter.
    let pochhammer: f64 = (0..order).map(|k| f64::from(d) - 0.5 - k as f64).product();
    let factorial: f64 = (1..=d + 1).map(f64::from).product();
    check::finite("J", 0.25 * pochhammer / factorial * integral.value)
}

/// A sum, and the sum of its terms' sizes, which bounds its rounding error.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Sum {
    value: f64,
    size: f64,
}

impl Sum {
    fn of(value: f64) -> Self {
        Self { value, size: value.abs() }
    }

    fn scaled(self, factor: f64) -> Self {
        Self { value: factor * self.value, size: factor.abs() * self.size }
    }
}

impl std::iter::Sum for Sum {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::default(), |sum, term| Self {
            value: sum.value + term.value,
            size: sum.size + term.size,
        })
    }
}

/// The integral of `integrand / sqrt(1 - e^2 sin^2 psi)^(2d+1)` over `psi` from 0 to pi, of a
/// trigonometric polynomial of degree `order`.
fn over_directions(g: f64, order: usize, d: i32, integrand: impl Fn(&Node) -> Sum) -> Sum {
    let k = crate::special::CompleteIntegrals::new(g).k;
    let count = elliptic::node_count(k, order + 2 * d.unsigned_abs() as usize);
    elliptic::nodes(g, count)
        .map(|node| integrand(&node).scaled(node.dn.powi(-2 * d)))
        .sum::<Sum>()
        .scaled(2.0 * k / count as f64)
}

/// An order as an exponent; [`MAX_ORDER`] keeps it small.
fn power(order: usize) -> i32 {
    i32::try_from(order).unwrap_or(i32::MAX)
}
