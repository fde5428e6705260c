//! Output streams: data to standard output, messages to standard error.

use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::builder::Styles;
use creepage_study::ReportError;
use indicatif::{HumanDuration, ProgressBar, ProgressState, ProgressStyle};
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

/// Whether `--quiet` was given: set once, before the work.
static QUIET: AtomicBool = AtomicBool::new(false);

/// Says nothing but errors from here on.
pub(crate) fn be_quiet() {
    QUIET.store(true, Ordering::Relaxed);
}

pub(crate) fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Tells the user something; a closed standard error is no reason to stop.
pub(crate) fn say(words: &str) {
    if !is_quiet() {
        let _ = writeln!(io::stderr().lock(), "{words}");
    }
}

/// Tells the user what went wrong, in the colours of wrong command lines.
pub(crate) fn complain(words: &str) {
    let styles = Styles::styled();
    let red = styles.get_error();
    let _ = writeln!(anstream::stderr().lock(), "{red}error:{red:#} {words}");
}

/// Tells which files were written.
pub(crate) fn say_written(paths: &[PathBuf]) {
    for path in paths {
        say(&format!("wrote {}", path.display()));
    }
}

/// A bar over so many steps, on a terminal only.
pub(crate) fn bar(steps: u64, template: &str) -> ProgressBar {
    if is_quiet() {
        return ProgressBar::hidden();
    }
    ProgressBar::new(steps).with_style(bar_style(template))
}

/// How a bar looks that shows progress on a terminal; `{left}` is the time left, once there is
/// progress to tell it by.
pub(crate) fn bar_style(template: &str) -> ProgressStyle {
    let left = |state: &ProgressState, text: &mut dyn std::fmt::Write| {
        if state.pos() > 0 {
            // A bar that cannot be drawn is no failure.
            let _ = write!(text, "{:#} left", HumanDuration(state.eta()));
        }
    };
    ProgressStyle::with_template(template)
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .with_key("left", left)
}
