//! `[solve]` of a sweep file: formulation, method, mesh.

use creepage::variational::{Limits, Method, Procedure, Settings, TractionBound, Weight};
use creepage::{Ellipse, InvalidValue};
use schemars::JsonSchema;
use serde::de::{Deserialize, Deserializer, Error};

use crate::case::error::CaseError;

#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Deserialize, JsonSchema)]
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
    /// With method = "areas" the weight of the slip in the area of adhesion, W3 of (5.15), where "weight" is
    /// that of the tractions in the area of slip, W2; the same as "weight" by default.
    adhesion_weight: Option<Weight>,
    /// What is done about tractions above their bound; "automatic" by default.
    #[serde(default)]
    bound: TractionBound,
    /// The iteration ends when the largest change is below delta times the largest unknown;
    /// 1e-6 by default, 1e-3 for "newton".
    delta: Option<f64>,
    /// Most iterations of a case; 200 by default, 12 for "newton".
    max_iterations: Option<usize>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum MethodName {
    /// The integral (5.9), by Newton's method with damping.
    #[default]
    Damped,
    /// The integral (5.9), by Newton's method as in 1967.
    Newton,
    /// Least squares with explicit areas of adhesion and slip (5.15), next to the solution of (5.9).
    Areas,
}

impl SolveSection {
    pub(crate) fn settings(&self, a_over_b: f64) -> Result<Settings, CaseError> {
        if self.adhesion_weight.is_some() && self.method != MethodName::Areas {
            return Err(CaseError::WeightOfAreas);
        }
        let usual = self.degree.map_or_else(Settings::default, Settings::of_degree);
        let mesh = self.mesh_length.map(|lengths| cells(lengths, a_over_b)).transpose()?;
        Ok(Settings {
            mesh: mesh.unwrap_or(usual.mesh),
            weight: self.weight.unwrap_or(usual.weight),
            bound: self.bound,
            adhesion_weight: self.adhesion_weight,
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

/// An array of just two: the TOML reader by itself would drop a third number silently.
fn two_numbers<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<[f64; 2]>, D::Error> {
    let numbers = Vec::<f64>::deserialize(deserializer)?;
    let count = numbers.len();
    let pair = numbers.try_into().map_err(|_| D::Error::invalid_length(count, &"two numbers"))?;
    Ok(Some(pair))
}
