//! Wear and fatigue as text, as a table and as pictures: wear across the contact, and the shakedown map, which shows how much
//! of the load is tangential and how high the pressure is against the yield stress.

use creepage_plot::format::{Scale, quantity, significant};
use creepage_plot::{Axis, Label, Mark, Panel, Pen, Shape, Sheet};

use super::{Damage, WearRow};
use crate::error::ReportError;
use crate::text::Lines;

impl Damage {
    pub(crate) fn lines(&self, lines: &mut Lines) {
        lines.heading("Wear and fatigue");
        lines.row("T gamma, without spin", &quantity(self.t_gamma_n, "N", 5));
        lines.row("  with spin", &quantity(self.t_gamma_with_spin_n, "N", 5));
        self.wear_lines(lines);
        let four = |value: f64| significant(value, 4);
        lines.row("WLRM damage of the rail", &four(self.wlrm_damage));
        lines.row("  by direction", &four(self.wlrm_directed_damage));
        lines.row("surface fatigue index", &four(self.surface_fatigue_index));
        if let Some(index) = self.local_surface_fatigue_index {
            lines.row("  largest of an element", &four(index));
        }
        lines.row("subsurface fatigue index", &quantity(self.subsurface_fatigue_index_pa, "Pa", 4));
        if let (Some(factor), Some([y, z])) = (self.shakedown_load_factor, self.shakedown_place_m) {
            lines.row("shakedown to loads times", &four(factor));
            lines.row("  governed at y", &quantity(y, "m", 3));
            lines.row("  depth z", &quantity(z, "m", 3));
        }
        if let (Some(share), Some([y, z])) = (self.dang_van_over_limit, self.dang_van_place_m) {
            lines.row("Dang Van's stress over limit", &four(share));
            lines.row("  most at y", &quantity(y, "m", 3));
            lines.row("  depth z", &quantity(z, "m", 3));
        }
        if !self.unverified.is_empty() {
            lines.words(&format!(
                "UNVERIFIED, constants from memory, replaceable in [damage]: {}.",
                self.unverified.join(", ")
            ));
        }
    }

    fn wear_lines(&self, lines: &mut Lines) {
        let four = |value: f64| significant(value, 4);
        let over_area = format!("{} N/mm²", four(self.t_gamma_over_area_n_per_mm2));
        lines.row("  over the area", &over_area);
        let rate = format!("{} µg/(m mm²)", four(self.usfd_rate_ug_per_m_mm2));
        lines.row("USFD wear rate", &rate);
        let mut depth = |name: &str, depth: Option<f64>| {
            if let Some(depth) = depth {
                lines.row(name, &quantity(depth, "m", 4));
            }
        };
        depth("  deepest in a passage", self.usfd_depth_m);
        depth("Archard, deepest", self.archard_depth_m);
        if let Some(zone) = self.archard_zone {
            lines.row("  worst zone", &format!(" {zone}"));
        }
        if let Some(area) = self.bre_area_m2_per_m {
            lines.row("BRE area per km", &format!("{} mm²", four(1e9 * area)));
        }
    }
}

/// Columns of wear across the contact.
const HEADER: [&str; 4] = ["y", "usfd_depth", "archard_depth", "archard_zone"];

impl Damage {
    /// `wear.csv`, the shakedown map as `shakedown.svg` and `.png`, and where there is wear to show
    /// `wear.svg` and `wear.png`.
    pub(crate) fn files(&self) -> Result<Vec<(&'static str, Vec<u8>)>, ReportError> {
        let mut files = vec![("wear.csv", self.csv()?)];
        let map = self.map_svg();
        let png = creepage_plot::png(&map)?;
        files.extend([("shakedown.svg", map.into_bytes()), ("shakedown.png", png)]);
        if let Some(svg) = self.svg() {
            let png = creepage_plot::png(&svg)?;
            files.extend([("wear.svg", svg.into_bytes()), ("wear.png", png)]);
        }
        Ok(files)
    }

    /// A row for each place across the contact: `y`, depths of one passage (m), and the worst zone of
    /// Archard's map; empty where the rolling velocity is not given.
    ///
    /// # Errors
    /// [`ReportError`] as of the writer of CSV.
    pub fn csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(HEADER)?;
        for row in &self.across {
            let zone = row.zone.map_or("", |zone| zone.name());
            let archard = row.archard_depth.map_or(String::new(), |depth| format!("{depth:e}"));
            let [y, usfd] = [row.y, row.usfd_depth].map(|number| format!("{number:e}"));
            writer.write_record([&y[..], &usfd, &archard, zone])?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }
}

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

/// Largest force over load, and peak pressure over yield stress, that the map always shows.
const RANGE: [f64; 2] = [0.6, 6.0];
/// Points of the surface-flow limit in the shakedown map.
const CURVE_POINTS: u8 = 120;
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
        let share = |i: u8| f64::from(i + 1) / f64::from(CURVE_POINTS);
        let surface = (0..CURVE_POINTS).map(|i| right * share(i)).map(|f| [f, 1.0 / f]);
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
