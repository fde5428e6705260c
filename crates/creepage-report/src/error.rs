//! Why a report could not be written.

use std::io;
use std::path::PathBuf;

use resvg::usvg;

/// Why a report could not be written.
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
    /// The numbers could not be put into JSON.
    #[error("cannot make report.json: {0}")]
    Json(#[from] serde_json::Error),
    /// The numbers could not be put into CSV.
    #[error("cannot make a table: {0}")]
    Points(#[from] csv::Error),
    /// The picture could not be read back for rasterising.
    #[error("cannot read the picture back: {0}")]
    Picture(#[from] usvg::Error),
    /// The picture could not be turned into pixels.
    #[error("cannot make a picture of {width} x {height} pixels")]
    Pixels {
        /// Width (pixels).
        width: u32,
        /// Height (pixels).
        height: u32,
    },
}
