//! File of a table: NetCDF (classic format), which xarray, MATLAB and ncdump open.
//!
//! The last variable, `checksum`, is the CRC-32 of all bytes before it: a file that was cut
//! short, changed, or saved again by another program is distinguished from a whole one before any of it
//! is believed.

use std::cell::RefCell;
use std::io::{self, Cursor, Seek, SeekFrom, Write};
use std::rc::Rc;

use netcdf3::{DataSet, FileReader, FileWriter, InvalidDataSet, ReadError, Version, WriteError};

use super::axis::Axis;
use super::in_memory::{Provenance, Table};
use super::measure::{Accuracy, Spread};
use super::spec::Spec;
use super::values::{Intervals, Values};

/// Error of bytes that are not a table, or of a table that cannot be laid out as bytes.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// The bytes are not those that were written, or never were a table.
    #[error("it is no table of creep force, or it is damaged: its checksum does not fit")]
    Damaged,
    /// NetCDF that is not laid out as a table.
    #[error("it is no table of creep force: `{0}` is missing or of another kind")]
    Missing(&'static str),
    /// A table of another format.
    #[error(
        "its format is number {found}, and this program reads number {FORMAT}: build the table \
             again"
    )]
    Format {
        /// Number of the format; files of the first say nothing of it.
        found: i32,
    },
    /// Numbers that no table has.
    #[error("it is no table of creep force: its numbers make no sense")]
    Senseless,
    /// The NetCDF library does not take the table, as when its provenance is no plain text.
    #[error("it cannot be laid out as NetCDF")]
    Unfit,
}

impl From<WriteError> for FileError {
    fn from(_: WriteError) -> Self {
        Self::Unfit
    }
}

impl From<InvalidDataSet> for FileError {
    fn from(_: InvalidDataSet) -> Self {
        Self::Unfit
    }
}

/// The layout and the meaning of a file's numbers; another number for any change of either.
const FORMAT: i32 = 2;
const DIMENSIONS: [&str; 5] = ["poisson", "a_over_b", "theta", "phi", "t"];
const FORCES: [(&str, &str, &str); 3] = [
    ("fx", "mu N", "longitudinal force on the lower body"),
    ("fy", "mu N", "lateral force on the lower body"),
    ("mz", "mu N c", "moment on the lower body, c = sqrt(a b)"),
];
const ERRORS: [&str; 4] = ["median", "p95", "p99", "worst"];
const COMMENT: &str = "u = (sx xi, sy eta, sz chi) with, for q = a/b, \
    sx = 0.5 q^(3/2) + 0.5 q^(-1/4), sy = 0.7 q + 0.3/q, sz = 0.5 q^(3/2) + 0.5 q^(-1/2); \
    u = r (sin theta cos phi, sin theta sin phi, cos theta); t = r/(2 + r). \
    Signs of xi and fx change together; those of eta, chi, fy and mz do.";

impl Table {
    /// The bytes of the table's file.
    ///
    /// # Errors
    /// [`FileError::Unfit`] when the provenance is not plain text.
    pub fn to_bytes(&self) -> Result<Vec<u8>, FileError> {
        let definition = self.definition()?;
        let buffer = Buffer::default();
        let mut file = FileWriter::open_seek_write("table", Box::new(buffer.clone()))?;
        file.set_def(&definition, Version::Offset64Bit, 0)?;
        for (name, nodes) in DIMENSIONS.into_iter().zip(self.node_values()) {
            file.write_var_f64(name, &nodes)?;
        }
        for (i, (name, ..)) in FORCES.into_iter().enumerate() {
            let all = self.blocks.iter().flat_map(|block| &block.forces);
            file.write_var_f64(name, &all.map(|force| force[i]).collect::<Vec<_>>())?;
        }
        let gains: Vec<f64> =
            self.blocks.iter().flat_map(|block| block.gains.as_flattened()).copied().collect();
        file.write_var_f64("gain", &gains)?;
        let whole = |count: usize| i32::try_from(count).unwrap_or(i32::MAX);
        let doubtful: Vec<i32> = self.blocks.iter().map(|block| whole(block.doubtful)).collect();
        file.write_var_i32("doubtful", &doubtful)?;
        file.write_var_i32("checksum", &[0])?;
        file.close()?;
        sealed(buffer.0.take().into_inner())
    }

    /// The values of the nodes along each dimension.
    fn node_values(&self) -> [Vec<f64>; 5] {
        let Intervals { theta, phi, t } = self.intervals;
        let [theta_axis, phi_axis] = [self.intervals.theta_axis(), self.intervals.phi_axis()];
        [
            self.poisson.shares().map(|share| self.poisson.even(share)).collect(),
            self.a_over_b.shares().map(|share| self.a_over_b.geometric(share)).collect(),
            (0..=theta).map(|k| theta_axis.node(k)).collect(),
            (0..=phi).map(|k| phi_axis.node(k)).collect(),
            (0..=t).map(|k| k as f64 / t as f64).collect(),
        ]
    }

