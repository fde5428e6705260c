//! `[heat]`: that temperatures are wanted, how both bodies conduct heat, and how hot they are.

use creepage::InvalidValue;
use creepage::temperature::ThermalSolid;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::CaseError;

/// Temperatures of both surfaces are wanted. The rolling velocity must be given.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct HeatSection {
    /// The upper body, such as a wheel.
    upper: ThermalBody,
    /// The lower body, such as a rail.
    lower: ThermalBody,
}

/// How a body conducts heat: `material`, or all three of its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ThermalBody {
    /// "steel": 50 W/(m K), 7850 kg/m3, 450 J/(kg K).
    material: Option<Material>,
    /// Thermal conductivity (W/(m K)).
    conductivity: Option<f64>,
    /// Density (kg/m3).
    density: Option<f64>,
    /// Specific heat (J/(kg K)).
    specific_heat: Option<f64>,
    /// Temperature before the contact (degrees Celsius); 0 by default, temperatures then are rises.
    #[serde(default)]
    bulk_temperature: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Material {
    /// 50 W/(m K), 7850 kg/m3, 450 J/(kg K).
    Steel,
}

/// Options of temperatures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeatWanted {
    /// The upper and the lower body.
    pub solids: [ThermalSolid; 2],
    /// Their temperatures before the contact (degrees Celsius).
    pub bulk: [f64; 2],
}

const SECTION: &str = "heat";
/// In degrees Celsius.
const ABSOLUTE_ZERO: f64 = -273.15;

impl ThermalBody {
    fn solid(&self, body: &str) -> Result<ThermalSolid, CaseError> {
        let numbers = [
            ("conductivity", self.conductivity),
            ("density", self.density),
            ("specific_heat", self.specific_heat),
        ];
        if self.material.is_some() {
            let [Material::Steel] = [self.material.unwrap_or(Material::Steel)];
            return match numbers.into_iter().find(|(_, value)| value.is_some()) {
                None => Ok(ThermalSolid::STEEL),
                Some((key, _)) => Err(CaseError::Conflict {
                    first: (SECTION, "material"),
                    second: (SECTION, key),
                }),
            };
        }
        let [conductivity, density, specific_heat] = numbers.map(|(key, value)| {
            let key = format!("{body}: {key}");
            value.ok_or(CaseError::Missing { section: SECTION.into(), key })
        });
        let (conductivity, density, specific_heat) = (conductivity?, density?, specific_heat?);
        // Below these no solid is: g/cm3, kJ.
        for (quantity, value, valid) in [
            ("density", density, "at least 10 kg/m3"),
            ("specific_heat", specific_heat, "at least 10 J/(kg K)"),
        ] {
            if value > 0.0 && value < 10.0 {
                return Err(CaseError::invalid(SECTION)(InvalidValue { quantity, value, valid }));
            }
        }
        ThermalSolid::new(conductivity, density, specific_heat).map_err(CaseError::invalid(SECTION))
    }
}

impl HeatSection {
    /// What is wanted; rolling at `speed` (m/s), which must be given.
    pub(crate) fn wanted(&self, speed: Option<f64>) -> Result<HeatWanted, CaseError> {
        self.rolling("creepage", speed)
    }

    /// The same of a wheelset, whose speed stands elsewhere.
    pub(crate) fn wanted_of_wheels(&self, speed: Option<f64>) -> Result<HeatWanted, CaseError> {
        self.rolling("motion", speed)
    }

    fn rolling(&self, section: &str, speed: Option<f64>) -> Result<HeatWanted, CaseError> {
        let missing = || CaseError::Missing {
            section: section.into(),
            key: "speed, which [heat] needs,".into(),
        };
        speed.filter(|speed| speed.abs() > 0.0).ok_or_else(missing)?;
        let solids = [self.upper.solid("upper")?, self.lower.solid("lower")?];
        let bulk = [self.upper.bulk_temperature, self.lower.bulk_temperature];
        if let Some(value) =
            bulk.into_iter().find(|bulk| !(ABSOLUTE_ZERO..f64::INFINITY).contains(bulk))
        {
            let (quantity, valid) =
                ("bulk_temperature", "a finite number of degrees Celsius, not below -273.15");
            return Err(CaseError::invalid(SECTION)(InvalidValue { quantity, value, valid }));
        }
        Ok(HeatWanted { solids, bulk })
    }
}
