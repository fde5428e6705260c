//! The report for a terminal: plain lines in aligned columns.

use creepage::Hertz;
use creepage::rolling::exact::Known;
use creepage::rolling::{SiForce, Status};
use creepage_plot::format::{Scale, fixed, quantity, significant};

use crate::report::Report;

impl Report<'_> {
    /// A short report of one screen: contact, creepage, forces on both bodies, status.
    #[must_use]
    pub fn text(&self) -> String {
        let mut lines = Lines(String::new());
        lines.status(self);
        lines.caution(self);
        lines.contact(self.contact);
        lines.row("friction mu", &significant(self.friction, 5));
        lines.creepage(self);
        lines.forces(self);
        lines.use_of_friction(self);
        lines.details(self);
        lines.0
    }
}

/// The contact ellipse and its pressure as a short text.
#[must_use]
pub fn hertz_text(contact: &Hertz) -> String {
    let mut lines = Lines(String::new());
    lines.contact(contact);
    let [along, across] = contact.relative_curvatures();
    lines.row("relative curvature along", &format!("{} 1/m", significant(along, 5)));
    lines.row("relative curvature across", &format!("{} 1/m", significant(across, 5)));
    lines.0
}

/// A status in words that follow the theory's name.
pub(crate) fn status_words(status: Status) -> &'static str {
    match status {
        Status::Solved => "solved",
        Status::NotConverged => {
            "NOT CONVERGED: these numbers are those of the last iterate, not a solution"
        }
        Status::CreepageTooSmall => {
            "CREEPAGE TOO SMALL for this theory's resolution: the forces may be far off"
        }
        Status::SpinTooLarge => "SPIN TOO LARGE: beyond the bound up to which this theory holds",
        _ => "NOT SOLVED: for a reason that this report has no words for",
    }
}

/// A number and its unit in a column: numbers end in one line, units start in one.
pub(crate) fn aligned(value: &str) -> String {
    let (number, unit) = value.split_once(' ').unwrap_or((value, ""));
    format!("{number:>11} {unit:<5}")
}

struct Lines(String);

impl Lines {
    fn line(&mut self, line: &str) {
        self.0.push_str(line.trim_end());
        self.0.push('\n');
    }

    fn heading(&mut self, heading: &str) {
        self.line("");
        self.line(heading);
    }

    fn row(&mut self, name: &str, value: &str) {
        self.line(&format!("  {name:<26}{}", aligned(value)));
    }

    fn columns(&mut self, name: &str, values: [&str; 3]) {
        let mut line = format!("  {name:<26}");
        for value in values {
            line.push_str(&aligned(value));
        }
        self.line(&line);
    }

    fn status(&mut self, report: &Report) {
        let answer = &report.answer;
        let words = status_words(answer.solution.status);
        let line = format!("Theory {}: {words}", answer.theory_name);
        if answer.solution.status == Status::Solved {
            self.line(&line);
        } else {
            let rule = "!".repeat(line.chars().count());
            self.line(&rule);
            self.line(&line);
            self.line(&rule);
        }
    }

    fn caution(&mut self, report: &Report) {
        if let Some(left_out) = report.extras.left_out {
            let unlike = significant(left_out.kappa_over_mu, 3);
            let error = fixed(100.0 * left_out.error(), 0);
            self.line(&format!(
                "CAUTION: this theory takes the bodies for like ones; kappa/mu = {unlike}."
            ));
            self.line(&format!(
                "For that the force may be off by some {error} % of mu N. exact counts it."
            ));
        }
    }

    fn contact(&mut self, contact: &Hertz) {
        let ellipse = contact.ellipse();
        self.heading("Contact ellipse");
        self.row("normal force N", &quantity(contact.normal_force(), "N", 5));
        self.row("semi-axis a, along rolling", &quantity(ellipse.a(), "m", 5));
        self.row("semi-axis b, across", &quantity(ellipse.b(), "m", 5));
        self.row("a/b", &significant(ellipse.ratio(), 5));
        self.row("peak pressure", &quantity(contact.peak_pressure(), "Pa", 5));
        self.row("approach of the bodies", &quantity(contact.approach(), "m", 5));
        self.row("curvature length rho", &quantity(contact.rho(), "m", 5));
        if contact.angle() != 0.0 {
            let degrees = fixed(contact.angle().to_degrees(), 3);
            self.row("angle of the axis a", &format!("{degrees} deg"));
        }
    }

