//! Profile files that an input file names.

use std::fs;
use std::path::{Component, Path, PathBuf};

use creepage_rail::file::{ReadOptions, SliceList, read};
use creepage_rail::{Profile, Role};

use crate::text::{comments, list as list_of, number, quoted};
use crate::wheels::ProfileFile;
use crate::{File, ImportError, NotWritten};

/// Where profiles are looked for, and those that were found.
#[derive(Debug)]
pub(crate) struct Profiles {
    /// The input file's name.
    input: String,
    /// The directory of the input file.
    from: PathBuf,
    /// The directory of the case files.
    to: PathBuf,
    /// Found files that lie elsewhere, each with its name beside the case files.
    copied: Vec<(PathBuf, String)>,
    /// Lists of slices: their path, and what stands for them beside the case files.
    lists: Vec<(PathBuf, SlicesRead)>,
}

/// What MIRRORY does to a profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// Nothing: it reads so by itself.
    AsRead,
    /// `y` points where MIRRORY says, and not where the format has it.
    Said,
    /// The flange lies on the other side.
    AgainstShape,
}

/// A list of slices as a file of ours.
#[derive(Debug, Clone)]
pub(crate) struct SlicesRead {
    pub(crate) file: File,
    /// The first slice's profile, as the list has it.
    pub(crate) first: String,
    pub(crate) approximates: bool,
    pub(crate) accelerations: usize,
}

impl Profiles {
    pub(crate) fn new(input: &Path, to: &Path) -> Self {
        let from = input.parent().unwrap_or(Path::new("")).to_path_buf();
        let input = input.file_name().unwrap_or_default().to_string_lossy().into_owned();
        Self { input, from, to: to.to_path_buf(), copied: Vec::new(), lists: Vec::new() }
    }

    /// The name of a profile as a case file has it.
    pub(crate) fn name(&mut self, given: &str) -> Result<String, NotWritten> {
        let path = find(&self.from, given).ok_or_else(|| not_found(given, &self.input))?;
        Ok(self.name_of(path))
    }

    /// A list of slices as a file of ours, whose profiles lie beside the case files.
    pub(crate) fn slices(&mut self, given: &str, role: Role) -> Result<SlicesRead, NotWritten> {
        let unread = |why: String| NotWritten::Unread { file: given.into(), why };
        let path = find(&self.from, given).ok_or_else(|| not_found(given, &self.input))?;
        if let Some((_, known)) = self.lists.iter().find(|(known, _)| *known == path) {
            return Ok(known.clone());
        }
        let text = fs::read(&path).map_err(|error| unread(error.to_string()))?;
        let list = SliceList::read(&String::from_utf8_lossy(&text), role);
        let list = list.map_err(|error| unread(error.to_string()))?;
        let beside = path.parent().unwrap_or(Path::new("")).to_path_buf();
        let mut lines = Vec::new();
        for (u, profile, features) in &list.slices {
            let missing = || not_found(profile, given);
            let profile = self.name_of(find(&beside, profile).ok_or_else(missing)?);
            let features = if features.is_empty() {
                String::new()
            } else {
                format!(", features = {}", list_of(features.iter().copied()))
            };
            lines.push(format!(
                "    {{ u = {}, profile = {}{features} }},\n",
                number(*u),
                quoted(&profile)
            ));
        }
        let unit = if role == Role::Rail { "m along the track" } else { "rad around the wheel" };
        let kinks = if list.kinks.is_empty() {
            String::new()
        } else {
            format!("kinks = {:?}\n", list.kinks)
        };
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let head =
            comments(&[format!("Slices of {name}: u in {unit}, arc lengths of features in m.")]);
        let contents = format!("{head}{kinks}slices = [\n{}]\n", lines.concat());
        let free = |name: &str| self.lists.iter().all(|(_, list)| list.file.name != name);
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let names = std::iter::once(format!("{stem}.slices.toml"));
        let mut names = names.chain((2..).map(|count| format!("{count}-{stem}.slices.toml")));
        let file = names.find(|name| free(name)).unwrap_or(stem);
        let read = SlicesRead {
            file: File::text(file, contents),
            first: list.slices.first().map(|(_, name, _)| name.clone()).unwrap_or_default(),
            approximates: list.approximates,
            accelerations: list.accelerations,
        };
        self.lists.push((path, read.clone()));
        Ok(read)
    }

