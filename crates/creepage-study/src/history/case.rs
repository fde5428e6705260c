//! A contact that rolls, every number of it checked.

use std::path::Path;

use creepage::approximate::carter::LineContact;
use creepage::approximate::fastsim::Settings;
use creepage::coulomb::Resolution;
use creepage::friction_law::RollingFriction;
use creepage::normal::NormalContact;
use creepage::theory::ExactOptions;
use creepage::unsteady::{Motion, Prescribed, Rolled, Rolling, RollingFastsim};
use creepage::{Contact, InvalidValue, Scaling, SolidPair, TheorySpec};

use super::areas;
use super::error::HistoryError;
use super::file::{Bodies, RollFile, SmoothFile, StartSection, StartTraction};
use super::roller::Roller;
use crate::CaseError;
use crate::case::contact::ContactSection;
use crate::case::sections::check_aligned;
use crate::case::solve;

/// A contact that rolls by a history.
#[derive(Debug, Clone, PartialEq)]
pub struct RollCase {
    /// The units of its nominal load.
    pub scaling: Scaling,
    /// Normal force (N), or load of the line (N/m).
    pub load: f64,
    /// Coefficient of friction, the largest.
    pub friction: f64,
    pub(super) kind: Kind,
    pub(super) start: Start,
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
    },
    /// Of any shape.
    Areas {
        contact: NormalContact,
        resolution: Resolution,
        friction: Option<RollingFriction>,
    },
}

/// By which theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Method {
    Exact(Resolution),
    Fastsim(Settings),
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Start {
    None,
    Steady,
    /// Forces over `mu N`.
    Shift([f64; 2]),
}

/// How the bodies move up to some distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HistoryMotion {
    /// Dimensionless in the units of the nominal load.
    pub motion: Motion,
    /// Normal force over the nominal one.
    pub load: f64,
}

/// Of a line whose length does not matter.
const LONG: f64 = 1000.0;

impl RollFile {
    /// The case, every number of it checked; files of points stand in `directory`.
    ///
    /// # Errors
    /// [`HistoryError`] for numbers out of range, contradictions, bodies without such a contact, and
    /// theories of steady rolling.
    pub fn case(&self, directory: &Path) -> Result<RollCase, HistoryError> {
        let case = match &self.bodies {
            Bodies::Smooth(file) => file.case()?,
            Bodies::Shaped(file) => areas::case(&file.case_at_rest(directory)?)?,
        };
        if case.lacks_memory() {
            return Err(HistoryError::NoMemory);
        }
        let start = self.start.checked(case.scaling.force)?;
        if case.is_fastsim() && matches!(start, Start::Shift(_)) {
            return Err(HistoryError::NotOfFastsim { what: "[start] traction = \"shift\"" });
        }
        Ok(RollCase { start, ..case })
    }
}

impl SmoothFile {
    fn case(&self) -> Result<RollCase, HistoryError> {
        let method = self.method()?;
        match (self.contact.normal_force, self.contact.line_load) {
            (Some(_), Some(_)) => {
                let (first, second) = (("contact", "normal_force"), ("contact", "line_load"));
                Err(CaseError::Conflict { first, second }.into())
            }
            (None, None) => {
                let keys = ["normal_force", "line_load"];
                Err(CaseError::MissingEither { section: "contact", keys }.into())
            }
            (Some(force), None) => self.ellipse(force, method),
            (None, Some(_)) if matches!(method, Method::Fastsim(_)) => {
                Err(HistoryError::NotOfFastsim { what: "[contact] line_load" })
            }
            (None, Some(load)) => self.line(load),
        }
    }

    fn method(&self) -> Result<Method, HistoryError> {
        let spec = solve::from_table(&self.solve).map_err(CaseError::Spec)?;
        match &spec {
            TheorySpec::Exact(options) => resolution(options).map(Method::Exact),
            TheorySpec::Fastsim(settings) => Ok(Method::Fastsim(*settings)),
            _ => Err(HistoryError::Theory { theory: spec.facts().name }),
        }
    }

