//! Newton's method with a line search for a few unknowns, the Jacobian by differences; Broyden's update of a Jacobian.

use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DVector, DefaultAllocator, Dim, OVector};

/// Tolerance and limits of [`newton()`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewtonLimits {
    /// Largest component of the residual at which it ends.
    pub tolerance: f64,
    /// Most steps.
    pub max_steps: usize,
    /// Most lengths of one step that are tried, each half of the one before.
    pub max_halvings: usize,
    /// A step of length `l`, a full one being 1, is taken if it leaves less than `1 - l * least_decrease` of the residual.
    pub least_decrease: f64,
}

/// Result of Newton's method.
#[derive(Debug, Clone, PartialEq)]
pub struct Newton<D: Dim, T>
where
    DefaultAllocator: Allocator<D>,
{
    /// The unknowns.
    pub at: OVector<f64, D>,
    /// What the function gives there besides its residual.
    pub value: T,
    /// The residual there.
    pub residual: OVector<f64, D>,
}

impl<D: Dim, T> Newton<D, T>
where
    DefaultAllocator: Allocator<D>,
{
    /// The largest component of the residual; NaN where one is.
    #[must_use]
    pub fn largest(&self) -> f64 {
        largest_magnitude(self.residual.as_slice())
    }
}

/// The largest magnitude of a residual's components; NaN where one of them is, which `amax` and `f64::max` pass over:
/// a residual without a number is not met.
///
/// ```
/// use creepage::numerics::largest_magnitude;
/// assert_eq!(largest_magnitude(&[1.0, -3.0]), 3.0);
/// assert!(largest_magnitude(&[f64::NAN, 1.0]).is_nan());
/// ```
#[must_use]
pub fn largest_magnitude(values: &[f64]) -> f64 {
    let larger = |most: f64, part: f64| if part <= most { most } else { part };
    let magnitudes = values.iter().map(|part| part.abs());
    magnitudes.fold(0.0, |most, part| if most.is_nan() { most } else { larger(most, part) })
}

/// Seeks where the residual of `function` vanishes, from `start`; `differences` are the steps of the unknowns by which the
/// Jacobian is found. Where it stagnates, the best place so far: whether the tolerance is met is the caller's to see.
///
/// # Errors
/// The first of `function` at the start or in a difference; in the line search a failing place counts as too far.
///
/// ```
/// use creepage::numerics::{NewtonLimits, newton};
/// use nalgebra::Vector2;
/// let limits = NewtonLimits { tolerance: 1e-12, max_steps: 20, max_halvings: 8, least_decrease: 0.1 };
/// let circle_and_hyperbola = |v: &Vector2<f64>| {
///     Ok::<_, std::convert::Infallible>(((), Vector2::new(v.norm_squared() - 4.0, v.x * v.y - 1.0)))
/// };
/// let found = newton(Vector2::new(2.0, 0.3), &Vector2::repeat(1e-6), limits, circle_and_hyperbola)?;
/// assert!(found.largest() <= 1e-12);
/// # Ok::<(), std::convert::Infallible>(())
/// ```
pub fn newton<D: Dim, T, E>(
    start: OVector<f64, D>,
    differences: &OVector<f64, D>,
    limits: NewtonLimits,
    mut function: impl FnMut(&OVector<f64, D>) -> Result<(T, OVector<f64, D>), E>,
) -> Result<Newton<D, T>, E>
where
    DefaultAllocator: Allocator<D>,
{
    let count = start.len();
    let (value, residual) = function(&start)?;
    let mut best = Newton { at: start, value, residual };
    for _ in 0..limits.max_steps {
        if best.largest() <= limits.tolerance {
            break;
        }
        let mut jacobian = DMatrix::<f64>::zeros(count, count);
        for k in 0..count {
            let mut moved = best.at.clone();
            moved[k] += differences[k];
            let there = function(&moved)?.1;
            for i in 0..count {
                jacobian[(i, k)] = (there[i] - best.residual[i]) / differences[k];
            }
        }
        let right = DVector::from_iterator(count, best.residual.iter().map(|left| -left));
        let Some(step) = newton_step(jacobian, &right) else { break };
        let mut nearer = None;
        let mut length = 1.0;
        for _ in 0..limits.max_halvings {
            let mut at = best.at.clone();
            for (at, step) in at.iter_mut().zip(step.iter()) {
                *at += step * length;
            }
            if let Ok((value, residual)) = function(&at)
                && residual.norm() < (1.0 - limits.least_decrease * length) * best.residual.norm()
            {
                nearer = Some(Newton { at, value, residual });
                break;
            }
            length *= 0.5;
        }
        let Some(nearer) = nearer else { break };
        best = nearer;
    }
    Ok(best)
}

