//! Robust least squares in one or two parameters: Levenberg and Marquardt's method with Huber's weights.

/// Levenberg and Marquardt's damping: first value, and its changes.
const FIRST_DAMPING: f64 = 1e-3;
const LESS_DAMPING: f64 = 0.3;
const MORE_DAMPING: f64 = 5.0;
const MAX_TRIALS: usize = 10;
/// Gauss-Newton steps at most.
const MAX_STEPS: usize = 60;
/// Steps of the logarithm of a parameter below this change no printed digit.
const SMALL_STEP: f64 = 1e-7;
/// Largest step of a logarithm: parameters stay where the model is smooth.
const LARGEST_STEP: f64 = 0.5;
/// Step of the central differences: their error is of its square, far above what a theory's iteration
/// leaves open.
const DIFFERENCE: f64 = 1e-3;
/// Huber's limit in standard deviations: 95 % efficient for points without outliers.
const HUBER: f64 = 1.345;
/// Standard deviation over the median of the sizes, of a normal distribution.
const FROM_MEDIAN: f64 = 1.4826;

/// Residuals at the logarithms of the parameters, of which there are one or two.
pub(super) type Residuals<'a, E> = dyn FnMut(&[f64]) -> Result<Vec<f64>, E> + 'a;

/// Minimum of the sum of squares.
pub(super) struct Minimum {
    /// Logarithms of the parameters.
    pub(super) at: Vec<f64>,
    pub(super) residuals: Vec<f64>,
    /// A column a parameter.
    pub(super) jacobian: Vec<Vec<f64>>,
}

/// A standard deviation that outliers do not move, at least `least`.
pub(super) fn robust_deviation(residuals: &[f64], least: f64) -> f64 {
    let mut sizes: Vec<_> = residuals.iter().map(|residual| residual.abs()).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    let median = sizes.get(sizes.len() / 2).copied().unwrap_or(0.0);
    (FROM_MEDIAN * median).max(least)
}

/// From `at` downhill. `robust` gives Huber's weights, with this least standard deviation.
pub(super) fn minimize<E>(
    residuals: &mut Residuals<'_, E>,
    mut at: Vec<f64>,
    robust: Option<f64>,
) -> Result<Minimum, E> {
    let mut found = residuals(&at)?;
    let mut damping = FIRST_DAMPING;
    for _ in 0..MAX_STEPS {
        let jacobian = jacobian(residuals, &at)?;
        let weights = weights(&found, robust);
        let cost = |found: &[f64]| -> f64 {
            found.iter().zip(&weights).map(|(r, weight)| weight * r * r).sum()
        };
        let (normal, gradient) = normal_equations(&jacobian, &found, &weights);
        let before = cost(&found);
        let mut moved = None;
        for _ in 0..MAX_TRIALS {
            let Some(step) = solve(&normal, &gradient, damping) else { break };
            let trial: Vec<_> = at
                .iter()
                .zip(&step)
                .map(|(value, step)| value + step.clamp(-LARGEST_STEP, LARGEST_STEP))
                .collect();
            let there = residuals(&trial)?;
            if cost(&there) < before {
                moved = Some((trial, there, step));
                break;
            }
            damping *= MORE_DAMPING;
        }
        let Some((trial, there, step)) = moved else { break };
        (at, found) = (trial, there);
        damping *= LESS_DAMPING;
        if step.iter().all(|step| step.abs() < SMALL_STEP) {
            break;
        }
    }
    let jacobian = jacobian(residuals, &at)?;
    Ok(Minimum { at, residuals: found, jacobian })
}

/// By central differences.
fn jacobian<E>(residuals: &mut Residuals<'_, E>, at: &[f64]) -> Result<Vec<Vec<f64>>, E> {
    let mut columns = Vec::with_capacity(at.len());
    for k in 0..at.len() {
        let mut beside = |by: f64| {
            let mut moved = at.to_vec();
            moved[k] += by;
            residuals(&moved)
        };
        let (high, low) = (beside(DIFFERENCE)?, beside(-DIFFERENCE)?);
        let slope = |(high, low): (&f64, &f64)| (high - low) / (2.0 * DIFFERENCE);
        columns.push(high.iter().zip(&low).map(slope).collect());
    }
    Ok(columns)
}

fn weights(residuals: &[f64], robust: Option<f64>) -> Vec<f64> {
    let Some(least) = robust else { return vec![1.0; residuals.len()] };
    let limit = HUBER * robust_deviation(residuals, least);
    residuals.iter().map(|residual| (limit / residual.abs()).min(1.0)).collect()
}

