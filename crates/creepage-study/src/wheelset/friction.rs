//! Friction on a rail as a file has it: a number, a law by the speed of slip, or by the place on the rail.

use std::borrow::Cow;

use creepage_wheelset::{FrictionOfPlace, PlaceOnRail, RailFriction};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{Deserialize, Deserializer, Error};
use toml::Value;

use super::error::{WheelsetFileError, checked};
use crate::case::CaseError;
use crate::case::friction::FrictionValue;

const SECTION: &str = "contact friction";

/// Friction of a rail as the file has it.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum RailFrictionValue {
    OfCase(FrictionValue),
    Place(PlaceTable),
}

/// Friction by the place on the rail: linear between control points, constant beyond them.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct PlaceTable {
    /// Inclinations of the rail's surface in the axes of its profile (rad), rising; negative on the gauge
    /// face. Give these or `position`.
    angle: Option<Vec<f64>>,
    /// Places on the rail's profile, y to the field side (m), rising.
    position: Option<Vec<f64>>,
    /// The coefficient at each.
    value: Vec<f64>,
}

impl RailFrictionValue {
    pub(super) fn friction(&self) -> Result<RailFriction, WheelsetFileError> {
        match self {
            Self::OfCase(FrictionValue::Constant(value)) => {
                let is_valid = *value > 0.0 && value.is_finite();
                checked("contact", "friction", *value, is_valid, "positive and finite")?;
                Ok(RailFriction::Constant(*value))
            }
            Self::OfCase(value) => Ok(value.of_rail()?),
            Self::Place(table) => table.friction(),
        }
    }
}

impl PlaceTable {
    fn friction(&self) -> Result<RailFriction, WheelsetFileError> {
        let (by, places) = match (&self.angle, &self.position) {
            (Some(angle), None) => (PlaceOnRail::Angle, angle),
            (None, Some(position)) => (PlaceOnRail::Position, position),
            (Some(_), Some(_)) => {
                let [first, second] = ["angle", "position"].map(|key| (SECTION, key));
                return Err(CaseError::Conflict { first, second }.into());
            }
            (None, None) => {
                let keys = ["angle", "position"];
                return Err(CaseError::MissingEither { section: SECTION, keys }.into());
            }
        };
        Ok(RailFriction::Place(FrictionOfPlace::new(by, places, &self.value)?))
    }
}

impl<'de> Deserialize<'de> for RailFrictionValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(deserializer)?;
        let is_of_place = |table: &toml::Table| {
            ["angle", "position", "value"].iter().any(|key| table.contains_key(*key))
        };
        let wrong = |error: toml::de::Error| D::Error::custom(error.message());
        match value {
            Value::Table(table) if is_of_place(&table) => {
                let read = table.try_into().map(Self::Place);
                read.map_err(|error| D::Error::custom(format!("friction: {}", error.message())))
            }
            other => other.try_into().map(Self::OfCase).map_err(wrong),
        }
    }
}

impl JsonSchema for RailFrictionValue {
    fn schema_name() -> Cow<'static, str> {
        "RailFriction".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let (case, place) =
            (FrictionValue::json_schema(generator), PlaceTable::json_schema(generator));
        schemars::json_schema!({ "anyOf": [case, place] })
    }
}
