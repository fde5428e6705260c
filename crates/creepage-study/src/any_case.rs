//! A case of any kind of contact: one file format read once, one way to its contact, theory and solution.

use std::path::Path;

use creepage::theory::UnknownTheory;
use creepage::{Contact, Creepage, Hertz, Solid, TheorySpec};

use crate::case::keys;
use crate::{
    Case, CaseError, CaseFile, Caution, DamageWanted, GapCase, GapCaseError, GapFile, GapSolver,
    HeatWanted, SolvedCase, Sources, solve,
};

/// A case file: bodies that touch in Hertz's ellipse, or, with `[gap]`, bodies of any shape.
///
/// ```
/// use creepage_study::AnyCaseFile;
/// # let text = "
/// # [upper]
/// # shear_modulus = 82e9
/// # poisson = 0.28
/// # [lower]
/// # shear_modulus = 82e9
/// # poisson = 0.28
/// # [gap]
/// # polynomial = [[2, 0, 1.1], [0, 4, 5e4]]
/// # [contact]
/// # normal_force = 40e3
/// # friction = 0.3
/// # [creepage]
/// # longitudinal = 1e-3
/// # ";
/// let solved = AnyCaseFile::read(text)?.case(".".as_ref())?.solve(None)?;
/// assert!(solved.force().longitudinal > 5e3); // newtons
/// # Ok::<(), creepage_study::GapCaseError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum AnyCaseFile {
    /// Hertz's ellipse.
    Ellipse(Box<CaseFile>),
    /// Any shape.
    Gap(Box<GapFile>),
}

impl AnyCaseFile {
    /// Reads the text of a case file and checks its form.
    ///
    /// # Errors
    /// [`GapCaseError`] that says where the text is not a case file.
    pub fn read(text: &str) -> Result<Self, GapCaseError> {
        let table = keys::parse(text)?;
        Ok(if table.contains_key("gap") {
            Self::Gap(Box::new(GapFile::of(&table, text)?))
        } else {
            Self::Ellipse(Box::new(CaseFile::of(&table, text)?))
        })
    }

    /// Checks the numbers; files of points stand in `directory`.
    ///
    /// # Errors
    /// [`GapCaseError`] with section, key and value.
    pub fn case(&self, directory: &Path) -> Result<AnyCase, GapCaseError> {
        Ok(match self {
            Self::Ellipse(file) => AnyCase::Ellipse(file.case_in(directory)?),
            Self::Gap(file) => AnyCase::Gap(file.case(directory)?),
        })
    }
}

/// A case of any kind of contact, every number of it checked.
#[derive(Debug, Clone)]
pub enum AnyCase {
    /// Bodies that touch in Hertz's ellipse.
    Ellipse(Case),
    /// Bodies of any shape.
    Gap(GapCase),
}

impl AnyCase {
    /// Solves it by its own theory, or by another one. For many cases of any shape use [`GapSolver`].
    ///
    /// # Errors
    /// [`GapCaseError`] for a contact or options out of the theory's range, bodies without a contact
    /// area, and for forces that cannot be reached.
    pub fn solve(&self, other: Option<&TheorySpec>) -> Result<SolvedCase, GapCaseError> {
        match (self, other) {
            (Self::Ellipse(case), other) => Ok(solve(case, other)?),
            (Self::Gap(case), None) => GapSolver::default().solve(case),
            (Self::Gap(case), Some(spec)) => {
                GapSolver::default().solve(&case.clone().by_spec(spec)?)
            }
        }
    }

    /// What touches, with its friction; bodies of any shape are pressed for it.
    ///
    /// # Errors
    /// [`GapCaseError`] for bodies without a contact area.
    pub fn contact(&self) -> Result<Contact, GapCaseError> {
        match self {
            Self::Ellipse(case) => Ok(case.contact.clone()),
            Self::Gap(case) => GapSolver::default().contact(case),
        }
    }

    /// That its contact lies in a plane, for what knows no other; `what` says for whom, as "curves".
    ///
    /// # Errors
    /// [`GapCaseError::CurvedOf`].
    pub fn lies_in_a_plane(&self, what: &'static str) -> Result<(), GapCaseError> {
        match self {
            Self::Gap(case) if case.curved.is_some() => Err(GapCaseError::CurvedOf { what }),
            _ => Ok(()),
        }
    }

