//! Batch rows that differ from a case with `[gap]`: many contacts of any shape, on all cores.

use std::path::{Path, PathBuf};

use creepage::normal::NormalError;
use creepage::{Status, TheorySpec};
use creepage_study::{
    Caution, GapCaseError, GapFile, GapRows, GapSolver, GapValue, GapVaried, Heat, LoadOrApproach,
    SolvedCase, Sources, theory_spec,
};
use csv::ByteRecord;
use rayon::prelude::*;

use super::columns::{ColumnError, NoCase, names, parse, place_of, tell_misspelt};
use super::rows::RowAnswer;
use super::table::Table;
use super::{free, write_answers};
use crate::batch_args::BatchArgs;
use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::output::say;

/// What is appended before status and message: the name of a column, and the path of the quantity of the report that it
/// holds.
const COLUMNS: [(&str, &str); 15] = [
    ("normal_force_n", "contact.normal_force_n"),
    ("approach_m", "contact.approach_m"),
    ("area_m2", "contact.area_m2"),
    ("peak_pressure_pa", "contact.peak_pressure_pa"),
    ("longitudinal_creepage", "creepage.longitudinal"),
    ("lateral_creepage", "creepage.lateral"),
    ("spin_rad_per_m", "creepage.spin_rad_per_m"),
    ("longitudinal_n", "lower_body.longitudinal_n"),
    ("lateral_n", "lower_body.lateral_n"),
    ("moment_n_m", "lower_body.moment_n_m"),
    ("longitudinal_error_n", "lower_body.longitudinal_n"),
    ("lateral_error_n", "lower_body.lateral_n"),
    ("moment_error_n_m", "lower_body.moment_n_m"),
    ("frictional_power_per_metre_j_per_m", "frictional_power_per_metre_j_per_m"),
    ("frictional_power_w", "frictional_power_w"),
];
/// A column, and what it holds of the temperatures.
type HeatColumn = (&'static str, fn(&Heat) -> f64);
/// The same where temperatures are wanted.
const HEAT: [HeatColumn; 2] = [
    ("contact_temperature_max_c", |heat| heat.contact_temperature_max_c),
    ("flash_max_k", |heat| heat.flash_max_k),
];
/// Columns of error bars have it in their names.
const ERROR: &str = "_error_";

/// Why a row has no answer.
#[derive(Debug, thiserror::Error)]
enum GapRowError {
    #[error(transparent)]
    Field(#[from] NoCase),
    #[error(transparent)]
    Case(#[from] GapCaseError),
}

/// The rows' case, the places of what varies, and the theory where another is asked for.
struct Gaps {
    rows: GapRows,
    places: Vec<usize>,
    count: usize,
    theory: Option<TheorySpec>,
    solver: GapSolver,
    error_bars: bool,
    /// Where the files stand that rows name.
    directory: PathBuf,
}

pub(super) fn run(args: &BatchArgs, path: &Path, file: GapFile) -> Result<Outcome, Failure> {
    if args.table.is_some() {
        return Err(Failure::TableOfEllipses { path: path.into() });
    }
    let table = Table::open(args.input.as_deref())?;
    let left_out = file.left_out_of_rows();
    let gaps = Gaps::new(args, path, file, &table)?;
    for section in left_out {
        say(&format!("caution: [{section}] is left out: rows have no such numbers"));
    }
    let appended = gaps.appended();
    free(&table, &appended)?;
    let answers = |rows: &[ByteRecord]| {
        if let Some(out) = &args.out {
            gaps.files(rows).ensure_not_overwritten(out)?;
        }
        Ok(rows.par_iter().map(|row| gaps.answer(row)).collect())
    };
    let tally = write_answers(args, table, &appended, None, answers, |out, row, answer| {
        out.write_answer(row, answer)
    })?;
    Ok(tally.outcome())
}

impl Gaps {
    fn new(args: &BatchArgs, path: &Path, file: GapFile, table: &Table) -> Result<Self, Failure> {
        let wrong = |source| Failure::Gap { path: path.into(), source: Box::new(source) };
        let theory = args.theory.as_ref().map(|name| {
            let name = TheorySpec::named(name)?.facts().name;
            theory_spec(name, &args.options).map_err(Failure::Option)
        });
        let theory = theory.transpose()?;
        let known = match &theory {
            Some(spec) => spec.check_on_areas().map(|()| spec.clone()).map_err(Into::into),
            None => file.theory(),
        };
        let error_bars = known.map_err(wrong)?.facts().error_bars;
        let (mut varied, mut places) = (Vec::new(), Vec::new());
        let input = |source| Failure::Columns { input: table.name.clone(), source };
        for quantity in GapVaried::ALL {
            if let Some(place) = place_of(&table.header, quantity.name()).map_err(input)? {
                varied.push(quantity);
                places.push(place);
            }
        }
        if varied.is_empty() {
            return Err(input(ColumnError::NoGapVaries { found: names(&table.header) }));
        }
        tell_misspelt(&table.header, &GapVaried::ALL.map(GapVaried::name));
        let directory = path.parent().unwrap_or(Path::new("")).to_path_buf();
        let rows = GapRows::new(file, directory.clone(), varied);
        let (count, solver) = (table.header.len(), GapSolver::default());
        Ok(Self { rows, places, count, theory, solver, error_bars, directory })
    }

    /// The files that rows name.
    fn files(&self, rows: &[ByteRecord]) -> Sources {
        let varied = self.rows.varied().iter().zip(&self.places);
        let places: Vec<_> = varied.filter(|(one, _)| one.is_file()).map(|(_, at)| *at).collect();
        let names = rows.iter().flat_map(|row| places.iter().filter_map(|place| row.get(*place)));
        let path =
            |name: &[u8]| self.directory.join(String::from_utf8_lossy(name.trim_ascii()).as_ref());
        Sources::new(names.map(path))
    }

    /// Columns with the quantities that they hold, by a theory with or without error bars, with or without a speed.
    fn columns(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        COLUMNS.into_iter().filter(|(name, _)| match *name {
            "frictional_power_w" => self.rows.has_speed(),
            name => self.error_bars || !name.contains(ERROR),
        })
    }

    /// The columns that are appended.
    fn appended(&self) -> Vec<&'static str> {
        let own = self.columns().map(|(name, _)| name);
        let heat = self.heat_columns().map(|(name, _)| name);
        own.chain(heat).chain(["status", "message"]).collect()
    }

    /// Columns of temperatures, where the case asks for them.
    fn heat_columns(&self) -> impl Iterator<Item = HeatColumn> {
        HEAT.into_iter().filter(|_| self.rows.has_heat())
    }

    fn answer(&self, row: &ByteRecord) -> Result<RowAnswer, GapRowError> {
        if row.len() != self.count {
            return Err(NoCase::FieldCount { found: row.len(), expected: self.count }.into());
        }
        let value = |(quantity, place): (&GapVaried, &usize)| {
            let (name, field) = (quantity.name(), &row[*place]);
            match String::from_utf8_lossy(field.trim_ascii()) {
                empty if empty.is_empty() => Err(NoCase::EmptyField { column: name }),
                file if quantity.is_file() => Ok(GapValue::File(file.into_owned())),
                _ => parse(name, field).map(GapValue::Number),
            }
        };
        let varied = self.rows.varied().iter().zip(&self.places);
        let values: Vec<_> = varied.map(value).collect::<Result<_, _>>()?;
        let loads = self.rows.varied().iter().zip(&values);
        let is_unloaded = |(quantity, value): (&GapVaried, &GapValue)| {
            *quantity == GapVaried::NormalForce && *value == GapValue::Number(0.0)
        };
        if loads.into_iter().any(is_unloaded) {
            return Ok(self.no_contact(f64::NAN));
        }
        let case = self.rows.case(&values)?;
        let case = match &self.theory {
            Some(spec) => case.by_spec(spec)?,
            None => case,
        };
        match self.solver.solve(&case) {
            Err(GapCaseError::Normal {
                source: NormalError::NoContact { approach, .. }, ..
            }) if matches!(case.pressed, LoadOrApproach::Approach(_)) => {
                Ok(self.no_contact(approach))
            }
            solved => Ok(self.numbers(&solved?)),
        }
    }

    /// No load, area, pressure and force at an approach; without a contact there is no creepage.
    fn no_contact(&self, approach: f64) -> RowAnswer {
        let number = |(_, path): (_, &str)| match path {
            "contact.approach_m" => approach,
            path if path.starts_with("creepage.") => f64::NAN,
            _ => 0.0,
        };
        let none = self.heat_columns().map(|_| f64::NAN);
        let numbers = self.columns().map(number).chain(none).collect();
        let message = Caution::Status(Status::NoContact).to_string();
        RowAnswer { numbers, status: Status::NoContact, message }
    }

    fn numbers(&self, solved: &SolvedCase) -> RowAnswer {
        let report = solved.numbers();
        let number = |(name, path): (&str, &str)| {
            let found = report.find(path)?;
            if name.contains(ERROR) { found.error } else { found.value }
        };
        let own = self.columns().map(|column| number(column).unwrap_or(f64::NAN));
        // A theory without slip gives no temperatures, and its caution says so.
        let heat = self.heat_columns().map(|(_, of)| solved.heat().map_or(f64::NAN, of));
        let numbers = own.chain(heat).collect();
        let cautions: Vec<_> = solved.cautions.iter().map(ToString::to_string).collect();
        RowAnswer { numbers, status: solved.solution().status, message: cautions.join("; ") }
    }
}
