//! Text report for a terminal: plain lines in aligned columns.

use creepage::Hertz;
use creepage::coulomb::Constraints;
use creepage::friction_law::RollingFriction;
use creepage::{SiForce, Status};
use creepage_plot::format::{Scale, fixed, significant};

use crate::gap::OnAreas;
use crate::report::{Shown, hertz_report};
use crate::{Caution, SolvedCase};

/// Longest line.
const WIDTH: usize = 80;

impl SolvedCase {
    /// A short report of one screen: contact, creepage, forces on both bodies, status.
    #[must_use]
    pub fn text(&self) -> String {
        if let Some(on_areas) = OnAreas::of(self) {
            return on_areas.text();
        }
        let mut lines = Lines::default();
        lines.status(self);
        lines.cautions(self);
        let report = self.report();
        lines.heading("Contact ellipse");
        report.rows(&mut lines, Shown::Contact);
        lines.row("friction mu", &significant(self.case.friction(), 5));
        if let Some(friction) = self.contact.rolling_friction() {
            lines.friction(friction);
        }
        lines.creepage(self);
        lines.forces(self);
        lines.line("");
        report.rows(&mut lines, Shown::Friction);
        if let Ok(Some(damage)) = self.damage() {
            damage.lines(&mut lines);
        }
        if let Some(heat) = self.heat() {
            heat.lines(&mut lines);
        }
        lines.diagnostics(self);
        lines.0
    }
}

/// The contact ellipse and its pressure as a short text, cautions first.
#[must_use]
pub fn hertz_text(contact: &Hertz, cautions: &[Caution]) -> String {
    let mut lines = Lines::default();
    for caution in cautions {
        lines.caution(&caution.to_string());
    }
    lines.heading("Contact ellipse");
    let report = hertz_report(contact, cautions);
    report.rows(&mut lines, Shown::Contact);
    report.rows(&mut lines, Shown::ContactAlone);
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
        Status::SeveralSolutions => {
            "SEVERAL SOLUTIONS: this one has the least slip, friction at rest led to it"
        }
        Status::NoContact => "NO CONTACT: no load presses the bodies together",
        _ => "NOT SOLVED: for a reason that this report has no words for",
    }
}

/// A number and its unit in a column: numbers end in one line, units start in one.
pub(crate) fn aligned(value: &str) -> String {
    let (number, unit) = value.split_once(' ').unwrap_or((value, ""));
    format!("{number:>11} {unit:<5}")
}

/// Lines of a report.
#[derive(Debug, Default)]
pub(crate) struct Lines(String);

impl Lines {
    pub(crate) fn line(&mut self, line: &str) {
        self.0.push_str(line.trim_end());
        self.0.push('\n');
    }

    /// Between what friction varies.
    fn friction(&mut self, friction: RollingFriction) {
        match friction.by_place() {
            Some(across) => {
                let least =
                    across.points().iter().fold(f64::INFINITY, |least, [_, mu]| least.min(*mu));
                self.row("  least, across", &significant(least, 5));
            }
            None if friction.of_temperature().is_some() => {
                let law = friction.of_temperature();
                let [_, hot] = law.map_or([f64::NAN; 2], |law| law.ends());
                self.row("  of hot surfaces", &significant(hot, 5));
            }
            None => self.row("  kinetic", &significant(friction.law().kinetic(), 5)),
        }
    }

    pub(crate) fn heading(&mut self, heading: &str) {
        self.line("");
        self.line(heading);
    }

    pub(crate) fn row(&mut self, name: &str, value: &str) {
        self.line(&format!("  {name:<26}{}", aligned(value)));
    }

    pub(crate) fn columns(&mut self, name: &str, values: [&str; 3]) {
        let mut line = format!("  {name:<26}");
        for value in values {
            line.push_str(&aligned(value));
        }
        self.line(&line);
    }

    fn status(&mut self, report: &SolvedCase) {
        let status = report.solution().status;
        self.headline(&format!("Theory {}: {}", report.theory.name, status_words(status)), status);
    }

    /// The first line, between rules where it is a warning.
    pub(crate) fn headline(&mut self, line: &str, status: Status) {
        if status == Status::Solved {
            return self.line(line);
        }
        let rule = "!".repeat(line.chars().count());
        self.line(&rule);
        self.line(line);
        self.line(&rule);
    }

    /// All cautions but that of the status, which stands above.
    fn cautions(&mut self, report: &SolvedCase) {
        let of_status = |caution: &&Caution| matches!(caution, Caution::Status(_));
        for caution in report.cautions.iter().filter(|caution| !of_status(caution)) {
            self.caution(&caution.to_string());
        }
    }

    /// A caution, broken into lines.
    pub(crate) fn caution(&mut self, words: &str) {
        self.words(&format!("CAUTION: {words}"));
    }

    /// Words, broken into lines.
    pub(crate) fn words(&mut self, words: &str) {
        let mut line = String::new();
        for word in words.split(' ') {
            if line.chars().count() + word.chars().count() >= WIDTH {
                self.line(&line);
                line.clear();
            }
            let gap = if line.is_empty() { "" } else { " " };
            line = line + gap + word;
        }
        self.line(&line);
    }

