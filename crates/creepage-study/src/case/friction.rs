//! `[contact] friction`: a number, or a law by the speed of slip or by the place.

use std::borrow::Cow;

use creepage::friction_law::{
    FrictionAcross, FrictionByTemperature, FrictionLaw, FrictionMemory, RollingFriction, Shape,
    Term,
};
use creepage::temperature::HeatedPair;
use creepage::{Contact, Hertz, InvalidValue};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{Deserialize, Deserializer, Error};
use toml::Value;

use super::error::CaseError;
use crate::heat::HeatWanted;
use creepage_wheelset::RailFriction;

const SECTION: &str = "contact";

/// Friction as a case file has it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum FrictionValue {
    /// Coulomb's.
    Constant(f64),
    /// By the speed of slip.
    Law(LawTable),
    /// By the place across the contact.
    Across(AcrossTable),
    /// By the temperature of both surfaces.
    Temperature(TemperatureTable),
}

/// How friction differs across the contact: linear between the places, constant beyond them.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AcrossTable {
    /// Two to seven pairs of y (m), rising, and the coefficient there.
    across: Vec<[f64; 2]>,
}

/// How friction depends on the temperature of both surfaces in contact; needs `[heat]`.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TemperatureTable {
    /// Coefficient of cold surfaces.
    cold: f64,
    /// Coefficient of hot surfaces.
    hot: f64,
    /// The temperatures from which on friction changes and from which on it is that of hot surfaces
    /// (degrees Celsius); linear between.
    temperatures: [f64; 2],
}

/// How friction depends on the absolute speed of slip: from kinetic plus all drops, at rest, down to
/// kinetic.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LawTable {
    /// How the terms fall.
    law: LawName,
    /// Coefficient at very high speed.
    kinetic: f64,
    /// Up to four falling terms; none where the law is "constant".
    #[serde(default)]
    terms: Vec<TermTable>,
    /// Distance of slip over which friction follows the speed (m). Give this and `memory_speed`, or
    /// neither.
    memory_distance: Option<f64>,
    /// The least speed that slip counts as in that (m/s).
    memory_speed: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum LawName {
    /// The same at every speed.
    Constant,
    /// Each term `drop 2^(-s/half_speed)`.
    Exponential,
    /// Each term `drop max(0, 1 - s/(2 half_speed))`.
    Linear,
    /// Term number i `drop/(1 + (s/half_speed)^i)`.
    Rational,
}

/// One falling part of a law.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct TermTable {
    /// What the term adds at rest.
    drop: f64,
    /// Speed of slip at which half of it is left (m/s).
    half_speed: f64,
}

impl FrictionValue {
    /// The contact with this friction, for bodies that roll at `speed` (m/s).
    pub(crate) fn contact(
        &self,
        hertz: &Hertz,
        speed: Option<f64>,
        heat: Option<HeatWanted>,
    ) -> Result<Contact, CaseError> {
        let contact = hertz.with_friction(self.at_rest()?).map_err(CaseError::invalid(SECTION))?;
        Ok(match self.rolling(speed, heat)? {
            Some(friction) => contact.with_rolling_friction(friction),
            None => contact,
        })
    }

    /// That of a rail; across a contact it is given in other axes there.
    pub(crate) fn of_rail(&self) -> Result<RailFriction, CaseError> {
        match self {
            Self::Constant(friction) => Ok(RailFriction::Constant(*friction)),
            Self::Law(table) => Ok(RailFriction::Law(table.law()?, table.memory()?)),
            Self::Across(_) => Err(CaseError::AcrossOnRail),
            Self::Temperature(_) => Err(CaseError::TemperatureOnRail),
        }
    }

    /// The coefficient at rest, the `mu` of all quantities.
    pub(crate) fn at_rest(&self) -> Result<f64, CaseError> {
        match self {
            Self::Constant(friction) => Ok(*friction),
            Self::Law(table) => Ok(table.law()?.at_rest()),
            Self::Across(table) => Ok(table.friction()?.largest()),
            Self::Temperature(table) => Ok(table.friction()?.largest()),
        }
    }

    /// Whether it is a law, or differs from place to place or with the temperature.
    pub(crate) fn varies(&self) -> bool {
        match self {
            Self::Constant(_) => false,
            Self::Law(table) => table.law != LawName::Constant,
            Self::Across(_) | Self::Temperature(_) => true,
        }
    }

    /// How friction varies, where it is not constant.
    pub(crate) fn rolling(
        &self,
        speed: Option<f64>,
        heat: Option<HeatWanted>,
    ) -> Result<Option<RollingFriction>, CaseError> {
        let table = match self {
            Self::Constant(_) => return Ok(None),
            Self::Across(table) => return table.rolling().map(Some),
            Self::Temperature(table) => return table.rolling(speed, heat).map(Some),
            Self::Law(table) => table,
        };
        let (law, memory) = (table.law()?, table.memory()?);
        if table.law == LawName::Constant {
            return Ok(None);
        }
        let speed = speed.ok_or(CaseError::SpeedOfLaw)?;
        let rolling = RollingFriction::new(law, memory, speed);
        rolling.map(Some).map_err(CaseError::invalid("creepage"))
    }
}

