//! Text report of areas of any shape, for a terminal.

use creepage::SiForce;
use creepage::normal::NormalContact;
use creepage_plot::format::{Scale, fixed, quantity, significant};

use super::view::OnAreas;
use crate::report::{Report, Shown, method, pressed_report};
use crate::text::{Lines, status_words};
use crate::{Caution, CurvedJson};

impl OnAreas<'_> {
    /// A short report: contact areas, creepage, forces on both bodies, error bars, status.
    pub(crate) fn text(&self) -> String {
        let mut lines = Lines::default();
        let status = self.solution.status;
        let name = self.solved.theory.name;
        lines.headline(&format!("Theory {name}: {}", status_words(status)), status);
        for caution in &self.solved.cautions {
            lines.caution(&caution.to_string());
        }
        let report = self.solved.report();
        contact_lines(&mut lines, &report, self.contact, Some(self.solved.case.friction()));
        patch_lines(&mut lines, self.contact);
        if let Some(curved) = &self.solved.curved {
            curved_lines(&mut lines, curved, self.contact);
        }
        self.creepage_lines(&mut lines);
        self.force_lines(&mut lines);
        lines.heading("Friction");
        report.rows(&mut lines, Shown::Friction);
        if let Ok(Some(damage)) = self.solved.damage() {
            damage.lines(&mut lines);
        }
        if let Some(heat) = self.solved.heat() {
            heat.lines(&mut lines);
        }
        lines.into_text()
    }

    fn creepage_lines(&self, lines: &mut Lines) {
        let si = self.scaling.si_creepage(self.creepage);
        lines.heading("Creepage of the upper body relative to the lower, at the origin");
        lines.columns("", ["longitudinal", "lateral", "spin"]);
        let spin = format!("{} rad/m", significant(si.spin, 5));
        let [x, y] = [si.longitudinal, si.lateral].map(|value| significant(value, 5));
        lines.columns("", [&x, &y, &spin]);
        if !self.given.is_creepage() {
            let word = |given: Option<f64>| if given.is_some() { "given" } else { "found" };
            lines.columns("given or found", self.given.creepage.map(word));
        }
    }

    fn force_lines(&self, lines: &mut Lines) {
        lines.heading("Tangential force, moment about the origin");
        lines.columns("", ["longitudinal", "lateral", "moment"]);
        let scale = self.scaling;
        let newton = Scale::of(scale.force, "N", 5);
        let newton_metre = Scale::of(scale.force * scale.length, "N m", 5);
        let mut row = |name: &str, force: SiForce| {
            let [x, y] = [force.longitudinal, force.lateral].map(|value| newton.write(value));
            lines.columns(name, [&x, &y, &newton_metre.write(force.moment)]);
        };
        row("on the lower body", self.solved.force());
        if let Some(error) = self.solved.force_error() {
            row("  error bar", error);
        }
        row("on the upper body", -self.solved.force());
        if !self.given.is_creepage() {
            let word = |wanted: Option<f64>| if wanted.is_some() { "wanted" } else { "found" };
            lines.columns("wanted or found", self.given.force.map(word));
        }
    }
}

/// Bodies of any shape pressed together as a short text, warnings first.
#[must_use]
pub fn pressed_text(contact: &NormalContact, cautions: &[Caution]) -> String {
    let mut lines = Lines::default();
    for caution in cautions {
        lines.caution(&caution.to_string());
    }
    contact_lines(&mut lines, &pressed_report(contact, cautions), contact, None);
    patch_lines(&mut lines, contact);
    lines.into_text()
}

fn contact_lines(
    lines: &mut Lines,
    report: &Report,
    contact: &NormalContact,
    friction: Option<f64>,
) {
    lines.heading("Contact area of any shape");
    lines.columns("", ["", "error bar", ""]);
    report.rows_with_errors(lines, Shown::Contact);
    if let Some(friction) = friction {
        lines.row("friction mu", &significant(friction, 5));
    }
    lines.row("pressure found by", &format!(" {}", method(contact)));
}

/// A contact along a curve beside the same bodies in one plane.
fn curved_lines(lines: &mut Lines, curved: &CurvedJson, contact: &NormalContact) {
    lines.heading("Along the curve across: y is the arc length");
    lines.row(
        "the surface turns by",
        &format!("{} degrees", fixed(curved.turn_rad.to_degrees(), 2)),
    );
    // In the load's unit: a force that is its rounding is none.
    let scale = Scale::of(curved.vertical_n, "N", 5);
    lines.row("load, with friction", &scale.write(curved.vertical_n));
    lines.row("  of which by friction", &scale.write(curved.vertical_by_friction_n));
    lines.row("lateral force, with pressure", &scale.write(curved.lateral_n));
    let beside = |own: f64, plane: f64| format!("{} %", fixed(100.0 * (plane / own - 1.0), 2));
    let (peak, approach) = (contact.peak_pressure().value, contact.approach().value);
    lines.row("in a plane: peak pressure", &beside(peak, curved.plane_peak_pressure_pa));
    lines.row("  approach", &beside(approach, curved.plane_approach_m));
}

fn patch_lines(lines: &mut Lines, contact: &NormalContact) {
    lines.heading("Patches, from low to high y");
    for patch in contact.patches() {
        let (extent, [x, y]) = (patch.extent(), patch.centroid());
        let mm = |value: f64| fixed(1e3 * value, 3);
        lines.row("load", &quantity(patch.load(), "N", 5));
        lines.row("  area", &format!("{} mm²", significant(1e6 * patch.area(), 5)));
        for (name, [low, high]) in [("  x", extent.x), ("  y", extent.y)] {
            lines.columns(name, [&format!("{} mm", mm(low)), &format!("{} mm", mm(high)), ""]);
        }
        let centre = [format!("{} mm", mm(x)), format!("{} mm", mm(y))];
        lines.columns("  centre of pressure x, y", [&centre[0], &centre[1], ""]);
    }
}
