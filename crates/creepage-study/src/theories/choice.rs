//! Which theories are meant, and whether the options of the case file are theirs.

use std::error::Error;
use std::fmt;

use crate::{Bound, Solve};

use crate::theories::registry::{ENTRIES, Entry};

/// The theory of a case that names none.
const DEFAULT: &str = "exact";

/// The theories to use, and what of the case file does not concern them.
#[derive(Debug)]
pub struct Choice {
    /// At least one.
    pub theories: Vec<&'static Entry>,
    /// Options that only the theory of the case file has.
    pub ignored: Vec<&'static str>,
}

/// Why no theory can be chosen.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ChoiceError {
    /// There is no theory of that name.
    #[error(transparent)]
    Unknown(#[from] UnknownTheory),
    /// An option that none of the chosen theories has.
    #[error("`{option}` is an option of {}, not of {}", owners.join(" and "), theories.join(" and "))]
    Foreign {
        /// The option.
        option: &'static str,
        /// The theories that have it.
        owners: Vec<&'static str>,
        /// Those that were chosen.
        theories: Vec<&'static str>,
    },
    /// A bound that another theory has.
    #[error("bound = \"{}\" is not valid for {theory}: it must be {}", given.word(), words(known))]
    Bound {
        /// The bound that is given.
        given: Bound,
        /// The theory.
        theory: &'static str,
        /// The bounds that it has.
        known: &'static [Bound],
    },
}

/// Each in quotes, as a choice.
fn words(bounds: &[Bound]) -> String {
    let words: Vec<_> = bounds.iter().map(|bound| format!("\"{}\"", bound.word())).collect();
    words.join(" or ")
}

/// A name that no theory has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownTheory {
    /// The name.
    pub name: String,
    /// The theory that may be meant.
    pub nearest: Option<&'static str>,
}

impl Error for UnknownTheory {}

impl fmt::Display for UnknownTheory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown theory `{}`: ", self.name)?;
        match self.nearest {
            Some(nearest) => write!(f, "did you mean `{nearest}`?"),
            None => write!(f, "known are {}", names(ENTRIES).join(", ")),
        }
    }
}

/// The theory of that name.
///
/// # Errors
/// [`UnknownTheory`], with the nearest name if one is near.
pub fn find(name: &str) -> Result<&'static Entry, UnknownTheory> {
    ENTRIES.iter().find(|entry| entry.name == name).ok_or_else(|| {
        let likeness = |entry: &&Entry| strsim::jaro_winkler(name, entry.name);
        let nearest = ENTRIES.iter().max_by(|one, two| likeness(one).total_cmp(&likeness(two)));
        let nearest = nearest.filter(|entry| likeness(entry) > 0.8).map(|entry| entry.name);
        UnknownTheory { name: name.into(), nearest }
    })
}

/// The theories of these names, or where there are none that of the case file, or the full one.
///
/// An option of the file must be one of theirs, or of the file's own theory that they replace.
///
/// # Errors
/// [`ChoiceError`] for unknown names and for options of other theories.
pub fn choose(names: &[String], solve: &Solve) -> Result<Choice, ChoiceError> {
    let of_file = find(solve.theory.as_deref().unwrap_or(DEFAULT));
    let theories = if names.is_empty() {
        vec![of_file.clone()?]
    } else {
        names.iter().map(|name| find(name)).collect::<Result<_, _>>()?
    };
    let mut ignored = Vec::new();
    for option in solve.options() {
        if theories.iter().any(|theory| theory.takes(option, solve)) {
            continue;
        }
        if !of_file.as_ref().is_ok_and(|theory| theory.takes(option, solve)) {
            return Err(foreign(option, &theories, solve));
        }
        ignored.push(option);
    }
    Ok(Choice { theories, ignored })
}