    pub(crate) fn into_text(self) -> String {
        self.0
    }

    fn creepage(&mut self, report: &SolvedCase) {
        let creepage = report.creepage();
        let si = report.scaling().si_creepage(creepage);
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
        let [xi, eta, chi] = creepage.components().map(|value| significant(value, 5));
        self.columns("xi, eta, chi", [&xi, &eta, &chi]);
        if let Some(Constraints { xi, eta, chi, .. }) = report.constraints() {
            let word = |given: Option<f64>| if given.is_some() { "given" } else { "found" };
            self.columns("given or found", [xi, eta, chi].map(word));
        }
    }

    fn forces(&mut self, report: &SolvedCase) {
        let force = report.solution().force;
        let lower = report.scaling().si_force(force);
        self.heading("Tangential force");
        self.columns("", ["longitudinal", "lateral", "moment"]);
        self.force("on the lower body", report, lower);
        self.force("on the upper body", report, -lower);
        let [fx, fy, mz] = force.components().map(|value| fixed(value, 5));
        self.columns("lower, in mu N and mu N c", [&fx, &fy, &mz]);
        if let Some(Constraints { fx, fy, mz, .. }) = report.constraints() {
            let word = |wanted: Option<f64>| if wanted.is_some() { "wanted" } else { "found" };
            self.columns("wanted or found", [fx, fy, mz].map(word));
        }
    }

    fn force(&mut self, name: &str, report: &SolvedCase, force: SiForce) {
        let newton = Scale::of(report.scaling().force, "N", 5);
        let newton_metre = Scale::of(report.scaling().force * report.scaling().length, "N m", 5);
        self.columns(
            name,
            [
                &newton.write(force.longitudinal),
                &newton.write(force.lateral),
                &newton_metre.write(force.moment),
            ],
        );
    }

    fn diagnostics(&mut self, report: &SolvedCase) {
        let diagnostics = report.diagnostics();
        if !diagnostics.is_empty() {
            self.heading(&format!("Theory {}", report.theory.name));
        }
        for diagnostic in diagnostics {
            self.row(diagnostic.label, &significant(diagnostic.value, 5));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{CURVE, SLIDING, Trial, case, report, solved};
    use crate::{Case, Given};
    use creepage_plot::format::quantity;

    /// The words and numbers of the line that starts with `name`.
    fn line(text: &str, name: &str) -> Vec<String> {
        let line = text.lines().find(|line| line.trim_start().starts_with(name)).unwrap();
        line.trim_start()[name.len()..].split_whitespace().map(str::to_string).collect()
    }

    #[test]
    fn both_bodies_get_their_force() {
        let text = report(2.25, SLIDING, CURVE).text();
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
        let given =
            Constraints { chi: Some(1.5), fx: Some(0.6), fy: Some(0.5), ..Constraints::default() };
        let case =
            Case { speed: Some(20.0), given: Given::Constraints(given), ..case(2.25, CURVE) };
        let report = solved(&case, SLIDING);
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
        for kappa_over_mu in [0.3, -0.3, -123_456.7] {
            let like = case(2.25, CURVE);
            let contact = like.contact.with_kappa_over_mu(kappa_over_mu).unwrap();
            let text = solved(&Case { contact, ..like }, SLIDING).text();
            let caution = text.lines().find(|line| line.starts_with("CAUTION")).unwrap();
            assert!(caution.contains("polach takes the bodies for like ones"), "{caution}");
            assert!(text.contains(&fixed(kappa_over_mu, 3)), "{text}");
            assert!(text.lines().skip(3).all(|line| line.chars().count() <= 80), "{text}");
        }
        assert!(!report(2.25, SLIDING, CURVE).text().contains("CAUTION"));
    }

    #[test]
    fn no_line_is_wider_than_a_terminal() {
        for a_over_b in [1e-5, 1.5, 1e5] {
            for line in report(a_over_b, Trial::Sticking, CURVE).text().lines() {
                assert!(line.chars().count() <= 80, "{line}");
            }
        }
    }

    #[test]
    fn what_is_not_solved_stands_on_top_between_rules() {
        for status in [Status::NotConverged, Status::CreepageTooSmall, Status::SpinTooLarge] {
            let text = report(1.0, Trial::Sliding(status), CURVE).text();
            let top: Vec<_> = text.lines().take(3).collect();
            assert!(top[0].starts_with("!!!!") && top[2] == top[0]);
            let word = status.name().replace('_', " ").to_uppercase();
            assert!(top[1].contains(&word), "{}", top[1]);
        }
        let text = report(1.0, Trial::Sticking, CURVE).text();
        assert!(text.starts_with("Theory test & trial: solved"));
    }

    #[test]
    fn hertz_alone() {
        let text = hertz_text(&case(2.25, CURVE).hertz, &[]);
        assert_eq!(line(&text, "normal force N"), ["80", "kN"]);
        assert_eq!(line(&text, "a/b"), ["2.25"]);
        assert!(!text.contains("angle"));
    }
}
