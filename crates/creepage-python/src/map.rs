//! Python class of contact maps of wheelsets: built, kept in a file, asked.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use creepage_map::{ContactMap, PLACES, Side, Spread, WheelAnswer};
use creepage_study::{MapBuildError, MapPlan, MapResolution, WheelsetCase, WholeFile, build_map};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use rayon::prelude::*;

use crate::errors;
use crate::pool::detached;
use crate::signals;
use crate::table::Table;
use crate::wheelset::WheelsetData;

/// Numbers of a place of contact.
const PATCH: usize = 13;
/// Numbers of a wheel: its error, its places.
const WHEEL: usize = 3 + PLACES * PATCH;

/// A contact map.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct ContactMapData {
    map: Arc<ContactMap>,
}

/// 21 numbers, those of both wheels, derivatives.
type Solved<'py> =
    (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Option<Bound<'py, PyArray1<f64>>>);

/// 25 numbers of each row; rows without an answer, and why.
type SolvedRows<'py> = (Bound<'py, PyArray1<f64>>, Vec<(usize, String)>);

fn refused(py: Python, error: MapBuildError) -> PyErr {
    match error {
        MapBuildError::Wheelset(error) => errors::wheelset(py, error),
        other => PyValueError::new_err(other.to_string()),
    }
}

/// The plan of these numbers for this wheelset, which has a map by it.
fn checked_plan(
    py: Python,
    case: &WheelsetCase,
    [y, yaw, tolerance, narrowest]: [f64; 4],
    loads: Vec<f64>,
    states: usize,
    resolution: &str,
) -> PyResult<MapPlan> {
    let usual = MapPlan::of(case).map_err(|error| refused(py, error))?;
    let or = |value: f64, own: f64| if value.is_nan() { own } else { value };
    let resolution = match resolution {
        "fast" => MapResolution::Fast,
        "standard" => MapResolution::Standard,
        "fine" => MapResolution::Fine,
        other => {
            let words = format!("resolution must be fast, standard or fine, got {other:?}");
            return Err(PyValueError::new_err(words));
        }
    };
    let plan = MapPlan {
        y: or(y, usual.y),
        yaw: or(yaw, usual.yaw),
        tolerance: or(tolerance, usual.tolerance),
        widths: [usual.widths[0], or(narrowest, usual.widths[1])],
        loads: if loads.is_empty() { usual.loads.clone() } else { loads },
        states,
        resolution,
        ..usual
    };
    plan.check().and_then(|()| plan.check_case(case)).map_err(|error| refused(py, error))?;
    Ok(plan)
}

#[pymethods]
impl ContactMapData {
    /// Refuses what is in no map, before a table of ellipses is built.
    #[staticmethod]
    fn check(
        py: Python,
        wheelset: PyRef<WheelsetData>,
        plan: [f64; 4],
        loads: Vec<f64>,
        states: usize,
        resolution: &str,
    ) -> PyResult<()> {
        checked_plan(py, &wheelset.case, plan, loads, states, resolution).map(|_| ())
    }

    /// Builds the map of a wheelset, on all cores; NaN and nothing are the usual plan's.
    #[staticmethod]
    #[allow(clippy::too_many_arguments)] // those of Python
    fn build(
        py: Python,
        wheelset: PyRef<WheelsetData>,
        ellipses: PyRef<Table>,
        plan: [f64; 4],
        loads: Vec<f64>,
        states: usize,
        resolution: &str,
        journal: Option<PathBuf>,
    ) -> PyResult<Self> {
        let (case, text) = (wheelset.case.clone(), wheelset.text.clone());
        let table = Arc::clone(&ellipses.table);
        let plan = checked_plan(py, &case, plan, loads, states, resolution)?;
        let work = move |stop: &AtomicBool| {
            let goes_on = |_| !stop.load(Ordering::Relaxed);
            build_map(&case, &plan, table, text, journal.as_deref(), &goes_on)
        };
        let built = signals::stoppable(py, work)?;
        let map = built.map_err(|error| refused(py, error))?;
        Ok(Self { map: Arc::new(map) })
    }

    /// Reads a map's file.
    #[staticmethod]
    fn load(py: Python, path: PathBuf) -> PyResult<Self> {
        let bytes =
            py.detach(|| fs::read(&path)).map_err(|error| errors::os(error, path.clone()))?;
        let map = py.detach(|| ContactMap::from_bytes(bytes));
        let named = |error| errors::no_table(py, &format!("{}: {error}", path.display()));
        Ok(Self { map: Arc::new(map.map_err(named)?) })
    }

