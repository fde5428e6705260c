//! Which theories are meant, and whether the options of the case file are theirs.

use std::error::Error;
use std::fmt;

use creepage_case::Solve;

use crate::registry::{ENTRIES, Entry};

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
        if theories.iter().any(|theory| theory.options.contains(&option)) {
            continue;
        }
        if !of_file.as_ref().is_ok_and(|theory| theory.options.contains(&option)) {
            let owners =
                self::names(ENTRIES.iter().filter(|entry| entry.options.contains(&option)));
            return Err(ChoiceError::Foreign { option, owners, theories: self::names(theories) });
        }
        ignored.push(option);
    }
    Ok(Choice { theories, ignored })
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
}
