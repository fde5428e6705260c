//! Contact areas of any shape: a case file with `[gap]` is read, solved and reported.
//!
//! [`GapFile`] is the file, [`GapCase`] its checked numbers; a solution is a [`SolvedCase`](crate::SolvedCase), as that of an
//! ellipse, whose file is [`CaseFile`](crate::CaseFile) and whose numbers are [`Case`](crate::Case).

mod along;
mod case;
mod columns;
mod creepage;
mod curved;
mod error;
mod field;
mod file;
mod picture;
mod roller;
mod rows;
mod shape;
mod solver;
mod text;
mod vary;
mod view;

pub use along::Roller;
pub use case::{GapCase, LoadOrApproach};
pub use creepage::SiGiven;
pub use curved::CurvedJson;
pub use error::{GapCaseError, GapFileError};
pub(crate) use field::AreaField;
pub use file::{GapFile, gap_json_schema};
pub(crate) use picture::AreasPicture;
pub use rows::GapRows;
pub(crate) use shape::Points;
pub(crate) use solver::pressed;
pub use solver::{GapSolver, solve_gap};
pub use text::pressed_text;
pub use vary::{GapValue, GapVaried};
pub(crate) use view::OnAreas;