/// Why none of the theories takes the option.
fn foreign(option: &'static str, theories: &[&'static Entry], solve: &Solve) -> ChoiceError {
    let of_that_name = theories.iter().find(|theory| theory.options.contains(&option));
    if let (Some(theory), Some(given)) = (of_that_name, solve.bound) {
        return ChoiceError::Bound { given, theory: theory.name, known: theory.bounds };
    }
    let owners = names(ENTRIES.iter().filter(|entry| entry.options.contains(&option)));
    ChoiceError::Foreign { option, owners, theories: names(theories.iter().copied()) }
}

fn names(theories: impl IntoIterator<Item = &'static Entry>) -> Vec<&'static str> {
    theories.into_iter().map(|entry| entry.name).collect()
}

impl Choice {
    /// A word to the user about options that have no effect.
    #[must_use]
    pub fn note(&self) -> Option<String> {
        let verb = if self.ignored.len() == 1 { "has" } else { "have" };
        (!self.ignored.is_empty()).then(|| {
            let theories = names(self.theories.iter().copied()).join(" and ");
            let options = self.ignored.join(", ");
            format!("note: [solve] {options} {verb} no meaning for {theories}, and no effect")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(theories: &[&str]) -> Vec<String> {
        theories.iter().map(ToString::to_string).collect()
    }

    fn solve(theory: &str) -> Solve {
        Solve { theory: Some(theory.into()), grid: Some([10, 10]), ..Solve::default() }
    }

    #[test]
    fn an_option_belongs_to_one_of_the_theories() {
        let choice = choose(&[], &solve("fastrip")).ok().unwrap();
        assert_eq!((choice.theories[0].name, choice.note()), ("fastrip", None));
        let error = choose(&[], &solve("linear")).err().unwrap().to_string();
        assert_eq!(error, "`grid` is an option of fastrip and fastsim, not of linear");
        assert!(choose(&names(&["linear", "fastsim"]), &solve("linear")).is_ok());
    }

    #[test]
    fn an_option_of_the_replaced_theory_is_ignored_aloud() {
        let choice = choose(&names(&["linear", "strip"]), &solve("fastsim")).ok().unwrap();
        let note = "note: [solve] grid has no meaning for linear and strip, and no effect";
        assert_eq!(choice.note().unwrap(), note);
        assert!(choose(&names(&["linear"]), &solve("none such")).is_err());
    }

    #[test]
    fn a_bound_is_an_option_of_the_theory_that_has_its_word() {
        let bounded = |theory: &str, bound| Solve {
            theory: Some(theory.into()),
            bound: Some(bound),
            ..Solve::default()
        };
        for (theory, bound) in [("fastsim", Bound::Parabolic), ("variational", Bound::Kept)] {
            assert!(choose(&[], &bounded(theory, bound)).is_ok());
            let choice = choose(&names(&["fastsim", "variational"]), &bounded(theory, bound));
            assert_eq!(choice.unwrap().note(), None);
        }
        let error = choose(&[], &bounded("fastsim", Bound::Kept)).unwrap_err().to_string();
        let words = "it must be \"elliptic\" or \"parabolic\"";
        assert_eq!(error, format!("bound = \"kept\" is not valid for fastsim: {words}"));
        let error = choose(&[], &bounded("linear", Bound::Kept)).unwrap_err().to_string();
        let owners = "variational and fastsim";
        assert_eq!(error, format!("`bound` is an option of {owners}, not of linear"));
        // What the replaced theory has is ignored aloud, though the other has a key of that name.
        let replaced = bounded("variational", Bound::Kept);
        let choice = choose(&names(&["fastsim"]), &replaced).unwrap();
        assert_eq!(choice.ignored, ["bound"]);
        let fastsim = choice.theories[0].prepare(1.0, 0.28, &replaced).unwrap();
        let usual = choice.theories[0].prepare(1.0, 0.28, &Solve::default()).unwrap();
        let creepage = creepage::rolling::Creepage { xi: 0.4, eta: 0.1, chi: 0.2 };
        assert_eq!(fastsim.answer(creepage), usual.answer(creepage));
    }
}
