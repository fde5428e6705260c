//! Quantity that is given, or found from equilibrium: a number, or the word "free".

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::{Deserializer, Error, Unexpected, Visitor};

/// As the file has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum GivenOrFree {
    Given(f64),
    Free,
}

impl GivenOrFree {
    /// The number; `None` where free.
    pub(super) fn number(self) -> Option<f64> {
        match self {
            Self::Given(number) => Some(number),
            Self::Free => None,
        }
    }
}

impl<'de> Deserialize<'de> for GivenOrFree {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(GivenOrFreeVisitor)
    }
}

/// A pitch rate as the file has it: of the axle, or of the left and the right wheel.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected a number, \"free\", or two of these in brackets")]
pub(super) enum PitchValue {
    Axle(GivenOrFree),
    Wheels([GivenOrFree; 2]),
}

struct GivenOrFreeVisitor;

impl Visitor<'_> for GivenOrFreeVisitor {
    type Value = GivenOrFree;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or \"free\"")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<GivenOrFree, E> {
        Ok(GivenOrFree::Given(number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<GivenOrFree, E> {
        Ok(GivenOrFree::Given(number as f64))
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<GivenOrFree, E> {
        Ok(GivenOrFree::Given(number as f64))
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<GivenOrFree, E> {
        if word == "free" {
            Ok(GivenOrFree::Free)
        } else {
            Err(E::invalid_value(Unexpected::Str(word), &self))
        }
    }
}

impl JsonSchema for GivenOrFree {
    fn schema_name() -> Cow<'static, str> {
        "GivenOrFree".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "type": "number" }, { "const": "free" }] })
    }
}
