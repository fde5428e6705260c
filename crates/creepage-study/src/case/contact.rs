//! `[contact]`: what presses the bodies together, and the ellipse that comes of it.

use creepage::{Ellipse, Hertz, HertzError, SolidPair};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::case::body::Body;
use crate::case::error::CaseError;
use crate::case::friction::FrictionValue;
use crate::case::slip::SlipPoints;

/// The load and the friction, and the contact ellipse where it is known beforehand.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ContactSection {
    /// Normal force N that presses the bodies together (N).
    pub(crate) normal_force: f64,
    /// Coefficient of friction mu, or a law by the speed of slip or across the contact, whose largest
    /// value is mu. Needed for rolling, not for the contact alone.
    pub(crate) friction: Option<FrictionValue>,
    /// Angle from the upper body's rolling section to the lower body's (degrees); 0 by default.
    pub(crate) angle: Option<f64>,
    /// Semi-axis of the contact ellipse along the rolling direction (m). Both semi-axes
    /// replace the bodies' radii.
    pub(crate) semi_axis_rolling: Option<f64>,
    /// Semi-axis of the contact ellipse across the rolling direction (m).
    pub(crate) semi_axis_lateral: Option<f64>,
    /// Rigid slip of the upper body relative to the lower, over the rolling velocity, that differs from place to
    /// place: added to that of creepage and spin. CSV file beside the case file with the columns x, y (m),
    /// longitudinal, lateral, or these as lists: the points of a rectangular grid, in any order. Theory exact.
    #[schemars(with = "SlipPoints")]
    #[serde(default)]
    pub(crate) slip: Option<SlipPoints>,
}

const SECTION: &str = "contact";

impl ContactSection {
    /// The contact of the two bodies, from their radii or from the given ellipse.
    pub(crate) fn hertz(&self, upper: &Body, lower: &Body) -> Result<Hertz, CaseError> {
        let pair = SolidPair::new(upper.solid("upper")?, lower.solid("lower")?);
        let missing = |key: &str| CaseError::Missing { section: SECTION.into(), key: key.into() };
        match (self.semi_axis_rolling, self.semi_axis_lateral) {
            (None, None) => self.by_radii(pair, upper, lower),
            (Some(a), Some(b)) => {
                self.reject_shape_beside_ellipse(upper, lower)?;
                Ellipse::new(a, b)
                    .and_then(|ellipse| Hertz::from_ellipse(pair, ellipse, self.normal_force))
                    .map_err(CaseError::invalid(SECTION))
            }
            (Some(_), None) => Err(missing("semi_axis_lateral")),
            (None, Some(_)) => Err(missing("semi_axis_rolling")),
        }
    }

    fn by_radii(&self, pair: SolidPair, upper: &Body, lower: &Body) -> Result<Hertz, CaseError> {
        let angle = self.angle.unwrap_or(0.0);
        let radii = [upper.radii("upper")?, lower.radii("lower")?];
        Hertz::new(pair, radii[0], radii[1], angle.to_radians(), self.normal_force).map_err(
            |error| match error {
                HertzError::Invalid(invalid) => CaseError::invalid(SECTION)(invalid),
                source => CaseError::Shape {
                    upper: upper.describe_radii(),
                    lower: lower.describe_radii(),
                    source,
                },
            },
        )
    }

    fn reject_shape_beside_ellipse(&self, upper: &Body, lower: &Body) -> Result<(), CaseError> {
        let second = upper
            .any_radius()
            .map(|key| ("upper", key))
            .or(lower.any_radius().map(|key| ("lower", key)))
            .or(self.angle.map(|_| (SECTION, "angle")));
        second.map_or(Ok(()), |second| {
            Err(CaseError::Conflict { first: (SECTION, "semi_axis_rolling"), second })
        })
    }
}
