//! Solver of cases of any shape, with a cache: what one case presses together, the next ones only roll.

use super::case::{GapCase, LoadOrApproach};
use super::error::GapCaseError;
use crate::recent::Recent;
use crate::solve::{SolvedTheory, in_si_units};
use crate::{AnyCase, CaseError, Caution, SolveError, SolvedCase};
use creepage::coulomb::{NonHertzian, Resolution};
use creepage::gap::Gap;
use creepage::normal::{self, NormalContact, NormalError};
use creepage::theory::{ExactOptions, NamedResolution, ResolutionSpec};
use creepage::{Contact, InvalidValue, SolidPair, Theory, TheorySpec};
use std::sync::Arc;

/// Solves a case of any shape: the pressure, then rolling. For many cases use [`GapSolver`].
///
/// # Errors
/// [`GapCaseError`] for bodies without a contact area, and for wanted forces out of reach.
pub fn solve_gap(case: &GapCase) -> Result<SolvedCase, GapCaseError> {
    GapSolver::default().solve(case)
}

/// Solves cases of any shape, one after another or at once by several threads, and keeps the
/// contacts of the last few and what the full theory prepared on them: a case that differs from one
/// of these in creepage, speed, friction or layer alone is not pressed anew. Answers have the same bits as
/// those of [`solve_gap`].
#[derive(Debug)]
pub struct GapSolver {
    contacts: Recent<CacheKey, PreparedAreas>,
}

/// What a contact follows from.
#[derive(Debug, Clone, PartialEq)]
struct CacheKey {
    gap: Gap,
    pair: SolidPair,
    pressed: LoadOrApproach,
    resolution: normal::Resolution,
}

/// Pressed areas, and the full theory on them.
#[derive(Debug)]
struct PreparedAreas {
    areas: Result<Arc<NormalContact>, NormalError>,
    theories: Recent<Resolution, Result<NonHertzian, InvalidValue>>,
}

/// A table is mostly in order: each thread is at one contact, or between two.
fn contacts_kept() -> usize {
    rayon::current_num_threads() + 1
}

impl Default for GapSolver {
    fn default() -> Self {
        Self { contacts: Recent::new(contacts_kept) }
    }
}

impl GapSolver {
    /// Solves a case.
    ///
    /// # Errors
    /// [`GapCaseError`], as [`solve_gap`].
    pub fn solve(&self, case: &GapCase) -> Result<SolvedCase, GapCaseError> {
        if let Some(curved) = &case.curved {
            return case.solve_curved(curved);
        }
        let known = self.pressed(case, fineness(&case.theory));
        let contact = case.contact(known.areas(case)?)?;
        let TheorySpec::Exact(options) = &case.theory else {
            return case.solved(&contact, case.theory.prepare(&contact)?);
        };
        let (resolutions, accuracy) = options.resolutions().map_err(CaseError::invalid("solve"))?;
        let (last, first) = resolutions.split_last().unwrap_or((&Resolution::STANDARD, &[]));
        let rolled = |resolution| -> Result<SolvedCase, GapCaseError> {
            let theory =
                known.theory(&contact, resolution).map_err(CaseError::invalid("contact"))?;
            case.solved(&contact, Box::new(theory))
        };
        for resolution in first {
            let solved = rolled(*resolution)?;
            let error = solved.solution().error.unwrap_or_default();
            if error.fx.max(error.fy) <= accuracy {
                return Ok(solved);
            }
        }
        rolled(*last)
    }

    /// The contact of a case, pressed as finely as its theory needs.
    ///
    /// # Errors
    /// [`GapCaseError`] for bodies without a contact area.
    pub fn contact(&self, case: &GapCase) -> Result<Contact, GapCaseError> {
        if let Some(curved) = &case.curved {
            let areas = case.press_curved(curved, fineness(&case.theory))?;
            return Ok(case.contact(&Arc::new(areas))?);
        }
        let known = self.pressed(case, fineness(&case.theory));
        Ok(case.contact(known.areas(case)?)?)
    }

    /// The bodies of a case pressed together.
    fn pressed(&self, case: &GapCase, resolution: normal::Resolution) -> Arc<PreparedAreas> {
        let (gap, pressed) = (case.gap.clone(), case.pressed);
        let asked = CacheKey { gap, pair: case.pair, pressed, resolution };
        self.contacts.of(&asked, || {
            let areas = pressed_together(case, resolution).map(Arc::new);
            PreparedAreas { areas, theories: Recent::new(contacts_kept) }
        })
    }
}

