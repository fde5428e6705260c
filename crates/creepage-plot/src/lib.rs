//! Pictures as SVG and PNG: curves over axes, and ellipses seen from above. Nothing here knows what
//! is drawn.
//!
//! Two pictures are made of the same parts. A [`Sheet`] has a title, [`Panel`]s and one legend below
//! them, so that the legend covers nothing; a [`TopView`] has one ellipse with its legend beside it
//! and a table at the foot. A panel is a pair of [`Axis`], and what is drawn over it, in the order
//! in which it is added.
//!
//! ```
//! use creepage_plot::{Axis, Label, Panel, Pen, Sheet};
//! let x = Axis::new([0.0, 6.0], Label::default().symbol("ξ"));
//! let y = Axis::new([0.0, 1.1], Label::default().indexed("f", "x"));
//! let curve = (0..=60).map(|k| 0.1 * f64::from(k)).map(|x| [x, f64::tanh(x)]).collect();
//! let sheet = Sheet::new("A saturating force")
//!     .panel(Panel::new(x, y).curve(curve, Pen::of(0)))
//!     .key(Pen::of(0), Label::new("tanh ").symbol("ξ"));
//! let svg = sheet.svg();
//! assert!(svg.starts_with("<svg") && creepage_plot::png(&svg)?.len() > 1000);
//! # Ok::<(), creepage_plot::PlotError>(())
//! ```

mod animation;
mod axis;
mod bands;
mod boxes;
mod clip;
mod contour;
pub mod format;
mod head;
mod ink;
mod label;
mod legend;
mod mark;
mod names;
mod palette;
mod panel;
mod plane;
mod raster;
mod scene;
mod sheet;
mod table;
pub mod theme;
mod top_view;

pub use animation::{Frames, animated_png};
pub use axis::Axis;
pub use bands::Bands;
pub use boxes::Boxes;
pub use clip::Frame;
pub use contour::{Contour, closed, ellipse, signed_area};
pub use label::Label;
pub use legend::Sample;
pub use mark::{Fill, Mark, Pen, Shape};
pub use panel::Panel;
pub use plane::Arrows;
pub use raster::{PlotError, png};
pub use scene::{Anchor, Point};
pub use sheet::Sheet;
pub use table::{Cell, Table};
pub use top_view::TopView;