    fn ellipse(&self, normal_force: f64, method: Method) -> Result<RollCase, HistoryError> {
        let own = &self.contact;
        let only_of_lines =
            [("length", own.length.is_some()), ("radius_rolling", own.radius_rolling.is_some())];
        if let Some((key, _)) = only_of_lines.into_iter().find(|(_, given)| *given) {
            let why = "goes with line_load alone";
            return Err(HistoryError::Foreign { section: "contact", key, why });
        }
        let section = ContactSection {
            normal_force,
            friction: None,
            angle: own.angle,
            semi_axis_rolling: own.semi_axis_rolling,
            semi_axis_lateral: own.semi_axis_lateral,
        };
        let hertz = section.hertz(&self.upper, &self.lower)?;
        check_aligned(own.angle, &hertz)?;
        let contact = own.friction.contact(&hertz, self.creepage.speed)?;
        let friction = own.friction.at_rest()?;
        let (scaling, kind) = (contact.scaling(), Kind::Ellipse { contact, method });
        Ok(RollCase { scaling, load: normal_force, friction, kind, start: Start::None })
    }

    fn line(&self, load: f64) -> Result<RollCase, HistoryError> {
        let (own, invalid) = (&self.contact, CaseError::invalid("contact"));
        let only_of_ellipses = [
            ("angle", own.angle.is_some()),
            ("semi_axis_rolling", own.semi_axis_rolling.is_some()),
            ("semi_axis_lateral", own.semi_axis_lateral.is_some()),
        ];
        if let Some((key, _)) = only_of_ellipses.into_iter().find(|(_, given)| *given) {
            let why = "goes with normal_force alone";
            return Err(HistoryError::Foreign { section: "contact", key, why });
        }
        let pair = SolidPair::new(self.upper.solid("upper")?, self.lower.solid("lower")?);
        let (friction, law) = (own.friction.at_rest()?, own.friction.rolling(self.creepage.speed)?);
        if law.is_some_and(|law| law.by_place().is_some()) {
            let why = "across a line does not differ";
            return Err(HistoryError::Foreign { section: "contact", key: "friction", why });
        }
        if !(friction.is_finite() && friction > 0.0) {
            let valid = "finite and greater than zero";
            return Err(
                invalid(InvalidValue { quantity: "friction", value: friction, valid }).into()
            );
        }
        let line = LineContact::new(pair, self.radii()?, load).map_err(&invalid)?;
        let length = own.length.map(|length| length / line.half_width());
        let poisson = pair.poisson();
        let scaling = Scaling {
            length: line.half_width(),
            slip: friction * line.half_width() / line.rho(),
            force: friction * load,
            traction: friction * line.peak_pressure(),
        };
        let kind = Kind::Line { length, poisson, friction: law };
        Ok(RollCase { scaling, load, friction, kind, start: Start::None })
    }

    /// Radii along the rolling direction, those of the bodies or the one of both.
    fn radii(&self) -> Result<[f64; 2], CaseError> {
        let metres = |section: &'static str, radius: crate::case::radius::Radius| {
            radius.metres().map_err(|value| {
                let valid = crate::case::radius::Radius::VALID;
                CaseError::Radius { section, key: "radius_rolling", value, valid }
            })
        };
        if let Some(radius) = self.contact.radius_rolling {
            let bodies = [("upper", &self.upper), ("lower", &self.lower)];
            let other = bodies.into_iter().find(|(_, body)| body.radius_rolling.is_some());
            if let Some((section, _)) = other {
                let (first, key) = (("contact", "radius_rolling"), "radius_rolling");
                return Err(CaseError::Conflict { first, second: (section, key) });
            }
            return Ok([metres("contact", radius)?, f64::INFINITY]);
        }
        let of = |section: &'static str, radius: Option<crate::case::radius::Radius>| {
            let missing =
                || CaseError::Missing { section: section.into(), key: "radius_rolling".into() };
            metres(section, radius.ok_or_else(missing)?)
        };
        Ok([of("upper", self.upper.radius_rolling)?, of("lower", self.lower.radius_rolling)?])
    }
}

