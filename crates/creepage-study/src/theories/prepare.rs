//! From the options of a case file to a theory prepared.

use crate::{Bound, Resolution, Solve};
use creepage::InvalidValue;
use creepage::rolling::exact::{self, Automatic, Exact};
use creepage::rolling::fastrip::Fastrip;
use creepage::rolling::fastsim::{self, Fastsim};
use creepage::rolling::linear::{CreepageCoefficients, Linear};
use creepage::rolling::polach::Polach;
use creepage::rolling::saturated::Saturated;
use creepage::rolling::shen_hedrick_elkins::ShenHedrickElkins;
use creepage::rolling::strip::StripTheory;
use creepage::rolling::variational::{self, Variational, VariationalError};
use creepage::rolling::vermeulen_johnson::VermeulenJohnson;

use crate::theories::prepared::PreparedTheory;

type Prepared = Result<PreparedTheory, TheoryError>;

/// Why a theory cannot be prepared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TheoryError {
    /// Degree or mesh of the numerical theory.
    #[error(transparent)]
    Variational(#[from] VariationalError),
    /// A number out of range: a ratio, or an option.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// An accuracy is wanted, but the resolution is fixed.
    #[error("`accuracy` needs resolution = \"auto\"")]
    AccuracyOfFixed,
}

/// The largest error bar that is wanted (in parts of `mu N`), where the resolution depends on it.
#[must_use]
pub fn wanted_accuracy(solve: &Solve) -> Option<f64> {
    let automatic = solve.resolution == Some(Resolution::Auto);
    automatic.then(|| solve.accuracy.unwrap_or(1e-3))
}

pub(crate) fn exact(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
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

pub(crate) fn variational(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    let theory = Variational::new(a_over_b, poisson, variational_settings(solve))?;
    Ok(PreparedTheory::Variational(Box::new(theory)))
}

/// The settings of the numerical theory; what is left out is usual.
#[must_use]
pub fn variational_settings(solve: &Solve) -> variational::Settings {
    let default = variational::Settings::default();
    let usual = solve.degree.map_or(default, variational::Settings::of_degree);
    variational::Settings {
        mesh: solve.mesh.unwrap_or(usual.mesh),
        weight: solve.weight.map_or(usual.weight, Into::into),
        bound: solve.bound.and_then(Bound::of_variational).unwrap_or(usual.bound),
        ..usual
    }
}

pub(crate) fn linear(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::Linear(Linear::new(a_over_b, poisson)?))
}

/// Poisson's ratio does not matter to it.
pub(crate) fn saturated(a_over_b: f64, _: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::Saturated(Box::new(Saturated::new(a_over_b)?)))
}

pub(crate) fn vermeulen_johnson(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::VermeulenJohnson(VermeulenJohnson::new(a_over_b, poisson)?))
}

pub(crate) fn shen_hedrick_elkins(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::ShenHedrickElkins(ShenHedrickElkins::new(a_over_b, poisson)?))
}

pub(crate) fn polach(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    let clean = Polach::new(a_over_b, poisson)?;
    let Some([adhesion, slip]) = solve.reduction else {
        return Ok(PreparedTheory::Polach(clean));
    };
    let valid = "two factors [adhesion, slip] with 0 < slip <= adhesion <= 1";
    let named = |invalid| InvalidValue { quantity: "reduction", valid, ..invalid };
    Ok(PreparedTheory::Polach(clean.with_reduction(adhesion, slip).map_err(named)?))
}

pub(crate) fn strip(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(PreparedTheory::Strip(Box::new(StripTheory::new(a_over_b, poisson)?)))
}

pub(crate) fn fastsim(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    let usual = fastsim::Settings::default();
    let settings = fastsim::Settings {
        flexibility: solve.flexibility.map_or(usual.flexibility, Into::into),
        bound: solve.bound.and_then(Bound::of_fastsim).unwrap_or(usual.bound),
        grid: solve.grid.unwrap_or(usual.grid),
    };
    let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
    Ok(PreparedTheory::Fastsim(Box::new(Fastsim::new(a_over_b, poisson, &coefficients, settings)?)))
}

pub(crate) fn fastrip(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    let variant = solve.variant.map(Into::into).unwrap_or_default();
    let grid = solve.grid.unwrap_or(fastsim::Settings::default().grid);
    let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
    Ok(PreparedTheory::Fastrip(Box::new(Fastrip::new(
        a_over_b,
        poisson,
        &coefficients,
        variant,
        grid,
    )?)))
}
