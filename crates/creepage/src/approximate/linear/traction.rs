//! Tractions inside the ellipse from the strengths of their singularities on the edge.

use super::compensation::Symmetry;
use super::edge::Strength;
use crate::halfspace::harmonics;

/// A traction `(1 - r^2)^(-1/2) (X', Y')` by the coefficients of `X'`, `Y'` in the
/// [`harmonics`] that are polynomials.
#[derive(Debug, Clone)]
pub(super) struct Traction {
    degree: usize,
    coefficients: Vec<[f64; 2]>,
}

impl Traction {
    /// From the strengths by degree, times `scale`.
    pub(super) fn new(strengths: &[Strength], symmetry: Symmetry, scale: f64) -> Self {
        let degree = strengths.len() - 1;
        let mut edge = vec![0.0; harmonics::count(degree)];
        harmonics::evaluate(degree, 1.0, 0.0, &mut edge);
        let mut coefficients = Vec::with_capacity(harmonics::polynomial_count(degree));
        for (n, strength) in strengths.iter().enumerate() {
            for m in harmonics::even_orders(n) {
                let order = m.unsigned_abs();
                let [x, y] = wave(strength, order, symmetry.u_even_in_x(n));
                let factor = scale / edge[harmonics::index(n, order.cast_signed())];
                let part = usize::from(m < 0);
                coefficients.push([factor * x[part], factor * y[part]]);
            }
        }
        Self { degree, coefficients }
    }

    /// Linear combination of three tractions of equal degree.
    pub(super) fn sum(parts: &[Self; 3], shares: [f64; 3]) -> Self {
        let mut sum = parts[0].clone();
        for (i, total) in sum.coefficients.iter_mut().enumerate() {
            *total = [0, 1].map(|component| {
                parts.iter().zip(shares).map(|(p, s)| s * p.coefficients[i][component]).sum()
            });
        }
        sum
    }

    /// A function that gives the traction at `(x/a, y/b)` inside the ellipse.
    pub(super) fn evaluator(&self) -> impl FnMut(f64, f64) -> [f64; 2] {
        let mut values = vec![0.0; harmonics::count(self.degree)];
        move |x, y| {
            harmonics::evaluate(self.degree, x, y, &mut values);
            let root = (1.0 - x * x - y * y).sqrt();
            let mut traction = [0.0; 2];
            for (index, part) in harmonics::even_indices(self.degree).zip(&self.coefficients) {
                traction[0] += values[index] * part[0];
                traction[1] += values[index] * part[1];
            }
            traction.map(|t| t / root)
        }
    }
}

impl Traction {
    /// A function that gives the strength `(X', Y')` of the singularity at `(a cos t, b sin t)` of the edge.
    pub(super) fn on_edge(&self) -> impl FnMut(f64) -> [f64; 2] {
        let mut values = vec![0.0; harmonics::count(self.degree)];
        move |t| {
            let (sin, cos) = t.sin_cos();
            harmonics::evaluate(self.degree, cos, sin, &mut values);
            let mut strength = [0.0; 2];
            for (index, part) in harmonics::even_indices(self.degree).zip(&self.coefficients) {
                strength[0] += values[index] * part[0];
                strength[1] += values[index] * part[1];
            }
            strength
        }
    }
}

/// `[X', Y']` of frequency `m` as amplitudes of `cos m psi` and `sin m psi`, `psi = pi/2 - t`
/// being the angle from the `x` axis.
fn wave(strength: &Strength, m: usize, u_even_in_x: bool) -> [[f64; 2]; 2] {
    let degree = strength.len() - 1;
    let (below, above) = (strength[(degree - m) / 2], strength[usize::midpoint(degree, m)]);
    // Amplitudes of cos mt and sin mt.
    let cos = |i: usize| if m == 0 { above[i] } else { above[i] + below[i] };
    let sin = |i: usize| above[i] - below[i];
    let [x, y] =
        if u_even_in_x { [[cos(0), 0.0], [0.0, -sin(1)]] } else { [[0.0, sin(0)], [cos(1), 0.0]] };
    let (quarter_cos, quarter_sin) = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][m % 4];
    [x, y].map(|[c, s]| [c * quarter_cos + s * quarter_sin, c * quarter_sin - s * quarter_cos])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Ellipse;
    use crate::approximate::linear::compensation::{Criterion, Edge};
    use crate::halfspace::LoadDisplacement;

    /// The traction, put into the load-displacement equations, causes the rigid displacement
    /// and nothing else that depends on `x`.
    #[test]
    fn tractions_cause_the_displacements_of_4_31() {
        let (degree, poisson) = (9, 0.3);
        for a_over_b in [0.2, 1.0, 3.0] {
            let ellipse = Ellipse::from_ratio(a_over_b).unwrap();
            let response = LoadDisplacement::new(ellipse, poisson, degree).unwrap();
            let edge = Edge::new(ellipse, poisson, degree);
            let displacement = |symmetry: Symmetry, problem: usize, [x, y]: [f64; 2]| {
                let solution = edge.compensate(symmetry, Criterion::Energy);
                let traction = Traction::new(&solution.problems[problem], symmetry, 1.0);
                let [tx, ty]: [Vec<f64>; 2] =
                    [0, 1].map(|i| traction.coefficients.iter().map(|pair| pair[i]).collect());
                let mut values = vec![0.0; harmonics::count(degree)];
                harmonics::evaluate(degree, x / ellipse.a(), y / ellipse.b(), &mut values);
                response.tangential([&tx, &ty]).map(|u| {
                    let terms = harmonics::even_indices(degree).zip(u);
                    terms.map(|(index, u)| values[index] * u).sum::<f64>()
                })
            };
            let (x, y) = (0.4 * ellipse.a(), -0.3 * ellipse.b());
            let difference = |symmetry, problem| {
                let [here, there] = [x, -0.5 * x].map(|x| displacement(symmetry, problem, [x, y]));
                [here[0] - there[0], here[1] - there[1]]
            };
            for (difference, expected) in [
                (difference(Symmetry::Longitudinal, 0), [-1.5 * x, 0.0]),
                (difference(Symmetry::Lateral, 0), [0.0, -1.5 * x]),
                (difference(Symmetry::Lateral, 1), [1.5 * x * y, -0.5 * 0.75 * x * x]),
            ] {
                // Rounding of some ten terms of order ten.
                assert!((difference[0] - expected[0]).abs() < 1e-12, "{difference:?}");
                assert!((difference[1] - expected[1]).abs() < 1e-12, "{difference:?}");
            }
        }
    }
}
