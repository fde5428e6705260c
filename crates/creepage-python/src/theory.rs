//! Python base class of every prepared theory.

use crate::batch::{Answers, Row, solve_all};
use crate::number::{Inputs, Number};
use crate::{errors, mesh, options, results, signals};
use creepage::theory::{NamedResolution, ResolutionSpec};
use creepage::variational::{
    IntegrandArguments, IntegrandTerms, Settings, Variational, VariationalError,
};
use creepage::{Contact, Creepage, Solution, TheorySpec};
use creepage_study::Caution;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

const NAMES: [&str; 3] = ["xi", "eta", "chi"];
/// Seconds below which letting other threads run costs more than it gives.
const QUICK: f64 = 2e-6;
/// Seconds of a force from which a single call answers signals.
pub(crate) const LONG: f64 = 1e-3;

/// A theory of steady rolling, prepared for one ratio of semi-axes and one Poisson's ratio.
///
/// Prepare once, ask many times, from any number of threads. All quantities are dimensionless:
/// creepages xi = upsilon_x rho / (mu c) and eta = upsilon_y rho / (mu c), spin
/// chi = phi rho / mu; forces fx, fy in units of mu N and the moment mz in units of mu N c, with
/// c = sqrt(a b). x is the rolling direction, z points into the lower body; creepage is that of
/// the upper body relative to the lower, forces are those of the upper body on the lower.
#[pyclass(frozen, subclass, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Theory {
    prepared: Arc<dyn creepage::Theory>,
    /// As the class, in lower case.
    name: &'static str,
    /// Whether its forces come with error bars.
    error_bars: bool,
    /// Largest error bar of the forces that it was told to keep, in parts of `mu N`.
    accuracy: Option<f64>,
    /// What it was made with, for pickle and repr.
    arguments: Py<PyDict>,
    /// Seconds of one force, roughly.
    cost: f64,
    /// What an integrand of the user's own has raised.
    raised: Raised,
}

/// A theory that gives the derivative of its force.
#[pyclass(frozen, subclass, extends = Theory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct DifferentiableTheory;

/// The arguments of a theory's class, read.
pub(crate) struct Call<'py> {
    pub(crate) contact: Contact,
    pub(crate) spec: TheorySpec,
    /// A function in place of the integrand of chapter 5.
    integrand: Option<Py<PyAny>>,
    arguments: Bound<'py, PyDict>,
}

