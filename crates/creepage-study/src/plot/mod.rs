//! Pictures of curves and of contacts, for numbers that no report draws by itself.
//!
//! A [`Sheet`] has a title, [`Panel`]s and one key below them, so that the key covers nothing. A
//! panel is a pair of [`Scale`]s, and what is drawn over it, in the order in which it is added.
//!
//! ```
//! use creepage_study::plot::{Label, Panel, Pen, Scale, Sheet};
//! let x = Scale::new([0.0, 6.0], Label::default().symbol("ξ"));
//! let y = Scale::new([0.0, 1.1], Label::default().indexed("f", "x"));
//! let curve = (0..=60).map(|k| 0.1 * f64::from(k)).map(|x| [x, f64::tanh(x)]).collect();
//! let sheet = Sheet::new("A saturating force")
//!     .panel(Panel::new(x, y).curve(curve, Pen::of(0)))
//!     .key(Pen::of(0), Label::new("tanh ").symbol("ξ"));
//! let svg = sheet.svg();
//! assert!(svg.starts_with("<svg") && creepage_study::png(&svg)?.len() > 1000);
//! # Ok::<(), creepage_study::ReportError>(())
//! ```

mod ink;
mod key;
mod panel;
mod scale;
mod sheet;

pub use crate::label::Label;
pub use crate::scene::Anchor;
pub use ink::{Fill, Mark, Pen, Shape};
pub use key::Sample;
pub use panel::Panel;
pub use scale::Scale;
pub use sheet::Sheet;
