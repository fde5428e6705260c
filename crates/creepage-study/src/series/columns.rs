//! The columns of a series, the same in every format.

use Cell::{Count, Real};

use super::SeriesRow;

/// A number of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Cell {
    Real(f64),
    Count(usize),
}

/// One column of numbers.
pub(super) struct Column {
    pub(super) name: &'static str,
    /// What it is, with its unit.
    pub(super) meaning: &'static str,
    pub(super) value: fn(&SeriesRow) -> Cell,
}

/// All columns but the status, which is a word.
pub(super) const COLUMNS: [Column; 15] = [
    column("chi", "spin, phi rho / mu", |row| Real(row.creepage.chi())),
    column("alpha", "angle from the rolling direction to the creepage [degrees]", |row| {
        Real(row.alpha)
    }),
    column("upsilon", "magnitude of the creepage (xi, eta)", |row| Real(row.upsilon)),
    column("xi", "longitudinal creepage, upsilon_x rho / (mu c)", |row| Real(row.creepage.xi())),
    column("eta", "lateral creepage, upsilon_y rho / (mu c)", |row| Real(row.creepage.eta())),
    column("fx", "longitudinal force on the lower body over mu N", |row| Real(row.force.fx)),
    column("fy", "lateral force on the lower body over mu N", |row| Real(row.force.fy)),
    column("mz", "moment on the lower body over mu N c", |row| Real(row.force.mz)),
    column("iterations", "iterations", |row| Count(row.iterations)),
    column("steps_from_previous", "steps in which the previous case was left", |row| {
        Count(row.steps_from_previous)
    }),
    column("mean_integrand", "mean of W T S over the mesh", |row| Real(row.mean_integrand)),
    column("residual", "mean of W T S over that of rigid bodies", |row| Real(row.residual)),
    column("aberrations", "mesh points with T > S and traction above its bound", |row| {
        Count(row.aberrations)
    }),
    column("adhesion_share", "share of the mesh points that adhere", |row| {
        Real(row.adhesion_share)
    }),
    column("second_start_difference", "largest change of a force by a second start", |row| {
        Real(row.second_start_difference)
    }),
];

const fn column(
    name: &'static str,
    meaning: &'static str,
    value: fn(&SeriesRow) -> Cell,
) -> Column {
    Column { name, meaning, value }
}
