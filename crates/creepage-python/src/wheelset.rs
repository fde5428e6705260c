//! Python class of wheelsets by their files.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use creepage::InvalidValue;
use creepage_study::{
    ANSWERS, ASKED, CaseError, Sources, StepsStart, TableAxis, WHEEL_STEP_COLUMNS,
    WHEEL_STEP_NUMBERS, WheelStepsRun, WheelTable, WheelsetCase, WheelsetFile, WheelsetFileError,
    WheelsetReport, WheelsetTable, theory_spec, wheelset_caution_words,
};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

use crate::case::{QuantityTuple, quantities};
use crate::errors;
use crate::pool::detached;
use crate::signals;

/// A wheelset in its track, read and checked.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct WheelsetData {
    pub(crate) case: WheelsetCase,
    /// The text of its file.
    pub(crate) text: String,
}

/// A wheelset, solved.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct SolvedWheelset {
    solved: WheelsetReport,
    case: WheelsetCase,
}

#[pymethods]
impl WheelsetData {
    /// From the text of a wheelset file whose profiles are in a directory.
    #[new]
    fn new(py: Python, text: &str, directory: PathBuf) -> PyResult<Self> {
        let read = || {
            let file = WheelsetFile::read(text).map_err(WheelsetFileError::from)?;
            file.case(&directory)
        };
        let case = detached(py, read)?.map_err(|error| errors::wheelset(py, error))?;
        Ok(Self { case, text: text.to_owned() })
    }

    /// Combined Poisson's ratio; NaN where there are no materials.
    fn poisson(&self) -> f64 {
        self.case.solids.map_or(f64::NAN, |pair| pair.poisson())
    }

    /// What was found in the profile files and repaired.
    fn notes(&self) -> Vec<String> {
        let notes = self.case.notes.iter();
        let words = notes.flat_map(|note| {
            note.actions.iter().map(|action| format!("{}: {action}", note.path.display()))
        });
        words.collect()
    }

    /// Solves; with derivatives by position and motion where they are asked for.
    fn solve(&self, py: Python, derivatives: bool) -> PyResult<SolvedWheelset> {
        let case = self.case.clone();
        let solve = move || {
            let mut solved = case.solve()?;
            if derivatives {
                solved.solved.derivatives = Some(case.derivatives(&solved)?);
            }
            Ok(solved)
        };
        let solved = signals::answered(py, solve)?.map_err(|error| errors::wheelset(py, error))?;
        Ok(SolvedWheelset { solved, case: self.case.clone() })
    }

    /// The same by the theory of that name, with options `key = value` as in a file.
    fn by_theory(&self, py: Python, theory: &str, options: Vec<String>) -> PyResult<Self> {
        let spec = theory_spec(theory, &options).map_err(CaseError::from);
        let theory = spec.map_err(|error| errors::case(py, error))?;
        let case = WheelsetCase { theory, ..self.case.clone() };
        case.solver().map_err(|error| errors::wheelset(py, error))?;
        Ok(Self { case, text: self.text.clone() })
    }

    /// The same at another place along the track (m), its wheels turned to another pitch (rad); NaN is the
    /// wheelset's own.
    fn at(&self, py: Python, s: f64, pitch: f64) -> PyResult<Self> {
        let case = detached(py, || self.case.at(s, pitch))?;
        let case = case.map_err(|error| errors::wheelset(py, error))?;
        let [s, pitch] = case.running.place();
        let mut file: toml::Table = self
            .text
            .parse()
            .map_err(|error: toml::de::Error| errors::internal(&error.to_string()))?;
        if let Some(wheelset) = file.get_mut("wheelset").and_then(toml::Value::as_table_mut) {
            wheelset.insert("s".into(), s.into());
            wheelset.insert("pitch".into(), pitch.into());
        }
        Ok(Self { case, text: file.to_string() })
    }

    /// The text of its file.
    fn text(&self) -> String {
        self.text.clone()
    }

