//! Stream of input rows, read by a thread of their own, so that those that are there need not wait for those that are not; and the progress bar of a batch, on a terminal only.

use crate::batch_args::BatchArgs;
use crate::output::{bar, bar_style, is_quiet};
use csv::{ByteRecord, Reader};
use indicatif::ProgressBar;
use std::fs;
use std::io::{self, IsTerminal, Read};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

/// Time between two outputs.
const BEAT: Duration = Duration::from_millis(200);
/// Most rows at a time.
const MAX_ROWS: usize = 1 << 16;

/// A row and how far the table is read, in bytes.
type Read1 = Result<(ByteRecord, u64), csv::Error>;

/// The rows of a table, in portions of about a fifth of a second of work; the first row is a portion
/// of its own.
pub(super) struct Stream {
    rows: Receiver<Read1>,
    size: usize,
    given: Option<Instant>,
    position: u64,
    failed: Option<csv::Error>,
}

impl Stream {
    /// Starts to read.
    pub(super) fn start(mut reader: Reader<Box<dyn Read + Send>>) -> Self {
        let (sender, rows) = sync_channel(MAX_ROWS);
        // It ends with the table, or when nobody listens; waiting for input it ends with the program.
        thread::spawn(move || {
            loop {
                let mut row = ByteRecord::new();
                let read = match reader.read_byte_record(&mut row) {
                    Ok(false) => return,
                    Ok(true) => Ok((row, reader.position().byte())),
                    Err(error) => Err(error),
                };
                let failed = read.is_err();
                if sender.send(read).is_err() || failed {
                    return;
                }
            }
        });
        Self { rows, size: 1, given: None, position: 0, failed: None }
    }

    /// Bytes read of the rows that were given.
    pub(super) fn position(&self) -> u64 {
        self.position
    }

    /// The next rows; none at the end. Rows before a failure are given before it.
    pub(super) fn next(&mut self) -> Result<Vec<ByteRecord>, csv::Error> {
        if let Some(error) = self.failed.take() {
            return Err(error);
        }
        self.fit();
        let mut rows = Vec::new();
        if let Ok(first) = self.rows.recv() {
            self.take(first, &mut rows);
        }
        let end = Instant::now() + BEAT;
        while !rows.is_empty() && rows.len() < self.size && self.failed.is_none() {
            match self.rows.recv_timeout(end.saturating_duration_since(Instant::now())) {
                Ok(row) => self.take(row, &mut rows),
                Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => break,
            }
        }
        self.given = Some(Instant::now());
        match self.failed.take() {
            Some(error) if rows.is_empty() => Err(error),
            failed => {
                self.failed = failed;
                Ok(rows)
            }
        }
    }

    fn take(&mut self, read: Read1, rows: &mut Vec<ByteRecord>) {
        match read {
            Ok((row, position)) => {
                rows.push(row);
                self.position = position;
            }
            Err(error) => self.failed = Some(error),
        }
    }

    /// As many rows as a beat takes, by how long the last ones took.
    fn fit(&mut self) {
        let Some(given) = self.given else { return };
        let taken = given.elapsed();
        self.size = if taken < BEAT / 2 { 4 * self.size } else { self.size };
        self.size = if taken > BEAT { self.size / 2 } else { self.size };
        self.size = self.size.clamp(1, MAX_ROWS);
    }
}

/// A bar over the bytes of the input file, or a count of rows where its size is not known.
/// Hidden when standard error is no terminal, or when the rows themselves run over the screen.
pub(super) fn progress_bar(args: &BatchArgs) -> ProgressBar {
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
