//! Case of two bodies of any shape, every number of it checked.

use std::sync::Arc;

use creepage::curved::CurvedGap;
use creepage::friction_law::RollingFriction;
use creepage::gap::Gap;
use creepage::{AddedSlip, Layer, SiCreepage, Solid, SolidPair, TheorySpec};

use super::along::Roller;
use super::creepage::SiGiven;
use super::error::GapCaseError;
use crate::case::solve;
use crate::damage::DamageWanted;
use crate::heat::HeatWanted;
use crate::{CaseError, Sources};

/// Normal constraint of a contact: its load or its approach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LoadOrApproach {
    /// A normal force (N).
    Load(f64),
    /// An approach (m).
    Approach(f64),
}

/// One case of bodies of any shape, every number of it checked.
#[derive(Debug, Clone)]
pub struct GapCase {
    /// The undeformed distance.
    pub gap: Gap,
    /// The same along a curve across, where the contact is solved there.
    pub curved: Option<Box<CurvedGap>>,
    /// The key that gave it, with its file.
    pub shape: String,
    /// The roller that gave it, where one did.
    pub roller: Option<Roller>,
    /// The file that gave it, where there is one.
    pub sources: Sources,
    /// The equivalent solid of both bodies.
    pub pair: SolidPair,
    /// Load or approach.
    pub pressed: LoadOrApproach,
    /// Coefficient of friction `mu`, at rest where it depends on the slip.
    pub friction: f64,
    /// How friction varies, where it is not constant.
    pub rolling_friction: Option<RollingFriction>,
    /// The layer between the bodies.
    pub layer: Option<Layer>,
    /// Rigid slip beside creepage and spin, where it differs from place to place.
    pub slip: Option<Arc<AddedSlip>>,
    /// What is wanted of wear and fatigue, if anything is.
    pub damage: Option<DamageWanted>,
    /// What is wanted of temperatures, if anything is.
    pub heat: Option<HeatWanted>,
    /// Creepages and wanted forces.
    pub given: SiGiven,
    /// Rolling velocity (m/s), where it is known.
    pub speed: Option<f64>,
    /// The materials of the upper and the lower body.
    pub solids: [Solid; 2],
    /// The theory of rolling and its options.
    pub theory: TheorySpec,
}

impl GapCase {
    /// The same case by the theory of another name, with its default options.
    ///
    /// # Errors
    /// [`GapCaseError`] for a name that is unknown, or of a theory that needs an ellipse.
    pub fn by_theory(self, name: &str) -> Result<Self, GapCaseError> {
        let spec = TheorySpec::named(name).map_err(|unknown| {
            GapCaseError::Case(CaseError::from(solve::SpecError::from(unknown)))
        })?;
        self.by_spec(&spec)
    }

    /// The same case with the undeformed distance at the points `[x, y, gap]` (m) of a rectangular grid,
    /// in any order.
    ///
    /// # Errors
    /// [`GapCaseError::Gap`] for points that are no grid.
    pub fn with_grid(self, points: &[[f64; 3]]) -> Result<Self, GapCaseError> {
        let shape = "grid".to_owned();
        let wrong = |source| GapCaseError::Gap { shape: shape.clone(), source };
        Ok(Self {
            gap: Gap::grid(points).map_err(wrong)?,
            curved: None,
            shape,
            roller: None,
            sources: Sources::default(),
            ..self
        })
    }

    /// The same case at this creepage, with no forces wanted.
    ///
    /// # Errors
    /// [`GapCaseError`] for numbers that are not finite.
    pub fn at(self, creepage: SiCreepage) -> Result<Self, GapCaseError> {
        Ok(Self { given: SiGiven::at(creepage)?, ..self })
    }

    /// The same case by another theory.
    ///
    /// # Errors
    /// [`GapCaseError`] for a theory or an option that needs an ellipse.
    pub fn by_spec(self, spec: &TheorySpec) -> Result<Self, GapCaseError> {
        spec.check_on_areas()?;
        Ok(Self { theory: spec.clone(), ..self })
    }
}
