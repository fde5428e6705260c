//! Wear and fatigue numbers for a terminal.

use creepage_plot::format::{quantity, significant};

use super::Damage;
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
