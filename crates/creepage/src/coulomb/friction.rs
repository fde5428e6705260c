//! The law of Coulomb as a projection: a traction (over its bound) and a slip obey it when the
//! traction plus a positive multiple of the slip projects on the unit disc as that traction.
//!
//! An element that changes between adhesion and slip bends the force as a function of creepage.
//! So the solver rounds the projection's corner, over a width that shrinks with the elements: by a
//! polynomial above the corner's middle and below its ends, whose mean error is zero.

/// The sliding branch of the projection at one element.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sliding {
    /// The projected traction, of about unit size.
    pub traction: [f64; 2],
    /// Derivative of the projected traction by `traction + weight * slip`.
    pub derivative: [[f64; 2]; 2],
}

/// The projection of `trial = traction + weight * slip`: `None` where it is the trial itself, in
/// adhesion. `rounding` is the half-width of the rounded corner.
pub(crate) fn project(trial: [f64; 2], rounding: f64) -> Option<Sliding> {
    let size = (trial[0] * trial[0] + trial[1] * trial[1]).sqrt();
    if size <= 1.0 - rounding {
        return None;
    }
    let (projected, slope) = rounded(size, rounding);
    let [x, y] = [trial[0] / size, trial[1] / size];
    let turn = projected / size;
    let bend = slope - turn;
    Some(Sliding {
        traction: [projected * x, projected * y],
        derivative: [[turn + bend * x * x, bend * x * y], [bend * x * y, turn + bend * y * y]],
    })
}

/// `min(size, 1)` with its corner rounded, and its slope. With `x = (size - 1)/rounding` it is
/// `1 + rounding (x - m)/2`, where `m = 3/16 + 9/8 x^2 - 5/16 x^4` joins `|x|` smoothly at -1 and 1
/// and has its mean.
fn rounded(size: f64, rounding: f64) -> (f64, f64) {
    if size >= 1.0 + rounding {
        return (1.0, 0.0);
    }
    let x = (size - 1.0) / rounding;
    let square = x * x;
    let m = 0.1875 + square * (1.125 - 0.3125 * square);
    (1.0 + 0.5 * rounding * (x - m), 0.5 - x * (1.125 - 0.625 * square))
}

/// The same on a disc of radius `limit`, greater than zero.
pub(crate) fn project_within(limit: f64, trial: [f64; 2], rounding: f64) -> Option<Sliding> {
    let sliding = project(trial.map(|t| t / limit), rounding)?;
    Some(Sliding { traction: sliding.traction.map(|t| limit * t), ..sliding })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_trials_adhere() {
        assert!(project([0.9, 0.0], 0.1).is_none());
    }

    /// Central differences of step 1e-6, in the rounded corner and beyond: their error is of order
    /// 1e-10.
    #[test]
    fn the_derivative_is_that_of_the_projection() {
        let h = 1e-6;
        for trial in [[0.75, -0.6], [0.8, -0.7], [1.2, -0.7]] {
            let sliding = project(trial, 0.1).unwrap();
            for k in 0..2 {
                let at = |h: f64| {
                    let mut moved = trial;
                    moved[k] += h;
                    project(moved, 0.1).unwrap().traction
                };
                for row in 0..2 {
                    let numeric = (at(h)[row] - at(-h)[row]) / (2.0 * h);
                    assert!((numeric - sliding.derivative[row][k]).abs() < 1e-9);
                }
            }
        }
    }

    /// The corner is joined with its slope, and its errors cancel; a midpoint sum of 2000 terms.
    #[test]
    fn the_rounded_corner_has_no_bias() {
        let (rounding, n) = (0.2, 2000);
        let at = |k: i32| 0.8 + 0.4 * (f64::from(k) + 0.5) / f64::from(n);
        let error: f64 = (0..n).map(|k| rounded(at(k), rounding).0 - at(k).min(1.0)).sum();
        assert!((error / f64::from(n)).abs() < 1e-7);
        for (size, slope) in [(0.8, 1.0), (1.2 - 1e-12, 0.0)] {
            let (value, found) = rounded(size, rounding);
            assert!((value - size.min(1.0)).abs() < 1e-11 && (found - slope).abs() < 1e-10);
        }
    }
}
