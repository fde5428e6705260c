//! Construction of a rolling case from its file: every number is checked.

use std::path::Path;
use std::sync::Arc;

use creepage::approximate::carter::LineContact;
use creepage::coulomb::Resolution;
use creepage::normal::{self, NormalContact};
use creepage::theory::ExactOptions;
use creepage::{Contact, InvalidValue, Layer, Scaling, SolidPair, TheorySpec};

use super::case::{Kind, Method, RollCase, Start};
use super::error::HistoryError;
use super::file::{Bodies, RollFile, SmoothFile, StartSection, StartTraction};
use crate::case::contact::ContactSection;
use crate::case::layer::LayerSection;
use crate::case::radius::line_radii;
use crate::case::sections::{check_aligned, smallest_radius};
use crate::case::solve;
use crate::gap::{GapCase, pressed};
use crate::{CaseError, Caution, Sources};

impl RollFile {
    /// The files of points that it names, which stand in `directory`.
    #[must_use]
    pub fn sources(&self, directory: &Path) -> Sources {
        match &self.bodies {
            Bodies::Smooth(file) => {
                let slip = file.contact.slip.as_ref();
                Sources::new(slip.and_then(|slip| slip.file(directory)))
            }
            Bodies::Shaped(file) => file.sources(directory),
        }
    }

