//! The report of a wheelset for a terminal.

use creepage_plot::format::{fixed, quantity, significant};
use creepage_rail::Side;
use creepage_wheelset::{
    ForceDerivative, SolvedContact, SolvedWheel, StateVariable, WheelsetDerivatives, side_word,
};

use super::report::WheelsetReport;
use crate::text::{Lines, status_words};
use crate::{Damage, Heat};

impl WheelsetReport {
    /// A short report: position and motion, forces on both rails, every contact.
    #[must_use]
    pub fn text(&self) -> String {
        let mut lines = Lines::default();
        let status = self.status();
        lines.headline(&format!("Theory {}: {}", self.theory.name(), status_words(status)), status);
        for words in self.caution_words() {
            lines.caution(&words);
        }
        self.position_lines(&mut lines);
        for wheel in self.wheels() {
            wheel_lines(self, wheel, &mut lines);
            if let Some(derivatives) = &self.derivatives {
                derivative_lines(derivatives, wheel.side, &mut lines);
            }
        }
        lines.into_text()
    }

    fn position_lines(&self, lines: &mut Lines) {
        let (position, motion) = (self.position(), self.motion);
        lines.heading("Wheelset in track axes: x forward, y right, z down");
        lines.columns("", ["y", "z", ""]);
        lines.columns("centre", [&mm(position.y), &mm(position.z), ""]);
        lines.columns("", ["roll", "yaw", ""]);
        lines.columns("", [&mrad(position.roll), &mrad(position.yaw), ""]);
        if let Some([s, pitch]) = self.place {
            lines.columns("", ["s", "pitch", ""]);
            lines.columns("", [&mm(s), &mrad(pitch), ""]);
        }
        lines.row("speed", &quantity(motion.speed, "m/s", 5));
        let rate = |rate: f64| format!("{} rad/s", significant(rate, 8));
        if self.is_independent {
            for wheel in self.wheels() {
                let name = format!("pitch rate, {} wheel", side_word(wheel.side));
                lines.row(&name, &rate(wheel.pitch_rate));
            }
        } else {
            lines.row("pitch rate", &rate(motion.pitch_rate));
        }
        if motion.curvature.abs() > 0.0 {
            let side = if motion.curvature > 0.0 { "right" } else { "left" };
            let radius = quantity(1.0 / motion.curvature.abs(), "m", 5);
            lines.row("curve", &format!("{radius} to the {side}"));
        }
        if motion.lateral_velocity.abs() > 0.0 {
            lines.row("lateral velocity", &quantity(motion.lateral_velocity, "m/s", 5));
        }
        if motion.vertical_velocity.abs() > 0.0 {
            lines.row("vertical velocity", &quantity(motion.vertical_velocity, "m/s", 5));
        }
        if motion.roll_rate.abs() > 0.0 {
            lines.row("roll rate", &format!("{} rad/s", significant(motion.roll_rate, 5)));
        }
        if motion.yaw_rate.abs() > 0.0 {
            lines.row("yaw rate", &format!("{} rad/s", significant(motion.yaw_rate, 5)));
        }
        let friction = significant(self.friction, 5);
        let friction = if self.least_friction < self.friction {
            format!("{} to {friction}, by place", significant(self.least_friction, 5))
        } else {
            friction
        };
        lines.row("friction mu", &friction);
    }
}

fn mm(value: f64) -> String {
    format!("{} mm", fixed(1e3 * value, 4))
}

fn mrad(value: f64) -> String {
    format!("{} mrad", fixed(1e3 * value, 4))
}

fn newton(value: f64) -> String {
    format!("{} N", fixed(value, 1))
}

