//! FMU archive: description, library, and a contact map or a wheelset's file with its profiles.

use std::fs;
use std::io::{Cursor, Write};
use std::path::Path;

use creepage_map::ContactMap;
use creepage_study::{WheelsetFile, WheelsetFileError};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use crate::contacts::{Contacts, ContactsError};
use crate::description::{IDENTIFIER, description};
use crate::instance::Instance;
use crate::resources::{MAP, WHEELSET, token};
use crate::solver::Solver;

/// Version of the Functional Mock-up Interface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Version {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}

/// Error of packing an FMU.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PackError {
    /// Something that cannot answer in an FMU.
    #[error(transparent)]
    Contacts(#[from] ContactsError),
    /// A library without the functions of the interface.
    #[error("the library has no function {name}: it is not that of creepage-fmu")]
    NotTheLibrary {
        /// The function that was looked for.
        name: &'static str,
    },
    /// A system that has no name among those of the FMI.
    #[error("there is no name for the platform {system} on {machine} in the FMI")]
    Platform {
        /// The operating system.
        system: &'static str,
        /// The machine.
        machine: &'static str,
    },
    /// The archive cannot be written.
    #[error("the archive cannot be written: {0}")]
    Archive(#[from] zip::result::ZipError),
    /// Its contents cannot be written.
    #[error("the archive cannot be written: {0}")]
    Write(#[from] std::io::Error),
}

/// Name of the file of the FMU's library on this system.
#[must_use]
pub fn library_name() -> String {
    format!("{}{IDENTIFIER}{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX)
}

/// The bytes of an FMU for this system that asks a contact map, from those of the map and of the library
/// `creepage-fmu`.
///
/// # Errors
/// [`PackError`].
pub fn pack(map: &[u8], library: &[u8], version: Version) -> Result<Vec<u8>, PackError> {
    check(library, version)?;
    let contacts = ContactMap::from_bytes(map.to_vec()).map_err(ContactsError::from)?;
    let contacts = Contacts::Map(Box::new(contacts));
    archive(contacts, vec![(MAP.to_owned(), map.to_vec())], library, version)
}

/// The bytes of an FMU for this system that solves the wheelset of a file, from that file and the bytes of the library
/// `creepage-fmu`.
///
/// # Errors
/// [`PackError`].
pub fn pack_solver(
    wheelset: &Path,
    library: &[u8],
    version: Version,
) -> Result<Vec<u8>, PackError> {
    check(library, version)?;
    let read = |path: &Path| {
        fs::read(path).map_err(|source| ContactsError::Read { path: path.into(), source })
    };
    let text = String::from_utf8_lossy(&read(wheelset)?).into_owned();
    let directory = wheelset.parent().unwrap_or(Path::new(""));
    let contacts = Contacts::Solver(Box::new(Solver::new(&text, directory)?));
    let file = WheelsetFile::read(&text).map_err(WheelsetFileError::from);
    let case = file.and_then(|file| file.case(directory)).map_err(ContactsError::from)?;
    let packed = case.packed(&text, directory).map_err(ContactsError::from)?;
    let mut files = vec![(WHEELSET.to_owned(), packed.text.into_bytes())];
    for (name, path) in packed.profiles {
        files.push((name, read(&path)?));
    }
    archive(contacts, files, library, version)
}

/// Whether a file is the library.
fn check(library: &[u8], version: Version) -> Result<(), PackError> {
    let name = match version {
        Version::Two => "fmi2DoStep",
        Version::Three => "fmi3DoStep",
    };
    let is_there = library.windows(name.len()).any(|bytes| bytes == name.as_bytes());
    if is_there { Ok(()) } else { Err(PackError::NotTheLibrary { name }) }
}

fn archive(
    contacts: Contacts,
    mut files: Vec<(String, Vec<u8>)>,
    library: &[u8],
    version: Version,
) -> Result<Vec<u8>, PackError> {
    files.sort();
    let instance = Instance::new(contacts);
    let xml = description(version, &token(&files), &instance.inputs);
    let binaries = folder(version)?;
    let ending = std::env::consts::DLL_SUFFIX;
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    let mut add = |name: &str, content: &[u8]| -> Result<(), PackError> {
        archive.start_file(name, options)?;
        Ok(archive.write_all(content)?)
    };
    add("modelDescription.xml", xml.as_bytes())?;
    add(&format!("binaries/{binaries}/{IDENTIFIER}{ending}"), library)?;
    for (name, content) in files {
        add(&format!("resources/{name}"), &content)?;
    }
    Ok(archive.finish()?.into_inner())
}

/// Where the library stands in the archive.
fn folder(version: Version) -> Result<&'static str, PackError> {
    let (system, machine) = (std::env::consts::OS, std::env::consts::ARCH);
    let known = match (version, system, machine) {
        (Version::Two, "linux", "x86_64") => "linux64",
        (Version::Two, "windows", "x86_64") => "win64",
        (Version::Two, "macos", _) => "darwin64",
        (Version::Three, "linux", "x86_64") => "x86_64-linux",
        (Version::Three, "linux", "aarch64") => "aarch64-linux",
        (Version::Three, "windows", "x86_64") => "x86_64-windows",
        (Version::Three, "macos", "x86_64") => "x86_64-darwin",
        (Version::Three, "macos", "aarch64") => "aarch64-darwin",
        _ => return Err(PackError::Platform { system, machine }),
    };
    Ok(known)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_file_is_no_library() {
        for (version, name) in [(Version::Two, "fmi2DoStep"), (Version::Three, "fmi3DoStep")] {
            let refused = pack(b"", b"file,role,points", version);
            assert!(matches!(refused, Err(PackError::NotTheLibrary { name: own }) if own == name));
            // With the function it is the map that is looked at.
            assert!(matches!(pack(b"", name.as_bytes(), version), Err(PackError::Contacts(_))));
        }
    }
}
