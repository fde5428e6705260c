//! Quantities of a solved case, whatever touches.

use creepage::SiForce;
use creepage::coulomb::Constraints;

use super::of_contact::words;
use super::part::{DetailJson, ReportPart};
use super::quantity::{Report, Shown};
use super::unit::Unit::{
    self, JoulePerMetre, MetrePerSecond, Newton, NewtonMetre, One, RadianPerMetre, Share,
    SquareMetre, Watt,
};
use crate::SolvedCase;
use crate::gap::OnAreas;

/// Name, unit, and words for the lower and for the upper body, of the parts of a tangential force.
const FORCE: [(&str, Unit, [&str; 2]); 3] = [
    (
        "longitudinal",
        Newton,
        ["longitudinal force on the lower body", "longitudinal force on the upper body"],
    ),
    ("lateral", Newton, ["lateral force on the lower body", "lateral force on the upper body"]),
    ("moment", NewtonMetre, ["moment on the lower body", "moment on the upper body"]),
];

impl SolvedCase {
    /// All that is known of it but the points; ready for `serde_json`.
    #[must_use]
    pub fn report(&self) -> Report {
        let status = self.solution().status;
        let mut report = Report::solved(self.theory.name, status, words(&self.cautions));
        self.add_numbers(&mut report);
        report.part("", "known", ReportPart::Names(self.known()));
        let law = self.contact.rolling_friction().map(Into::into);
        report.part("", "friction_law", ReportPart::Friction(law));
        // Tractions of a solved case are finite.
        report.part("", "damage", ReportPart::Damage(self.damage().ok().flatten().cloned()));
        report.part("", "heat", ReportPart::Heat(self.heat().cloned()));
        if self.areas().is_some() {
            report.part("", "curved", ReportPart::Curved(self.curved));
        }
        let details = self.diagnostics().into_iter();
        let details =
            details.map(|one| (one.key, DetailJson { label: one.label, value: one.value }));
        report.part("", "details", ReportPart::Details(details.collect()));
        report
    }

    /// Its numbers alone, for many cases in rows: without what only a report needs, such as wear and the shakedown limit.
    #[must_use]
    pub fn numbers(&self) -> Report {
        let mut report = Report::default();
        self.add_numbers(&mut report);
        report
    }

    fn add_numbers(&self, report: &mut Report) {
        match (self.areas(), self.case.hertz()) {
            (Some(areas), _) => report.areas(areas, "contact"),
            (None, Some(hertz)) => report.ellipse(hertz, "contact"),
            (None, None) => {}
        }
        let friction = self.case.friction();
        report.section("", Shown::Nowhere).number("friction", "friction mu", One, friction);
        report.creepage(self);
        report.forces(self);
        report.friction(self);
    }

    /// Names of the three quantities that were given, where the creepage was to be found.
    #[must_use]
    pub fn known(&self) -> Option<Vec<&'static str>> {
        if let Some(on_areas) = OnAreas::of(self) {
            return on_areas.known();
        }
        let Constraints { xi, eta, chi, fx, fy, mz } = self.constraints()?;
        let values = [("xi", xi), ("eta", eta), ("chi", chi), ("fx", fx), ("fy", fy), ("mz", mz)];
        Some(values.into_iter().filter_map(|(name, value)| value.map(|_| name)).collect())
    }
}

impl Report {
    /// Of the upper body relative to the lower.
    fn creepage(&mut self, solved: &SolvedCase) {
        let creepage = solved.creepage();
        let si = solved.scaling().si_creepage(creepage);
        let [xi, eta, chi] = creepage.components();
        self.section("creepage", Shown::Nowhere)
            .number("longitudinal", "longitudinal creepage", One, si.longitudinal)
            .number("lateral", "lateral creepage", One, si.lateral)
            .number("spin", "spin", RadianPerMetre, si.spin)
            .number("xi", "longitudinal creepage xi", One, xi)
            .number("eta", "lateral creepage eta", One, eta)
            .number("chi", "spin chi", One, chi);
    }

    /// On both bodies, with error bars where the theory has them, and in parts of what friction can bear.
    fn forces(&mut self, solved: &SolvedCase) {
        let parts = |force: SiForce| [force.longitudinal, force.lateral, force.moment];
        let (force, error) = (solved.force(), solved.force_error().map(parts));
        for (k, ((name, unit, [label, _]), value)) in
            FORCE.into_iter().zip(parts(force)).enumerate()
        {
            let estimate = (value, error.map(|error| error[k]));
            self.section("lower_body", Shown::Nowhere).estimate(name, label, unit, estimate);
        }
        for ((name, unit, [_, label]), value) in FORCE.into_iter().zip(parts(-force)) {
            self.section("upper_body", Shown::Nowhere).number(name, label, unit, value);
        }
        let force = solved.solution().force;
        self.section("dimensionless", Shown::Nowhere)
            .number("fx", "F_x over mu N", One, force.fx)
            .number("fy", "F_y over mu N", One, force.fy)
            .number("mz", "M_z over mu N c", One, force.mz);
        self.section("dimensionless", Shown::Friction).number(
            "friction_used",
            "share of mu N used",
            Share,
            force.magnitude(),
        );
        if solved.areas().is_some() {
            let used = force.magnitude();
            self.section("", Shown::Nowhere).number(
                "friction_used",
                "share of mu N used",
                Share,
                used,
            );
        }
    }

    /// Areas of adhesion and slip, and heat.
    fn friction(&mut self, solved: &SolvedCase) {
        let (share, area) = (solved.adhesion_share(), solved.contact_area());
        self.section("areas", Shown::Friction).number(
            "adhesion_share",
            "adhesion, share of area",
            Share,
            share,
        );
        self.section("areas", Shown::Nowhere)
            .number("adhesion", "area of adhesion", SquareMetre, share * area)
            .number("slip", "area of slip", SquareMetre, (1.0 - share) * area);
        self.part("areas", "points", ReportPart::Count(solved.point_count()));
        self.section("", Shown::Friction)
            .number(
                "frictional_power_per_metre",
                "heat per metre rolled",
                JoulePerMetre,
                solved.power_per_metre(),
            )
            .number(
                "frictional_power_per_metre_by_slip",
                "  from traction and slip",
                JoulePerMetre,
                solved.dissipation_per_metre(),
            )
            .number("rolling_velocity", "rolling velocity", MetrePerSecond, solved.case.speed())
            .number("frictional_power", "frictional power", Watt, solved.power());
    }
}