impl<'py> Call<'py> {
    pub(crate) fn read(
        py: Python<'py>,
        name: &str,
        (a_over_b, poisson): (f64, f64),
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Self> {
        let arguments = PyDict::new(py);
        arguments.set_item("a_over_b", a_over_b)?;
        arguments.set_item("poisson", poisson)?;
        let own = options.map_or_else(|| Ok(PyDict::new(py)), PyDictMethods::copy)?;
        let mut kappa_over_mu = 0.0;
        // Other theories would not count it.
        if let ("exact" | "automatic" | "variational", Some(given)) =
            (name, own.get_item("kappa_over_mu")?)
        {
            kappa_over_mu = given.extract()?;
            own.del_item("kappa_over_mu")?;
        }
        let mut integrand = None;
        if let ("variational", Some(given)) = (name, own.get_item("integrand")?) {
            own.del_item("integrand")?;
            if !given.is_none() {
                arguments.set_item("integrand", &given)?;
                integrand = Some(given.unbind());
            }
        }
        let spec = options::spec(py, name, Some(&own))?;
        for (option, value) in own.iter().filter(|(_, value)| !value.is_none()) {
            arguments.set_item(option, value)?;
        }
        if let Some(accuracy) = spec.prescribed_accuracy() {
            arguments.set_item("accuracy", accuracy)?;
        }
        if kappa_over_mu != 0.0 {
            arguments.set_item("kappa_over_mu", kappa_over_mu)?;
        }
        let contact = options::contact(a_over_b, poisson, kappa_over_mu);
        let contact = contact.map_err(|error| errors::invalid(py, error))?;
        Ok(Self { contact, spec, integrand, arguments })
    }

    /// The theory of a class.
    pub(crate) fn prepare(self, py: Python, name: &'static str) -> PyResult<Theory> {
        let cost = cost(&self.spec);
        if let (TheorySpec::Variational(options), Some(function)) = (&self.spec, &self.integrand) {
            let function = function.clone_ref(py);
            let (made, raised) =
                prepare_own_integrand(py, &self.contact, options.settings(), function);
            check_raised(&raised)?;
            let made = made.map_err(|error| errors::theory(py, error.into()))?;
            return Ok(Theory { raised, ..self.theory(name, Arc::new(made), cost) });
        }
        let made = py.detach(|| self.spec.prepare(&self.contact));
        let theory = made.map_err(|error| errors::theory(py, error))?;
        Ok(self.theory(name, theory.into(), cost))
    }

    pub(crate) fn theory(
        self,
        name: &'static str,
        theory: Arc<dyn creepage::Theory>,
        cost: f64,
    ) -> Theory {
        let error_bars = self.spec.facts().error_bars;
        let accuracy = self.spec.prescribed_accuracy();
        let (arguments, raised) = (self.arguments.unbind(), Raised::default());
        Theory { prepared: theory, name, error_bars, accuracy, arguments, cost, raised }
    }
}

/// Seconds of one force, roughly.
pub(crate) fn cost(spec: &TheorySpec) -> f64 {
    let cells = |[along, across]: [usize; 2]| (along as f64) * (across as f64);
    match spec {
        TheorySpec::Exact(options) => {
            let once = match options.resolution {
                ResolutionSpec::Named(NamedResolution::Fast) => 3e-4,
                ResolutionSpec::Named(NamedResolution::Fine) => 5e-3,
                ResolutionSpec::Named(_) => 9e-4,
                ResolutionSpec::Elements(elements) => 1.1e-7 * cells(elements).powf(1.5),
            };
            // Pressing and rolling in turn.
            if options.coupled { 100.0 * once } else { once }
        }
        TheorySpec::Variational(options) => {
            let settings = options.settings();
            let unknowns = ((settings.degree + 1) * (settings.degree + 2)) as f64;
            3e-9 * cells(settings.mesh) * unknowns * unknowns
        }
        TheorySpec::Fastrip(options) => 7e-9 * cells(options.grid),
        TheorySpec::Fastsim(settings) => 2.2e-9 * cells(settings.grid),
        TheorySpec::Strip(_) | TheorySpec::Saturated(_) => 9e-7,
        _ => 3e-8,
    }
}

impl Theory {
    pub(crate) fn contact(&self) -> &Contact {
        self.prepared.contact()
    }

