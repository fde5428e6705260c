//! `creepage profile`: what profile files hold, and what had to be done to them; standard profiles too.

use std::path::{Path, PathBuf};
use std::{fs, io};

use creepage_rail::file::{Format, ReadOptions, Reading, read, write};
use creepage_rail::{Profile, Role, Side, Smoothing, Standard};
use creepage_study::{Sources, profile_pictures, write_all};
use serde_json::{Value, json};

use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::output::{complain, print, say_written, to_json};
use crate::rail_args::{
    LateralSense, ProfileArgs, ProfileFormat, RoleName, SideName, UprightSense,
};
use crate::survey;

/// Points of a converted file lie at most this far apart (m).
const SPACING: f64 = 5e-4;

/// What an argument names.
enum NamedProfile {
    Standard(Profile),
    File(Reading),
}

impl NamedProfile {
    fn profile(&self) -> &Profile {
        match self {
            Self::Standard(profile) => profile,
            Self::File(reading) => &reading.profile,
        }
    }
}

/// The files first, then the words, so that a wrong `--out` prints nothing. A profile that cannot
/// be read keeps all files from being written, but not the words on the others.
pub(crate) fn run(args: &ProfileArgs) -> Result<Outcome, Failure> {
    if args.list {
        print(&listed())?;
        return Ok(Outcome::Done);
    }
    if let Some(value) = args.unit.filter(|unit| !(*unit > 0.0 && unit.is_finite())) {
        return Err(Failure::Unit { value });
    }
    if let (false, Some(out)) = (args.survey.is_empty(), &args.out) {
        return survey::run(args, out);
    }
    told(args).map(|()| Outcome::Done)
}

/// The standard profiles, a line each.
fn listed() -> String {
    let lines = Standard::NAMES.iter().map(|(name, standard)| {
        format!("{name:<15} {:<6} {}\n", standard.role().to_string(), standard.source())
    });
    lines.collect()
}

/// Says what profiles hold, and writes the files.
fn told(args: &ProfileArgs) -> Result<(), Failure> {
    let wanted = args.wanted();
    let find = |path: &PathBuf| (path.clone(), find(path, &wanted));
    let found: Vec<(PathBuf, Result<NamedProfile, Failure>)> =
        args.profiles.iter().map(find).collect();
    if let Some(directory) = &args.out
        && found.iter().all(|(_, one)| one.is_ok())
    {
        let read =
            found.iter().filter_map(|(path, one)| Some((path.as_path(), one.as_ref().ok()?)));
        say_written(&written(directory, &read.collect::<Vec<_>>(), args.convert)?);
    }
    if args.json {
        let facts = found.iter().map(|(path, one)| match one {
            Ok(found) => facts(path, found),
            Err(failure) => json!({ "file": path, "error": failure.to_string() }),
        });
        print(&to_json(&facts.collect::<Vec<Value>>())?)?;
    } else {
        let read = found.iter().filter_map(|(path, one)| Some(words(path, one.as_ref().ok()?)));
        let texts: Vec<String> = read.collect();
        if !texts.is_empty() {
            print(&texts.join("\n"))?;
        }
    }
    let mut failures = found.into_iter().filter_map(|(_, one)| one.err()).peekable();
    while let Some(failure) = failures.next() {
        if failures.peek().is_none() {
            return Err(failure);
        }
        complain(&failure.to_string());
    }
    Ok(())
}

/// As in a case file: a standard profile by its name, else a file.
fn find(path: &Path, wanted: &ReadOptions) -> Result<NamedProfile, Failure> {
    if let Some(standard) = path.to_str().and_then(Standard::named) {
        if *wanted != ReadOptions::default() {
            return Err(Failure::NothingToRead { profile: standard.name() });
        }
        return Ok(NamedProfile::Standard(standard.profile()));
    }
    let content = fs::read(path).map_err(|source| nowhere(path, source))?;
    read(&path.to_string_lossy(), &content, wanted)
        .map(NamedProfile::File)
        .map_err(|source| Failure::Profile { path: path.into(), source })
}

fn nowhere(path: &Path, source: io::Error) -> Failure {
    let is_bare = path.extension().is_none() && path.components().count() == 1;
    if is_bare && source.kind() == io::ErrorKind::NotFound {
        return Failure::NoProfile { path: path.into() };
    }
    Failure::Read { path: path.into(), source }
}

