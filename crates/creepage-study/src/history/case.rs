//! Case of a contact that rolls by a history.

use std::sync::Arc;

use creepage::approximate::fastsim::Settings;
use creepage::coulomb::Resolution;
use creepage::friction_law::RollingFriction;
use creepage::normal::NormalContact;
use creepage::unsteady::{Prescribed, Rolled, Rolling, RollingFastsim, RollingVariational};
use creepage::variational::{self, VariationalError};
use creepage::{AddedSlip, Contact, Force, InvalidValue, Layer, Scaling, SiCreepage};

use super::error::HistoryError;
use super::roller::{HistoryMotion, TransientSolver};
use crate::Caution;

/// A contact that rolls by a history.
#[derive(Debug, Clone, PartialEq)]
pub struct RollCase {
    /// The units of its nominal load.
    pub scaling: Scaling,
    /// Normal force (N), or load of the line (N/m).
    pub load: f64,
    /// Coefficient of friction, the largest.
    pub friction: f64,
    /// What its contact is in doubt for, whatever it does.
    pub cautions: Vec<Caution>,
    /// Peak pressure at that load, and the combined shear modulus (Pa).
    pub(super) stresses: [f64; 2],
    pub(super) kind: Kind,
    pub(super) start: Start,
}

impl RollCase {
    /// What the pressure under `load`, over the nominal one and larger, is in doubt for: it grows as the cube root on an
    /// ellipse; a line's and an area's load is not varied.
    #[must_use]
    pub fn caution_of_load(&self, load: f64) -> Option<Caution> {
        let [peak, modulus] = self.stresses;
        let peak = peak * load.cbrt();
        let is_heavy = load > 1.0 && matches!(self.kind, Kind::Ellipse { .. });
        let high = || Caution::moduli(peak, modulus).next();
        is_heavy.then(|| high().or_else(|| Caution::yields(peak, modulus, None))).flatten()
    }

    /// What a motion is in doubt for that no rolling body has: it may be in per cent or in degrees.
    #[must_use]
    pub fn caution_of_motion(&self, creepage: SiCreepage) -> Option<Caution> {
        let spin = match &self.kind {
            Kind::Ellipse { contact, .. } => {
                let ellipse = contact.ellipse();
                let half = self.scaling.length * ellipse.major() / ellipse.c();
                Caution::large_spin(creepage.spin, half)
            }
            Kind::Line { .. } => None,
            Kind::Areas { contact, .. } => Caution::large_spin_of_areas(creepage.spin, contact),
        };
        Caution::large_creepage(creepage).chain(spin).next()
    }
}

#[allow(clippy::large_enum_variant)] // one a case
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Kind {
    Ellipse {
        contact: Contact,
        method: Method,
    },
    /// Length over the half-width, where it is given.
    Line {
        length: Option<f64>,
        poisson: f64,
        friction: Option<RollingFriction>,
        layer: Option<Layer>,
    },
    /// Of any shape.
    Areas {
        contact: NormalContact,
        resolution: Resolution,
        friction: Option<RollingFriction>,
        layer: Option<Layer>,
        slip: Option<Arc<AddedSlip>>,
    },
}

/// Theory of transient rolling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Method {
    Exact(Resolution),
    Fastsim(Settings),
    Variational(variational::Settings),
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Start {
    None,
    Steady,
    /// Forces over `mu N`.
    Shift([f64; 2]),
}

/// Of a line whose length does not matter.
const LONG: f64 = 1000.0;

impl RollCase {
    /// Whether friction falls with the slip at once, which the full theory does not roll with.
    pub(super) fn lacks_memory(&self) -> bool {
        let friction = match &self.kind {
            Kind::Ellipse { contact, method: Method::Exact(_) } => contact.rolling_friction(),
            Kind::Ellipse { .. } => None,
            Kind::Line { friction, .. } | Kind::Areas { friction, .. } => *friction,
        };
        friction.is_some_and(|friction| friction.falls() && friction.memory().is_none())
    }

