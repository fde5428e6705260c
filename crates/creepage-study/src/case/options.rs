//! Options of a theory that stand outside a case file, as on a command line.

use toml::Table;

use crate::case::error::CaseError;
use crate::case::keys;
use crate::case::solve::Solve;
use crate::json_schema;

impl Solve {
    /// Reads options that stand outside a case file, each as `key = value` or `key=value`; a word
    /// needs no quotes.
    ///
    /// ```
    /// let options = ["grid=[20, 10]", "bound=parabolic"];
    /// assert_eq!(creepage_study::Solve::read(&options)?.grid, Some([20, 10]));
    /// # Ok::<(), creepage_study::CaseError>(())
    /// ```
    ///
    /// # Errors
    /// [`CaseError`] for what `[solve]` of a case file may not say either.
    pub fn read(options: &[impl AsRef<str>]) -> Result<Self, CaseError> {
        let lines: Vec<_> = options.iter().map(|option| quoted(option.as_ref())).collect();
        let text = lines.join("\n");
        keys::check_section("solve", &text.parse()?, &json_schema())?;
        Ok(toml::from_str(&text)?)
    }
}

/// The option as a line of TOML: what is no value of TOML is text.
fn quoted(option: &str) -> String {
    match option.split_once('=') {
        Some((key, word)) if option.parse::<Table>().is_err() => {
            format!("{key}={}", toml::Value::from(word.trim()))
        }
        _ => option.into(),
    }
}
