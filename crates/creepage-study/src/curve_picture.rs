//! The picture of creep-force curves: a panel for each component of the force.

use creepage::{Force, Status};
use creepage_plot::format::{Scale, fixed, floor_log10, significant};
use creepage_plot::theme::DARK;
use creepage_plot::{Axis, Fill, Label, Mark, Panel, Pen, Point, Shape, Sheet};

use crate::curve_words::raised;
use crate::curves::{Component, Curve, Curves};
use crate::measured::Overlaid;
use crate::measured::picture::MEASURED;

/// A component that stays below this, in parts of its unit, has no panel.
const NEGLIGIBLE: f64 = 0.01;
/// White above and below the curves, in parts of their range.
const AIR: f64 = 0.06;
/// Width of a line that is not to be trusted.
const THIN: f64 = 0.9;
const LARGEST: Mark = Mark { size: 6.0, ..Mark::open(Shape::Target, "#c62828") };
const APART: Mark = Mark::open(Shape::Circle, MEASURED.colour);
/// Error bars, and the part of a panel's height from which they are drawn.
const BAND: Fill = Fill::plain("#dfe4e9");
const VISIBLE: f64 = 0.004;
/// Longer names of theories are cut.
const LONGEST_NAME: usize = 21;

/// One component of the force over the range.
#[derive(Debug, Clone, Copy)]
struct Shown {
    words: &'static str,
    /// Dimensionless, and with its dimension.
    symbols: [&'static str; 2],
    index: &'static str,
    /// Symbol of the unit, its SI value, and the SI unit of that.
    unit: (&'static str, f64, &'static str),
    /// Friction allows no more: theories that do not know are cut off.
    limit: f64,
    of: fn(Force) -> f64,
}

impl Curves {
    /// The curves as SVG: a panel for each component of the force that is not negligible.
    #[must_use]
    pub fn svg(&self) -> String {
        let shown = self.shown();
        let height = [420.0, 300.0, 230.0][shown.len().clamp(1, 3) - 1];
        let mut sheet = Sheet::new("Creep-force curves")
            .width(1000.0)
            .note(self.note.clone())
            .note(self.held());
        for (k, one) in shown.iter().enumerate() {
            let panel = self.panel(one, k + 1 == shown.len()).height(height);
            sheet = sheet.panel(if k == 0 { panel.top(self.si_axis()) } else { panel });
        }
        self.keyed(sheet).svg()
    }

    /// One component with its curves and its axes.
    fn panel(&self, shown: &Shown, is_last: bool) -> Panel {
        let x = Axis::new(self.range(), self.x_label());
        let x = if is_last { x } else { x.shared() };
        let range = shown.range(self);
        let mut panel = Panel::new(x, Axis::new(range, shown.label())).right(shown.si_axis(range));
        let case = self.vary.of(self.creepage);
        if self.reach(case) {
            panel = panel.curve(range.map(|y| [case, y]).to_vec(), Pen::GUIDE);
        }
        let bands = self.lines.iter().filter_map(|curve| self.band(curve, *shown, range));
        panel = bands.fold(panel, |panel, band| panel.area(vec![band], BAND));
        for (k, curve) in self.lines.iter().enumerate().filter(|(_, curve)| shown.is_of(curve)) {
            let solutions = self.values.iter().zip(&curve.solutions);
            let points = solutions.map(|(x, solution)| {
                ([*x, (shown.of)(solution.force)], solution.status == Status::Solved)
            });
            let points: Vec<_> = points.collect();
            for (solved, part) in parts(&points) {
                let pen = if solved { Pen::of(k) } else { Pen::of(k).wide(THIN) };
                panel = panel.curve(part, pen);
            }
            let end = points.last().map(|(end, _)| *end);
            if let Some(end) = end {
                panel = panel.name(end, Pen::of(k), curve.name());
            }
            let largest = curve.largest.map(|largest| [largest.at, (shown.of)(largest.force)]);
            panel = panel.marks(largest.into_iter().collect(), LARGEST);
        }
        let measured = |is_apart: bool| {
            let points = self.measured.iter().filter(|point| point.is_apart == is_apart);
            points.filter_map(|point| shown.measured(self, point)).collect()
        };
        panel.marks(measured(true), APART).marks(measured(false), MEASURED)
    }

    /// Between the ends of a curve's error bars, where an eye can tell them from the line.
    fn band(&self, curve: &Curve, shown: Shown, [low, high]: [f64; 2]) -> Option<Vec<Point>> {
        let bar = |found: &creepage::Solution| found.error.as_ref().map(|bars| (shown.of)(*bars));
        let widest = curve.solutions.iter().filter_map(bar).fold(0.0, f64::max);
        let end = |sign: f64| {
            self.values.iter().zip(&curve.solutions).map(move |(x, found)| {
                let y = (shown.of)(found.force) + sign * bar(found).unwrap_or(0.0);
                [*x, y.clamp(low, high)]
            })
        };
        let is_wide = shown.is_of(curve) && widest > VISIBLE * (high - low);
        is_wide.then(|| end(1.0).chain(end(-1.0).rev()).collect())
    }