    fn definition(&self) -> Result<DataSet, InvalidDataSet> {
        let mut set = DataSet::new();
        let Provenance { theory, options, program } = &self.provenance;
        for (name, text) in [
            ("title", "Creep force of two elastic bodies in rolling contact"),
            ("Conventions", "CF-1.8"),
            ("source", program),
            ("theory", theory),
            ("options", options),
            ("comment", COMMENT),
        ] {
            if !text.is_empty() {
                set.add_global_attr_string(name, text)?;
            }
        }
        set.add_global_attr_i32("format", vec![FORMAT])?;
        let Accuracy { places, hard_places, .. } = self.accuracy;
        for (name, count) in [("error_places", places), ("error_hard_places", hard_places)] {
            set.add_global_attr_i32(name, vec![i32::try_from(count).unwrap_or(i32::MAX)])?;
        }
        for (what, spread) in [("force", self.accuracy.force), ("moment", self.accuracy.moment)] {
            let Spread { median, p95, p99, worst } = spread;
            for (name, value) in ERRORS.into_iter().zip([median, p95, p99, worst]) {
                set.add_global_attr_f64(&format!("{what}_error_{name}"), vec![value])?;
            }
        }
        for (name, nodes) in DIMENSIONS.into_iter().zip(self.node_values()) {
            set.add_fixed_dim(name, nodes.len())?;
        }
        set.add_fixed_dim("of", 3)?;
        set.add_fixed_dim("by", 3)?;
        variables(&mut set)?;
        Ok(set)
    }

    /// Reads a table from the bytes of its file.
    ///
    /// # Errors
    /// [`FileError`] when they are not a whole table.
    pub fn from_bytes(bytes: Vec<u8>) -> Result<Self, FileError> {
        let size = bytes.len();
        let (body, sum) = bytes.split_last_chunk::<4>().ok_or(FileError::Damaged)?;
        if crc32fast::hash(body) != u32::from_be_bytes(*sum) {
            return Err(FileError::Damaged);
        }
        let file = FileReader::open_seek_read("table", Box::new(Cursor::new(bytes)));
        let mut file = file.map_err(|_: ReadError| FileError::Damaged)?;
        check_format(&file)?;
        let (axes, intervals) = layout(&mut file, size)?;
        let blocks = blocks(&mut file, axes[0].nodes * axes[1].nodes, intervals)?;
        let (provenance, accuracy) = (provenance(&file), accuracy(&file)?);
        Ok(Self::new(provenance, axes, intervals, blocks, accuracy))
    }
}

/// Variables, with what they mean; the checksum last.
fn variables(set: &mut DataSet) -> Result<(), InvalidDataSet> {
    let meanings = [
        ("poisson", "1", "combined Poisson's ratio"),
        ("a_over_b", "1", "semi-axis along over semi-axis across the rolling direction"),
        ("theta", "rad", "from pure spin to no spin"),
        ("phi", "rad", "from -eta over xi to eta"),
        ("t", "1", "size of creepage and spin, from zero (0) to infinity (1)"),
    ];
    for (name, units, meaning) in meanings {
        set.add_var_f64(name, &[name])?;
        set.add_var_attr_string(name, "units", units)?;
        set.add_var_attr_string(name, "long_name", meaning)?;
    }
    for (name, units, meaning) in FORCES {
        set.add_var_f64(name, &DIMENSIONS)?;
        set.add_var_attr_string(name, "units", units)?;
        set.add_var_attr_string(name, "long_name", meaning)?;
    }
    set.add_var_f64("gain", &["poisson", "a_over_b", "of", "by"])?;
    let meaning = "derivative of (fx, fy, mz) by (xi, eta, chi) at zero";
    set.add_var_attr_string("gain", "long_name", meaning)?;
    set.add_var_i32("doubtful", &["poisson", "a_over_b"])?;
    let meaning = "number of nodes that the theory does not call solved";
    set.add_var_attr_string("doubtful", "long_name", meaning)?;
    let scalar: [&str; 0] = [];
    set.add_var_i32("checksum", &scalar)?;
    set.add_var_attr_string("checksum", "long_name", "CRC-32 of all bytes before it")
}

/// Puts the checksum of all other bytes into the last four.
fn sealed(mut bytes: Vec<u8>) -> Result<Vec<u8>, FileError> {
    let (body, sum) = bytes.split_last_chunk_mut::<4>().ok_or(FileError::Damaged)?;
    *sum = crc32fast::hash(body).to_be_bytes();
    Ok(bytes)
}

