//! Text report of a wheelset, for a terminal.

use creepage_plot::format::{fixed, quantity, significant};
use creepage_rail::Side;
use creepage_wheelset::{
    ForceDerivative, SolvedContact, SolvedWheel, StateVariable, WheelsetDerivatives, side_word,
};

use super::quantities::of_contact;
use super::report::WheelsetReport;
use crate::report::{Report, Shown};
use crate::text::{Lines, status_words};
use crate::{Damage, Heat};

const FORCE: [&str; 3] = ["force.longitudinal_n", "force.lateral_n", "force.vertical_n"];

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
        self.position_lines(&self.report(), &mut lines);
        for wheel in self.wheels() {
            self.wheel_lines(wheel, &mut lines);
            if let Some(derivatives) = &self.derivatives {
                derivative_lines(derivatives, wheel.side, &mut lines);
            }
        }
        lines.into_text()
    }

    fn position_lines(&self, report: &Report, lines: &mut Lines) {
        lines.heading("Wheelset in track axes: x forward, y right, z down");
        lines.columns("", ["y", "z", ""]);
        report.columns(lines, "centre", ["y_m", "z_m", ""]);
        lines.columns("", ["roll", "yaw", ""]);
        report.columns(lines, "", ["roll_rad", "yaw_rad", ""]);
        if self.place.is_some() {
            lines.columns("", ["s", "pitch", ""]);
            report.columns(lines, "", ["s_m", "pitch_rad", ""]);
        }
        report.rows(lines, Shown::Motion);
        if self.is_independent {
            for wheel in self.wheels() {
                let rate = format!("{} rad/s", significant(wheel.pitch_rate, 8));
                lines.row(&format!("pitch rate, {} wheel", side_word(wheel.side)), &rate);
            }
        }
        let curvature = self.motion.curvature;
        if curvature.abs() > 0.0 {
            let side = if curvature > 0.0 { "right" } else { "left" };
            let radius = quantity(1.0 / curvature.abs(), "m", 5);
            lines.row("curve", &format!("{radius} to the {side}"));
        }
        report.rows(lines, Shown::Force);
        let friction = significant(self.friction, 5);
        let friction = if self.least_friction < self.friction {
            format!("{} to {friction}, by place", significant(self.least_friction, 5))
        } else {
            friction
        };
        lines.row("friction mu", &friction);
    }

    fn wheel_lines(&self, wheel: &SolvedWheel, lines: &mut Lines) {
        let name = if wheel.side == Side::Left { "Left" } else { "Right" };
        if wheel.contacts().is_empty() {
            let clearance = wheel.clearance.map_or(String::new(), |gap| format!(" by {}", mm(gap)));
            return lines.heading(&format!("{name} wheel: hangs above its rail{clearance}"));
        }
        let report = self.of_wheel(wheel);
        let what = if wheel.on_guard().is_some() { "rail and guard rail" } else { "rail" };
        lines.heading(&format!("{name} wheel: force on the {what}"));
        lines.columns("", ["longitudinal", "lateral", "vertical"]);
        report.columns(lines, "in track axes", FORCE);
        report.error_columns(lines, "  error bar", FORCE);
        let moment = ["force.moment_x_n_m", "force.moment_y_n_m", "force.moment_z_n_m"];
        report.columns(lines, "moment about its origin", moment);
        if wheel.on_guard().is_some() && wheel.guard_clearance <= Some(0.0) {
            let force =
                ["guard.force.longitudinal_n", "guard.force.lateral_n", "guard.force.vertical_n"];
            report.columns(lines, "of which on the guard rail", force);
        }
        if let Some([y, z]) = wheel.deflection {
            lines.columns("rail gives way", ["", &mm(y), &mm(z)]);
        }
        for (k, contact) in wheel.contacts().iter().enumerate() {
            let damage = self.damage(wheel.side).get(k);
            contact_lines(contact, (damage, self.heat(wheel.side, k)), lines);
        }
    }
}

fn mm(value: f64) -> String {
    format!("{} mm", fixed(1e3 * value, 4))
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
    let areas = match contact.normal.patches().len() {
        1 => String::new(),
        count => format!(", {count} areas"),
    };
    let report = of_contact(contact, damage, heat);
    let rail = if contact.is_on_guard { "guard rail" } else { "rail" };
    lines.heading(&format!("  contact at y = {} of the {rail}{areas}", mm(contact.y_rail)));
    report.rows(lines, Shown::Contact);
    lines.columns("", ["longitudinal", "lateral", "spin"]);
    let creepage = ["longitudinal_creepage", "lateral_creepage", "spin_rad_per_m"];
    report.columns(lines, "creepage", creepage);
    report.columns(lines, "force", ["longitudinal_n", "lateral_n", "moment_n_m"]);
    report.rows(lines, Shown::Friction);
    if let Some(damage) = damage {
        damage.lines(lines);
    }
    if let Some(heat) = heat {
        heat.lines(lines);
    }
}