    /// Whether a panel has such a band.
    fn has_band(&self) -> bool {
        let has = |shown: &Shown| {
            let range = shown.range(self);
            self.lines.iter().any(|curve| self.band(curve, *shown, range).is_some())
        };
        self.shown().iter().any(has)
    }

    /// What is beside the lines.
    fn keyed(&self, mut sheet: Sheet) -> Sheet {
        let case = self.vary.of(self.creepage);
        if self.reach(case) {
            let label = Label::new("the case: ").symbol(self.vary.symbol()).plain(" = ");
            sheet = sheet.key(Pen::GUIDE, label.number(&significant(case, 4)));
        }
        if let Some((_, largest)) = self.largest().next() {
            let label = Label::new("largest force: ").number(&fixed(largest.force.magnitude(), 4));
            let label = label.plain(" at ").symbol(self.vary.symbol()).plain(" = ");
            sheet = sheet.key(LARGEST, label.number(&significant(largest.at, 4)));
        }
        if self.has_band() {
            sheet = sheet.key(BAND, Label::new("error bars"));
        }
        if self.measured.iter().any(|point| !point.is_apart) {
            sheet = sheet.key(MEASURED, Label::new("measured"));
        }
        if self.measured.iter().any(|point| point.is_apart) {
            sheet = sheet.key(APART, Label::new("measured at another creepage or load"));
        }
        let mut solutions = self.lines.iter().flat_map(|curve| &curve.solutions);
        if solutions.any(|solution| solution.status != Status::Solved) {
            let pen = Pen { colour: DARK, dashes: "", width: THIN };
            sheet = sheet.key(pen, Label::new("thin: out of the theory's range"));
        }
        sheet
    }

    fn range(&self) -> [f64; 2] {
        let (first, last) = (self.values.first().copied(), self.values.last().copied());
        [first.unwrap_or(0.0), last.unwrap_or(1.0)]
    }

