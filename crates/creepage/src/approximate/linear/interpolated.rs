//! Interpolated coefficients in a microsecond, by series in the shape and Poisson's ratio.
//!
//! Over each of a few ranges of `ln(a/b)` and over all of Poisson's ratio they are a sum of products of
//! Chebyshev's polynomials, fitted to the solution of twice the degree of [`CreepageCoefficients::new`].
//! They are analytic in both: the shape's nearest singularity is `a/b = i`, that of the ratio at 1.

use super::{CreepageCoefficients, checked};
use crate::check::InvalidValue;
use crate::contact::Contact;

/// Ranges of `ln(a/b)`, of one width.
const RANGES: usize = 8;
/// Polynomials in `ln(a/b)`.
const SHAPES: usize = 16;
/// Polynomials in Poisson's ratio.
const MATERIALS: usize = 14;
/// `C11, C22, C23, C33`.
const NUMBERS: usize = 4;
/// Numbers of one range: of each product of polynomials, one of each coefficient.
const LENGTH: usize = SHAPES * MATERIALS * NUMBERS;

/// Little-endian numbers of all ranges; the tests compare them with the solution, and write them anew.
static SERIES: &[u8; RANGES * LENGTH * size_of::<f64>()] = include_bytes!("interpolated.f64");

impl CreepageCoefficients {
    /// The coefficients to a relative accuracy of 1e-8 in less than a microsecond: what theories are
    /// prepared with that take no more than the coefficients.
    ///
    /// ```
    /// use creepage::approximate::linear::CreepageCoefficients;
    /// use creepage::{Contact, Ellipse};
    /// let contact = Contact::new(Ellipse::from_ratio(1.5)?, 0.28)?;
    /// let quick = CreepageCoefficients::interpolated(&contact)?;
    /// let solved = CreepageCoefficients::new(&contact)?;
    /// assert!((quick.c11 / solved.c11 - 1.0).abs() < 1e-8);
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    ///
    /// # Errors
    /// As [`CreepageCoefficients::new`].
    pub fn interpolated(contact: &Contact) -> Result<Self, InvalidValue> {
        let (range, shape) = place(checked(contact)?.ratio());
        let (shapes, materials): ([f64; SHAPES], [f64; MATERIALS]) =
            (polynomials(shape), polynomials(4.0 * contact.poisson() - 1.0));
        let products = shapes.iter().flat_map(|t| materials.iter().map(move |s| t * s));
        let (series, _) = SERIES.as_chunks().0[range * LENGTH..][..LENGTH].as_chunks();
        let mut sums = [0.0; NUMBERS];
        for (product, terms) in products.zip(series) {
            let terms: &[[u8; size_of::<f64>()]; NUMBERS] = terms;
            for (sum, term) in sums.iter_mut().zip(terms) {
                *sum += product * f64::from_le_bytes(*term);
            }
        }
        let [c11, c22, c23, c33] = sums;
        Ok(Self { c11, c22, c23, c32: -c23, c33 })
    }
}

/// The range in which a shape lies, and where in it, from -1 to 1.
// A small positive number by construction.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn place(ratio: f64) -> (usize, f64) {
    let [low, high] = CreepageCoefficients::RATIO_RANGE.map(f64::ln);
    let place = (ratio.ln() - low) / (high - low) * RANGES as f64;
    let range = (place as usize).min(RANGES - 1);
    (range, 2.0 * (place - range as f64) - 1.0)
}

