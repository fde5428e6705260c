//! How far a batch has come, shown on a terminal only.

use std::fs;
use std::io::{self, IsTerminal};
use std::time::Duration;

use indicatif::ProgressBar;

use crate::args::BatchArgs;
use crate::output::bar_style;

/// A bar over the bytes of the input file, or a count of rows where its size is not known.
/// Hidden when standard error is no terminal, or when the rows themselves run over the screen.
pub(super) fn bar(args: &BatchArgs) -> ProgressBar {
    if args.out.is_none() && io::stdout().is_terminal() {
        return ProgressBar::hidden();
    }
    let size = args.input.as_ref().and_then(|path| fs::metadata(path).ok());
    let bar = match size.filter(fs::Metadata::is_file) {
        Some(data) => ProgressBar::new(data.len())
            .with_style(bar_style("{wide_bar} {percent:>3} %  {msg}  {eta} left")),
        None => ProgressBar::new_spinner().with_style(bar_style("{spinner} {msg}  {elapsed}")),
    };
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
