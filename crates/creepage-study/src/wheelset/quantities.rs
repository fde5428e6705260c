//! Quantities of a solved wheelset, of its wheels and of their contacts: text, JSON, Python and C have them from these
//! lists. Track axes: `x` forward, `y` right, `z` down.

use creepage_wheelset::{
    ForceDerivative, Resultant, RigidSlip, SolvedContact, SolvedWheel, StateVariable,
};

use super::report::WheelsetReport;
use crate::report::{
    PerUnit, Report, ReportPart, Shown,
    Unit::{
        self, JoulePerMetre, Metre, MetrePerSecond, Newton, NewtonMetre, One, Pascal, Radian,
        RadianPerMetre, RadianPerSecond, Share, SquareMetre,
    },
    Written, method,
};
use crate::{Damage, Heat};

const MILLIMETRES: Written = Written::Fixed(1e3, "mm", 4);
const MILLIRADIANS: Written = Written::Fixed(1e3, "mrad", 4);
const DEGREES: Written = Written::Fixed(180.0 / std::f64::consts::PI, "degrees", 4);
const NEWTONS: Written = Written::Fixed(1.0, "N", 1);
/// Names and words of the forces on a rail, and of the moments.
const FORCES: [(&str, &str); 3] = [
    ("longitudinal", "force on the rail along x"),
    ("lateral", "force on the rail along y"),
    ("vertical", "force on the rail along z"),
];
const MOMENTS: [(&str, &str); 3] = [
    ("moment_x", "moment on the rail about x"),
    ("moment_y", "moment on the rail about y"),
    ("moment_z", "moment on the rail about z"),
];
impl WheelsetReport {
    /// All that is known of it but what happens inside the contacts; as `serde` sees it, `report.json`. `left` and
    /// `right` are the wheels, `null` where the other one was solved alone; `patches` of a wheel its places of contact, by
    /// falling load.
    #[must_use]
    pub fn report(&self) -> Report {
        let (position, motion) = (self.position(), self.motion);
        let words = self.caution_words().join("; ");
        let caution = (!words.is_empty()).then_some(words);
        let mut report = Report::solved(self.theory.name(), self.status(), caution);
        let moves = |value: f64| if value.abs() > 0.0 { Shown::Force } else { Shown::Nowhere };
        let mut all = report.section("", Shown::Nowhere);
        all.written(MILLIMETRES)
            .number("y", "lateral position, to the right", Metre, position.y)
            .number("z", "height, down", Metre, position.z)
            .written(MILLIRADIANS)
            .number("roll", "turn about x", Radian, position.roll)
            .number("yaw", "turn about z", Radian, position.yaw);
        if let Some([s, pitch]) = self.place {
            all.written(MILLIMETRES)
                .number("s", "place along the track", Metre, s)
                .written(MILLIRADIANS)
                .number("pitch", "how far the wheels have rolled on", Radian, pitch);
        }
        let one_axle = if self.is_independent { Shown::Nowhere } else { Shown::Motion };
        all.written(Written::USUAL)
            .shown(Shown::Motion)
            .number("speed", "speed", MetrePerSecond, motion.speed)
            .written(Written::Digits(8))
            .shown(one_axle)
            .number("pitch_rate", "pitch rate", RadianPerSecond, motion.pitch_rate)
            .written(Written::USUAL);
        let (aside, down) = (motion.lateral_velocity, motion.vertical_velocity);
        all.shown(moves(aside))
            .number("lateral_velocity", "lateral velocity", MetrePerSecond, aside)
            .shown(moves(down))
            .number("vertical_velocity", "vertical velocity", MetrePerSecond, down)
            .shown(moves(motion.roll_rate))
            .number("roll_rate", "roll rate", RadianPerSecond, motion.roll_rate)
            .shown(moves(motion.yaw_rate))
            .number("yaw_rate", "yaw rate", RadianPerSecond, motion.yaw_rate);
        all.shown(Shown::Nowhere).number("friction", "friction mu", One, self.friction);
        if self.least_friction < self.friction {
            let least = self.least_friction;
            all.number("least_friction", "the least friction mu", One, least);
        }
        let slip = match self.slip {
            RigidSlip::Flat => "flat",
            RigidSlip::Curved => "curved",
        };
        report.part("", "slip", slip.into());
        for (side, wheel) in [("left", &self.left), ("right", &self.right)] {
            let wheel = wheel.as_ref().map(|wheel| self.of_wheel(wheel));
            report.part("", side, ReportPart::Report(wheel));
        }
        report
    }

