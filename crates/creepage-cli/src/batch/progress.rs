//! Progress display of a batch, on a terminal only.

use std::fs;
use std::io::{self, IsTerminal};
use std::time::Duration;

use indicatif::ProgressBar;

use crate::batch_args::BatchArgs;
use crate::output::{bar, bar_style, is_quiet};

/// A bar over the bytes of the input file, or a count of rows where its size is not known.
/// Hidden when standard error is no terminal, or when the rows themselves run over the screen.
pub(super) fn of(args: &BatchArgs) -> ProgressBar {
    if is_quiet() || (args.out.is_none() && io::stdout().is_terminal()) {
        return ProgressBar::hidden();
    }
    let size = args.input.as_ref().and_then(|path| fs::metadata(path).ok());
    let bar = match size.filter(fs::Metadata::is_file) {
        Some(data) => bar(data.len(), "{wide_bar} {percent:>3} %  {msg}  {left}"),
        None => ProgressBar::new_spinner().with_style(bar_style("{spinner} {msg}  {elapsed}")),
    };
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
