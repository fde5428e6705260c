//! The picture of a line contact: pressure and traction from edge to edge.

use creepage_plot::format::quantity;
use creepage_plot::{Axis, Fill, Label, Panel, Pen, Point, Sheet};

use super::solved::{LinePoint, SolvedLine};

/// White beside the edges and above the curves, in parts of the width and the height.
const AIR: f64 = 0.06;

impl SolvedLine {
    /// Pressure times friction, and the traction within it, as SVG; rolling to the right.
    #[must_use]
    pub fn svg(&self) -> String {
        let [from, to] = self.edges.map(|edge| 1e3 * edge);
        let air = AIR * (to - from);
        let friction = self.case.friction;
        let most = 1e-6 * friction * self.peak[0];
        let sense = if self.force < 0.0 { -1.0 } else { 1.0 };
        let lowest = self.points.iter().map(|point| 1e-6 * point.traction * sense);
        let lowest = lowest.fold(0.0_f64, f64::min);
        let height = [lowest - AIR * most * f64::from(u8::from(lowest < 0.0)), (1.0 + AIR) * most];
        let upright = if sense < 0.0 { [-height[1], -height[0]] } else { height };
        let x = Axis::new([from - air, to + air], Label::default().symbol("x").plain(" (mm)"));
        let y = Axis::new(upright, Label::new("traction on the lower body (MPa)"));
        let curve = |value: fn(&LinePoint) -> f64, by: f64| -> Vec<Point> {
            self.points.iter().map(|point| [1e3 * point.x, 1e-6 * by * value(point)]).collect()
        };
        let bound = curve(|point| point.pressure, sense * friction);
        let strips = |adheres: bool| -> Vec<Vec<Point>> {
            let pairs = self.points.windows(2).filter(|pair| pair[0].adheres == adheres);
            let strip = |pair: &[LinePoint]| {
                let [a, b] = [1e3 * pair[0].x, 1e3 * pair[1].x];
                let top = |point: &LinePoint| 1e-6 * sense * friction * point.pressure;
                vec![[a, 0.0], [b, 0.0], [b, top(&pair[1])], [a, top(&pair[0])]]
            };
            pairs.map(strip).collect()
        };
        let words = format!(
            "{} on the lower body at creepage {}",
            quantity(self.force, "N/m", 4),
            creepage_plot::format::significant(self.creepage, 4)
        );
        let panel = Panel::new(x, y)
            .height(320.0)
            .area(strips(true), Fill::ADHESION)
            .area(strips(false), Fill::SLIP)
            .curve(bound, Pen::GUIDE)
            .curve(curve(|point| point.traction, 1.0), Pen::OUTLINE);
        Sheet::new("Line contact, rolling to the right")
            .note(Label::new(&words))
            .panel(panel)
            .key(Pen::OUTLINE, Label::new("traction"))
            .key(Pen::GUIDE, Label::new("pressure times friction"))
            .key(Fill::ADHESION, Label::new("adhesion"))
            .key(Fill::SLIP, Label::new("slip"))
            .svg()
    }
}