    /// One wheel on its rail.
    pub(super) fn of_wheel(&self, wheel: &SolvedWheel) -> Report {
        let mut report = Report::default();
        // With that on the guard rail beside it, where there is one.
        report.resultant("force", &wheel.on_rail());
        let damage = self.damage(wheel.side);
        let patch = |(k, contact): (usize, &SolvedContact)| {
            of_contact(contact, damage.get(k), self.heat(wheel.side, k))
        };
        let patches = wheel.contacts().iter().enumerate().map(patch).collect();
        report.part("", "patches", ReportPart::Reports(patches));
        report
            .section("", Shown::Nowhere)
            .number("z", "the wheelset's height for this wheel", Metre, wheel.position.z)
            .number("pitch_rate", "angular velocity", RadianPerSecond, wheel.pitch_rate)
            .number("clearance", "distance down to the rail", Metre, wheel.clearance);
        if let Some(force) = wheel.on_guard() {
            report.resultant("guard.force", &force);
            report.section("guard", Shown::Nowhere).number(
                "clearance",
                "distance of the flange's back from the guard rail",
                Metre,
                wheel.guard_clearance,
            );
        }
        let numbers = |numbers: &[f64]| ReportPart::Numbers(Some(numbers.to_vec()));
        let deflection = wheel.deflection.map(|deflection| deflection.to_vec());
        report.part("", "rail_deflection_m", ReportPart::Numbers(deflection));
        report.part("", "rail_origin_m", numbers(&wheel.rail_origin));
        let derivatives = self.derivatives.as_ref().map(|all| {
            let mut report = Report::default();
            for by in StateVariable::ALL {
                let own = all.of(wheel.side, by).map(|own| of_derivative(&own, by));
                report.part("", by.key(), ReportPart::Report(own));
            }
            report
        });
        report.part("", "derivatives", ReportPart::Report(derivatives));
        report
    }
}

/// The derivative of force and moment on a rail by one part of the position or the motion.
fn of_derivative(derivative: &ForceDerivative, by: StateVariable) -> Report {
    let ForceDerivative { force, force_error, moment, moment_error } = *derivative;
    let unit = match by {
        StateVariable::Y | StateVariable::Z => PerUnit::Metre,
        StateVariable::Roll | StateVariable::Yaw => PerUnit::Radian,
        StateVariable::Speed | StateVariable::LateralVelocity => PerUnit::MetrePerSecond,
        StateVariable::PitchRate | StateVariable::YawRate => PerUnit::RadianPerSecond,
    };
    let mut report = Report::default();
    let mut all = report.section("", Shown::Nowhere);
    for (k, (name, label)) in FORCES.into_iter().enumerate() {
        all.estimate(name, label, Unit::ForceBy(unit), (force[k], Some(force_error[k])));
    }
    for (k, (name, label)) in MOMENTS.into_iter().enumerate() {
        all.estimate(name, label, Unit::MomentBy(unit), (moment[k], Some(moment_error[k])));
    }
    report
}

impl Report {
    /// Force and moment on a rail in track axes; moments about the origin of the rail's profile.
    fn resultant(&mut self, section: &'static str, on_rail: &Resultant) {
        let Resultant { force, force_error, moment } = *on_rail;
        let mut all = self.section(section, Shown::Nowhere);
        all.written(NEWTONS);
        for (k, (name, label)) in FORCES.into_iter().enumerate() {
            all.estimate(name, label, Newton, (force[k], force_error.map(|error| error[k])));
        }
        all.written(Written::Fixed(1.0, "N m", 3));
        for (k, (name, label)) in MOMENTS.into_iter().enumerate() {
            all.number(name, label, NewtonMetre, moment[k]);
        }
    }
}