    /// The components that stay as they are.
    fn held(&self) -> Label {
        let mut label = Label::new("forces on the lower body");
        for component in [Component::Longitudinal, Component::Lateral, Component::Spin] {
            let value = component.of(self.creepage);
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
    fn unit(&self, component: Component) -> f64 {
        match component {
            Component::Longitudinal | Component::Lateral => self.contact.scaling().slip,
            Component::Spin => self.contact.scaling().slip / self.contact.scaling().length,
        }
    }

    /// The varied component without dimension.
    fn x_label(&self) -> Label {
        let label = Label::default().symbol(self.vary.symbol()).plain(" = ");
        if self.contact.areas().is_some() {
            let label = match self.vary {
                Component::Spin => self.vary.si_symbol(label).symbol("c"),
                _ => self.vary.si_symbol(label),
            };
            return label.plain(" 2").symbol("G").plain("/(").symbol("μp₀").plain(")");
        }
        let label = self.vary.si_symbol(label).symbol("ρ").plain("/");
        match self.vary {
            Component::Spin => label.symbol("μ"),
            _ => label.plain("(").symbol("μc").plain(")"),
        }
    }

    /// The varied component in SI units.
    fn si_axis(&self) -> Axis {
        let range = self.range().map(|value| value * self.unit(self.vary));
        let largest = range[0].abs().max(range[1].abs());
        let (factor, unit) = match self.vary {
            Component::Spin => {
                let scale = Scale::of(largest, "rad/m", 4);
                (scale.factor, format!(" [{}]", scale.unit))
            }
            _ if (0.1..100.0).contains(&largest) => (1.0, String::new()),
            _ => {
                let power = floor_log10(largest).div_euclid(3) * 3;
                (10f64.powi(power), format!(" [10{}]", raised(power)))
            }
        };
        let label = self.vary.si_symbol(Label::new(self.vary.words())).plain(&unit);
        Axis::new(range.map(|value| value / factor), label)
    }

    /// The components to be shown, at least one.
    fn shown(&self) -> Vec<Shown> {
        let force = self.contact.scaling().force;
        let moment = self.largest_moment;
        let along = Shown {
            words: "longitudinal force ",
            symbols: ["f", "F"],
            index: "x",
            unit: ("μN", force, "N"),
            limit: 1.0,
            of: |force: Force| force.fx,
        };
        let across =
            Shown { words: "lateral force ", index: "y", of: |force: Force| force.fy, ..along };
        let about = Shown {
            words: "spin moment ",
            symbols: ["m", "M"],
            index: "z",
            unit: ("μNc", force * self.contact.scaling().length, "N m"),
            limit: moment,
            of: |force: Force| force.mz,
        };
        let mut shown = vec![along, across, about];
        shown.retain(|one| one.largest(self) > NEGLIGIBLE);
        if shown.is_empty() { vec![along] } else { shown }
    }
}

impl Curve {
    /// What it is called at its end.
    fn name(&self) -> Label {
        Label::new(&self.theory.chars().take(LONGEST_NAME).collect::<String>())
    }
}

impl Shown {
    /// Whether the curve's theory has this component.
    fn is_of(self, curve: &Curve) -> bool {
        self.index != "z" || curve.has_moment()
    }

    fn values(self, curve: &Curve) -> impl Iterator<Item = f64> {
        curve.solutions.iter().map(move |solution| (self.of)(solution.force))
    }

    /// A measured point in its panel, where it was measured and lies within the axis.
    fn measured(self, curves: &Curves, point: &Overlaid) -> Option<Point> {
        let value = match self.index {
            "x" => point.force[0],
            "y" => point.force[1],
            _ => None,
        };
        let at = curves.vary.of(point.creepage);
        curves.reach(at).then_some([at, value?])
    }

    /// Largest size of this component on any curve.
    fn largest(self, curves: &Curves) -> f64 {
        let measured = curves.measured.iter().filter_map(|point| self.measured(curves, point));
        let values = curves.lines.iter().flat_map(|curve| self.values(curve));
        values.chain(measured.map(|[_, value]| value)).fold(0.0, |m, v| m.max(v.abs()))
    }

    /// The range of the curves, zero included.
    fn range(self, curves: &Curves) -> [f64; 2] {
        let values = curves.lines.iter().flat_map(|curve| self.values(curve));
        let values = values.map(|value| value.clamp(-self.limit, self.limit));
        let measured = curves.measured.iter().filter_map(|point| self.measured(curves, point));
        let values = values.chain(measured.map(|[_, value]| value));
        let (low, high) = values
            .fold((0.0, 0.0), |(low, high): (f64, f64), value| (low.min(value), high.max(value)));
        let air = AIR * (high - low).max(f64::MIN_POSITIVE);
        // What only rounding has put on the other side of zero needs none.
        let low = if low < -1e-3 * air { low - air } else { 0.0 };
        let high = if high > 1e-3 * air || low >= 0.0 { high + air } else { 0.0 };
        [low, high]
    }

    fn label(self) -> Label {
        let [small, large] = self.symbols;
        let label = Label::new(self.words).indexed(small, self.index).plain(" = ");
        label.indexed(large, self.index).plain("/").symbol(self.unit.0)
    }

    /// The same range in SI units.
    fn si_axis(self, range: [f64; 2]) -> Axis {
        let (_, unit, name) = self.unit;
        let scale = Scale::of(range[0].abs().max(range[1].abs()) * unit, name, 4);
        let label = Label::default().indexed(self.symbols[1], self.index);
        let label = label.plain(&format!(" [{}]", scale.unit));
        Axis::new(range.map(|value| value * unit / scale.factor), label)
    }
}

/// A line in parts that are each solved or not throughout.
fn parts(points: &[(Point, bool)]) -> Vec<(bool, Vec<Point>)> {
    let mut parts: Vec<(bool, Vec<Point>)> = Vec::new();
    for pair in points.windows(2) {
        let solved = pair[0].1 && pair[1].1;
        match parts.last_mut() {
            Some((kind, part)) if *kind == solved => part.push(pair[1].0),
            _ => parts.push((solved, vec![pair[0].0, pair[1].0])),
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use creepage::TheorySpec;

    use super::*;
    use crate::testing::{CURVE, case, check_legible};

    const COMPONENTS: [Component; 3] =
        [Component::Longitudinal, Component::Lateral, Component::Spin];

    fn svg(a_over_b: f64, given: [f64; 3], vary: Component, [from, to]: [f64; 2]) -> String {
        let case = case(a_over_b, given);
        let values = (0..=40).map(|k| from + (to - from) * f64::from(k) / 40.0).collect();
        let mut curves = Curves::new(&case, vary, values).unwrap();
        for (shown, name) in [
            ("linear", "linear"),
            ("a name that is far too long for it", "saturated"),
            ("polach", "polach"),
            ("vermeulen-johnson", "vermeulen-johnson"),
        ] {
            let theory = TheorySpec::named(name).unwrap().prepare(&case.contact).unwrap();
            curves.add(shown, &*theory);
        }
        curves.svg()
    }

    fn check(svg: &str) {
        let boxes = check_legible(svg);
        assert!(boxes.texts.len() > 20 && boxes.shapes.len() > 20);
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
        let none = [0.0; 3];
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
            let case = [CURVE[0], CURVE[1], chi];
            svg(1.0, case, Component::Longitudinal, [0.1, 3.0]).contains("thin: out of")
        };
        assert!(thin(0.5) && !thin(0.0));
    }

    #[test]
    fn doubtful_points_make_parts_of_their_own() {
        let line = [true, true, false, true, true];
        let line: Vec<_> =
            line.iter().enumerate().map(|(x, solved)| ([x as f64, 1.0], *solved)).collect();
        let parts = parts(&line);
        let kinds: Vec<_> = parts.iter().map(|(solved, part)| (*solved, part.len())).collect();
        assert_eq!(kinds, [(true, 2), (false, 3), (true, 2)]);
    }
}
