//! A table or figure of the thesis, and what it becomes.

use creepage_plot::Sheet;

use crate::comparison::Comparison;
use crate::data::Data;
use crate::error::GalleryError;

/// What is said of experiments whose points are in the thesis's pictures only.
pub const EXPERIMENTS: &str = "The points of the experiments are only in the picture of 1967, not in \
    its text; here are the theoretical curves alone.";

/// A table or figure of the thesis.
#[derive(Debug, Clone, Copy)]
pub struct Item {
    /// Its name on the command line, and that of its files.
    pub name: &'static str,
    /// What it shows, after its number: `Fig. 3. Force by Carter's theory`.
    pub title: &'static str,
    make: fn() -> Result<Reproduction, GalleryError>,
}

impl Item {
    pub(crate) const fn new(
        name: &'static str,
        title: &'static str,
        make: fn() -> Result<Reproduction, GalleryError>,
    ) -> Self {
        Self { name, title, make }
    }

    /// Computes it.
    ///
    /// # Errors
    /// [`GalleryError`] when what was printed, as the program was built with it, is damaged, or a
    /// theory refuses its input.
    pub fn make(&self) -> Result<Reproduction, GalleryError> {
        (self.make)()
    }
}

/// A table or figure, computed again.
#[derive(Debug, Clone)]
pub struct Reproduction {
    /// What is seen, in plain words.
    pub caption: String,
    /// The picture as SVG.
    pub svg: Option<String>,
    /// The table or the printed page in words.
    pub text: Option<String>,
    /// Its numbers.
    pub data: Data,
    /// What the thesis says, and what is found.
    pub agreement: Vec<Comparison>,
}

impl Reproduction {
    pub(crate) fn figure(
        sheet: &Sheet,
        caption: impl Into<String>,
        data: Data,
        agreement: Vec<Comparison>,
    ) -> Self {
        // The page has the title as its heading.
        let svg = Some(sheet.clone().without_title().svg());
        Self { caption: caption.into(), svg, text: None, data, agreement }
    }

    pub(crate) fn table(
        text: String,
        caption: impl Into<String>,
        data: Data,
        agreement: Vec<Comparison>,
    ) -> Self {
        Self { caption: caption.into(), svg: None, text: Some(text), data, agreement }
    }
}
