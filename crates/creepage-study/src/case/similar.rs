//! Suggestion of the name that a misspelt one may stand for.

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
