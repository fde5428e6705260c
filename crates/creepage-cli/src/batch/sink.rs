//! Where rows go: standard output, or a file that appears when it is whole.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Stdout, Write};
use std::path::{Path, PathBuf};

/// Where rows go.
pub(super) enum Sink {
    Stdout(Stdout),
    /// A pipe or device, which is written to in place.
    Special(File),
    File(PartialFile),
}

/// A file under a temporary name beside its own; removed again unless it is finished.
pub(super) struct PartialFile {
    file: File,
    partial: PathBuf,
    target: PathBuf,
}

impl Sink {
    pub(super) fn open(out: Option<&Path>) -> io::Result<Self> {
        let Some(path) = out else {
            return Ok(Self::Stdout(io::stdout()));
        };
        match fs::metadata(path) {
            Ok(data) if data.is_dir() => Err(ErrorKind::IsADirectory.into()),
            Ok(data) if !data.is_file() => {
                File::options().write(true).open(path).map(Self::Special)
            }
            _ => PartialFile::create(path).map(Self::File),
        }
    }

    /// Gives the file its name.
    pub(super) fn finish(mut self) -> io::Result<()> {
        match &self {
            Self::File(file) => file.finish(),
            Self::Stdout(_) | Self::Special(_) => self.flush(),
        }
    }

    fn writer(&mut self) -> &mut dyn Write {
        match self {
            Self::Stdout(stdout) => stdout,
            Self::Special(file) | Self::File(PartialFile { file, .. }) => file,
        }
    }
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer().flush()
    }
}

impl PartialFile {
    fn create(path: &Path) -> io::Result<Self> {
        // What a link points to is replaced, not the link.
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.into());
        let name = target.file_name().ok_or(ErrorKind::InvalidFilename)?.to_string_lossy();
        let partial = target.with_file_name(format!(".{name}.{}.partial", std::process::id()));
        Ok(Self { file: File::create(&partial)?, partial, target })
    }

    fn finish(&self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.partial, &self.target)
    }
}

impl Drop for PartialFile {
    fn drop(&mut self) {
        // Once finished it has another name, and there is nothing to remove.
        let _ = fs::remove_file(&self.partial);
    }
}
