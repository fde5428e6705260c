//! The law of Coulomb as a projection: a traction (over its bound) and a slip obey it when the
//! traction plus a positive multiple of the slip projects on the unit disc as that traction.

/// The sliding branch of the projection at one element.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sliding {
    /// The projected traction: a unit vector.
    pub traction: [f64; 2],
    /// Derivative of the projected traction by `traction + weight * slip`.
    pub derivative: [[f64; 2]; 2],
}

/// The projection of `traction + weight * slip`: `None` where it lies inside the disc, in
/// adhesion.
pub(crate) fn project(traction: [f64; 2], slip: [f64; 2], weight: f64) -> Option<Sliding> {
    let trial = [traction[0] + weight * slip[0], traction[1] + weight * slip[1]];
    let size = trial[0].hypot(trial[1]);
    if size <= 1.0 {
        return None;
    }
    let [x, y] = [trial[0] / size, trial[1] / size];
    let [xx, xy, yy] = [y * y / size, -x * y / size, x * x / size];
    Some(Sliding { traction: [x, y], derivative: [[xx, xy], [xy, yy]] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_trials_adhere() {
        assert!(project([0.6, 0.0], [1.0, 0.0], 0.3).is_none());
    }

    /// Central differences of step 1e-6: their error is of order 1e-10.
    #[test]
    fn the_derivative_is_that_of_the_projection() {
        let (trial, h) = ([1.2, -0.7], 1e-6);
        let sliding = project(trial, [0.0; 2], 1.0).unwrap();
        for k in 0..2 {
            let at = |h: f64| {
                let mut moved = trial;
                moved[k] += h;
                project(moved, [0.0; 2], 1.0).unwrap().traction
            };
            for row in 0..2 {
                let numeric = (at(h)[row] - at(-h)[row]) / (2.0 * h);
                assert!((numeric - sliding.derivative[row][k]).abs() < 1e-9);
            }
        }
    }
}
