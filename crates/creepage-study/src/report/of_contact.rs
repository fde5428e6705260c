//! Quantities of a contact that is pressed: Hertz's ellipse, and areas of any shape.

use creepage::normal::{Estimate, Method, NormalContact, Status};
use creepage::{Hertz, SolidPair};

use super::part::ReportPart;
use super::quantity::{Report, Shown};
use super::unit::Unit::{
    Metre, MetrePerNewtonTwoThirds, Newton, NewtonPerMetre, One, Pascal, PerMetre, Radian,
    SquareMetre,
};
use crate::Caution;

/// Hertz's ellipse alone as a report.
#[must_use]
pub fn hertz_report(contact: &Hertz, cautions: &[Caution]) -> Report {
    let mut report = Report::default();
    report.ellipse(contact, "");
    report.cautions(cautions);
    report
}

/// Bodies of any shape pressed together as a report, without rolling.
#[must_use]
pub fn pressed_report(contact: &NormalContact, cautions: &[Caution]) -> Report {
    let mut report = Report::default();
    report.areas(contact, "");
    report.cautions(cautions);
    report
}

/// The section of the equivalent solid inside that of the contact.
fn solid_in(section: &'static str) -> &'static str {
    if section.is_empty() { "solid" } else { "contact.solid" }
}

impl Report {
    /// Hertz's ellipse: closed forms, without error.
    pub(super) fn ellipse(&mut self, contact: &Hertz, section: &'static str) {
        let ellipse = contact.ellipse();
        let exactly = |value: f64| (value, Some(0.0));
        let area = std::f64::consts::PI * ellipse.a() * ellipse.b();
        let [along, across] = contact.relative_curvatures();
        let (a, b, ratio) = (ellipse.a(), ellipse.b(), ellipse.ratio());
        self.section(section, Shown::Contact)
            .estimate("normal_force", "normal force N", Newton, exactly(contact.normal_force()))
            .number("semi_axis_rolling", "semi-axis a, along rolling", Metre, a)
            .number("semi_axis_lateral", "semi-axis b, across", Metre, b)
            .number("a_over_b", "a/b", One, ratio)
            .estimate("peak_pressure", "peak pressure", Pascal, exactly(contact.peak_pressure()))
            .estimate("approach", "approach of the bodies", Metre, exactly(contact.approach()));
        self.section(section, Shown::Nowhere).estimate("area", "area", SquareMetre, exactly(area));
        self.stiffness(section, contact.stiffness());
        let constant = contact.approach_constant();
        let turned = if contact.angle() == 0.0 { Shown::Nowhere } else { Shown::Contact };
        self.section(section, Shown::Contact)
            .number("approach_constant", "approach over N^(2/3)", MetrePerNewtonTwoThirds, constant)
            .number("rho", "curvature length rho", Metre, contact.rho())
            .shown(turned)
            .number("angle", "angle of the axis a", Radian, contact.angle());
        self.section(section, Shown::ContactAlone)
            .number("relative_curvature_rolling", "relative curvature along", PerMetre, along)
            .number("relative_curvature_lateral", "relative curvature across", PerMetre, across);
        self.solid(section, contact.pair());
    }

    /// Areas of any shape; an error bar of zero stands by what was given.
    pub(super) fn areas(&mut self, contact: &NormalContact, section: &'static str) {
        let of = |Estimate { value, error }: Estimate| (value, Some(error));
        self.section(section, Shown::Contact)
            .estimate("normal_force", "normal force N", Newton, of(contact.load()))
            .estimate("approach", "approach of the bodies", Metre, of(contact.approach()))
            .estimate("peak_pressure", "peak pressure", Pascal, of(contact.peak_pressure()))
            .estimate("area", "area", SquareMetre, of(contact.area()));
        self.stiffness(section, contact.stiffness());
        let status = match contact.status() {
            Status::Converged => "converged",
            Status::NotConverged { .. } => "not_converged",
        };
        self.part(section, "method", method(contact).into());
        self.part(section, "status", status.into());
        self.part(section, "centroid_m", ReportPart::Numbers(Some(contact.centroid().to_vec())));
        let patches = contact.patches().iter().map(Into::into).collect();
        self.part(section, "patches", ReportPart::Patches(patches));
        self.solid(section, contact.pair());
    }

    fn stiffness(&mut self, section: &'static str, stiffness: f64) {
        self.section(section, Shown::Contact).number(
            "stiffness",
            "stiffness dN/d(approach)",
            NewtonPerMetre,
            stiffness,
        );
    }

    /// The solid that stands for both bodies (2.10).
    fn solid(&mut self, section: &'static str, pair: SolidPair) {
        self.section(solid_in(section), Shown::Nowhere)
            .number("shear_modulus", "combined shear modulus G", Pascal, pair.shear_modulus())
            .number("poisson", "combined Poisson's ratio sigma", One, pair.poisson())
            .number("kappa", "measure kappa of how unlike the bodies are", One, pair.kappa());
    }

    /// Cautions in words; else `null`.
    pub(super) fn cautions(&mut self, cautions: &[Caution]) {
        self.part("", "caution", ReportPart::Text(words(cautions)));
    }

    /// The report of a solution begins with the program's version, the theory, the status and cautions.
    pub(crate) fn solved(theory: &str, status: creepage::Status, caution: Option<String>) -> Self {
        let mut report = Self::default();
        report.part("", "creepage_version", env!("CARGO_PKG_VERSION").into());
        report.part("", "theory", theory.into());
        report.part("", "status", status.name().into());
        report.part("", "caution", ReportPart::Text(caution));
        report
    }
}

/// Cautions in words, where there are any.
pub(crate) fn words(cautions: &[Caution]) -> Option<String> {
    (!cautions.is_empty()).then(|| Caution::words(cautions))
}

/// How the pressure was found.
pub(crate) fn method(contact: &NormalContact) -> &'static str {
    match contact.method() {
        Method::Strips => "strips",
        Method::Elements => "elements",
    }
}
