//! Results of wear over a distance: tables, profiles, JSON.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use creepage_rail::file::{self, Format};
use creepage_rail::{Profile, Role};
use serde::Serialize;

use super::error::WearError;
use super::limits::WearEnd;
use super::picture::Animation;
use super::run::Wear;
use super::section::WearPlan;
use super::state::{WearStop, WornBody};
use crate::error::ReportError;
use crate::file_set::write_all;
use crate::sources::Sources;
use crate::wheelset::WheelsetCase;

const HEADER: [&str; 12] = [
    "distance_m",
    "passages",
    "steps",
    "body",
    "depth_m",
    "area_m2",
    "volume_m3",
    "flange_height_m",
    "flange_thickness_m",
    "flange_slope_m",
    "hollow_m",
    "conicity_at_3_mm",
];

/// One row of `wear.csv` and of the report: a body at a stop.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WearRowJson {
    /// Distance that wheels ran (m).
    pub distance_m: f64,
    /// Passages over the rails.
    pub passages: f64,
    /// Steps so far.
    pub steps: usize,
    /// `wheel_left`, `wheel_right`, `rail_left` or `rail_right`.
    pub body: &'static str,
    /// The greatest depth (m), along the normal.
    pub depth_m: f64,
    /// Area of the section that is lost (m2).
    pub area_m2: f64,
    /// Volume lost (m3); of a rail per metre.
    pub volume_m3: f64,
    /// Flange height of a wheel (m).
    pub flange_height_m: Option<f64>,
    /// Flange thickness (m).
    pub flange_thickness_m: Option<f64>,
    /// Flange slope qR (m).
    pub flange_slope_m: Option<f64>,
    /// How far the tread rises above its field side (m).
    pub hollow_m: Option<f64>,
    /// Equivalent conicity at 3 mm by EN 15302.
    pub conicity_at_3_mm: Option<f64>,
}

/// The report of wear over a distance.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WearReportJson<'a> {
    /// A row for each body at each stop.
    pub rows: Vec<WearRowJson>,
    /// Why the run ended before its distance: the first limit that was reached; else `null`.
    pub ended: Option<WearEnd>,
    /// Cautions about it.
    pub cautions: &'a [String],
}

impl WearStop {
    /// A row for each body that wears.
    #[must_use]
    pub fn rows(&self) -> Vec<WearRowJson> {
        let row = |body: WornBody| {
            let worn = self.of(body)?;
            let measure = |k: usize| worn.measures.map(|measures| measures[k]);
            Some(WearRowJson {
                distance_m: self.distance,
                passages: self.passages,
                steps: self.steps,
                body: body.name(),
                depth_m: worn.greatest(),
                area_m2: worn.area,
                volume_m3: worn.volume,
                flange_height_m: measure(0),
                flange_thickness_m: measure(1),
                flange_slope_m: measure(2),
                hollow_m: measure(3),
                conicity_at_3_mm: self.conicity,
            })
        };
        WornBody::ALL.into_iter().filter_map(row).collect()
    }

    /// Writes the profiles of a stop, whose `number` (from 0, the new ones) its files have in their names, into
    /// `directory`, which is made when missing; none of `sources`.
    ///
    /// # Errors
    /// [`WearError`]: nothing is written then.
    pub fn write(
        &self,
        number: usize,
        directory: &Path,
        sources: &Sources,
    ) -> Result<Vec<PathBuf>, WearError> {
        let files = self.profiles(number)?;
        let files: Vec<(&str, &[u8])> =
            files.iter().map(|(name, content)| (&name[..], &content[..])).collect();
        Ok(write_all(directory, &files, sources)?)
    }

    /// The profiles of a stop as files, which `[wheel]` and `[rail]` of a wheelset file take.
    fn profiles(&self, number: usize) -> Result<Vec<(String, Vec<u8>)>, WearError> {
        let mut files = Vec::new();
        for body in WornBody::ALL {
            let Some(worn) = self.of(body) else { continue };
            let profile = Profile::through(body.role(), &worn.points, &worn.corners)
                .map_err(|source| WearError::Profile { body: body.name(), source })?;
            let text = file::write(&profile, Format::Json, 1.0);
            files.push((profile_name(body, number), text.into_bytes()));
        }
        Ok(files)
    }
}

/// The tables of a run.
const TABLES: [&str; 3] = ["wear.csv", "profiles.csv", "report.json"];

/// The pictures of the wheels or the rails: as SVG, as PNG, moving.
fn picture_names(role: Role) -> [String; 3] {
    ["s.svg", "s.png", "s-moving.png"].map(|ending| format!("{role}{ending}"))
}

/// The file of a body's profile at a stop.
fn profile_name(body: WornBody, number: usize) -> String {
    format!("{}_{number:03}.json", body.name())
}

impl Wear {
    /// The name of the file in which a run keeps what it has done.
    pub const STATE: &'static str = "wear.state";