    fn solve_one<'py>(
        &self,
        py: Python<'py>,
        [xi, eta, chi]: [f64; 3],
    ) -> PyResult<Bound<'py, PyAny>> {
        let creepage = Creepage::new(xi, eta, chi).map_err(|error| errors::invalid(py, error))?;
        let prepared = Arc::clone(&self.prepared);
        let solve = move || prepared.solve(creepage);
        let solution = match self.cost {
            ..QUICK => solve(),
            QUICK..LONG => py.detach(solve),
            _ => signals::answered(py, solve)?,
        };
        check_raised(&self.raised)?;
        self.warn_of_accuracy(py, 1, self.missed(&solution))?;
        results::force(py, &solution)
    }

    fn solve_many<'py>(
        &self,
        py: Python<'py>,
        inputs: &Inputs<'py, 3>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if self.error_bars {
            // The number of forces that miss the accuracy, and the bits of the largest error bar.
            let (count, largest) = (AtomicUsize::new(0), AtomicU64::new(0));
            let row = |solution: &Solution| {
                if let Some(reached) = self.missed(solution) {
                    count.fetch_add(1, Ordering::Relaxed);
                    largest.fetch_max(reached.to_bits(), Ordering::Relaxed);
                }
                results::row_with_errors(solution)
            };
            let answers = self.rows(py, inputs, row)?;
            let (count, largest) = (count.into_inner(), f64::from_bits(largest.into_inner()));
            self.warn_of_accuracy(py, count, (count > 0).then_some(largest))?;
            return results::forces_with_errors(py, answers);
        }
        let rows = self.rows(py, inputs, results::row)?;
        check_raised(&self.raised)?;
        results::forces(py, rows)
    }

    /// The larger error bar of both forces, where it is above the prescribed accuracy.
    fn missed(&self, solution: &Solution) -> Option<f64> {
        let (accuracy, error) = (self.accuracy?, solution.error?);
        Some(error.fx.max(error.fy)).filter(|reached| *reached > accuracy)
    }

    /// Warns that error bars of `count` forces are above the prescribed accuracy.
    fn warn_of_accuracy(&self, py: Python, count: usize, reached: Option<f64>) -> PyResult<()> {
        let (Some(reached), Some(prescribed)) = (reached, self.accuracy) else { return Ok(()) };
        let caution = Caution::Accuracy { prescribed, reached };
        let words =
            if count > 1 { format!("{count} forces: {caution}") } else { caution.to_string() };
        errors::warn(py, "AccuracyWarning", &words)
    }

    fn rows<'py, const W: usize>(
        &self,
        py: Python<'py>,
        inputs: &Inputs<'py, 3>,
        row: impl Fn(&Solution) -> Row<W> + Sync,
    ) -> PyResult<Answers<'py, W>> {
        solve_all(py, inputs, self.cost, |[xi, eta, chi]| {
            Ok(row(&self.prepared.solve(Creepage::new(xi, eta, chi)?)))
        })
    }
}

#[pymethods]
impl Theory {
    /// The theory's name in case files.
    #[getter]
    fn name(&self) -> &'static str {
        self.name
    }

    /// Semi-axes (a, b) of the contact in units of c = sqrt(a b): sqrt(a/b) and sqrt(b/a).
    #[getter]
    fn semi_axes(&self) -> (f64, f64) {
        let ellipse = self.contact().ellipse();
        (ellipse.a(), ellipse.b())
    }

    /// Force and moment on the lower body.
    ///
    /// xi, eta, chi: dimensionless creepages and spin, floats or anything of which NumPy makes
    /// arrays of real numbers; they broadcast against each other, those of xarray by the names of
    /// their dimensions. For floats a Force of floats, else a Force of arrays of the common shape.
    /// Arrays are solved by all cores with the GIL released, and Ctrl-C ends them; do not write to
    /// them meanwhile.
    ///
    /// Raises InvalidValue where a component is not finite (or beyond 1e100), with the index of
    /// the first such element; TypeError for what is no real number, ValueError for shapes that
    /// do not broadcast.
    #[pyo3(signature = (xi=Number::One(0.0), eta=Number::One(0.0), chi=Number::One(0.0)),
           text_signature = "($self, xi=0.0, eta=0.0, chi=0.0)")]
    fn force<'py>(
        &self,
        py: Python<'py>,
        xi: Number<'py>,
        eta: Number<'py>,
        chi: Number<'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if let (Number::One(xi), Number::One(eta), Number::One(chi)) = (&xi, &eta, &chi) {
            return self.solve_one(py, [*xi, *eta, *chi]);
        }
        let inputs = Inputs::new(py, NAMES, [xi, eta, chi])?;
        match inputs.scalars() {
            Some(creepage) => self.solve_one(py, creepage),
            None => self.solve_many(py, &inputs),
        }
    }

    /// Traction and slip in the contact at one creepage: a Field.
    ///
    /// x, y: positions in units of c, floats or arrays that broadcast; by default the middles of
    /// points x points cells of the box around the ellipse, y first. Traction is that on the
    /// lower body in units of mu times the peak pressure, slip that of the upper body relative to
    /// the lower in units of mu c V / rho.
    #[pyo3(signature = (xi=0.0, eta=0.0, chi=0.0, *, x=None, y=None, points=50))]
    #[allow(clippy::too_many_arguments)] // Python's are by name
    fn field<'py>(
        &self,
        py: Python<'py>,
        xi: f64,
        eta: f64,
        chi: f64,
        x: Option<Number<'py>>,
        y: Option<Number<'py>>,
        points: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let creepage = Creepage::new(xi, eta, chi).map_err(|error| errors::invalid(py, error))?;
        let ellipse = self.contact().ellipse();
        let (shape, positions) = if x.is_none() && y.is_none() {
            mesh::cells(py, ellipse, points)?
        } else {
            let zero = Number::One(0.0);
            mesh::given(py, [x.unwrap_or(zero), y.unwrap_or(Number::One(0.0))])?
        };
        let found = py.detach(|| self.prepared.field(creepage, &positions));
        check_raised(&self.raised)?;
        results::field(py, &shape, ellipse, &found)
    }

    fn __repr__(&self, py: Python) -> PyResult<String> {
        let mut words = Vec::new();
        for (name, value) in self.arguments.bind(py).iter() {
            words.push(format!("{name}={}", value.repr()?));
        }
        Ok(format!("creepage.{}({})", self.name.replace('-', "_"), words.join(", ")))
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> (Bound<'py, PyTuple>, Py<PyDict>) {
        (PyTuple::empty(py), self.arguments.clone_ref(py))
    }
}

