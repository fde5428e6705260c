//! A file that appears under its name when it is whole.

use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// A file under a temporary name beside its own; removed again unless it is finished.
pub(crate) struct PartialFile {
    file: File,
    partial: PathBuf,
    target: PathBuf,
    finished: bool,
}

impl PartialFile {
    /// Under a name that is this process's own.
    pub(crate) fn create(path: &Path) -> io::Result<Self> {
        let (target, partial) = names(path, &format!(".{}", std::process::id()))?;
        Ok(Self { file: File::create(&partial)?, partial, target, finished: false })
    }

    /// Under a name that is the same in every run: what a run left that was interrupted is
    /// replaced. An error of kind `WouldBlock` while another run has the file.
    pub(crate) fn claim(path: &Path) -> io::Result<Self> {
        let (target, partial) = names(path, "")?;
        loop {
            let file = File::options().write(true).create(true).truncate(false).open(&partial)?;
            // A file system without locks excludes nobody.
            if let Err(TryLockError::WouldBlock) = file.try_lock() {
                return Err(ErrorKind::WouldBlock.into());
            }
            // Before it was ours, another run may have finished it and given it its name.
            if fs::exists(&partial)? {
                file.set_len(0)?;
                return Ok(Self { file, partial, target, finished: false });
            }
        }
    }

    pub(crate) fn file(&mut self) -> &mut File {
        &mut self.file
    }

    /// Where the file is until it is finished.
    pub(crate) fn path(&self) -> &Path {
        &self.partial
    }

    pub(crate) fn finish(&mut self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.partial, &self.target)?;
        self.finished = true;
        sync_directory_of(&self.target)
    }
}

/// Puts the name of a file on the disk.
pub(crate) fn sync_directory_of(path: &Path) -> io::Result<()> {
    // Elsewhere a directory cannot be opened, and a name needs no such care.
    if cfg!(not(unix)) {
        return Ok(());
    }
    let directory = path.parent().filter(|parent| !parent.as_os_str().is_empty());
    File::open(directory.unwrap_or(Path::new(".")))?.sync_all()
}

impl Drop for PartialFile {
    fn drop(&mut self) {
        if !self.finished {
            // Best effort: it is marked as partial by its name.
            let _ = fs::remove_file(&self.partial);
        }
    }
}

/// The file's own name and the temporary one beside it.
fn names(path: &Path, mark: &str) -> io::Result<(PathBuf, PathBuf)> {
    // What a link points to is replaced, not the link.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.into());
    let name = target.file_name().ok_or(ErrorKind::InvalidFilename)?.to_string_lossy();
    let partial = target.with_file_name(format!(".{name}{mark}.partial"));
    Ok((target, partial))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    #[test]
    fn what_an_interrupted_run_left_is_replaced() {
        let place = tempfile::tempdir().unwrap();
        let (path, left) = (place.path().join("out"), place.path().join(".out.partial"));
        fs::write(&left, "rows of an earlier run that was interrupted").unwrap();
        let mut file = PartialFile::claim(&path).unwrap();
        assert_eq!(PartialFile::claim(&path).err().unwrap().kind(), ErrorKind::WouldBlock);
        assert!(left.exists());
        file.file().write_all(b"whole").unwrap();
        file.finish().unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "whole");
        drop(PartialFile::claim(&path).unwrap());
        drop(file);
        assert!(!left.exists() && path.exists());
    }
}
