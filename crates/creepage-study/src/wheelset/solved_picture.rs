//! Pictures of a solved wheelset: both wheels on their rails with areas and forces, and each place
//! of contact seen from above.

use creepage_plot::format::{fixed, quantity};
use creepage_plot::theme::{ARROW, RED};
use creepage_plot::{Axis, Label, Panel, Pen, Point, Sample, Sheet};
use creepage_rail::{GeometryError, Side, WheelsetOnTrack};
use creepage_wheelset::{SolvedContact, SolvedWheel, side_word};

use super::report::WheelsetReport;
use crate::gap::AreasPicture;

/// Millimetres to a metre: the unit of the axes.
const MM: f64 = 1e3;
/// Spacing of the points drawn (m).
const SPACING: f64 = 2e-4;
const WHEEL: Pen = Pen { colour: "#0b6bcb", dashes: "", width: 1.8 };
const RAIL: Pen = Pen::OUTLINE;
const AREA: Pen = Pen { colour: RED, dashes: "", width: 5.0 };
/// Length of the longest arrow (mm) where all of rail and wheel is shown.
const ARROW_LENGTH: f64 = 26.0;

/// A wheel on its rail, as lines `(y, z)` in millimetres.
struct View<'a> {
    wheel: &'a SolvedWheel,
    lines: [Vec<Point>; 2],
    guard: Vec<Point>,
    /// Millimetres to a newton.
    unit: f64,
}

impl WheelsetReport {
    /// Wheels on their rails, seen along the track in the direction of travel: contact areas and
    /// the forces on the rails; close by in a second row.
    ///
    /// # Errors
    /// [`GeometryError`] for a position that the track does not have.
    pub fn svg(&self, running: &WheelsetOnTrack) -> Result<String, GeometryError> {
        let largest =
            self.contacts().map(across).fold(0.0, |most: f64, [y, z]| most.max(y.hypot(z)));
        let unit = if largest > 0.0 { ARROW_LENGTH / largest } else { 0.0 };
        let view = |wheel| View::new(wheel, running, unit);
        let views = self.wheels().map(view).collect::<Result<Vec<_>, _>>()?;
        let mut sheet = Sheet::new("Wheelset on its track").columns(views.len()).width(1100.0);
        sheet = sheet.note(self.setting());
        for view in &views {
            sheet = sheet.panel(view.whole());
        }
        for view in &views {
            sheet = sheet.panel(view.close());
        }
        sheet = sheet.key(WHEEL, Label::new("wheel")).key(RAIL, Label::new("rail"));
        sheet = sheet.key(AREA, Label::new("contact area"));
        let sample = Sample::Arrow { colour: ARROW, length: 40.0 };
        let words = Label::new("force of the wheel on the rail, longest ");
        Ok(sheet.key(sample, words.number(&quantity(largest, "N", 3))).svg())
    }

    /// One picture a place of contact, seen from above: a name and SVG.
    #[must_use]
    pub fn contact_svgs(&self) -> Vec<(String, String)> {
        let of = |wheel: &SolvedWheel| {
            let named = wheel.contacts().iter().enumerate();
            let pictures = named.map(|(i, contact)| {
                (format!("{}_{}", side_word(wheel.side), i + 1), contact_svg(contact, i + 1))
            });
            pictures.collect::<Vec<_>>()
        };
        self.wheels().flat_map(of).collect()
    }

    /// The depth of wear across each place of contact, by the name of its file, `left_1_wear` and so on.
    pub(super) fn wear_svgs(&self) -> Vec<(String, String)> {
        let pictures = self.wheels().flat_map(|wheel| {
            let named = self.damage(wheel.side).iter().zip(1..);
            named.filter_map(|(damage, k): (_, usize)| {
                let svg = damage.svg()?;
                Some((format!("{}_{k}_wear", side_word(wheel.side)), svg))
            })
        });
        pictures.collect()
    }

    fn contacts(&self) -> impl Iterator<Item = &SolvedContact> {
        self.wheels().flat_map(SolvedWheel::contacts)
    }

    fn setting(&self) -> Label {
        let position = self.position();
        let gap = "\u{2003}";
        let is = |label: Label, symbol: &str, value: f64, unit: &str, digits: usize| {
            label.symbol(symbol).plain(" = ").number(&format!("{} {unit}", fixed(value, digits)))
        };
        let label = is(Label::default(), "y", MM * position.y, "mm", 3);
        let label = is(label.plain(gap), "z", MM * position.z, "mm", 4);
        let label = is(label.plain(gap).plain("roll "), "φ", MM * position.roll, "mrad", 3);
        let label = is(label.plain(gap).plain("yaw "), "ψ", MM * position.yaw, "mrad", 3);
        is(label.plain(gap), "μ", self.friction, "", 2)
    }
}

