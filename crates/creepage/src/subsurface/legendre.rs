//! Legendre's functions of the second kind off the cut, from which a harmonic's potential is made:
//!
//! ```math
//! Q_n(\zeta) = \frac12 \int_{-1}^{1} \frac{P_n(h)}{\zeta - h} \, dh
//! ```

use nalgebra::Complex;

/// Steps of the continued fraction, at most.
const MAX_STEPS: f64 = 400.0;

/// `Q_0`, `Q_1`, ... at `zeta = 1 + from_end` into `values`, for `Im zeta <= 0`; on the cut,
/// where the imaginary part is a negative zero, the limit from below.
///
/// Forward recurrence loses `rho^(2n)` in accuracy, `rho` being the sum of the semi-axes of the
/// ellipse with foci at the ends of the cut; where that matters the ratios of neighbours come from
/// the continued fraction, whose error falls by `rho^2` a step.
pub(super) fn second_kind(from_end: Complex<f64>, values: &mut [Complex<f64>]) {
    let zeta = from_end + 1.0;
    let first = logarithm(from_end);
    let Some((last, _)) = values.split_last_mut() else { return };
    *last = first;
    let degree = values.len() - 1;
    if degree == 0 {
        return;
    }
    values[0] = first;
    let growth = (zeta + (from_end * (from_end + 2.0)).sqrt()).norm().ln().abs();
    if 2.0 * degree as f64 * growth < 4.0 {
        forward(zeta, values);
    } else {
        backward(zeta, growth, values);
    }
}

/// `Q_0 = ln((zeta + 1)/(zeta - 1)) / 2`.
fn logarithm(from_end: Complex<f64>) -> Complex<f64> {
    // At the very end of the cut the logarithm is infinite, but no sum over directions feels it.
    let size = from_end.norm().max(1e-30);
    let other = from_end + 2.0;
    let real = 0.5 * (other.norm() / size).ln();
    Complex::new(real, 0.5 * (other.arg() - from_end.im.atan2(from_end.re)))
}

fn forward(zeta: Complex<f64>, values: &mut [Complex<f64>]) {
    values[1] = zeta * values[0] - 1.0;
    for n in 1..values.len() - 1 {
        let n_real = n as f64;
        let next = (2.0 * n_real + 1.0) * zeta * values[n] - n_real * values[n - 1];
        values[n + 1] = next / (n_real + 1.0);
    }
}

// A count of steps below a bound, positive by construction.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn backward(zeta: Complex<f64>, growth: f64, values: &mut [Complex<f64>]) {
    let degree = values.len() - 1;
    let extra = (20.0 / growth).ceil().min(MAX_STEPS) as usize;
    let mut ratio = Complex::new(0.0, 0.0);
    for n in (1..=degree + extra).rev() {
        let n_real = n as f64;
        ratio = n_real / ((2.0 * n_real + 1.0) * zeta - (n_real + 1.0) * ratio);
        if n <= degree {
            values[n] = ratio;
        }
    }
    for n in 1..=degree {
        values[n] *= values[n - 1];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the definition, by Gauss's rule of 200 nodes: far enough from the cut for rounding.
    #[test]
    fn the_definition_is_met() {
        let rule = gauss_quad::GaussLegendre::new(200.try_into().unwrap());
        for zeta in [[0.3, -0.4], [1.4, -0.01], [3.0, 0.0], [0.0, -20.0], [-1.2, -0.3]] {
            let zeta = Complex::new(zeta[0], zeta[1]);
            let mut values = [Complex::new(0.0, 0.0); 9];
            second_kind(zeta - 1.0, &mut values);
            let mut expected = [Complex::new(0.0, 0.0); 9];
            for &(h, weight) in &rule {
                let mut p = [1.0, h];
                for (n, sum) in expected.iter_mut().enumerate() {
                    *sum += 0.5 * weight * p[0] / (zeta - h);
                    let n = n as f64 + 1.0;
                    p = [p[1], ((2.0 * n + 1.0) * h * p[1] - n * p[0]) / (n + 1.0)];
                }
            }
            for (value, expected) in values.iter().zip(expected) {
                assert!((value - expected).norm() < 1e-13, "{zeta}: {value} {expected}");
            }
        }
    }

    #[test]
    fn the_cut_is_met_from_below() {
        let mut values = [Complex::new(0.0, 0.0); 2];
        second_kind(Complex::new(-0.7, -0.0), &mut values);
        let q0 = 0.5 * (1.3_f64 / 0.7).ln();
        assert!((values[0] - Complex::new(q0, std::f64::consts::FRAC_PI_2)).norm() < 1e-15);
    }
}
