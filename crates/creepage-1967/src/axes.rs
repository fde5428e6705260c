//! Axis labels of all figures: names and symbols of the thesis's quantities.

use creepage_plot::Label;

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
