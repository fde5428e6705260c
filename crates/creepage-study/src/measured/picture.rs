//! The picture of a fit: measured points, and the theory.

use creepage::SiCreepage;
use creepage_plot::format::significant;
use creepage_plot::{Axis, Label, Mark, Panel, Pen, Point, Shape, Sheet};

use super::fitted::{Fit, FittedPoint};

pub(crate) const MEASURED: Mark = Mark::full(Shape::Circle, "#10243a");
const BAD: Mark = Mark { size: 5.2, ..Mark::open(Shape::Cross, "#b3261e") };
const FITTED: Mark = Mark::open(Shape::Diamond, "#c62828");
const CURVE: Pen = Pen { colour: "#c62828", dashes: "", width: 2.2 };
/// White around the points, in parts of their range.
const AIR: f64 = 0.06;
const WORDS: [&str; 3] = ["longitudinal creepage", "lateral creepage", "spin [rad/m]"];

fn component(creepage: SiCreepage, k: usize) -> f64 {
    [creepage.longitudinal, creepage.lateral, creepage.spin][k]
}

impl Fit {
    /// The forces over the normal force against the component that varies most, a panel for each that
    /// was measured: the theory as a curve where the points lie on one, else as points of its own.
    #[must_use]
    pub fn svg(&self) -> String {
        let k = self.curve.as_ref().map_or_else(|| self.widest(), |curve| curve.component);
        let measured: Vec<_> = (0..2)
            .filter(|force| self.points.iter().any(|point| point.measured[*force].is_some()))
            .collect();
        let [low, high] = self.friction.interval;
        let note = Label::new(&format!("{}: ", self.theory)).symbol("μ").plain(" = ");
        let mut note = note.number(&significant(self.friction.value, 4));
        note = note.plain(&format!(" (95 %: {low:.4} to {high:.4})"));
        if let Some(slope) = self.slope {
            note = note.plain(", factor of the slope ").number(&significant(slope.value, 3));
        }
        let mut sheet = Sheet::new("Friction fitted to measured points").width(900.0).note(note);
        for (place, force) in measured.iter().enumerate() {
            let is_last = place + 1 == measured.len();
            sheet = sheet.panel(self.panel(k, *force, is_last).height(380.0));
        }
        sheet = sheet.key(MEASURED, Label::new("measured"));
        if self.points.iter().any(|point| point.bad) {
            sheet = sheet.key(BAD, Label::new("measured, left out"));
        }
        sheet = match self.curve {
            Some(_) => sheet.key(CURVE, Label::new("theory")),
            None => sheet.key(FITTED, Label::new("theory")),
        };
        sheet.svg()
    }

    /// The component of the creepage that varies most, in parts of its largest size.
    fn widest(&self) -> usize {
        let spread = |k: usize| {
            let values = || self.points.iter().map(|point| component(point.creepage, k));
            let largest = values().map(f64::abs).fold(f64::MIN_POSITIVE, f64::max);
            (values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min)) / largest
        };
        (0..3).reduce(|one, two| if spread(two) > spread(one) { two } else { one }).unwrap_or(0)
    }

    fn panel(&self, k: usize, force: usize, is_last: bool) -> Panel {
        let over = |value: f64, point: &FittedPoint| value / point.normal_force;
        let measured = |bad: bool| -> Vec<Point> {
            let points = self.points.iter().filter(|point| point.bad == bad);
            let at = |point: &FittedPoint| {
                Some([component(point.creepage, k), over(point.measured[force]?, point)])
            };
            points.filter_map(at).collect()
        };
        let normal = self.points.first().map_or(1.0, |point| point.normal_force);
        let curve: Vec<Point> = self
            .curve
            .iter()
            .flat_map(|curve| &curve.points)
            .map(|point| [point[0], point[1 + force] / normal])
            .collect();
        let fitted: Vec<Point> = match self.curve {
            Some(_) => Vec::new(),
            None => self
                .points
                .iter()
                .map(|point| [component(point.creepage, k), over(point.fitted[force], point)])
                .collect(),
        };
        let (good, bad) = (measured(false), measured(true));
        let all = || good.iter().chain(&bad).chain(&curve).chain(&fitted);
        let [x, y] = [0, 1].map(|axis| around(all().map(|point| point[axis])));
        let name = Label::default().indexed("F", ["x", "y"][force]).plain("/").symbol("N");
        let axis = Axis::new(x, Label::new(WORDS[k]));
        let axis = if is_last { axis } else { axis.shared() };
        let panel = Panel::new(axis, Axis::new(y, name));
        let panel = if curve.is_empty() { panel } else { panel.curve(curve, CURVE) };
        panel.marks(fitted, FITTED).marks(good, MEASURED).marks(bad, BAD)
    }
}

/// A range with zero and all values in it.
fn around(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let (low, high) = values.fold((0.0_f64, 0.0_f64), |(l, h), value| (l.min(value), h.max(value)));
    let air = AIR * (high - low).max(f64::MIN_POSITIVE);
    [if low < 0.0 { low - air } else { low }, if high > 0.0 { high + air } else { high }]
}
