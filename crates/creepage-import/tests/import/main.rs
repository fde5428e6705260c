//! Input files of our own making, read and written.

#![allow(clippy::unwrap_used)] // helpers of tests

mod bodies;
mod odd;
mod wheels;

use std::fs;

use creepage_import::{Case, ImportError, Imported, import};

/// Words of a case of module 3 up to its friction.
pub(crate) fn head(first: &str, second: &str) -> String {
    format!(
        " 3 MODULE\n {first} PBTNFS\n {second} LDCMZE\n 0000341 HGIAOWR\n 50 50 30 1 1e-6 settings\n"
    )
}

/// A steady case: a ball, wanted force or creepage as the digits say.
pub(crate) fn ball(first: &str, kinematics: &str, rolling: &str) -> String {
    head(first, "022020")
        + &format!(
            " {kinematics} load\n 0.3 0.3 friction\n {rolling}\n 0.28 0.28 82000. 82000. material\n 1 IPOTCN\n \
             9 9 -0.9 -0.9 0.2 0.2 grid\n 1 1 kinds\n .005 .0 .005 .0 .0 .0 shape\n"
        )
}

pub(crate) fn read(text: &str) -> Result<Imported, ImportError> {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("own.inp");
    fs::write(&path, text).unwrap();
    import(&path, &place.path().join("out"))
}

pub(crate) fn text(case: &Case, file: usize) -> String {
    let written = case.written.as_ref().unwrap();
    String::from_utf8(written.files[file].contents.clone()).unwrap()
}

pub(crate) fn has(text: &str, lines: &[&str]) {
    for line in lines {
        assert!(text.lines().any(|other| other == *line), "{line} is not in\n{text}");
    }
}