/// Writes the files of all profiles: over none that was read, no two of one name, and a converted
/// profile over no other file, which may be somebody's measurement. Pictures are replaced.
fn written(
    directory: &Path,
    profiles: &[(&Path, &NamedProfile)],
    convert: Option<ProfileFormat>,
) -> Result<Vec<PathBuf>, Failure> {
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    for (path, found) in profiles {
        for (name, content) in made_of(path, found.profile(), convert)? {
            let target = directory.join(&name);
            if files.iter().any(|(other, _)| *other == name) {
                return Err(Failure::SameName { path: target });
            }
            let ending = Path::new(&name).extension();
            let is_picture = ending.is_some_and(|ending| ending == "svg" || ending == "png");
            let is_other = || fs::read(&target).is_ok_and(|there| there != content);
            if !is_picture && !is_source(&target, profiles) && is_other() {
                return Err(Failure::Exists { path: target });
            }
            files.push((name, content));
        }
    }
    let files: Vec<(&str, &[u8])> =
        files.iter().map(|(name, content)| (&name[..], &content[..])).collect();
    let read = profiles.iter().filter(|(_, found)| matches!(found, NamedProfile::File(_)));
    Ok(write_all(directory, &files, &Sources::new(read.map(|(path, _)| *path)))?)
}

/// Whether a file is one of those that were read, over which [`write_all`] writes nothing.
fn is_source(target: &Path, profiles: &[(&Path, &NamedProfile)]) -> bool {
    let files = profiles.iter().filter(|(_, found)| matches!(found, NamedProfile::File(_)));
    Sources::new(files.map(|(path, _)| *path)).ensure_not_overwritten(target).is_err()
}

/// The picture, and the profile in another format: names and contents of files.
fn made_of(
    path: &Path,
    profile: &Profile,
    convert: Option<ProfileFormat>,
) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let title = path.file_stem().unwrap_or_default().to_string_lossy();
    // Not every system allows the colon of `cone-1:20`.
    let stem = title.replace(':', "-");
    let [svg, png] = profile_pictures(&title, profile)?;
    let mut files = vec![(format!("{stem}.svg"), svg), (format!("{stem}.png"), png)];
    if let Some(format) = convert {
        let text = write(profile, format.into(), SPACING);
        files.push((format!("{stem}.{}", format.ending(profile.role())), text.into()));
    }
    Ok(files)
}

fn name(format: Format) -> &'static str {
    match format {
        Format::Simpack => "Simpack",
        Format::MiniProf => "MiniProf",
        Format::Vampire => "VAMPIRE",
        Format::Gensys => "GENSYS",
        Format::Columns => "two columns",
        Format::Json => "JSON",
    }
}

fn words(path: &Path, found: &NamedProfile) -> String {
    let (given, profile) = (path.display(), found.profile());
    let (role, length) = (profile.role(), 1e3 * profile.curve().length());
    match found {
        NamedProfile::Standard(_) => format!("{given}: {role}, standard, {length:.1} mm long\n"),
        NamedProfile::File(Reading { format, points, actions, .. }) => {
            let format = name(*format);
            let head = format!("{given}: {role}, {format}, {points} points, {length:.1} mm long\n");
            actions.iter().fold(head, |text, action| format!("{text}  {action}\n"))
        }
    }
}

/// What only a file has is `null` of a standard profile.
fn facts(path: &Path, found: &NamedProfile) -> Value {
    let profile = found.profile();
    let (role, length) = (profile.role().to_string(), profile.curve().length());
    match found {
        NamedProfile::Standard(_) => json!({
            "standard": path, "file": null, "role": role, "format": null, "points": null,
            "length_m": length, "actions": [],
        }),
        NamedProfile::File(Reading { format, points, actions, .. }) => {
            let actions: Vec<String> = actions.iter().map(ToString::to_string).collect();
            json!({
                "standard": null, "file": path, "role": role, "format": name(*format),
                "points": points, "length_m": length, "actions": actions,
            })
        }
    }
}

impl ProfileArgs {
    /// What is asked for in place of what would be found.
    pub(crate) fn wanted(&self) -> ReadOptions {
        ReadOptions {
            format: None,
            role: self.role.map(|role| match role {
                RoleName::Wheel => Role::Wheel,
                RoleName::Rail => Role::Rail,
            }),
            side: self.side.map(|side| match side {
                SideName::Left => Side::Left,
                SideName::Right => Side::Right,
            }),
            unit: self.unit,
            field_side: self.y.map(|sense| sense == LateralSense::FieldSide),
            down: self.z.map(|sense| sense == UprightSense::Down),
            smoothing: self.smooth.map(Smoothing::Wavelength),
            corners: None,
        }
    }
}

impl From<ProfileFormat> for Format {
    fn from(format: ProfileFormat) -> Self {
        match format {
            ProfileFormat::Simpack => Self::Simpack,
            ProfileFormat::Miniprof => Self::MiniProf,
            ProfileFormat::Vampire => Self::Vampire,
            ProfileFormat::Gensys => Self::Gensys,
            ProfileFormat::Columns => Self::Columns,
        }
    }
}

impl ProfileFormat {
    /// The ending of a file's name.
    fn ending(self, role: Role) -> &'static str {
        let [rail, wheel] = match self {
            Self::Simpack => ["prr", "prw"],
            Self::Miniprof => ["ban", "whl"],
            Self::Vampire => ["rai", "whe"],
            Self::Gensys => ["rail", "wheel"],
            Self::Columns => ["txt", "txt"],
        };
        if role == Role::Rail { rail } else { wheel }
    }
}
