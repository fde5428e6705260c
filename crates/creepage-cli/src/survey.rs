//! `creepage profile --survey`: thousands of measured profiles, a row each.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use creepage_rail::file::{Reading, read};
use creepage_rail::{Profile, Role, Standard, Track, Wheel, WheelMeasures, Wheelset};
use creepage_study::{Sources, WholeFile};
use csv::Writer;
use indicatif::ProgressBar;
use rayon::prelude::*;

use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::output::{bar_style, say, say_written};
use crate::rail_args::ProfileArgs;

const HEADER: [&str; 14] = [
    "file",
    "role",
    "points",
    "length_m",
    "flange_height_m",
    "flange_thickness_m",
    "flange_slope_m",
    "hollow_m",
    "worn_area_m2",
    "conicity_at_3_mm",
    "rough_wave_m",
    "rough_turn_rad",
    "notes",
    "error",
];
/// Amplitude at which workshops state the conicity (m).
const AMPLITUDE: f64 = 3e-3;
/// Contact is looked for as far as this to either side (m).
const REACH: f64 = 0.02;
/// Waves up to this length (m) are roughness; from this turn on (rad) they count.
const ROUGH: (f64, f64) = (8e-3, 0.01);

/// What rows are made against.
struct Survey<'a> {
    args: &'a ProfileArgs,
    track: Option<Track>,
    reference: Option<Profile>,
}

/// Finished rows, by file, on disk as they come: a survey that was killed goes on from there.
struct Journal {
    path: PathBuf,
    done: BTreeMap<String, Vec<String>>,
    file: Mutex<File>,
}

pub(crate) fn run(args: &ProfileArgs, out: &Path) -> Result<Outcome, Failure> {
    let files = files(&args.survey)?;
    let survey = Survey::new(args)?;
    let against = args.rail.iter().chain(&args.reference);
    Sources::new(files.iter().chain(against)).ensure_not_overwritten(out)?;
    let failed = |source| Failure::Write { path: out.into(), source };
    // Fails at once where nothing can be written there. The file itself is made at the end: a killed run leaves none.
    drop(WholeFile::create(out).map_err(failed)?);
    let journal = Journal::open(out, &survey.key()).map_err(failed)?;
    if !journal.done.is_empty() {
        say(&format!("note: {} rows are there from an earlier run", journal.done.len()));
    }
    let style = bar_style("{wide_bar} {pos}/{len} files  {per_sec}  {left}");
    let bar = ProgressBar::new(files.len() as u64).with_style(style);
    let row = |path: &PathBuf| {
        let known = journal.known(path);
        let row = known.map_or_else(|| journal.keep(path, survey.row(path)), Ok);
        bar.inc(1);
        row
    };
    let rows: Vec<Vec<String>> =
        files.par_iter().map(row).collect::<Result<_, _>>().map_err(failed)?;
    bar.finish_and_clear();
    let bad = rows.iter().filter(|row| row.last().is_some_and(|error| !error.is_empty())).count();
    fill(WholeFile::create(out).map_err(failed)?, &rows).map_err(failed)?;
    journal.remove().map_err(failed)?;
    say_written(&[out.into()]);
    say(&format!("{} files: {} read, {bad} not", rows.len(), rows.len() - bad));
    Ok(if bad == 0 { Outcome::Done } else { Outcome::Doubtful })
}

fn fill(mut whole: WholeFile, rows: &[Vec<String>]) -> io::Result<()> {
    {
        let mut writer = Writer::from_writer(&mut whole);
        writer.write_record(HEADER).map_err(io::Error::other)?;
        for row in rows {
            writer.write_record(row).map_err(io::Error::other)?;
        }
        writer.flush()?;
    }
    whole.finish()
}

/// The files that patterns name, in order, each once.
fn files(patterns: &[String]) -> Result<Vec<PathBuf>, Failure> {
    let mut found = Vec::new();
    for pattern in patterns {
        let wrong = |why: String| Failure::Pattern { pattern: pattern.clone(), why };
        let before = found.len();
        for path in glob::glob(pattern).map_err(|error| wrong(error.to_string()))? {
            let path = path.map_err(|error| wrong(error.to_string()))?;
            if path.is_file() {
                found.push(path);
            }
        }
        if found.len() == before {
            return Err(wrong("it names no file".into()));
        }
    }
    found.sort();
    found.dedup();
    Ok(found)
}

impl<'a> Survey<'a> {
    fn new(args: &'a ProfileArgs) -> Result<Self, Failure> {
        let profile = |name: &PathBuf| -> Result<Profile, Failure> {
            if let Some(standard) = name.to_str().and_then(Standard::named) {
                return Ok(standard.profile());
            }
            let content =
                fs::read(name).map_err(|source| Failure::Read { path: name.clone(), source })?;
            let reading = read(&name.to_string_lossy(), &content, &args.wanted());
            let wrong = |source| Failure::Profile { path: name.clone(), source };
            Ok(reading.map_err(wrong)?.profile)
        };
        let rail = args.rail.as_ref().map(profile).transpose()?;
        let place = creepage_rail::Place::gauge(args.gauge, args.gauge_height);
        let track = rail.map(|rail| Track::new(&rail, args.cant, place)).transpose();
        let track = track.map_err(|source| Failure::Survey { source })?;
        let reference = args.reference.as_ref().map(profile).transpose()?;
        // What a rail has worn is not measured.
        if reference.as_ref().is_some_and(|reference| reference.role() == Role::Rail) {
            return Err(Failure::ReferenceIsRail);
        }
        Ok(Self { args, track, reference })
    }