/// Chebyshev's polynomials `T_0`, `T_1` and so on.
fn polynomials<const N: usize>(x: f64) -> [f64; N] {
    let (mut last, mut next) = (1.0, x);
    std::array::from_fn(|_| {
        let this = last;
        (last, next) = (next, 2.0 * x * next - last);
        this
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use proptest::prelude::*;

    use super::super::compensation::Criterion;
    use super::super::sufficient_degree;
    use super::*;
    use crate::ellipse::Ellipse;

    fn solved(ratio: f64, poisson: f64) -> [f64; NUMBERS] {
        let ellipse = Ellipse::from_ratio(ratio).unwrap();
        let degree = 2 * sufficient_degree(ellipse);
        let energy = Criterion::Energy;
        let c = CreepageCoefficients::raw(ellipse, poisson, degree, energy).reciprocal();
        [c.c11, c.c22, c.c23, c.c33]
    }

    /// Points of interpolation, from -1 to 1.
    fn nodes<const N: usize>() -> [f64; N] {
        std::array::from_fn(|k| (PI * (k as f64 + 0.5) / N as f64).cos())
    }

    /// Series of one range: sums over the points, for Chebyshev's polynomials are orthogonal there.
    fn fitted(range: usize) -> Vec<f64> {
        let [low, high] = CreepageCoefficients::RATIO_RANGE.map(f64::ln);
        let width = (high - low) / RANGES as f64;
        let mut series = vec![0.0; LENGTH];
        for shape in nodes::<SHAPES>() {
            let ratio = (low + (range as f64 + 0.5 * (shape + 1.0)) * width).exp();
            let shapes: [f64; SHAPES] = polynomials(shape);
            for material in nodes::<MATERIALS>() {
                let materials: [f64; MATERIALS] = polynomials(material);
                let values = solved(ratio, 0.25 * (material + 1.0));
                for k in 0..LENGTH {
                    let (j, i) = (k / NUMBERS % MATERIALS, k / NUMBERS / MATERIALS);
                    let halves = [i, j].map(|degree| if degree == 0 { 1.0 } else { 2.0 });
                    let weight = halves[0] * halves[1] / (SHAPES * MATERIALS) as f64;
                    series[k] += weight * shapes[i] * materials[j] * values[k % NUMBERS];
                }
            }
        }
        series
    }

    /// `CREEPAGE_WRITE_COEFFICIENTS=1 cargo test -p creepage --lib interpolated` writes them anew.
    #[test]
    fn the_series_are_fitted_to_the_solution() {
        if std::env::var_os("CREEPAGE_WRITE_COEFFICIENTS").is_some() {
            let all: Vec<u8> = (0..RANGES).flat_map(fitted).flat_map(f64::to_le_bytes).collect();
            let here = concat!(env!("CARGO_MANIFEST_DIR"), "/src/approximate/linear");
            std::fs::write(format!("{here}/interpolated.f64"), all).unwrap();
            return;
        }
        let (kept, _) = SERIES.as_chunks();
        let range = RANGES / 2;
        for (k, fitted) in fitted(range).into_iter().enumerate() {
            // Rounding of sums over points, on any processor.
            assert!((fitted - f64::from_le_bytes(kept[range * LENGTH + k])).abs() < 1e-12);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]
        #[test]
        fn they_are_the_solution_s(log in -3.0..3.0_f64, poisson in 0.0..0.5) {
            let ratio = 10_f64.powf(log);
            let contact = Contact::new(Ellipse::from_ratio(ratio).unwrap(), poisson).unwrap();
            let c = CreepageCoefficients::interpolated(&contact).unwrap();
            for (quick, solved) in [c.c11, c.c22, c.c23, c.c33].into_iter().zip(solved(ratio, poisson)) {
                let error = (quick / solved - 1.0).abs();
                prop_assert!(error < 1e-8, "{error:e} a/b {ratio}, {poisson}: {error:e}");
            }
        }
    }

    /// At the borders of the ranges, and of what is given at all.
    #[test]
    fn borders_belong_to_both_sides() {
        for k in 0..=RANGES {
            let border = 10_f64.powf(6.0 * k as f64 / RANGES as f64 - 3.0);
            let at = |ratio: f64| {
                let [low, high] = CreepageCoefficients::RATIO_RANGE;
                let ellipse = Ellipse::from_ratio(ratio.clamp(low, high)).unwrap();
                let contact = Contact::new(ellipse, 0.3).unwrap();
                CreepageCoefficients::interpolated(&contact).unwrap().c23
            };
            let [before, after] = [-1e-12, 1e-12].map(|step: f64| at(border * step.exp()));
            assert!((before / after - 1.0).abs() < 1e-8, "{border}: {before} {after}");
        }
    }
}