    fn creepage(&mut self, report: &Report) {
        let creepage = report.answer.creepage;
        let si = report.scaling.si_creepage(creepage);
        self.heading("Creepage of the upper body relative to the lower");
        self.columns("", ["longitudinal", "lateral", "spin"]);
        self.columns(
            "in SI units",
            [
                &significant(si.longitudinal, 5),
                &significant(si.lateral, 5),
                &format!("{} rad/m", significant(si.spin, 5)),
            ],
        );
        let [xi, eta, chi] =
            [creepage.xi, creepage.eta, creepage.chi].map(|value| significant(value, 5));
        self.columns("xi, eta, chi", [&xi, &eta, &chi]);
        if let Some(Known { xi, eta, chi, .. }) = report.extras.known {
            let word = |given: Option<f64>| if given.is_some() { "given" } else { "found" };
            self.columns("given or found", [xi, eta, chi].map(word));
        }
    }

    fn forces(&mut self, report: &Report) {
        let force = report.answer.solution.force;
        let lower = report.scaling.si_force(force);
        self.heading("Tangential force");
        self.columns("", ["longitudinal", "lateral", "moment"]);
        self.force("on the lower body", report, lower);
        self.force("on the upper body", report, -lower);
        let [fx, fy, mz] = [force.fx, force.fy, force.mz].map(|value| fixed(value, 5));
        self.columns("lower, in mu N and mu N c", [&fx, &fy, &mz]);
        if let Some(Known { fx, fy, mz, .. }) = report.extras.known {
            let word = |wanted: Option<f64>| if wanted.is_some() { "wanted" } else { "found" };
            self.columns("wanted or found", [fx, fy, mz].map(word));
        }
    }

    fn force(&mut self, name: &str, report: &Report, force: SiForce) {
        let newton = Scale::of(report.scaling.force, "N", 5);
        let newton_metre = Scale::of(report.scaling.force * report.scaling.length, "N m", 5);
        self.columns(
            name,
            [
                &newton.write(force.longitudinal),
                &newton.write(force.lateral),
                &newton_metre.write(force.moment),
            ],
        );
    }

    fn use_of_friction(&mut self, report: &Report) {
        let percent = |share: f64| format!("{} %", fixed(100.0 * share, 2));
        self.line("");
        self.row("share of mu N used", &percent(report.answer.solution.force.magnitude()));
        self.row("adhesion, share of area", &percent(report.adhesion_share()));
        self.row("heat per metre rolled", &quantity(report.power_per_metre(), "J/m", 5));
        if let Some(power) = report.dissipation_per_metre() {
            self.row("  from traction and slip", &quantity(power, "J/m", 5));
        }
        if let (Some(speed), Some(power)) = (report.extras.speed, report.power()) {
            self.row("rolling velocity", &quantity(speed, "m/s", 5));
            self.row("frictional power", &quantity(power, "W", 5));
        }
    }

