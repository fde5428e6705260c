//! FMU archive: description, library, map.

use std::io::{Cursor, Write};
use std::sync::Arc;

use creepage_map::{ContactMap, MapError};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use crate::description::{IDENTIFIER, description};
use crate::instance::{Instance, token};

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
    /// Bytes that are not those of a map.
    #[error(transparent)]
    Map(#[from] MapError),
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

/// The bytes of an FMU for this system, from those of a map and of the library `creepage-fmu`.
///
/// # Errors
/// [`PackError`].
pub fn pack(map: &[u8], library: &[u8], version: Version) -> Result<Vec<u8>, PackError> {
    let name = match version {
        Version::Two => "fmi2DoStep",
        Version::Three => "fmi3DoStep",
    };
    if !library.windows(name.len()).any(|bytes| bytes == name.as_bytes()) {
        return Err(PackError::NotTheLibrary { name });
    }
    let instance = Instance::new(Arc::new(ContactMap::from_bytes(map.to_vec())?));
    let xml = description(version, &token(map), &instance.inputs);
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
    add("resources/wheelset.nc", map)?;
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
            assert!(matches!(pack(b"", name.as_bytes(), version), Err(PackError::Map(_))));
        }
    }
}
