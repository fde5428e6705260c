//! A shift to and fro: its numbers, its steps as text, JSON and CSV, and force over shift as a picture.

use std::fmt::Write as _;

use creepage::statics::{ShearedRectangle, ShiftAxis, ShiftEnd, ShiftPath};
use creepage::{Ellipse, Hertz};
use creepage_plot::theme::RED;
use creepage_plot::{Axis, Label, Mark, Panel, Pen, Point, Shape, Sheet};
use serde_json::{Map, Value, json};

use super::StaticsReport;
use super::build::{pair_numbers, pressed, shape};
use super::field::Field;
use super::quantity::Quantity;
use crate::error::ReportError;

/// Points of the picture from step to step.
const POINTS: u32 = 48;
/// Micrometres and kilonewtons: the picture's units.
const MICRO: f64 = 1e6;
const KILO: f64 = 1e-3;

/// A path after each of its steps.
#[derive(Debug, Clone, Copy)]
pub(super) enum Path<'a> {
    /// The problem has none.
    None,
    Shifted(&'a [ShiftPath]),
    Sheared(&'a [ShearedRectangle]),
}

/// What goes to and fro.
trait Step: Clone {
    /// Keys of what is told of a step.
    const KEYS: &'static [&'static str];

    /// The numbers of these keys: the first two are force and shift.
    fn numbers(&self) -> Vec<f64>;

    /// Before the first step.
    fn begin(&self) -> Self;

    /// Goes on a part, from 0 to 1, of the way to another state; false where it cannot.
    fn go(&mut self, from: &Self, to: &Self, part: f64) -> bool;
}

impl Step for ShiftPath {
    const KEYS: &'static [&'static str] =
        &["force_n", "shift_m", "adhesion_share", "dissipated_j", "normal_force_n"];

    fn numbers(&self) -> Vec<f64> {
        let (adhesion, load) = (self.adhesion().powi(2), self.normal_force());
        vec![self.force(), self.shift(), adhesion, self.dissipated(), load]
    }

    fn begin(&self) -> Self {
        self.fresh()
    }

    #[allow(clippy::float_cmp)] // a load that was not changed has the same bits
    fn go(&mut self, from: &Self, to: &Self, part: f64) -> bool {
        let between = |from: f64, to: f64| from + part * (to - from);
        let [one, other] = [from.normal_force(), to.normal_force()];
        if one == other {
            return self.to_force(between(from.force(), to.force())).is_ok();
        }
        if !matches!(to.last_end(), Some(ShiftEnd::Shift(_))) {
            let force = ShiftEnd::Force(between(from.force(), to.force()));
            return self.to(between(one, other), force).is_ok();
        }
        // In proportion with Hertz's approach.
        let approach = |load: f64| load.cbrt().powi(2);
        let load = between(approach(one), approach(other)).sqrt().powi(3);
        self.to(load, ShiftEnd::Shift(between(from.shift(), to.shift()))).is_ok()
    }
}

impl Step for ShearedRectangle {
    const KEYS: &'static [&'static str] =
        &["force_n", "shift_m", "plastic_displacement_m", "sliding_way_m", "dissipated_j"];

    fn numbers(&self) -> Vec<f64> {
        let (plastic, slid) = (self.plastic_displacement(), self.sliding_way());
        vec![self.force(), self.shift(), plastic, slid, self.dissipated()]
    }

    fn begin(&self) -> Self {
        self.fresh()
    }

    fn go(&mut self, from: &Self, to: &Self, part: f64) -> bool {
        self.to_shift(from.shift() + part * (to.shift() - from.shift())).is_ok()
    }
}

impl Path<'_> {
    /// Whether there is no step.
    pub(super) fn is_empty(self) -> bool {
        match self {
            Self::None => true,
            Self::Shifted(steps) => steps.is_empty(),
            Self::Sheared(steps) => steps.is_empty(),
        }
    }

    fn keys(self) -> &'static [&'static str] {
        match self {
            Self::None => &[],
            Self::Shifted(_) => ShiftPath::KEYS,
            Self::Sheared(_) => ShearedRectangle::KEYS,
        }
    }

    /// The numbers of every step.
    fn rows(self) -> Vec<Vec<f64>> {
        match self {
            Self::None => Vec::new(),
            Self::Shifted(steps) => steps.iter().map(Step::numbers).collect(),
            Self::Sheared(steps) => steps.iter().map(Step::numbers).collect(),
        }
    }

    /// Force over shift, in the picture's units: the line, and where the steps end.
    fn line(self) -> [Vec<Point>; 2] {
        match self {
            Self::None => [vec![], vec![]],
            Self::Shifted(steps) => line(steps),
            Self::Sheared(steps) => line(steps),
        }
    }
}

/// Every step from where the one before ended.
fn line<S: Step>(steps: &[S]) -> [Vec<Point>; 2] {
    let place = |step: &S| -> Point {
        let numbers = step.numbers();
        [MICRO * numbers[1], KILO * numbers[0]]
    };
    let (mut line, mut stops): (Vec<Point>, _) = (vec![[0.0; 2]], Vec::new());
    let mut before: Option<&S> = None;
    for step in steps {
        let from = before.cloned().unwrap_or_else(|| step.begin());
        let mut part = from.clone();
        for k in 1..=POINTS {
            if part.go(&from, step, f64::from(k) / f64::from(POINTS)) {
                line.push(place(&part));
            }
        }
        stops.push(place(step));
        before = Some(step);
    }
    [line, stops]
}

