//! A ball bearing: its case file, solved and reported.

mod file;
mod report;

pub use file::{BearingCase, BearingCaseError, BearingFile, bearing_json_schema};
pub use report::BearingReport;
