//! Resources of an FMU: the files that an instance reads, and the token that binds a description to them.

use std::fs;
use std::path::{Path, PathBuf};

use crate::contacts::ContactsError;

/// Name of a contact map.
pub(crate) const MAP: &str = "wheelset.nc";
/// Name of a wheelset's file.
pub(crate) const WHEELSET: &str = "wheelset.toml";

/// Files by their names in a folder.
#[derive(Debug)]
pub(crate) struct Resources {
    folder: PathBuf,
    files: Vec<(String, Vec<u8>)>,
}

impl Resources {
    /// All that are in a folder, in the order of their names.
    pub(crate) fn read(folder: &Path) -> Result<Self, ContactsError> {
        let wrong = |path: &Path| {
            let path = path.to_path_buf();
            move |source| ContactsError::Read { path, source }
        };
        let mut files = Vec::new();
        for entry in fs::read_dir(folder).map_err(wrong(folder))? {
            let path = entry.map_err(wrong(folder))?.path();
            let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
            // A host may leave folders or files of its own.
            if is_ours(name) {
                files.push((name.to_owned(), fs::read(&path).map_err(wrong(&path))?));
            }
        }
        files.sort();
        Ok(Self { folder: folder.into(), files })
    }

    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    pub(crate) fn get(&self, name: &str) -> Option<&[u8]> {
        self.files.iter().find(|(own, _)| own == name).map(|(_, bytes)| bytes.as_slice())
    }

    pub(crate) fn token(&self) -> String {
        token(&self.files)
    }
}

fn is_ours(name: &str) -> bool {
    name == MAP || name == WHEELSET || name.starts_with(PROFILE)
}

/// How names of profiles begin.
pub(crate) const PROFILE: &str = "profile-";

/// The token of files in the order of their names: a GUID's form, of a checksum and the length.
pub(crate) fn token(files: &[(String, Vec<u8>)]) -> String {
    let (mut sum, mut length) = (crc32fast::Hasher::new(), 0);
    for (_, bytes) in files {
        sum.update(bytes);
        length += bytes.len() as u64;
    }
    format!("{{{:08x}-0000-4000-8000-{length:012x}}}", sum.finalize())
}