#[pymethods]
impl DifferentiableTheory {
    /// Derivative of (fx, fy, mz) (rows) by (xi, eta, chi) (columns): an array of shape (3, 3),
    /// or (..., 3, 3) for arrays, which broadcast as in force. One-sided where the force has a
    /// kink.
    ///
    /// Raises as force does.
    #[pyo3(signature = (xi=Number::One(0.0), eta=Number::One(0.0), chi=Number::One(0.0)),
           text_signature = "($self, xi=0.0, eta=0.0, chi=0.0)")]
    fn derivative<'py>(
        slf: PyRef<'py, Self>,
        py: Python<'py>,
        xi: Number<'py>,
        eta: Number<'py>,
        chi: Number<'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let Theory { prepared, cost, .. } = &**slf.as_super();
        let inputs = Inputs::new(py, NAMES, [xi, eta, chi])?;
        // A derivative costs a few forces.
        let answers = solve_all(py, &inputs, 5.0 * cost, |[xi, eta, chi]| {
            let matrix = prepared.jacobian(Creepage::new(xi, eta, chi)?);
            Ok(results::matrix_row(&matrix.unwrap_or([[f64::NAN; 3]; 3])))
        })?;
        answers.stacked(py, &[3, 3])
    }
}

/// The first exception of a function that is asked where none can be raised.
pub(crate) type Raised = Arc<Mutex<Option<PyErr>>>;

/// Chapter 5 with the integrand `function(x, y, a, b, t, s)`, which gives `f` and its derivatives
/// `f*`, `f.`, `f**`, `f*.`, `f..`.
fn prepare_own_integrand(
    py: Python,
    contact: &Contact,
    settings: Settings,
    function: Py<PyAny>,
) -> (Result<Variational, VariationalError>, Raised) {
    let raised = Raised::default();
    let kept = Arc::clone(&raised);
    let integrand = move |at| asked(&function, &kept, at);
    (py.detach(|| Variational::with_integrand(contact, settings, integrand)), raised)
}

/// Raises what the function has raised since the last time.
fn check_raised(raised: &Raised) -> PyResult<()> {
    let error = raised.lock().unwrap_or_else(PoisonError::into_inner).take();
    error.map_or(Ok(()), Err)
}

/// What the function answers; no numbers once it raises, which end the iteration.
fn asked(function: &Py<PyAny>, raised: &Raised, at: IntegrandArguments) -> IntegrandTerms {
    let ([x, y], [a, b]) = (at.position, at.semi_axes);
    let answer = Python::attach(|py| -> PyResult<[f64; 6]> {
        function.call1(py, (x, y, a, b, at.t, at.s))?.extract(py)
    });
    let [f, t, s, tt, ts, ss] = answer.unwrap_or_else(|error| {
        raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
        [f64::NAN; 6]
    });
    IntegrandTerms { f, t, s, tt, ts, ss }
}
