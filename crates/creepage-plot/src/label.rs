//! A line of text with symbols: italic letters, subscripts, powers of ten.

use std::fmt::Write as _;

/// One line of text, built span by span.
///
/// ```
/// use creepage_plot::Label;
/// let label = Label::new("force ").indexed("F", "x").plain(" = ").number("-2.5e3 N");
/// ```
#[derive(Debug, Clone, Default)]
pub struct Label {
    spans: String,
}

impl Label {
    /// Upright text.
    #[must_use]
    pub fn new(text: &str) -> Self {
        Self::default().plain(text)
    }

    /// Adds upright text.
    #[must_use]
    pub fn plain(mut self, text: &str) -> Self {
        self.spans.push_str(&escape(text));
        self
    }

    /// Adds a quantity's symbol, in italics.
    #[must_use]
    pub fn symbol(mut self, symbol: &str) -> Self {
        self.span("font-style=\"italic\"", symbol);
        self
    }

    /// Adds a symbol with a lowered index.
    #[must_use]
    pub fn indexed(self, symbol: &str, index: &str) -> Self {
        let mut label = self.symbol(symbol);
        label.shifted(3.5, index);
        label
    }

    /// Adds a number with a true minus and a raised power of ten.
    #[must_use]
    pub fn number(mut self, number: &str) -> Self {
        let (decimal, unit) = number.split_once(' ').unwrap_or((number, ""));
        let (mantissa, power) = decimal.split_once('e').unwrap_or((decimal, ""));
        self = self.plain(&mantissa.replace('-', "\u{2212}"));
        if !power.is_empty() {
            self = self.plain("\u{2009}·\u{2009}10");
            self.shifted(-5.0, &power.replace('-', "\u{2212}"));
        }
        if unit.is_empty() { self } else { self.plain("\u{a0}").plain(unit) }
    }

    /// Adds another label.
    #[must_use]
    pub fn joined(mut self, other: &Self) -> Self {
        self.spans.push_str(&other.spans);
        self
    }

    /// About how wide it is in type of `size`.
    pub(crate) fn width(&self, size: f64) -> f64 {
        // The mean of the condensed letters, and a little.
        0.53 * size * self.letters() as f64
    }

    /// Letters outside of markup; an entity is one.
    fn letters(&self) -> usize {
        let (mut letters, mut inside) = (0, false);
        for character in self.spans.chars() {
            match character {
                '<' | '&' => inside = true,
                '>' => inside = false,
                ';' if inside => (letters, inside) = (letters + 1, false),
                '\u{200b}' => {}
                _ if inside => {}
                _ => letters += 1,
            }
        }
        letters
    }

    /// The spans as SVG.
    pub(crate) fn svg(&self) -> &str {
        &self.spans
    }

    fn span(&mut self, attributes: &str, text: &str) {
        // Writing to a String cannot fail.
        let _ = write!(self.spans, "<tspan {attributes}>{}</tspan>", escape(text));
    }

    /// Smaller text moved down by `shift`; an invisible span moves what follows back. Some converters take a
    /// per cent of the font size for one of the picture.
    fn shifted(&mut self, shift: f64, text: &str) {
        self.span(&format!("dy=\"{shift}\" font-size=\"0.72em\""), text);
        self.span(&format!("dy=\"{}\"", -shift), "\u{200b}");
    }
}

/// Text as XML may carry it; a character that XML forbids becomes a space.
fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '\u{fffe}' | '\u{ffff}' => escaped.push(' '),
            c if c.is_control() => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_in_text_stays_text() {
        assert_eq!(Label::new("a<b & \u{1}c").svg(), "a&lt;b &amp;  c");
    }

    #[test]
    fn letters_are_those_that_are_seen() {
        let label = Label::new("a < b ").indexed("f", "x");
        assert_eq!(label.letters(), 8);
    }

    #[test]
    fn numbers_get_a_true_minus_and_raised_powers() {
        assert_eq!(Label::default().number("-2.5 kN").svg(), "\u{2212}2.5\u{a0}kN");
        let power = Label::default().number("1.5e-7");
        assert!(power.svg().starts_with("1.5\u{2009}·\u{2009}10<tspan dy=\"-5\""));
        assert!(power.svg().contains(" font-size=\"0.72em\">\u{2212}7</tspan>"));
    }
}
