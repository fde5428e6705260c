//! Python class of transient rolling: step by step, and whole histories.

use std::sync::{Mutex, MutexGuard, PoisonError};

use creepage::SiCreepage;
use creepage_study::{
    Caution, HISTORY_COLUMNS, History, HistoryError, HistoryRun, RollFile, RollStart, RollStepper,
};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::{errors, results};

/// A contact that rolls step by step.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct RollingData {
    stepper: Mutex<RollStepper>,
}

/// Distance (m), creepage in SI units, force in SI units, share of adhesion, status, what the motion is in doubt for.
type Step = (f64, [f64; 3], [f64; 3], f64, u8, Option<String>);

/// The file of a contact that rolls, or that of a steady case without its creepage.
fn file(text: &str, is_case: bool, start: Option<Start>) -> Result<RollFile, HistoryError> {
    let file = if is_case { RollFile::of_case(text) } else { RollFile::read(text) }?;
    Ok(match start {
        None => file,
        Some(Start::Shift(force)) => file.with_start(RollStart::Shift(force)),
        Some(Start::Steady(true)) => file.with_start(RollStart::Steady),
        Some(Start::Steady(false)) => file.with_start(RollStart::None),
    })
}

/// As Python gives it: forces of a shift (N), or whether rolling was steady.
#[derive(FromPyObject)]
pub(crate) enum Start {
    Steady(bool),
    Shift([f64; 2]),
}

#[pymethods]
impl RollingData {
    #[new]
    fn new(py: Python, text: &str, is_case: bool, start: Option<Start>) -> PyResult<Self> {
        let prepare = || RollStepper::new(file(text, is_case, start)?.case(".".as_ref())?);
        let stepper = py.detach(prepare).map_err(|error| errors::history(py, error))?;
        Ok(Self { stepper: Mutex::new(stepper) })
    }

    /// What the contact is in doubt for, in words.
    #[getter]
    fn caution(&self) -> Option<String> {
        words(&self.lock().case().cautions)
    }

    /// Rolls on by numbers named as the columns of a history.
    fn step(&self, py: Python, given: Vec<(String, f64)>) -> PyResult<Step> {
        let given: Vec<_> = given.iter().map(|(name, value)| (&name[..], *value)).collect();
        let step = || {
            let mut stepper = self.lock();
            let rolled = stepper.step(&given)?;
            let units = stepper.case().scaling;
            let creepage = units.si_creepage(rolled.creepage);
            let asked = |name| {
                given.iter().find(|(known, _)| *known == name).map_or(0.0, |(_, value)| *value)
            };
            let [longitudinal, lateral, spin] = ["longitudinal", "lateral", "spin"].map(asked);
            let asked = SiCreepage { longitudinal, lateral, spin };
            let caution =
                stepper.case().caution_of_motion(asked).map(|caution| caution.to_string());
            let force = units.si_force(rolled.solution.force);
            Ok((
                rolled.distance * units.length,
                [creepage.longitudinal, creepage.lateral, creepage.spin],
                [force.longitudinal, force.lateral, force.moment],
                rolled.adhesion_share,
                results::code(rolled.solution.status),
                caution,
            ))
        };
        py.detach(step).map_err(|error| errors::history(py, error))
    }

    /// What the contact remembers.
    fn save(&self, py: Python) -> Vec<u8> {
        py.detach(|| self.lock().save())
    }

    fn restore(&self, py: Python, state: &[u8]) -> PyResult<()> {
        let restored = py.detach(|| self.lock().restore(state));
        restored.map_err(errors::no_state)
    }
}

impl RollingData {
    fn lock(&self) -> MutexGuard<'_, RollStepper> {
        self.stepper.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn words(cautions: &[Caution]) -> Option<String> {
    (!cautions.is_empty()).then(|| Caution::words(cautions))
}

/// A whole history by its columns: those of `history.csv`, the status as numbers of `creepage.Status`; and what the
/// contact is in doubt for, in words.
#[pyfunction]
pub(crate) fn roll<'py>(
    py: Python<'py>,
    text: &str,
    is_case: bool,
    start: Option<Start>,
    columns: Vec<(String, PyReadonlyArray1<'py, f64>)>,
) -> PyResult<(Bound<'py, PyDict>, Option<String>)> {
    let wrong = |error| errors::history(py, error);
    let given: Vec<(String, Vec<f64>)> =
        columns.iter().map(|(name, values)| (name.clone(), values.as_array().to_vec())).collect();
    let columns: Vec<_> = given.iter().map(|(name, values)| (&name[..], &values[..])).collect();
    let case = py.detach(|| file(text, is_case, start)?.case(".".as_ref())).map_err(wrong)?;
    let history = History::from_columns(&columns, &case).map_err(wrong)?;
    let mut run = py.detach(|| HistoryRun::new(&case, &history)).map_err(wrong)?;
    let mut found: [Vec<f64>; 11] = Default::default();
    let mut statuses = Vec::new();
    while let Some((distance, rolled)) = py.detach(|| run.next_row()).map_err(wrong)? {
        py.check_signals()?;
        let numbers = run.numbers(distance, &rolled);
        found.iter_mut().zip(numbers).for_each(|(column, number)| column.push(number));
        statuses.push(results::code(rolled.solution.status));
    }
    let table = PyDict::new(py);
    for (name, values) in HISTORY_COLUMNS.into_iter().zip(found) {
        table.set_item(name, PyArray1::from_vec(py, values))?;
    }
    table.set_item("status", PyArray1::from_vec(py, statuses))?;
    let of_row = history.caution(&case).map(|(row, caution)| format!("row {row}: {caution}"));
    let all: Vec<_> = words(&case.cautions).into_iter().chain(of_row).collect();
    Ok((table, (!all.is_empty()).then(|| all.join("; "))))
}
