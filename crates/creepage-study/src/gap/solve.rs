//! A case of any shape, solved.

use creepage::approximate::non_hertzian::{NonHertzianSimplified, Simplified};
use creepage::coulomb::{ElementField, InverseError, NonHertzian, Resolution};
use creepage::normal::{self, NormalContact, NormalError};
use creepage::theory::Constraints;
use creepage::theory::{ExactOptions, NamedResolution, ResolutionSpec};
use creepage::{Creepage, Force, InvalidValue, Scaling, SiCreepage, SiForce, Solution, Solved};

use super::case::{GapCase, Pressed};
use super::caution::GapCaution;
use super::error::GapCaseError;
use crate::damage::{Ground, of_elements};
use crate::{CaseError, Damage, Unreachable, adhesion};

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

/// The bodies pressed together.
pub(crate) fn pressed(
    case: &GapCase,
    resolution: normal::Resolution,
) -> Result<NormalContact, GapCaseError> {
    pressed_together(case, resolution).map_err(|source| not_pressed(case, source))
}

pub(super) fn pressed_together(
    case: &GapCase,
    resolution: normal::Resolution,
) -> Result<NormalContact, NormalError> {
    match case.pressed {
        Pressed::Load(load) => NormalContact::under_load(&case.gap, case.pair, load, resolution),
        Pressed::Approach(approach) => {
            NormalContact::at_approach(&case.gap, case.pair, approach, resolution)
        }
    }
}

/// The error of bodies that have no contact.
pub(super) fn not_pressed(case: &GapCase, source: NormalError) -> GapCaseError {
    let pressed = match case.pressed {
        Pressed::Load(load) => format!("normal_force = {load}"),
        Pressed::Approach(approach) => format!("approach = {approach}"),
    };
    GapCaseError::Normal { shape: case.shape.clone(), pressed, source }
}

/// The resolutions to be tried, the coarsest first, until this accuracy is met.
pub(crate) fn resolutions(options: ExactOptions) -> Result<(Vec<Resolution>, f64), CaseError> {
    if options.coupled {
        let valid = "left out with [gap], whose bodies are taken for like ones";
        let invalid = InvalidValue { quantity: "coupled", value: 1.0, valid };
        return Err(CaseError::invalid("solve")(invalid));
    }
    let valid = "finite and greater than zero";
    let accuracy = options.accuracy.unwrap_or(creepage::coulomb::Automatic::DEFAULT_ACCURACY);
    if !(accuracy.is_finite() && accuracy > 0.0) {
        let invalid = InvalidValue { quantity: "accuracy", value: accuracy, valid };
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

/// A case rolled by the full theory on its contact.
pub(super) fn rolled(
    case: &GapCase,
    contact: &NormalContact,
    theory: Result<NonHertzian, InvalidValue>,
) -> Result<SolvedGap, GapCaseError> {
    let theory = theory.map_err(CaseError::invalid("contact"))?;
    let asked = Asked::new(case, contact, theory.scaling())?;
    let solved = match asked {
        Asked::At(creepage) => theory.solve(creepage),
        Asked::For(constraints) => {
            theory.find(constraints).map_err(|error| unreachable(error, case, theory.scaling()))?
        }
    };
    Ok(SolvedGap::new(case, contact, theory.scaling(), &solved, solved.elements()))
}

/// The same by a simplified theory.
pub(super) fn simplified(
    case: &GapCase,
    contact: &NormalContact,
    kind: Simplified,
    cells: [usize; 2],
) -> Result<SolvedGap, GapCaseError> {
    let theory = NonHertzianSimplified::new(contact, case.friction, kind, cells)
        .map_err(CaseError::invalid("solve"))?;
    let solved = match Asked::new(case, contact, theory.scaling())? {
        Asked::At(creepage) => theory.solve(creepage),
        Asked::For(constraints) => {
            theory.find(constraints).map_err(|error| unreachable(error, case, theory.scaling()))?
        }
    };
    Ok(SolvedGap::new(case, contact, theory.scaling(), &solved, solved.elements()))
}

/// What is asked of a theory, in the contact's units.
enum Asked {
    At(Creepage),
    For(Constraints),
}

impl Asked {
    fn new(case: &GapCase, contact: &NormalContact, scaling: Scaling) -> Result<Self, CaseError> {
        if case.given.is_creepage() {
            return Ok(Self::At(case.given.creepage(scaling)?));
        }
        Ok(Self::For(case.given.constraints(scaling, reach(contact))?))
    }
}

fn unreachable(error: InverseError, case: &GapCase, scaling: Scaling) -> GapCaseError {
    let prescribed = case.given.force.map(|force| force.is_some());
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
        solved: &dyn Solved,
        elements: Vec<ElementField>,
    ) -> Self {
        let (solution, creepage) = (solved.solution(), solved.creepage());
        let si = scaling.si_creepage(creepage);
        let mut cautions = GapCaution::all(contact, case.friction, si, solution.status);
        cautions.extend(GapCaution::large_areas(&case.gap, contact));
        Self {
            cautions,
            case: case.clone(),
            contact: contact.clone(),
            scaling,
            solution,
            creepage,
            elements,
            power: solved.power(),
            dissipation: solved.dissipation(),
        }
    }

    /// Wear and fatigue numbers by the laws that `[damage]` sets; no shakedown limit. `None` where the case
    /// has none.
    #[must_use]
    pub fn damage(&self) -> Option<Damage> {
        let wanted = self.case.damage.as_ref()?;
        let normal = self.contact.load().value;
        let rows = of_elements(&self.elements, self.scaling, normal);
        let ground = Ground {
            force: self.force(),
            creepage: self.scaling.si_creepage(self.creepage),
            normal,
            area: self.contact.area().value,
            peak: self.contact.peak_pressure().value,
            speed: self.case.speed,
            rows: Some(&rows),
        };
        Some(Damage::new(wanted, &ground, None))
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

    /// Error bars of the force: those of rolling, where the theory has them, and the load's in
    /// proportion.
    #[must_use]
    pub fn force_error(&self) -> Option<SiForce> {
        let load = self.contact.load();
        let part = load.error / load.value;
        let (force, error) = (self.solution.force, self.solution.error?);
        Some(self.scaling.si_force(Force {
            fx: error.fx + part * force.fx.abs(),
            fy: error.fy + part * force.fy.abs(),
            mz: error.mz + part * force.mz.abs(),
        }))
    }

    /// Adhesion area over contact area, 0 to 1.
    #[must_use]
    pub fn adhesion_share(&self) -> f64 {
        adhesion::share(&self.elements)
    }

    /// Given or found.
    #[must_use]
    pub fn creepage(&self) -> SiCreepage {
        self.scaling.si_creepage(self.creepage)
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
