//! Destination of batch rows: a file that appears when it is whole, or standard output.

use std::io::{self, Stdout, Write};
use std::path::Path;

use creepage_study::WholeFile;

/// Destination of rows.
pub(super) enum Sink {
    Stdout(Stdout),
    File(WholeFile),
}

impl Sink {
    pub(super) fn open(out: Option<&Path>) -> io::Result<Self> {
        out.map_or_else(
            || Ok(Self::Stdout(io::stdout())),
            |path| WholeFile::create(path).map(Self::File),
        )
    }

    pub(super) fn finish(self) -> io::Result<()> {
        match self {
            Self::Stdout(mut stdout) => stdout.flush(),
            Self::File(file) => file.finish(),
        }
    }

    fn writer(&mut self) -> &mut dyn Write {
        match self {
            Self::Stdout(stdout) => stdout,
            Self::File(file) => file,
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
