//! Rolling that is not steady: a case file without a creepage, and a table of how the bodies move.

mod case;
mod columns;
mod error;
mod file;
mod picture;
mod progress;
mod run;
mod writer;

pub use case::{HistoryMotion, RollCase};
pub use columns::{History, HistoryRow};
pub use error::HistoryError;
pub use file::{RollFile, roll_json_schema};
pub use picture::{history_picture, to_png};
pub use run::{HISTORY_COLUMNS, HistoryRun};
pub use writer::HistoryWriter;
