//! How finely the full theory cuts the contact: a word, or two numbers.

use std::borrow::Cow;
use std::fmt;

use creepage::InvalidValue;
use creepage::rolling::exact;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};

/// Elements of the full theory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Resolution {
    /// 14 x 12 elements: forces to 0.3 % of mu N.
    Fast,
    /// 22 x 18 elements: forces to 0.1 %.
    Standard,
    /// 40 x 32 elements: forces to a few hundredths of a per cent.
    Fine,
    /// The first of these three whose error bars are within the wanted accuracy.
    Auto,
    /// So many elements along and across a circle.
    Elements([usize; 2]),
}

const WORDS: [&str; 4] = ["fast", "standard", "fine", "auto"];

impl Resolution {
    /// The library's resolution; none where the case itself decides.
    ///
    /// # Errors
    /// [`InvalidValue`] for a number of elements out of range.
    pub fn fixed(self) -> Result<Option<exact::Resolution>, InvalidValue> {
        let named = |invalid| InvalidValue { quantity: "resolution", ..invalid };
        match self {
            Self::Fast => Ok(Some(exact::Resolution::FAST)),
            Self::Standard => Ok(Some(exact::Resolution::STANDARD)),
            Self::Fine => Ok(Some(exact::Resolution::FINE)),
            Self::Auto => Ok(None),
            Self::Elements([along, across]) => {
                exact::Resolution::new(along, across).map(Some).map_err(named)
            }
        }
    }
}

impl<'de> Deserialize<'de> for Resolution {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ResolutionVisitor)
    }
}

struct ResolutionVisitor;

impl<'de> Visitor<'de> for ResolutionVisitor {
    type Value = Resolution;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\"fast\", \"standard\", \"fine\", \"auto\", or two numbers of elements")
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<Resolution, E> {
        match word {
            "fast" => Ok(Resolution::Fast),
            "standard" => Ok(Resolution::Standard),
            "fine" => Ok(Resolution::Fine),
            "auto" => Ok(Resolution::Auto),
            _ => Err(E::unknown_variant(word, &WORDS)),
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut numbers: A) -> Result<Resolution, A::Error> {
        let mut elements = Vec::new();
        while let Some(number) = numbers.next_element()? {
            elements.push(number);
        }
        let count = elements.len();
        let pair = elements.try_into().map_err(|_| A::Error::invalid_length(count, &self))?;
        Ok(Resolution::Elements(pair))
    }
}

impl JsonSchema for Resolution {
    fn schema_name() -> Cow<'static, str> {
        "Resolution".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "oneOf": [
            { "const": "fast", "description": "14 x 12 elements: forces to 0.3 % of mu N." },
            { "const": "standard", "description": "22 x 18 elements: forces to 0.1 %." },
            { "const": "fine",
              "description": "40 x 32 elements: forces to a few hundredths of a per cent." },
            { "const": "auto",
              "description": "The first of these whose error bars are within `accuracy`." },
            { "type": "array", "title": "[along, across]",
              "items": { "type": "integer", "minimum": 4, "maximum": 200 },
              "minItems": 2, "maxItems": 2,
              "description": "So many elements on a circle, 4 to 200 (10000 in all); on an ellipse they become \
                              more nearly square." },
        ] })
    }
}
