//! `creepage profile`: what profile files hold, and what had to be done to them.

use std::fs;
use std::path::{Path, PathBuf};

use creepage_rail::file::{Format, Reading, Wanted, read, write};
use creepage_rail::{Role, Side};
use creepage_study::{profile_pictures, write_all};
use serde_json::{Value, json};

use crate::failure::Failure;
use crate::output::{print, say_written, to_json};
use crate::rail_args::{
    LateralSense, ProfileArgs, ProfileFormat, RoleName, SideName, UprightSense,
};

/// Points of a converted file lie at most this far apart (m).
const SPACING: f64 = 5e-4;

/// The files first, then the words, so that a wrong `--out` prints nothing.
pub(crate) fn run(args: &ProfileArgs) -> Result<(), Failure> {
    let readings: Vec<(&Path, Reading)> = args
        .files
        .iter()
        .map(|path| Ok((path.as_path(), reading(path, &args.wanted())?)))
        .collect::<Result<_, Failure>>()?;
    if let Some(directory) = &args.out {
        for (path, reading) in &readings {
            say_written(&written(directory, path, reading, args.convert)?);
        }
    }
    if args.json {
        let facts: Vec<Value> = readings.iter().map(|(path, one)| facts(path, one)).collect();
        return print(&to_json(&facts)?);
    }
    let texts: Vec<String> = readings.iter().map(|(path, one)| words(path, one)).collect();
    print(&texts.join("\n"))
}

fn reading(path: &Path, wanted: &Wanted) -> Result<Reading, Failure> {
    let content = fs::read(path).map_err(|source| Failure::Read { path: path.into(), source })?;
    read(&path.to_string_lossy(), &content, wanted)
        .map_err(|source| Failure::Profile { path: path.into(), source })
}

/// The picture, and the profile in another format.
fn written(
    directory: &Path,
    path: &Path,
    reading: &Reading,
    convert: Option<ProfileFormat>,
) -> Result<Vec<PathBuf>, Failure> {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let [svg, png] = profile_pictures(&stem, &reading.profile)?;
    let mut files = vec![(format!("{stem}.svg"), svg), (format!("{stem}.png"), png)];
    if let Some(format) = convert {
        let text = write(&reading.profile, format.into(), SPACING);
        files.push((format!("{stem}.{}", format.ending(reading.profile.role())), text.into()));
    }
    let files: Vec<(&str, &[u8])> =
        files.iter().map(|(name, content)| (&name[..], &content[..])).collect();
    Ok(write_all(directory, &files)?)
}

fn name(format: Format) -> &'static str {
    match format {
        Format::Simpack => "Simpack",
        Format::MiniProf => "MiniProf",
        Format::Vampire => "VAMPIRE",
        Format::Gensys => "GENSYS",
        Format::Columns => "two columns",
    }
}

fn words(path: &Path, reading: &Reading) -> String {
    let length = 1e3 * reading.profile.curve().length();
    let head = format!(
        "{}: {}, {}, {} points, {length:.1} mm long\n",
        path.display(),
        reading.profile.role(),
        name(reading.format),
        reading.points
    );
    reading.actions.iter().fold(head, |text, action| format!("{text}  {action}\n"))
}

fn facts(path: &Path, reading: &Reading) -> Value {
    let actions: Vec<String> = reading.actions.iter().map(ToString::to_string).collect();
    json!({
        "file": path,
        "role": reading.profile.role().to_string(),
        "format": name(reading.format),
        "points": reading.points,
        "length_m": reading.profile.curve().length(),
        "actions": actions,
    })
}

impl ProfileArgs {
    /// What is asked for in place of what would be found.
    fn wanted(&self) -> Wanted {
        Wanted {
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
            smoothing: self.smooth,
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