    /// The creepage on that contact, where it is given.
    ///
    /// # Errors
    /// [`CaseError::Wanted`] where it is to be found.
    pub fn creepage(&self, contact: &Contact) -> Result<Creepage, CaseError> {
        match self {
            Self::Ellipse(case) => case.creepage(),
            Self::Gap(case) if case.given.is_creepage() => case.given.creepage(contact.scaling()),
            Self::Gap(_) => Err(CaseError::Wanted),
        }
    }

    /// Numbers that look like ones in another unit.
    #[must_use]
    pub fn cautions_of_units(&self, contact: &Contact, creepage: Creepage) -> Vec<Caution> {
        let si = contact.scaling().si_creepage(creepage);
        match self {
            Self::Ellipse(case) => Caution::units(&case.hertz, case.smallest_radius, si),
            Self::Gap(case) => {
                let areas = contact.areas().into_iter();
                let of_areas = areas.flat_map(|areas| {
                    Caution::of_areas(areas).chain(Caution::large_areas(&case.gap, areas))
                });
                let spin = contact.areas();
                let spin = spin.and_then(|areas| Caution::large_spin_of_areas(si.spin, areas));
                of_areas.chain(Caution::large_creepage(si)).chain(spin).collect()
            }
        }
    }

    /// The theory and its options.
    #[must_use]
    pub fn theory(&self) -> &TheorySpec {
        match self {
            Self::Ellipse(case) => &case.theory,
            Self::Gap(case) => &case.theory,
        }
    }

    /// The theory of that name for this case: the case's own with the options that it gives, any
    /// other with its default options.
    ///
    /// # Errors
    /// [`UnknownTheory`], with the nearest name if one is near.
    pub fn theory_named(&self, name: &str) -> Result<TheorySpec, UnknownTheory> {
        if self.theory().facts().name == name {
            return Ok(self.theory().clone());
        }
        TheorySpec::named(name)
    }

    /// Whether the options of the case's own theory are given up for those of `theories`.
    #[must_use]
    pub fn gives_up_options(&self, theories: &[TheorySpec]) -> bool {
        let own = self.theory().facts().name;
        let is_default = TheorySpec::named(own).is_ok_and(|default| default == *self.theory());
        !is_default && !theories.iter().any(|theory| theory.facts().name == own)
    }

    /// The contact ellipse and its pressure, where it is Hertz's.
    #[must_use]
    pub fn hertz(&self) -> Option<&Hertz> {
        match self {
            Self::Ellipse(case) => Some(&case.hertz),
            Self::Gap(_) => None,
        }
    }

    /// Coefficient of friction `mu`, the largest where it varies.
    #[must_use]
    pub fn friction(&self) -> f64 {
        match self {
            Self::Ellipse(case) => case.friction,
            Self::Gap(case) => case.friction,
        }
    }

    /// Rolling velocity (m/s), where it is known.
    #[must_use]
    pub fn speed(&self) -> Option<f64> {
        match self {
            Self::Ellipse(case) => case.speed,
            Self::Gap(case) => case.speed,
        }
    }

    /// The materials of the upper and the lower body.
    #[must_use]
    pub fn solids(&self) -> [Solid; 2] {
        match self {
            Self::Ellipse(case) => case.solids,
            Self::Gap(case) => case.solids,
        }
    }

    /// What is asked for of temperatures.
    #[must_use]
    pub fn heat(&self) -> Option<&HeatWanted> {
        match self {
            Self::Ellipse(case) => case.heat.as_ref(),
            Self::Gap(case) => case.heat.as_ref(),
        }
    }

    /// What is asked for of wear and fatigue.
    #[must_use]
    pub fn damage(&self) -> Option<&DamageWanted> {
        match self {
            Self::Ellipse(case) => case.damage.as_ref(),
            Self::Gap(case) => case.damage.as_ref(),
        }
    }

    /// The files that the case was read from.
    pub(crate) fn sources(&self) -> Sources {
        match self {
            Self::Ellipse(case) => case.sources.clone(),
            Self::Gap(case) => case.sources.clone(),
        }
    }
}
