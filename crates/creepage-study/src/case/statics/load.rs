//! `[statics]`: which problem, and its load.

use creepage::InvalidValue;
use creepage::statics::{ShiftAxis, ShiftEnd};
use schemars::JsonSchema;
use serde::Deserialize;

use super::error::StaticsError;
use crate::case::error::CaseError;

/// The problem, and the load that the upper body exerts on the lower; each problem takes its own
/// keys.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Statics {
    /// "die": a rigid die under an offset load; "shift" and "twist": without slip;
    /// "partial-slip": a shift with slip at the edge (Cattaneo, Mindlin); "shift-path": the same to and fro,
    /// under a load that stays or changes (Mindlin, Deresiewicz); "compression": unlike balls pressed together with friction
    /// (Spence); "sheared-rectangle": a layer under a rectangle of uniform pressure, sheared to and fro.
    pub(crate) problem: Problem,
    /// Problem "die": offset of the normal force from the centre, along x (m); 0 by default.
    offset_x: Option<f64>,
    /// Problem "die": offset of the normal force from the centre, along y (m); 0 by default.
    offset_y: Option<f64>,
    /// Problems "shift" and "partial-slip": tangential force along x (N).
    force_x: Option<f64>,
    /// Problems "shift" and "partial-slip": tangential force along y (N).
    force_y: Option<f64>,
    /// Problem "twist": moment about z, positive from x to y (N m).
    moment: Option<f64>,
    /// Problems "shift-path" and "sheared-rectangle": the axis along which the bodies are shifted.
    along: Option<Along>,
    /// Problems "shift-path" and "sheared-rectangle": where the path goes, one step after the other.
    steps: Option<Vec<ShiftStep>>,
}

/// An axis of the contact ellipse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Along {
    X,
    Y,
}

/// Where a step of a path ends: a force or a shift.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ShiftStep {
    /// Tangential force (N).
    pub(crate) force: Option<f64>,
    /// Shift of the upper body relative to the lower (m).
    pub(crate) shift: Option<f64>,
    /// Problem "shift-path": load at its end (N), to which it goes in proportion with the force, or with the shift
    /// over Hertz's approach; that of the step before by default, and first that of [contact].
    pub(crate) normal_force: Option<f64>,
}

/// The load of a step (N), where it has one of its own, and where it ends.
pub(crate) type LoadedEnd = (Option<f64>, ShiftEnd);

/// The problems by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Problem {
    Die,
    Shift,
    Twist,
    PartialSlip,
    ShiftPath,
    Compression,
    ShearedRectangle,
}

impl Problem {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Die => "die",
            Self::Shift => "shift",
            Self::Twist => "twist",
            Self::PartialSlip => "partial-slip",
            Self::ShiftPath => "shift-path",
            Self::Compression => "compression",
            Self::ShearedRectangle => "sheared-rectangle",
        }
    }

    /// The keys of its load.
    fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Die => &["offset_x", "offset_y"],
            Self::Shift | Self::PartialSlip => &["force_x", "force_y"],
            Self::Twist => &["moment"],
            Self::ShiftPath | Self::ShearedRectangle => &["along", "steps"],
            Self::Compression => &[],
        }
    }
}

impl Statics {
    /// A load of another problem must not be dropped in silence.
    pub(crate) fn reject_foreign_keys(&self) -> Result<(), StaticsError> {
        let keys = self.problem.keys();
        let given = [
            ("offset_x", self.offset_x.is_some()),
            ("offset_y", self.offset_y.is_some()),
            ("force_x", self.force_x.is_some()),
            ("force_y", self.force_y.is_some()),
            ("moment", self.moment.is_some()),
            ("along", self.along.is_some()),
            ("steps", self.steps.is_some()),
        ];
        let foreign = given.iter().find(|(key, is_given)| *is_given && !keys.contains(key));
        foreign.map_or(Ok(()), |&(key, _)| {
            Err(StaticsError::ForeignKey { key, problem: self.problem.name(), keys })
        })
    }

    pub(crate) fn offset(&self) -> [f64; 2] {
        [self.offset_x.unwrap_or(0.0), self.offset_y.unwrap_or(0.0)]
    }

    pub(crate) fn tangential_force(&self) -> Result<[f64; 2], CaseError> {
        let first = self.force_x.map(|_| "force_x").or(self.force_y.map(|_| "force_y"));
        let keys = ["force_x", "force_y"];
        let first = first.ok_or(CaseError::MissingEither { section: "statics", keys })?;
        let x = finite("force_x", self.force_x.unwrap_or(0.0))?;
        let y = finite("force_y", self.force_y.unwrap_or(0.0))?;
        if x == 0.0 && y == 0.0 {
            return Err(invalid(first, 0.0, "other than zero, unless the other force is"));
        }
        Ok([x, y])
    }

    /// The axis of a path, and where its steps end, with their loads.
    pub(crate) fn path(&self) -> Result<(ShiftAxis, Vec<LoadedEnd>), CaseError> {
        let missing = |key: &str| CaseError::Missing { section: "statics".into(), key: key.into() };
        let axis = match self.along.ok_or_else(|| missing("along"))? {
            Along::X => ShiftAxis::X,
            Along::Y => ShiftAxis::Y,
        };
        let steps = self.steps.as_deref().ok_or_else(|| missing("steps"))?;
        if steps.is_empty() {
            return Err(invalid("number of steps", 0.0, "1 or more"));
        }
        let end = |step: &ShiftStep| match (step.force, step.shift) {
            (Some(force), None) => finite("force", force).map(ShiftEnd::Force),
            (None, Some(shift)) => finite("shift", shift).map(ShiftEnd::Shift),
            (None, None) => {
                let keys = ["force", "shift"];
                Err(CaseError::MissingEither { section: "statics", keys })
            }
            (Some(_), Some(_)) => {
                let (first, second) = (("statics", "force"), ("statics", "shift"));
                Err(CaseError::Conflict { first, second })
            }
        };
        let one = |step| end(step).map(|end| (step.normal_force, end));
        Ok((axis, steps.iter().map(one).collect::<Result<_, _>>()?))
    }

    pub(crate) fn moment(&self) -> Result<f64, CaseError> {
        let missing = || CaseError::Missing { section: "statics".into(), key: "moment".into() };
        let moment = finite("moment", self.moment.ok_or_else(missing)?)?;
        if moment == 0.0 {
            return Err(invalid("moment", moment, "other than zero"));
        }
        Ok(moment)
    }
}

fn finite(key: &'static str, value: f64) -> Result<f64, CaseError> {
    if value.is_finite() { Ok(value) } else { Err(invalid(key, value, "a finite number")) }
}

/// An [`InvalidValue`] of `[statics]`.
fn invalid(quantity: &'static str, value: f64, valid: &'static str) -> CaseError {
    CaseError::invalid("statics")(InvalidValue { quantity, value, valid })
}
