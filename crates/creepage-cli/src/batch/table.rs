//! Input table of a batch: CSV with a header.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::path::{Path, PathBuf};

use csv::{ByteRecord, Reader, ReaderBuilder};

use super::columns::ColumnError;
use crate::failure::Failure;

type Input = Box<dyn Read + Send>;

/// A CSV table of which the header is read.
pub(super) struct Table {
    pub(super) name: String,
    /// Lines that begin with #, above the header.
    pub(super) comments: Vec<u8>,
    pub(super) header: ByteRecord,
    pub(super) delimiter: u8,
    /// The rows; those of a wrong length are answered each, not an end to the table.
    pub(super) reader: Reader<Input>,
}

impl Table {
    /// Opens a file, or standard input, and reads its header.
    pub(super) fn open(path: Option<&Path>) -> Result<Self, Failure> {
        let (name, input): (String, Input) = match path.filter(|path| *path != Path::new("-")) {
            None => ("standard input".into(), Box::new(io::stdin())),
            Some(path) => (path.display().to_string(), Box::new(open(path)?)),
        };
        let mut input = BufReader::with_capacity(1 << 16, input);
        let read = |source: io::Error| Failure::Rows { input: name.clone(), source: source.into() };
        let (comments, mut first) = first_lines(&mut input).map_err(read)?;
        let wrong = |source| Failure::Columns { input: name.clone(), source };
        if first.contains(&0) || first.starts_with(&[0xff, 0xfe]) {
            return Err(wrong(ColumnError::Utf16));
        }
        let delimiter = delimiter(&first);
        // An open quote takes the end of the line into its field.
        if !first.ends_with(b"\n") {
            first.push(b'\n');
        }
        let mut builder = ReaderBuilder::new();
        let whole: Input = Box::new(Cursor::new(first).chain(input));
        let mut reader = builder.flexible(true).delimiter(delimiter).from_reader(whole);
        let header = match reader.byte_headers() {
            Ok(header) => header.clone(),
            Err(source) => return Err(Failure::Rows { input: name, source }),
        };
        if header.is_empty() {
            return Err(wrong(ColumnError::Empty));
        }
        if header.iter().any(goes_on) {
            return Err(wrong(ColumnError::OpenQuote));
        }
        Ok(Self { name, comments, header, delimiter, reader })
    }
}

/// The comments above the header, and its first line.
fn first_lines(input: &mut impl BufRead) -> io::Result<(Vec<u8>, Vec<u8>)> {
    let mut comments = Vec::new();
    loop {
        let mut line = Vec::new();
        input.read_until(b'\n', &mut line)?;
        if !line.starts_with(b"#") {
            return Ok((comments, line));
        }
        comments.append(&mut line);
    }
}

/// Whether a field goes over several lines.
pub(super) fn goes_on(field: &[u8]) -> bool {
    field.iter().any(|byte| b"\r\n".contains(byte))
}

/// What separates the columns: a comma, or where the header has none, a semicolon or a tab.
fn delimiter(header: &[u8]) -> u8 {
    [b',', b';', b'\t'].into_iter().find(|delimiter| header.contains(delimiter)).unwrap_or(b',')
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
