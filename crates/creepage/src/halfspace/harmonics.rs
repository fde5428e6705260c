//! Hemispherical harmonics: the polynomials on the ellipse in which the half-space's response
//! is block diagonal.
//!
//! Lift the point `(x/a, y/b) = r (cos f, sin f)` to the unit hemisphere, `z = sqrt(1 - r^2)`.
//! The spherical harmonics `Y_nm` with `n + m` even are polynomials of degree `n` in `x/a`,
//! `y/b`; they are orthonormal for the weight `(1 - r^2)^(-1/2)` of the singular tractions.
//! Those with `n + m` odd are `z` times a polynomial: the tractions that vanish at the edge.

/// Position of `Y_nm` in a table of all harmonics: cosines at `m >= 0`, sines at `m < 0`.
#[must_use]
pub fn index(n: usize, m: isize) -> usize {
    (n * n + n).wrapping_add_signed(m)
}

/// Number of harmonics, even and odd, up to and including `degree`.
#[must_use]
pub fn count(degree: usize) -> usize {
    (degree + 1) * (degree + 1)
}

/// Number of polynomials in two variables up to and including `degree`.
#[must_use]
pub fn polynomial_count(degree: usize) -> usize {
    (degree + 1) * (degree + 2) / 2
}

/// The least degree whose polynomials number `count` or more.
pub(super) fn degree_of(count: usize) -> usize {
    (0..count).find(|&degree| polynomial_count(degree) >= count).unwrap_or(0)
}

/// The orders `m` of the even harmonics of degree `n`, the polynomials: `-n, -n + 2, ..., n`.
pub fn even_orders(n: usize) -> impl Iterator<Item = isize> + Clone {
    (0..=n).map(move |k| (2 * k).cast_signed() - n.cast_signed())
}

/// Table positions of the polynomials up to `degree`, by degree and order.
pub fn even_indices(degree: usize) -> impl Iterator<Item = usize> + Clone {
    (0..=degree).flat_map(|n| even_orders(n).map(move |m| index(n, m)))
}

/// Position of the even harmonic `Y_nm` in a table of the polynomials alone, the order of
/// [`even_indices`].
#[must_use]
pub fn position(n: usize, m: isize) -> usize {
    (n * (n + 2)).wrapping_add_signed(m) / 2
}

/// Evaluates all harmonics up to `degree` at `(x/a, y/b)` into `values`, a table as of
/// [`index`]. Outside the ellipse the odd harmonics are taken as on its edge: zero.
///
/// # Panics
/// When `values` is shorter than [`count`]`(degree)`.
pub fn evaluate(degree: usize, x_over_a: f64, y_over_b: f64, values: &mut [f64]) {
    visit(degree, [x_over_a, y_over_b], |n, m, value| values[index(n, m)] = value);
}

/// Values at `(x/a, y/b)` of polynomials given by the coefficients of their even harmonics, in
/// the order of [`even_indices`]; the tables may end at any degree up to `degree`.
#[must_use]
pub fn sum<const N: usize>(degree: usize, point: [f64; 2], coefficients: [&[f64]; N]) -> [f64; N] {
    let mut sums = [0.0; N];
    visit(degree, point, |n, m, value| {
        if n.wrapping_add_signed(m).is_multiple_of(2) {
            let position = position(n, m);
            for (sum, table) in sums.iter_mut().zip(coefficients) {
                *sum += value * table.get(position).copied().unwrap_or(0.0);
            }
        }
    });
    sums
}

/// Calls `visitor` with `n`, `m` and `Y_nm`, for every harmonic up to `degree`, order by order.
pub(super) fn visit(degree: usize, [x, y]: [f64; 2], mut visitor: impl FnMut(usize, isize, f64)) {
    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
    // (cos, sin) hold r^m (cos mf, sin mf), scaled to make Y_mm.
    let (mut cos, mut sin) = (std::f64::consts::TAU.sqrt().recip(), 0.0);
    for m in 0..=degree {
        visit_order(degree, m, z, [cos, sin], &mut visitor);
        let next = (m + 1) as f64;
        // The first step also brings in sqrt(2), since cosines and sines share the norm.
        let scale = ((2.0 * next + 1.0) / (2.0 * next) * if m == 0 { 2.0 } else { 1.0 }).sqrt();
        (cos, sin) = (scale * (x * cos - y * sin), scale * (x * sin + y * cos));
    }
}

/// The three-term recurrence in `n` at fixed order `m`, started with `Y_mm`.
fn visit_order(
    degree: usize,
    m: usize,
    z: f64,
    first: [f64; 2],
    visitor: &mut impl FnMut(usize, isize, f64),
) {
    let order = m.cast_signed();
    let (mut previous, mut current) = ([0.0; 2], first);
    let mut here = 0.0;
    for n in m..=degree {
        visitor(n, order, current[0]);
        if m > 0 {
            visitor(n, -order, current[1]);
        }
        let ahead = coupling(n + 1, m);
        let next = [0, 1].map(|i| (z * current[i] - here * previous[i]) / ahead);
        (previous, current, here) = (current, next, ahead);
    }
}

/// `z Y_nm = coupling(n+1, m) Y_{n+1,m} + coupling(n, m) Y_{n-1,m}`.
pub(super) fn coupling(n: usize, m: usize) -> f64 {
    let (n2, m2) = ((n * n) as f64, (m * m) as f64);
    ((n2 - m2) / (4.0 * n2 - 1.0)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn low_degrees_are_the_known_polynomials() {
        let (x, y) = (0.3, -0.5);
        let z = (1.0_f64 - x * x - y * y).sqrt();
        let mut values = vec![0.0; count(2)];
        evaluate(2, x, y, &mut values);
        let norm = |factor: f64| (factor / (2.0 * std::f64::consts::PI)).sqrt();
        for (position, expected) in [
            (index(0, 0), norm(1.0)),
            (index(1, 0), norm(3.0) * z),
            (index(1, 1), norm(3.0) * x),
            (index(1, -1), norm(3.0) * y),
            (index(2, 0), norm(5.0) * (3.0 * z * z - 1.0) / 2.0),
            (index(2, 2), norm(15.0) * (x * x - y * y) / 2.0),
            (index(2, -2), norm(15.0) * x * y),
        ] {
            assert!((values[position] - expected).abs() < 1e-15);
        }
    }
}
