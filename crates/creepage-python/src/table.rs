//! Python class of tables of creep force: built, kept in a file, looked up.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;

use creepage::table::{Axis, FileError, Intervals, Provenance, Slice, Spec, Spread};
use creepage::{Creepage, InvalidValue, Solution, Statistics, Status, table};
use creepage_study::WholeFile;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::batch::solve_all;
use crate::number::{Inputs, Number};
use crate::table_build::{self, Range};
use crate::{errors, options, results};

const NAMES: [&str; 5] = ["xi", "eta", "chi", "a_over_b", "poisson"];
/// Seconds of one look-up, roughly.
const COST: f64 = 2e-7;

/// Creep force of one theory, looked up: over creepage and spin from zero to infinity, at one
/// ratio a/b and one Poisson's ratio or over ranges of these.
///
/// `Table.build` makes one, `Table.read` reads a file of `creepage table build`.
#[pyclass(frozen, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Table {
    pub(crate) table: Arc<table::Table>,
}

#[pymethods]
impl Table {
    /// Reads a table. Raises OSError, or TableError where the file is none or is damaged.
    #[staticmethod]
    fn read(py: Python, path: PathBuf) -> PyResult<Self> {
        let bytes =
            py.detach(|| fs::read(&path)).map_err(|error| errors::os(error, path.clone()))?;
        let named =
            |error: FileError| errors::no_table(py, &format!("{}: {error}", path.display()));
        let table = py.detach(|| table::Table::from_bytes(bytes)).map_err(named)?;
        Ok(Self { table: Arc::new(table) })
    }

    /// Writes the table to a file of NetCDF, which xarray opens too; the file appears when it is
    /// whole. Raises OSError.
    fn write(&self, py: Python, path: PathBuf) -> PyResult<()> {
        let bytes = self.bytes(py)?;
        let write = || {
            let mut file = WholeFile::create(&path)?;
            file.write_all(&bytes)?;
            file.finish()
        };
        py.detach(write).map_err(|error| errors::os(error, path.clone()))
    }

