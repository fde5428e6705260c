//! Output table of a batch: the input rows, each with its answer appended, to a file that appears when it is whole, or to standard output.

use super::columns::NoCase;
use super::row_query::RowQuery;
use super::tally::Tally;
use creepage::Status;
use creepage_study::{BulkAnswer, Caution, DamageWanted, Reply, WholeFile};
use csv::{ByteRecord, Writer, WriterBuilder};
use std::error::Error;
use std::io::{self, Stdout, Write};
use std::path::Path;

/// A row's answer: the reply to what it asked.
pub(super) type Answer = Result<(RowQuery, Reply), NoCase>;

/// Columns appended to a row of areas of any shape or of a wheelset.
pub(super) struct RowAnswer {
    pub(super) numbers: Vec<f64>,
    pub(super) status: Status,
    pub(super) message: String,
}

/// Writes rows and counts them.
pub(super) struct Rows<W: Write> {
    writer: Writer<W>,
    /// Columns of the input.
    columns: usize,
    /// Columns that are appended.
    appended: usize,
    damage: Option<DamageWanted>,
    tally: Tally,
}

impl<W: Write> Rows<W> {
    /// Starts the table with its header.
    pub(super) fn start(
        sink: W,
        header: &ByteRecord,
        appended: &[&str],
        delimiter: u8,
    ) -> io::Result<Self> {
        let mut builder = WriterBuilder::new();
        let mut writer = builder.buffer_capacity(1 << 16).delimiter(delimiter).from_writer(sink);
        let names = header.iter().chain(appended.iter().map(|name| name.as_bytes()));
        writer.write_record(names).map_err(into_io)?;
        let (columns, appended) = (header.len(), appended.len());
        Ok(Self { writer, columns, appended, damage: None, tally: Tally::default() })
    }

    /// The same with wear and fatigue numbers by these laws.
    pub(super) fn with_damage(self, damage: Option<DamageWanted>) -> Self {
        Self { damage, ..self }
    }

    /// Writes one row. One of a wrong length is filled up or cut, so that the answer stands in
    /// its columns.
    pub(super) fn write(&mut self, mut row: ByteRecord, answer: Answer) -> io::Result<()> {
        self.fit(&mut row);
        match answer {
            Ok((asked, reply)) => self.push_reply(&mut row, &asked, reply),
            Err(error) => self.push_error(&mut row, &error),
        }
        self.writer.write_byte_record(&row).map_err(into_io)
    }

    /// The same for rows of areas of any shape and of wheelsets.
    pub(super) fn write_answer(
        &mut self,
        mut row: ByteRecord,
        answer: Result<RowAnswer, impl Error>,
    ) -> io::Result<()> {
        self.fit(&mut row);
        match answer {
            Ok(RowAnswer { numbers, status, message }) => {
                // What a row does not have is empty.
                for number in numbers {
                    let text = if number.is_nan() { String::new() } else { format!("{number:?}") };
                    row.push_field(text.as_bytes());
                }
                row.push_field(status.name().as_bytes());
                row.push_field(message.as_bytes());
                self.tally.count_status(Some(status));
            }
            Err(error) => self.push_error(&mut row, &error),
        }
        self.writer.write_byte_record(&row).map_err(into_io)
    }

    fn fit(&self, row: &mut ByteRecord) {
        row.truncate(self.columns);
        while row.len() < self.columns {
            row.push_field(b"");
        }
    }

    fn push_error(&mut self, row: &mut ByteRecord, error: &dyn Error) {
        for _ in 0..self.appended.saturating_sub(2) {
            row.push_field(b"");
        }
        row.push_field(b"invalid");
        row.push_field(error.to_string().as_bytes());
        self.tally.count_status(None);
    }

    /// The answer's fields; numbers in the shortest form that reads back as the same number.
    fn push_reply(&mut self, row: &mut ByteRecord, asked: &RowQuery, reply: Reply) {
        let mut number = |value: f64| row.push_field(format!("{value:?}").as_bytes());
        let reply = match asked {
            RowQuery::Dimensionless(_) => reply,
            RowQuery::Case(asked) => {
                let answer = BulkAnswer::new(asked.clone(), reply);
                answer.numbers(self.damage.as_ref()).for_each(&mut number);
                answer.reply
            }
        };
        let forces = [Some(reply.solution.force), reply.solution.error];
        forces.into_iter().flatten().flat_map(|force| force.components()).for_each(number);
        row.push_field(reply.solution.status.name().as_bytes());
        row.push_field(Caution::words(&reply.cautions).as_bytes());
        self.tally.count(Ok(&reply));
    }

    /// Hands over what was written.
    pub(super) fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()
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