    /// Takes a contact just pressed together to its starting state; `first` is the motion of steady
    /// rolling if that is it. Gives the force in that state, dimensionless.
    pub(super) fn start(
        &self,
        rolling: &mut TransientSolver,
        first: &HistoryMotion,
    ) -> Result<Force, InvalidValue> {
        match self.start {
            Start::None => rolling.start_with_load(first.load).map(|()| Force::default()),
            Start::Steady => rolling.start_steady(first),
            Start::Shift(force) => rolling.shift(force),
        }
    }

    /// The contact just pressed together.
    pub(super) fn prepared(&self) -> Result<TransientSolver, HistoryError> {
        self.solver().map_err(|error| match error {
            VariationalError::Invalid(invalid) => HistoryError::Contact(invalid),
            other => HistoryError::Variational(other),
        })
    }

    fn solver(&self) -> Result<TransientSolver, VariationalError> {
        Ok(match &self.kind {
            Kind::Ellipse { contact, method: Method::Exact(resolution) } => {
                TransientSolver::Exact(Rolling::new(contact, *resolution)?)
            }
            Kind::Ellipse { contact, method: Method::Fastsim(settings) } => {
                TransientSolver::Fastsim(RollingFastsim::new(contact, *settings)?)
            }
            Kind::Ellipse { contact, method: Method::Variational(settings) } => {
                TransientSolver::Variational(RollingVariational::new(contact, *settings)?)
            }
            Kind::Line { length, poisson, friction, layer } => {
                let (length, surface) = (length.unwrap_or(LONG), (*friction, *layer));
                let rolling = Rolling::line_with_surface(length, *poisson, surface, self.scaling)?;
                TransientSolver::Exact(rolling)
            }
            Kind::Areas { contact, resolution, friction: law, layer, slip } => {
                let (friction, resolution) = (self.friction, *resolution);
                let rolling = match layer {
                    None => Rolling::on_areas(contact, friction, *law, resolution)?,
                    Some(layer) => {
                        let surface = (*law, *layer);
                        Rolling::on_areas_with_layer(contact, friction, surface, resolution)?
                    }
                };
                TransientSolver::Exact(match slip {
                    Some(slip) => rolling.with_added_slip(slip, self.scaling),
                    None => rolling,
                })
            }
        })
    }

    /// Rolls on by a length (m).
    pub(super) fn roll(
        &self,
        rolling: &mut TransientSolver,
        length: f64,
        motion: &HistoryMotion,
    ) -> Result<Rolled, InvalidValue> {
        rolling.step(length / self.scaling.length, motion)
    }

    /// Whether it rolls by FASTSIM.
    pub(super) fn is_fastsim(&self) -> bool {
        matches!(self.kind, Kind::Ellipse { method: Method::Fastsim(_), .. })
    }

    /// Whether it rolls by chapter 5.
    pub(super) fn is_variational(&self) -> bool {
        matches!(self.kind, Kind::Ellipse { method: Method::Variational(_), .. })
    }

    /// The largest moment that friction gives on an ellipse, over `mu N c`.
    pub(super) fn largest_moment(&self) -> Option<f64> {
        let Kind::Ellipse { contact, .. } = &self.kind else { return None };
        Some(contact.ellipse().friction_arm() / contact.ellipse().c())
    }

    /// Whether its areas are of any shape.
    pub(super) fn has_areas(&self) -> bool {
        matches!(self.kind, Kind::Areas { .. })
    }

    /// Whether there is a layer between the bodies.
    pub(super) fn has_layer(&self) -> bool {
        match &self.kind {
            Kind::Ellipse { contact, .. } => contact.layer().is_some(),
            Kind::Line { layer, .. } | Kind::Areas { layer, .. } => layer.is_some(),
        }
    }

    /// Whether it is a line contact.
    #[must_use]
    pub fn is_line(&self) -> bool {
        matches!(self.kind, Kind::Line { .. })
    }

    /// Whether it is a line contact without a length.
    pub(super) fn lacks_length(&self) -> bool {
        matches!(self.kind, Kind::Line { length: None, .. })
    }
}

/// A force in SI units over its unit.
pub(super) fn over(prescribed: Prescribed, unit: f64) -> Prescribed {
    match prescribed {
        Prescribed::Creepage(value) => Prescribed::Creepage(value / unit),
        Prescribed::Force(value) => Prescribed::Force(value / unit),
    }
}