    /// Solves in another position and motion, asked as `ASKED` has it; NaN is the wheelset's own. With
    /// `start`, an earlier solution, from there; without it the same bits whatever came before.
    fn solve_at(
        &self,
        py: Python,
        asked: [f64; ASKED.len()],
        start: Option<PyRef<SolvedWheelset>>,
        derivatives: bool,
    ) -> PyResult<SolvedWheelset> {
        let (case, start) = (self.case.clone(), start.map(|start| start.solved.clone()));
        let solve = move || {
            let (stance, travel) = case.asked(&asked)?;
            let solver = case.solver()?;
            let mut solved = match &start {
                Some(before) => solver.next(before, &stance, &travel)?,
                None => solver.solve(&stance, &travel)?,
            };
            if derivatives {
                solved.derivatives = Some(solver.derivatives(&solved, &stance, &travel)?);
            }
            Ok((
                WheelsetReport::from(solved),
                WheelsetCase { stance, travel: Some(travel), ..case },
            ))
        };
        let solved = signals::answered(py, solve)?;
        let (solved, case) = solved.map_err(|error| errors::wheelset(py, error))?;
        Ok(SolvedWheelset { solved, case })
    }

    /// The same for many rows on all cores, each from nothing: for each row what `ANSWERS` says, NaN where it
    /// was not solved; and its status and its cautions in words.
    fn solve_rows<'py>(
        &self,
        py: Python<'py>,
        rows: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<SolvedRows<'py>> {
        let (rows, case) = (rows.to_vec()?, self.case.clone());
        let solve = move |stop: &AtomicBool| {
            let solver = case.solver()?;
            let nothing = [f64::NAN; ANSWERS.len()];
            let one = |row: &[f64; ASKED.len()]| {
                if stop.load(Ordering::Relaxed) {
                    return (nothing, ["not solved".to_owned(), String::new()]);
                }
                let asked = case.asked(row);
                let solved = asked.and_then(|(stance, travel)| Ok(solver.solve(&stance, &travel)?));
                match solved {
                    Ok(solved) => {
                        let words = wheelset_caution_words(&solved).join("; ");
                        (solved.answers(), [solved.status().name().to_owned(), words])
                    }
                    Err(error) => (nothing, [error.to_string(), String::new()]),
                }
            };
            Ok(rows.as_chunks::<{ ASKED.len() }>().0.par_iter().map(one).unzip())
        };
        let solved = signals::stoppable(py, solve)?;
        let (numbers, words): (Vec<_>, Vec<_>) =
            solved.map_err(|error| errors::wheelset(py, error))?;
        let (statuses, cautions) = words.into_iter().map(<(String, String)>::from).unzip();
        Ok((PyArray1::from_slice(py, numbers.as_flattened()), [statuses, cautions]))
    }

    /// Rolls in steps by columns of one length, from steady rolling or not: the columns of what comes of it, the
    /// status in words, and what to be careful about; with the row (from 1) where one cannot be solved.
    fn roll<'py>(
        &self,
        py: Python<'py>,
        columns: Vec<(String, Vec<f64>)>,
        starts_steady: Option<bool>,
    ) -> PyResult<(Bound<'py, PyDict>, Vec<String>)> {
        let given: Vec<_> = columns.iter().map(|(name, values)| (&name[..], &values[..])).collect();
        let table = WheelTable::from_columns(&given)
            .map_err(|error| PyValueError::new_err(error.to_string()))?;
        let start = match starts_steady {
            None => self.case.start,
            Some(true) => StepsStart::Steady,
            Some(false) => StepsStart::Pressed,
        };
        let case = WheelsetCase { start, ..self.case.clone() };
        let wrong = |error| errors::wheelset(py, error);
        let mut run = WheelStepsRun::new(&case, &table).map_err(wrong)?;
        let mut rows: Vec<[f64; WHEEL_STEP_NUMBERS]> = Vec::new();
        let mut statuses: Vec<&str> = Vec::new();
        loop {
            py.check_signals()?;
            let row = rows.len() + 1;
            let next = py.detach(|| run.next_row());
            let of_row = |error: WheelsetFileError| {
                errors::in_section(py, format!("row {row}: {error}"), "wheelset")
            };
            let Some((distance, stepped)) = next.map_err(of_row)? else { break };
            rows.push(WheelStepsRun::numbers(distance, &stepped));
            statuses.push(stepped.solved.status().name());
        }
        let found = PyDict::new(py);
        for (place, name) in WHEEL_STEP_COLUMNS.into_iter().take(WHEEL_STEP_NUMBERS).enumerate() {
            let numbers = rows.iter().map(|row| row[place]).collect();
            found.set_item(name, PyArray1::from_vec(py, numbers))?;
        }
        found.set_item("status", statuses)?;
        Ok((found, run.cautions()))
    }

    /// Columns over the axes in their order, each as one flat array; those of contacts over these too.
    fn table<'py>(
        &self,
        py: Python<'py>,
        axes: Vec<(String, Vec<f64>)>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let named = |(name, values): (String, Vec<f64>)| {
            let name = TableAxis::NAMES.into_iter().find(|known| *known == name)?;
            Some(TableAxis { name, values })
        };
        let axes: Vec<TableAxis> = axes.into_iter().filter_map(named).collect();
        let case = self.case.clone();
        let solve = move |stop: &AtomicBool| {
            WheelsetTable::solve(&case, &axes, || !stop.load(Ordering::Relaxed))
        };
        let table = signals::stoppable(py, solve)?.map_err(|error| errors::wheelset(py, error))?;
        let columns = PyDict::new(py);
        for (name, values) in table.columns().chain(table.contact_columns()) {
            columns.set_item(name, PyArray1::from_vec(py, values))?;
        }
        Ok(columns)
    }

    /// `y` and the right wheel's rolling radius less the left's (m).
    fn radius_difference(&self, py: Python, rolls: bool) -> PyResult<Vec<(f64, f64)>> {
        let found = detached(py, || self.case.radius_difference(rolls))?;
        Ok(found.map_err(|error| errors::wheelset(py, error))?.rows().collect())
    }

    /// The equivalent conicity at amplitudes (m); NaN where contact ends before or the
    /// wheelset does not swing; and what is odd about it, in words. An amplitude that is not finite and positive is
    /// refused.
    fn conicity(
        &self,
        py: Python,
        amplitudes: Vec<f64>,
        rolls: bool,
    ) -> PyResult<(Vec<f64>, Vec<String>)> {
        let wrong = |amplitude: &&f64| !(**amplitude > 0.0 && amplitude.is_finite());
        if let Some(&value) = amplitudes.iter().find(wrong) {
            let (quantity, valid) = ("amplitude", "positive and finite");
            return Err(errors::invalid(py, InvalidValue { quantity, value, valid }));
        }
        let found = detached(py, || self.case.radius_difference(rolls))?;
        let difference = found.map_err(|error| errors::wheelset(py, error))?;
        let at = |amplitude: &f64| difference.conicity(*amplitude).unwrap_or(f64::NAN);
        let found: Vec<f64> = amplitudes.iter().map(at).collect();
        let swings = amplitudes.iter().zip(&found).filter(|(_, found)| !found.is_nan());
        let largest = swings.map(|(amplitude, _)| *amplitude).fold(0.0, f64::max);
        let words = self.case.conicity_caution_words(&difference, rolls, largest);
        Ok((found, words))
    }
}

