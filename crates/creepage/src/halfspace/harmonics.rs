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

/// The orders `m` of the even harmonics of degree `n`, the polynomials: `-n, -n + 2, ..., n`.
pub fn even_orders(n: usize) -> impl Iterator<Item = isize> + Clone {
    (0..=n).map(move |k| (2 * k).cast_signed() - n.cast_signed())
}

/// Table positions of the polynomials up to `degree`, by degree and order.
pub fn even_indices(degree: usize) -> impl Iterator<Item = usize> + Clone {
    (0..=degree).flat_map(|n| even_orders(n).map(move |m| index(n, m)))
}

/// Evaluates all harmonics up to `degree` at `(x/a, y/b)` into `values`, a table as of
/// [`index`]. Outside the ellipse the odd harmonics are taken as on its edge: zero.
///
/// # Panics
/// When `values` is shorter than [`count`]`(degree)`.
pub fn evaluate(degree: usize, x_over_a: f64, y_over_b: f64, values: &mut [f64]) {
    let z = (1.0 - x_over_a * x_over_a - y_over_b * y_over_b).max(0.0).sqrt();
    // (cos, sin) hold r^m (cos mf, sin mf), scaled to make Y_mm.
    let (mut cos, mut sin) = (std::f64::consts::TAU.sqrt().recip(), 0.0);
    for m in 0..=degree {
        evaluate_order(degree, m, z, [cos, sin], values);
        let next = (m + 1) as f64;
        // The first step also brings in sqrt(2), since cosines and sines share the norm.
        let scale = ((2.0 * next + 1.0) / (2.0 * next) * if m == 0 { 2.0 } else { 1.0 }).sqrt();
        (cos, sin) =
            (scale * (x_over_a * cos - y_over_b * sin), scale * (x_over_a * sin + y_over_b * cos));
    }
}

/// The three-term recurrence in `n` at fixed order `m`, started with `Y_mm`.
fn evaluate_order(degree: usize, m: usize, z: f64, first: [f64; 2], values: &mut [f64]) {
    let order = m.cast_signed();
    let (mut previous, mut current) = ([0.0; 2], first);
    for n in m..=degree {
        values[index(n, order)] = current[0];
        if m > 0 {
            values[index(n, -order)] = current[1];
        }
        let (here, ahead) = (coupling(n, m), coupling(n + 1, m));
        let next = [0, 1].map(|i| (z * current[i] - here * previous[i]) / ahead);
        (previous, current) = (current, next);
    }
}

/// `z Y_nm = coupling(n+1, m) Y_{n+1,m} + coupling(n, m) Y_{n-1,m}`.
fn coupling(n: usize, m: usize) -> f64 {
    let (n2, m2) = ((n * n) as f64, (m * m) as f64);
    ((n2 - m2) / (4.0 * n2 - 1.0)).sqrt()
}

/// Coefficients of `z F` from those of `F`: one degree more, the parity changes.
#[must_use]
pub fn times_z(degree: usize, coefficients: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; count(degree + 1)];
    for n in 0..=degree {
        let top = n.cast_signed();
        for m in -top..=top {
            let value = coefficients[index(n, m)];
            let order = m.unsigned_abs();
            product[index(n + 1, m)] += coupling(n + 1, order) * value;
            if order < n {
                product[index(n - 1, m)] += coupling(n, order) * value;
            }
        }
    }
    product
}

/// Coefficients of `z dF/d(x/a)` from those of `F`: the rotation of the sphere about the `y`
/// axis, which keeps the degree and changes the order by one.
#[must_use]
pub fn times_z_ddx(degree: usize, coefficients: &[f64]) -> Vec<f64> {
    let mut rotated = vec![0.0; count(degree)];
    for n in 0..=degree {
        let top = n.cast_signed();
        for m in -top..=top {
            let order = m.unsigned_abs();
            let value = coefficients[index(n, m)];
            let half = if order == 0 { std::f64::consts::FRAC_1_SQRT_2 } else { 0.5 };
            if order < n {
                let outward = if m < 0 { m - 1 } else { m + 1 };
                let step = (((n - order) * (n + order + 1)) as f64).sqrt();
                rotated[index(n, outward)] -= half * step * value;
            }
            // The sine of order zero vanishes.
            if order > 0 && m != -1 {
                let inward = if m < 0 { m + 1 } else { m - 1 };
                let half = if m == 1 { std::f64::consts::FRAC_1_SQRT_2 } else { 0.5 };
                let step = (((n + order) * (n - order + 1)) as f64).sqrt();
                rotated[index(n, inward)] += half * step * value;
            }
        }
    }
    rotated
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(degree: usize, coefficients: &[f64], x: f64, y: f64) -> f64 {
        let mut values = vec![0.0; count(degree)];
        evaluate(degree, x, y, &mut values);
        values.iter().zip(coefficients).map(|(value, coefficient)| value * coefficient).sum()
    }

    fn sample(degree: usize) -> Vec<f64> {
        (0..count(degree)).map(|i| (1.7 * i as f64 + 0.3).sin()).collect()
    }

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

    #[test]
    fn multiplication_by_z() {
        let degree = 6;
        let (f, x, y) = (sample(degree), 0.31, 0.44);
        let z = (1.0_f64 - x * x - y * y).sqrt();
        let product = at(degree + 1, &times_z(degree, &f), x, y);
        // Rounding only: 49 terms of order one.
        assert!((product - z * at(degree, &f, x, y)).abs() < 1e-13);
    }

    #[test]
    fn rotation_is_z_times_the_x_derivative() {
        let degree = 6;
        let (f, x, y, h) = (sample(degree), -0.31, 0.44, 1e-5);
        let z = (1.0_f64 - x * x - y * y).sqrt();
        let slope = (at(degree, &f, x + h, y) - at(degree, &f, x - h, y)) / (2.0 * h);
        // Central difference: h^2 times a third derivative of order 100.
        assert!((at(degree, &times_z_ddx(degree, &f), x, y) - z * slope).abs() < 1e-7);
    }
}
