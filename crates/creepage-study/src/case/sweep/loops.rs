//! The triple loop over `chi`, `alpha` and the list of `upsilon` (5.16).

use creepage::{Creepage, InvalidValue};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::case::error::CaseError;

/// `[creepage]`: the values that the three loops run through; what is left out is zero.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Loops {
    /// Dimensionless spin, the outermost loop: a list, or `{ from, step, to }`.
    #[serde(default)]
    chi: Values,
    /// Angle from the rolling direction to the creepage (xi, eta) (degrees): a list, or
    /// `{ from, step, to }`.
    #[serde(default)]
    alpha: Values,
    /// Magnitude of the creepage (xi, eta), the innermost loop: a list, or
    /// `{ from, step, to }`.
    #[serde(default)]
    upsilon: Values,
}

/// The values of one loop.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected a list of numbers or { from, step, to }")]
pub(crate) enum Values {
    /// One after the other.
    List(Vec<f64>),
    /// `for value := from step step until to`.
    Range(Range),
}

/// Equidistant values.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Range {
    /// The first value.
    from: f64,
    /// The step, negative for a loop downwards.
    step: f64,
    /// The last value, if the steps meet it.
    to: f64,
}

impl Default for Values {
    fn default() -> Self {
        Self::List(vec![0.0])
    }
}

impl Loops {
    /// The most cases of a sweep.
    pub(crate) const MAX_CASES: usize = 100_000_000;

    /// The values of `chi`, `alpha` and `upsilon`.
    pub(crate) fn values(&self) -> Result<[Vec<f64>; 3], CaseError> {
        let chi = self.chi.values("chi")?;
        let alpha = self.alpha.values("alpha")?;
        let upsilon = self.upsilon.values("upsilon")?;
        let cases = chi.len() as f64 * alpha.len() as f64 * upsilon.len() as f64;
        within_bounds("upsilon", cases)?;
        Ok([chi, alpha, upsilon])
    }
}

impl Values {
    fn values(&self, key: &'static str) -> Result<Vec<f64>, CaseError> {
        let invalid = |value: f64, valid: &'static str| {
            CaseError::invalid("creepage")(InvalidValue { quantity: key, value, valid })
        };
        match self {
            Self::List(list) => {
                if list.is_empty() {
                    return Err(invalid(0.0, "a list with at least one number"));
                }
                match list.iter().find(|value| !is_creepage(**value)) {
                    Some(&value) => Err(invalid(value, "between -1e100 and 1e100")),
                    None => Ok(list.clone()),
                }
            }
            Self::Range(Range { from, step, to }) => {
                if let Some(&value) = [from, step, to].into_iter().find(|part| !is_creepage(**part))
                {
                    return Err(invalid(value, "between -1e100 and 1e100"));
                }
                let steps = (to - from) / step;
                if steps.is_nan() || steps < 0.0 {
                    return Err(invalid(*step, "a step that leads from `from` to `to`"));
                }
                within_bounds(key, steps + 1.0)?;
                Ok(equidistant(*from, *step, steps))
            }
        }
    }
}

fn is_creepage(value: f64) -> bool {
    value.abs() <= Creepage::MAX
}

/// A last step that falls short by rounding counts.
fn equidistant(from: f64, step: f64, steps: f64) -> Vec<f64> {
    const ROUNDING: f64 = 1e-9;
    let last = (steps + ROUNDING).floor();
    (0..=Loops::MAX_CASES)
        .map(|k| k as f64)
        .take_while(|&k| k <= last)
        .map(|k| from + k * step)
        .collect()
}

fn within_bounds(key: &'static str, cases: f64) -> Result<(), CaseError> {
    if cases <= Loops::MAX_CASES as f64 {
        return Ok(());
    }
    Err(CaseError::TooManyCases { key, cases, max: Loops::MAX_CASES })
}
