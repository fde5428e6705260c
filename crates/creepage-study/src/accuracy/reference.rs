//! Reference cases of the full theory of steady rolling, by which others are measured.

use creepage::{Contact, Creepage, Ellipse, Force, InvalidValue};
use serde::Deserialize;

/// A case whose forces are known, each with its uncertainty.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceCase {
    /// Shape and Poisson's ratio; like bodies.
    pub contact: Contact,
    /// Creepage and spin.
    pub creepage: Creepage,
    /// Force and moment on the lower body.
    pub force: Force,
    /// Uncertainty of each component of `force`, where it is known.
    pub uncertainty: Option<Force>,
}

/// Error of reading the reference cases: the file was changed by hand.
#[derive(Debug, thiserror::Error)]
pub enum ReferenceError {
    /// Not a table of numbers.
    #[error("the reference cases cannot be read")]
    Table(#[from] csv::Error),
    /// A number out of range.
    #[error("the reference cases cannot be read: {0}")]
    Number(#[from] InvalidValue),
}

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

impl TryFrom<Row> for ReferenceCase {
    type Error = InvalidValue;

    fn try_from(row: Row) -> Result<Self, InvalidValue> {
        Ok(Self {
            contact: Contact::new(Ellipse::from_ratio(row.a_over_b)?, row.poisson)?,
            creepage: Creepage::new(row.xi, row.eta, row.chi)?,
            force: Force { fx: row.fx, fy: row.fy, mz: row.mz },
            uncertainty: Some(Force { fx: row.u_fx, fy: row.u_fy, mz: row.u_mz }),
        })
    }
}

/// 132 cases: `a/b` from 0.2 to 5, spin to 10, computed on square grids and extrapolated; their
/// origin is in `data/README.md`.
///
/// # Errors
/// [`ReferenceError`] when the table that the library was built with is damaged.
pub fn steady_rolling() -> Result<Vec<ReferenceCase>, ReferenceError> {
    let table = include_str!("../../data/steady_rolling.csv");
    let rows = csv::Reader::from_reader(table.as_bytes()).into_deserialize::<Row>();
    rows.map(|row| Ok(ReferenceCase::try_from(row?)?)).collect()
}
