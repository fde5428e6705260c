//! Solution of the numerical theory, and how good it is.

use super::discretization::Discretization;
use super::newton::Minimum;
use super::{Variational, integrand};
use crate::{Creepage, FieldPoint, Region, Solution, Statistics, Status};

/// Traction, slip, and their judgement at one point of the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshPoint {
    /// Traction, slip and area, as any theory gives them.
    pub field: FieldPoint,
    /// Distance `T` of the traction over its bound from the slip's direction, squared (5.6).
    pub t: f64,
    /// Slip squared `S`, in units of `(mu f00)^2` (5.6).
    pub s: f64,
    /// The integrand `f`: `W T S`, or the weighted function of the user.
    pub integrand: f64,
    /// `|X'|`, the traction over its bound.
    pub reduced_traction: f64,
    /// An aberration: nearer to adhesion than to slip, `T > S`, and yet above the bound.
    pub aberrant: bool,
}

/// The minimum of `I` at one creepage.
#[derive(Debug, Clone, PartialEq)]
pub struct VariationalSolution {
    /// Force and status.
    pub solution: Solution,
    /// Coefficients of `X'`, then of `Y'`, in the polynomials of
    /// [`harmonics::even_indices`](crate::halfspace::harmonics::even_indices).
    pub tau: Vec<f64>,
    /// `I`, the mean of the integrand over the mesh.
    pub mean_integrand: f64,
    /// `I` over that of rigid bodies without traction: 0 for an exact solution, 1 at worst.
    pub residual: f64,
    /// Points with `T > S` and traction above its bound, in which the solution is doubtful.
    pub aberrations: usize,
    /// The mesh points, line by line from `-y`, each from `-x`.
    pub points: Vec<MeshPoint>,
}

impl VariationalSolution {
    /// Steps of the iteration.
    #[must_use]
    pub fn iterations(&self) -> usize {
        self.solution.statistics.iterations
    }

    pub(super) fn new(theory: &Variational, creepage: Creepage, minimum: &Minimum) -> Self {
        let tau = minimum.tau.as_slice().to_vec();
        let points = mesh_points(theory, &theory.mesh, creepage, &tau);
        let rigid_value = theory.functional_of(creepage, theory.form()).rigid_value();
        let mean_integrand =
            points.iter().map(|point| point.integrand).sum::<f64>() / points.len() as f64;
        let status = if !minimum.converged {
            Status::NotConverged
        } else if theory.is_driven(creepage) && !slip_is_resolved(&points, theory.response.degree())
        {
            Status::CreepageTooSmall
        } else {
            Status::Solved
        };
        Self {
            solution: Solution {
                statistics: Statistics { iterations: minimum.iterations, factorizations: 0 },
                ..Solution::closed_form(theory.response.force(&tau), status)
            },
            mean_integrand,
            residual: if rigid_value > 0.0 { mean_integrand / rigid_value } else { 0.0 },
            aberrations: points.iter().filter(|point| point.aberrant).count(),
            tau,
            points,
        }
    }
}

/// Polynomials of degree `M` do not resolve an area of slip below a share of about
/// `1/(3 (M + 1))` of the contact: the force is then too small by up to all of it, for as the
/// creepage vanishes the minimum tends to full adhesion, whose force is zero.
fn slip_is_resolved(points: &[MeshPoint], degree: usize) -> bool {
    let slipping = points.iter().filter(|point| point.field.region == Region::Slip).count();
    3 * (degree + 1) * slipping >= points.len()
}

/// The field and its judgement at every point of `discretization`.
pub(super) fn mesh_points(
    theory: &Variational,
    discretization: &Discretization,
    creepage: Creepage,
    tau: &[f64],
) -> Vec<MeshPoint> {
    let slip_unit = discretization.slip_scale().recip();
    (0..discretization.positions().len())
        .map(|point| {
            let state @ [x, y, p, q] = discretization.state(creepage, tau, point);
            let [t, s] = integrand::t_and_s(state);
            let bound_squared = discretization.bound_squared()[point];
            let position = discretization.positions()[point];
            let (bound, weight) = (bound_squared.sqrt(), theory.weight.at(1.0 - bound_squared));
            MeshPoint {
                field: FieldPoint {
                    position,
                    traction: [bound * x, bound * y],
                    slip: [slip_unit * p, slip_unit * q],
                    region: if t < s { Region::Slip } else { Region::Adhesion },
                },
                t,
                s,
                integrand: weight * theory.form().value((point, position), t, s),
                reduced_traction: x.hypot(y),
                aberrant: t > s && x.hypot(y) > 1.0,
            }
        })
        .collect()
}
