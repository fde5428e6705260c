//! The theories by name.

use std::fs;
use std::path::Path;

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
use creepage::rolling::{Creepage, Solution, Theory};
use creepage_case::{Case, CaseFile, Solve};

use crate::failure::Failure;

/// A theory prepared for one shape of the contact and one Poisson's ratio.
pub(crate) enum Solver {
    /// The one with error bars.
    Exact(Box<Exact>),
    Other {
        name: String,
        theory: Box<dyn Theory>,
    },
}

impl Solver {
    /// Prepares the theory `name`; `solve` holds options of its own only.
    pub(crate) fn new(
        name: &str,
        a_over_b: f64,
        poisson: f64,
        solve: &Solve,
    ) -> Result<Self, Failure> {
        let known = options(name).ok_or_else(|| Failure::Theory(name.into()))?;
        if let Some(option) = solve.options().find(|option| !known.contains(option)) {
            return Err(Failure::Foreign { option, theory: name.into() });
        }
        if name == "exact" {
            let fixed = solve.resolution.map_or(Ok(None), creepage_case::Resolution::fixed)?;
            let resolution = fixed.unwrap_or(Resolution::STANDARD);
            return Ok(Self::Exact(Box::new(Exact::new(a_over_b, poisson, resolution)?)));
        }
        let theory = approximate(name, a_over_b, poisson, solve)?;
        Ok(Self::Other { name: name.into(), theory })
    }

    pub(crate) fn solve(&self, creepage: Creepage) -> Solution {
        match self {
            Self::Exact(theory) => theory.solve(creepage),
            Self::Other { theory, .. } => theory.solve(creepage),
        }
    }
}

/// The options that a theory has; `None` if there is no such theory.
fn options(name: &str) -> Option<&'static [&'static str]> {
    Some(match name {
        "exact" => &["resolution"],
        "variational" => &["degree", "mesh", "weight"],
        "fastrip" => &["grid", "variant"],
        "fastsim" => &["grid", "flexibility", "bound"],
        "linear"
        | "saturated"
        | "strip"
        | "polach"
        | "shen-hedrick-elkins"
        | "vermeulen-johnson" => &[],
        _ => return None,
    })
}

fn approximate(
    name: &str,
    a_over_b: f64,
    poisson: f64,
    solve: &Solve,
) -> Result<Box<dyn Theory>, Failure> {
    Ok(match name {
        "variational" => Box::new(Variational::new(a_over_b, poisson, variational(solve))?),
        "fastrip" => {
            let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
            let variant = solve.variant.map(Into::into).unwrap_or_default();
            let grid = solve.grid.unwrap_or(fastsim::Settings::default().grid);
            Box::new(Fastrip::new(a_over_b, poisson, &coefficients, variant, grid)?)
        }
        "fastsim" => {
            let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
            Box::new(Fastsim::new(a_over_b, poisson, &coefficients, fastsim(solve))?)
        }
        "linear" => Box::new(Linear::new(a_over_b, poisson)?),
        "saturated" => Box::new(Saturated::new(a_over_b)?),
        "strip" => Box::new(StripTheory::new(a_over_b, poisson)?),
        "polach" => Box::new(Polach::new(a_over_b, poisson)?),
        "shen-hedrick-elkins" => Box::new(ShenHedrickElkins::new(a_over_b, poisson)?),
        "vermeulen-johnson" => Box::new(VermeulenJohnson::new(a_over_b, poisson)?),
        _ => return Err(Failure::Theory(name.into())),
    })
}

fn variational(solve: &Solve) -> variational::Settings {
    let default = variational::Settings::default();
    let usual = solve.degree.map_or(default, variational::Settings::of_degree);
    variational::Settings {
        mesh: solve.mesh.unwrap_or(usual.mesh),
        weight: solve.weight.map_or(usual.weight, Into::into),
        ..usual
    }
}

fn fastsim(solve: &Solve) -> fastsim::Settings {
    let usual = fastsim::Settings::default();
    fastsim::Settings {
        flexibility: solve.flexibility.map_or(usual.flexibility, Into::into),
        bound: solve.bound.map_or(usual.bound, Into::into),
        grid: solve.grid.unwrap_or(usual.grid),
    }
}

/// The case of a file, and its theory, or the theory `name` with its usual options.
pub(crate) fn case(path: &Path, name: Option<&str>) -> Result<(Case, Solver), Failure> {
    let text =
        fs::read_to_string(path).map_err(|source| Failure::Read { path: path.into(), source })?;
    let wrong = |source| Failure::CaseFile { path: path.into(), source };
    let case = CaseFile::read(&text).map_err(wrong)?.case().map_err(wrong)?;
    let own = case.solve.theory.as_deref().unwrap_or("exact");
    let name = name.unwrap_or(own);
    let solve = if name == own { case.solve.clone() } else { Solve::default() };
    let (ratio, poisson) = (case.contact.ellipse().ratio(), case.contact.pair().poisson());
    let solver = Solver::new(name, ratio, poisson, &solve)?;
    Ok((case, solver))
}
