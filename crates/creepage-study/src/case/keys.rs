//! Keys of a case file: sections and keys against those of the format, which the schema knows; suggestions for misspelt ones, and the TOML reader's messages in plain words.

use crate::case::error::CaseError;
use serde_json::Value;
use toml::Table;

/// The sections of a text.
pub(crate) fn parse(text: &str) -> Result<Table, CaseError> {
    text.parse().map_err(|error| bare_word(text, &error).unwrap_or(CaseError::Toml(error)))
}

/// A word without quotes at the place of an error, which TOML takes for the beginning of `false`.
fn bare_word(text: &str, error: &toml::de::Error) -> Option<CaseError> {
    let start = error.span()?.start.min(text.len());
    let before = text.get(..start)?;
    let line = text.lines().nth(before.matches('\n').count())?;
    let (key, value) = line.split_once('=')?;
    let (key, word) = (key.trim(), value.split('#').next()?.trim());
    let is_word = word.starts_with(|c: char| c.is_ascii_alphabetic())
        && word.chars().all(|c| c.is_ascii_alphanumeric() || "-_".contains(c));
    is_word.then(|| CaseError::BareWord { key: key.into(), word: word.into() })
}

/// Every key must be one of those of `schema`, and none that is required may be missing.
pub(crate) fn check(file: &Table, schema: &Value) -> Result<(), CaseError> {
    let strange = || file.keys().filter(|key| schema["properties"][key.as_str()].is_null());
    // A section of another kind of file says more than a misspelt one.
    let of_other_kind = strange().find(|key| other_kind(key, "").is_some());
    if let Some(key) = of_other_kind.or_else(|| strange().next()) {
        return Err(unknown(key, "", schema));
    }
    for section in required(schema) {
        if !file.contains_key(section) {
            let needs = needs(&schema["properties"][section]);
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
    let hint = if let Some(kind) = other_kind(key, section) {
        kind.into()
    } else if let Some(name) = similar(key, &here) {
        format!("did you mean `{name}`?")
    } else if let Some((other, name)) = elsewhere(key, schema) {
        format!("did you mean `{name}` in [{other}]?")
    } else {
        format!("known are {}", here.join(", "))
    };
    let place = if section.is_empty() { "the file".into() } else { format!("[{section}]") };
    CaseError::UnknownKey { key: key.into(), place, hint }
}

/// What a section needs, in words.
fn needs(form: &Value) -> String {
    let mut needed: Vec<_> = required(form).map(ToOwned::to_owned).collect();
    if names(form).contains(&"shear_modulus") {
        needed.push("shear_modulus or young_modulus".into());
    }
    if needed.is_empty() { names(form).join(", ") } else { needed.join(", ") }
}

/// Where a section belongs that this kind of file does not have.
fn other_kind(key: &str, section: &str) -> Option<&'static str> {
    match key {
        "line_load" if section == "contact" => {
            Some("it makes a line contact, for `creepage solve` and `creepage roll`")
        }
        _ if !section.is_empty() => None,
        "relaxation" => Some("it belongs to line contacts, for `creepage solve`"),
        "bearing" | "ball" | "inner" | "outer" => {
            Some("it belongs to bearing files, for `creepage bearing`")
        }
        "start" => Some("it belongs to wheelset files that roll, for `creepage roll`"),
        "statics" => Some("it belongs to statics files, for `creepage statics`"),
        "chain" | "page" => Some("it belongs to sweep files, for `creepage sweep`"),
        "wheel" | "wheel_left" | "wheel_right" | "rail" | "rail_left" | "rail_right" | "track"
        | "wheelset" | "motion" | "materials" => {
            Some("it belongs to wheelset files, for `creepage wheelset`")
        }
        "creepage" | "wanted" | "solve" | "gap" => {
            Some("it belongs to case files, for `creepage solve`")
        }
        _ => None,
    }
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

/// The name that `word` is but for capitals, or for two letters of a long one.
///
/// ```
/// use creepage_study::misspelt;
/// let names = ["longitudinal", "lateral_force", "y"];
/// assert_eq!(misspelt("longitudnal", &names), Some("longitudinal"));
/// assert_eq!(misspelt("Y", &names), Some("y"));
/// assert_eq!(misspelt("lateral_n", &names), None);
/// ```
#[must_use]
pub fn misspelt<'a>(word: &str, names: &[&'a str]) -> Option<&'a str> {
    const LONG: usize = 5;
    let word = word.to_ascii_lowercase();
    let distance = |name: &str| strsim::osa_distance(&word, name);
    let is_it = |name: &&str| distance(name) == 0 || (name.len() >= LONG && distance(name) <= 2);
    names.iter().copied().filter(is_it).min_by_key(|name| distance(name))
}

/// Its types, the longer names first, and what they are.
const TYPES: [(&str, &str); 9] = [
    ("usize", "a whole number that is not negative"),
    ("u64", "a whole number that is not negative"),
    ("u32", "a whole number that is not negative"),
    ("i64", "a whole number"),
    ("i32", "a whole number"),
    ("f64", "a number"),
    ("f32", "a number"),
    ("a boolean", "true or false"),
    ("a string", "a word"),
];

/// A message of the reader of TOML in plain words.
#[must_use]
pub fn plain_words(message: &str) -> String {
    let mut words = message.to_owned();
    for (name, plain) in TYPES {
        words = words.replace(&format!("expected {name}"), &format!("expected {plain}"));
    }
    words.replace("floating point `", "number `").replace("integer `", "number `")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_of_the_program_become_kinds_of_numbers() {
        let message = "invalid type: floating point `7.5`, expected usize";
        let plain = "invalid type: number `7.5`, expected a whole number that is not negative";
        assert_eq!(plain_words(message), plain);
    }
}