/// The step that makes a residual zero by its Jacobian; `None` where that is singular.
fn newton_step(jacobian: DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    jacobian.lu().solve(right).filter(|step| step.iter().all(|part| part.is_finite()))
}

/// Corrects the Jacobian of a function by a step: then it explains how the function changed, and is what it was across
/// the step. Gives by how much the change was missed before.
///
/// C.G. Broyden, Mathematics of Computation 19 (1965) 577-593.
pub fn broyden_update(
    jacobian: &mut DMatrix<f64>,
    step: &DVector<f64>,
    change: &DVector<f64>,
) -> f64 {
    let missed = change - &*jacobian * step;
    let square = step.norm_squared();
    if square > 0.0 {
        jacobian.ger(1.0, &(&missed / square), step, 1.0);
    }
    missed.norm()
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use nalgebra::SVector;

    use super::*;

    const LIMITS: NewtonLimits =
        NewtonLimits { tolerance: 1e-12, max_steps: 60, max_halvings: 12, least_decrease: 0.1 };

    #[test]
    fn two_equations_are_solved() {
        // x^2 + y^2 = 4, x y = 1: quadratic convergence ends at rounding.
        let residual = |v: &SVector<f64, 2>| -> Result<_, Infallible> {
            Ok(((), SVector::from([v[0] * v[0] + v[1] * v[1] - 4.0, v[0] * v[1] - 1.0])))
        };
        let start = SVector::from([2.0, 0.3]);
        let Ok(found) = newton(start, &SVector::from([1e-6; 2]), LIMITS, residual);
        assert!(found.largest() <= 1e-12, "{found:?}");
        assert!((found.at[0] * found.at[1] - 1.0).abs() < 1e-12, "{found:?}");
    }

    /// Full steps of an arctangent swing ever farther from 1.4 on (Dennis and Schnabel 1983); halved ones do not, and a
    /// place where the function fails is only too far.
    #[test]
    fn steps_that_lead_away_or_fail_are_halved() {
        let mut calls = 0;
        let residual = |v: &DVector<f64>| {
            calls += 1;
            if v[0].abs() > 30.0 { Err(()) } else { Ok((calls, v.map(f64::atan))) }
        };
        let start = DVector::from_element(1, 10.0);
        let found = newton(start, &DVector::from_element(1, 1e-7), LIMITS, residual).unwrap();
        assert!(found.at[0].abs() < 1e-12 && found.value > 0, "{found:?}");
        let fails = |_: &DVector<f64>| Err::<((), DVector<f64>), _>("beyond");
        let start = DVector::from_element(1, 1.0);
        assert_eq!(newton(start.clone(), &start, LIMITS, fails).unwrap_err(), "beyond");
    }

    /// Where there is no root the best place is found.
    #[test]
    fn stagnation_gives_the_best_place() {
        let residual = |v: &SVector<f64, 1>| Ok::<_, Infallible>(((), v.map(|x: f64| x * x + 1.0)));
        let start = SVector::from([3.0]);
        let Ok(found) = newton(start, &SVector::from([1e-6]), LIMITS, residual);
        // Lower than where it began, and no lower than there is: 1.
        assert!((1.0..1.1).contains(&found.residual[0]), "{found:?}");
    }

    #[test]
    fn a_corrected_jacobian_explains_the_step_and_is_the_same_across() {
        let mut jacobian = DMatrix::from_row_slice(2, 2, &[1.0, 0.3, -0.2, 2.0]);
        let (before, step) = (jacobian.clone(), DVector::from_vec(vec![0.3, -0.4]));
        let change = DVector::from_vec(vec![0.7, 0.1]);
        let missed = broyden_update(&mut jacobian, &step, &change);
        // Roundings of a few products.
        assert!((&jacobian * &step - &change).amax() < 1e-15);
        assert!((missed - (&before * &step - &change).norm()).abs() < 1e-15);
        let across = DVector::from_vec(vec![0.4, 0.3]);
        assert!((&jacobian * &across - &before * &across).amax() < 1e-15);
        broyden_update(&mut jacobian, &DVector::zeros(2), &change);
        assert!(jacobian.iter().all(|entry| entry.is_finite()));
    }

    /// A residual that is not a number is not small.
    #[test]
    fn what_is_not_a_number_is_not_met() {
        let residual = SVector::from([f64::NAN, 1e-15]);
        let found = Newton { at: SVector::from([0.0; 2]), value: (), residual };
        assert!(found.largest().is_nan());
    }
}
