//! Files of profiles that an input file names.

use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::{File, ImportError};

/// Where profiles are looked for, and those that were found.
#[derive(Debug)]
pub(crate) struct Profiles {
    /// The directory of the input file.
    from: PathBuf,
    /// The directory of the case files.
    to: PathBuf,
    /// Found files that lie elsewhere, each with its name beside the case files.
    copied: Vec<(PathBuf, String)>,
}

impl Profiles {
    pub(crate) fn new(input: &Path, to: &Path) -> Self {
        let from = input.parent().unwrap_or(Path::new("")).to_path_buf();
        Self { from, to: to.to_path_buf(), copied: Vec::new() }
    }

    /// The name of a profile as a case file has it.
    pub(crate) fn name(&mut self, given: &str) -> Result<String, String> {
        let missing = || format!("there is no profile {given} beside the input file");
        let path = find(&self.from, given).ok_or_else(missing)?;
        let path = path.canonicalize().unwrap_or(path);
        if let Ok(to) = self.to.canonicalize()
            && let Ok(inside) = path.strip_prefix(to)
        {
            return Ok(inside.to_string_lossy().replace('\\', "/"));
        }
        if let Some((_, name)) = self.copied.iter().find(|(copied, _)| *copied == path) {
            return Ok(name.clone());
        }
        let base = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let is_free =
            |name: &str| self.copied.iter().all(|(_, other)| !other.eq_ignore_ascii_case(name));
        let numbered = (2..).map(|number| format!("{number}-{base}"));
        let name = std::iter::once(base.clone()).chain(numbered).find(|name| is_free(name));
        let name = name.unwrap_or(base);
        self.copied.push((path, name.clone()));
        Ok(name)
    }

    /// The median distance between points of a profile that are next to each other, in its own unit; `None`
    /// where fewer than three lines hold two numbers.
    pub(crate) fn spacing(&self, given: &str) -> Option<f64> {
        let text = fs::read(find(&self.from, given)?).ok()?;
        let text = String::from_utf8_lossy(&text);
        let points = text.lines().filter_map(|line| {
            let mut words = line.split(|c: char| c.is_whitespace() || c == ',' || c == ';');
            let mut number = || words.by_ref().find(|word| !word.is_empty())?.parse::<f64>().ok();
            Some([number()?, number()?])
        });
        let points: Vec<[f64; 2]> = points.collect();
        let apart = |pair: &[[f64; 2]]| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        let mut distances: Vec<f64> = points.windows(2).map(apart).filter(|d| *d > 0.0).collect();
        distances.sort_by(f64::total_cmp);
        (distances.len() > 1).then(|| distances[distances.len() / 2]).filter(|d| d.is_finite())
    }

    /// The files that are to be copied beside the case files.
    pub(crate) fn files(&self) -> Result<Vec<File>, ImportError> {
        self.copied
            .iter()
            .map(|(path, name)| {
                let read = fs::read(path);
                let contents =
                    read.map_err(|source| ImportError::Read { path: path.clone(), source })?;
                Ok(File { name: name.clone(), contents })
            })
            .collect()
    }

    /// What was read.
    pub(crate) fn paths(&self) -> Vec<PathBuf> {
        self.copied.iter().map(|(path, _)| path.clone()).collect()
    }
}

/// The file of that name, whatever the case of its letters and its separators.
fn find(directory: &Path, given: &str) -> Option<PathBuf> {
    let given = given.replace('\\', "/");
    let direct = directory.join(&given);
    if direct.is_file() {
        return Some(direct);
    }
    let mut found =
        if given.starts_with('/') { PathBuf::from("/") } else { directory.to_path_buf() };
    for component in Path::new(&given).components() {
        match component {
            Component::Normal(name) => {
                let here = if found.as_os_str().is_empty() { Path::new(".") } else { &found };
                let mut names: Vec<_> = fs::read_dir(here)
                    .ok()?
                    .filter_map(|entry| Some(entry.ok()?.file_name()))
                    .collect();
                // The order of a directory is no order.
                names.sort();
                let fits = |other: &&std::ffi::OsString| other.eq_ignore_ascii_case(name);
                let exact = names.iter().find(|other| *other == name);
                let name = exact.or_else(|| names.iter().find(fits))?;
                found.push(name);
            }
            Component::ParentDir => found.push(".."),
            _ => {}
        }
    }
    found.is_file().then_some(found)
}
