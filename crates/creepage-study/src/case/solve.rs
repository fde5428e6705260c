//! `[solve]`: which theory, and its options.

use creepage::TheorySpec;
use creepage::theory::UnknownTheory;
use toml::{Table, Value};

use super::keys::{plain_words, similar};

/// Error of `[solve]`, or of options outside a case file, that name no theory.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpecError {
    /// There is no theory of that name.
    #[error(transparent)]
    UnknownTheory(#[from] UnknownTheory),
    /// No theory has an option of that name.
    #[error("unknown key `{key}` in [solve]: {hint}")]
    UnknownOption {
        /// The name.
        key: String,
        /// A likely meaning, or the options of the theory.
        hint: String,
    },
    /// An option of other theories.
    #[error("`{option}` is an option of {}, not of {theory}", owners.join(" and "))]
    Foreign {
        /// The option.
        option: String,
        /// The theories that have it.
        owners: Vec<&'static str>,
        /// The theory that was chosen.
        theory: &'static str,
    },
    /// A value that the option does not take.
    #[error("{option} = {value} is not valid for {theory}: {}", plain_words(source.message()))]
    Value {
        /// The option.
        option: String,
        /// The value that was given.
        value: Value,
        /// The theory that was chosen.
        theory: &'static str,
        /// What it must be.
        source: Box<toml::de::Error>,
    },
    /// The name of the theory where only its options belong.
    #[error("`theory` is not an option of a theory")]
    Theory,
    /// An option that is not `key = value`.
    #[error(transparent)]
    Toml(#[from] toml::de::Error),
}

/// The theory of that name, or `exact`, with options that stand outside a case file, as on a
/// command line: each `key = value` or `key=value`; a word needs no quotes.
///
/// ```
/// use creepage::TheorySpec;
/// let spec = creepage_study::theory_spec("fastsim", &["grid=[20, 10]", "bound=parabolic"])?;
/// assert!(matches!(spec, TheorySpec::Fastsim(settings) if settings.grid == [20, 10]));
/// # Ok::<(), creepage_study::SpecError>(())
/// ```
///
/// # Errors
/// [`SpecError`] for what `[solve]` of a case file may not say either.
pub fn theory_spec(name: &str, options: &[impl AsRef<str>]) -> Result<TheorySpec, SpecError> {
    let lines: Vec<_> = options.iter().map(|option| quoted(option.as_ref())).collect();
    let mut table: Table = lines.join("\n").parse()?;
    if table.contains_key("theory") {
        return Err(SpecError::Theory);
    }
    table.insert("theory".into(), name.into());
    from_table(&table)
}

/// The option as a line of TOML: what is no value of TOML is text.
fn quoted(option: &str) -> String {
    match option.split_once('=') {
        Some((key, word)) if option.parse::<Table>().is_err() => {
            format!("{key}={}", Value::from(word.trim()))
        }
        _ => option.into(),
    }
}

/// The theory of `[solve]`; `exact` where it names none.
pub(crate) fn from_table(table: &Table) -> Result<TheorySpec, SpecError> {
    let named = match table.get("theory") {
        None => TheorySpec::default(),
        Some(Value::String(name)) => TheorySpec::named(name)?,
        Some(other) => TheorySpec::named(&other.to_string())?,
    };
    let facts = named.facts();
    let read = |options: Table| {
        let theory = [("theory".to_owned(), Value::from(facts.name))];
        let table: Table = options.into_iter().chain(theory).collect();
        table.try_into::<TheorySpec>()
    };
    let mut options = table.clone();
    options.remove("theory");
    for (option, value) in &options {
        if !facts.options.contains(&&option[..]) {
            return Err(not_its_option(option, facts.name));
        }
        // Each by itself, so that what is wrong has a name.
        read(Table::from_iter([(option.clone(), value.clone())])).map_err(|source| {
            SpecError::Value {
                option: option.clone(),
                value: value.clone(),
                theory: facts.name,
                source: Box::new(source),
            }
        })?;
    }
    Ok(read(options)?)
}

fn not_its_option(key: &str, theory: &'static str) -> SpecError {
    let all = TheorySpec::all().map(|theory| theory.facts());
    let owners: Vec<_> =
        all.iter().filter(|facts| facts.options.contains(&key)).map(|facts| facts.name).collect();
    if !owners.is_empty() {
        return SpecError::Foreign { option: key.into(), owners, theory };
    }
    let mut known: Vec<_> = all.iter().flat_map(|facts| facts.options).copied().collect();
    known.push("theory");
    let hint = match similar(key, &known) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("known are {}", known.join(", ")),
    };
    SpecError::UnknownOption { key: key.into(), hint }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<TheorySpec, SpecError> {
        from_table(&text.parse().unwrap())
    }

    fn refused(text: &str) -> String {
        read(text).unwrap_err().to_string()
    }

    #[test]
    fn every_option_of_every_theory_is_read_and_written_back() {
        assert_eq!(read("").unwrap(), TheorySpec::default());
        for spec in TheorySpec::all() {
            let table = Table::try_from(&spec).unwrap();
            assert_eq!(from_table(&table).unwrap(), spec, "{table}");
        }
        let auto = read("resolution = 'auto'\naccuracy = 1").unwrap();
        assert_eq!(auto.prescribed_accuracy(), Some(1.0));
    }

    #[test]
    fn what_is_wrong_is_named() {
        let owners = "`grid` is an option of fastrip and fastsim, not of linear";
        assert_eq!(refused("theory = 'linear'\ngrid = [9, 9]"), owners);
        assert!(refused("theory = 'lineer'").contains("did you mean `linear`?"));
        assert!(refused("gird = 1").contains("did you mean `grid`?"));
        assert!(refused("xyz = 1").contains("known are resolution, accuracy"));
        let bound = refused("theory = 'fastsim'\nbound = 'kept'");
        assert!(bound.starts_with("bound = \"kept\" is not valid for fastsim"), "{bound}");
        assert!(bound.contains("`parabolic` or `elliptic`"), "{bound}");
        for grid in ["[1, 2, 3]", "[1]", "9", "[-1, 2]"] {
            let words = refused(&format!("theory = 'fastsim'\ngrid = {grid}"));
            assert!(words.starts_with("grid = "), "{words}");
        }
    }
}