/// `J^T W J` and `J^T W r`.
fn normal_equations(
    jacobian: &[Vec<f64>],
    residuals: &[f64],
    weights: &[f64],
) -> (Vec<Vec<f64>>, Vec<f64>) {
    let dot = |one: &[f64], two: &[f64]| -> f64 {
        one.iter().zip(two).zip(weights).map(|((one, two), weight)| weight * one * two).sum()
    };
    let row = |one: &Vec<f64>| jacobian.iter().map(|two| dot(one, two)).collect();
    let gradient = jacobian.iter().map(|column| dot(column, residuals)).collect();
    (jacobian.iter().map(row).collect(), gradient)
}

/// The step `-(A + damping diag A)^-1 g`; `None` where the matrix is singular.
fn solve(normal: &[Vec<f64>], gradient: &[f64], damping: f64) -> Option<Vec<f64>> {
    let inverse = inverse(normal, damping)?;
    let step = |row: &Vec<f64>| -row.iter().zip(gradient).map(|(a, g)| a * g).sum::<f64>();
    let step: Vec<_> = inverse.iter().map(step).collect();
    step.iter().all(|step| step.is_finite()).then_some(step)
}

/// Of one or two rows, the diagonal enlarged by a part.
fn inverse(matrix: &[Vec<f64>], enlarged: f64) -> Option<Vec<Vec<f64>>> {
    let factor = 1.0 + enlarged;
    match matrix {
        [a] => (a[0] > 0.0).then(|| vec![vec![1.0 / (a[0] * factor)]]),
        [a, b] => {
            let (aa, bb, ab) = (a[0] * factor, b[1] * factor, a[1]);
            let determinant = aa * bb - ab * ab;
            (determinant > 0.0).then(|| {
                vec![
                    vec![bb / determinant, -ab / determinant],
                    vec![-ab / determinant, aa / determinant],
                ]
            })
        }
        _ => None,
    }
}

impl Minimum {
    /// `(J^T J)^-1`, which the variance of the residuals makes the covariance of the parameters' logarithms.
    pub(super) fn cofactors(&self) -> Option<Vec<Vec<f64>>> {
        let ones = vec![1.0; self.residuals.len()];
        inverse(&normal_equations(&self.jacobian, &self.residuals, &ones).0, 0.0)
    }
}

/// Student's `t` that 95 % of samples stay within, for so many degrees of freedom.
pub(super) fn student_95(freedom: usize) -> f64 {
    /// Exact to the digits given, for 1 to 9 degrees.
    const FEW_DEGREES: [f64; 9] =
        [12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060, 2.2622];
    let few = freedom.checked_sub(1).and_then(|k| FEW_DEGREES.get(k)).copied();
    // Expansion about the normal distribution (Abramowitz and Stegun 26.7.5): 1e-4 from 10 degrees on.
    let (z, n) = (1.959_963_985_f64, freedom as f64);
    let [z3, z5, z7, z9] = [3, 5, 7, 9].map(|power| z.powi(power));
    few.unwrap_or_else(|| {
        z + (z3 + z) / (4.0 * n)
            + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n)
            + (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n.powi(3))
            + (79.0 * z9 + 776.0 * z7 + 1482.0 * z5 - 1920.0 * z3 - 945.0 * z)
                / (92160.0 * n.powi(4))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `y = p e^(-q x)` with a point far off.
    fn residuals(outlier: f64) -> impl FnMut(&[f64]) -> Result<Vec<f64>, std::convert::Infallible> {
        move |at: &[f64]| {
            let [p, q] = [at[0].exp(), at[1].exp()];
            let measured =
                |k: u32| 2.0 * (-0.5 * f64::from(k)).exp() + if k == 3 { outlier } else { 0.0 };
            Ok((0..12).map(|k| measured(k) - p * (-q * f64::from(k)).exp()).collect())
        }
    }

    #[test]
    fn two_parameters_are_found_without_noise() {
        let found = minimize(&mut residuals(0.0), vec![0.0, 0.0], None).unwrap();
        // What the steps leave open.
        assert!((found.at[0].exp() - 2.0).abs() < 1e-6 && (found.at[1].exp() - 0.5).abs() < 1e-6);
    }

    #[test]
    fn huber_s_weights_hold_an_outlier_off() {
        let found = minimize(&mut residuals(1.0), vec![0.0, 0.0], Some(1e-3)).unwrap();
        let plain = minimize(&mut residuals(1.0), vec![0.0, 0.0], None).unwrap();
        let miss = |found: &Minimum| (found.at[1].exp() - 0.5).abs();
        // The limit of 1.345 standard deviations, 1e-3 at least, is what the outlier still pulls with.
        assert!(miss(&found) < 0.01 && miss(&plain) > 0.05, "{} {}", miss(&found), miss(&plain));
    }

    #[test]
    fn student_s_table() {
        // Printed tables: 2.228, 2.086, 1.984.
        for (freedom, printed) in [(10, 2.2281), (20, 2.0860), (100, 1.9840)] {
            assert!((student_95(freedom) - printed).abs() < 1e-4);
        }
    }
}
