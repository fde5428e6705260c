//! Wheelsets by their files.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use creepage::InvalidValue;
use creepage_study::{
    CaseError, Load, Sources, Stance, Travel, WheelsetCase, WheelsetError, WheelsetFile,
    WheelsetTable, theory_spec,
};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

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
    solved: creepage_study::SolvedWheelset,
    case: WheelsetCase,
}

#[pymethods]
impl WheelsetData {
    /// From the text of a wheelset file whose profiles are in a directory.
    #[new]
    fn new(py: Python, text: &str, directory: PathBuf) -> PyResult<Self> {
        let read = || {
            let file = WheelsetFile::read(text).map_err(WheelsetError::from)?;
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
                solved.derivatives = Some(case.derivatives(&solved)?);
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

    /// Solves in another position and motion: `pose` holds y, z, roll, yaw, the load on both wheels, `motion`
    /// speed, pitch rate, lateral and vertical velocity, roll and yaw rate; NaN is the wheelset's own. With
    /// `start`, an earlier solution, from there; without it the same bits whatever came before.
    fn solve_at(
        &self,
        py: Python,
        pose: [f64; 5],
        motion: [f64; 6],
        start: Option<PyRef<SolvedWheelset>>,
        derivatives: bool,
    ) -> PyResult<SolvedWheelset> {
        let (case, start) = (self.case.clone(), start.map(|start| start.solved.clone()));
        let solve = move || {
            let (stance, travel) = at(&case, pose, motion)?;
            let solver = case.solver()?;
            let mut solved = match &start {
                Some(before) => solver.next(before, &stance, &travel)?,
                None => solver.solve(&stance, &travel)?,
            };
            if derivatives {
                solved.derivatives = Some(solver.derivatives(&solved, &stance, &travel)?);
            }
            Ok((solved, WheelsetCase { stance, travel: Some(travel), ..case }))
        };
        let solved = signals::answered(py, solve)?;
        let (solved, case) = solved.map_err(|error| errors::wheelset(py, error))?;
        Ok(SolvedWheelset { solved, case })
    }

    /// The same for many rows, 11 numbers each, on all cores and each from nothing: for each row 6 numbers of
    /// each wheel on its rail, 6 of the wrench, z, roll, pitch rate, in all 21, NaN where it was not solved; and
    /// its status and its cautions in words.
    fn solve_rows<'py>(
        &self,
        py: Python<'py>,
        rows: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<SolvedRows<'py>> {
        let (rows, case) = (rows.to_vec()?, self.case.clone());
        let solve = move |stop: &AtomicBool| {
            let solver = case.solver()?;
            let radius = case.running.wheelset().radius();
            let one = |row: &[f64; 11]| {
                if stop.load(Ordering::Relaxed) {
                    return ([f64::NAN; 21], ["not solved".to_owned(), String::new()]);
                }
                let [y, z, roll, yaw, load, motion @ ..] = *row;
                let solved = at(&case, [y, z, roll, yaw, load], motion)
                    .and_then(|(stance, travel)| solver.solve(&stance, &travel));
                match solved {
                    Ok(solved) => {
                        let words = solved.caution_words().join("; ");
                        (numbers(&solved, radius), [solved.status().name().to_owned(), words])
                    }
                    Err(error) => ([f64::NAN; 21], [error.to_string(), String::new()]),
                }
            };
            Ok(rows.as_chunks::<11>().0.par_iter().map(one).unzip())
        };
        let solved = signals::stoppable(py, solve)?;
        let (numbers, words): (Vec<_>, Vec<_>) =
            solved.map_err(|error| errors::wheelset(py, error))?;
        let (statuses, cautions) = words.into_iter().map(<(String, String)>::from).unzip();
        Ok((PyArray1::from_slice(py, numbers.as_flattened()), [statuses, cautions]))
    }

    /// Columns over yaw and lateral position, each as one flat array.
    fn table<'py>(
        &self,
        py: Python<'py>,
        y: PyReadonlyArray1<'py, f64>,
        yaw: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let [y, yaw] = [y, yaw].map(|values| values.to_vec());
        let (y, yaw) = (y?, yaw?);
        let case = self.case.clone();
        let solve = move |stop: &AtomicBool| {
            WheelsetTable::solve(&case, &y, &yaw, || !stop.load(Ordering::Relaxed))
        };
        let table = signals::stoppable(py, solve)?.map_err(|error| errors::wheelset(py, error))?;
        let columns = PyDict::new(py);
        for (name, values) in table.columns() {
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
    /// wheelset does not swing. An amplitude that is not finite and positive is refused.
    fn conicity(&self, py: Python, amplitudes: Vec<f64>, rolls: bool) -> PyResult<Vec<f64>> {
        let wrong = |amplitude: &&f64| !(**amplitude > 0.0 && amplitude.is_finite());
        if let Some(&value) = amplitudes.iter().find(wrong) {
            let (quantity, valid) = ("amplitude", "positive and finite");
            return Err(errors::invalid(py, InvalidValue { quantity, value, valid }));
        }
        let found = detached(py, || self.case.radius_difference(rolls))?;
        let difference = found.map_err(|error| errors::wheelset(py, error))?;
        let at = |amplitude: &f64| difference.conicity(*amplitude).unwrap_or(f64::NAN);
        Ok(amplitudes.iter().map(at).collect())
    }
}

/// Numbers of many rows; their statuses and their cautions.
type SolvedRows<'py> = (Bound<'py, PyArray1<f64>>, [Vec<String>; 2]);

/// The position and the motion of a row; NaN is the wheelset's own.
fn at(
    case: &WheelsetCase,
    [y, z, roll, yaw, load]: [f64; 5],
    motion: [f64; 6],
) -> Result<(Stance, Travel), WheelsetError> {
    let or = |value: f64, own: f64| if value.is_nan() { own } else { value };
    let given = |value: f64| (!value.is_nan()).then_some(value);
    let own = case.stance;
    let load = given(z).map(Load::Height).or(given(load).map(Load::Axle)).or(own.load);
    let roll = given(roll).or(own.roll);
    let stance = Stance { y: or(y, own.y), yaw: or(yaw, own.yaw), roll, load, ..own };
    let travel = case.travel.unwrap_or_default();
    let [speed, pitch_rate, lateral, vertical, roll_rate, yaw_rate] = motion;
    let travel = Travel {
        speed: or(speed, travel.speed),
        pitch_rate: given(pitch_rate).or(travel.pitch_rate),
        lateral_velocity: or(lateral, travel.lateral_velocity),
        vertical_velocity: or(vertical, travel.vertical_velocity),
        roll_rate: or(roll_rate, travel.roll_rate),
        yaw_rate: or(yaw_rate, travel.yaw_rate),
    };
    stance.checked()?;
    travel.checked()?;
    Ok((stance, travel))
}

/// Forces and moments on the left and the right rail, the wrench on the wheelset, z, roll, pitch rate.
fn numbers(solved: &creepage_study::SolvedWheelset, radius: f64) -> [f64; 21] {
    let mut all = [f64::NAN; 21];
    let wheels = [&solved.left, &solved.right].map(|wheel| {
        wheel.as_ref().map_or([[f64::NAN; 3]; 2], |wheel| {
            let on_rail = wheel.on_rail();
            [on_rail.force, on_rail.moment]
        })
    });
    let found = solved.position();
    let wrench = solved.wrench(radius);
    let parts = wheels.as_flattened().iter().chain(&wrench).copied();
    let parts = parts.flatten().chain([found.z, found.roll, solved.motion.pitch_rate]);
    all.iter_mut().zip(parts).for_each(|(place, number)| *place = number);
    all
}

#[pymethods]
impl SolvedWheelset {
    /// 21 numbers as of `solve_rows`.
    fn numbers<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let radius = self.case.running.wheelset().radius();
        PyArray1::from_slice(py, &numbers(&self.solved, radius))
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
        serde_json::to_string(&detached(py, || self.solved.json())?)
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
