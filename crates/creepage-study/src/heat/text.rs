//! Text report of temperatures, for a terminal.

use creepage_plot::format::{fixed, quantity, significant};

use super::Heat;
use crate::text::Lines;

impl Heat {
    pub(crate) fn lines(&self, lines: &mut Lines) {
        let degrees = |value: f64| format!("{} °C", fixed(value, 2));
        lines.heading("Temperature of both surfaces");
        lines.row("highest in the contact", &degrees(self.contact_temperature_max_c));
        if let Some([x, y]) = self.place_m {
            lines.row("  at x", &quantity(x, "m", 4));
            lines.row("  at y", &quantity(y, "m", 4));
        }
        lines.row("largest rise by friction", &format!("{} K", fixed(self.flash_max_k, 2)));
        lines.row("unrubbed, in contact", &degrees(self.contact_temperature_unrubbed_c));
        lines.row("heat of friction", &quantity(self.friction_w, "W", 5));
        lines.row("  upper body's share", &significant(self.share_upper, 4));
        lines.row("heat into the upper body", &quantity(self.into_upper_w, "W", 5));
        lines.row("heat into the lower body", &quantity(self.into_lower_w, "W", 5));
        lines.row("Peclet number, upper", &significant(self.peclet_upper, 4));
        lines.row("  lower", &significant(self.peclet_lower, 4));
    }
}