    /// All rows.
    #[must_use]
    pub fn json(&self) -> WearReportJson<'_> {
        let rows = self.stops.iter().flat_map(WearStop::rows).collect();
        WearReportJson { rows, ended: self.ended, cautions: &self.cautions }
    }

    /// The rows as a table for people.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::from(
            "distance    passages  body         depth   area     Sh      Sd      qR      hollow  conicity\n\
             km                                 mm      mm2      mm      mm      mm      mm\n",
        );
        let or = |value: Option<f64>, unit: f64| match value {
            Some(value) => format!("{:<7.3}", unit * value),
            None => "-      ".to_owned(),
        };
        for row in self.stops.iter().flat_map(WearStop::rows) {
            let measures =
                [row.flange_height_m, row.flange_thickness_m, row.flange_slope_m, row.hollow_m];
            let [height, thickness, slope, hollow] = measures.map(|value| or(value, 1e3));
            // Nothing fails in writing to a string.
            let _ = writeln!(
                text,
                "{:<11.1} {:<9.0} {:<12} {:<7.4} {:<8.3} {height} {thickness} {slope} {hollow} {}",
                1e-3 * row.distance_m,
                row.passages,
                row.body,
                1e3 * row.depth_m,
                1e6 * row.area_m2,
                or(row.conicity_at_3_mm, 1.0).trim_end(),
            );
        }
        if let Some(words) = self.end_in_words() {
            let _ = writeln!(text, "{words}");
        }
        text
    }

    /// Where and why the run ended before its distance.
    #[must_use]
    pub fn end_in_words(&self) -> Option<String> {
        let (end, last) = (self.ended?, self.stops.last()?);
        let mut way = Vec::new();
        if last.distance > 0.0 {
            way.push(format!("{:.1} km", 1e-3 * last.distance));
        }
        if last.passages > 0.0 {
            way.push(format!("{:.0} passages", last.passages));
        }
        Some(format!("ends after {}: {}", way.join(" and "), end.words()))
    }

    /// `wear.csv`: a row for each body at each stop.
    ///
    /// # Errors
    /// [`ReportError`].
    pub fn csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(HEADER)?;
        let cell = |value: f64| format!("{value:e}");
        let or = |value: Option<f64>| value.map(cell).unwrap_or_default();
        for row in self.stops.iter().flat_map(WearStop::rows) {
            writer.write_record([
                cell(row.distance_m),
                cell(row.passages),
                row.steps.to_string(),
                row.body.to_owned(),
                cell(row.depth_m),
                cell(row.area_m2),
                cell(row.volume_m3),
                or(row.flange_height_m),
                or(row.flange_thickness_m),
                or(row.flange_slope_m),
                or(row.hollow_m),
                or(row.conicity_at_3_mm),
            ])?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }

    /// `profiles.csv`: points of all profiles with the depth there.
    fn points_csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(["body", "distance_m", "passages", "y_m", "z_m", "depth_m"])?;
        for stop in &self.stops {
            for body in WornBody::ALL {
                let Some(worn) = stop.of(body) else { continue };
                for ([y, z], depth) in worn.points.iter().zip(&worn.depth) {
                    let numbers = [stop.distance, stop.passages, *y, *z, *depth];
                    let cells = numbers.map(|value| format!("{value:e}"));
                    writer.write_record(std::iter::once(body.name().to_owned()).chain(cells))?;
                }
            }
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }

    /// Writes `wear.csv`, `profiles.csv`, `report.json`, a picture and an animation of each kind of body, and a file for each
    /// profile at each stop into `directory`, which is made when missing; none of `sources` or of the case's files.
    ///
    /// # Errors
    /// [`WearError`]: nothing is written then.
    pub fn write(
        &self,
        case: &WheelsetCase,
        plan: &WearPlan,
        directory: &Path,
        sources: &Sources,
    ) -> Result<Vec<PathBuf>, WearError> {
        let json = serde_json::to_vec_pretty(&self.json()).map_err(ReportError::from)?;
        let tables = [self.csv()?, self.points_csv()?, json];
        let mut files: Vec<_> = TABLES.map(str::to_owned).into_iter().zip(tables).collect();
        for role in [Role::Wheel, Role::Rail] {
            if let Some(svg) = self.svg(role) {
                let [as_svg, as_png, as_moving] = picture_names(role);
                let png = creepage_plot::png(&svg).map_err(ReportError::from)?;
                files.push((as_svg, svg.into_bytes()));
                files.push((as_png, png));
                let moving =
                    Animation::new(self, role).map(|frames| creepage_plot::animated_png(&frames));
                if let Some(png) = moving.transpose().map_err(ReportError::from)? {
                    files.push((as_moving, png));
                }
            }
        }
        for (number, stop) in self.stops.iter().enumerate() {
            files.extend(stop.profiles(number)?);
        }
        let files: Vec<(&str, &[u8])> =
            files.iter().map(|(name, content)| (&name[..], &content[..])).collect();
        Ok(write_all(directory, &files, &plan.sources(case).with(sources))?)
    }
}

impl WearPlan {
    /// Checks that no result of a run into `directory` would stand where one of `sources` is, before it begins.
    ///
    /// # Errors
    /// [`ReportError::OverSource`].
    pub fn ensure_not_overwritten(
        &self,
        directory: &Path,
        sources: &Sources,
    ) -> Result<(), ReportError> {
        let tables = TABLES.into_iter().chain([Wear::STATE]).map(str::to_owned);
        let pictures = [Role::Wheel, Role::Rail].into_iter().flat_map(picture_names);
        let profiles = (0..=self.stops as usize)
            .flat_map(|number| WornBody::ALL.map(|body| profile_name(body, number)));
        let mut names = tables.chain(pictures).chain(profiles);
        names.try_for_each(|name| sources.ensure_not_overwritten(&directory.join(name)))
    }

    /// The files that it and its wheelset were read from.
    #[must_use]
    pub fn sources(&self, case: &WheelsetCase) -> Sources {
        case.sources().with(&Sources::new(self.table.iter()))
    }
}
