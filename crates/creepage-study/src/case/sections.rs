//! Sections of a case file that say what touches and how it creeps: numbers, cheap to clone.

use creepage::{Contact, Hertz};

use super::body::Body;
use super::contact::ContactSection;
use super::creepage::CreepageSection;
use super::error::CaseError;
use super::layer::LayerSection;
use crate::heat::HeatSection;

/// Two bodies, what presses them together, and how they creep.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sections {
    pub(crate) upper: Body,
    pub(crate) lower: Body,
    pub(crate) contact: ContactSection,
    pub(crate) layer: Option<LayerSection>,
    pub(crate) creepage: CreepageSection,
    /// What friction by temperature depends on.
    pub(crate) heat: Option<HeatSection>,
}

/// Two bodies pressed together, with friction.
pub(crate) struct PressedBodies {
    pub(crate) hertz: Hertz,
    pub(crate) friction: f64,
    pub(crate) contact: Contact,
    /// Rolling velocity (m/s), where it is given.
    pub(crate) speed: Option<f64>,
}

impl Sections {
    /// The contact alone.
    pub(crate) fn hertz(&self) -> Result<Hertz, CaseError> {
        self.contact.hertz(&self.upper, &self.lower)
    }

    /// The contact as a theory of rolling needs it.
    pub(crate) fn touching(&self) -> Result<PressedBodies, CaseError> {
        self.touching_by(self.hertz()?)
    }

    /// The same where the pressure is known beforehand.
    pub(crate) fn touching_by(&self, hertz: Hertz) -> Result<PressedBodies, CaseError> {
        check_aligned(self.contact.angle, &hertz)?;
        let friction = self.contact.friction.as_ref().ok_or_else(|| CaseError::Missing {
            section: "contact".into(),
            key: "friction".into(),
        })?;
        let speed = self.creepage.speed()?;
        let heat = self.heat.map(|section| section.wanted(speed)).transpose()?;
        let contact = friction.contact(&hertz, speed, heat)?;
        let contact = match &self.layer {
            Some(layer) => contact.with_layer(layer.layer()?),
            None => contact,
        };
        Ok(PressedBodies { hertz, friction: friction.at_rest()?, contact, speed })
    }

    /// The smallest of the bodies' radii (m), its size, where one is given.
    pub(crate) fn smallest_radius(&self) -> Option<f64> {
        smallest_radius([&self.upper, &self.lower])
    }
}

impl Sections {
    /// By how much the slip varies across the contact over the square of the place (1/m2): the surfaces of
    /// conforming bodies, one of them hollow across, curve alike, and their rolling radii change with it
    /// (Heathcote 1921). `None` where they do not conform, radii are not given, or one body lies askew.
    pub(crate) fn slip_by_groove(&self) -> Option<f64> {
        let radii = [self.upper.radii("upper").ok()?, self.lower.radii("lower").ok()?];
        let straight = self.contact.angle.is_none_or(|angle| angle == 0.0);
        let [upper, lower] = radii.map(|radii| [radii.rolling.recip(), radii.lateral.recip()]);
        // The surface in which they meet lies halfway between both.
        let curvature = 0.5 * (upper[1] - lower[1]);
        let conform = upper[1] < 0.0 || lower[1] < 0.0;
        (straight && conform).then_some(0.5 * curvature.abs() * (upper[0] + lower[0]).abs())
    }
}

/// The smallest of the bodies' radii (m), where one is given.
pub(crate) fn smallest_radius(bodies: [&Body; 2]) -> Option<f64> {
    let radii = bodies.into_iter().filter_map(Body::smallest_radius);
    radii.reduce(f64::min).filter(|radius| radius.is_finite())
}

/// The axes of the ellipse must lie along and across the rolling direction.
pub(crate) fn check_aligned(angle: Option<f64>, contact: &Hertz) -> Result<(), CaseError> {
    // Rounding of an angle of 90 degrees, or of a circle's axes, is not a tilt.
    const TOLERANCE: f64 = 1e-9;
    let circular = 1.0 - contact.ellipse().g() < TOLERANCE;
    if circular || contact.angle().abs() < TOLERANCE {
        return Ok(());
    }
    Err(CaseError::Tilted {
        angle: angle.unwrap_or(0.0),
        ellipse_angle: contact.angle().to_degrees(),
    })
}