    /// A map of the bytes of its file.
    #[staticmethod]
    fn from_bytes(py: Python, bytes: Vec<u8>) -> PyResult<Self> {
        let map = py.detach(|| ContactMap::from_bytes(bytes));
        let map = map.map_err(|error| errors::no_table(py, &error.to_string()))?;
        Ok(Self { map: Arc::new(map) })
    }

    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        let make = py.get_type::<Self>().getattr("from_bytes")?;
        Ok((make, (PyBytes::new(py, &self.bytes(py)?),)))
    }

    /// Whether both have the same file.
    fn __eq__(&self, py: Python, other: &Bound<PyAny>) -> PyResult<bool> {
        let Ok(other) = other.cast::<Self>() else { return Ok(false) };
        Ok(self.bytes(py)? == other.get().bytes(py)?)
    }

    fn __hash__(&self, py: Python) -> PyResult<u64> {
        let mut hasher = DefaultHasher::new();
        self.bytes(py)?.hash(&mut hasher);
        Ok(hasher.finish())
    }

    /// Writes the map's file, which appears when it is whole.
    fn save(&self, py: Python, path: PathBuf) -> PyResult<()> {
        let bytes = self.bytes(py)?;
        let write = || {
            let mut file = WholeFile::create(&path)?;
            file.write_all(&bytes)?;
            file.finish()
        };
        py.detach(write).map_err(|error| errors::os(error, path.clone()))
    }

    /// The text of the wheelset's file.
    fn source(&self) -> &str {
        self.map.source()
    }

    /// The wheelset's own y, z (NaN where found), roll (NaN where found), yaw.
    fn own(&self) -> [f64; 4] {
        let own = self.map.head().own;
        let z = match own.pressed {
            creepage_map::HeightOrLoad::Height(z) => z,
            creepage_map::HeightOrLoad::AxleLoad(_) => f64::NAN,
        };
        [own.y, z, own.roll.unwrap_or(f64::NAN), own.yaw]
    }

    /// Of tangential, normal and whole force, away from where areas join and there: states, rms, median, 95 %,
    /// worst.
    fn error(&self) -> Vec<[f64; 5]> {
        let accuracy = self.map.accuracy();
        let all = [accuracy.tangential, accuracy.normal, accuracy.total];
        let row = |spread: Spread| {
            let Spread { states, rms, median, p95, worst } = spread;
            [states as f64, rms, median, p95, worst]
        };
        all.into_iter().flatten().map(row).collect()
    }

    /// Of the left and the right wheel: first and last place, number of nodes.
    fn ranges(&self) -> [[f64; 3]; 2] {
        [Side::Left, Side::Right].map(|side| {
            let wheel = self.map.wheel(side);
            let [low, high] = wheel.range();
            [low, high, wheel.places().len() as f64]
        })
    }

    /// One state: 21 numbers as of a wheelset, numbers of both wheels, derivatives where they are asked for.
    fn solve<'py>(
        &self,
        py: Python<'py>,
        row: [f64; 12],
        derivatives: bool,
    ) -> PyResult<Solved<'py>> {
        let state = self.map.head().own.with(&row);
        let wrong = |error: creepage_map::MapError| PyValueError::new_err(error.to_string());
        let (answer, by) = if derivatives {
            let (answer, by) = self.map.solve_with_derivatives(&state).map_err(wrong)?;
            (answer, Some(PyArray1::from_slice(py, by.as_flattened().as_flattened())))
        } else {
            (self.map.solve(&state).map_err(wrong)?, None)
        };
        let wheels: Vec<f64> = [answer.left, answer.right].iter().flat_map(wheel).collect();
        Ok((PyArray1::from_slice(py, &answer.numbers()), PyArray1::from_vec(py, wheels), by))
    }

    /// Many rows of 12 numbers, on all cores: 21 numbers each, two errors of each wheel; rows that have no
    /// answer and why.
    fn solve_rows<'py>(
        &self,
        py: Python<'py>,
        rows: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<SolvedRows<'py>> {
        let (rows, map) = (rows.to_vec()?, Arc::clone(&self.map));
        let solve = move || {
            let rows = rows.as_chunks::<12>().0;
            let mut out = vec![[f64::NAN; 25]; rows.len()];
            let one = |(k, (row, out)): (usize, (&[f64; 12], &mut [f64; 25]))| match map
                .solve(&map.head().own.with(row))
            {
                Ok(answer) => {
                    let errors = [answer.left.error, answer.right.error];
                    let errors = errors.iter().flat_map(|e| [e.tangential, e.normal]);
                    let all = answer.numbers().into_iter().chain(errors);
                    out.iter_mut().zip(all).for_each(|(to, from)| *to = from);
                    None
                }
                Err(error) => Some((k, error.to_string())),
            };
            let pairs = rows.par_iter().zip(out.par_iter_mut()).enumerate();
            let wrong: Vec<_> = pairs.with_min_len(64).filter_map(one).collect();
            (out, wrong)
        };
        let (out, wrong) = detached(py, solve)?;
        Ok((PyArray1::from_slice(py, out.as_flattened()), wrong))
    }
}

impl ContactMapData {
    /// The bytes of its file.
    fn bytes(&self, py: Python) -> PyResult<Vec<u8>> {
        let bytes = py.detach(|| self.map.to_bytes());
        bytes.map_err(|error| errors::no_table(py, &error.to_string()))
    }
}

fn wheel(wheel: &WheelAnswer) -> [f64; WHEEL] {
    let mut all = [0.0; WHEEL];
    let error = [wheel.error.states as f64, wheel.error.tangential, wheel.error.normal];
    let patches = wheel.patches.iter().flat_map(|patch| {
        let one = [patch.angle, patch.normal_force, patch.peak_pressure, patch.area];
        patch.reference.into_iter().chain(one).chain(patch.creepage).chain(patch.friction)
    });
    all.iter_mut().zip(error.into_iter().chain(patches)).for_each(|(to, from)| *to = from);
    all
}
