//! `[chain]` of a sweep file: what a case starts from.

use creepage::halfspace::Polynomial;
use creepage::variational::Start;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::case::error::CaseError;

#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ChainSection {
    /// The outermost loop that a chain runs through; several chains run in parallel. "upsilon" by
    /// default: a chain for every chi and alpha; "chi" is one chain of all cases, as in 1967.
    #[serde(default)]
    pub(crate) through: Through,
    /// Coefficients of X', then of Y', in 1, x, y, x^2, xy, y^2, ..., with the major semi-axis as
    /// unit of length: what the first case of every chain starts from. By default full sliding.
    starting_values: Option<Vec<f64>>,
    /// Solve every case from a second start as well, and tell by how much the forces differ.
    pub(crate) second_start: Option<SecondStart>,
}

impl ChainSection {
    pub(crate) fn starting_values(&self) -> Result<Option<[Polynomial; 2]>, CaseError> {
        self.starting_values.as_deref().map(polynomials).transpose()
    }
}

/// The outermost loop that a chain runs through.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Through {
    /// A chain for every chi and alpha.
    #[default]
    Upsilon,
    /// A chain for every chi.
    Alpha,
    /// One chain.
    Chi,
}

/// Where the check of a case starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SecondStart {
    /// From full sliding.
    FullSliding,
    /// From full adhesion.
    Adhesion,
    /// From no traction.
    Zero,
}

impl SecondStart {
    /// The start itself.
    #[must_use]
    pub fn start(self) -> Start<'static> {
        match self {
            Self::FullSliding => Start::FullSliding,
            Self::Adhesion => Start::Adhesion,
            Self::Zero => Start::Zero,
        }
    }
}

/// `X'` and `Y'` from the list of their coefficients.
fn polynomials(values: &[f64]) -> Result<[Polynomial; 2], CaseError> {
    let (x, y) = values.split_at(values.len() / 2);
    let polynomial = |values: &[f64]| {
        Polynomial::new(values.to_vec()).map_err(|source| CaseError::StartingValues { source })
    };
    Ok([polynomial(x)?, polynomial(y)?])
}