impl<'a> View<'a> {
    fn new(
        wheel: &'a SolvedWheel,
        running: &WheelsetOnTrack,
        unit: f64,
    ) -> Result<Self, GeometryError> {
        let lines = running.outlines(wheel.side, &wheel.position, SPACING)?;
        let lines =
            lines.map(|line| line.into_iter().map(|place| place.map(|at| MM * at)).collect());
        let guard = running.guard_outline(wheel.side, SPACING).into_iter();
        let guard = guard.map(|place| place.map(|at| MM * at)).collect();
        Ok(Self { wheel, lines, guard, unit })
    }

    /// Wheel and rail head.
    fn whole(&self) -> Panel {
        const BELOW: f64 = 42.0;
        const ABOVE: f64 = 16.0;
        let [wheel, _] = &self.lines;
        let y = wheel.iter().map(|place| place[0]);
        let range = [y.clone().fold(f64::INFINITY, f64::min), y.fold(f64::NEG_INFINITY, f64::max)];
        let words = match self.wheel.side {
            Side::Left => "left wheel",
            Side::Right => "right wheel",
        };
        let panel = panel([range[0] - 2.0, range[1] + 2.0], [BELOW, -ABOVE]);
        self.drawn(panel.heading(Label::new(words)), self.unit)
    }

    /// The surroundings of the contacts.
    fn close(&self) -> Panel {
        const AROUND: f64 = 4.0;
        const HEIGHT: f64 = 0.45;
        let ends = self.wheel.contacts().iter().flat_map(ends_of_areas);
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let [mut y, mut z] = ends.flatten().fold([nothing; 2], |[y, z], [at_y, at_z]| {
            [[y[0].min(at_y), y[1].max(at_y)], [z[0].min(at_z), z[1].max(at_z)]]
        });
        if y[0] > y[1] {
            (y, z) = ([0.0, 1.0].map(|part| part + MM * self.wheel.rail_origin[1]), [0.0, 1.0]);
        }
        let width = (y[1] - y[0] + 2.0 * AROUND).max((z[1] - z[0] + 2.0 * AROUND) / HEIGHT);
        let (middle, level) = (y[0].midpoint(y[1]), z[0].midpoint(z[1]));
        let half = 0.5 * HEIGHT * width;
        let panel =
            panel([middle - 0.5 * width, middle + 0.5 * width], [level + half, level - half]);
        self.drawn(panel, self.unit * width / 140.0)
    }

    fn drawn(&self, panel: Panel, unit: f64) -> Panel {
        let [wheel, rail] = &self.lines;
        let panel = panel.curve(rail.clone(), RAIL).curve(wheel.clone(), WHEEL);
        let panel =
            if self.guard.is_empty() { panel } else { panel.curve(self.guard.clone(), RAIL) };
        self.wheel.contacts().iter().fold(panel, |panel, contact| {
            let areas = ends_of_areas(contact);
            let panel = panel.curves(&areas, AREA);
            let [x, s] = contact.normal.centroid();
            let [_, y, z] = contact.in_track([x, s]).map(|at| MM * at);
            let [along_y, along_z] = across(contact).map(|force| unit * force);
            panel.arrow([y, z], [y + along_y, z + along_z], 2.2, ARROW)
        })
    }
}

fn panel(y: [f64; 2], z: [f64; 2]) -> Panel {
    let name = |symbol: &str, words: &str| Label::default().symbol(symbol).plain(words);
    Panel::new(Axis::new(y, name("y", " to the right (mm)")), Axis::new(z, name("z", " down (mm)")))
        .to_scale()
}

/// Each area's two ends across (mm).
fn ends_of_areas(contact: &SolvedContact) -> Vec<Vec<Point>> {
    let ends = |patch: &creepage::normal::Patch| {
        let end = |s: f64| {
            let [_, y, z] = contact.in_track([0.0, s]);
            [MM * y, MM * z]
        };
        patch.extent().y.map(end).to_vec()
    };
    contact.normal.patches().iter().map(ends).collect()
}

/// Force on the rail across the track and down (N).
fn across(contact: &SolvedContact) -> [f64; 2] {
    let (sin, cos) = contact.angle.sin_cos();
    let (s, n) = (contact.force.lateral, contact.load());
    [s * cos - n * sin, s * sin + n * cos]
}

/// The areas of a contact seen from above, in the contact plane.
fn contact_svg(contact: &SolvedContact, number: usize) -> String {
    let side = match contact.side {
        Side::Left => "Left",
        Side::Right => "Right",
    };
    let y = fixed(MM * contact.y_rail, 2);
    let rail = if contact.is_on_guard { "guard rail" } else { "rail" };
    AreasPicture {
        title: &format!("{side} wheel, contact {number}: at y = {y} mm of the {rail}"),
        contact: &contact.normal,
        elements: &contact.elements(),
        scaling: contact.scaling,
        status: contact.status,
        friction: contact.friction,
        force: contact.force,
        share: contact.adhesion_share(),
    }
    .svg()
}
