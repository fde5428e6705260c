//! The integral `I` of (5.9), as a mean over the mesh points, with gradient and Hessian.

use nalgebra::{DMatrix, DVector};

use super::discretization::{Discretization, Rows};
use super::integrand::{self, Integrand, IntegrandTerms, State};
use super::own_integrand::OwnIntegrand;
use super::power_integrand;
use crate::Creepage;

/// Form of the integrand.
#[derive(Clone, Copy)]
pub(super) enum Form<'a> {
    /// `T S` (5.9).
    Product,
    /// The user's function.
    Own(&'a OwnIntegrand),
    /// `W3 S` in the area of adhesion, `W2 T` in that of slip (5.15). A point belongs to the area
    /// where its term is the smaller one: the areas follow the unknowns. The points have the weight
    /// `W2`; here is `W3/W2` of each.
    Areas(&'a [f64]),
    /// The power that is lost, see [`power_integrand`], with `|s|` rounded off, the stiffness of the
    /// bound, and the power that goes into elastic energy where that changes.
    Power { smoothing: f64, stiffness: f64, elastic: Option<&'a ElasticPower> },
}

impl Form<'_> {
    /// The integrand without derivatives.
    pub(super) fn value(self, (point, position): (usize, [f64; 2]), t: f64, s: f64) -> f64 {
        match self {
            Self::Product => t * s,
            Self::Areas(ratios) => t.min(ratios[point] * s),
            Self::Own(own) => own.value(position, t, s),
            Self::Power { .. } => t * s.sqrt(),
        }
    }
}

/// Power of the tractions on `c u - u'`, what the displacements are and were: half a quadratic form of
/// the unknowns, less a linear one.
#[derive(Debug, Clone)]
pub(super) struct ElasticPower {
    pub(super) present: DMatrix<f64>,
    pub(super) past: DVector<f64>,
}

/// `I` at one creepage as a function of the unknowns.
pub(super) struct Functional<'a> {
    discretization: &'a Discretization,
    /// Weight of each point; they sum to the mean of `W`.
    weights: &'a [f64],
    creepage: Creepage,
    form: Form<'a>,
    /// `I` where both bodies are rigid and no traction acts: the size to measure `I` by.
    rigid_value: f64,
}

/// `I` and its derivatives by the unknowns.
pub(super) struct Expansion {
    pub(super) value: f64,
    pub(super) gradient: DVector<f64>,
    pub(super) hessian: DMatrix<f64>,
}

impl Expansion {
    pub(super) fn zeros(unknowns: usize) -> Self {
        Self {
            value: 0.0,
            gradient: DVector::zeros(unknowns),
            hessian: DMatrix::zeros(unknowns, unknowns),
        }
    }
}

impl<'a> Functional<'a> {
    pub(super) fn new(
        discretization: &'a Discretization,
        weights: &'a [f64],
        creepage: Creepage,
        form: Form<'a>,
    ) -> Self {
        let mut functional = Self { discretization, weights, creepage, form, rigid_value: 0.0 };
        functional.rigid_value = functional.value_if_rigid();
        functional
    }

    pub(super) fn unknowns(&self) -> usize {
        self.discretization.unknowns()
    }

    pub(super) fn rigid_value(&self) -> f64 {
        self.rigid_value
    }

    fn value_if_rigid(&self) -> f64 {
        self.weights
            .iter()
            .enumerate()
            .map(|(point, weight)| {
                let [p, q] = self.discretization.rigid_slip(self.creepage, point);
                let position = self.discretization.positions()[point];
                weight * self.form.value((point, position), 1.0, p * p + q * q)
            })
            .sum()
    }

    /// By how much `I` may rise from rounding alone.
    pub(super) fn rounding(&self, value: f64) -> f64 {
        /// Relative rounding of the slip, and of the residuals whose squares make `I`.
        const RELATIVE: f64 = 1e-14;
        match self.form {
            Form::Power { .. } => RELATIVE * self.rigid_value,
            _ => RELATIVE * (value * self.rigid_value.max(value)).sqrt(),
        }
    }

