//! A wheelset's file with the profiles that it names, as files of one folder, to be read elsewhere.

use std::path::{Path, PathBuf};

use toml::Value;

use super::case::WheelsetCase;
use super::error::WheelsetFileError;
use crate::case::CaseError;

/// A wheelset's file whose profiles lie beside it.
#[derive(Debug, Clone, PartialEq)]
pub struct PackedWheelset {
    /// Its text, which names them so.
    pub text: String,
    /// Their names, and the files that they were read from.
    pub profiles: Vec<(String, PathBuf)>,
}

impl WheelsetCase {
    /// This case, read from `text` in `directory`, with its profiles by names of their own, which begin with `profile-`.
    ///
    /// # Errors
    /// [`WheelsetFileError`] where the text is no TOML.
    pub fn packed(
        &self,
        text: &str,
        directory: &Path,
    ) -> Result<PackedWheelset, WheelsetFileError> {
        let wrong = |error: toml::de::Error| WheelsetFileError::from(CaseError::from(error));
        let mut table: toml::Table = text.parse().map_err(wrong)?;
        let mut profiles: Vec<(String, PathBuf)> = Vec::new();
        for note in &self.notes {
            if profiles.iter().all(|(_, path)| *path != note.path) {
                let mut name = PathBuf::from(format!("profile-{}", profiles.len() + 1));
                // Which says how it is read.
                name.set_extension(note.path.extension().unwrap_or_default());
                profiles.push((name.display().to_string(), note.path.clone()));
            }
        }
        table.iter_mut().for_each(|(_, value)| rename(value, directory, &profiles));
        Ok(PackedWheelset { text: table.to_string(), profiles })
    }
}

/// Gives profiles their names wherever they stand.
fn rename(value: &mut Value, directory: &Path, profiles: &[(String, PathBuf)]) {
    match value {
        Value::String(text) => {
            let path = directory.join(&*text);
            if let Some((name, _)) = profiles.iter().find(|(_, own)| *own == path) {
                text.clone_from(name);
            }
        }
        Value::Array(all) => all.iter_mut().for_each(|one| rename(one, directory, profiles)),
        Value::Table(all) => {
            all.iter_mut().for_each(|(_, one)| rename(one, directory, profiles));
        }
        _ => {}
    }
}