    /// The case, every number of it checked; files of points stand in `directory`.
    ///
    /// # Errors
    /// [`HistoryError`] for numbers out of range, contradictions, bodies without such a contact, and
    /// theories of steady rolling.
    pub fn case(&self, directory: &Path) -> Result<RollCase, HistoryError> {
        let case = match &self.bodies {
            Bodies::Smooth(file) => file.case(directory)?,
            Bodies::Shaped(file) => on_areas(&file.case_at_rest(directory)?)?,
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
    fn case(&self, directory: &Path) -> Result<RollCase, HistoryError> {
        let (spec, method) = self.method()?;
        match (self.contact.normal_force, self.contact.line_load) {
            (Some(_), Some(_)) => {
                let (first, second) = (("contact", "normal_force"), ("contact", "line_load"));
                Err(CaseError::Conflict { first, second }.into())
            }
            (None, None) => {
                let keys = ["normal_force", "line_load"];
                Err(CaseError::MissingEither { section: "contact", keys }.into())
            }
            (Some(force), None) => self.ellipse(force, (&spec, method), directory),
            (None, Some(_)) if matches!(method, Method::Fastsim(_)) => {
                Err(HistoryError::NotOfFastsim { what: "[contact] line_load" })
            }
            (None, Some(_)) if matches!(method, Method::Variational(_)) => {
                Err(HistoryError::NotOfVariational { what: "[contact] line_load" })
            }
            (None, Some(load)) => self.line(load),
        }
    }

    fn layer(&self) -> Result<Option<Layer>, CaseError> {
        self.layer.as_ref().map(LayerSection::layer).transpose()
    }

    fn method(&self) -> Result<(TheorySpec, Method), HistoryError> {
        let spec = solve::from_table(&self.solve).map_err(CaseError::Spec)?;
        let method = match &spec {
            TheorySpec::Exact(options) => Method::Exact(resolution(options)?),
            TheorySpec::Fastsim(settings) => Method::Fastsim(*settings),
            TheorySpec::Variational(options) => Method::Variational(options.settings()),
            _ => return Err(HistoryError::Theory { theory: spec.facts().name }),
        };
        Ok((spec, method))
    }

    fn ellipse(
        &self,
        normal_force: f64,
        (spec, method): (&TheorySpec, Method),
        directory: &Path,
    ) -> Result<RollCase, HistoryError> {
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
            slip: None,
        };
        let hertz = section.hertz(&self.upper, &self.lower)?;
        check_aligned(own.angle, &hertz)?;
        let contact = own.friction.contact(&hertz, self.creepage.speed, None)?;
        let contact = match self.layer()? {
            None => contact,
            Some(_) if matches!(method, Method::Fastsim(_)) => {
                return Err(HistoryError::NotOfFastsim { what: "section [layer]" });
            }
            Some(_) if matches!(method, Method::Variational(_)) => {
                return Err(HistoryError::NotOfVariational { what: "section [layer]" });
            }
            Some(layer) => contact.with_layer(layer),
        };
        let contact = match (&own.slip, method) {
            (None, _) => contact,
            (Some(slip), Method::Exact(_)) => contact.with_added_slip(slip.read(directory, [])?),
            (Some(_), Method::Fastsim(_)) => {
                return Err(HistoryError::NotOfFastsim { what: "[contact] slip" });
            }
            (Some(_), Method::Variational(_)) => {
                return Err(HistoryError::NotOfVariational { what: "[contact] slip" });
            }
        };
        if matches!(method, Method::Variational(_)) && contact.rolling_friction().is_some() {
            return Err(HistoryError::NotOfVariational { what: "[contact] friction with a law" });
        }
        let friction = own.friction.at_rest()?;
        let mut cautions = Caution::neglected(spec, &contact);
        let smallest = smallest_radius([&self.upper, &self.lower]);
        cautions.extend(Caution::of_hertz(&hertz, smallest));
        let (scaling, kind) = (contact.scaling(), Kind::Ellipse { contact, method });
        let stresses = [hertz.peak_pressure(), hertz.pair().shear_modulus()];
        let (load, start) = (normal_force, Start::None);
        Ok(RollCase { scaling, load, friction, cautions, stresses, kind, start })
    }

    fn line(&self, load: f64) -> Result<RollCase, HistoryError> {
        let (own, invalid) = (&self.contact, CaseError::invalid("contact"));
        let only_of_ellipses = [
            ("angle", own.angle.is_some()),
            ("semi_axis_rolling", own.semi_axis_rolling.is_some()),
            ("semi_axis_lateral", own.semi_axis_lateral.is_some()),
            ("slip", own.slip.is_some()),
        ];
        if let Some((key, _)) = only_of_ellipses.into_iter().find(|(_, given)| *given) {
            let why = "goes with normal_force alone";
            return Err(HistoryError::Foreign { section: "contact", key, why });
        }
        let pair = SolidPair::new(self.upper.solid("upper")?, self.lower.solid("lower")?);
        let (friction, law) =
            (own.friction.at_rest()?, own.friction.rolling(self.creepage.speed, None)?);
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
        let radii = line_radii([&self.upper, &self.lower], own.radius_rolling)?;
        let line = LineContact::new(pair, radii, load).map_err(&invalid)?;
        let length = own.length.map(|length| length / line.half_width());
        if let Some(value) =
            own.length.filter(|_| length.is_some_and(|n| !(10.0..=1e6).contains(&n)))
        {
            let valid = "10 to 1e6 half-widths of the contact, as a line";
            return Err(invalid(InvalidValue { quantity: "length", value, valid }).into());
        }
        let poisson = pair.poisson();
        let scaling = Scaling {
            length: line.half_width(),
            slip: friction * line.half_width() / line.rho(),
            force: friction * load,
            traction: friction * line.peak_pressure(),
        };
        let layer = self.layer()?;
        let smallest = smallest_radius([&self.upper, &self.lower]).unwrap_or(0.25 * line.rho());
        let stresses = [line.peak_pressure(), pair.shear_modulus()];
        let mut cautions = Caution::line_units([line.half_width(), smallest], stresses);
        if cautions.is_empty() {
            cautions.extend(Caution::yields(stresses[0], stresses[1], None));
        }
        cautions.extend(Caution::like_bodies(pair.kappa() / friction));
        cautions.extend(layer.and_then(|layer| Caution::thick_beside(layer, line.half_width())));
        let kind = Kind::Line { length, poisson, friction: law, layer };
        Ok(RollCase { scaling, load, friction, cautions, stresses, kind, start: Start::None })
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

/// The case of a history from the one of steady rolling.
fn on_areas(case: &GapCase) -> Result<RollCase, HistoryError> {
    let options = match &case.theory {
        TheorySpec::Exact(options) => *options,
        TheorySpec::Fastsim(_) => return Err(HistoryError::NotOfFastsim { what: "[gap]" }),
        TheorySpec::Variational(_) => return Err(HistoryError::NotOfVariational { what: "[gap]" }),
        other => return Err(HistoryError::Theory { theory: other.facts().name }),
    };
    options.resolutions().map_err(CaseError::invalid("solve"))?;
    let resolution = resolution(&options)?;
    let fineness = match resolution {
        Resolution::FAST => normal::Resolution::FAST,
        _ => normal::Resolution::FINE,
    };
    let contact = pressed(case, fineness)?;
    let scaling = contact.scaling(case.friction).map_err(CaseError::invalid("contact"))?;
    let load = contact.load().value;
    let (friction, layer) = (case.rolling_friction, case.layer);
    let cautions = of_areas(case, &contact)?;
    let slip = case.slip.clone();
    let stresses = [contact.peak_pressure().value, contact.pair().shear_modulus()];
    let (friction_at_rest, start) = (case.friction, Start::None);
    let kind = Kind::Areas { contact, resolution, friction, layer, slip };
    Ok(RollCase { scaling, load, friction: friction_at_rest, cautions, stresses, kind, start })
}

/// What areas of any shape are in doubt for, whatever they do.
fn of_areas(case: &GapCase, areas: &NormalContact) -> Result<Vec<Caution>, HistoryError> {
    let contact = Contact::of_areas(Arc::new(areas.clone()), case.friction);
    let contact = contact.map_err(CaseError::invalid("contact"))?;
    let contact = match case.layer {
        Some(layer) => contact.with_layer(layer),
        None => contact,
    };
    let contact = match &case.slip {
        Some(slip) => contact.with_added_slip(Arc::clone(slip)),
        None => contact,
    };
    let mut cautions = Caution::neglected(&case.theory, &contact);
    cautions.extend(Caution::of_areas(areas).chain(Caution::large_areas(&case.gap, areas)));
    if !cautions.iter().any(Caution::is_of_units) {
        let (peak, modulus) = (areas.peak_pressure().value, areas.pair().shear_modulus());
        cautions.extend(Caution::yields(peak, modulus, None));
    }
    Ok(cautions)
}

/// The resolution of the full theory, which a history keeps.
fn resolution(options: &ExactOptions) -> Result<Resolution, HistoryError> {
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
    if options.coupled {
        let valid = "false where bodies roll unsteadily: their pressure is that without friction";
        let invalid = InvalidValue { quantity: "coupled", value: 1.0, valid };
        return Err(CaseError::invalid("solve")(invalid).into());
    }
    let resolution = options.fixed_resolution().map_err(invalid)?;
    resolution.ok_or(HistoryError::Automatic)
}