    fn details(&mut self, report: &Report) {
        let answer = &report.answer;
        if !answer.details.is_empty() {
            self.heading(&format!("Theory {}", answer.theory_name));
        }
        for detail in &answer.details {
            self.row(detail.label, &significant(detail.value, 5));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Extras;
    use crate::testing::{CURVE, contact, report, sliding, sticking};
    use creepage_theories::find;

    /// The words and numbers of the line that starts with `name`.
    fn line(text: &str, name: &str) -> Vec<String> {
        let line = text.lines().find(|line| line.trim_start().starts_with(name)).unwrap();
        line.trim_start()[name.len()..].split_whitespace().map(str::to_string).collect()
    }

    #[test]
    fn both_bodies_get_their_force() {
        let (contact, theory) = (contact(2.25), sliding(2.25));
        let text = report(&contact, &theory, CURVE).text();
        let lower = ["14.400", "kN", "12.000", "kN", "-14.40", "N", "m"];
        let upper = ["-14.400", "kN", "-12.000", "kN", "14.40", "N", "m"];
        assert_eq!(line(&text, "on the lower body"), lower);
        assert_eq!(line(&text, "on the upper body"), upper);
        assert_eq!(line(&text, "lower, in mu N and mu N c"), ["0.60000", "0.50000", "-0.10000"]);
        assert_eq!(line(&text, "semi-axis a, along rolling"), ["9", "mm"]);
        assert_eq!(line(&text, "share of mu N used"), ["78.10", "%"]);
        assert_eq!(line(&text, "mean of W T S"), ["0.00125"]);
    }

    #[test]
    fn what_is_known_besides_has_its_lines() {
        let (contact, theory) = (contact(2.25), sliding(2.25));
        let known = Known { chi: Some(1.5), fx: Some(0.6), fy: Some(0.5), ..Known::default() };
        let extras = Extras {
            speed: Some(20.0),
            dissipation: Some(0.5),
            known: Some(known),
            ..Extras::default()
        };
        let report = report(&contact, &theory, CURVE).with(extras);
        let text = report.text();
        assert_eq!(line(&text, "given or found"), ["found", "found", "given"]);
        assert_eq!(line(&text, "wanted or found"), ["wanted", "wanted", "found"]);
        assert_eq!(line(&text, "rolling velocity"), ["20", "m/s"]);
        let watts = quantity(20.0 * report.power_per_metre(), "W", 5);
        assert_eq!(line(&text, "frictional power").join(" "), watts);
        assert!(text.lines().skip(3).all(|line| line.chars().count() <= 80), "{text}");
    }

    #[test]
    fn what_the_theory_leaves_out_stands_below_its_name() {
        let (contact, theory) = (contact(2.25), sliding(2.25));
        for kappa_over_mu in [0.3, -0.3, -123_456.7] {
            let left_out = find("shen-hedrick-elkins").unwrap().leaves_out(kappa_over_mu);
            let extras = Extras { left_out, ..Extras::default() };
            let text = report(&contact, &theory, CURVE).with(extras).text();
            let caution = text.lines().find(|line| line.starts_with("CAUTION")).unwrap();
            assert!(caution.contains(&significant(kappa_over_mu, 3)), "{caution}");
            assert!(text.lines().skip(3).all(|line| line.chars().count() <= 80), "{text}");
        }
        assert!(!report(&contact, &theory, CURVE).text().contains("CAUTION"));
    }

    #[test]
    fn no_line_is_wider_than_a_terminal() {
        for a_over_b in [1e-5, 1.5, 1e5] {
            let (contact, theory) = (contact(a_over_b), sticking(a_over_b));
            for line in report(&contact, &theory, CURVE).text().lines() {
                assert!(line.chars().count() <= 80, "{line}");
            }
        }
    }

    #[test]
    fn what_is_not_solved_stands_on_top_between_rules() {
        let contact = contact(1.0);
        for status in [Status::NotConverged, Status::CreepageTooSmall, Status::SpinTooLarge] {
            let theory = crate::testing::Sliding { status, ..sliding(1.0) };
            let text = report(&contact, &theory, CURVE).text();
            let top: Vec<_> = text.lines().take(3).collect();
            assert!(top[0].starts_with("!!!!") && top[2] == top[0]);
            let word = status.name().replace('_', " ").to_uppercase();
            assert!(top[1].contains(&word), "{}", top[1]);
        }
        let theory = sticking(1.0);
        assert!(report(&contact, &theory, CURVE).text().starts_with("Theory test & trial: solved"));
    }

    #[test]
    fn hertz_alone() {
        let text = hertz_text(&contact(2.25));
        assert_eq!(line(&text, "normal force N"), ["80", "kN"]);
        assert_eq!(line(&text, "a/b"), ["2.25"]);
        assert!(!text.contains("angle"));
    }
}
