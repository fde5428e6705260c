//! Cases of the full theory of steady rolling to measure others by.

use creepage::rolling::{Creepage, Force};
use serde::Deserialize;

/// A case whose forces are known, each with its uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReferenceCase {
    /// Ratio of the contact's semi-axes.
    pub a_over_b: f64,
    /// Combined Poisson's ratio.
    pub poisson: f64,
    /// Creepage and spin.
    pub creepage: Creepage,
    /// Force and moment on the lower body.
    pub force: Force,
    /// Uncertainty of each component of `force`.
    pub uncertainty: Force,
}

/// The reference cases cannot be read: the file was changed by hand.
#[derive(Debug, thiserror::Error)]
#[error("the reference cases cannot be read")]
pub struct ReferenceError(#[from] csv::Error);

#[derive(Deserialize)]
struct Row {
    a_over_b: f64,
    poisson: f64,
    xi: f64,
    eta: f64,
    chi: f64,
    fx: f64,
    fy: f64,
    mz: f64,
    u_fx: f64,
    u_fy: f64,
    u_mz: f64,
}

impl From<Row> for ReferenceCase {
    fn from(row: Row) -> Self {
        Self {
            a_over_b: row.a_over_b,
            poisson: row.poisson,
            creepage: Creepage { xi: row.xi, eta: row.eta, chi: row.chi },
            force: Force { fx: row.fx, fy: row.fy, mz: row.mz },
            uncertainty: Force { fx: row.u_fx, fy: row.u_fy, mz: row.u_mz },
        }
    }
}

/// 132 cases: `a/b` from 0.2 to 5, spin to 10, computed on square grids and extrapolated; their
/// origin is told in `data/README.md`.
///
/// # Errors
/// [`ReferenceError`] when the table that the library was built with is damaged.
pub fn steady_rolling() -> Result<Vec<ReferenceCase>, ReferenceError> {
    let table = include_str!("../data/steady_rolling.csv");
    let rows = csv::Reader::from_reader(table.as_bytes()).into_deserialize::<Row>();
    Ok(rows.map(|row| row.map(ReferenceCase::from)).collect::<Result<_, _>>()?)
}
