//! A theory by its name and the text of its options.

use creepage::TheorySpec;
use serde::Deserialize;

use crate::failure::Failure;

/// The theory `name`; `options` are of its own only, as in the section `solve` of a case file.
pub(crate) fn spec(name: &str, options: &str) -> Result<TheorySpec, Failure> {
    let facts = TheorySpec::named(name)?.facts();
    let mut options: toml::Table = options.parse()?;
    if let Some(option) = options.keys().find(|key| !facts.options.contains(&key.as_str())) {
        let option = option.clone();
        return Err(Failure::Option { option, theory: facts.name });
    }
    options.insert("theory".into(), name.into());
    Ok(TheorySpec::deserialize(options)?)
}

/// What is wrong with an option of the theory's.
pub(crate) fn foreign(option: &str, theory: &str) -> String {
    let all = TheorySpec::all().map(|spec| spec.facts());
    let has = all.iter().filter(|facts| facts.options.contains(&option));
    let owners: Vec<_> = has.map(|facts| facts.name).collect();
    if owners.is_empty() {
        return format!("`{option}` is not an option of {theory}");
    }
    format!("`{option}` is an option of {}, not of {theory}", owners.join(" and "))
}