impl AcrossTable {
    fn friction(&self) -> Result<FrictionAcross, CaseError> {
        let invalid = CaseError::invalid("contact friction");
        // As far from a contact no place of it lies.
        if let Some([value, _]) = self.across.iter().find(|[y, _]| y.abs() > 1.0) {
            let (quantity, valid) = ("y of friction across", "within 1 m of the contact");
            return Err(invalid(InvalidValue { quantity, value: *value, valid }));
        }
        FrictionAcross::new(&self.across).map_err(invalid)
    }

    fn rolling(&self) -> Result<RollingFriction, CaseError> {
        RollingFriction::across(self.friction()?).map_err(CaseError::invalid("contact friction"))
    }
}

impl TemperatureTable {
    fn friction(&self) -> Result<FrictionByTemperature, CaseError> {
        FrictionByTemperature::new(self.cold, self.hot - self.cold, self.temperatures)
            .map_err(CaseError::invalid("contact friction"))
    }

    fn rolling(
        &self,
        speed: Option<f64>,
        heat: Option<HeatWanted>,
    ) -> Result<RollingFriction, CaseError> {
        let HeatWanted { solids, bulk } = heat.ok_or(CaseError::HeatOfFriction)?;
        let speed = speed.ok_or(CaseError::SpeedOfLaw)?;
        let friction = self.friction()?;
        HeatedPair::new(solids, [speed; 2], bulk)
            .and_then(|pair| RollingFriction::by_temperature(friction, pair, speed))
            .map_err(CaseError::invalid("heat"))
    }
}

impl LawTable {
    fn law(&self) -> Result<FrictionLaw, CaseError> {
        let shape = match self.law {
            LawName::Constant if self.terms.is_empty() => Shape::Linear,
            LawName::Constant => return Err(CaseError::TermsOfConstant),
            LawName::Exponential => Shape::Exponential,
            LawName::Linear => Shape::Linear,
            LawName::Rational => Shape::Rational,
        };
        let term = |term: &TermTable| Term { drop: term.drop, half_speed: term.half_speed };
        let terms: Vec<_> = self.terms.iter().map(term).collect();
        if let Some(Term { half_speed: value, .. }) = terms.iter().find(|t| t.half_speed > 100.0) {
            let (quantity, valid) = ("half_speed", "positive, at most 100 m/s");
            let invalid = InvalidValue { quantity, value: *value, valid };
            return Err(CaseError::invalid("contact friction")(invalid));
        }
        FrictionLaw::new(shape, self.kinetic, &terms)
            .map_err(CaseError::invalid("contact friction"))
    }

    fn memory(&self) -> Result<Option<FrictionMemory>, CaseError> {
        let missing = |key: &str| CaseError::Missing {
            section: "contact".into(),
            key: format!("friction: {key}"),
        };
        let own = self.memory_distance.map(|value| ("memory_distance", value));
        let own = own.or(self.memory_speed.map(|value| ("memory_speed", value)));
        if let Some((quantity, value)) = own.filter(|_| self.law == LawName::Constant) {
            let valid = "left out where the law is \"constant\"";
            let invalid = InvalidValue { quantity, value, valid };
            return Err(CaseError::invalid("contact friction")(invalid));
        }
        match (self.memory_distance, self.memory_speed) {
            (None, None) => Ok(None),
            (Some(value), _) if value > 1.0 => {
                let (quantity, valid) = ("memory_distance", "positive, at most 1 m");
                let invalid = InvalidValue { quantity, value, valid };
                Err(CaseError::invalid("contact friction")(invalid))
            }
            (Some(distance), Some(speed)) => FrictionMemory::new(distance, speed)
                .map(Some)
                .map_err(CaseError::invalid("contact friction")),
            (Some(_), None) => Err(missing("memory_speed")),
            (None, Some(_)) => Err(missing("memory_distance")),
        }
    }
}

impl<'de> Deserialize<'de> for FrictionValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match Value::deserialize(deserializer)? {
            Value::Float(friction) => Ok(Self::Constant(friction)),
            Value::Integer(friction) => Ok(Self::Constant(friction as f64)),
            Value::Table(table) => {
                let read = if table.contains_key("across") {
                    table.try_into().map(Self::Across)
                } else if table.contains_key("temperatures") {
                    table.try_into().map(Self::Temperature)
                } else {
                    table.try_into().map(Self::Law)
                };
                read.map_err(|error| D::Error::custom(format!("friction: {}", error.message())))
            }
            other => Err(D::Error::custom(format!(
                "friction = {other}: expected a number, or a table with law, kinetic and terms, with \
                 across, or with cold, hot and temperatures"
            ))),
        }
    }
}

impl JsonSchema for FrictionValue {
    fn schema_name() -> Cow<'static, str> {
        "Friction".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let (law, across) = (LawTable::json_schema(generator), AcrossTable::json_schema(generator));
        let temperature = TemperatureTable::json_schema(generator);
        schemars::json_schema!({ "anyOf": [{ "type": "number" }, law, across, temperature] })
    }
}
