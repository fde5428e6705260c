//! The tables and figures of Kalker's thesis of 1967, computed again beside what was printed.
//!
//! Every table and figure is an [`Item`] of the [`registry`]. Made, it is a [`Reproduction`]: a
//! picture or a table in words, its numbers as CSV, and one [`Comparison`] for each thing that the
//! thesis says of it. [`reproduce`] makes many of them on all cores, [`files`] turns them into
//! what is written, and [`gallery()`] into one page with the table of agreement.
//!
//! ```
//! use creepage_1967::{Verdict, find};
//! let table = find("table1").ok_or("no such item")?.make()?;
//! assert!(table.agreement.iter().all(|line| line.verdict == Verdict::Agrees));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # To add a figure
//! 1. A file `src/figures/figNN.rs`, named as the thesis numbers it, with one constant and one
//!    function; `figures/fig13.rs` is a short example:
//!    `pub(crate) const ITEM: Item = Item::new("fig13", "title", make);` and
//!    `fn make() -> Result<Reproduction, GalleryError>`.
//! 2. `mod figNN;` and its place in `ITEMS` of `registry.rs`, in the order of the thesis.
//!
//! `make` computes with the theories of the library and gives `Reproduction::figure`:
//! - a [`Sheet`](creepage_plot::Sheet): the panels of `creepage_plot`, drawn with the pens of
//!   colours and axes of `axes.rs` (the full theory looks the same in every figure);
//!   `contact.rs` asks theories for fields, traces areas and draws contacts with headings;
//! - a caption in plain words: the setting (`a/b`, `sigma`, degree, weight), what is seen, what
//!   1967 got right by the full theory; where experiments' points are not in the text of the
//!   thesis, that is said with [`EXPERIMENTS`];
//! - a [`Data`]: all numbers of the picture, a row a point, `curve` or alike in the first column;
//! - a [`Comparison`] for every number and every claim that the text or the caption of the thesis
//!   makes: [`Comparison::number`] with the digits as printed, [`Comparison::claim`] for words.
//!   The verdict is computed. What is not reproduced says why with
//!   [`because`](Comparison::because).
//!
//! Printed numbers that are many go to `data/`, with their origin in `data/README.md`. Results
//! must not depend on the number of threads or on time. `tests/gallery.rs` makes every item and
//! asserts its verdicts: a new item takes one line there.

mod axes;
mod comparison;
mod contact;
mod data;
mod error;
mod figures;
mod item;
mod output;
mod page;
mod points;
mod prelude;
mod registry;
mod rows;
mod tables;
mod theories;

pub use comparison::{Comparison, Verdict};
pub use data::Data;
pub use error::GalleryError;
pub use item::{EXPERIMENTS, Item, Made, Reproduction, reproduce};
pub use output::{File, agreement_text, files, gallery};
pub use page::{Page, PageStyle};
pub use points::{OwnPoints, PointsError};
pub use registry::{find, registry};
pub use rows::{ROWS, rows, states};
