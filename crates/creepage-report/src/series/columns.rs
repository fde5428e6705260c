//! The columns of a series, the same in every format.

use super::SeriesRow;

/// One column of numbers.
pub(super) struct Column {
    pub(super) name: &'static str,
    /// What it is, with its unit.
    pub(super) meaning: &'static str,
    pub(super) value: fn(&SeriesRow) -> f64,
}

/// All columns but the status, which is a word.
pub(super) const COLUMNS: [Column; 15] = [
    column("chi", "spin, phi rho / mu", |row| row.creepage.chi),
    column("alpha", "angle from the rolling direction to the creepage [degrees]", |row| row.alpha),
    column("upsilon", "magnitude of the creepage (xi, eta)", |row| row.upsilon),
    column("xi", "longitudinal creepage, upsilon_x rho / (mu c)", |row| row.creepage.xi),
    column("eta", "lateral creepage, upsilon_y rho / (mu c)", |row| row.creepage.eta),
    column("fx", "longitudinal force on the lower body over mu N", |row| row.force.fx),
    column("fy", "lateral force on the lower body over mu N", |row| row.force.fy),
    column("mz", "moment on the lower body over mu N c", |row| row.force.mz),
    column("iterations", "iterations", |row| row.iterations as f64),
    column("steps_from_previous", "steps in which the previous case was left", |row| {
        row.steps_from_previous as f64
    }),
    column("mean_integrand", "mean of W T S over the mesh", |row| row.mean_integrand),
    column("residual", "mean of W T S over that of rigid bodies", |row| row.residual),
    column("aberrations", "mesh points with T > S and traction above its bound", |row| {
        row.aberrations as f64
    }),
    column("adhesion_share", "share of the mesh points that adhere", |row| row.adhesion_share),
    column("second_start_difference", "largest change of a force by a second start", |row| {
        row.second_start_difference
    }),
];

const fn column(name: &'static str, meaning: &'static str, value: fn(&SeriesRow) -> f64) -> Column {
    Column { name, meaning, value }
}
