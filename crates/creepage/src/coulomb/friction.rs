//! Coulomb's law as a projection: a traction (over its bound) and a slip obey it when the traction plus a positive
//! multiple of the slip projects on the unit disc as that traction.
//!
//! An element that changes between adhesion and slip bends the force as a function of creepage.
//! So the solver rounds the projection's corner, over a width that shrinks with the elements.

/// Rounding of the projection's corner, and its half-width.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) enum Regularization {
    #[default]
    Sharp,
    /// By a polynomial above the corner's middle and below its ends, whose mean error is zero.
    Unbiased(f64),
    /// By a parabola below the corner. It nowhere falls, as the sharp one: then Newton's way does not end
    /// between two solutions, which falling branches have.
    Monotone(f64),
}

impl Regularization {
    pub(crate) fn half_width(self) -> f64 {
        match self {
            Self::Sharp => 0.0,
            Self::Unbiased(half_width) | Self::Monotone(half_width) => half_width,
        }
    }

    /// `min(size, 1)` rounded, and its slope. With `x = (size - 1)/half_width` it is
    /// `1 + half_width (x - m)/2`, where `m` joins `|x|` smoothly at -1 and 1: `(1 + x^2)/2`, or
    /// `3/16 + 9/8 x^2 - 5/16 x^4`, which has the mean of `|x|`.
    fn rounded(self, size: f64) -> (f64, f64) {
        let half_width = self.half_width();
        if size >= 1.0 + half_width {
            return (1.0, 0.0);
        }
        let x = (size - 1.0) / half_width;
        let (m, slope) = self.smooth_abs(x);
        (1.0 + 0.5 * half_width * (x - m), 0.5 - 0.5 * slope)
    }

    /// `m` between -1 and 1, and its slope.
    fn smooth_abs(self, x: f64) -> (f64, f64) {
        let square = x * x;
        if matches!(self, Self::Monotone(_)) {
            (0.5 + 0.5 * square, x)
        } else {
            (0.1875 + square * (1.125 - 0.3125 * square), x * (2.25 - 1.25 * square))
        }
    }

    /// The derivative of `min(size, 1)` rounded by the half-width.
    fn by_half_width(self, size: f64) -> f64 {
        let x = (size - 1.0) / self.half_width();
        let (m, slope) = self.smooth_abs(x);
        if x.abs() < 1.0 { 0.5 * (x * slope - m) } else { 0.0 }
    }
}

/// The sliding branch of the projection at one element.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sliding {
    /// The projected traction, of about unit size.
    pub traction: [f64; 2],
    /// Derivative of the projected traction by `traction + weight * slip`.
    pub derivative: [[f64; 2]; 2],
    /// Beyond the rounded corner: the traction turns, its size stays.
    pub at_bound: bool,
    /// Below the corner, where traction grows with what slip remains: [`project_within`].
    pub holds: bool,
}

/// The projection of `trial = traction + weight * slip`: `None` where it is the trial itself, in
/// adhesion.
pub(crate) fn project(trial: [f64; 2], corner: Regularization) -> Option<Sliding> {
    let size = (trial[0] * trial[0] + trial[1] * trial[1]).sqrt();
    if size <= 1.0 - corner.half_width() {
        return None;
    }
    let (projected, slope) = corner.rounded(size);
    let [x, y] = [trial[0] / size, trial[1] / size];
    let turn = projected / size;
    let bend = slope - turn;
    Some(Sliding {
        traction: [projected * x, projected * y],
        derivative: [[turn + bend * x * x, bend * x * y], [bend * x * y, turn + bend * y * y]],
        at_bound: size >= 1.0 + corner.half_width(),
        holds: false,
    })
}

/// The same on a disc of radius `limit`, greater than zero, where adhesion leaves a slip of `compliance` times
/// the traction over the weight: the solution then is `weight * slip = compliance * traction` below the bound.
pub(crate) fn project_within(
    limit: f64,
    compliance: f64,
    trial: [f64; 2],
    corner: Regularization,
) -> Option<Sliding> {
    let part = 1.0 / (1.0 + compliance);
    let shared = trial.map(|t| part * t / limit);
    let sliding = match project(shared, corner) {
        None if compliance > 0.0 => held(shared),
        sliding => sliding?,
    };
    Some(Sliding {
        traction: sliding.traction.map(|t| limit * t),
        derivative: sliding.derivative.map(|row| row.map(|d| part * d)),
        ..sliding
    })
}

/// The change of the same projection with the half-width of its corner.
pub(crate) fn by_half_width(
    limit: f64,
    compliance: f64,
    trial: [f64; 2],
    corner: Regularization,
) -> [f64; 2] {
    let size = trial[0].hypot(trial[1]);
    let change = limit * corner.by_half_width(size / (limit * (1.0 + compliance)));
    if change == 0.0 { [0.0; 2] } else { trial.map(|t| change * t / size) }
}