fn wheel_lines(report: &WheelsetReport, wheel: &SolvedWheel, lines: &mut Lines) {
    let damage = report.damage(wheel.side);
    let name = if wheel.side == Side::Left { "Left" } else { "Right" };
    if wheel.contacts().is_empty() {
        let clearance = wheel.clearance.map_or(String::new(), |gap| format!(" by {}", mm(gap)));
        return lines.heading(&format!("{name} wheel: hangs above its rail{clearance}"));
    }
    let what = if wheel.on_guard().is_some() { "rail and guard rail" } else { "rail" };
    lines.heading(&format!("{name} wheel: force on the {what}"));
    let on_rail = wheel.on_rail();
    lines.columns("", ["longitudinal", "lateral", "vertical"]);
    let [x, y, z] = on_rail.force.map(newton);
    lines.columns("in track axes", [&x, &y, &z]);
    if let Some(error) = on_rail.force_error {
        let [x, y, z] = error.map(|error| format!("{} N", significant(error, 2)));
        lines.columns("  error bar", [&x, &y, &z]);
    }
    let [x, y, z] = on_rail.moment.map(|moment| format!("{} N m", fixed(moment, 3)));
    lines.columns("moment about its origin", [&x, &y, &z]);
    if let Some(on_guard) = wheel.on_guard().filter(|_| wheel.guard_clearance <= Some(0.0)) {
        let [x, y, z] = on_guard.force.map(newton);
        lines.columns("of which on the guard rail", [&x, &y, &z]);
    }
    if let Some([y, z]) = wheel.deflection {
        lines.columns("rail gives way", ["", &mm(y), &mm(z)]);
    }
    for (k, contact) in wheel.contacts().iter().enumerate() {
        contact_lines(contact, (damage.get(k), report.heat(wheel.side, k)), lines);
    }
}

fn derivative_lines(derivatives: &WheelsetDerivatives, side: Side, lines: &mut Lines) {
    lines.heading("  derivatives of the force on the rail, with what is found following");
    lines.columns("", ["longitudinal", "lateral", "vertical"]);
    for by in StateVariable::ALL {
        if let Some(ForceDerivative { force, force_error, .. }) = derivatives.of(side, by) {
            let (name, unit) = name(by);
            let [x, y, z] = force.map(|value| fixed(value, 1));
            lines.columns(&format!("by {name}, {unit}"), [&x, &y, &z]);
            let [x, y, z] = force_error.map(|error| fixed(error, 1));
            lines.columns("  error of differences", [&x, &y, &z]);
        }
    }
}

fn name(by: StateVariable) -> (&'static str, &'static str) {
    match by {
        StateVariable::Y => ("y", "N/m"),
        StateVariable::Z => ("z", "N/m"),
        StateVariable::Roll => ("roll", "N/rad"),
        StateVariable::Yaw => ("yaw", "N/rad"),
        StateVariable::Speed => ("speed", "N s/m"),
        StateVariable::PitchRate => ("pitch rate", "N s/rad"),
        StateVariable::LateralVelocity => ("lateral velocity", "N s/m"),
        StateVariable::YawRate => ("yaw rate", "N s/rad"),
    }
}

fn contact_lines(
    contact: &SolvedContact,
    (damage, heat): (Option<&Damage>, Option<&Heat>),
    lines: &mut Lines,
) {
    let normal = &contact.normal;
    let areas = match normal.patches().len() {
        1 => String::new(),
        count => format!(", {count} areas"),
    };
    let rail = if contact.is_on_guard { "guard rail" } else { "rail" };
    lines.heading(&format!("  contact at y = {} of the {rail}{areas}", mm(contact.y_rail)));
    lines.row("y on the wheel", &mm(contact.y_wheel));
    lines.row("x in the track", &mm(contact.reference[0]));
    let angle = format!("{} degrees", fixed(contact.angle.to_degrees(), 4));
    lines.row("contact angle", &angle);
    if contact.varying.is_some() {
        let slope = format!("{} degrees", fixed(contact.slope.to_degrees(), 4));
        lines.row("falls ahead by", &slope);
    }
    lines.row("normal force", &newton(contact.load()));
    lines.row("approach", &format!("{} µm", significant(1e6 * normal.approach().value, 5)));
    lines.row("peak pressure", &quantity(normal.peak_pressure().value, "Pa", 5));
    let area = significant(1e6 * normal.area().value, 5);
    lines.row("area", &format!("{area} mm²"));
    lines.columns("", ["longitudinal", "lateral", "spin"]);
    let creepage = contact.creepage;
    let [x, y] = [creepage.longitudinal, creepage.lateral].map(|value| significant(value, 5));
    lines.columns("creepage", [&x, &y, &format!("{} rad/m", significant(creepage.spin, 5))]);
    let force = contact.force;
    let moment = format!("{} N m", fixed(force.moment, 4));
    lines.columns("force", [&newton(force.longitudinal), &newton(force.lateral), &moment]);
    lines.row(
        "adhesion, share of area",
        &format!("{} %", fixed(100.0 * contact.adhesion_share(), 2)),
    );
    if let Some(power) = contact.dissipation {
        lines.row("heat per metre rolled", &quantity(power, "J/m", 5));
    }
    if let Some(damage) = damage {
        damage.lines(lines);
    }
    if let Some(heat) = heat {
        heat.lines(lines);
    }
}
