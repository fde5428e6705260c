//! The picture of wear across the contact.

use creepage_plot::format::Scale;
use creepage_plot::{Axis, Label, Panel, Pen, Sheet};

use super::{Damage, WearRow};

impl Damage {
    /// Depth of one passage across the contact, as SVG; `None` where the theory gives no slip.
    #[must_use]
    pub fn svg(&self) -> Option<String> {
        let (first, last) = (self.across.first()?, self.across.last()?);
        let archard = |row: &WearRow| row.archard_depth;
        let curves = [
            ("USFD", Some(self.curve(|row| Some(row.usfd_depth)))),
            ("Archard", first.archard_depth.map(|_| self.curve(archard))),
        ];
        let depths = curves.iter().flat_map(|(_, curve)| curve.iter().flatten());
        let deepest = depths.map(|[_, depth]| *depth).fold(f64::MIN_POSITIVE, f64::max);
        let scale = Scale::of(deepest, "m", 3);
        let label = Label::new(&format!("depth of a passage, {}", scale.unit));
        let y = Axis::new([1.1 * deepest / scale.factor, 0.0], label);
        let x =
            Axis::new([1e3 * first.y, 1e3 * last.y], Label::default().symbol("y").plain(", mm"));
        let mut panel = Panel::new(x, y);
        let mut sheet = Sheet::new("Wear across the contact");
        for (k, (name, curve)) in curves.into_iter().enumerate() {
            let Some(curve) = curve else { continue };
            let curve = curve.into_iter().map(|[y, depth]| [1e3 * y, depth / scale.factor]);
            panel = panel.curve(curve.collect(), Pen::of(k));
            sheet = sheet.key(Pen::of(k), Label::new(name));
        }
        Some(sheet.panel(panel).svg())
    }

    fn curve(&self, depth: impl Fn(&WearRow) -> Option<f64>) -> Vec<[f64; 2]> {
        self.across.iter().filter_map(|row| Some([row.y, depth(row)?])).collect()
    }
}
