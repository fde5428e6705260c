//! The picture of creep-force curves: what goes where on the sheet.

use std::f64::consts::PI;

use creepage::rolling::Force;

use crate::axis::Axis;
use crate::caption;
use crate::curve_legend;
use crate::curve_panel::Panel;
use crate::curves::{Component, Curves};
use crate::format::significant;
use crate::label::Label;
use crate::scene::{Scene, Type};
use crate::sheet::{Area, DARK, GREY, MARGIN, WIDTH};

/// Where the curves start and end.
const SIDES: [f64; 2] = [112.0, 888.0];
/// Where the legend starts.
const LEGEND: f64 = 138.0;
/// From the legend to the first frame: its heading and the upper axis.
const ABOVE: f64 = 62.0;
/// Between two frames: the lower one's heading.
const BETWEEN: f64 = 48.0;
/// Below the last frame: the lower axis.
const BELOW: f64 = 84.0;
/// A component that stays below this, in parts of its unit, has no panel.
const NEGLIGIBLE: f64 = 0.01;

impl Curves<'_> {
    /// The curves as SVG: a panel for each component of the force that is not negligible.
    #[must_use]
    pub fn svg(&self) -> String {
        let mut scene = Scene::new();
        let title = Label::new("Creep-force curves");
        scene.text([MARGIN, 54.0], Type::new(25.0, DARK).bold(), &title);
        let small = Type::new(15.5, GREY);
        scene.text([MARGIN, 82.0], small, &caption::contact(self.contact, self.friction));
        scene.text([MARGIN, 106.0], small, &self.held());
        let legend_height = curve_legend::draw(&mut scene, [MARGIN, LEGEND], self);
        let panels = self.panels();
        let height = [420.0, 300.0, 230.0][panels.len().clamp(1, 3) - 1];
        let x = Axis::new(self.values.first().copied().unwrap_or(0.0), self.last_value());
        let mut top = LEGEND + legend_height + ABOVE;
        for (k, panel) in panels.iter().enumerate() {
            let frame = Area { from: [SIDES[0], top], to: [SIDES[1], top + height] };
            let heading = top - if k == 0 { 36.0 } else { 14.0 };
            panel.draw(&mut scene, frame, heading, x, self);
            if k == 0 {
                self.upper_axis(&mut scene, frame, heading, x);
            }
            if k + 1 == panels.len() {
                self.lower_axis(&mut scene, frame, x);
            }
            top += height + BETWEEN;
        }
        let names: Vec<_> = self.lines.iter().map(|curve| &curve.theory[..]).collect();
        let description = format!("Creep-force curves: {}", names.join(", "));
        scene.finish([WIDTH, top - BETWEEN + BELOW], &description)
    }

    fn last_value(&self) -> f64 {
        self.values.last().copied().unwrap_or(1.0)
    }

    /// The components that stay as they are.
    fn held(&self) -> Label {
        let mut label = Label::new("forces on the lower body");
        for component in [Component::Longitudinal, Component::Lateral, Component::Spin] {
            let value = component.of(self.case);
            if component != self.vary && value != 0.0 {
                let si = significant(value * self.unit(component), 4);
                let [symbol, unit] = [component.symbol(), component.unit()];
                label = label.plain(",\u{2003}at ").symbol(symbol).plain(" = ");
                label = component.si_symbol(label.number(&significant(value, 4)).plain(" ("));
                label = label.plain(" = ").number(&si).plain(unit).plain(")");
            }
        }
        label
    }

    /// SI unit of a component over its dimensionless unit.
    pub(crate) fn unit(&self, component: Component) -> f64 {
        match component {
            Component::Longitudinal | Component::Lateral => self.scaling.slip,
            Component::Spin => self.scaling.slip / self.scaling.length,
        }
    }

    /// The panels, at least one.
    fn panels(&self) -> Vec<Panel> {
        let force = self.scaling.force;
        let ellipse = self.contact.ellipse();
        // No traction has a larger moment than that of pure spin, which this bounds.
        let moment = 3.0 * PI / 16.0 * ellipse.major() / ellipse.c();
        let all = [
            Panel {
                words: "longitudinal force ",
                symbols: ["f", "F"],
                index: "x",
                unit: ("μN", force, "N"),
                limit: 1.0,
                of: |force: Force| force.fx,
            },
            Panel {
                words: "lateral force ",
                symbols: ["f", "F"],
                index: "y",
                unit: ("μN", force, "N"),
                limit: 1.0,
                of: |force: Force| force.fy,
            },
            Panel {
                words: "spin moment ",
                symbols: ["m", "M"],
                index: "z",
                unit: ("μNc", force * self.scaling.length, "N m"),
                limit: moment,
                of: |force: Force| force.mz,
            },
        ];
        let some: Vec<_> = all.into_iter().filter(|p| p.largest(self) > NEGLIGIBLE).collect();
        if some.is_empty() { all[..1].to_vec() } else { some }
    }
}

