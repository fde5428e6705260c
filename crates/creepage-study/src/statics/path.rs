//! A shift to and fro: its numbers, its steps as text, JSON and CSV, and force over shift as a picture.

use std::fmt::Write as _;

use creepage::Hertz;
use creepage::statics::{ShiftAxis, ShiftPath};
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

/// Keys of what is told of a step.
const STEP: [&str; 4] = ["force_n", "shift_m", "adhesion_share", "dissipated_j"];

fn numbers(step: &ShiftPath) -> [f64; 4] {
    [step.force(), step.shift(), step.adhesion().powi(2), step.dissipated()]
}

impl<'a> StaticsReport<'a> {
    /// A shift to and fro along `axis`, after each of its `steps`; `None` for a path without a step.
    #[must_use]
    pub fn shift_path(
        contact: &Hertz,
        friction: f64,
        axis: ShiftAxis,
        steps: &'a [ShiftPath],
    ) -> Option<Self> {
        let (ellipse, last) = (contact.ellipse(), steps.last()?);
        let (given, peak) = pressed(contact, friction);
        let used = 100.0 * last.force().abs() / (friction * contact.normal_force());
        let ratio = last.adhesion();
        let found = vec![
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
        ];
        Some(Self {
            cautions: Vec::new(),
            problem: "shift-path",
            title: "Shift to and fro with slip at the edge",
            ellipse,
            given: [given, shape(ellipse), vec![peak], pair_numbers(contact.pair())].concat(),
            found,
            field: Field::ShiftPath(last, axis),
            steps,
        })
    }

    /// A line a step.
    pub(super) fn steps_text(&self) -> String {
        let mut text = String::new();
        if self.steps.is_empty() {
            return text;
        }
        // Writing to a String cannot fail.
        text.push_str("\nSteps\n     force (N)      shift (um)   adhesion (%)   heat so far (J)\n");
        for step in self.steps {
            let [force, shift, share, heat] = numbers(step);
            let (shift, adhesion) = (MICRO * shift, 100.0 * share);
            let _ =
                writeln!(text, "  {force:>12.5}  {shift:>14.6}  {adhesion:>13.2}  {heat:>16.5e}");
        }
        text
    }

    pub(super) fn steps_json(&self) -> Value {
        let step = |step: &ShiftPath| -> Map<String, Value> {
            STEP.iter()
                .zip(numbers(step))
                .map(|(key, value)| ((*key).into(), json!(value)))
                .collect()
        };
        self.steps.iter().map(step).collect()
    }

    /// The files of a path: `path.csv`, force over shift as SVG and as PNG; none of other problems.
    pub(super) fn path_files(&self) -> Result<Vec<(&'static str, Vec<u8>)>, ReportError> {
        if self.steps.is_empty() {
            return Ok(Vec::new());
        }
        let mut csv = STEP.join(",") + "\n";
        for step in self.steps {
            csv += &(numbers(step).map(|value| format!("{value:e}")).join(",") + "\n");
        }
        let svg = self.path_svg();
        let png = creepage_plot::png(&svg)?;
        Ok(vec![("path.csv", csv.into_bytes()), ("path.svg", svg.into_bytes()), ("path.png", png)])
    }

    /// Force over shift: every step from where the one before ended.
    fn path_svg(&self) -> String {
        let place = |path: &ShiftPath| -> Point { [MICRO * path.shift(), KILO * path.force()] };
        let mut line: Vec<Point> = vec![[0.0; 2]];
        let mut stops = Vec::new();
        let mut before: Option<&ShiftPath> = None;
        for step in self.steps {
            let start = before.map_or(0.0, ShiftPath::force);
            let mut part = before.map_or_else(|| step.fresh(), Clone::clone);
            let way = step.force() - start;
            for k in 1..=POINTS {
                let force = start + way * f64::from(k) / f64::from(POINTS);
                if part.to_force(force).is_ok() {
                    line.push(place(&part));
                }
            }
            stops.push(place(step));
            before = Some(step);
        }
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
