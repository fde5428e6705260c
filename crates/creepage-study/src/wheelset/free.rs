//! A quantity that is given, or found from equilibrium: a number, or the word "free".

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::{Deserializer, Error, Unexpected, Visitor};

/// As the file has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Freely {
    Given(f64),
    Free,
}

impl Freely {
    /// The number; `None` where free.
    pub(super) fn number(self) -> Option<f64> {
        match self {
            Self::Given(number) => Some(number),
            Self::Free => None,
        }
    }
}

impl<'de> Deserialize<'de> for Freely {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(FreelyVisitor)
    }
}

/// A pitch rate as the file has it: of the axle, or of the left and the right wheel.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected a number, \"free\", or two of these in brackets")]
pub(super) enum PitchValue {
    Axle(Freely),
    Wheels([Freely; 2]),
}

struct FreelyVisitor;

impl Visitor<'_> for FreelyVisitor {
    type Value = Freely;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or \"free\"")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Freely, E> {
        Ok(Freely::Given(number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Freely, E> {
        Ok(Freely::Given(number as f64))
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Freely, E> {
        Ok(Freely::Given(number as f64))
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<Freely, E> {
        if word == "free" {
            Ok(Freely::Free)
        } else {
            Err(E::invalid_value(Unexpected::Str(word), &self))
        }
    }
}

impl JsonSchema for Freely {
    fn schema_name() -> Cow<'static, str> {
        "Freely".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "type": "number" }, { "const": "free" }] })
    }
}
