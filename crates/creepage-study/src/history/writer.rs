//! Writer of `history.csv`, with what it needs to go on after an interruption.
//!
//! Rows go to `history.csv.partial`; beside it `history.state` has the state of the contact after some
//! row and how long the table was then. A run with the same case and the same history goes on from
//! there. The partial table gets its name when it is whole, and the state goes.

use std::fs::{self, File, TryLockError};
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::error::HistoryError;
use super::run::{HISTORY_COLUMNS, HistoryRun};
use crate::atomic_file::{WholeFile, sync_directory_of};
use crate::error::ReportError;
use crate::sources::keep_foreign;

/// Between two times that the state is written.
const PAUSE: Duration = Duration::from_secs(2);
const MAGIC: &[u8; 16] = b"creepage history";

/// The table of a history that is being written to a directory.
#[derive(Debug)]
pub struct HistoryWriter {
    file: File,
    partial: PathBuf,
    state: PathBuf,
    target: PathBuf,
    /// Tells a case and its history from others.
    key: u32,
    length: u64,
    saved: Instant,
}

impl HistoryWriter {
    /// The name of the table.
    pub const NAME: &str = "history.csv";

    /// Begins the table, or goes on with the one of an earlier run of the same `texts`: all that tells the case, and
    /// that of the history; the run is then taken to where it was.
    ///
    /// # Errors
    /// [`ReportError::Write`] for a directory that cannot be written to, or where other files have the
    /// names of the partial table or of the state, `Ok(Err)` while another run
    /// writes there.
    pub fn open(
        directory: &Path,
        texts: [&str; 2],
        run: &mut HistoryRun,
    ) -> Result<Result<Self, HistoryError>, ReportError> {
        fs::create_dir_all(directory).map_err(failure(directory))?;
        let [target, partial, state] =
            [Self::NAME, "history.csv.partial", "history.state"].map(|name| directory.join(name));
        if target.is_dir() {
            return Err(failure(&target)(io::ErrorKind::IsADirectory.into()));
        }
        let header = format!("{}\n", HISTORY_COLUMNS.join(","));
        keep_foreign(&partial, header.as_bytes()).map_err(failure(&partial))?;
        keep_foreign(&state, MAGIC).map_err(failure(&state))?;
        let options = File::options().read(true).write(true).create(true).truncate(false).clone();
        let file = options.open(&partial).map_err(failure(&partial))?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Ok(Err(HistoryError::Busy)),
            Err(TryLockError::Error(error)) => return Err(failure(&partial)(error)),
        }
        let words = format!("{}\0{}\0{}", env!("CARGO_PKG_VERSION"), texts[0], texts[1]);
        let key = crc32fast::hash(words.as_bytes());
        let mut writer =
            Self { file, partial, state, target, key, length: 0, saved: Instant::now() };
        writer.begin(run).map_err(failure(&writer.partial.clone()))?;
        Ok(Ok(writer))
    }

    fn begin(&mut self, run: &mut HistoryRun) -> io::Result<()> {
        if let Some(length) = self.resume(run)? {
            self.length = length;
            self.file.set_len(length)?;
            self.file.seek(SeekFrom::Start(length))?;
            return Ok(());
        }
        self.file.set_len(0)?;
        self.file.seek(SeekFrom::Start(0))?;
        self.line(&HISTORY_COLUMNS.join(","))
    }

    /// The length of the table up to which an earlier run had come.
    fn resume(&self, run: &mut HistoryRun) -> io::Result<Option<u64>> {
        let Ok(bytes) = fs::read(&self.state) else { return Ok(None) };
        let Some((head, state)) = bytes.split_at_checked(36) else { return Ok(None) };
        let number = |from: usize| {
            let mut bytes = [0; 8];
            bytes.copy_from_slice(&head[from..from + 8]);
            u64::from_le_bytes(bytes)
        };
        let is_ours = head[..16] == MAGIC[..] && head[16..20] == self.key.to_le_bytes();
        let (rows, length) = (number(20), number(28));
        let is_there = self.file.metadata()?.len() >= length;
        let rows = usize::try_from(rows).unwrap_or(usize::MAX);
        Ok((is_ours && is_there && run.resume(rows, state)).then_some(length))
    }

    /// Adds a row; now and then the state too.
    ///
    /// # Errors
    /// [`ReportError::Write`].
    pub fn write(&mut self, record: &[String], run: &HistoryRun) -> Result<(), ReportError> {
        self.line(&record.join(",")).map_err(failure(&self.partial))?;
        if self.saved.elapsed() > PAUSE {
            self.save(run).map_err(failure(&self.state))?;
            self.saved = Instant::now();
        }
        Ok(())
    }

    fn line(&mut self, line: &str) -> io::Result<()> {
        self.file.write_all(format!("{line}\n").as_bytes())?;
        self.length += line.len() as u64 + 1;
        Ok(())
    }

    fn save(&self, run: &HistoryRun) -> io::Result<()> {
        self.file.sync_data()?;
        let mut file = WholeFile::create(&self.state)?;
        file.write_all(MAGIC)?;
        file.write_all(&self.key.to_le_bytes())?;
        file.write_all(&(run.done() as u64).to_le_bytes())?;
        file.write_all(&self.length.to_le_bytes())?;
        file.write_all(&run.state())?;
        file.finish()
    }

    /// Gives the whole table its name.
    ///
    /// # Errors
    /// [`ReportError::Write`].
    pub fn finish(self) -> Result<PathBuf, ReportError> {
        let done = || -> io::Result<()> {
            self.file.sync_all()?;
            fs::rename(&self.partial, &self.target)?;
            if self.state.exists() {
                fs::remove_file(&self.state)?;
            }
            sync_directory_of(&self.target)
        };
        done().map_err(failure(&self.target))?;
        Ok(self.target.clone())
    }
}

fn failure(path: &Path) -> impl FnOnce(io::Error) -> ReportError {
    let path = path.to_owned();
    move |source| ReportError::Write { path, source }
}
