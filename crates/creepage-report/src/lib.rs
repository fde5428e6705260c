//! What a solved case looks like: text for the terminal, JSON, CSV and VTK for programs, and
//! a picture of the contact as SVG and PNG.
//!
//! A [`Report`] is made from one [`Hertz`](creepage::Hertz) contact and the [`Answer`] of one
//! theory; everything else follows from it.
//!
//! ```
//! use creepage::rolling::{Creepage, FieldPoint, Force, Region, Solution, Status, Theory};
//! use creepage::{Ellipse, Hertz, Solid, SolidPair};
//! use creepage_report::{Answer, Report};
//!
//! /// Complete sliding along x: the traction is at its bound everywhere.
//! struct Sliding;
//!
//! impl Theory for Sliding {
//!     fn solve(&self, _: Creepage) -> Solution {
//!         Solution { force: Force { fx: 1.0, fy: 0.0, mz: 0.0 }, status: Status::Solved }
//!     }
//!     fn field(&self, _: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
//!         let bound = |[x, y]: [f64; 2]| (1.0 - x * x - y * y).max(0.0).sqrt(); // a circle
//!         let point = |&position| FieldPoint {
//!             position,
//!             traction: [bound(position), 0.0],
//!             slip: [f64::NAN; 2],
//!             region: Region::Slip,
//!         };
//!         positions.iter().map(point).collect()
//!     }
//! }
//!
//! let steel = Solid::new(82e9, 0.28)?;
//! let circle = Ellipse::new(5e-3, 5e-3)?;
//! let contact = Hertz::from_ellipse(SolidPair::new(steel, steel), circle, 80e3)?;
//! let creepage = Creepage { xi: 9.0, eta: 0.0, chi: 0.0 };
//! let answer = Answer {
//!     creepage,
//!     theory_name: "sliding",
//!     theory: &Sliding,
//!     solution: Sliding.solve(creepage),
//!     points: Sliding.field(creepage, &[[0.0, 0.0]]),
//!     details: Vec::new(),
//! };
//! let report = Report::new(&contact, 0.3, answer)?;
//! assert!((report.json().lower_body.longitudinal_n - 24e3).abs() < 1e-9);
//! println!("{}", report.text());
//! # Ok::<(), creepage::InvalidValue>(())
//! ```

mod contact_json;
mod contact_picture;
mod curve_picture;
mod curves;
mod error;
mod json;
mod points;
mod report;
mod series;
mod statics;
#[cfg(test)]
mod testing;
mod text;
mod vtk;
mod write;

pub use contact_json::{HertzJson, SolidJson, hertz_json};
pub use creepage_theories::Detail;
pub use curves::{Component, Curves};
pub use error::ReportError;
pub use json::{AreasJson, CreepageJson, DetailJson, DimensionlessJson, ForceJson, ReportJson};
pub use report::{Answer, Extras, Report};
pub use series::{SeriesHead, SeriesRow, series_csv, series_json, series_netcdf};
pub use statics::StaticsReport;
pub use text::hertz_text;
pub use write::write_all;
