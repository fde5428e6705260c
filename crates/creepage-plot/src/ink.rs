//! Fill and outline of shapes.

use std::fmt::Write as _;

/// Fill and outline of a shape.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Ink {
    fill: Option<&'static str>,
    line: Option<(&'static str, f64)>,
    dashes: Option<&'static str>,
}

impl Ink {
    /// A filled shape without outline.
    pub(crate) fn fill(colour: &'static str) -> Self {
        Self { fill: Some(colour), ..Self::default() }
    }

    /// An outline, or an open line, of some width.
    pub(crate) const fn line(colour: &'static str, width: f64) -> Self {
        Self { fill: None, line: Some((colour, width)), dashes: None }
    }

    /// An open line with `stroke-dasharray` `dashes`, unbroken where that is empty.
    pub(crate) const fn broken_line(
        colour: &'static str,
        width: f64,
        dashes: &'static str,
    ) -> Self {
        let dashes = if dashes.is_empty() { None } else { Some(dashes) };
        Self { fill: None, line: Some((colour, width)), dashes }
    }

    /// The same, outlined too.
    pub(crate) fn outlined(self, colour: &'static str, width: f64) -> Self {
        Self { line: Some((colour, width)), ..self }
    }

    pub(crate) fn attributes(self) -> String {
        let mut attributes = format!("fill=\"{}\"", self.fill.unwrap_or("none"));
        if let Some((colour, width)) = self.line {
            // Writing to a String cannot fail.
            let _ = write!(attributes, " stroke=\"{colour}\" stroke-width=\"{width}\"");
        }
        if let Some(dashes) = self.dashes {
            let _ = write!(attributes, " stroke-dasharray=\"{dashes}\"");
        }
        attributes
    }
}
