//! Splines through points: continuous slope and curvature, corners where asked.

use super::{Cubic, Curve, Line, Piece};

/// Error of points through which no curve goes.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SplineError {
    /// A curve needs two points at least.
    #[error("{count} points: a curve needs 2 at least")]
    TooFew {
        /// Number of points.
        count: usize,
    },
    /// Two consecutive points coincide, or one is not finite.
    #[error("points {index} and {} coincide or are not finite", index + 1)]
    NotApart {
        /// Index of the first of the two, from 0.
        index: usize,
    },
}

/// The curve through `points` `(y, z)` (m), cubic by chord length, with continuous slope and
/// curvature but at the points named in `corners` (rising indices).
///
/// Ends and corners carry no condition of their own: the first two cubics are one (not-a-knot).
///
/// # Errors
/// [`SplineError`] for fewer than two points, points that coincide, and values not finite.
pub fn interpolate(points: &[[f64; 2]], corners: &[usize]) -> Result<Curve, SplineError> {
    check(points)?;
    let pieces = runs(points, corners).flat_map(|(run, _)| smooth_run(run));
    Curve::new(pieces).ok_or(SplineError::TooFew { count: points.len() })
}

/// Consecutive points must lie apart.
pub(super) fn check(points: &[[f64; 2]]) -> Result<(), SplineError> {
    let apart = |pair: &[[f64; 2]]| {
        let chord = (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        chord > 0.0 && chord.is_finite()
    };
    match points.windows(2).position(|pair| !apart(pair)) {
        Some(index) => Err(SplineError::NotApart { index }),
        None if points.len() < 2 => Err(SplineError::TooFew { count: points.len() }),
        None => Ok(()),
    }
}

/// The runs of points between corners, which belong to both sides, each with its first index.
pub(super) fn runs<'a>(
    points: &'a [[f64; 2]],
    corners: &'a [usize],
) -> impl Iterator<Item = (&'a [[f64; 2]], usize)> {
    let last = points.len().saturating_sub(1);
    let starts = [0].into_iter().chain(corners.iter().copied());
    let ends = corners.iter().copied().chain([last]);
    starts.zip(ends).filter_map(move |(start, end)| {
        points.get(start..=end).filter(|run| run.len() > 1).map(|run| (run, start))
    })
}

/// The cubics through one run of points without corners.
fn smooth_run(points: &[[f64; 2]]) -> Vec<Piece> {
    if let [a, b] = points {
        return vec![Line::between(*a, *b)];
    }
    let chords: Vec<f64> =
        points.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).collect();
    let [y, z] = [0, 1].map(|axis| {
        let values: Vec<f64> = points.iter().map(|p| p[axis]).collect();
        let bends = second_derivatives(&chords, &values);
        cubics(&chords, &values, &bends)
    });
    y.into_iter().zip(z).map(|(y, z)| Cubic::from_coefficients(y, z)).collect()
}

/// Coefficients of `t` (0 to 1) in each interval, from values and second derivatives.
pub(super) fn cubics(chords: &[f64], values: &[f64], bends: &[f64]) -> Vec<[f64; 4]> {
    chords
        .iter()
        .zip(values.windows(2))
        .zip(bends.windows(2))
        .map(|((&h, value), bend)| {
            let (a, b) = (bend[0] * h * h / 6.0, bend[1] * h * h / 6.0);
            [value[0], value[1] - value[0] - 2.0 * a - b, 3.0 * a, b - a]
        })
        .collect()
}

/// Second derivatives of the interpolating spline, not-a-knot at both ends.
fn second_derivatives(chords: &[f64], values: &[f64]) -> Vec<f64> {
    let slopes: Vec<f64> =
        chords.iter().zip(values.windows(2)).map(|(h, v)| (v[1] - v[0]) / h).collect();
    let inner = slopes.len().saturating_sub(1);
    let mut rows: Vec<[f64; 4]> = chords
        .windows(2)
        .zip(slopes.windows(2))
        .map(|(h, d)| [h[0], 2.0 * (h[0] + h[1]), h[1], 6.0 * (d[1] - d[0])])
        .collect();
    if inner == 1 {
        // Three points: one parabola.
        let bend = rows.first().map_or(0.0, |r| r[3] / (r[0] + r[1] + r[2]));
        return vec![bend; 3];
    }
    let first = chords.first().zip(chords.get(1)).map_or(1.0, |(a, b)| a / b);
    let last = chords.last().zip(chords.iter().rev().nth(1));
    let last = last.map_or(1.0, |(a, b)| a / b);
    if let Some(row) = rows.first_mut() {
        row[1] += row[0] * (1.0 + first);
        row[2] -= row[0] * first;
    }
    if let Some(row) = rows.last_mut() {
        row[1] += row[2] * (1.0 + last);
        row[0] -= row[2] * last;
    }
    let middle = tridiagonal(&mut rows);
    let at = |i: usize| middle.get(i).copied().unwrap_or(0.0);
    let head = (1.0 + first) * at(0) - first * at(1);
    let tail = (1.0 + last) * at(inner - 1) - last * at(inner - 2);
    [&[head], middle.as_slice(), &[tail]].concat()
}

/// Slopes at the knots of the interpolating spline, not-a-knot at both ends; of two knots those of the chord.
pub(crate) fn spline_slopes(knots: &[f64], values: &[f64]) -> Vec<f64> {
    let chords: Vec<f64> = knots.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let slopes: Vec<f64> =
        chords.iter().zip(values.windows(2)).map(|(h, v)| (v[1] - v[0]) / h).collect();
    let (Some(&first), true) = (slopes.first(), slopes.len() > 1) else {
        return vec![slopes.first().copied().unwrap_or(0.0); knots.len()];
    };
    let bends = second_derivatives(&chords, values);
    let start = first
        - chords.first().zip(bends.get(..2)).map_or(0.0, |(h, b)| h * (2.0 * b[0] + b[1]) / 6.0);
    let behind = slopes.iter().zip(&chords).zip(bends.windows(2));
    let behind = behind.map(|((slope, h), bend)| slope + h * (bend[0] + 2.0 * bend[1]) / 6.0);
    [start].into_iter().chain(behind).collect()
}

/// Solves rows `[below, diagonal, above, right]` by elimination without pivots.
fn tridiagonal(rows: &mut [[f64; 4]]) -> Vec<f64> {
    let mut before: Option<[f64; 4]> = None;
    for row in rows.iter_mut() {
        if let Some([_, diagonal, above, right]) = before {
            let factor = row[0] / diagonal;
            row[1] -= factor * above;
            row[3] -= factor * right;
        }
        before = Some(*row);
    }
    let mut next = 0.0;
    let mut solution: Vec<f64> = rows
        .iter()
        .rev()
        .map(|[_, diagonal, above, right]| {
            next = (right - above * next) / diagonal;
            next
        })
        .collect();
    solution.reverse();
    solution
}
