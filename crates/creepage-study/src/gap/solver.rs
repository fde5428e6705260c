//! Cases of any shape solved: what one presses together, the next ones only roll.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use creepage::coulomb::{NonHertzian, Resolution};
use creepage::gap::Gap;
use creepage::normal::{self, NormalContact, NormalError};
use creepage::theory::{NamedResolution, ResolutionSpec};
use creepage::{InvalidValue, SolidPair};

use super::case::{GapCase, Pressed};
use super::error::GapCaseError;
use super::solve::{self, SolvedGap, resolutions, rolled, simplified};
use super::theory::GapTheory;

/// Solves a case of any shape: the pressure, then rolling. For many cases use [`GapSolver`].
///
/// # Errors
/// [`GapCaseError`] for bodies without a contact area, and for wanted forces out of reach.
pub fn solve_gap(case: &GapCase) -> Result<SolvedGap, GapCaseError> {
    GapSolver::default().solve(case)
}

/// Solves cases of any shape, one after another or at once by several threads, and keeps the
/// contacts of the last few and what the full theory prepared on them: a case that differs from one
/// of these in creepage, speed, friction or layer alone is not pressed anew. Answers have the same bits as
/// those of [`solve_gap`].
#[derive(Debug, Default)]
pub struct GapSolver {
    contacts: Memory<Asked, Known>,
}

/// What a contact follows from.
#[derive(Debug, Clone, PartialEq)]
struct Asked {
    gap: Gap,
    pair: SolidPair,
    pressed: Pressed,
    resolution: normal::Resolution,
}

/// A contact, and the full theory on it.
#[derive(Debug)]
struct Known {
    contact: Result<NormalContact, NormalError>,
    theories: Memory<Resolution, Result<NonHertzian, InvalidValue>>,
}

impl GapSolver {
    /// Solves a case.
    ///
    /// # Errors
    /// [`GapCaseError`], as [`solve_gap`].
    pub fn solve(&self, case: &GapCase) -> Result<SolvedGap, GapCaseError> {
        let options = match case.theory {
            GapTheory::Exact(options) => options,
            GapTheory::Simplified(kind, cells) => {
                if case.rolling_friction.is_some() || case.layer.is_some() {
                    let why =
                        "a law of friction or a layer is counted on other areas by exact alone";
                    return Err(GapCaseError::Theory { name: case.theory.name(), why });
                }
                let known = self.pressed(case, normal::Resolution::STANDARD);
                return simplified(case, known.contact(case)?, kind, cells);
            }
        };
        let fineness = match options.resolution {
            ResolutionSpec::Named(NamedResolution::Fast) => normal::Resolution::FAST,
            _ => normal::Resolution::FINE,
        };
        let known = self.pressed(case, fineness);
        let contact = known.contact(case)?;
        let rolled = |resolution| rolled(case, contact, known.theory(contact, case, resolution));
        let (resolutions, accuracy) = resolutions(options)?;
        let (last, first) = resolutions.split_last().unwrap_or((&Resolution::STANDARD, &[]));
        for resolution in first {
            let solved = rolled(*resolution)?;
            let error = solved.solution.error.unwrap_or_default();
            if error.fx.max(error.fy) <= accuracy {
                return Ok(solved);
            }
        }
        rolled(*last)
    }

    /// The bodies of a case pressed together.
    fn pressed(&self, case: &GapCase, resolution: normal::Resolution) -> Arc<Known> {
        let (gap, pressed) = (case.gap.clone(), case.pressed);
        let asked = Asked { gap, pair: case.pair, pressed, resolution };
        self.contacts.of(&asked, |_| {
            let contact = solve::pressed_together(case, resolution);
            Known { contact, theories: Memory::default() }
        })
    }
}

impl Known {
    /// The contact, if there is one.
    fn contact(&self, case: &GapCase) -> Result<&NormalContact, GapCaseError> {
        self.contact.as_ref().map_err(|error| solve::not_pressed(case, error.clone()))
    }

    /// The full theory on a contact of this one, for the case's friction and layer.
    fn theory(
        &self,
        contact: &NormalContact,
        case: &GapCase,
        resolution: Resolution,
    ) -> Result<NonHertzian, InvalidValue> {
        // Any friction will do for what does not depend on it.
        let theory = self.theories.of(&resolution, |r| NonHertzian::new(contact, 1.0, *r));
        let theory = theory.as_ref().as_ref().map_err(InvalidValue::clone)?;
        let theory = theory.with_friction(case.friction)?;
        Ok(theory.with_resistance(case.rolling_friction, case.layer))
    }
}

/// The last few values by their keys; each is made once, and whoever else asks for it meanwhile
/// waits.
#[derive(Debug)]
struct Memory<K, V> {
    entries: Mutex<VecDeque<(K, Slot<V>)>>,
}

type Slot<V> = Arc<OnceLock<Arc<V>>>;

impl<K, V> Default for Memory<K, V> {
    fn default() -> Self {
        Self { entries: Mutex::default() }
    }
}

impl<K: PartialEq + Clone, V> Memory<K, V> {
    fn of(&self, key: &K, make: impl FnOnce(&K) -> V) -> Arc<V> {
        let slot = self.slot(key);
        Arc::clone(slot.get_or_init(|| Arc::new(make(key))))
    }

    /// The place of a key; the one not asked for the longest gives way to a new one.
    fn slot(&self, key: &K) -> Slot<V> {
        let mut entries = self.entries.lock().unwrap_or_else(PoisonError::into_inner);
        let place = entries.iter().position(|(known, _)| known == key);
        let entry = place.and_then(|place| entries.remove(place));
        let (key, slot) = entry.unwrap_or_else(|| (key.clone(), Slot::default()));
        // A table is mostly in order: each thread is at one contact, or between two.
        if entries.len() > rayon::current_num_threads() {
            entries.pop_front();
        }
        entries.push_back((key, Arc::clone(&slot)));
        slot
    }
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
        let kept = solver.contacts.entries.lock().unwrap().len();
        assert!(kept <= rayon::current_num_threads() + 1, "{kept}");
    }
}
