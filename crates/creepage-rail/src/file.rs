//! Profile files: what is in them, what had to be done to them.
//!
//! The format is told by the content, then by the name's ending. Units, senses of the axes and
//! the order of points are those of the format; what it leaves open is found in the shape, and
//! what the shape leaves open is an error that asks for it ([`ReadOptions`]) or, for the lateral sense
//! of rails, the format's convention. All of it stands in the report.
//!
//! | format | lengths | `y` of rails | `z` |
//! |---|---|---|---|
//! | Simpack `.prr`, `.prw` | `units.len.f` | to the field side after its mirrors | down after its mirrors |
//! | `MiniProf` `.ban`, `.whl` | mm | to the track side | found |
//! | VAMPIRE `.rai`, `.whe` | mm | to the right | found |
//! | GENSYS `.rail`, `.wheel` | mm | to the track side | down |
//! | two columns, JSON | found | to the field side | found |
//!
//! Wheels show by their flange where the track is and what is down, rails by their head what is
//! down; where that contradicts the format the shape counts, and where it contradicts the role that
//! the file says, or what is asked for, the error names both.
//!
//! ```
//! use creepage_rail::file::{Format, ReadOptions, read, write};
//! use creepage_rail::Standard;
//!
//! let text = write(&Standard::S1002.profile(), Format::Simpack, 5e-4);
//! let read = read("wheel.prw", text.as_bytes(), &ReadOptions::default())?;
//! assert_eq!(read.format, Format::Simpack);
//! assert!((read.profile.at_z(0.010).unwrap().y + 0.0375).abs() < 1e-8);
//! # Ok::<(), creepage_rail::file::FileError>(())
//! ```

mod columns;
mod error;
mod json;
mod miniprof;
mod orientation;
mod outline;
mod repair;
mod report;
mod rows;
mod scans;
mod segments;
mod shape;
mod simpack;
mod slice_list;
mod text;
mod vampire;
mod writing;

pub use error::{FileError, SaidBy};
pub use repair::CornerSearch;
pub use report::Action;
pub use slice_list::{SliceList, SliceListError};
pub use text::unicode;
pub use writing::write;

use orientation::Turned;
use rows::{Raw, lines};

use crate::{Profile, Role, Side, Smoothing};

/// A profile file's format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// Simpack `.prr`, `.prw`.
    Simpack,
    /// `MiniProf` `.ban`, `.whl`, the newer and the older text.
    MiniProf,
    /// VAMPIRE `.rai`, `.whe`: left and right side by side.
    Vampire,
    /// GENSYS `.rail`, `.wheel`.
    Gensys,
    /// Two columns `y z`.
    Columns,
    /// JSON: an array of points, or one of each coordinate.
    Json,
}

/// Options of reading, in place of what would be found in the file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ReadOptions {
    /// The format.
    pub format: Option<Format>,
    /// Wheel or rail.
    pub role: Option<Role>,
    /// The side to take from a file that holds both.
    pub side: Option<Side>,
    /// Length of the file's unit (m).
    pub unit: Option<f64>,
    /// Whether `y` grows to the field side.
    pub field_side: Option<bool>,
    /// Whether `z` grows downwards.
    pub down: Option<bool>,
    /// How strongly its points are smoothed.
    pub smoothing: Option<Smoothing>,
    /// How corners are told from roughness.
    pub corners: Option<CornerSearch>,
}

/// A profile read from a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The profile.
    pub profile: Profile,
    /// The file's format.
    pub format: Format,
    /// Number of points from which the profile is made.
    pub points: usize,
    /// What was found, assumed and done, in order.
    pub actions: Vec<Action>,
}