    /// The name of a file that was found, as it lies beside the case files.
    fn name_of(&mut self, path: PathBuf) -> String {
        let path = path.canonicalize().unwrap_or(path);
        if let Ok(to) = self.to.canonicalize()
            && let Ok(inside) = path.strip_prefix(to)
        {
            return inside.to_string_lossy().replace('\\', "/");
        }
        if let Some((_, name)) = self.copied.iter().find(|(copied, _)| *copied == path) {
            return name.clone();
        }
        let base = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let is_free =
            |name: &str| self.copied.iter().all(|(_, other)| !other.eq_ignore_ascii_case(name));
        let numbered = (2..).map(|number| format!("{number}-{base}"));
        let name = std::iter::once(base.clone()).chain(numbered).find(|name| is_free(name));
        let name = name.unwrap_or(base);
        self.copied.push((path, name.clone()));
        name
    }

    /// Whether a rail's profile has a groove with a guard rail beside it: not where the wheel is narrower than the
    /// groove, in which it runs then.
    pub(crate) fn is_grooved(&self, rail: &ProfileFile, wheel: &ProfileFile) -> bool {
        let Some(opening) = self.profile(rail, Role::Rail).and_then(|rail| rail.groove_opening())
        else {
            return false;
        };
        self.profile(wheel, Role::Wheel).is_none_or(|wheel| wheel.width() > opening)
    }

    /// A profile as it reads by itself.
    fn profile(&self, file: &ProfileFile, role: Role) -> Option<Profile> {
        let content = fs::read(find(&self.from, &file.name)?).ok()?;
        let down = (file.mirror_z == 1).then_some(false);
        let wanted = ReadOptions { role: Some(role), down, ..ReadOptions::default() };
        Some(read(&file.name, &content, &wanted).ok()?.profile)
    }

    /// Whether MIRRORY has to be said: what the file is without it, and with it.
    pub(crate) fn side(&self, file: &ProfileFile, role: Role) -> Side {
        let Some(content) = find(&self.from, &file.name).and_then(|path| fs::read(path).ok())
        else {
            return Side::AsRead;
        };
        let down = (file.mirror_z == 1).then_some(false);
        let of = |field_side: Option<bool>| {
            let wanted =
                ReadOptions { role: Some(role), down, field_side, ..ReadOptions::default() };
            read(&file.name, &content, &wanted).ok().map(|found| found.profile)
        };
        match (of(None), of(Some(!file.mirror_y))) {
            (Some(by_itself), Some(as_said)) if by_itself == as_said => Side::AsRead,
            (Some(_), None) => Side::AgainstShape,
            (None, None) => Side::AsRead,
            (_, Some(_)) => Side::Said,
        }
    }

    /// The files that are to be copied beside the case files.
    pub(crate) fn files(&self) -> Result<Vec<File>, ImportError> {
        let lists = self.lists.iter().map(|(_, list)| Ok(list.file.clone()));
        self.copied
            .iter()
            .map(|(path, name)| {
                let read = fs::read(path);
                let contents =
                    read.map_err(|source| ImportError::Read { path: path.clone(), source })?;
                Ok(File { name: name.clone(), contents })
            })
            .chain(lists)
            .collect()
    }

    /// What was read.
    pub(crate) fn paths(&self) -> Vec<PathBuf> {
        let lists = self.lists.iter().map(|(path, _)| path.clone());
        self.copied.iter().map(|(path, _)| path.clone()).chain(lists).collect()
    }
}

fn not_found(file: &str, beside: &str) -> NotWritten {
    NotWritten::NotFound { file: file.into(), beside: beside.into() }
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
