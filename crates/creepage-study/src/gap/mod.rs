//! Contact areas of any shape: a case file with `[gap]` is read, solved and reported.
//!
//! [`GapFile`] is the file, [`GapCase`] its checked numbers, [`SolvedGap`] its solution. The
//! ellipse's way through the same rooms is [`CaseFile`](crate::CaseFile), [`Case`](crate::Case),
//! [`SolvedCase`](crate::SolvedCase).

mod along;
mod case;
mod columns;
mod creepage;
mod curved;
mod error;
mod field;
mod file;
mod json;
mod picture;
mod roller;
mod rows;
mod shape;
mod solve;
mod solver;
mod text;
mod vary;
mod view;

pub use along::Roller;
pub use case::{GapCase, Pressed};
pub use creepage::SiGiven;
pub use curved::CurvedJson;
pub use error::{GapCaseError, GapFileError};
pub(crate) use field::AreaField;
pub use file::{GapFile, gap_json_schema};
pub use json::{
    ExtentJson, GapContactJson, GapCreepageJson, GapForceJson, GapReportJson, PatchJson,
    PressedReportJson,
};
pub(crate) use picture::AreasPicture;
pub use rows::GapRows;
pub(crate) use solve::pressed;
pub use solver::{GapSolver, solve_gap};
pub use text::pressed_text;
pub use vary::{GapValue, GapVaried};
pub(crate) use view::OnAreas;
