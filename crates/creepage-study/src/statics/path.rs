//! Path of a shift to and fro: its numbers, its steps as text, JSON and CSV, and force over shift as a picture.

use std::fmt::Write as _;

use creepage::statics::{ShearedRectangle, ShiftAxis, ShiftEnd, ShiftPath};
use creepage::{Ellipse, Hertz};
use creepage_plot::theme::RED;
use creepage_plot::{Axis, Label, Mark, Panel, Pen, Point, Shape, Sheet};

use super::StaticsReport;
use super::build::{found, pair_numbers, peak_pressure, pressed, shape};
use super::field::Field;
use super::output::cell;
use crate::error::ReportError;
use crate::report::{
    Quantity, Report,
    Unit::{Joule, Metre, Newton, Percent, Share},
};

/// Points of the picture from step to step.
const POINTS_PER_STEP: u32 = 48;
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
    /// What is told of a step.
    fn report(&self) -> Report;

    /// Shift (m) and force (N).
    fn place(&self) -> [f64; 2];

    /// Before the first step.
    fn begin(&self) -> Self;

    /// Goes on a part, from 0 to 1, of the way to another state; false where it cannot.
    fn apply_part(&mut self, from: &Self, to: &Self, part: f64) -> bool;
}

impl Step for ShiftPath {
    fn report(&self) -> Report {
        let mut report = Report::default();
        report
            .statics("")
            .number("force", "force", Newton, self.force())
            .number("shift", "shift", Metre, self.shift())
            .number("adhesion_share", "adhesion, share of area", Share, self.adhesion().powi(2))
            .number("dissipated", "energy turned to heat so far", Joule, self.dissipated())
            .number("normal_force", "normal force", Newton, self.normal_force());
        report
    }

    fn place(&self) -> [f64; 2] {
        [self.shift(), self.force()]
    }

    fn begin(&self) -> Self {
        self.fresh()
    }

    #[allow(clippy::float_cmp)] // a load that was not changed has the same bits
    fn apply_part(&mut self, from: &Self, to: &Self, part: f64) -> bool {
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
    fn report(&self) -> Report {
        let (plastic, slid) = (self.plastic_displacement(), self.sliding_way());
        let mut report = Report::default();
        report
            .statics("")
            .number("force", "force", Newton, self.force())
            .number("shift", "shift", Metre, self.shift())
            .number("plastic_displacement", "plastic displacement", Metre, plastic)
            .number("sliding_way", "way slid", Metre, slid)
            .number("dissipated", "work turned to heat so far", Joule, self.dissipated());
        report
    }

    fn place(&self) -> [f64; 2] {
        [self.shift(), self.force()]
    }

    fn begin(&self) -> Self {
        self.fresh()
    }

    fn apply_part(&mut self, from: &Self, to: &Self, part: f64) -> bool {
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

    /// What is told of every step.
    pub(super) fn reports(self) -> Vec<Report> {
        match self {
            Self::None => Vec::new(),
            Self::Shifted(steps) => steps.iter().map(Step::report).collect(),
            Self::Sheared(steps) => steps.iter().map(Step::report).collect(),
        }
    }

    /// The steps as a table: header and a line a step; empty without a step.
    fn csv(self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        for (k, report) in self.reports().iter().enumerate() {
            if k == 0 {
                writer.write_record(report.own().map(Quantity::key))?;
            }
            writer.write_record(report.own().map(|one| cell(one.value.unwrap_or(f64::NAN))))?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
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
        let [shift, force] = step.place();
        [MICRO * shift, KILO * force]
    };
    let (mut line, mut stops): (Vec<Point>, _) = (vec![[0.0; 2]], Vec::new());
    let mut before: Option<&S> = None;
    for step in steps {
        let from = before.cloned().unwrap_or_else(|| step.begin());
        let mut part = from.clone();
        for k in 1..=POINTS_PER_STEP {
            if part.apply_part(&from, step, f64::from(k) / f64::from(POINTS_PER_STEP)) {
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
        let load = last.normal_force();
        let used = 100.0 * last.force().abs() / (friction * load);
        let ratio = last.adhesion();
        let changes = load != contact.normal_force();
        let mut numbers = Report::default();
        pressed(&mut numbers, contact.normal_force(), friction);
        shape(&mut numbers, nominal);
        peak_pressure(&mut numbers, contact);
        pair_numbers(&mut numbers, contact.pair());
        let mut end = found(&mut numbers);
        if changes {
            end.number("end_normal_force", "normal force in the end", Newton, load);
        }
        end.number("force", "force in the end", Newton, last.force())
            .number("friction_used", "force, share of mu N", Percent, used)
            .number("shift", "shift in the end", Metre, last.shift())
            .number("sliding_shift", "shift where they slide", Metre, last.sliding_shift())
            .number("adhesion", "adhesion, share of area", Percent, 100.0 * ratio * ratio)
            .number("dissipated", "energy turned to heat", Joule, last.dissipated());
        // Hertz's semi-axes grow with the cube root of the load.
        let size = (load / contact.normal_force()).cbrt();
        let ellipse = Ellipse::new(size * nominal.a(), size * nominal.b()).ok()?;
        Some(Self {
            cautions: Vec::new(),
            problem: "shift-path",
            title: "Shift to and fro with slip at the edge",
            ellipse: if changes { ellipse } else { nominal },
            numbers,
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

    /// The files of a path: `path.csv`, force over shift as SVG and as PNG; none of other problems.
    pub(super) fn path_files(&self) -> Result<Vec<(&'static str, Vec<u8>)>, ReportError> {
        if self.path.is_empty() {
            return Ok(Vec::new());
        }
        let csv = self.path.csv()?;
        if matches!(self.path, Path::Sheared(_)) {
            // Its picture is that of the contact already.
            return Ok(vec![("path.csv", csv)]);
        }
        let svg = self.path_svg();
        let png = creepage_plot::png(&svg)?;
        Ok(vec![("path.csv", csv), ("path.svg", svg.into_bytes()), ("path.png", png)])
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
