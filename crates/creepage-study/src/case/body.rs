//! `[upper]` and `[lower]`: one body's material and its shape at the contact.

use creepage::{Radii, Solid};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::case::error::CaseError;
use crate::case::radius::Radius;

/// One body: its material, and its radii of curvature at the contact.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Body {
    /// Shear modulus G (Pa). Give this or `young_modulus`.
    pub(crate) shear_modulus: Option<f64>,
    /// Young's modulus E (Pa). Give this or `shear_modulus`.
    pub(crate) young_modulus: Option<f64>,
    /// Poisson's ratio, 0 to 0.5.
    pub(crate) poisson: f64,
    /// Radius of the section along the rolling direction (m): a wheel's rolling radius.
    /// Positive where convex, negative where hollow, "flat" where straight.
    pub(crate) radius_rolling: Option<Radius>,
    /// Radius of the section across the rolling direction (m): a rail head's.
    /// Positive where convex, negative where hollow, "flat" where straight.
    pub(crate) radius_lateral: Option<Radius>,
}

impl Body {
    /// Its radius along the rolling direction (m), infinite where flat; `None` where none is given, or none
    /// that is one.
    pub(crate) fn rolling_radius(&self) -> Option<f64> {
        self.radius_rolling.and_then(|radius| radius.metres().ok())
    }

    pub(crate) fn solid(&self, section: &'static str) -> Result<Solid, CaseError> {
        let solid = match (self.shear_modulus, self.young_modulus) {
            (Some(g), None) => Solid::new(g, self.poisson),
            (None, Some(e)) => Solid::from_young_modulus(e, self.poisson),
            (Some(_), Some(_)) => {
                return Err(CaseError::Conflict {
                    first: (section, "shear_modulus"),
                    second: (section, "young_modulus"),
                });
            }
            (None, None) => {
                let keys = ["shear_modulus", "young_modulus"];
                return Err(CaseError::MissingEither { section, keys });
            }
        };
        solid.map_err(CaseError::invalid(section))
    }

    pub(crate) fn radii(&self, section: &'static str) -> Result<Radii, CaseError> {
        let metres = |key: &'static str, radius: Option<Radius>| {
            radius
                .ok_or(CaseError::Missing { section: section.into(), key: key.into() })?
                .metres()
                .map_err(|value| CaseError::Radius { section, key, value, valid: Radius::VALID })
        };
        Ok(Radii {
            rolling: metres("radius_rolling", self.radius_rolling)?,
            lateral: metres("radius_lateral", self.radius_lateral)?,
        })
    }

    /// The smaller of the radii that are given (m), its size; none of a flat body.
    pub(crate) fn smallest_radius(&self) -> Option<f64> {
        let radii = [self.radius_rolling, self.radius_lateral].into_iter().flatten();
        radii.filter_map(|radius| radius.metres().ok()).map(f64::abs).reduce(f64::min)
    }

    /// The name of a radius that is given, if one is.
    pub(crate) fn any_radius(&self) -> Option<&'static str> {
        self.radius_rolling
            .map(|_| "radius_rolling")
            .or(self.radius_lateral.map(|_| "radius_lateral"))
    }

    /// The shape in the file's words, for messages.
    pub(crate) fn describe_radii(&self) -> String {
        let word = |radius: Option<Radius>| radius.unwrap_or(Radius::Flat);
        format!(
            "radius_rolling = {}, radius_lateral = {}",
            word(self.radius_rolling),
            word(self.radius_lateral)
        )
    }
}
