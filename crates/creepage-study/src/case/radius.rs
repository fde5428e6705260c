//! A principal radius of curvature: a number, or the word "flat".

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Error, Visitor};

use super::body::Body;
use super::error::CaseError;

/// A radius of curvature as a case file has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Radius {
    /// Radius (m): positive where the body is convex, negative where it is hollow.
    Curved(f64),
    /// No curvature.
    Flat,
}

impl Radius {
    pub(crate) const VALID: &'static str =
        "in metres, positive for a convex and negative for a hollow body, not zero; or \"flat\"";

    /// The radius (m), infinite where flat; `Err` with the number that is no radius.
    pub(crate) fn metres(self) -> Result<f64, f64> {
        match self {
            Self::Flat => Ok(f64::INFINITY),
            Self::Curved(radius) if radius.is_finite() && radius.recip().is_finite() => Ok(radius),
            Self::Curved(radius) => Err(radius),
        }
    }
}

/// Radii along the rolling direction of two cylinders (m), those of the bodies or the one of both; refuses crowns, and
/// cylinders that do not touch along a line.
pub(crate) fn line_radii(
    bodies: [&Body; 2],
    of_both: Option<Radius>,
) -> Result<[f64; 2], CaseError> {
    let named = || ["upper", "lower"].into_iter().zip(bodies);
    for (section, body) in named() {
        if let Some(Radius::Curved(radius)) = body.radius_lateral {
            return Err(CaseError::CrownOnLine { section, radius });
        }
    }
    let metres = |section: &'static str, radius: Radius| {
        let valid = Radius::VALID;
        let key = "radius_rolling";
        radius.metres().map_err(|value| CaseError::Radius { section, key, value, valid })
    };
    if let Some(radius) = of_both {
        let (first, key) = (("contact", "radius_rolling"), "radius_rolling");
        if let Some((section, _)) = named().find(|(_, body)| body.radius_rolling.is_some()) {
            return Err(CaseError::Conflict { first, second: (section, key) });
        }
        return Ok([metres("contact", radius)?, f64::INFINITY]);
    }
    let mut radii = [f64::INFINITY; 2];
    for (radius, (section, body)) in radii.iter_mut().zip(named()) {
        let missing =
            || CaseError::Missing { section: section.into(), key: "radius_rolling".into() };
        *radius = metres(section, body.radius_rolling.ok_or_else(missing)?)?;
    }
    let [upper, lower] = radii;
    if upper.recip() + lower.recip() > 0.0 {
        return Ok(radii);
    }
    // A hollow that is as tight as the body that it holds, or two flat bodies.
    let (section, value) = if lower < 0.0 { ("lower", lower) } else { ("upper", upper) };
    let valid = "such that the bodies part: a hollow (negative) larger in size than what it holds, not both flat";
    Err(CaseError::Radius { section, key: "radius_rolling", value, valid })
}

impl fmt::Display for Radius {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Curved(radius) => radius.fmt(f),
            Self::Flat => f.write_str("\"flat\""),
        }
    }
}

impl<'de> Deserialize<'de> for Radius {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(RadiusVisitor)
    }
}

struct RadiusVisitor;

impl Visitor<'_> for RadiusVisitor {
    type Value = Radius;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a radius in metres or \"flat\"")
    }

    fn visit_f64<E: Error>(self, radius: f64) -> Result<Radius, E> {
        Ok(Radius::Curved(radius))
    }

    fn visit_i64<E: Error>(self, radius: i64) -> Result<Radius, E> {
        Ok(Radius::Curved(radius as f64))
    }

    fn visit_u64<E: Error>(self, radius: u64) -> Result<Radius, E> {
        Ok(Radius::Curved(radius as f64))
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<Radius, E> {
        if word == "flat" {
            Ok(Radius::Flat)
        } else {
            Err(E::invalid_value(serde::de::Unexpected::Str(word), &self))
        }
    }
}

impl JsonSchema for Radius {
    fn schema_name() -> Cow<'static, str> {
        "Radius".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "type": "number" }, { "const": "flat" }] })
    }
}