    /// Whether only rounding is left of a sum of squares: full sliding.
    pub(super) fn is_negligible(&self, value: f64) -> bool {
        let is_sum_of_squares = !matches!(self.form, Form::Power { .. });
        is_sum_of_squares && value <= 1e-26 * self.rigid_value
    }

    /// Evaluates `I` with gradient and exact Hessian into `expansion`.
    pub(super) fn expand(&self, tau: &DVector<f64>, expansion: &mut Expansion) {
        expansion.value = 0.0;
        expansion.gradient.fill(0.0);
        expansion.hessian.fill(0.0);
        for (point, &weight) in self.weights.iter().enumerate() {
            let state = self.discretization.state(self.creepage, tau.as_slice(), point);
            let local = self.integrand(point, state);
            add_point(expansion, &self.discretization.rows(point), &local, weight);
        }
        expansion.hessian.fill_upper_triangle_with_lower_triangle();
        if let Form::Power { elastic: Some(elastic), .. } = self.form {
            let slope = &elastic.present * tau;
            expansion.value += (0.5 * &slope - &elastic.past).dot(tau);
            expansion.gradient += slope - &elastic.past;
            expansion.hessian += &elastic.present;
        }
    }

    fn integrand(&self, point: usize, state: State) -> Integrand {
        match self.form {
            Form::Product => integrand::with_derivatives(state),
            Form::Own(own) => own.with_derivatives(self.discretization.positions()[point], state),
            Form::Areas(ratios) => smaller(state, ratios[point]),
            Form::Power { smoothing, stiffness, .. } => {
                let rigid = self.discretization.rigid_slip(self.creepage, point);
                power_integrand::lost(state, rigid, smoothing, stiffness)
            }
        }
    }
}

/// `T` or `ratio S`, whichever is smaller.
fn smaller(state: State, ratio: f64) -> Integrand {
    let [t, s] = integrand::t_and_s(state);
    let terms = if t < ratio * s {
        IntegrandTerms { f: t, t: 1.0, ..IntegrandTerms::default() }
    } else {
        IntegrandTerms { f: ratio * s, s: ratio, ..IntegrandTerms::default() }
    };
    integrand::of_terms(state, &terms)
}

/// Adds one point's share; of the Hessian the lower triangle only.
fn add_point(expansion: &mut Expansion, rows: &Rows, local: &Integrand, weight: f64) {
    let n = rows.value.len();
    let unknowns = 2 * n;
    expansion.value += weight * local.value;
    let [gx, gy, gp, gq] = local.gradient.map(|g| weight * g);
    let h = local.hessian.map(|row| row.map(|entry| weight * entry));
    let gradient = expansion.gradient.as_mut_slice();
    // Storage is by columns.
    let hessian = expansion.hessian.as_mut_slice();
    for j in 0..n {
        let (v, px, py, qy) = (rows.value[j], rows.px[j], rows.py[j], rows.qy[j]);
        gradient[j] += gx * v + gp * px + gq * py;
        gradient[n + j] += gy * v + gp * py + gq * qy;
        // The local Hessian times the change of the state by the j-th X' and Y' unknown.
        let by_x: [f64; 4] = std::array::from_fn(|i| h[i][0] * v + h[i][2] * px + h[i][3] * py);
        let by_y: [f64; 4] = std::array::from_fn(|i| h[i][1] * v + h[i][2] * py + h[i][3] * qy);
        let (x_column, y_column) = hessian[j * unknowns..].split_at_mut(n * unknowns);
        let (xx, xy) = x_column.split_at_mut(n);
        accumulate(&mut xx[j..], [by_x[0], by_x[2], by_x[3]], rows.of_x(j));
        accumulate(&mut xy[..n], [by_x[1], by_x[2], by_x[3]], rows.of_y(0));
        accumulate(&mut y_column[n + j..2 * n], [by_y[1], by_y[2], by_y[3]], rows.of_y(j));
    }
}

/// Adds three multiples of three rows.
fn accumulate(sum: &mut [f64], [p, q, r]: [f64; 3], [a, b, c]: [&[f64]; 3]) {
    for (((sum, a), b), c) in sum.iter_mut().zip(a).zip(b).zip(c) {
        *sum += p * a + q * b + r * c;
    }
}
