//! Tractions that vanish at the edge (chapter 3), in terms of the singular ones (chapter 2).
//!
//! `(1 - r^2)^(1/2) P` is `(1 - r^2)^(-1/2)` times the polynomial `(1 - r^2) P`, and so is its
//! `x` derivative: both map into the harmonics exactly, by recurrences alone.

use super::{harmonics, products};

/// Coefficients of `(1 - r^2) P`, of two degrees more than `P`.
#[must_use]
pub(crate) fn as_singular(degree: usize, polynomial: &[f64]) -> Vec<f64> {
    let once = products::times_z(degree, &spread(degree, polynomial));
    gather(degree + 2, &products::times_z(degree + 1, &once))
}

/// Coefficients of `(1 - r^2)^(1/2) d/d(x/a) [(1 - r^2)^(1/2) P]`, of one degree more than `P`.
///
/// The response to this singular traction is `a du/dx` of the response to
/// `(1 - r^2)^(1/2) P`, since a traction that vanishes at the edge may be shifted.
#[must_use]
pub(crate) fn x_derivative(degree: usize, polynomial: &[f64]) -> Vec<f64> {
    let once = products::times_z(degree, &spread(degree, polynomial));
    gather(degree + 1, &products::times_z_ddx(degree + 1, &once))
}

/// Coefficients of `P` from those of `(1 - r^2) P`, of two degrees more than `P`.
///
/// A given polynomial need not be such a product: [`as_singular`] of the result shows by how
/// much it is not. Below degree two no polynomial but zero is, and the result is `[0]`.
#[must_use]
pub(crate) fn from_singular(degree: usize, product: &[f64]) -> Vec<f64> {
    if degree < 2 {
        return vec![0.0];
    }
    let once = products::over_z(degree, &spread(degree, product));
    gather(degree - 2, &products::over_z(degree - 1, &once))
}

/// A table of all harmonics from the coefficients of the polynomials among them.
fn spread(degree: usize, polynomial: &[f64]) -> Vec<f64> {
    let mut table = vec![0.0; harmonics::count(degree)];
    for (index, value) in harmonics::even_indices(degree).zip(polynomial) {
        table[index] = *value;
    }
    table
}

/// The polynomials' coefficients out of a table of all harmonics.
fn gather(degree: usize, table: &[f64]) -> Vec<f64> {
    harmonics::even_indices(degree).map(|index| table[index]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(degree: usize, polynomial: &[f64], x: f64, y: f64) -> f64 {
        let mut values = vec![0.0; harmonics::count(degree)];
        harmonics::evaluate(degree, x, y, &mut values);
        gather(degree, &values).iter().zip(polynomial).map(|(a, b)| a * b).sum()
    }

    fn sample(degree: usize) -> Vec<f64> {
        (0..harmonics::polynomial_count(degree)).map(|i| (2.3 * i as f64).cos()).collect()
    }

    #[test]
    fn product_with_one_minus_r_squared() {
        let (p, x, y) = (sample(5), 0.2, 0.7);
        let product = (1.0 - x * x - y * y) * at(5, &p, x, y);
        assert!((at(7, &as_singular(5, &p), x, y) - product).abs() < 1e-13);
    }

    #[test]
    fn division_undoes_the_product() {
        let p = sample(20);
        let quotient = from_singular(22, &as_singular(20, &p));
        // Two recurrences over 20 degrees, each good to a digit.
        assert!(quotient.iter().zip(&p).all(|(a, b)| (a - b).abs() < 1e-13));
    }

    #[test]
    fn derivative_of_the_vanishing_traction() {
        let (p, x, y, h) = (sample(5), 0.2, 0.7, 1e-5);
        let root = |x: f64| (1.0 - x * x - y * y).sqrt();
        let traction = |x: f64| root(x) * at(5, &p, x, y);
        let slope = (traction(x + h) - traction(x - h)) / (2.0 * h);
        // Central difference: h^2 times a third derivative of order 100.
        assert!((at(6, &x_derivative(5, &p), x, y) - root(x) * slope).abs() < 1e-7);
    }
}
