//! `[motion]`: creepage and spin from how the bodies move, in place of `[creepage]`.

use creepage::motion::{RigidMotion, RollingMotion};
use schemars::JsonSchema;
use serde::Deserialize;

use super::creepage::CreepageSection;
use super::error::CaseError;

/// How both bodies move, in place of `[creepage]`: x the rolling direction, y to its right, z into the lower
/// body, the origin at the contact. Creepage, spin and rolling velocity follow.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MotionSection {
    /// The upper body; at rest if not given.
    #[serde(default)]
    upper: BodyMotion,
    /// The lower body; at rest if not given.
    #[serde(default)]
    lower: BodyMotion,
    /// Velocity of the contact itself (m/s); zero if not given, where all is seen from the contact.
    #[serde(default)]
    contact_velocity: [f64; 3],
}

/// How one body moves.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct BodyMotion {
    /// A point of the body (m); by default the centre of its rolling radius, or the contact where it is flat.
    point: Option<[f64; 3]>,
    /// Velocity of that point (m/s).
    #[serde(default)]
    velocity: [f64; 3],
    /// Angular velocity (rad/s).
    #[serde(default)]
    angular_velocity: [f64; 3],
}

const SECTION: &str = "motion";

impl BodyMotion {
    fn rigid(&self, height: Option<f64>, key: &str) -> Result<RigidMotion, CaseError> {
        let turns = self.angular_velocity.iter().any(|part| part.abs() > 0.0);
        let missing = || CaseError::Missing { section: SECTION.into(), key: key.into() };
        let centre = height.map(|height| [0.0, 0.0, height]);
        let usual = if turns { centre.ok_or_else(missing) } else { Ok([0.0; 3]) };
        let point = self.point.map_or_else(|| usual, Ok)?;
        let Self { velocity, angular_velocity, .. } = *self;
        Ok(RigidMotion { point, velocity, angular_velocity })
    }
}

impl MotionSection {
    /// What `[creepage]` would say. `radii` are the rolling radii of the upper and the lower body, infinite
    /// where flat, where they are given.
    pub(crate) fn creepage(
        &self,
        radii: [Option<f64>; 2],
        given: &CreepageSection,
    ) -> Result<CreepageSection, CaseError> {
        let speed = given.speed.map(|_| "speed");
        if let Some(name) = given.names().next().or(speed) {
            return Err(CaseError::Conflict {
                first: (SECTION, "upper"),
                second: ("creepage", name),
            });
        }
        let height = |radius: f64| if radius.is_finite() { radius } else { 0.0 };
        let upper = self.upper.rigid(radii[0].map(|r| -height(r)), "upper point")?;
        let lower = self.lower.rigid(radii[1].map(height), "lower point")?;
        let found = RollingMotion::new(&upper, &lower, self.contact_velocity)
            .map_err(CaseError::invalid(SECTION))?;
        Ok(CreepageSection {
            longitudinal: Some(found.creepage.longitudinal),
            lateral: Some(found.creepage.lateral),
            spin: Some(found.creepage.spin),
            speed: Some(found.speed),
            ..CreepageSection::default()
        })
    }
}
