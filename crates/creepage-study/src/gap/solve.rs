//! A case of any shape, solved.

use creepage::coulomb::{ElementField, InverseError, NonHertzian, NonHertzianSolved, Resolution};
use creepage::normal::{self, NormalContact};
use creepage::theory::{ExactOptions, NamedResolution, ResolutionSpec};
use creepage::{Creepage, Force, Region, Scaling, SiForce, Solution, Solved};
use creepage_plot::signed_area;

use super::caution::GapCaution;
use super::error::GapCaseError;
use super::file::{GapCase, Pressed};
use crate::{CaseError, Unreachable};

/// A case of any shape and its solution, ready to be shown.
#[derive(Debug, Clone)]
pub struct SolvedGap {
    /// The case.
    pub case: GapCase,
    /// Contact areas and pressure.
    pub contact: NormalContact,
    /// What is to be held against the solution.
    pub cautions: Vec<GapCaution>,
    pub(super) scaling: Scaling,
    pub(super) solution: Solution,
    pub(super) creepage: Creepage,
    pub(super) elements: Vec<ElementField>,
    power: f64,
    dissipation: Option<f64>,
}

/// Solves a case of any shape: the pressure, then rolling.
///
/// # Errors
/// [`GapCaseError`] for bodies without a contact area, and for wanted forces out of reach.
pub fn solve_gap(case: &GapCase) -> Result<SolvedGap, GapCaseError> {
    let contact = pressed(case)?;
    let (resolutions, accuracy) = resolutions(case.options)?;
    let (last, first) = resolutions.split_last().unwrap_or((&Resolution::STANDARD, &[]));
    for resolution in first {
        let solved = rolled(case, &contact, *resolution)?;
        let error = solved.solution.error.unwrap_or_default();
        if error.fx.max(error.fy) <= accuracy {
            return Ok(solved);
        }
    }
    rolled(case, &contact, *last)
}

fn pressed(case: &GapCase) -> Result<NormalContact, GapCaseError> {
    let resolution = match case.options.resolution {
        ResolutionSpec::Named(NamedResolution::Fast) => normal::Resolution::FAST,
        _ => normal::Resolution::FINE,
    };
    let (contact, pressed) = match case.pressed {
        Pressed::Load(load) => (
            NormalContact::under_load(&case.gap, case.pair, load, resolution),
            format!("normal_force = {load}"),
        ),
        Pressed::Approach(approach) => (
            NormalContact::at_approach(&case.gap, case.pair, approach, resolution),
            format!("approach = {approach}"),
        ),
    };
    contact.map_err(|source| GapCaseError::Normal { shape: case.shape.clone(), pressed, source })
}

/// The resolutions to be tried, the coarsest first, until this accuracy is met.
fn resolutions(options: ExactOptions) -> Result<(Vec<Resolution>, f64), CaseError> {
    let valid = "finite and greater than zero";
    let accuracy = options.accuracy.unwrap_or(creepage::coulomb::Automatic::DEFAULT_ACCURACY);
    if !(accuracy.is_finite() && accuracy > 0.0) {
        let invalid = creepage::InvalidValue { quantity: "accuracy", value: accuracy, valid };
        return Err(CaseError::invalid("solve")(invalid));
    }
    let resolutions = match options.resolution {
        ResolutionSpec::Named(NamedResolution::Fast) => vec![Resolution::FAST],
        ResolutionSpec::Named(NamedResolution::Standard) => vec![Resolution::STANDARD],
        ResolutionSpec::Named(NamedResolution::Fine) => vec![Resolution::FINE],
        ResolutionSpec::Named(NamedResolution::Auto) => {
            vec![Resolution::FAST, Resolution::STANDARD, Resolution::FINE]
        }
        ResolutionSpec::Elements([along, across]) => {
            vec![Resolution::new(along, across).map_err(CaseError::invalid("solve"))?]
        }
    };
    Ok((resolutions, accuracy))
}

fn rolled(
    case: &GapCase,
    contact: &NormalContact,
    resolution: Resolution,
) -> Result<SolvedGap, GapCaseError> {
    let theory = NonHertzian::new(contact, case.friction, resolution)
        .map_err(CaseError::invalid("contact"))?;
    let scaling = theory.scaling();
    let solved = if case.given.is_creepage() {
        theory.solve(case.given.creepage(scaling)?)
    } else {
        let constraints = case.given.constraints(scaling, reach(contact))?;
        let prescribed = case.given.force.map(|force| force.is_some());
        theory.find(constraints).map_err(|error| unreachable(error, prescribed, scaling))?
    };
    Ok(SolvedGap::new(case, contact, scaling, &solved))
}

fn unreachable(error: InverseError, prescribed: [bool; 3], scaling: Scaling) -> GapCaseError {
    match error {
        InverseError::NotReachable { nearest, at } => {
            Unreachable { prescribed, nearest, at, scaling }.into()
        }
        other => other.into(),
    }
}

/// The largest distance of the contact from the origin of coordinates (m), or a little more.
fn reach(contact: &NormalContact) -> f64 {
    let largest = |[low, high]: [f64; 2]| low.abs().max(high.abs());
    let extents = contact.patches().iter().map(normal::Patch::extent);
    extents.map(|extent| largest(extent.x).hypot(largest(extent.y))).fold(0.0, f64::max)
}

impl SolvedGap {
    fn new(
        case: &GapCase,
        contact: &NormalContact,
        scaling: Scaling,
        solved: &NonHertzianSolved<'_>,
    ) -> Self {
        let solution = solved.solution();
        Self {
            cautions: GapCaution::all(contact, case.friction, solution.status),
            case: case.clone(),
            contact: contact.clone(),
            scaling,
            solution,
            creepage: solved.creepage(),
            elements: solved.elements(),
            power: solved.power(),
            dissipation: solved.dissipation(),
        }
    }

    /// Force in units of [`Scaling`], error bars, status.
    #[must_use]
    pub fn solution(&self) -> Solution {
        self.solution
    }

    /// Force on the lower body, the moment about the origin of coordinates.
    #[must_use]
    pub fn force(&self) -> SiForce {
        self.scaling.si_force(self.solution.force)
    }

    /// Error bars of the force: those of rolling, and the load's in proportion.
    #[must_use]
    pub fn force_error(&self) -> SiForce {
        let load = self.contact.load();
        let part = load.error / load.value;
        let (force, error) = (self.solution.force, self.solution.error.unwrap_or_default());
        self.scaling.si_force(Force {
            fx: error.fx + part * force.fx.abs(),
            fy: error.fy + part * force.fy.abs(),
            mz: error.mz + part * force.mz.abs(),
        })
    }

    /// Adhesion area over contact area, 0 to 1, counted by elements.
    #[must_use]
    pub fn adhesion_share(&self) -> f64 {
        let area = |element: &ElementField| signed_area(&element.corners).abs();
        let all: f64 = self.elements.iter().map(area).sum();
        let adhesion = |element: &&ElementField| element.point.region == Region::Adhesion;
        self.elements.iter().filter(adhesion).map(area).sum::<f64>() / all
    }

    /// Energy turned to heat per metre rolled (J/m), from force and creepage.
    #[must_use]
    pub fn power_per_metre(&self) -> f64 {
        self.scaling.force * self.scaling.slip * self.power
    }

    /// The same energy (J/m) from traction and slip all over the contact.
    #[must_use]
    pub fn dissipation_per_metre(&self) -> Option<f64> {
        self.dissipation.map(|power| self.scaling.force * self.scaling.slip * power)
    }
}