/// Reads a profile. `name` is the file's, its ending tells what the content leaves open.
///
/// # Errors
/// [`FileError`]: each names its line, or what must be asked for.
pub fn read(name: &str, content: &[u8], wanted: &ReadOptions) -> Result<Reading, FileError> {
    let mut actions = Vec::new();
    let text = text::decoded(content, &mut actions);
    let format = wanted.format.map_or_else(|| recognised(name, &text), Ok)?;
    let mut raw = match format {
        Format::Simpack => simpack::parse(&text)?,
        Format::MiniProf if has_sections(&text) => miniprof::sections(&text)?,
        Format::MiniProf => miniprof::parse(&text)?,
        Format::Vampire => vampire::parse(&text, wanted.side)?,
        Format::Gensys => columns::gensys(&text)?,
        Format::Columns => columns::parse(&text)?,
        Format::Json => json::parse(&text)?,
    };
    actions.append(&mut raw.actions);
    raw.actions = actions;
    finish(raw, format, by_ending(name), wanted)
}

/// Brings points to the house's form, repairs them and lays a curve through.
fn finish(
    mut raw: Raw,
    format: Format,
    ending: Option<Role>,
    wanted: &ReadOptions,
) -> Result<Reading, FileError> {
    let mut actions = std::mem::take(&mut raw.actions);
    scans::measured(&mut raw.points, &mut actions);
    scans::without_spikes(&mut raw.points, &mut actions);
    scans::without_outliers(&mut raw.points, &mut actions);
    scans::in_order(&raw.points)?;
    let role = wanted.role.or(raw.role).or(ending);
    raw.points = outline::opened(raw.points, role, &mut actions)?;
    let turned = orientation::turned(raw, ending, wanted, &mut actions)?;
    let Turned { points, role, unit } = turned;
    let points = repair::repaired(points, &mut actions)?;
    let corners = repair::corners(&points, wanted.corners.unwrap_or_default(), &mut actions);
    let line = points.first().map_or(0, |point| point.line);
    // What was dropped may have been most of it.
    orientation::check_length(orientation::length(&points), unit, line)?;
    let places: Vec<[f64; 2]> = points.iter().map(|point| point.at).collect();
    let profile = match wanted.smoothing {
        Some(smoothing) => {
            actions.push(Action::Smoothed { smoothing });
            Profile::smoothed(role, &places, &corners, smoothing)
        }
        None => Profile::through(role, &places, &corners),
    };
    let profile = profile.map_err(|source| FileError::Profile { line, source })?;
    Ok(Reading { profile, format, points: places.len(), actions })
}

/// Whether the text is of sections, `[FileInfo]` first.
fn has_sections(text: &str) -> bool {
    lines(text).take(3).any(|(_, line)| line.contains("[FileInfo]"))
}

/// The format by the content, else by the name's ending.
fn recognised(name: &str, text: &str) -> Result<Format, FileError> {
    let head: Vec<&str> = lines(text).map(|(_, line)| line).take(60).collect();
    let starts = |word: &str| head.iter().any(|line| line.trim_start().starts_with(word));
    let first = head.first().map_or("", |line| line.trim());
    if has_sections(text) {
        return Ok(Format::MiniProf);
    }
    if starts("header.begin") || starts("spline.begin") {
        return Ok(Format::Simpack);
    }
    if first.starts_with("WHEELPROFILE") || first.starts_with("RAILPROFILE") {
        return Ok(Format::Vampire);
    }
    if text.trim_start().starts_with(['{', '[']) {
        return Ok(Format::Json);
    }
    let old = head.iter().take(3).any(|line| line.to_uppercase().contains("MINI"));
    if old || head.iter().take(3).any(|line| miniprof::is_key(line)) {
        return Ok(Format::MiniProf);
    }
    match ending(name).as_str() {
        "rail" | "wheel" => Ok(Format::Gensys),
        "whe" | "rai" => Ok(Format::Vampire),
        "slcs" | "slcw" => Err(FileError::Unsupported { line: 1, what: "profiles in slices" }),
        _ => Ok(Format::Columns),
    }
}

fn ending(name: &str) -> String {
    name.rsplit_once('.').map_or(String::new(), |(_, ending)| ending.to_lowercase())
}

fn by_ending(name: &str) -> Option<Role> {
    match ending(name).as_str() {
        "prr" | "ban" | "rai" | "rail" => Some(Role::Rail),
        "prw" | "whl" | "whe" | "wheel" => Some(Role::Wheel),
        _ => None,
    }
}
