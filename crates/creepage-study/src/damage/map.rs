//! The shakedown map with the case in it: how much of the load is tangential, and how high the pressure
//! is against the yield stress.

use creepage_plot::format::significant;
use creepage_plot::{Axis, Label, Mark, Panel, Pen, Shape, Sheet};

use super::Damage;

/// Largest force over load, and peak pressure over yield stress, that the map always shows.
const RANGE: [f64; 2] = [0.6, 6.0];
const POINTS: u8 = 120;
const INK: &str = "#222";

impl Damage {
    /// The map as SVG: above the curve `p0/k = N/F` the surface ratchets (K.L. Johnson); where Melan's
    /// bound is known it is marked above or below the case.
    #[must_use]
    pub fn map_svg(&self) -> String {
        let case = [self.traction_coefficient, self.peak_over_shear_yield];
        let melan = self.shakedown_load_factor.map(|factor| [case[0], factor * case[1]]);
        let highest = melan.map_or(case[1], |[_, limit]| limit.max(case[1]));
        let [right, top] = [RANGE[0].max(1.2 * case[0]), RANGE[1].max(1.2 * highest)];
        let share = |i: u8| f64::from(i + 1) / f64::from(POINTS);
        let surface = (0..POINTS).map(|i| right * share(i)).map(|f| [f, 1.0 / f]);
        let surface: Vec<_> = surface.filter(|[_, limit]| *limit <= top).collect();
        let x = Axis::new([0.0, right], Label::new("tangential force over load"));
        let y = Axis::new([0.0, top], Label::new("peak pressure over ").symbol("k"));
        let (here, limit) = (Mark::full(Shape::Circle, INK), Mark::open(Shape::Square, INK));
        let mut panel = Panel::new(x, y).curve(surface, Pen::of(0)).marks(vec![case], here);
        let mut sheet =
            Sheet::new("Shakedown map").key(Pen::of(0), Label::new("the surface ratchets above"));
        sheet = sheet.key(here, Label::new("this contact: ").plain(&significant(case[1], 3)));
        if let Some(melan) = melan {
            panel = panel.curve(vec![case, melan], Pen::GUIDE).marks(vec![melan], limit);
            let label = Label::new("shakes down up to here, by Melan's bound: ");
            sheet = sheet.key(limit, label.plain(&significant(melan[1], 3)));
        }
        sheet.panel(panel).svg()
    }
}