impl Component {
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Self::Longitudinal => "ξ",
            Self::Lateral => "η",
            Self::Spin => "χ",
        }
    }

    /// Adds the symbol of the quantity with its dimension.
    pub(crate) fn si_symbol(self, label: Label) -> Label {
        match self {
            Self::Longitudinal => label.indexed("υ", "x"),
            Self::Lateral => label.indexed("υ", "y"),
            Self::Spin => label.symbol("φ"),
        }
    }

    fn unit(self) -> &'static str {
        match self {
            Self::Longitudinal | Self::Lateral => "",
            Self::Spin => " rad/m",
        }
    }
}

#[cfg(test)]
mod tests {
    use creepage::rolling::linear::Linear;
    use creepage::rolling::polach::Polach;
    use creepage::rolling::saturated::Saturated;
    use creepage::rolling::vermeulen_johnson::VermeulenJohnson;
    use creepage::rolling::{Creepage, Theory};

    use super::*;
    use crate::testing::{CURVE, check_legible, contact};

    const COMPONENTS: [Component; 3] =
        [Component::Longitudinal, Component::Lateral, Component::Spin];

    fn svg(a_over_b: f64, case: Creepage, vary: Component, [from, to]: [f64; 2]) -> String {
        let contact = contact(a_over_b);
        let values = (0..=40).map(|k| from + (to - from) * f64::from(k) / 40.0).collect();
        let mut curves = Curves::new(&contact, 0.3, case, vary, values).unwrap();
        let theories: [(&str, Box<dyn Theory>); 4] = [
            ("linear", Box::new(Linear::new(a_over_b, 0.28).unwrap())),
            ("a name that is far too long for it", Box::new(Saturated::new(a_over_b).unwrap())),
            ("polach", Box::new(Polach::new(a_over_b, 0.28).unwrap())),
            ("vermeulen-johnson", Box::new(VermeulenJohnson::new(a_over_b, 0.28).unwrap())),
        ];
        for (name, theory) in &theories {
            curves.add(name, &**theory);
        }
        curves.svg()
    }

    fn check(svg: &str) {
        let (texts, shapes) = check_legible(svg);
        assert!(texts.len() > 20 && shapes.len() > 20);
    }

    #[test]
    fn nothing_is_clipped_or_covered() {
        for vary in COMPONENTS {
            for a_over_b in [0.01, 1.0, 30.0] {
                check(&svg(a_over_b, CURVE, vary, [0.0, 4.0]));
            }
            for range in [[-3.5, 0.0], [-1e-7, 1e-7], [0.0, 1e5], [2.0, 2.5]] {
                check(&svg(1.5, CURVE, vary, range));
            }
        }
    }

    #[test]
    fn panels_are_those_of_forces_that_there_are() {
        let panels = |case, vary| {
            let svg = svg(1.0, case, vary, [0.0, 3.0]);
            ["longitudinal force ", "lateral force ", "spin moment "]
                .map(|words| svg.contains(words))
        };
        let none = Creepage::default();
        assert_eq!(panels(none, Component::Longitudinal), [true, false, false]);
        assert_eq!(panels(none, Component::Lateral), [false, true, true]);
        assert_eq!(panels(CURVE, Component::Lateral), [true, true, true]);
    }

    #[test]
    fn the_case_is_marked_where_the_range_reaches_it() {
        let marked = |to| svg(1.0, CURVE, Component::Spin, [0.0, to]).contains("the case");
        assert!(marked(2.0) && !marked(1.0));
    }

    #[test]
    fn what_a_theory_does_not_hold_for_is_thin() {
        let thin = |chi| {
            let case = Creepage { chi, ..CURVE };
            svg(1.0, case, Component::Longitudinal, [0.1, 3.0]).contains("thin: beyond")
        };
        assert!(thin(0.5) && !thin(0.0));
    }
}
