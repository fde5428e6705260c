//! Ball bearings: case file, solution and report.

mod file;
mod report;

pub use file::{BearingCase, BearingCaseError, BearingFile, bearing_json_schema};
pub use report::BearingReport;
