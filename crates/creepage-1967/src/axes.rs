//! Axis labels and colours shared by all figures.

use creepage_plot::{Fill, Label, Mark, Pen, Shape};

/// `name = symbol`.
fn named(name: &str, symbol: &str) -> Label {
    Label::new(name).plain(" ").symbol(symbol)
}

pub(crate) fn xi() -> Label {
    named("longitudinal creepage", "ξ")
}

pub(crate) fn eta() -> Label {
    named("lateral creepage", "η")
}

pub(crate) fn chi() -> Label {
    named("spin", "χ")
}

pub(crate) fn fx() -> Label {
    Label::default().indexed("f", "x").plain(" = ").indexed("F", "x").plain("/").symbol("μN")
}

pub(crate) fn fy() -> Label {
    Label::default().indexed("f", "y").plain(" = ").indexed("F", "y").plain("/").symbol("μN")
}

/// What errors of forces are measured in.
pub(crate) fn force_error() -> Label {
    let label = Label::new("error of (").indexed("f", "x").plain(", ").indexed("f", "y");
    label.plain(") in per cent of ").symbol("μN")
}

/// A line of settings below a title: `a/b = 1,  σ = 0.28`.
pub(crate) fn setting(parts: &[(&str, &str)]) -> Label {
    let one =
        |(symbol, value): &(&str, &str)| Label::default().symbol(symbol).plain(" = ").number(value);
    let labels: Vec<_> = parts.iter().map(one).collect();
    let mut label = Label::default();
    for (k, part) in labels.iter().enumerate() {
        label = if k > 0 { label.plain(",\u{2003}") } else { label }.joined(part);
    }
    label
}

/// What a curve of chapter 5 is called at its end.
pub(crate) fn short_degree(degree: usize) -> Label {
    Label::default().symbol("M").plain(&format!(" = {degree}"))
}

/// What a curve of chapter 5 is called in a key.
pub(crate) fn degree(degree: usize) -> Label {
    Label::new("chapter 5, ").symbol("M").plain(&format!(" = {degree}"))
}

const DARK: &str = "#10243a";
const RED: &str = "#c62828";

/// The full theory, the reference for the results of 1967.
pub(crate) const FULL: Pen = Pen { colour: RED, dashes: "11 4", width: 2.3 };
/// Its error bars.
pub(crate) const BAND: Fill = Fill::plain("#f3c9c9");
/// The same where it is points.
pub(crate) const FULL_MARK: Mark = Mark::full(Shape::Circle, RED);
/// What was printed in 1967, number by number.
pub(crate) const PRINTED: Mark = Mark::open(Shape::Circle, DARK);
/// The theory of 1967 that the figure is about.
pub(crate) const OF_1967: Pen = Pen { colour: DARK, dashes: "", width: 2.5 };
/// A second and a third of them.
pub(crate) const SECOND: Pen = Pen { colour: "#1565c0", dashes: "2.5 3.5", width: 2.7 };
pub(crate) const THIRD: Pen = Pen { colour: "#2e7d32", dashes: "13 4 2.5 4", width: 2.4 };
/// Around what is small.
pub(crate) const RING: Pen = Pen { colour: "#8e24aa", dashes: "", width: 1.6 };
/// Linear theory, and other tangents.
pub(crate) const TANGENT: Pen = Pen { colour: "#5d6a76", dashes: "7 4", width: 1.4 };
