//! Error of a report that could not be written.

use std::io;
use std::path::PathBuf;

use creepage_plot::PlotError;

/// Error of a report that could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// A file or directory could not be made.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file or directory.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A file would be written over one that was read.
    #[error("{} would be written over what was read", path.display())]
    OverSource {
        /// The file.
        path: PathBuf,
    },
    /// The numbers could not be put into JSON.
    #[error("cannot make report.json: {0}")]
    Json(#[from] serde_json::Error),
    /// The numbers could not be put into CSV.
    #[error("cannot make a table: {0}")]
    Points(#[from] csv::Error),
    /// The table of a series could not be written.
    #[error("cannot write the series: {0}")]
    Series(#[from] io::Error),
    /// The columns of a series are none that NetCDF takes.
    #[error("cannot define the columns of the NetCDF file")]
    NetCdfDefinition,
    /// The columns of a series do not fit their NetCDF file.
    #[error("cannot write the NetCDF file: {0:?}")]
    NetCdf(netcdf3::WriteError),
    /// The picture could not be turned into pixels.
    #[error(transparent)]
    Picture(#[from] PlotError),
}

impl From<netcdf3::InvalidDataSet> for ReportError {
    // What it holds cannot leave its thread, and only says which of our columns is at fault.
    fn from(_: netcdf3::InvalidDataSet) -> Self {
        Self::NetCdfDefinition
    }
}

impl From<netcdf3::WriteError> for ReportError {
    fn from(error: netcdf3::WriteError) -> Self {
        match error {
            netcdf3::WriteError::IOErrorKind(kind) => Self::Series(kind.into()),
            other => Self::NetCdf(other),
        }
    }
}