/// How finely bodies are pressed for a theory of rolling.
pub(super) fn fineness(theory: &TheorySpec) -> normal::Resolution {
    match theory {
        TheorySpec::Exact(ExactOptions {
            resolution: ResolutionSpec::Named(NamedResolution::Fast),
            ..
        }) => normal::Resolution::FAST,
        TheorySpec::Exact(_) => normal::Resolution::FINE,
        _ => normal::Resolution::STANDARD,
    }
}

impl PreparedAreas {
    /// The areas, if there are any.
    fn areas(&self, case: &GapCase) -> Result<&Arc<NormalContact>, GapCaseError> {
        self.areas.as_ref().map_err(|error| not_pressed(case, error.clone()))
    }

    /// The full theory for a contact on these areas.
    fn theory(
        &self,
        contact: &Contact,
        resolution: Resolution,
    ) -> Result<NonHertzian, InvalidValue> {
        // What depends on friction or on a layer is little, and made for each contact.
        let friction = contact.friction().unwrap_or(1.0);
        let theory = self.theories.of(&resolution, || NonHertzian::on(contact, resolution));
        let theory = theory.as_ref().as_ref().map_err(InvalidValue::clone)?;
        let theory = theory.with_friction(friction)?;
        let theory = theory.with_resistance(contact.rolling_friction(), contact.layer());
        Ok(match contact.added_slip() {
            Some(slip) => theory.with_added_slip(Arc::clone(slip)),
            None => theory,
        })
    }
}

impl GapCase {
    /// The contact on areas that this case gives, with its law of friction and its layer.
    pub(crate) fn contact(&self, areas: &Arc<NormalContact>) -> Result<Contact, CaseError> {
        let contact = Contact::of_areas(Arc::clone(areas), self.friction)
            .map_err(CaseError::invalid("contact"))?;
        let contact = match self.rolling_friction {
            Some(law) => contact.with_rolling_friction(law),
            None => contact,
        };
        let contact = match self.layer {
            Some(layer) => contact.with_layer(layer),
            None => contact,
        };
        Ok(match &self.slip {
            Some(slip) => contact.with_added_slip(Arc::clone(slip)),
            None => contact,
        })
    }

    /// The case solved by a theory that is prepared for its contact.
    fn solved(
        &self,
        contact: &Contact,
        theory: Box<dyn Theory>,
    ) -> Result<SolvedCase, GapCaseError> {
        let scaling = contact.scaling();
        let held = if self.given.is_creepage() {
            let creepage = self.given.creepage(scaling)?;
            SolvedTheory::new(theory, |theory| theory.solved(creepage))
        } else {
            let reach = contact.areas().map_or(0.0, |areas| reach(areas));
            let constraints = self.given.constraints(scaling, reach)?;
            let prescribed = self.given.force.map(|force| force.is_some());
            SolvedTheory::try_new(theory, |theory| {
                let name = self.theory.facts().name;
                let found =
                    theory.solved_for(constraints).ok_or(SolveError::FindsNothing { name })?;
                found.map_err(|error| in_si_units(error, prescribed, scaling))
            })?
        };
        Ok(self.kept(contact, held).with_heat())
    }

    /// The solved case, with its cautions.
    pub(super) fn kept(&self, contact: &Contact, held: SolvedTheory) -> SolvedCase {
        let scaling = contact.scaling();
        SolvedCase::new(
            AnyCase::Gap(self.clone()),
            contact,
            self.theory.facts(),
            held,
            |solution, creepage| {
                let mut cautions = Caution::all(&self.theory, contact, solution);
                let si = scaling.si_creepage(creepage);
                cautions.extend(Caution::large_creepage(si));
                let shear_yield = self.damage.as_ref().map(|damage| damage.constants.shear_yield);
                if let Some(areas) = contact.areas() {
                    cautions.extend(Caution::large_spin_of_areas(si.spin, areas));
                    cautions.extend(Caution::large_areas(&self.gap, areas));
                    cautions.extend(self.roller.and_then(|roller| roller.caution(areas)));
                    let (peak, pair) = (areas.peak_pressure().value, areas.pair());
                    if !cautions.iter().any(Caution::is_of_units) {
                        cautions.extend(Caution::yields(peak, pair.shear_modulus(), shear_yield));
                    }
                }
                cautions
            },
        )
    }
}

