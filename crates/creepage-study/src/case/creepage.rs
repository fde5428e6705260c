//! `[creepage]`: in SI units or dimensionless.

use creepage::{Creepage, InvalidValue, Scaling, SiCreepage};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::case::error::CaseError;

/// Velocity of the upper body relative to the lower, over the rolling velocity: either
/// `longitudinal`, `lateral`, `spin` or the dimensionless `xi`, `eta`, `chi`. What is left out
/// is zero, unless [wanted] asks for it.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CreepageSection {
    /// Longitudinal creepage, positive along the rolling direction.
    pub(crate) longitudinal: Option<f64>,
    /// Lateral creepage, positive to the right of the rolling direction.
    pub(crate) lateral: Option<f64>,
    /// Spin (rad/m), positive from the rolling direction to the right.
    pub(crate) spin: Option<f64>,
    /// Dimensionless longitudinal creepage.
    pub(crate) xi: Option<f64>,
    /// Dimensionless lateral creepage.
    pub(crate) eta: Option<f64>,
    /// Dimensionless spin.
    pub(crate) chi: Option<f64>,
    /// Rolling velocity (m/s), for the frictional power in watts; a law of friction by the speed of slip
    /// needs it.
    pub(crate) speed: Option<f64>,
}

const SECTION: &str = "creepage";
const SI_NAMES: [&str; 3] = ["longitudinal", "lateral", "spin"];
const NAMES: [&str; 3] = ["xi", "eta", "chi"];

impl CreepageSection {
    /// The creepage, without dimension.
    pub(crate) fn resolve(&self, scaling: Scaling) -> Result<Creepage, CaseError> {
        if self.names().next().is_none() {
            return Err(CaseError::MissingSection {
                section: SECTION.into(),
                needs: "longitudinal, lateral, spin, or xi, eta, chi".into(),
            });
        }
        self.convert(scaling)
    }

    /// What is given of `xi`, `eta`, `chi`, in whichever units.
    pub(crate) fn known(&self, scaling: Scaling) -> Result<[Option<f64>; 3], CaseError> {
        let (si, dimensionless) = (self.si(), self.dimensionless());
        let creepage = self.convert(scaling)?.components();
        Ok([0, 1, 2].map(|k| si[k].or(dimensionless[k]).map(|_| creepage[k])))
    }

    /// Names of the creepages that are given.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'static str> {
        given(SI_NAMES, self.si()).chain(given(NAMES, self.dimensionless()))
    }

    /// Rolling velocity (m/s).
    pub(crate) fn speed(&self) -> Result<Option<f64>, CaseError> {
        match self.speed {
            Some(value) if !(value.is_finite() && value > 0.0) => {
                let valid = "finite and greater than zero";
                Err(CaseError::invalid(SECTION)(InvalidValue { quantity: "speed", value, valid }))
            }
            speed => Ok(speed),
        }
    }

    fn si(&self) -> [Option<f64>; 3] {
        [self.longitudinal, self.lateral, self.spin]
    }

    fn dimensionless(&self) -> [Option<f64>; 3] {
        [self.xi, self.eta, self.chi]
    }

    /// The creepage, zero where nothing is given.
    fn convert(&self, scaling: Scaling) -> Result<Creepage, CaseError> {
        let si = given(SI_NAMES, self.si()).next();
        match (si, given(NAMES, self.dimensionless()).next()) {
            (Some(first), Some(second)) => {
                Err(CaseError::Conflict { first: (SECTION, first), second: (SECTION, second) })
            }
            (_, None) => self.by_si(scaling),
            (None, Some(_)) => self.by_dimensionless(),
        }
    }

    fn by_si(&self, scaling: Scaling) -> Result<Creepage, CaseError> {
        let si = SiCreepage {
            longitudinal: self.longitudinal.unwrap_or(0.0),
            lateral: self.lateral.unwrap_or(0.0),
            spin: self.spin.unwrap_or(0.0),
        };
        scaling.creepage(si).map_err(CaseError::invalid(SECTION))
    }

    fn by_dimensionless(&self) -> Result<Creepage, CaseError> {
        let [xi, eta, chi] = [self.xi, self.eta, self.chi].map(|part| part.unwrap_or(0.0));
        Creepage::new(xi, eta, chi).map_err(CaseError::invalid(SECTION))
    }
}

/// Names whose value is given.
pub(crate) fn given(
    names: [&'static str; 3],
    values: [Option<f64>; 3],
) -> impl Iterator<Item = &'static str> {
    names.into_iter().zip(values).filter_map(|(name, value)| value.map(|_| name))
}
