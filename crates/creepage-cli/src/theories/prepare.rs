//! From the options of a case file to a theory prepared.

use creepage::InvalidValue;
use creepage::rolling::exact::{Exact, Resolution};
use creepage::rolling::fastrip::Fastrip;
use creepage::rolling::fastsim::{self, Fastsim};
use creepage::rolling::linear::{CreepageCoefficients, Linear};
use creepage::rolling::polach::Polach;
use creepage::rolling::saturated::Saturated;
use creepage::rolling::shen_hedrick_elkins::ShenHedrickElkins;
use creepage::rolling::strip::StripTheory;
use creepage::rolling::variational::{self, Variational};
use creepage::rolling::vermeulen_johnson::VermeulenJohnson;
use creepage_case::Solve;

use super::Prepared;

pub(super) fn exact(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    Ok(Box::new(exact_theory(a_over_b, poisson, solve)?))
}

pub(super) fn exact_theory(
    a_over_b: f64,
    poisson: f64,
    solve: &Solve,
) -> Result<Exact, InvalidValue> {
    let resolution = solve.resolution.map_or(Resolution::STANDARD, Into::into);
    Exact::new(a_over_b, poisson, resolution)
}

pub(super) fn variational(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    Ok(Box::new(Variational::new(a_over_b, poisson, variational_settings(solve))?))
}

pub(super) fn variational_settings(solve: &Solve) -> variational::Settings {
    let default = variational::Settings::default();
    let usual = solve.degree.map_or(default, variational::Settings::of_degree);
    variational::Settings {
        mesh: solve.mesh.unwrap_or(usual.mesh),
        weight: solve.weight.map_or(usual.weight, Into::into),
        ..usual
    }
}

pub(super) fn linear(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(Box::new(Linear::new(a_over_b, poisson)?))
}

/// Poisson's ratio does not matter to it.
pub(super) fn saturated(a_over_b: f64, _: f64, _: &Solve) -> Prepared {
    Ok(Box::new(Saturated::new(a_over_b)?))
}

pub(super) fn vermeulen_johnson(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(Box::new(VermeulenJohnson::new(a_over_b, poisson)?))
}

pub(super) fn shen_hedrick_elkins(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(Box::new(ShenHedrickElkins::new(a_over_b, poisson)?))
}

pub(super) fn polach(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(Box::new(Polach::new(a_over_b, poisson)?))
}

pub(super) fn strip(a_over_b: f64, poisson: f64, _: &Solve) -> Prepared {
    Ok(Box::new(StripTheory::new(a_over_b, poisson)?))
}

pub(super) fn fastsim(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    let usual = fastsim::Settings::default();
    let settings = fastsim::Settings {
        flexibility: solve.flexibility.map_or(usual.flexibility, Into::into),
        bound: solve.bound.map_or(usual.bound, Into::into),
        grid: solve.grid.unwrap_or(usual.grid),
    };
    let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
    Ok(Box::new(Fastsim::new(a_over_b, poisson, &coefficients, settings)?))
}

pub(super) fn fastrip(a_over_b: f64, poisson: f64, solve: &Solve) -> Prepared {
    let variant = solve.variant.map(Into::into).unwrap_or_default();
    let grid = solve.grid.unwrap_or(fastsim::Settings::default().grid);
    let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
    Ok(Box::new(Fastrip::new(a_over_b, poisson, &coefficients, variant, grid)?))
}
