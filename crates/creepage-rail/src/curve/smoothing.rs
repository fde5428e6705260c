//! Smoothing splines by wavelength or by weight.

use super::spline::{check, cubics, runs};
use super::{Cubic, Curve, Line, Piece, SplineError};

/// Strength of a smoothing spline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Smoothing {
    /// Waves of this length (m) keep half of their amplitude, whatever the spacing; longer ones more, shorter ones less.
    Wavelength(f64),
    /// The weight (m3) of the curvature's square beside points that count alike, however far apart they are: where they
    /// are `h` apart, a wave of length `2 pi (weight h)^(1/4)` keeps half.
    Weight(f64),
}

/// The smoothing spline of `points` `(y, z)` (m).
///
/// The curve minimises `sum w_i |x_i - f(s_i)|^2 + lambda int |f''|^2 ds`, each run between `corners` by itself; corners
/// stay in place. By wavelength `w_i` is the point's share of the way, and `lambda = (wavelength / 2 pi)^4`; by weight
/// `w_i` is one, and `lambda` the weight.
///
/// # Errors
/// [`SplineError`] as by [`interpolate`](super::interpolate).
pub fn smooth(
    points: &[[f64; 2]],
    corners: &[usize],
    smoothing: Smoothing,
) -> Result<Curve, SplineError> {
    check(points)?;
    let count = points.len();
    let pieces = runs(points, corners).flat_map(|(run, start)| {
        let ends = [start > 0, start + run.len() < count];
        smooth_run(run, ends, smoothing)
    });
    Curve::new(pieces).ok_or(SplineError::TooFew { count })
}

/// One run; `pinned` says which of its ends stays in place.
fn smooth_run(points: &[[f64; 2]], pinned: [bool; 2], smoothing: Smoothing) -> Vec<Piece> {
    if let [a, b] = points {
        return vec![Line::between(*a, *b)];
    }
    let chords: Vec<f64> =
        points.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).collect();
    let compliances = compliances(&chords, pinned, smoothing);
    let [y, z] = [0, 1].map(|axis| {
        let values: Vec<f64> = points.iter().map(|p| p[axis]).collect();
        let (values, bends) = smoothed(&chords, &values, &compliances);
        cubics(&chords, &values, &bends)
    });
    y.into_iter().zip(z).map(|(y, z)| Cubic::from_coefficients(y, z)).collect()
}

/// `lambda / w` of every point; none of a pinned one.
fn compliances(chords: &[f64], pinned: [bool; 2], smoothing: Smoothing) -> Vec<f64> {
    let mut shares: Vec<f64> = (0..=chords.len())
        .map(|i| {
            let before = i.checked_sub(1).and_then(|i| chords.get(i)).unwrap_or(&0.0);
            let after = chords.get(i).unwrap_or(&0.0);
            match smoothing {
                Smoothing::Wavelength(wavelength) => {
                    (wavelength / std::f64::consts::TAU).powi(4) / (0.5 * (before + after))
                }
                Smoothing::Weight(weight) => weight,
            }
        })
        .collect();
    if let (true, Some(first)) = (pinned[0], shares.first_mut()) {
        *first = 0.0;
    }
    if let (true, Some(last)) = (pinned[1], shares.last_mut()) {
        *last = 0.0;
    }
    shares
}

/// Smoothed values and their second derivatives by Reinsch's equations
/// `(R + Q' C Q) g = Q' x`, `f = x - C Q g`, `C` the compliances.
fn smoothed(chords: &[f64], values: &[f64], compliances: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let stencils: Vec<[f64; 3]> =
        chords.windows(2).map(|h| [1.0 / h[0], -1.0 / h[0] - 1.0 / h[1], 1.0 / h[1]]).collect();
    let rows: Vec<[f64; 4]> = (0..stencils.len())
        .map(|i| bands(chords, &stencils, compliances, i))
        .zip(stencils.iter().zip(values.windows(3)))
        .map(|([d, e, f], (q, x))| [d, e, f, q[0] * x[0] + q[1] * x[1] + q[2] * x[2]])
        .collect();
    let inner = pentadiagonal(rows);
    let mut moved = values.to_vec();
    for (i, (q, g)) in stencils.iter().zip(&inner).enumerate() {
        for (offset, weight) in q.iter().enumerate() {
            if let (Some(x), Some(c)) = (moved.get_mut(i + offset), compliances.get(i + offset)) {
                *x -= c * weight * g;
            }
        }
    }
    (moved, [&[0.0], inner.as_slice(), &[0.0]].concat())
}

/// Row `i` of the symmetric matrix: diagonal and two bands above.
fn bands(chords: &[f64], stencils: &[[f64; 3]], compliances: &[f64], i: usize) -> [f64; 3] {
    let h = |i: usize| chords.get(i).copied().unwrap_or(0.0);
    let q = |i: usize| stencils.get(i).copied().unwrap_or([0.0; 3]);
    let c = |i: usize| compliances.get(i).copied().unwrap_or(0.0);
    let ([a0, b0, c0], [a1, b1, _], [a2, _, _]) = (q(i), q(i + 1), q(i + 2));
    [
        (h(i) + h(i + 1)) / 3.0 + a0 * a0 * c(i) + b0 * b0 * c(i + 1) + c0 * c0 * c(i + 2),
        h(i + 1) / 6.0 + b0 * a1 * c(i + 1) + c0 * b1 * c(i + 2),
        c0 * a2 * c(i + 2),
    ]
}

/// Solves a symmetric positive definite matrix of rows `[diagonal, band, band, right]`.
fn pentadiagonal(mut rows: Vec<[f64; 4]>) -> Vec<f64> {
    for i in 0..rows.len() {
        let Some(&[d, e, f, right]) = rows.get(i) else { break };
        if let Some(next) = rows.get_mut(i + 1) {
            next[0] -= e * e / d;
            next[1] -= e * f / d;
            next[3] -= right * e / d;
        }
        if let Some(after) = rows.get_mut(i + 2) {
            after[0] -= f * f / d;
            after[3] -= right * f / d;
        }
    }
    let [mut next, mut after] = [0.0; 2];
    let mut solution: Vec<f64> = rows
        .iter()
        .rev()
        .map(|[d, e, f, right]| {
            (after, next) = (next, (right - e * next - f * after) / d);
            next
        })
        .collect();
    solution.reverse();
    solution
}
