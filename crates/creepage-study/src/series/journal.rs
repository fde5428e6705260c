//! Journal of a sweep: a file with a place for every case, from which an interrupted run goes on.
//!
//! A case is given to the system when it is solved: whatever ends the process, only the cases in
//! hand are lost, one a thread. While cases are solved a thread of its own puts what is new on the
//! disk, over and over: a power failure loses no case that was solved before the last two rounds,
//! which take [`PAUSE`] and the disk's own time, some milliseconds, each. A place that was never
//! written, or not wholly, fails its checksum. The file goes when the results are on the disk.

use std::fs::{self, File, TryLockError};
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use creepage::halfspace::harmonics;

use super::record::Record;
use crate::Sweep;
use crate::atomic_file::sync_directory_of;
use crate::sources::keep_foreign;

const MAGIC: &[u8; 12] = b"creepage 1\r\n";
const HEAD: u64 = 20;
/// Between two rounds of writing to the disk.
const PAUSE: Duration = Duration::from_millis(5);

/// The journal of one sweep.
#[derive(Debug)]
pub(super) struct Journal {
    path: PathBuf,
    file: Mutex<File>,
    /// Whether there is something that may not be on the disk.
    is_new: AtomicBool,
    record: usize,
    resumed: bool,
}

impl Journal {
    /// Opens the journal of an earlier run of the same sweep, or begins a new one; `None` while
    /// another process has it. A file that is no journal stays as it is.
    pub(super) fn open(path: &Path, sweep: &Sweep) -> io::Result<Option<Self>> {
        keep_foreign(path, MAGIC)?;
        let options = File::options().read(true).write(true).create(true).truncate(false).clone();
        let mut file = options.open(path)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Ok(None),
            Err(TryLockError::Error(error)) => return Err(error),
        }
        let head = head(sweep);
        let mut found = Vec::new();
        (&mut file).take(HEAD).read_to_end(&mut found)?;
        let resumed = found == head;
        if !resumed {
            file.set_len(0)?;
            file.seek(SeekFrom::Start(0))?;
            file.write_all(&head)?;
            file.sync_all()?;
            sync_directory_of(path)?;
        }
        let unknowns = 2 * harmonics::polynomial_count(sweep.settings.degree);
        Ok(Some(Self {
            path: path.into(),
            file: Mutex::new(file),
            is_new: AtomicBool::new(resumed),
            record: Record::length(unknowns),
            resumed,
        }))
    }

    /// Whether cases of an earlier run may be there.
    pub(super) fn resumed(&self) -> bool {
        self.resumed
    }

    /// The case of that number, if it was solved.
    pub(super) fn read(&self, index: usize) -> io::Result<Option<Record>> {
        let mut file = self.file();
        file.seek(SeekFrom::Start(self.place(index)))?;
        let mut bytes = Vec::with_capacity(self.record);
        (&mut *file).take(self.record as u64).read_to_end(&mut bytes)?;
        Ok(Record::read(index, &bytes))
    }

    pub(super) fn write(&self, index: usize, record: &Record) -> io::Result<()> {
        let bytes = record.bytes(index);
        let mut file = self.file();
        file.seek(SeekFrom::Start(self.place(index)))?;
        file.write_all(&bytes)?;
        self.is_new.store(true, Ordering::Release);
        Ok(())
    }

    /// Does `work` while what it writes goes to the disk. At the end all of it is there.
    pub(super) fn synced(&self, work: impl FnOnce() -> io::Result<()>) -> io::Result<()> {
        let disk = self.file().try_clone()?;
        let (end, ended) = mpsc::channel::<()>();
        thread::scope(|scope| {
            let rounds = scope.spawn(move || {
                while ended.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout) {
                    self.sync(&disk)?;
                }
                self.sync(&disk)
            });
            let worked = work();
            drop(end);
            let synced = rounds.join().unwrap_or_else(|_| Err(io::Error::other("sync")));
            worked.and(synced)
        })
    }

    fn sync(&self, disk: &File) -> io::Result<()> {
        if self.is_new.swap(false, Ordering::Acquire) { disk.sync_data() } else { Ok(()) }
    }

    /// All cases in order; for a journal that is complete.
    pub(super) fn records(&self) -> io::Result<impl Iterator<Item = io::Result<Record>> + use<>> {
        let mut file = BufReader::new(File::open(&self.path)?);
        file.seek(SeekFrom::Start(HEAD))?;
        let mut bytes = vec![0; self.record];
        Ok((0..).map(move |index| {
            file.read_exact(&mut bytes)?;
            Record::read(index, &bytes).ok_or(io::ErrorKind::InvalidData.into())
        }))
    }

    /// Removes the file.
    pub(super) fn remove(self) -> io::Result<()> {
        fs::remove_file(&self.path)
    }

    fn place(&self, index: usize) -> u64 {
        HEAD + index as u64 * self.record as u64
    }

    fn file(&self) -> MutexGuard<'_, File> {
        self.file.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Tells a sweep, and the version of the program, from all others.
fn head(sweep: &Sweep) -> Vec<u8> {
    let words = format!("{} {sweep:?}", env!("CARGO_PKG_VERSION"));
    let length = u32::try_from(words.len()).unwrap_or(u32::MAX);
    let sum = crc32fast::hash(words.as_bytes());
    [&MAGIC[..], &length.to_le_bytes(), &sum.to_le_bytes()].concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sweep(upsilon: &str) -> Sweep {
        let contact = "[contact]\na_over_b = 1\npoisson = 0.28\n";
        Sweep::read(&format!("{contact}[creepage]\nupsilon = {upsilon}")).unwrap()
    }

    fn open(path: &Path, sweep: &Sweep) -> Journal {
        Journal::open(path, sweep).unwrap().unwrap()
    }

    #[test]
    fn another_sweep_starts_anew_and_the_same_goes_on() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("out.csv.journal");
        let (one, two) = (sweep("[1, 2]"), sweep("[1, 3]"));
        let journal = open(&path, &one);
        assert!(!journal.resumed());
        assert!(Journal::open(&path, &one).unwrap().is_none());
        drop(journal);
        assert!(open(&path, &one).resumed());
        assert!(!open(&path, &two).resumed());
        assert_eq!(open(&path, &two).read(0).unwrap(), None);
    }
}
