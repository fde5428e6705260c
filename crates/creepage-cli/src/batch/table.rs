//! The table of cases that comes in.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use csv::{ByteRecord, Reader, ReaderBuilder};

use super::columns::Columns;
use crate::failure::Failure;

/// A CSV table whose columns have been found to ask for forces.
pub(super) struct Table {
    name: String,
    reader: Reader<Box<dyn Read>>,
    header: ByteRecord,
    columns: Columns,
}

impl Table {
    /// Opens a file, or standard input, and reads its header, to which columns are to be appended.
    pub(super) fn open(
        path: Option<&Path>,
        appended: &'static [&'static str],
    ) -> Result<Self, Failure> {
        let (name, input): (String, Box<dyn Read>) = match path {
            None => ("standard input".into(), Box::new(io::stdin())),
            Some(path) => (path.display().to_string(), Box::new(open(path)?)),
        };
        // Rows of a wrong length are answered each, not an end to the table.
        let mut reader = ReaderBuilder::new().flexible(true).from_reader(input);
        let header = match reader.byte_headers() {
            Ok(header) => header.clone(),
            Err(source) => return Err(Failure::Rows { input: name, source }),
        };
        match Columns::find(&header, appended) {
            Ok(columns) => Ok(Self { name, reader, header, columns }),
            Err(source) => Err(Failure::Columns { input: name, source }),
        }
    }

    pub(super) fn header(&self) -> &ByteRecord {
        &self.header
    }

    pub(super) fn columns(&self) -> Columns {
        self.columns
    }

    /// Bytes read so far.
    pub(super) fn position(&self) -> u64 {
        self.reader.position().byte()
    }

    /// The next rows, at most `count`; none at the end.
    pub(super) fn next_rows(&mut self, count: usize) -> Result<Vec<ByteRecord>, Failure> {
        self.reader
            .byte_records()
            .take(count)
            .collect::<Result<_, _>>()
            .map_err(|source| Failure::Rows { input: self.name.clone(), source })
    }
}

fn open(path: &Path) -> Result<File, Failure> {
    let read = |source| Failure::Read { path: PathBuf::from(path), source };
    let file = File::open(path).map_err(read)?;
    // A directory opens, and fails only when it is read.
    if file.metadata().map_err(read)?.is_dir() {
        return Err(read(io::ErrorKind::IsADirectory.into()));
    }
    Ok(file)
}
