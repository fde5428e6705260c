//! Output files: those of each item, the table of agreement, and the HTML gallery.

mod agreement;
mod page;

pub use agreement::agreement_text;

use rayon::prelude::*;

use crate::error::GalleryError;
use crate::item::Made;

/// A file to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    /// Its name, without a directory.
    pub name: String,
    /// Its bytes.
    pub contents: Vec<u8>,
}

impl File {
    /// Name and bytes, as a writer of many files takes them.
    #[must_use]
    pub fn as_pair(&self) -> (&str, &[u8]) {
        (&self.name, &self.contents)
    }
}

/// The files of each item: SVG and PNG of a picture, CSV, text of a table.
///
/// # Errors
/// [`GalleryError::Plot`] and [`GalleryError::Csv`], should memory not suffice.
pub fn files(made: &[Made]) -> Result<Vec<File>, GalleryError> {
    let parts: Vec<_> = made.par_iter().map(of_item).collect::<Result<_, _>>()?;
    Ok(parts.concat())
}

/// What shows all items together: `items.json`, their titles and captions; `agreement.csv`,
/// `agreement.md`; and `index.html`, a page that needs nothing beside it.
///
/// # Errors
/// [`GalleryError::Csv`], should memory not suffice.
pub fn gallery(made: &[Made]) -> Result<Vec<File>, GalleryError> {
    let file = |name: &str, contents| File { name: name.into(), contents };
    Ok(vec![
        file("items.json", serde_json::to_vec_pretty(&items(made))?),
        file("agreement.csv", agreement::csv(made)?),
        file("agreement.md", agreement::markdown(made).into()),
        file("index.html", page::html(made).into()),
    ])
}

/// Name, title and caption of every item.
fn items(made: &[Made]) -> serde_json::Value {
    let item = |made: &Made| {
        let (item, caption) = (made.item, &made.reproduction.caption);
        serde_json::json!({ "name": item.name, "title": item.title, "caption": caption })
    };
    made.iter().map(item).collect()
}

fn of_item(made: &Made) -> Result<Vec<File>, GalleryError> {
    let (name, reproduction) = (made.item.name, &made.reproduction);
    let file = |ending, contents| File { name: format!("{name}.{ending}"), contents };
    let mut files = vec![file("csv", reproduction.data.csv()?)];
    if let Some(svg) = &reproduction.svg {
        files.push(file("svg", svg.clone().into_bytes()));
        files.push(file("png", creepage_plot::png(svg)?));
    }
    if let Some(text) = &reproduction.text {
        files.push(file("txt", format!("{text}\n").into_bytes()));
    }
    Ok(files)
}
