//! Passage of a contact: the stresses that a material point sees while it goes by.

use super::ball;
use crate::check::{self, InvalidValue};
use crate::subsurface::{Interior, Stress};

/// States of stress over a passage, from far ahead to far behind. In steady rolling they are the field
/// along a line in the rolling direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage {
    states: Vec<Stress>,
}

impl Passage {
    /// The states that the material at `[y, z]` of a body sees: `count` points up to eight times
    /// `half_length` ahead and behind, close within the contact and ever wider beyond, and the unloaded
    /// state.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `half_length` is positive, the point in the body, and `count` between 3
    /// and 10000.
    pub fn below(
        interior: &Interior,
        half_length: f64,
        [y, z]: [f64; 2],
        count: usize,
    ) -> Result<Self, InvalidValue> {
        check::positive("half_length", half_length)?;
        let valid = "between 3 and 10000";
        check::require((3..=10_000).contains(&count), "count", count as f64, valid)?;
        let mut states = vec![Stress::default()];
        for k in 0..count {
            let t = 2.0 * k as f64 / (count - 1) as f64 - 1.0;
            let x = half_length * (1.6 * t + 6.4 * t.powi(5));
            states.push(interior.stress([x, y, z])?);
        }
        Ok(Self { states })
    }

    /// A passage of given states, as measured or computed elsewhere.
    #[must_use]
    pub fn new(states: Vec<Stress>) -> Self {
        Self { states }
    }

    /// The states.
    #[must_use]
    pub fn states(&self) -> &[Stress] {
        &self.states
    }
}

/// Dang Van's fatigue criterion: `(shear stress about its own middle) + c (mean stress)` at any moment of
/// the passage stays below the limit. K. Dang Van and others, ASTM STP 1191 (1993) 120-136.
///
/// *Unverified*: `c = 1/3`, the limit in pure shear 186e6 Pa, as of [`super::Ekberg`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DangVan {
    /// Weight `c` of the mean stress.
    pub mean_weight: f64,
    /// Limit of the equivalent stress (Pa).
    pub limit: f64,
}

impl Default for DangVan {
    fn default() -> Self {
        Self { mean_weight: 1.0 / 3.0, limit: 186e6 }
    }
}

impl DangVan {
    /// The largest equivalent stress of a passage (Pa). The middle is that of the smallest ball around
    /// the deviators, and shear stress half of Tresca's. Fatigue is predicted above the limit.
    #[must_use]
    pub fn equivalent(&self, passage: &Passage) -> f64 {
        let states: Vec<_> = passage.states.iter().map(ball::coordinates).collect();
        let middle = ball::deviator(ball::smallest(&states, 5).centre);
        let value = |stress: &Stress| {
            let shear = 0.5 * stress.deviator().plus(-1.0, &middle).tresca();
            shear + self.mean_weight * stress.trace() / 3.0
        };
        passage.states.iter().map(value).reduce(f64::max).unwrap_or(0.0)
    }
}
