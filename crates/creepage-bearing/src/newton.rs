//! Newton's method with a line search for a few unknowns, the Jacobian by differences.

use nalgebra::{DMatrix, DVector, SVector};

/// Most steps, and most halvings of one.
const MAX_STEPS: usize = 60;
const MAX_HALVINGS: usize = 12;

/// Finds where `residual` vanishes to `tolerance` (largest component), from `start`; `steps` are those of the
/// differences. Where it stagnates, the best place and what is left there.
///
/// # Errors
/// The first of `residual` at the start or in a difference; in the line search a failing place counts as too far.
pub(crate) fn newton<const N: usize, E>(
    start: SVector<f64, N>,
    steps: SVector<f64, N>,
    tolerance: f64,
    mut residual: impl FnMut(&SVector<f64, N>) -> Result<SVector<f64, N>, E>,
) -> Result<(SVector<f64, N>, f64), E> {
    let mut at = start;
    let mut left = residual(&at)?;
    for _ in 0..MAX_STEPS {
        if left.amax() <= tolerance {
            break;
        }
        let mut jacobian = DMatrix::<f64>::zeros(N, N);
        for k in 0..N {
            let mut moved = at;
            moved[k] += steps[k];
            jacobian.set_column(k, &((residual(&moved)? - left) / steps[k]));
        }
        let right = DVector::from_column_slice((-left).as_slice());
        let Some(step) = jacobian.lu().solve(&right) else { break };
        let step = SVector::<f64, N>::from_column_slice(step.as_slice());
        if !step.iter().all(|part| part.is_finite()) {
            break;
        }
        // Half the step until the residual is smaller.
        let mut taken = None;
        for halving in 0..MAX_HALVINGS {
            let length = 0.5_f64.powi(i32::try_from(halving).unwrap_or(i32::MAX));
            let next = at + step * length;
            let Ok(over) = residual(&next) else { continue };
            if over.norm() < (1.0 - 0.1 * length) * left.norm() {
                taken = Some((next, over));
                break;
            }
        }
        let Some((next, over)) = taken else { break };
        (at, left) = (next, over);
    }
    Ok((at, left.amax()))
}

#[cfg(test)]
mod tests {
    use super::newton;
    use nalgebra::SVector;

    #[test]
    fn two_equations_are_solved() {
        // x^2 + y^2 = 4, x y = 1: quadratic convergence ends at rounding.
        let residual = |v: &SVector<f64, 2>| -> Result<_, ()> {
            Ok(SVector::from([v[0] * v[0] + v[1] * v[1] - 4.0, v[0] * v[1] - 1.0]))
        };
        let start = SVector::from([2.0, 0.3]);
        let (at, left) = newton(start, SVector::from([1e-6; 2]), 1e-12, residual).unwrap();
        assert!(left <= 1e-12 && (at[0] * at[1] - 1.0).abs() < 1e-12, "{at}");
    }
}
