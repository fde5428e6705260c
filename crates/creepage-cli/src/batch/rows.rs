//! Rows that go out: as they came, with the answer appended.

use std::io::{self, Write};

use csv::{ByteRecord, Writer, WriterBuilder};

use super::solver::Answer;
use super::tally::Tally;
use crate::caution::caution;

/// What is appended to each row.
pub(super) const ANSWER_COLUMNS: [&str; 5] = ["fx", "fy", "mz", "status", "message"];

/// Writes rows and counts them.
pub(super) struct Rows<W: Write> {
    writer: Writer<W>,
    /// Columns of the input.
    columns: usize,
    tally: Tally,
}

impl<W: Write> Rows<W> {
    /// Starts the table with its header.
    pub(super) fn start(sink: W, header: &ByteRecord) -> io::Result<Self> {
        let mut writer = WriterBuilder::new().buffer_capacity(1 << 16).from_writer(sink);
        let names = header.iter().chain(ANSWER_COLUMNS.map(str::as_bytes));
        writer.write_record(names).map_err(into_io)?;
        Ok(Self { writer, columns: header.len(), tally: Tally::default() })
    }

    /// Writes one row. One of a wrong length is filled up or cut, so that the answer stands in
    /// its columns.
    pub(super) fn write(&mut self, mut row: ByteRecord, answer: &Answer) -> io::Result<()> {
        row.truncate(self.columns);
        while row.len() < self.columns {
            row.push_field(b"");
        }
        for field in fields(answer) {
            row.push_field(field.as_bytes());
        }
        self.writer.write_byte_record(&row).map_err(into_io)?;
        self.tally.count(answer);
        Ok(())
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

/// The answer's fields; numbers in the shortest form that reads back as the same number.
fn fields(answer: &Answer) -> [String; 5] {
    match answer {
        Ok(solution) => {
            let [fx, fy, mz] =
                [solution.force.fx, solution.force.fy, solution.force.mz].map(|f| format!("{f:?}"));
            let message = caution(solution.status).unwrap_or_default();
            [fx, fy, mz, solution.status.name().into(), message.into()]
        }
        Err(error) => {
            let nothing = String::new;
            [nothing(), nothing(), nothing(), "invalid".into(), error.to_string()]
        }
    }
}

/// The error of the sink itself: whether its reader has gone must not be lost in wrapping.
fn into_io(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(source) => source,
        other => io::Error::other(format!("{other:?}")),
    }
}