/// A traction below the corner.
fn held(traction: [f64; 2]) -> Sliding {
    Sliding { traction, derivative: [[1.0, 0.0], [0.0, 1.0]], at_bound: false, holds: true }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_trials_adhere() {
        assert!(project([0.9, 0.0], Regularization::Monotone(0.1)).is_none());
    }

    /// Central differences of step 1e-6, in the rounded corner and beyond: their error is of order
    /// 1e-10.
    #[test]
    fn the_derivative_is_that_of_the_projection() {
        let h = 1e-6;
        for corner in
            [Regularization::Sharp, Regularization::Unbiased(0.1), Regularization::Monotone(0.1)]
        {
            for trial in [[0.75, -0.67], [0.8, -0.7], [1.2, -0.7]] {
                let sliding = project(trial, corner).unwrap();
                for k in 0..2 {
                    let at = |h: f64| {
                        let mut moved = trial;
                        moved[k] += h;
                        project(moved, corner).unwrap().traction
                    };
                    for row in 0..2 {
                        let numeric = (at(h)[row] - at(-h)[row]) / (2.0 * h);
                        assert!((numeric - sliding.derivative[row][k]).abs() < 1e-9);
                    }
                }
            }
        }
    }

    /// The same within a limit, below and beyond the corner, where adhesion gives way; below it the slip
    /// that is left goes with the traction.
    #[test]
    fn adhesion_that_gives_way_is_a_smooth_law_too() {
        let (h, limit, compliance, corner) = (1e-6, 0.8, 0.3, Regularization::Unbiased(0.1));
        for trial in [[0.4, -0.3], [0.8, -0.62], [1.2, -0.7]] {
            let at = |trial| project_within(limit, compliance, trial, corner).unwrap();
            let found = at(trial);
            for k in 0..2 {
                let moved = |h: f64| [0, 1].map(|i| trial[i] + if i == k { h } else { 0.0 });
                let [ahead, behind] = [h, -h].map(|h| at(moved(h)).traction);
                for row in 0..2 {
                    let numeric = (ahead[row] - behind[row]) / (2.0 * h);
                    assert!((numeric - found.derivative[row][k]).abs() < 1e-9);
                }
                let slip = trial[k] - found.traction[k];
                assert!(!found.holds || (slip - compliance * found.traction[k]).abs() < 1e-15);
            }
        }
        assert!(project_within(limit, 0.0, [0.4, -0.3], corner).is_none());
    }

    /// Central differences of step 1e-6, below the corner, in it and beyond.
    #[test]
    fn the_projection_changes_with_the_width_of_its_corner() {
        let (h, limit, compliance) = (1e-6, 0.8, 0.3);
        for corner in [Regularization::Unbiased, Regularization::Monotone] {
            for trial in [[0.4, -0.3], [0.8, -0.62], [0.85, -0.62], [1.2, -0.7], [0.0, 0.0]] {
                let at = |half_width| {
                    project_within(limit, compliance, trial, corner(half_width)).unwrap().traction
                };
                let [ahead, behind] = [0.1 + h, 0.1 - h].map(at);
                let found = by_half_width(limit, compliance, trial, corner(0.1));
                for k in 0..2 {
                    let numeric = (ahead[k] - behind[k]) / (2.0 * h);
                    assert!((numeric - found[k]).abs() < 1e-9, "{trial:?} {numeric} {found:?}");
                }
            }
        }
    }

    /// Both corners are joined with their slope. The errors of one cancel, a midpoint sum of 2000 terms;
    /// the other nowhere falls nor exceeds the bound.
    #[test]
    fn rounded_corners_keep_what_they_promise() {
        let (half_width, n) = (0.2, 2000);
        let at = |k: i32| 0.8 + 0.4 * (f64::from(k) + 0.5) / f64::from(n);
        let (unbiased, monotone) =
            (Regularization::Unbiased(half_width), Regularization::Monotone(half_width));
        let error: f64 = (0..n).map(|k| unbiased.rounded(at(k)).0 - at(k).min(1.0)).sum();
        assert!((error / f64::from(n)).abs() < 1e-7);
        assert!(
            (0..n)
                .map(|k| monotone.rounded(at(k)))
                .all(|(value, slope)| value <= 1.0 && slope >= 0.0)
        );
        for (size, slope) in [(0.8, 1.0), (1.2 - 1e-12, 0.0)] {
            for corner in [unbiased, monotone] {
                let (value, found) = corner.rounded(size);
                assert!((value - size.min(1.0)).abs() < 1e-11 && (found - slope).abs() < 1e-10);
            }
        }
    }
}
