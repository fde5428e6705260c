//! Series of cases and its results as a table: CSV, JSON, and NetCDF for pandas, xarray and others.

mod journal;
mod netcdf;
mod record;
mod run;
mod table;

use crate::{Sweep, SweepCase};
use creepage::variational::ChainCase;
use creepage::{Creepage, Force, Region, Status};

pub use netcdf::series_netcdf;
pub use run::{SweepRun, Tally};
pub use table::{series_csv, series_json};

/// One case of a series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeriesRow {
    /// Angle from the rolling direction to the creepage (degrees).
    pub alpha: f64,
    /// Magnitude of the creepage.
    pub upsilon: f64,
    /// Creepage and spin.
    pub creepage: Creepage,
    /// Force and moment on the lower body.
    pub force: Force,
    /// Outcome.
    pub status: Status,
    /// Iterations of the successful attempt.
    pub iterations: usize,
    /// Into how many steps the way from the previous case of the chain was cut.
    pub steps_from_previous: usize,
    /// Mean of `W T S`.
    pub mean_integrand: f64,
    /// The same over that of rigid bodies without traction.
    pub residual: f64,
    /// Points with `T > S` and traction above its bound.
    pub aberrations: usize,
    /// Share of the mesh points that adhere.
    pub adhesion_share: f64,
    /// Largest difference of a force to the solution from a second start; NaN where that was not
    /// asked for.
    pub second_start_difference: f64,
}

/// Quantities that all cases of a series share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeriesHead {
    /// Ratio `a/b` of the contact's semi-axes.
    pub a_over_b: f64,
    /// Combined Poisson's ratio.
    pub poisson: f64,
    /// How unlike the bodies are: `kappa` of (2.10) over the coefficient of friction.
    pub kappa_over_mu: f64,
    /// Degree of the traction polynomials.
    pub degree: usize,
    /// Cells of the mesh along `x` and `y`.
    pub mesh: [usize; 2],
    /// Number of cases.
    pub cases: usize,
}

impl SeriesRow {
    /// The row of a solved case.
    #[must_use]
    pub fn new(case: &SweepCase, solved: &ChainCase, second_start_difference: f64) -> Self {
        let found = &solved.found;
        let adhering =
            found.points.iter().filter(|point| point.field.region == Region::Adhesion).count();
        Self {
            alpha: case.alpha,
            upsilon: case.upsilon,
            creepage: case.creepage,
            force: found.solution.force,
            status: found.solution.status,
            iterations: found.iterations(),
            steps_from_previous: solved.steps_from_previous,
            mean_integrand: found.mean_integrand,
            residual: found.residual,
            aberrations: found.aberrations,
            adhesion_share: adhering as f64 / found.points.len() as f64,
            second_start_difference,
        }
    }
}

impl From<&Sweep> for SeriesHead {
    fn from(sweep: &Sweep) -> Self {
        Self {
            a_over_b: sweep.a_over_b,
            poisson: sweep.poisson,
            kappa_over_mu: sweep.kappa_over_mu,
            degree: sweep.settings.degree,
            mesh: sweep.settings.mesh,
            cases: sweep.cases(),
        }
    }
}