impl<'a> StaticsReport<'a> {
    /// A shift to and fro along `axis`, after each of its `steps`; `None` for a path without a step.
    #[must_use]
    #[allow(clippy::float_cmp)] // a load that was not changed has the same bits
    pub fn shift_path(
        contact: &Hertz,
        friction: f64,
        axis: ShiftAxis,
        steps: &'a [ShiftPath],
    ) -> Option<Self> {
        let (nominal, last) = (contact.ellipse(), steps.last()?);
        let (given, peak) = pressed(contact, friction);
        let load = last.normal_force();
        let used = 100.0 * last.force().abs() / (friction * load);
        let ratio = last.adhesion();
        let changes = load != contact.normal_force();
        let end = Quantity::new("end_normal_force_n", "normal force in the end", load, "N");
        let mut found: Vec<Quantity> = changes.then_some(end).into_iter().collect();
        found.extend([
            Quantity::new("force_n", "force in the end", last.force(), "N"),
            Quantity::new("friction_used_percent", "force, share of mu N", used, "%"),
            Quantity::new("shift_m", "shift in the end", last.shift(), "m"),
            Quantity::new("sliding_shift_m", "shift where they slide", last.sliding_shift(), "m"),
            Quantity::new(
                "adhesion_percent",
                "adhesion, share of area",
                100.0 * ratio * ratio,
                "%",
            ),
            Quantity::new("dissipated_j", "energy turned to heat", last.dissipated(), "J"),
        ]);
        // Hertz's semi-axes grow with the cube root of the load.
        let size = (load / contact.normal_force()).cbrt();
        let ellipse = Ellipse::new(size * nominal.a(), size * nominal.b()).ok()?;
        Some(Self {
            cautions: Vec::new(),
            problem: "shift-path",
            title: "Shift to and fro with slip at the edge",
            ellipse: if changes { ellipse } else { nominal },
            given: [given, shape(nominal), vec![peak], pair_numbers(contact.pair())].concat(),
            found,
            field: Field::ShiftPath(last, axis),
            path: Path::Shifted(steps),
        })
    }

    /// A line a step.
    #[allow(clippy::float_cmp)] // a load that was not changed has the same bits
    pub(super) fn steps_text(&self) -> String {
        // Writing to a String cannot fail.
        let mut text = String::new();
        match self.path {
            Path::None => {}
            Path::Shifted(steps) => {
                let first = steps.first().map(|step| step.fresh().normal_force());
                let changes = steps.iter().any(|step| Some(step.normal_force()) != first);
                let own = if changes { "        load (N)" } else { "" };
                let _ = writeln!(
                    text,
                    "\nSteps\n     force (N)      shift (um)   adhesion (%)   heat so far (J){own}"
                );
                for step in steps {
                    let (force, heat) = (step.force(), step.dissipated());
                    let (shift, adhesion) = (MICRO * step.shift(), 100.0 * step.adhesion().powi(2));
                    let _ = write!(
                        text,
                        "  {force:>12.5}  {shift:>14.6}  {adhesion:>13.2}  {heat:>16.5e}"
                    );
                    let load = step.normal_force();
                    let _ = if changes { writeln!(text, "  {load:>14.5}") } else { writeln!(text) };
                }
            }
            Path::Sheared(steps) => {
                text.push_str(
                    "\nSteps\n     force (N)      shift (um)   yielded (um)     slid (um)   heat so far (J)\n",
                );
                for step in steps {
                    let (force, heat) = (step.force(), step.dissipated());
                    let [shift, plastic, slid] =
                        [step.shift(), step.plastic_displacement(), step.sliding_way()]
                            .map(|way| MICRO * way);
                    let _ = writeln!(
                        text,
                        "  {force:>12.5}  {shift:>14.6}  {plastic:>13.5} {slid:>13.5} {heat:>17.5e}"
                    );
                }
            }
        }
        text
    }

    pub(super) fn steps_json(&self) -> Value {
        let keys = self.path.keys();
        let step = |numbers: Vec<f64>| -> Map<String, Value> {
            keys.iter().zip(numbers).map(|(key, value)| ((*key).into(), json!(value))).collect()
        };
        self.path.rows().into_iter().map(step).collect()
    }

    /// The files of a path: `path.csv`, force over shift as SVG and as PNG; none of other problems.
    pub(super) fn path_files(&self) -> Result<Vec<(&'static str, Vec<u8>)>, ReportError> {
        if self.path.is_empty() {
            return Ok(Vec::new());
        }
        let mut csv = self.path.keys().join(",") + "\n";
        for numbers in self.path.rows() {
            let cells: Vec<_> = numbers.iter().map(|value| format!("{value:e}")).collect();
            csv += &(cells.join(",") + "\n");
        }
        if matches!(self.path, Path::Sheared(_)) {
            // Its picture is that of the contact already.
            return Ok(vec![("path.csv", csv.into_bytes())]);
        }
        let svg = self.path_svg();
        let png = creepage_plot::png(&svg)?;
        Ok(vec![("path.csv", csv.into_bytes()), ("path.svg", svg.into_bytes()), ("path.png", png)])
    }

    /// Force over shift.
    pub(super) fn path_svg(&self) -> String {
        let [line, stops] = self.path.line();
        let range = |axis: usize| {
            let ends = line.iter().map(|point| point[axis]);
            let [low, high] = [ends.clone().fold(0.0, f64::min), ends.fold(0.0, f64::max)];
            let margin = 0.06 * (high - low).max(1e-300);
            [low - margin, high + margin]
        };
        let across = Axis::new(range(0), Label::new("shift (µm)"));
        let up = Axis::new(range(1), Label::new("force (kN)"));
        let panel = Panel::new(across, up).curve(line, Pen::of(0));
        let panel = panel.marks(stops, Mark::open(Shape::Circle, RED));
        Sheet::new(self.title).panel(panel).svg()
    }
}
