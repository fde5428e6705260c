//! Tractions in a contact: lines of constant traction over its bound, and arrows.

use creepage::Ellipse;
use creepage::FieldPoint;

use crate::prelude::*;

/// Traction in per cent of Coulomb's bound, and its line.
pub(super) const LEVELS: [(u32, Pen); 4] = [
    (20, Pen { colour: "#8e24aa", dashes: "2 3.5", width: 2.0 }),
    (40, Pen { colour: "#2e7d32", dashes: "10 3.5 2 3.5", width: 2.0 }),
    (60, Pen { colour: "#1565c0", dashes: "7 4", width: 2.0 }),
    (80, Pen { colour: "#10243a", dashes: "", width: 1.7 }),
];
/// Half the length of an arrow.
const HALF: f64 = 0.09;
const ARROWS: &str = "#d07000";

/// Areas of less than so much traction, and arrows, of one field, in units of `c`.
pub(super) struct View {
    ellipse: Ellipse,
    /// How far out the field is resolved.
    edge: f64,
    areas: Vec<(u32, Vec<Polygon>)>,
    arrows: Vec<[[f64; 2]; 2]>,
}

impl View {
    pub(super) fn new(ellipse: Ellipse, field: &Field, edge: f64) -> Self {
        let level = |percent: u32| {
            let below =
                |point: &FieldPoint| contact::reduced(ellipse, point) < 0.01 * f64::from(percent);
            let trace = |points: &[[f64; 2]]| field(points).iter().map(below).collect();
            (percent, contact::traced(ellipse, trace).0)
        };
        let points = field(&lattice(ellipse));
        let arrows = points.iter().filter_map(|point| arrow(ellipse, point)).collect();
        let areas = LEVELS.iter().map(|(percent, _)| level(*percent)).collect();
        Self { ellipse, edge, areas, arrows }
    }

    /// Draws what lies in a part of the contact.
    pub(super) fn draw(&self, mut panel: Panel, keep: impl Fn([f64; 2]) -> bool) -> Panel {
        let kept = |point| contact::radius(self.ellipse, point) < self.edge && keep(point);
        for ((_, areas), (_, pen)) in self.areas.iter().zip(LEVELS) {
            let lines = contact::smooth(contact::parts(areas, kept));
            panel = panel.curves(&lines, pen);
        }
        let middle = |[from, to]: &[[f64; 2]; 2]| [0, 1].map(|i| f64::midpoint(from[i], to[i]));
        let arrows = self.arrows.iter().filter(|arrow| keep(middle(arrow)));
        arrows.fold(panel, |panel, [from, to]| panel.arrow(*from, *to, 1.5, ARROWS))
    }

    /// Adds the lines to a table of curve, spin, x and y.
    pub(super) fn collect(&self, data: &mut Data, name: &str, chi: f64) {
        for (percent, areas) in &self.areas {
            let line = contact::separatrix(self.ellipse, areas);
            data.points(&format!("{percent} %, {name}"), &[chi], line.iter().flatten());
        }
    }
}

/// Adds the lines and arrows to the key.
pub(super) fn key(sheet: Sheet) -> Sheet {
    let sheet = LEVELS.iter().fold(sheet, |sheet, (percent, pen)| {
        sheet.key(*pen, Label::new(&format!("{percent} % of Coulomb’s bound")))
    });
    sheet.key(Sample::arrow(ARROWS), Label::new("direction of the traction"))
}

fn arrow(ellipse: Ellipse, point: &FieldPoint) -> Option<[[f64; 2]; 2]> {
    let size = point.traction[0].hypot(point.traction[1]);
    // What is nearly nothing has no direction to speak of.
    let end =
        |sign: f64| [0, 1].map(|i| point.position[i] + sign * HALF * point.traction[i] / size);
    (contact::reduced(ellipse, point) > 0.03).then(|| [end(-1.0), end(1.0)])
}

/// Where arrows stand: rings about the centre.
fn lattice(ellipse: Ellipse) -> Vec<[f64; 2]> {
    let mut positions = Vec::new();
    for (radius, count) in [(0.14, 4), (0.38, 10), (0.62, 16), (0.86, 22)] {
        for k in 0..count {
            let turn = std::f64::consts::TAU * (f64::from(k) + 0.5) / f64::from(count);
            let (sin, cos) = turn.sin_cos();
            positions.push([radius * ellipse.a() * cos, radius * ellipse.b() * sin]);
        }
    }
    positions
}
