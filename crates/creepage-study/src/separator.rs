//! Tables in CSV: what separates their columns, and the numbers of their fields.

use csv::{ReaderBuilder, Trim};

/// What separates the columns of a table: a comma, a semicolon or a tab.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Separator(u8);

impl Separator {
    /// That of a table: of the three the one that its header has first.
    pub(crate) fn of(text: &str) -> Self {
        let is_header = |line: &&str| !line.is_empty() && !line.starts_with('#');
        let header = text.lines().find(is_header).unwrap_or_default();
        Self(header.bytes().find(|byte| b",;\t".contains(byte)).unwrap_or(b','))
    }

    /// A reader of such a table; lines that begin with `#` are passed over.
    pub(crate) fn reader(self) -> ReaderBuilder {
        let mut builder = ReaderBuilder::new();
        builder.delimiter(self.0).trim(Trim::All).comment(Some(b'#'));
        builder
    }

    /// The number of a field; between semicolons a comma may be the decimal sign.
    pub(crate) fn number(self, text: &str) -> Option<f64> {
        let decimal_comma = self.0 == b';' && text.contains(',') && !text.contains('.');
        let text = if decimal_comma { text.replace(',', ".") } else { text.into() };
        text.parse().ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_separator_of_the_header_is_the_tables() {
        for (text, separator) in [
            ("x,y\n1;2\n", b','),
            ("# a; b\n\nx;y, in mm\n", b';'),
            ("x\ty\n", b'\t'),
            ("x,y; in mm\n", b','),
            ("x\n1;2\n", b','),
            ("", b','),
        ] {
            assert_eq!(Separator::of(text), Separator(separator), "{text}");
        }
    }

    #[test]
    fn a_comma_is_a_decimal_sign_between_semicolons() {
        assert_eq!(Separator(b';').number("0,5"), Some(0.5));
        assert_eq!(Separator(b';').number("1,000.5"), None);
        assert_eq!(Separator(b',').number("0,5"), None);
        assert_eq!(Separator(b'\t').number("-1e-3"), Some(-1e-3));
    }
}