    /// What rows depend on beside their files.
    fn key(&self) -> String {
        let ProfileArgs { rail, cant, gauge, gauge_height, .. } = self.args;
        let ProfileArgs { back_to_back, flange_back, radius, reference, .. } = self.args;
        // A file is known by its size and time too.
        let [rail, reference] = [rail, reference].map(|one| one.as_deref().map(stamp));
        let against = (rail, cant, gauge, gauge_height, back_to_back, flange_back, radius);
        format!("{against:?} {reference:?} {:?}", self.args.wanted())
    }

    fn row(&self, path: &Path) -> Vec<String> {
        let mut row = vec![String::new(); HEADER.len()];
        row[0] = path.display().to_string();
        match self.reading(path) {
            Ok(reading) => self.fill(&mut row, &reading),
            Err(error) => row[13] = error,
        }
        row
    }

    fn reading(&self, path: &Path) -> Result<Reading, String> {
        let content = fs::read(path).map_err(|error| error.to_string())?;
        let reading = read(&path.to_string_lossy(), &content, &self.args.wanted());
        reading.map_err(|error| error.to_string())
    }

    fn fill(&self, row: &mut [String], reading: &Reading) {
        let Reading { profile, points, actions, .. } = reading;
        row[1] = profile.role().to_string();
        row[2] = points.to_string();
        row[3] = profile.curve().length().to_string();
        let words: Vec<String> = actions.iter().map(ToString::to_string).collect();
        row[12] = words.join("; ");
        if let Some(waves) = profile.all_waves(ROUGH.1).filter(|waves| waves.length < ROUGH.0) {
            row[10] = waves.length.to_string();
            row[11] = waves.swing.to_string();
        }
        if profile.role() == Role::Rail {
            return;
        }
        let back = self.args.flange_back;
        match WheelMeasures::of(profile, back) {
            Some(measures) => {
                let WheelMeasures { flange_height, flange_thickness, flange_slope, hollow } =
                    measures;
                let all = [flange_height, flange_thickness, flange_slope, hollow];
                row[4..8].iter_mut().zip(all).for_each(|(cell, value)| *cell = value.to_string());
            }
            None => row[13] = "no flange and tape circle to measure".into(),
        }
        if let Some(area) = self.reference.as_ref().and_then(|new| profile.worn_from(new)) {
            row[8] = area.to_string();
        }
        if let Some(track) = &self.track {
            match self.conicity(profile, track) {
                Ok(conicity) => row[9] = conicity.to_string(),
                Err(why) if row[13].is_empty() => row[13] = why,
                Err(_) => (),
            }
        }
    }

    /// Of two wheels of this profile.
    fn conicity(&self, profile: &Profile, track: &Track) -> Result<f64, String> {
        let ProfileArgs { radius, back_to_back, flange_back, .. } = *self.args;
        let words = |error: creepage_rail::GeometryError| error.to_string();
        let wheel = Wheel::new(profile, radius).map_err(words)?;
        let wheel = wheel.with_flange_back(flange_back).map_err(words)?;
        let wheelset = Wheelset::new(wheel.clone(), wheel, back_to_back).map_err(words)?;
        let difference = wheelset.on(track.clone()).radius_differences(REACH, Some(0.0));
        let conicity = difference.map_err(words)?.conicity(AMPLITUDE);
        conicity.map_err(|error| format!("conicity: {error}"))
    }
}

impl Journal {
    fn open(out: &Path, key: &str) -> io::Result<Self> {
        let name = out.file_name().unwrap_or_default().to_string_lossy();
        let path = out.with_file_name(format!(".{name}.survey"));
        let mut done = BTreeMap::new();
        if let Ok(file) = File::open(&path) {
            let mut lines = BufReader::new(file).lines();
            if lines.next().transpose()?.is_some_and(|first| first == key) {
                for line in lines.map_while(Result::ok) {
                    // A line that a kill cut short is no row.
                    if let Ok((stamp, row)) = serde_json::from_str::<(String, Vec<String>)>(&line) {
                        done.insert(stamp, row);
                    }
                }
            }
        }
        let mut file = OpenOptions::new().create(true).append(true).open(&path)?;
        if done.is_empty() {
            file.set_len(0)?;
            writeln!(file, "{key}")?;
        } else {
            // What a kill cut short has no end of line.
            writeln!(file)?;
        }
        Ok(Self { path, done, file: Mutex::new(file) })
    }

    /// A file that has not changed since its row was made.
    fn known(&self, path: &Path) -> Option<Vec<String>> {
        self.done.get(&stamp(path)).cloned()
    }

    fn keep(&self, path: &Path, row: Vec<String>) -> io::Result<Vec<String>> {
        let line = serde_json::to_string(&(stamp(path), &row)).map_err(io::Error::other)?;
        let mut file = self.file.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        writeln!(file, "{line}")?;
        Ok(row)
    }

    fn remove(self) -> io::Result<()> {
        fs::remove_file(self.path)
    }
}

/// Name, size and time of a file.
fn stamp(path: &Path) -> String {
    let facts = fs::metadata(path).ok().map(|facts| (facts.len(), facts.modified().ok()));
    format!("{} {facts:?}", path.display())
}