    /// A table of the bytes of its file.
    #[staticmethod]
    fn from_bytes(py: Python, bytes: Vec<u8>) -> PyResult<Self> {
        let table = table::Table::from_bytes(bytes);
        let table = table.map_err(|error| errors::no_table(py, &error.to_string()))?;
        Ok(Self { table: Arc::new(table) })
    }

    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        let make = py.get_type::<Self>().getattr("from_bytes")?;
        Ok((make, (PyBytes::new(py, &self.bytes(py)?),)))
    }

    /// Builds the table of a theory, on all cores, and measures its error.
    ///
    /// theory: its name, one that is linear near zero and bounded; options are those of its
    /// class. a_over_b, poisson: a number each, or the first and the last of a range of `shapes`
    /// and of `materials` nodes. intervals: along theta (from pure spin to none), phi (from -eta
    /// over xi to eta; even) and t (from no creepage to infinite creepage). places: at how many
    /// random ones the error is measured, and at about as many where the force bends most. Ctrl-C
    /// ends it.
    ///
    /// Raises UnknownTheory, InvalidValue, TableError for a theory of which there is no table.
    #[staticmethod]
    #[pyo3(signature = (theory, a_over_b, poisson, *, intervals=[20, 16, 48], shapes=9,
                        materials=4, places=500, **options))]
    #[allow(clippy::too_many_arguments)] // by name in Python
    fn build(
        py: Python,
        theory: &str,
        a_over_b: Range,
        poisson: Range,
        intervals: [usize; 3],
        shapes: usize,
        materials: usize,
        places: usize,
        options: Option<&Bound<PyDict>>,
    ) -> PyResult<Self> {
        let ([theta, phi, t], of) = (intervals, options::spec(py, theory, options)?);
        let spec = Spec {
            a_over_b: a_over_b.axis(shapes),
            poisson: poisson.axis(materials),
            intervals: Intervals { theta, phi, t },
            places,
            provenance: Provenance {
                theory: theory.replace('_', "-"),
                options: table_build::words(options)?,
                program: format!("creepage {}", env!("CARGO_PKG_VERSION")),
            },
        };
        Ok(Self { table: Arc::new(table_build::build(py, &spec, &of)?) })
    }

    /// Name of the theory.
    #[getter]
    fn theory(&self) -> &str {
        &self.table.provenance().theory
    }

    /// Its options, as a person would write them; may be empty.
    #[getter]
    fn options(&self) -> &str {
        &self.table.provenance().options
    }

    /// First and last ratio a/b; the same where the table has but one.
    #[getter]
    fn a_over_b(&self) -> (f64, f64) {
        let Axis { low, high, .. } = self.table.a_over_b();
        (low, high)
    }

    /// First and last Poisson's ratio.
    #[getter]
    fn poisson(&self) -> (f64, f64) {
        let Axis { low, high, .. } = self.table.poisson();
        (low, high)
    }

    /// The measured error of (fx, fy), in units of mu N: median, 95 %, 99 % and worst of the
    /// places.
    #[getter]
    fn force_error(&self) -> (f64, f64, f64, f64) {
        spread(self.table.accuracy().force)
    }

    /// The measured error of mz, in units of mu N c.
    #[getter]
    fn moment_error(&self) -> (f64, f64, f64, f64) {
        spread(self.table.accuracy().moment)
    }

    /// Force and moment on the lower body, as a theory gives them.
    ///
    /// xi, eta, chi, a_over_b, poisson: floats or arrays, which broadcast. The last two may be
    /// left out where the table has but one. Raises InvalidValue outside the table's ranges, and
    /// as a theory's force does.
    #[pyo3(signature = (xi=Number::One(0.0), eta=Number::One(0.0), chi=Number::One(0.0), *,
                        a_over_b=None, poisson=None),
           text_signature = "($self, xi=0.0, eta=0.0, chi=0.0, *, a_over_b=None, poisson=None)")]
    fn force<'py>(
        &self,
        py: Python<'py>,
        xi: Number<'py>,
        eta: Number<'py>,
        chi: Number<'py>,
        a_over_b: Option<Number<'py>>,
        poisson: Option<Number<'py>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let inputs = self.inputs(py, [xi, eta, chi], a_over_b, poisson)?;
        let solve = |at: [f64; 5]| {
            let (creepage, slice) = self.place(at)?;
            let (status, statistics) = (Status::Solved, Statistics::default());
            Ok(Solution { force: slice.force(creepage), error: None, status, statistics })
        };
        if let Some(at) = inputs.scalars() {
            return results::force(py, &solve(at).map_err(|error| errors::invalid(py, error))?);
        }
        results::forces(py, solve_all(py, &inputs, COST, |at| Ok(results::row(&solve(at)?)))?)
    }

    /// Derivative of (fx, fy, mz) (rows) by (xi, eta, chi) (columns), that of the interpolation:
    /// an array of shape (3, 3), or (..., 3, 3) for arrays. Arguments and errors as in force.
    #[pyo3(signature = (xi=Number::One(0.0), eta=Number::One(0.0), chi=Number::One(0.0), *,
                        a_over_b=None, poisson=None),
           text_signature = "($self, xi=0.0, eta=0.0, chi=0.0, *, a_over_b=None, poisson=None)")]
    fn derivative<'py>(
        &self,
        py: Python<'py>,
        xi: Number<'py>,
        eta: Number<'py>,
        chi: Number<'py>,
        a_over_b: Option<Number<'py>>,
        poisson: Option<Number<'py>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let inputs = self.inputs(py, [xi, eta, chi], a_over_b, poisson)?;
        let answers = solve_all(py, &inputs, 2.0 * COST, |at| {
            let (creepage, slice) = self.place(at)?;
            Ok(results::matrix_row(&slice.force_and_derivative(creepage).1))
        })?;
        answers.stacked(py, &[3, 3])
    }

    /// The same numbers of the same theory.
    fn __eq__(&self, py: Python, other: &Bound<PyAny>) -> PyResult<bool> {
        let Ok(other) = other.cast::<Self>() else { return Ok(false) };
        Ok(self.bytes(py)? == other.get().bytes(py)?)
    }

    fn __hash__(&self, py: Python) -> PyResult<u64> {
        let mut hasher = DefaultHasher::new();
        self.bytes(py)?.hash(&mut hasher);
        Ok(hasher.finish())
    }

    fn __repr__(&self) -> String {
        let [a_over_b, poisson] = [self.a_over_b(), self.poisson()];
        let worst = self.table.accuracy().force.worst;
        format!(
            "<creepage.Table of {}, a/b {a_over_b:?}, Poisson's ratio {poisson:?}, error at most \
             {worst:.1e} mu N>",
            self.theory()
        )
    }
}

impl Table {
    /// The table, for a solver to keep.
    pub(crate) fn shared(&self) -> Arc<table::Table> {
        Arc::clone(&self.table)
    }

    fn bytes(&self, py: Python) -> PyResult<Vec<u8>> {
        let bytes = py.detach(|| self.table.to_bytes());
        bytes.map_err(|error| errors::no_table(py, &error.to_string()))
    }

    fn inputs<'py>(
        &self,
        py: Python<'py>,
        [xi, eta, chi]: [Number<'py>; 3],
        a_over_b: Option<Number<'py>>,
        poisson: Option<Number<'py>>,
    ) -> PyResult<Inputs<'py, 5>> {
        // Without a value the only node serves; a table of several refuses NaN.
        let only = |axis: Axis| if axis.nodes == 1 { axis.low } else { f64::NAN };
        let given = |number: Option<Number<'py>>, axis| number.unwrap_or(Number::One(only(axis)));
        let a_over_b = given(a_over_b, self.table.a_over_b());
        let poisson = given(poisson, self.table.poisson());
        Inputs::new(py, NAMES, [xi, eta, chi, a_over_b, poisson])
    }

    fn place(
        &self,
        [xi, eta, chi, a_over_b, poisson]: [f64; 5],
    ) -> Result<(Creepage, Slice<'_>), InvalidValue> {
        Ok((Creepage::new(xi, eta, chi)?, self.table.at(a_over_b, poisson)?))
    }
}

fn spread(spread: Spread) -> (f64, f64, f64, f64) {
    let Spread { median, p95, p99, worst } = spread;
    (median, p95, p99, worst)
}
