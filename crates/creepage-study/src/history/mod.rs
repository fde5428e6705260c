//! Rolling that is not steady: a case file without a creepage, and a table of how the bodies move.

mod animation;
mod build;
mod case;
mod columns;
mod error;
mod file;
mod picture;
mod progress;
mod roller;
mod run;
mod stepper;
mod trace;
mod view;
mod writer;

pub use case::RollCase;
pub use columns::{History, HistoryRow};
pub use error::{HistoryError, MotionError};
pub use file::{RollFile, RollStart, roll_json_schema};
pub use picture::{history_animation, history_picture, to_png};
pub use roller::HistoryMotion;
pub use run::{HISTORY_COLUMNS, HistoryRun};
pub use stepper::RollStepper;
pub use writer::HistoryWriter;
