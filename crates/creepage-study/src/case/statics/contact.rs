//! `[contact]` of a statics file: as that of a case file, but problems without friction or load
//! leave these out.

use creepage::{Ellipse, Hertz};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::case::body::Body;
use crate::case::contact::ContactSection;
use crate::case::error::CaseError;

/// The load, the friction, and the contact ellipse where it is known beforehand.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StaticsContact {
    /// Normal force N that presses the bodies together (N). A shift or a twist without slip
    /// needs it only where the ellipse follows from the bodies' radii.
    normal_force: Option<f64>,
    /// Coefficient of friction mu. Problems "partial-slip", "shift-path", "compression" and
    /// "sheared-rectangle".
    friction: Option<f64>,
    /// Semi-axis a of the contact ellipse along x (m). Both semi-axes replace the bodies' radii;
    /// problem "die": the die's base.
    semi_axis_rolling: Option<f64>,
    /// Semi-axis b of the contact ellipse along y (m).
    semi_axis_lateral: Option<f64>,
    /// Problem "sheared-rectangle": half of the rectangle's length along x (m).
    half_length_rolling: Option<f64>,
    /// Problem "sheared-rectangle": half of the rectangle's length along y (m).
    half_length_lateral: Option<f64>,
}

const SECTION: &str = "contact";

impl StaticsContact {
    pub(crate) fn normal_force(&self) -> Result<f64, CaseError> {
        self.normal_force.ok_or_else(|| missing("normal_force"))
    }

    pub(crate) fn friction(&self) -> Result<f64, CaseError> {
        self.friction.ok_or_else(|| missing("friction"))
    }

    /// The half-lengths of a rectangle between bodies without radii or semi-axes.
    pub(crate) fn rectangle(&self, upper: &Body, lower: &Body) -> Result<[f64; 2], CaseError> {
        let first = (SECTION, "half_length_rolling");
        for (section, body) in [("upper", upper), ("lower", lower)] {
            if let Some(key) = body.any_radius() {
                return Err(CaseError::Conflict { first, second: (section, key) });
            }
        }
        let semi_axes = [
            ("semi_axis_rolling", self.semi_axis_rolling),
            ("semi_axis_lateral", self.semi_axis_lateral),
        ];
        if let Some((key, _)) = semi_axes.iter().find(|(_, given)| given.is_some()) {
            return Err(CaseError::Conflict { first, second: (SECTION, key) });
        }
        let along = self.half_length_rolling.ok_or_else(|| missing("half_length_rolling"))?;
        let across = self.half_length_lateral.ok_or_else(|| missing("half_length_lateral"))?;
        Ok([along, across])
    }

    /// A key of a rectangle, which other problems do not have.
    pub(crate) fn of_rectangle(&self) -> Option<&'static str> {
        let along = self.half_length_rolling.map(|_| "half_length_rolling");
        along.or(self.half_length_lateral.map(|_| "half_length_lateral"))
    }

    /// The contact of two bodies under load.
    pub(crate) fn hertz(&self, upper: &Body, lower: &Body) -> Result<Hertz, CaseError> {
        let contact = ContactSection {
            normal_force: self.normal_force()?,
            friction: None,
            angle: None,
            semi_axis_rolling: self.semi_axis_rolling,
            semi_axis_lateral: self.semi_axis_lateral,
            slip: None,
        };
        contact.hertz(upper, lower)
    }

    /// The contact ellipse of two bodies; where it is given, the load has no say in it.
    pub(crate) fn ellipse(&self, upper: &Body, lower: &Body) -> Result<Ellipse, CaseError> {
        let given = self.semi_axis_rolling.is_some() && self.semi_axis_lateral.is_some();
        if given && self.normal_force.is_none() {
            reject_radii("upper", upper)?;
            return self.base(lower);
        }
        Ok(self.hertz(upper, lower)?.ellipse())
    }

    /// The given ellipse, of which the lower body has no radii.
    pub(crate) fn base(&self, lower: &Body) -> Result<Ellipse, CaseError> {
        reject_radii("lower", lower)?;
        let a = self.semi_axis_rolling.ok_or_else(|| missing("semi_axis_rolling"))?;
        let b = self.semi_axis_lateral.ok_or_else(|| missing("semi_axis_lateral"))?;
        Ellipse::new(a, b).map_err(CaseError::invalid(SECTION))
    }
}

fn reject_radii(section: &'static str, body: &Body) -> Result<(), CaseError> {
    body.any_radius().map_or(Ok(()), |key| {
        Err(CaseError::Conflict { first: (SECTION, "semi_axis_rolling"), second: (section, key) })
    })
}

fn missing(key: &str) -> CaseError {
    CaseError::Missing { section: SECTION.into(), key: key.into() }
}