/// Numbers of many rows; their statuses and their cautions.
type SolvedRows<'py> = (Bound<'py, PyArray1<f64>>, [Vec<String>; 2]);

#[pymethods]
impl SolvedWheelset {
    /// What it answers, as `ANSWERS` says.
    fn numbers<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.solved.answers())
    }

    /// Every quantity of the report: path, label, unit, value, error bar.
    fn quantities(&self, py: Python) -> PyResult<Vec<QuantityTuple>> {
        detached(py, || quantities(&self.solved.report()))
    }

    /// Where it stands: y, z, roll, yaw.
    fn position(&self) -> [f64; 4] {
        let found = self.solved.position();
        [found.y, found.z, found.roll, found.yaw]
    }

    /// The status in a word, and warnings.
    fn outcome(&self) -> (&'static str, Vec<String>) {
        (self.solved.status().name(), self.solved.caution_words())
    }

    /// `report.json` as text.
    fn json(&self, py: Python) -> PyResult<String> {
        serde_json::to_string(&detached(py, || self.solved.report())?)
            .map_err(|e| errors::internal(&e.to_string()))
    }

    /// Derivatives of the forces and their errors, each of 2 wheels, 6 forces, by 8 numbers.
    fn derivatives<'py>(&self, py: Python<'py>) -> Option<[Bound<'py, PyArray1<f64>>; 2]> {
        let found = self.solved.derivatives.as_ref()?;
        let flat =
            |all: [[[f64; 8]; 6]; 2]| PyArray1::from_slice(py, all.as_flattened().as_flattened());
        Some([flat(found.values()), flat(found.errors())])
    }

    /// A short report for a terminal.
    fn text(&self, py: Python) -> PyResult<String> {
        detached(py, || self.solved.text())
    }

    /// Both wheels on their rails.
    fn svg(&self) -> PyResult<String> {
        let picture = self.solved.svg(&self.case.running);
        picture.map_err(|error| errors::internal(&error.to_string()))
    }

    /// Writes the files of the report.
    fn write(&self, py: Python, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        let write = || self.solved.write(&self.case, &directory, &Sources::default());
        detached(py, write)?.map_err(errors::report)
    }
}
