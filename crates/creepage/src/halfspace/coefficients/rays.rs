//! Influence coefficients along the rays from the centre, as the thesis has them (2.65)-(2.73).
//!
//! The derivatives of `r^(2h-1)` in (2.48) are Fourier sums in the ray's direction with exact
//! coefficients: by `x + iy` and `x - iy` every derivative of a power of `r` is one term.

use std::f64::consts::{FRAC_PI_2, PI};

use super::super::elliptic::Node;
use super::{Sum, over_directions, power};
use crate::ellipse::Ellipse;

/// `F^{h;pq}_{mn}`, for parities and orders where it does not vanish.
pub(super) fn f(h: usize, [p, q]: [usize; 2], [m, n]: [usize; 2], ellipse: Ellipse) -> Sum {
    // (2.64): the formulas hold for a <= b, the other orientation by exchange.
    let ([p, q], [m, n]) =
        if ellipse.a() <= ellipse.b() { ([p, q], [m, n]) } else { ([q, p], [n, m]) };
    let d = (power(2 * h + p + q) - power(m + n)) / 2;
    let waves = derivative_waves(h, [m, n]);
    let integral = over_directions(ellipse.g(), p + q + m + n, d, |node| {
        wave_sum(&waves, n, node).scaled(node.cn.powi(power(p)) * node.sn.powi(power(q)))
    });
    let sign = if (m + n) % 2 == 0 { 1.0 } else { -1.0 };
    integral.scaled(sign / PI * radial(d) * ellipse.minor().powi(2 * d + 1))
}

/// `1/4 Gamma(d + 1/2) Gamma(1/2) / Gamma(d + 2)`: the integral along the radius, for `d = -1`
/// its finite part.
fn radial(d: i32) -> f64 {
    (0..=d).fold(-FRAC_PI_2, |value, k| value * (f64::from(k) - 0.5) / (f64::from(k) + 1.0))
}

/// The factors of `exp(i (m + n - 2j) psi)`, over `i^n`, in `d^(m+n) r^(2h-1) / dx^m dy^n` on
/// `r = 1`: of `j` derivatives by `x + iy` and the rest by `x - iy`.
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
fn wave_sum(waves: &[f64], n: usize, node: &Node) -> Sum {
    let (psi, top) = (node.sn.atan2(node.cn), waves.len() as f64 - 1.0);
    let phase = FRAC_PI_2 * (n % 4) as f64;
    let wave = |j: usize| (phase + (top - 2.0 * j as f64) * psi).cos();
    waves.iter().enumerate().map(|(j, factor)| Sum::of(factor * wave(j))).sum()
}
