//! Sections and keys of a file against those of the format, which the schema knows.

use serde_json::Value;
use toml::Table;

use crate::case::error::CaseError;

/// Every key must be one of those of `schema`, and none that is required may be missing.
pub(crate) fn check(file: &Table, schema: &Value) -> Result<(), CaseError> {
    for key in file.keys() {
        if schema["properties"][key].is_null() {
            return Err(unknown(key, "", schema));
        }
    }
    for section in required(schema) {
        if !file.contains_key(section) {
            let needs = names(&schema["properties"][section]).join(", ");
            return Err(CaseError::MissingSection { section: section.into(), needs });
        }
    }
    for (section, content) in file {
        // What has a choice of forms is read by its own rules.
        let of_one_form = schema["properties"][section]["properties"].is_object();
        if let Some(table) = content.as_table().filter(|_| of_one_form) {
            check_section(section, table, schema)?;
        }
    }
    Ok(())
}

/// The same for the keys of one section.
fn check_section(section: &str, table: &Table, schema: &Value) -> Result<(), CaseError> {
    let form = &schema["properties"][section];
    if let Some(key) = table.keys().find(|key| form["properties"][key].is_null()) {
        return Err(unknown(key, section, schema));
    }
    match required(form).find(|key| !table.contains_key(*key)) {
        Some(key) => Err(CaseError::Missing { section: section.into(), key: key.into() }),
        None => Ok(()),
    }
}

fn required(form: &Value) -> impl Iterator<Item = &str> {
    form["required"].as_array().into_iter().flatten().filter_map(Value::as_str)
}

fn names(form: &Value) -> Vec<&str> {
    form["properties"].as_object().into_iter().flatten().map(|(name, _)| &name[..]).collect()
}

/// An unknown key, with the likely meaning: in its own section first, then in the others.
fn unknown(key: &str, section: &str, schema: &Value) -> CaseError {
    let form = if section.is_empty() { schema } else { &schema["properties"][section] };
    let here = names(form);
    let hint = if let Some(name) = similar(key, &here) {
        format!("did you mean `{name}`?")
    } else if let Some((other, name)) = elsewhere(key, schema) {
        format!("did you mean `{name}` in [{other}]?")
    } else {
        format!("known are {}", here.join(", "))
    };
    let place = if section.is_empty() { "the file".into() } else { format!("[{section}]") };
    CaseError::UnknownKey { key: key.into(), place, hint }
}

fn elsewhere<'a>(key: &str, schema: &'a Value) -> Option<(&'a str, &'a str)> {
    names(schema).into_iter().find_map(|section| {
        let known = names(&schema["properties"][section]);
        similar(key, &known).map(|name| (section, name))
    })
}

/// The name most like `key`, if any is like it at all.
pub(crate) fn similar<'a>(key: &str, names: &[&'a str]) -> Option<&'a str> {
    // Separates slips of the keys and plurals (above 0.85) from other words (below 0.75).
    const ALIKE: f64 = 0.8;
    names
        .iter()
        .map(|name| (strsim::jaro_winkler(key, name), *name))
        .filter(|(likeness, _)| *likeness > ALIKE)
        .max_by(|one, other| one.0.total_cmp(&other.0))
        .map(|(_, name)| name)
}
