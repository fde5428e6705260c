//! Which theories are meant, and whether the options of the case file are theirs.

use creepage_case::Solve;

use super::{ENTRIES, Entry};

/// The theory of a case that names none.
const DEFAULT: &str = "exact";

/// The theories to use, and what of the case file does not concern them.
pub(crate) struct Choice {
    pub(crate) theories: Vec<&'static Entry>,
    /// Options that only the theory of the case file has.
    pub(crate) ignored: Vec<&'static str>,
}

/// Why no theory can be chosen.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum ChoiceError {
    #[error(transparent)]
    Unknown(#[from] UnknownTheory),
    #[error("`{option}` is an option of {owners}, not of {theories}")]
    Foreign { option: &'static str, owners: String, theories: String },
}

/// A name that no theory has.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("unknown theory `{name}`: {hint}")]
pub(crate) struct UnknownTheory {
    name: String,
    hint: String,
}

/// The theory of that name.
pub(crate) fn find(name: &str) -> Result<&'static Entry, UnknownTheory> {
    ENTRIES.iter().find(|entry| entry.name == name).ok_or_else(|| {
        let likeness = |entry: &&Entry| strsim::jaro_winkler(name, entry.name);
        let nearest = ENTRIES.iter().max_by(|one, two| likeness(one).total_cmp(&likeness(two)));
        let hint = match nearest {
            Some(entry) if likeness(&entry) > 0.8 => format!("did you mean `{}`?", entry.name),
            _ => "`creepage theories` lists them".into(),
        };
        UnknownTheory { name: name.into(), hint }
    })
}

/// The theories of the command line, or that of the case file where it names none. An option of
/// the file must be one of theirs, or of the file's own theory that they replace.
pub(crate) fn choose(names: &[String], solve: &Solve) -> Result<Choice, ChoiceError> {
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
            let owners = listed(ENTRIES.iter().filter(|entry| entry.options.contains(&option)));
            return Err(ChoiceError::Foreign { option, owners, theories: listed(theories) });
        }
        ignored.push(option);
    }
    Ok(Choice { theories, ignored })
}

/// Their names, as `fastsim and fastrip`.
fn listed(theories: impl IntoIterator<Item = &'static Entry>) -> String {
    theories.into_iter().map(|entry| entry.name).collect::<Vec<_>>().join(" and ")
}

impl Choice {
    /// A word to the user about options that have no effect.
    pub(crate) fn note(&self) -> Option<String> {
        let verb = if self.ignored.len() == 1 { "has" } else { "have" };
        (!self.ignored.is_empty()).then(|| {
            let (options, theories) = (self.ignored.join(", "), listed(self.theories.clone()));
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
