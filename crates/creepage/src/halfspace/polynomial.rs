//! Polynomials in `x`, `y`: the public face of tractions and displacement differences.

use super::harmonics::{self, coupling, polynomial_count, position};
use super::products::{self, Axis};
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;

/// Error of a list of numbers that is no [`Polynomial`].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PolynomialError {
    /// A coefficient is not a finite number.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The number of coefficients belongs to no degree.
    #[error("{given} coefficients make no complete degree: it takes 1, 3, 6, 10, ...")]
    Count {
        /// How many coefficients were given.
        given: usize,
    },
}

/// A polynomial in `x` and `y` of total degree `M`: the sum of `d_pq x^p y^q`, `p + q <= M`.
///
/// Coefficients are in the thesis's order (2.49): `1, x, y, x^2, xy, y^2, ..., y^M`. Lengths
/// are in the unit of the ellipse that the polynomial lives on.
///
/// ```
/// use creepage::halfspace::Polynomial;
/// let polynomial = Polynomial::new(vec![1.0, 0.0, 2.0])?; // 1 + 2 y
/// assert_eq!(polynomial.at([5.0, 3.0]), 7.0);
/// assert_eq!(polynomial.coefficient(0, 1), 2.0);
/// # Ok::<(), creepage::halfspace::PolynomialError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Polynomial {
    degree: usize,
    coefficients: Vec<f64>,
}

impl Polynomial {
    /// A polynomial from its coefficients, `(M + 1)(M + 2)/2` of them.
    ///
    /// # Errors
    /// [`PolynomialError`] when the number fits no degree or a coefficient is not finite.
    pub fn new(coefficients: Vec<f64>) -> Result<Self, PolynomialError> {
        let given = coefficients.len();
        let degree = harmonics::degree_of(given);
        if polynomial_count(degree) != given {
            return Err(PolynomialError::Count { given });
        }
        for value in &coefficients {
            check::finite("polynomial coefficient", *value)?;
        }
        Ok(Self { degree, coefficients })
    }

    /// The polynomial of `degree` that is zero everywhere.
    #[must_use]
    pub fn zero(degree: usize) -> Self {
        Self { degree, coefficients: vec![0.0; polynomial_count(degree)] }
    }

    /// Position of `x^p y^q` among the coefficients.
    #[must_use]
    pub fn index(p: usize, q: usize) -> usize {
        (p + q) * (p + q + 1) / 2 + q
    }

    /// Total degree `M`.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The coefficients, `1, x, y, x^2, xy, y^2, ...`.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// The coefficient of `x^p y^q`, zero beyond the degree.
    #[must_use]
    pub fn coefficient(&self, p: usize, q: usize) -> f64 {
        self.coefficients.get(Self::index(p, q)).copied().unwrap_or(0.0)
    }

    /// The value at `[x, y]`.
    #[must_use]
    pub fn at(&self, [x, y]: [f64; 2]) -> f64 {
        (0..=self.degree).rev().fold(0.0, |sum, p| {
            let row = (0..=self.degree - p).rev();
            sum * x + row.fold(0.0, |row, q| row * y + self.coefficient(p, q))
        })
    }

    /// The coefficients of the same polynomial in the harmonics of `ellipse`, in the order of
    /// [`harmonics::even_indices`]. Exact but for rounding, and well conditioned.
    #[must_use]
    pub fn to_harmonics(&self, ellipse: Ellipse) -> Vec<f64> {
        // Horner's scheme in x/a, of rows that are Horner's scheme in y/b.
        (0..=self.degree).rev().fold(vec![], |sum, p| {
            let row = (0..=self.degree - p).rev().fold(vec![], |row, q| {
                let unit = ellipse.a().powi(power(p)) * ellipse.b().powi(power(q));
                plus_constant(times(Axis::Y, &row), self.coefficient(p, q) * unit)
            });
            plus(times(Axis::X, &sum), &row)
        })
    }

    /// The polynomial with these coefficients in the harmonics of `ellipse`.
    ///
    /// The monomials nearly depend on each other on an ellipse: their coefficients grow as
    /// `(1 + sqrt 2)^M` and their sum loses as many digits, four at degree 10, eight at 20.
    ///
    /// # Errors
    /// [`PolynomialError`] when the number of coefficients fits no degree, or a coefficient is
    /// not finite.
    pub fn from_harmonics(ellipse: Ellipse, harmonics: &[f64]) -> Result<Self, PolynomialError> {
        let degree = Self::new(harmonics.to_vec())?.degree;
        let mut coefficients = vec![0.0; polynomial_count(degree)];
        for m in 0..=degree {
            add_order(degree, m, harmonics, &mut coefficients);
        }
        for (p, q) in exponents(degree) {
            let unit = ellipse.a().powi(power(p)) * ellipse.b().powi(power(q));
            coefficients[Self::index(p, q)] /= unit;
        }
        Self::new(coefficients)
    }
}

/// All `(p, q)` with `p + q <= degree`, in the order of the coefficients.
pub(super) fn exponents(degree: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..=degree).flat_map(|total| (0..=total).map(move |q| (total - q, q)))
}

/// An exponent for `powi`; a degree beyond its range would not fit any memory.
fn power(exponent: usize) -> i32 {
    i32::try_from(exponent).unwrap_or(i32::MAX)
}

/// [`products::times_axis`] of a table of any degree; the empty table is zero.
fn times(axis: Axis, table: &[f64]) -> Vec<f64> {
    let degree = harmonics::degree_of(table.len());
    if table.is_empty() { vec![] } else { products::times_axis(axis, degree, table) }
}

