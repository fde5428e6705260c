//! The axes that all panels of the creep-force curves share.

use crate::axis::Axis;
use crate::curve_panel::{NUMBERS, TICK, WORDS, across};
use crate::curves::{Component, Curves};
use crate::format::{Scale, floor_log10};
use crate::label::Label;
use crate::scene::{Anchor, Ink, Scene};
use crate::sheet::{Area, GREY};

impl Curves<'_> {
    /// The varied component in SI units, above the first panel.
    pub(crate) fn upper_axis(&self, scene: &mut Scene, frame: Area, heading: f64, x: Axis) {
        let (factor, unit) = self.si_scale(x);
        let si = x.scaled(factor / self.unit(self.vary));
        let top = frame.from[1];
        for (value, text) in si.ticks() {
            let x = across(frame, si.share(value));
            scene.line(&[[x, top - TICK], [x, top]], Ink::line(GREY, 1.2));
            scene.text([x, top - TICK - 6.0], NUMBERS, &Label::default().number(&text));
        }
        let words = match self.vary {
            Component::Longitudinal => "longitudinal creepage ",
            Component::Lateral => "lateral creepage ",
            Component::Spin => "spin ",
        };
        let label = self.vary.si_symbol(Label::new(words)).plain(&unit);
        let middle = f64::midpoint(frame.from[0], frame.to[0]);
        scene.text([middle, heading], WORDS.anchored(Anchor::Middle), &label);
    }

    /// Unit of the upper axis in SI units, and its name in brackets.
    fn si_scale(&self, x: Axis) -> (f64, String) {
        let largest = x.from.abs().max(x.to.abs()) * self.unit(self.vary);
        if self.vary == Component::Spin {
            let scale = Scale::of(largest, "rad/m", 4);
            return (scale.factor, format!(" [{}]", scale.unit));
        }
        if (0.1..100.0).contains(&largest) {
            return (1.0, String::new());
        }
        let power = floor_log10(largest).div_euclid(3) * 3;
        (10f64.powi(power), format!(" [10{}]", raised(power)))
    }

    /// The varied component without dimension, below the last panel.
    pub(crate) fn lower_axis(&self, scene: &mut Scene, frame: Area, x: Axis) {
        let bottom = frame.to[1];
        for (value, text) in x.ticks() {
            let x = across(frame, x.share(value));
            scene.line(&[[x, bottom], [x, bottom + TICK]], Ink::line(GREY, 1.2));
            scene.text([x, bottom + TICK + 15.0], NUMBERS, &Label::default().number(&text));
        }
        let label = Label::default().symbol(self.vary.symbol()).plain(" = ");
        let label = self.vary.si_symbol(label).symbol("ρ").plain("/");
        let label = match self.vary {
            Component::Spin => label.symbol("μ"),
            _ => label.plain("(").symbol("μc").plain(")"),
        };
        let middle = f64::midpoint(frame.from[0], frame.to[0]);
        scene.text([middle, bottom + 44.0], WORDS.anchored(Anchor::Middle), &label);
    }
}

/// A power as raised digits.
fn raised(power: i32) -> String {
    let raise = |digit: char| match digit {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        _ => '⁹',
    };
    power.to_string().chars().map(raise).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_raised() {
        assert_eq!([raised(-3), raised(12)], ["⁻³", "¹²"]);
    }
}
