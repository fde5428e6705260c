//! Where rows go: standard output, or a file that appears when it is whole.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Stdout, Write};
use std::path::Path;

use crate::partial_file::PartialFile;

/// Where rows go.
pub(super) enum Sink {
    Stdout(Stdout),
    /// A pipe or device, which is written to in place.
    Special(File),
    File(PartialFile),
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
            _ => PartialFile::claim(path).map(Self::File),
        }
    }

    /// Gives the file its name.
    pub(super) fn finish(mut self) -> io::Result<()> {
        match &mut self {
            Self::File(file) => file.finish(),
            Self::Stdout(_) | Self::Special(_) => self.flush(),
        }
    }

    fn writer(&mut self) -> &mut dyn Write {
        match self {
            Self::Stdout(stdout) => stdout,
            Self::Special(file) => file,
            Self::File(partial) => partial.file(),
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
