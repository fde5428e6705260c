//! Item of the registry, a table or figure of the thesis; its reproduction, and that of many in parallel.

use crate::comparison::Comparison;
use crate::data::Data;
use crate::error::GalleryError;
use crate::points::{OwnPoints, PointsError};
use creepage_plot::{Label, Mark, Shape, Sheet};
use rayon::prelude::*;

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
    /// What the picture was drawn from.
    pub(crate) sheet: Option<Sheet>,
}

/// Points of one's own in a picture.
const OWN: Mark = Mark::full(Shape::Square, "#8e24aa");

impl Reproduction {
    pub(crate) fn figure(
        sheet: &Sheet,
        caption: impl Into<String>,
        data: Data,
        agreement: Vec<Comparison>,
    ) -> Self {
        // The page has the title as its heading.
        let sheet = sheet.clone().without_title();
        let svg = Some(sheet.svg());
        Self { caption: caption.into(), svg, text: None, data, agreement, sheet: Some(sheet) }
    }

    /// The same with points of one's own over its picture; and how many of them lie outside the
    /// frames, where they are not seen.
    ///
    /// # Errors
    /// [`PointsError`] for a table of words, and for a panel that the picture does not have.
    pub fn with_points(
        mut self,
        name: &'static str,
        points: &OwnPoints,
    ) -> Result<(Self, usize), PointsError> {
        let mut sheet = self.sheet.take().ok_or(PointsError::NoPicture { name })?;
        let panels = sheet.panels().len();
        let mut outside = 0;
        for (index, (panel, point)) in points.iter().enumerate() {
            let place = panel.checked_sub(1).filter(|place| *place < panels);
            let place = place.ok_or_else(|| PointsError::NoPanel {
                row: index + 1,
                panel: panel.to_string(),
                panels,
            })?;
            outside += usize::from(!sheet.panels()[place].holds(point));
            sheet = sheet.marks_over(place, vec![point], OWN);
        }
        let sheet = sheet.key(OWN, Label::new("your points"));
        self.svg = Some(sheet.svg());
        Ok((Self { sheet: Some(sheet), ..self }, outside))
    }

    pub(crate) fn table(
        text: String,
        caption: impl Into<String>,
        data: Data,
        agreement: Vec<Comparison>,
    ) -> Self {
        let caption = caption.into();
        Self { caption, svg: None, text: Some(text), data, agreement, sheet: None }
    }
}

/// Item with its reproduction.
#[derive(Debug, Clone)]
pub struct Made {
    /// The table or figure.
    pub item: &'static Item,
    /// Computed again.
    pub reproduction: Reproduction,
}

/// Makes `items` on all cores, in the order given; `done` is called after each.
///
/// The result is the same, bit for bit, on any number of cores.
///
/// # Errors
/// [`GalleryError`] of the first item that fails.
pub fn reproduce(
    items: &[&'static Item],
    done: impl Fn(&Item) + Sync,
) -> Result<Vec<Made>, GalleryError> {
    let make = |item: &&'static Item| {
        let reproduction = item.make()?;
        done(item);
        Ok(Made { item, reproduction })
    };
    items.par_iter().map(make).collect()
}