/// One place of contact. Its axes: `x` forward, `s = (cos angle, sin angle)` in the track's `(y, z)`, the normal into the
/// rail; extents and the centre of pressure from its reference point.
pub(super) fn of_contact(
    contact: &SolvedContact,
    damage: Option<&Damage>,
    heat: Option<&Heat>,
) -> Report {
    let (normal, force, error) = (&contact.normal, contact.force, contact.force_error);
    let [approach, area, peak] = [normal.approach(), normal.area(), normal.peak_pressure()]
        .map(|one| (one.value, Some(one.error)));
    let [x, y, z] = contact.reference;
    let mut report = Report::default();
    if contact.is_on_guard {
        report.part("", "rail", "guard".into());
    }
    let mut all = report.section("", Shown::Nowhere);
    all.written(MILLIMETRES)
        .number("y_rail", "y in the rail's profile", Metre, contact.y_rail)
        .shown(Shown::Contact)
        .number("y_wheel", "y on the wheel", Metre, contact.y_wheel)
        .number("x", "x in the track", Metre, x)
        .shown(Shown::Nowhere)
        .number("y", "y in the track", Metre, y)
        .number("z", "z in the track", Metre, z)
        .shown(Shown::Contact)
        .written(DEGREES)
        .number("contact_angle", "contact angle", Radian, contact.angle);
    if contact.varying.is_some() {
        all.number("contact_slope", "falls ahead by", Radian, contact.slope);
    }
    all.written(NEWTONS)
        .estimate(
            "normal_force",
            "normal force",
            Newton,
            (contact.load(), Some(contact.load_error)),
        )
        .written(Written::Significant(1e6, "µm", 5))
        .estimate("approach", "approach", Metre, approach)
        .written(Written::USUAL)
        .estimate("peak_pressure", "peak pressure", Pascal, peak)
        .estimate("area", "area", SquareMetre, area);
    report.part("", "areas", ReportPart::Count(normal.patches().len()));
    let [along, across] = contact.extent().map(|extent| ReportPart::Numbers(Some(extent.to_vec())));
    report.part("", "extent_x_m", along);
    report.part("", "extent_s_m", across);
    let centre = contact.centre_of_pressure().to_vec();
    report.part("", "centre_of_pressure_m", ReportPart::Numbers(Some(centre)));
    let creepage = contact.creepage;
    let error = |of: fn(&creepage::SiForce) -> f64| error.as_ref().map(of);
    report
        .section("", Shown::Nowhere)
        .number("longitudinal_creepage", "longitudinal creepage", One, creepage.longitudinal)
        .number("lateral_creepage", "lateral creepage", One, creepage.lateral)
        .number("spin", "spin", RadianPerMetre, creepage.spin)
        .written(NEWTONS)
        .estimate(
            "longitudinal",
            "force along x",
            Newton,
            (force.longitudinal, error(|one| one.longitudinal)),
        )
        .estimate("lateral", "force across", Newton, (force.lateral, error(|one| one.lateral)))
        .written(Written::Fixed(1.0, "N m", 4))
        .estimate(
            "moment",
            "moment about the normal",
            NewtonMetre,
            (force.moment, error(|one| one.moment)),
        )
        .written(Written::USUAL)
        .shown(Shown::Friction)
        .number("adhesion_share", "adhesion, share of area", Share, contact.adhesion_share())
        .number(
            "frictional_power_per_metre",
            "heat per metre rolled",
            JoulePerMetre,
            contact.heat(),
        );
    report.part("", "method", method(normal).into());
    report.part("", "status", contact.status.name().into());
    report.part("", "damage", ReportPart::Damage(damage.cloned()));
    report.part("", "heat", ReportPart::Heat(heat.cloned()));
    report
}
