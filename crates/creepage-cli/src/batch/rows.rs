//! Rows that go out: as they came, with the answer appended.

use std::io::{self, Write};

use creepage_study::Caution;
use csv::{ByteRecord, Writer, WriterBuilder};

use super::solver::{Answer, Reply};
use super::tally::Tally;

/// What is appended to each row.
const PLAIN: [&str; 5] = ["fx", "fy", "mz", "status", "message"];
/// The same for a theory with error bars.
const WITH_ERRORS: [&str; 8] =
    ["fx", "fy", "mz", "fx_error", "fy_error", "mz_error", "status", "message"];

/// The columns that are appended for a theory with or without error bars.
pub(super) fn answer_columns(error_bars: bool) -> &'static [&'static str] {
    if error_bars { &WITH_ERRORS } else { &PLAIN }
}

/// Writes rows and counts them.
pub(super) struct Rows<W: Write> {
    writer: Writer<W>,
    /// Columns of the input.
    columns: usize,
    error_bars: bool,
    tally: Tally,
}

impl<W: Write> Rows<W> {
    /// Starts the table with its header.
    pub(super) fn start(sink: W, header: &ByteRecord, error_bars: bool) -> io::Result<Self> {
        let mut writer = WriterBuilder::new().buffer_capacity(1 << 16).from_writer(sink);
        let names =
            header.iter().chain(answer_columns(error_bars).iter().map(|name| name.as_bytes()));
        writer.write_record(names).map_err(into_io)?;
        Ok(Self { writer, columns: header.len(), error_bars, tally: Tally::default() })
    }

    /// Writes one row. One of a wrong length is filled up or cut, so that the answer stands in
    /// its columns.
    pub(super) fn write(&mut self, mut row: ByteRecord, answer: &Answer) -> io::Result<()> {
        row.truncate(self.columns);
        while row.len() < self.columns {
            row.push_field(b"");
        }
        for field in self.fields(answer) {
            row.push_field(field.as_bytes());
        }
        self.writer.write_byte_record(&row).map_err(into_io)?;
        self.tally.count(answer);
        Ok(())
    }

    /// The answer's fields; numbers in the shortest form that reads back as the same number.
    fn fields(&self, answer: &Answer) -> Vec<String> {
        let numbers = if self.error_bars { 6 } else { 3 };
        match answer {
            Ok(Reply { solution, cautions }) => {
                let forces = [Some(solution.force), solution.error];
                let numbers = forces.into_iter().flatten().flat_map(|f| f.components());
                let words = [solution.status.name().into(), Caution::words(cautions)];
                numbers.map(|f| format!("{f:?}")).chain(words).collect()
            }
            Err(error) => {
                let words = ["invalid".into(), error.to_string()];
                vec![String::new(); numbers].into_iter().chain(words).collect()
            }
        }
    }

    /// What has been written so far.
    pub(super) fn tally(&self) -> Tally {
        self.tally
    }

    pub(super) fn finish(mut self) -> io::Result<Tally> {
        self.writer.flush()?;
        Ok(self.tally)
    }
}

/// The error of the sink itself: whether its reader has gone must not be lost in wrapping.
fn into_io(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(source) => source,
        other => io::Error::other(format!("{other:?}")),
    }
}