/// As many rows along a roller, whose ends are short beside it, through every door.
const ALONG_A_ROLLER: usize = 100;

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
    let fine = case.roller.and_then(|_| normal::Resolution::new(ALONG_A_ROLLER).ok());
    let resolution = fine.unwrap_or(resolution);
    match case.pressed {
        LoadOrApproach::Load(load) => {
            NormalContact::under_load(&case.gap, case.pair, load, resolution)
        }
        LoadOrApproach::Approach(approach) => {
            NormalContact::at_approach(&case.gap, case.pair, approach, resolution)
        }
    }
}

/// The error of bodies that have no contact.
pub(super) fn not_pressed(case: &GapCase, source: NormalError) -> GapCaseError {
    let pressed = match case.pressed {
        LoadOrApproach::Load(load) => format!("normal_force = {load}"),
        LoadOrApproach::Approach(approach) => format!("approach = {approach}"),
    };
    GapCaseError::Normal { shape: case.shape.clone(), pressed, source }
}

/// The largest distance of the contact from the origin of coordinates (m), or a little more.
pub(super) fn reach(contact: &NormalContact) -> f64 {
    let largest = |[low, high]: [f64; 2]| low.abs().max(high.abs());
    let extents = contact.patches().iter().map(normal::Patch::extent);
    extents.map(|extent| largest(extent.x).hypot(largest(extent.y))).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GapFile;

    /// A crowned roller with these values in the places of the usual ones.
    fn case(changes: &[(&str, &str)]) -> GapCase {
        let usual = "[upper]\nshear_modulus = 82e9\npoisson = 0.28\n\
            [lower]\nshear_modulus = 82e9\npoisson = 0.28\n\
            [gap]\npolynomial = [[2, 0, 1.1], [0, 4, 5e4]]\n\
            [contact]\nnormal_force = 40e3\nfriction = 0.3\n\
            [creepage]\nlongitudinal = 1e-3\nspeed = 20.0\n\
            [solve]\nresolution = \"fast\"\n";
        let text = changes.iter().fold(usual.to_owned(), |text, (from, to)| {
            assert!(text.contains(from));
            text.replace(from, to)
        });
        GapFile::read(&text).unwrap().case(".".as_ref()).unwrap()
    }

    /// Friction, its law, a layer, creepage and theory change from case to case and back again.
    #[test]
    fn one_after_another_is_as_each_alone() {
        let law = "friction = { law = \"rational\", kinetic = 0.1, \
            terms = [{ drop = 0.2, half_speed = 0.5 }] }";
        let layer = "[layer]\nthickness = 1e-5\nshear_modulus = 1e9\n[creepage]";
        let asked = [
            case(&[]),
            case(&[("friction = 0.3", "friction = 0.15")]),
            case(&[("friction = 0.3", law)]),
            case(&[("[creepage]", layer)]),
            case(&[("= 1e-3", "= -4e-4")]),
            case(&[("normal_force = 40e3", "approach = 4e-5")]),
            case(&[("resolution = \"fast\"", "theory = \"fastsim\"")]),
            case(&[("1.1", "1.2")]),
            case(&[]),
        ];
        let solver = GapSolver::default();
        for case in &asked {
            let (kept, alone) = (solver.solve(case).unwrap(), solve_gap(case).unwrap());
            assert_eq!(kept.force(), alone.force());
            assert_eq!(kept.solution(), alone.solution());
            assert_eq!(kept.contact, alone.contact);
            assert_eq!(kept.power_per_metre().to_bits(), alone.power_per_metre().to_bits());
        }
    }

    #[test]
    fn bodies_are_pressed_together_once() {
        let solver = GapSolver::default();
        let pressed = |case: &GapCase| solver.pressed(case, normal::Resolution::FAST);
        let first = pressed(&case(&[]));
        let other = case(&[("friction = 0.3", "friction = 0.15"), ("= 1e-3", "= -4e-4")]);
        assert!(Arc::ptr_eq(&first, &pressed(&other)));
        for change in [("normal_force = 40e3", "normal_force = 41e3"), ("1.1", "1.2")] {
            assert!(!Arc::ptr_eq(&first, &pressed(&case(&[change]))));
        }
    }

    #[test]
    fn few_contacts_are_kept() {
        let solver = GapSolver::default();
        for load in 1..=20 {
            let _ =
                solver.pressed(&case(&[("40e3", &format!("{load}e3"))]), normal::Resolution::FAST);
        }
        let kept = solver.contacts.count();
        assert!(kept <= rayon::current_num_threads() + 1, "{kept}");
    }
}
