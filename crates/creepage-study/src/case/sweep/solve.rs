//! `[solve]` of a sweep file: formulation, method, mesh.

use creepage::rolling::variational::{Limits, Method, Procedure, Settings, TractionBound};
use creepage::{Ellipse, InvalidValue};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::case::error::CaseError;
use crate::case::solve::{Weight, two_numbers};

#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SolveSection {
    /// Formulation and method; "damped" by default.
    #[serde(default)]
    method: MethodName,
    /// Degree M of the traction polynomials, 0 to 12; 3 by default.
    degree: Option<usize>,
    /// Mesh lengths [along, across] in units of the major semi-axis; each divides the box around
    /// the ellipse. By default a tenth of the box, finer for degrees above 3.
    #[serde(default, deserialize_with = "two_numbers")]
    mesh_length: Option<[f64; 2]>,
    /// Weight of the points of the mesh; "elliptic" by default.
    weight: Option<Weight>,
    /// What is done about tractions above their bound; "automatic" by default.
    #[serde(default)]
    bound: SweepBound,
    /// The iteration ends when the largest change is below delta times the largest unknown;
    /// 1e-6 by default, 1e-3 for "newton".
    delta: Option<f64>,
    /// Most iterations of a case; 200 by default, 12 for "newton".
    max_iterations: Option<usize>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum MethodName {
    /// The integral (5.9), by Newton's method with damping.
    #[default]
    Damped,
    /// The integral (5.9), by Newton's method as in 1967.
    Newton,
    /// Least squares with explicit areas of adhesion and slip (5.15).
    Areas,
}

/// What the numerical theory does about tractions above their bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum SweepBound {
    /// "kept" where a/b is 3 or more.
    #[default]
    Automatic,
    /// Verified afterwards only, as in 1967.
    Unchecked,
    /// Kept: by the least loss of power in place of the integral (5.9).
    Kept,
}

impl From<SweepBound> for TractionBound {
    fn from(bound: SweepBound) -> Self {
        match bound {
            SweepBound::Automatic => Self::Automatic,
            SweepBound::Unchecked => Self::Unchecked,
            SweepBound::Kept => Self::Kept,
        }
    }
}

impl SolveSection {
    pub(crate) fn settings(&self, a_over_b: f64) -> Result<Settings, CaseError> {
        let usual = self.degree.map_or_else(Settings::default, Settings::of_degree);
        let mesh = self.mesh_length.map(|lengths| cells(lengths, a_over_b)).transpose()?;
        Ok(Settings {
            mesh: mesh.unwrap_or(usual.mesh),
            weight: self.weight.map_or(usual.weight, Into::into),
            bound: self.bound.into(),
            ..usual
        })
    }

    pub(crate) fn procedure(&self) -> Result<Procedure, CaseError> {
        let (method, usual) = match self.method {
            MethodName::Damped => (Method::Damped, Limits::default()),
            MethodName::Newton => (Method::Newton, Limits::OF_1967),
            MethodName::Areas => (Method::Areas, Limits::default()),
        };
        let delta = self.delta.unwrap_or(usual.delta);
        if !(delta.is_finite() && delta > 0.0) {
            return Err(in_solve("delta", delta, "finite and greater than zero"));
        }
        let max_iterations = self.max_iterations.unwrap_or(usual.max_iterations);
        Ok(Procedure { method, limits: Limits { delta, max_iterations } })
    }
}

/// Cells of the box around the ellipse, whose major semi-axis is 1.
// A length that gives absurdly many cells ends as one too many, which the theory refuses.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn cells(lengths: [f64; 2], a_over_b: f64) -> Result<[usize; 2], CaseError> {
    let ellipse = Ellipse::from_ratio(a_over_b).map_err(CaseError::invalid("contact"))?;
    let mut cells = [0; 2];
    for (cells, (length, semi_axis)) in
        cells.iter_mut().zip(lengths.into_iter().zip([ellipse.a(), ellipse.b()]))
    {
        let count = 2.0 * semi_axis / ellipse.major() / length;
        // As near to a whole number as decimals of 1/3 written with seven digits.
        if !(length > 0.0 && (count - count.round()).abs() < 1e-5 && count >= 1.0) {
            let valid = "a length that divides the box around the ellipse, 2 along its major axis";
            return Err(in_solve("mesh_length", length, valid));
        }
        *cells = count.round().min(Settings::MAX_CELLS as f64 + 1.0) as usize;
    }
    Ok(cells)
}

fn in_solve(quantity: &'static str, value: f64, valid: &'static str) -> CaseError {
    CaseError::invalid("solve")(InvalidValue { quantity, value, valid })
}
