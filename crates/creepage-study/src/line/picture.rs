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
        let bound = |point: &LinePoint| 1e-6 * self.case.friction * point.pressure;
        // Between unlike bodies the traction turns its sign: both bounds are shown then.
        let has = |sign: f64| self.points.iter().any(|point| sign * point.traction > 0.0);
        let sides = match [has(-1.0), has(1.0)] {
            [true, true] => [-1.0, 1.0],
            [true, false] => [-1.0, 0.0],
            _ => [0.0, 1.0],
        };
        let most = self.points.iter().map(bound).fold(f64::MIN_POSITIVE, f64::max);
        let x = Axis::new([from - air, to + air], Label::default().symbol("x").plain(" (mm)"));
        let range = sides.map(|side| (1.0 + AIR) * side * most);
        let y = Axis::new(range, Label::new("traction on the lower body (MPa)"));
        let curve = |value: &dyn Fn(&LinePoint) -> f64| -> Vec<Point> {
            self.points.iter().map(|point| [1e3 * point.x, value(point)]).collect()
        };
        let strips = |adheres: bool| -> Vec<Vec<Point>> {
            let pairs = self.points.windows(2).filter(|pair| pair[0].adheres == adheres);
            let strip = |pair: &[LinePoint]| {
                let ends = [&pair[0], &pair[1]].map(|point| [1e3 * point.x, bound(point)]);
                let [[a, p], [b, q]] = ends;
                let [low, high] = sides;
                vec![[a, low * p], [b, low * q], [b, high * q], [a, high * p]]
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
            .curve(curve(&|point| sides[0] * bound(point)), Pen::GUIDE)
            .curve(curve(&|point| sides[1] * bound(point)), Pen::GUIDE)
            .curve(curve(&|point| 1e-6 * point.traction), Pen::OUTLINE);
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
