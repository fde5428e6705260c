//! Products of harmonics with `z`, `x/a`, `y/b`, and their `x` derivative, in coefficients: recurrences of two or four
//! terms, exact.

use std::f64::consts::FRAC_1_SQRT_2;

use super::harmonics::{count, coupling, even_orders, index, polynomial_count, position};

/// Coefficients of `z F` from those of `F`: one degree more, the parity changes.
pub(super) fn times_z(degree: usize, coefficients: &[f64]) -> Vec<f64> {
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
pub(super) fn times_z_ddx(degree: usize, coefficients: &[f64]) -> Vec<f64> {
    let mut rotated = vec![0.0; count(degree)];
    for n in 0..=degree {
        let top = n.cast_signed();
        for m in -top..=top {
            let order = m.unsigned_abs();
            let value = coefficients[index(n, m)];
            let half = if order == 0 { FRAC_1_SQRT_2 } else { 0.5 };
            if order < n {
                let outward = if m < 0 { m - 1 } else { m + 1 };
                let step = (((n - order) * (n + order + 1)) as f64).sqrt();
                rotated[index(n, outward)] -= half * step * value;
            }
            // The sine of order zero vanishes.
            if order > 0 && m != -1 {
                let inward = if m < 0 { m + 1 } else { m - 1 };
                let half = if m == 1 { FRAC_1_SQRT_2 } else { 0.5 };
                let step = (((n + order) * (n - order + 1)) as f64).sqrt();
                rotated[index(n, inward)] += half * step * value;
            }
        }
    }
    rotated
}

/// Coefficients of `G` from those of `F = z G`, `F` of `degree`, `G` of one degree less.
///
/// For a given `F` that is no multiple of `z`, `z G` and `F` differ in the terms `n = |m|`.
pub(super) fn over_z(degree: usize, coefficients: &[f64]) -> Vec<f64> {
    let mut quotient = vec![0.0; count(degree)];
    for n in (1..=degree).rev() {
        let top = n.cast_signed() - 1;
        for m in -top..=top {
            let order = m.unsigned_abs();
            let above =
                if n < degree { coupling(n + 1, order) * quotient[index(n + 1, m)] } else { 0.0 };
            quotient[index(n - 1, m)] = (coefficients[index(n, m)] - above) / coupling(n, order);
        }
    }
    quotient.truncate(count(degree - 1));
    quotient
}

/// A coordinate on the unit disc.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Axis {
    /// `x/a = r cos f`.
    X,
    /// `y/b = r sin f`.
    Y,
}

/// Coefficients of `x/a` or `y/b` times a polynomial: one degree more. Tables hold the even
/// harmonics only, in the order of [`super::harmonics::even_indices`].
pub(super) fn times_axis(axis: Axis, degree: usize, polynomial: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; polynomial_count(degree + 1)];
    for n in 0..=degree {
        for m in even_orders(n) {
            let value = polynomial[position(n, m)];
            for (target, factor) in angular(axis, m) {
                let inward = target.unsigned_abs() < m.unsigned_abs();
                // sin(theta) times the Legendre function of order `m` has two terms, of the
                // neighbouring order and of either neighbouring degree.
                let (sign, order) =
                    if inward { (-1.0, -(m.abs() as f64)) } else { (1.0, m.abs() as f64) };
                let (n_f, value) = (n as f64, sign * factor * value);
                let rise = (n_f + order + 1.0) * (n_f + order + 2.0) / (2.0 * n_f + 3.0);
                product[position(n + 1, target)] += (rise / (2.0 * n_f + 1.0)).sqrt() * value;
                if target.unsigned_abs() < n {
                    let fall = (n_f - order) * (n_f - order - 1.0) / (2.0 * n_f - 1.0);
                    product[position(n - 1, target)] -= (fall / (2.0 * n_f + 1.0)).sqrt() * value;
                }
            }
        }
    }
    product
}

/// `cos f` or `sin f` times the angular part of order `m` (sine where negative): the orders of
/// the product and their factors, with the norms of the harmonics.
fn angular(axis: Axis, m: isize) -> impl Iterator<Item = (isize, f64)> {
    let order = m.abs();
    // cos cos and sin sin give cosines, the mixed products sines.
    let sine = (m < 0) != (axis == Axis::Y);
    let outward = if axis == Axis::Y && m < 0 { -1.0 } else { 1.0 };
    let inward = if axis == Axis::Y && m >= 0 { -1.0 } else { 1.0 };
    let signed = move |order: isize| if sine { -order } else { order };
    let half = |near: bool| if near { FRAC_1_SQRT_2 } else { 0.5 };
    [
        (order + 1, outward * half(order == 0)),
        // Order zero has no inward neighbour, and the sine of order zero vanishes.
        (order - 1, inward * half(order == 1)),
    ]
    .into_iter()
    .filter(move |(order, _)| *order >= isize::from(sine))
    .map(move |(order, factor)| (signed(order), factor))
}

#[cfg(test)]
mod tests {
    use super::super::harmonics::evaluate;
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

    #[test]
    fn division_undoes_multiplication_by_z() {
        let degree = 30;
        let f = sample(degree);
        let quotient = over_z(degree + 1, &times_z(degree, &f));
        // The recurrence runs down 30 degrees and loses no more than a digit.
        assert!(quotient.iter().zip(&f).all(|(a, b)| (a - b).abs() < 1e-14));
    }

    #[test]
    fn multiplication_by_the_coordinates() {
        use super::super::harmonics::sum;
        let (degree, point) = (6, [0.31, -0.44]);
        let f: Vec<f64> = (0..polynomial_count(degree)).map(|i| (1.3 * i as f64).cos()).collect();
        let [value] = sum(degree, point, [&f]);
        for (axis, factor) in [(Axis::X, point[0]), (Axis::Y, point[1])] {
            let product = times_axis(axis, degree, &f);
            let [there] = sum(degree + 1, point, [&product]);
            // Rounding only: 36 terms of order one.
            assert!((there - factor * value).abs() < 1e-14);
        }
    }
}
