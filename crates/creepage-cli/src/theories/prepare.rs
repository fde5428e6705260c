//! From the options of a case file to a theory prepared.

use creepage::rolling::exact::{self, Automatic, Exact};
use creepage::rolling::fastrip::Fastrip;
use creepage::rolling::fastsim::{self, Fastsim};
use creepage::rolling::linear::{CreepageCoefficients, Linear};
use creepage::rolling::polach::Polach;
use creepage::rolling::saturated::Saturated;
use creepage::rolling::shen_hedrick_elkins::ShenHedrickElkins;
use creepage::rolling::strip::StripTheory;
use creepage::rolling::variational::{self, Variational};
use creepage::rolling::vermeulen_johnson::VermeulenJohnson;
use creepage_case::{Resolution, Solve};

use super::{Prepared, PreparedTheory, TheoryError};

/// The largest error bar that is wanted, where the resolution depends on it.
pub(crate) fn wanted_accuracy(solve: &Solve) -> Option<f64> {
    let automatic = solve.resolution == Some(Resolution::Auto);
    automatic.then(|| solve.accuracy.unwrap_or(1e-3))
}

pub(super) fn exact(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    if let Some(accuracy) = wanted_accuracy(solve) {
        let theory = Automatic::new(a_over_b, poisson, accuracy)?;
        return Ok(PreparedTheory::Automatic(Box::new(theory)));
    }
    if solve.accuracy.is_some() {
        return Err(TheoryError::AccuracyOfFixed);
    }
    let fixed = solve.resolution.map_or(Ok(None), Resolution::fixed)?;
    let theory = Exact::new(a_over_b, poisson, fixed.unwrap_or(exact::Resolution::STANDARD))?;
    Ok(PreparedTheory::Exact(Box::new(theory)))
}

pub(super) fn variational(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    let theory = Variational::new(a_over_b, poisson, variational_settings(solve))?;
    Ok(PreparedTheory::Variational(Box::new(theory)))
}

fn variational_settings(solve: &Solve) -> variational::Settings {
    let default = variational::Settings::default();
    let usual = solve.degree.map_or(default, variational::Settings::of_degree);
    variational::Settings {
        mesh: solve.mesh.unwrap_or(usual.mesh),
        weight: solve.weight.map_or(usual.weight, Into::into),
        ..usual
    }
}

pub(super) fn linear(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::other(Linear::new(a_over_b, poisson)?))
}

/// Poisson's ratio does not matter to it.
pub(super) fn saturated(a_over_b: f64, _: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::other(Saturated::new(a_over_b)?))
}

pub(super) fn vermeulen_johnson(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::other(VermeulenJohnson::new(a_over_b, poisson)?))
}

pub(super) fn shen_hedrick_elkins(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::other(ShenHedrickElkins::new(a_over_b, poisson)?))
}

pub(super) fn polach(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::other(Polach::new(a_over_b, poisson)?))
}

pub(super) fn strip(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::other(StripTheory::new(a_over_b, poisson)?))
}

pub(super) fn fastsim(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    let usual = fastsim::Settings::default();
    let settings = fastsim::Settings {
        flexibility: solve.flexibility.map_or(usual.flexibility, Into::into),
        bound: solve.bound.map_or(usual.bound, Into::into),
        grid: solve.grid.unwrap_or(usual.grid),
    };
    let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
    Ok(PreparedTheory::other(Fastsim::new(a_over_b, poisson, &coefficients, settings)?))
}

pub(super) fn fastrip(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    let variant = solve.variant.map(Into::into).unwrap_or_default();
    let grid = solve.grid.unwrap_or(fastsim::Settings::default().grid);
    let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
    Ok(PreparedTheory::other(Fastrip::new(a_over_b, poisson, &coefficients, variant, grid)?))
}