impl StartSection {
    /// Its forces over the friction force `most` (N).
    fn checked(&self, most: f64) -> Result<Start, HistoryError> {
        let given = [
            ("longitudinal_force", self.longitudinal_force),
            ("lateral_force", self.lateral_force),
        ];
        if self.traction == StartTraction::Shift {
            let force = given.map(|(_, value)| value.unwrap_or(0.0));
            let size = force[0].hypot(force[1]);
            // Written so that a force that is no number is refused too.
            if size < most {
                return Ok(Start::Shift(force.map(|force| force / most)));
            }
            return Err(HistoryError::Start { force: size, most });
        }
        if let Some((key, _)) = given.into_iter().find(|(_, value)| value.is_some()) {
            let why = "goes with traction = \"shift\"";
            return Err(HistoryError::Foreign { section: "start", key, why });
        }
        Ok(if self.traction == StartTraction::Steady { Start::Steady } else { Start::None })
    }
}

/// The resolution of the full theory, which a history keeps.
pub(super) fn resolution(options: &ExactOptions) -> Result<Resolution, HistoryError> {
    let invalid = |error| match error {
        creepage::theory::TheoryError::Invalid(invalid) => CaseError::invalid("solve")(invalid),
        _ => CaseError::Invalid {
            section: "solve",
            invalid: InvalidValue {
                quantity: "accuracy",
                value: options.accuracy.unwrap_or(f64::NAN),
                valid: "left out with a fixed resolution",
            },
        },
    };
    let resolution = options.fixed_resolution().map_err(invalid)?;
    resolution.ok_or(HistoryError::Automatic)
}

impl RollCase {
    /// Whether friction falls with the slip at once, which the full theory does not roll with.
    fn lacks_memory(&self) -> bool {
        let friction = match &self.kind {
            Kind::Ellipse { contact, method: Method::Exact(_) } => contact.rolling_friction(),
            Kind::Ellipse { .. } => None,
            Kind::Line { friction, .. } | Kind::Areas { friction, .. } => *friction,
        };
        friction.is_some_and(|friction| friction.falls() && friction.memory().is_none())
    }

    /// Takes a contact just pressed together to its starting state; `first` is the motion of steady
    /// rolling if that is it.
    pub(super) fn start(
        &self,
        rolling: &mut Roller,
        first: &HistoryMotion,
    ) -> Result<(), InvalidValue> {
        match self.start {
            Start::None => rolling.start_with_load(first.load),
            Start::Steady => rolling.start_steady(first),
            Start::Shift(force) => rolling.shift(force),
        }
    }

    /// The contact just pressed together.
    pub(super) fn prepared(&self) -> Result<Roller, InvalidValue> {
        Ok(match &self.kind {
            Kind::Ellipse { contact, method: Method::Exact(resolution) } => {
                Roller::Exact(Rolling::new(contact, *resolution)?)
            }
            Kind::Ellipse { contact, method: Method::Fastsim(settings) } => {
                Roller::Fastsim(RollingFastsim::new(contact, *settings)?)
            }
            Kind::Line { length, poisson, friction } => {
                let length = length.unwrap_or(LONG);
                Roller::Exact(match friction {
                    None => Rolling::line(length, *poisson)?,
                    Some(law) => Rolling::line_with_friction(length, *poisson, *law, self.scaling)?,
                })
            }
            Kind::Areas { contact, resolution, friction } => {
                Roller::Exact(Rolling::on_areas(contact, self.friction, *friction, *resolution)?)
            }
        })
    }

    /// Rolls on by a length (m).
    pub(super) fn roll(
        &self,
        rolling: &mut Roller,
        length: f64,
        motion: &HistoryMotion,
    ) -> Result<Rolled, InvalidValue> {
        rolling.step(length / self.scaling.length, motion)
    }

    /// Whether it rolls by FASTSIM.
    pub(super) fn is_fastsim(&self) -> bool {
        matches!(self.kind, Kind::Ellipse { method: Method::Fastsim(_), .. })
    }

    /// Whether its areas are of any shape.
    pub(super) fn has_areas(&self) -> bool {
        matches!(self.kind, Kind::Areas { .. })
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
