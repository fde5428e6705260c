//! `[solve]`: which theory, and its options.

use creepage::rolling::variational;
use schemars::JsonSchema;
use serde::de::{Deserialize, Deserializer, Error};

/// The theory that solves the case, and its options; what is left out is the theory's default.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Solve {
    /// Name of the theory, as `creepage theories` lists them.
    pub theory: Option<String>,
    /// Theory "variational": degree M of the traction polynomials, 0 to 12; 3 by default.
    pub degree: Option<usize>,
    /// Theory "variational": mesh cells [along, across] of the box around the ellipse;
    /// by default 10 x 10, more for degrees above 3.
    #[serde(default, deserialize_with = "two_numbers")]
    pub mesh: Option<[usize; 2]>,
    /// Theory "variational": weight of the points of the mesh; "elliptic" by default.
    pub weight: Option<Weight>,
}

/// Weight W of the points in the integral (5.8).
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Weight {
    /// `1 - (x/a)^2 - (y/b)^2`: the middle of the contact counts more than its edge.
    Elliptic,
    /// 1: every point counts alike.
    Uniform,
    /// The square root of the elliptic weight.
    #[serde(rename = "root-elliptic")]
    RootElliptic,
}

impl From<Weight> for variational::Weight {
    fn from(weight: Weight) -> Self {
        match weight {
            Weight::Elliptic => Self::Elliptic,
            Weight::Uniform => Self::Uniform,
            Weight::RootElliptic => Self::RootElliptic,
        }
    }
}

/// An array of just two: the TOML reader by itself would drop a third number silently.
pub(crate) fn two_numbers<'de, D, T>(deserializer: D) -> Result<Option<[T; 2]>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    let numbers = Vec::<T>::deserialize(deserializer)?;
    let count = numbers.len();
    let pair = numbers.try_into().map_err(|_| D::Error::invalid_length(count, &"two numbers"))?;
    Ok(Some(pair))
}
