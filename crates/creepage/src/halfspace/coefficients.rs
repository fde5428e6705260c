//! The coefficients `E` and `F` of the load-displacement equations in monomials, and the
//! elliptic integrals `I` and `J` they are sums of.
//!
//! The thesis's double sums (2.73), (3.12) alternate and lose a digit or two a degree. Here
//! the derivatives in (2.48) are a Fourier sum in the direction whose coefficients are exact
//! (in `x + iy` and `x - iy` every derivative of a power of `r` is one term), and the remaining
//! integral over the direction is done by a rule that converges geometrically.

use std::f64::consts::{FRAC_PI_2, PI};

use super::elliptic::{self, Node};
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;

/// Highest order `p + q` and `m + n` of the coefficients.
pub const MAX_ORDER: usize = 40;

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
/// and `d >= -1`. Its error is some 1e-15 of the largest coefficient with the same orders.
/// Coefficients fall off as `2^-(p + q)` where `x^p y^q` varies less fast with the direction
/// than the derivative: their relative error is below 1e-12 up to order 8.
///
/// # Errors
/// [`InvalidValue`] when `p + q` or `m + n` is above [`MAX_ORDER`], or `h` above 1.
pub fn f(
    h: usize,
    [p, q]: [usize; 2],
    [m, n]: [usize; 2],
    ellipse: Ellipse,
) -> Result<f64, InvalidValue> {
    check::require(h <= 1, "h", h as f64, "0 or 1")?;
    for (name, order) in [("p + q", p.saturating_add(q)), ("m + n", m.saturating_add(n))] {
        check::require(order <= MAX_ORDER, name, order as f64, "at most 40")?;
    }
    let twice_d = (2 * h + p + q).cast_signed() - (m + n).cast_signed();
    if (p + m) % 2 == 1 || (q + n) % 2 == 1 || twice_d < -2 {
        return Ok(0.0);
    }
    // (2.64): the formulas hold for a <= b, the other orientation by exchange.
    let ([p, q], [m, n]) =
        if ellipse.a() <= ellipse.b() { ([p, q], [m, n]) } else { ([q, p], [n, m]) };
    let d = half(twice_d);
    let waves = derivative_waves(h, [m, n]);
    let integral = over_directions(ellipse.g(), p + q + m + n, d, |node| {
        node.cn.powi(signed(p)) * node.sn.powi(signed(q)) * wave_sum(&waves, n, node)
    });
    let sign = if (m + n) % 2 == 0 { 1.0 } else { -1.0 };
    Ok(sign / PI * radial(d) * ellipse.minor().powi(2 * d + 1) * integral)
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
/// [`InvalidValue`] unless `0 < g <= 1`, `|d|` and `i + j` are at most [`MAX_ORDER`].
///
/// ```
/// use creepage::halfspace::coefficients::integral_j;
/// let k = creepage::special::CompleteIntegrals::new(0.3).k;
/// assert!((integral_j(0, 0, 0, 0.3)? - k / 2.0).abs() < 1e-15); // (3.21)
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
pub fn integral_j(d: i32, i: usize, j: usize, g: f64) -> Result<f64, InvalidValue> {
    let (order, order_f) = (i.saturating_add(j), i.saturating_add(j) as f64);
    check::require(g > 0.0 && g <= 1.0, "g", g, "above 0 and at most 1")?;
    check::require(d.unsigned_abs() as usize <= MAX_ORDER, "d", f64::from(d), "at most 40")?;
    check::require(order <= MAX_ORDER, "i + j", order_f, "at most 40")?;
    if d < -1 {
        return Ok(0.0);
    }
    let integral = over_directions(g, 2 * order, d, |node| {
        (node.cn * node.cn).powi(signed(i)) * (node.sn * node.sn).powi(signed(j))
    });
    // (-1)^(i+j) (1/2 - d)_{i+j} / (2 (d+1)!)
    let pochhammer: f64 = (0..order).map(|k| f64::from(d) - 0.5 - k as f64).product();
    let factorial: f64 = (1..=d + 1).map(f64::from).product();
    Ok(0.5 * pochhammer / factorial * (integral / 2.0))
}

/// The integral of `integrand / sqrt(1 - e^2 sin^2 psi)^(2d+1)` over half a turn.
fn over_directions(g: f64, order: usize, d: i32, integrand: impl Fn(&Node) -> f64) -> f64 {
    let k = crate::special::CompleteIntegrals::new(g).k;
    let count = elliptic::node_count(k, order + 2 * d.unsigned_abs() as usize);
    let sum: f64 =
        elliptic::nodes(g, count).map(|node| integrand(&node) * node.dn.powi(-2 * d)).sum();
    2.0 * k / count as f64 * sum
}

/// `1/4 Gamma(d + 1/2) Gamma(1/2) / Gamma(d + 2)`: the integral along the radius, for `d = -1`
/// its finite part.
fn radial(d: i32) -> f64 {
    (0..=d).fold(-FRAC_PI_2, |value, k| value * (f64::from(k) - 0.5) / (f64::from(k) + 1.0))
}

/// The factors of `exp(i (m + n - 2j) psi)`, over `i^n`, in `d^(m+n) r^(2h-1) / dx^m dy^n` on
/// `r = 1`: of `j` derivatives by `z = x + iy` and the rest by its conjugate.
fn derivative_waves(h: usize, [m, n]: [usize; 2]) -> Vec<f64> {
    // Coefficients of (t + 1)^m (t - 1)^n.
    let mut waves = vec![1.0];
    for sign in std::iter::repeat_n(1.0, m).chain(std::iter::repeat_n(-1.0, n)) {
        waves.push(0.0);
        for j in (0..waves.len()).rev() {
            waves[j] = sign * waves[j] + if j > 0 { waves[j - 1] } else { 0.0 };
        }
    }
    let falling = |count: usize| -> f64 { (0..count).map(|k| h as f64 - 0.5 - k as f64).product() };
    for (j, wave) in waves.iter_mut().enumerate() {
        *wave *= falling(j) * falling(m + n - j);
    }
    waves
}

/// The derivative's value in a direction: the real part of `i^n` times the sum of waves.
fn wave_sum(waves: &[f64], n: usize, node: &Node) -> f64 {
    let (psi, top) = (node.sn.atan2(node.cn), waves.len() as f64 - 1.0);
    let phase = FRAC_PI_2 * (n % 4) as f64;
    let wave = |j: usize| (phase + (top - 2.0 * j as f64) * psi).cos();
    waves.iter().enumerate().map(|(j, factor)| factor * wave(j)).sum()
}

/// Half of an even number, as an exponent.
fn half(twice: isize) -> i32 {
    i32::try_from(twice / 2).unwrap_or(i32::MAX)
}

/// An order, at most [`MAX_ORDER`], as an exponent.
fn signed(order: usize) -> i32 {
    i32::try_from(order).unwrap_or(i32::MAX)
}
