//! A file that appears under its name when it is whole.

use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// A file under a temporary name beside its own; removed again unless it is finished.
pub(crate) struct PartialFile {
    file: File,
    partial: PathBuf,
    target: PathBuf,
}

impl PartialFile {
    pub(crate) fn create(path: &Path) -> io::Result<Self> {
        // What a link points to is replaced, not the link.
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.into());
        let name = target.file_name().ok_or(ErrorKind::InvalidFilename)?.to_string_lossy();
        let partial = target.with_file_name(format!(".{name}.{}.partial", std::process::id()));
        Ok(Self { file: File::create(&partial)?, partial, target })
    }

    pub(crate) fn file(&mut self) -> &mut File {
        &mut self.file
    }

    /// Where the file is until it is finished.
    pub(crate) fn path(&self) -> &Path {
        &self.partial
    }

    pub(crate) fn finish(&self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.partial, &self.target)?;
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
        // Once finished it has another name, and there is nothing to remove.
        let _ = fs::remove_file(&self.partial);
    }
}
