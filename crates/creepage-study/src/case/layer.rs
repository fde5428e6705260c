//! `[layer]`: a layer between the bodies.

use creepage::{InvalidValue, Layer, Plasticity};
use schemars::JsonSchema;
use serde::Deserialize;

use super::error::CaseError;

const SECTION: &str = "layer";
/// No layer that bodies roll on is as soft (Pa): a smaller number is in another unit.
const SOFTEST: f64 = 1e3;

/// A thin layer between the bodies, such as oxide, sand or clay: it shears, and may yield.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LayerSection {
    /// Thickness (m).
    thickness: f64,
    /// Shear modulus (Pa).
    shear_modulus: f64,
    /// Shear stress at which it yields (Pa); it does not by default.
    yield_stress: Option<f64>,
    /// Rise of the yield stress with the plastic displacement (Pa/m), positive where the layer hardens;
    /// 0 by default.
    slope: Option<f64>,
}

impl LayerSection {
    pub(crate) fn layer(&self) -> Result<Layer, CaseError> {
        let soft =
            [("shear_modulus", Some(self.shear_modulus)), ("yield_stress", self.yield_stress)];
        for (quantity, value) in soft {
            if let Some(value) = value.filter(|value| *value > 0.0 && *value < SOFTEST) {
                let valid = "at least 1e3 Pa";
                return Err(CaseError::invalid(SECTION)(InvalidValue { quantity, value, valid }));
            }
        }
        let layer = Layer::elastic(self.thickness, self.shear_modulus);
        let layer = layer.map_err(CaseError::invalid(SECTION))?;
        match (self.yield_stress, self.slope) {
            (None, None) => Ok(layer),
            (None, Some(_)) => {
                Err(CaseError::Missing { section: SECTION.into(), key: "yield_stress".into() })
            }
            (Some(yield_stress), slope) => layer
                .with_plasticity(Plasticity { yield_stress, slope: slope.unwrap_or(0.0) })
                .map_err(CaseError::invalid(SECTION)),
        }
    }
}