fn plus_constant(table: Vec<f64>, value: f64) -> Vec<f64> {
    plus(table, &[value * std::f64::consts::TAU.sqrt()])
}

/// The sum of two tables, the first at least as long or empty.
fn plus(mut table: Vec<f64>, other: &[f64]) -> Vec<f64> {
    table.resize(table.len().max(other.len()), 0.0);
    table.iter_mut().zip(other).for_each(|(sum, value)| *sum += value);
    table
}

/// Adds all harmonics of order `m`, cosine and sine, times their coefficients.
///
/// `Y_mm` is `(x + i y)^m`, and `z^2 Y_nm` combines `Y_{n-2}`, `Y_n` and `Y_{n+2}`.
fn add_order(degree: usize, m: usize, harmonics: &[f64], sum: &mut [f64]) {
    for (sine, order) in [(false, m.cast_signed()), (true, -m.cast_signed())] {
        if sine && m == 0 {
            continue;
        }
        let (mut previous, mut current) = (vec![0.0; sum.len()], sectoral(degree, m, sine));
        for n in (m..=degree).step_by(2) {
            let weight = harmonics[position(n, order)];
            sum.iter_mut().zip(&current).for_each(|(sum, value)| *sum += weight * value);
            if n + 2 <= degree {
                (previous, current) =
                    (current.clone(), next_harmonic(degree, [n, m], &previous, &current));
            }
        }
    }
}

/// `Y_{n+2,m}` from `Y_{n-2,m}` and `Y_nm`, as monomials in `x/a`, `y/b`.
fn next_harmonic(degree: usize, [n, m]: [usize; 2], previous: &[f64], current: &[f64]) -> Vec<f64> {
    let below = if n > m { coupling(n, m) * coupling(n - 1, m) } else { 0.0 };
    let here = coupling(n + 1, m).powi(2) + coupling(n, m).powi(2);
    let ahead = coupling(n + 2, m) * coupling(n + 1, m);
    let mut next = vec![0.0; current.len()];
    for (p, q) in exponents(degree) {
        let at = |p, q| current[Polynomial::index(p, q)];
        // Multiplication by 1 - (x/a)^2 - (y/b)^2.
        let squares =
            if p >= 2 { at(p - 2, q) } else { 0.0 } + if q >= 2 { at(p, q - 2) } else { 0.0 };
        let index = Polynomial::index(p, q);
        next[index] = ((1.0 - here) * at(p, q) - squares - below * previous[index]) / ahead;
    }
    next
}

/// `Y_mm` (or its sine) as monomials in `x/a`, `y/b`.
fn sectoral(degree: usize, m: usize, sine: bool) -> Vec<f64> {
    let mut values = vec![0.0; polynomial_count(degree)];
    // On the edge at angle zero all of Y_mm is its factor of r^m cos(mf).
    let mut binomial = 0.0;
    harmonics::visit(m, [1.0, 0.0], |n, order, value| {
        if n == m && order == m.cast_signed() {
            binomial = value;
        }
    });
    for q in 0..=m {
        // i^q: real powers alternate for the cosine, imaginary ones for the sine.
        if (q % 2 == 1) == sine {
            let sign = if (q / 2) % 2 == 0 { 1.0 } else { -1.0 };
            values[Polynomial::index(m - q, q)] = sign * binomial;
        }
        binomial *= (m - q) as f64 / (q + 1) as f64;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(degree: usize) -> Vec<f64> {
        (0..polynomial_count(degree)).map(|i| (1.9 * i as f64 + 0.2).sin()).collect()
    }

    #[test]
    fn harmonics_of_a_polynomial_have_its_values() {
        let ellipse = Ellipse::new(0.7, 2.5).unwrap();
        let polynomial = Polynomial::new(sample(9)).unwrap();
        let point = [0.3, -1.1];
        let [value] = harmonics::sum(
            9,
            [point[0] / ellipse.a(), point[1] / ellipse.b()],
            [&polynomial.to_harmonics(ellipse)],
        );
        // Rounding only: monomials reach 2.5^9.
        assert!((value - polynomial.at(point)).abs() < 1e-12 * 2.5_f64.powi(9));
    }

    #[test]
    fn there_and_back() {
        let ellipse = Ellipse::new(1.3, 0.8).unwrap();
        for (degree, tolerance) in [(0, 1e-15), (3, 1e-14), (10, 1e-11)] {
            let polynomial = Polynomial::new(sample(degree)).unwrap();
            let back =
                Polynomial::from_harmonics(ellipse, &polynomial.to_harmonics(ellipse)).unwrap();
            // The tolerance follows the documented loss of digits.
            for (one, other) in polynomial.coefficients().iter().zip(back.coefficients()) {
                assert!((one - other).abs() < tolerance, "degree {degree}: {one} {other}");
            }
        }
    }

    #[test]
    fn nonsense_is_an_error() {
        assert_eq!(Polynomial::new(vec![]), Err(PolynomialError::Count { given: 0 }));
        assert_eq!(Polynomial::new(vec![1.0; 4]), Err(PolynomialError::Count { given: 4 }));
        assert!(matches!(Polynomial::new(vec![f64::NAN]), Err(PolynomialError::Invalid(_))));
        assert!(Polynomial::zero(2).coefficient(7, 1).abs() < f64::MIN_POSITIVE);
    }
}