/// Bytes that are still at hand when the writer of the format is done with them.
#[derive(Clone, Default)]
struct Buffer(Rc<RefCell<Cursor<Vec<u8>>>>);

impl Write for Buffer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Buffer {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.0.borrow_mut().seek(to)
    }
}

fn check_format(file: &FileReader) -> Result<(), FileError> {
    let found = file.data_set().get_global_attr_i32("format").and_then(|one| one.first());
    let found = found.copied().unwrap_or(1);
    if found == FORMAT { Ok(()) } else { Err(FileError::Format { found }) }
}

/// The axes of a file of `size` bytes, if they make sense.
fn layout(file: &mut FileReader, size: usize) -> Result<([Axis; 2], Intervals), FileError> {
    let [poisson, a_over_b] = [axis(file, "poisson")?, axis(file, "a_over_b")?];
    let count = |name| file.data_set().dim_size(name).ok_or(FileError::Missing(name));
    let [theta, phi, t] = [count("theta")?, count("phi")?, count("t")?];
    let intervals = Intervals {
        theta: theta.saturating_sub(1),
        phi: phi.saturating_sub(1),
        t: t.saturating_sub(1),
    };
    let provenance = Provenance::default();
    let spec = Spec { a_over_b, poisson, intervals, places: 1, provenance };
    spec.check().map_err(|_| FileError::Senseless)?;
    let bytes = 3 * 8 * intervals.nodes() * a_over_b.nodes * poisson.nodes;
    if bytes > size { Err(FileError::Senseless) } else { Ok(([a_over_b, poisson], intervals)) }
}

fn axis(file: &mut FileReader, name: &'static str) -> Result<Axis, FileError> {
    // A hundred nodes is the most that an axis may have.
    let nodes = file.data_set().var_len(name).filter(|nodes| *nodes <= 100);
    let nodes = nodes.ok_or(FileError::Missing(name))?;
    let values = file.read_var_f64(name).map_err(|_| FileError::Missing(name))?;
    match values[..] {
        [low, .., high] => Ok(Axis { low, high, nodes }),
        [only] => Ok(Axis::fixed(only)),
        [] => Err(FileError::Missing(name)),
    }
}

fn blocks(
    file: &mut FileReader,
    count: usize,
    intervals: Intervals,
) -> Result<Vec<Values>, FileError> {
    let mut column = |name, length: usize| {
        if file.data_set().var_len(name) != Some(length) {
            return Err(FileError::Missing(name));
        }
        let values = file.read_var_f64(name).map_err(|_| FileError::Missing(name))?;
        let sensible = values.iter().all(|value| value.abs() < 1e6);
        if sensible { Ok(values) } else { Err(FileError::Senseless) }
    };
    let nodes = intervals.nodes();
    let [fx, fy, mz] =
        [column("fx", count * nodes)?, column("fy", count * nodes)?, column("mz", count * nodes)?];
    let gains = column("gain", 9 * count)?;
    let doubtful = file.read_var_i32("doubtful").map_err(|_| FileError::Missing("doubtful"))?;
    let block = |k: usize| Values {
        forces: (k * nodes..(k + 1) * nodes).map(|n| [fx[n], fy[n], mz[n]]).collect(),
        gains: [0, 1, 2].map(|i| [0, 1, 2].map(|j| gains[9 * k + 3 * i + j])),
        doubtful: doubtful.get(k).and_then(|n| usize::try_from(*n).ok()).unwrap_or(0),
    };
    Ok((0..count).map(block).collect())
}

fn provenance(file: &FileReader) -> Provenance {
    let text = |name| file.data_set().get_global_attr_as_string(name).unwrap_or_default();
    Provenance { theory: text("theory"), options: text("options"), program: text("source") }
}

fn accuracy(file: &FileReader) -> Result<Accuracy, FileError> {
    let set = file.data_set();
    let count = |name| {
        let count = set.get_global_attr_i32(name).and_then(|one| one.first());
        count.and_then(|count| usize::try_from(*count).ok()).ok_or(FileError::Missing(name))
    };
    let spread = |what| {
        let [median, p95, p99, worst] = ERRORS.map(|name| {
            let values = set.get_global_attr_f64(&format!("{what}_error_{name}"));
            values.and_then(|values| values.first()).copied().unwrap_or(f64::NAN)
        });
        let known = worst.is_finite();
        known.then_some(Spread { median, p95, p99, worst }).ok_or(FileError::Missing("error"))
    };
    Ok(Accuracy {
        places: count("error_places")?,
        hard_places: count("error_hard_places")?,
        force: spread("force")?,
        moment: spread("moment")?,
    })
}
