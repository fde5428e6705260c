//! Data to standard output, words to standard error.

use std::io::{self, Write};
use std::path::PathBuf;

use creepage_study::ReportError;
use indicatif::ProgressStyle;
use serde::Serialize;

use crate::failure::Failure;

/// Prints data.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    stdout
        .write_all(text.as_bytes())
        .and_then(|()| if text.ends_with('\n') { Ok(()) } else { stdout.write_all(b"\n") })
        .and_then(|()| stdout.flush())
        .map_err(Failure::Stdout)
}

/// Data as JSON for people and programs.
pub(crate) fn to_json(data: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(data).map_err(|error| ReportError::from(error).into())
}

/// Tells the user something; a closed standard error is no reason to stop.
pub(crate) fn say(words: &str) {
    let _ = writeln!(io::stderr().lock(), "{words}");
}

/// Tells which files were written.
pub(crate) fn say_written(paths: &[PathBuf]) {
    for path in paths {
        say(&format!("wrote {}", path.display()));
    }
}

/// How a bar looks that shows progress on a terminal.
pub(crate) fn bar_style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
