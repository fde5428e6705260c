//! Tables in CSV: what separates their columns, and the numbers of their fields.

use csv::{ReaderBuilder, Trim};

/// What separates the columns of a table: a comma, a semicolon or a tab.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Separator(u8);

impl Separator {
    /// That of a table: of a semicolon, a tab and a comma the first that its header has as often as its first row, for
    /// names may have commas and notes semicolons; where none is, the one that the header has first.
    pub(crate) fn of(text: &str) -> Self {
        let is_row = |line: &&str| !line.is_empty() && !line.starts_with('#');
        let mut rows = text.lines().filter(is_row).map(str::as_bytes);
        let [header, first] = [(); 2].map(|()| rows.next().unwrap_or_default());
        let parts = |line: &[u8], one: u8| line.split(|byte| *byte == one).count();
        let is_alike = |one: &u8| match parts(header, *one) {
            1 => false,
            many => many == parts(first, *one),
        };
        let alike = b";\t,".iter().copied().find(is_alike);
        let found = alike.or_else(|| header.iter().copied().find(|byte| b",;\t".contains(byte)));
        Self(found.unwrap_or(b','))
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
    fn header_and_first_row_have_the_separator_alike() {
        for (text, separator) in [
            ("x,y\n1;2\n", b','),
            ("# a; b\n\nx;y, in mm\n", b';'),
            ("x\ty\n", b'\t'),
            ("x,y; in mm\n", b','),
            ("xi, -;force, N\n0,001;5,3\n", b';'),
            ("x,y,z,note; more\n1,2,3,a\n", b','),
            ("x,y\tin mm\n1,2\n", b','),
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
