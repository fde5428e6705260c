//! What every prepared theory can be asked.

use std::sync::Arc;

use creepage::Ellipse;
use creepage::rolling::{Creepage, Solution};
use creepage_study::{PreparedTheory, Solve, TheoryError, choose};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::batch::solve_all;
use crate::number::{Inputs, Number};
use crate::options::arguments;
use crate::{errors, mesh, results};

const NAMES: [&str; 3] = ["xi", "eta", "chi"];
/// Seconds below which letting other threads run costs more than it gives.
const QUICK: f64 = 2e-6;

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
    pub(crate) model: Arc<PreparedTheory>,
    /// As the class, in lower case.
    pub(crate) name: &'static str,
    pub(crate) ellipse: Ellipse,
    /// What it was made with, for pickle and repr.
    arguments: Py<PyDict>,
    /// Seconds of one force, roughly.
    cost: f64,
}

/// A theory that gives the derivative of its force.
#[pyclass(frozen, subclass, extends = Theory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct DifferentiableTheory;

/// The theory of that name in case files, prepared from options of case files. Raises InvalidOption
/// for a word that only another theory's option has.
pub(crate) fn prepare(
    py: Python,
    name: &str,
    a_over_b: f64,
    poisson: f64,
    solve: &Solve,
) -> PyResult<Result<PreparedTheory, TheoryError>> {
    let solve = &Solve { theory: Some(name.into()), ..solve.clone() };
    let choice = choose(&[], solve).map_err(|error| errors::choice(py, &error))?;
    let entry = choice.theories[0];
    Ok(py.detach(|| entry.prepare(a_over_b, poisson, solve)))
}

impl Theory {
    pub(crate) fn new(
        py: Python,
        name: &'static str,
        a_over_b: f64,
        arguments: Bound<PyDict>,
        cost: f64,
        made: Result<PreparedTheory, TheoryError>,
    ) -> PyResult<PyClassInitializer<Self>> {
        let model = Arc::new(made.map_err(|error| errors::theory(py, error))?);
        let ellipse = Ellipse::from_ratio(a_over_b).map_err(|error| errors::invalid(py, error))?;
        let arguments = arguments.unbind();
        Ok(PyClassInitializer::from(Self { model, name, ellipse, arguments, cost }))
    }

    fn solve_one<'py>(
        &self,
        py: Python<'py>,
        [xi, eta, chi]: [f64; 3],
    ) -> PyResult<Bound<'py, PyAny>> {
        let creepage = Creepage::new(xi, eta, chi).map_err(|error| errors::invalid(py, error))?;
        match &*self.model {
            PreparedTheory::Exact(theory) => {
                let found = py.detach(|| theory.solve_with(creepage, &mut theory.workspace()));
                results::exact_force(py, results::exact_row(found))
            }
            PreparedTheory::Automatic(theory) => {
                let found = py.detach(|| theory.solve_to_accuracy(creepage));
                results::exact_force(py, results::exact_row(found))
            }
            _ => results::force(py, results::plain_row(self.solve_plain(py, creepage))),
        }
    }

    fn solve_plain(&self, py: Python, creepage: Creepage) -> Solution {
        let theory = self.model.theory();
        if self.cost < QUICK {
            theory.solve(creepage)
        } else {
            py.detach(|| theory.solve(creepage))
        }
    }

    fn solve_many<'py>(
        &self,
        py: Python<'py>,
        inputs: &Inputs<'py, 3>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let creepage = |[xi, eta, chi]: [f64; 3]| Creepage::new(xi, eta, chi);
        match &*self.model {
            PreparedTheory::Exact(theory) => {
                let prepare = || theory.workspace();
                let answers = solve_all(py, inputs, self.cost, prepare, |workspace, at| {
                    Ok(results::exact_row(theory.solve_with(creepage(at)?, workspace)))
                })?;
                results::exact_forces(py, answers)
            }
            PreparedTheory::Automatic(theory) => {
                let answers = solve_all(
                    py,
                    inputs,
                    self.cost,
                    || (),
                    |(), at| Ok(results::exact_row(theory.solve_to_accuracy(creepage(at)?))),
                )?;
                results::exact_forces(py, answers)
            }
            PreparedTheory::Linear(theory) => self.solve_by(py, inputs, theory),
            model => self.solve_by(py, inputs, model.theory()),
        }
    }

    fn solve_by<'py, T: creepage::rolling::Theory + ?Sized>(
        &self,
        py: Python<'py>,
        inputs: &Inputs<'py, 3>,
        theory: &T,
    ) -> PyResult<Bound<'py, PyAny>> {
        let answers = solve_all(
            py,
            inputs,
            self.cost,
            || (),
            |(), [xi, eta, chi]| Ok(results::plain_row(theory.solve(Creepage::new(xi, eta, chi)?))),
        )?;
        results::forces(py, answers)
    }
}

impl DifferentiableTheory {
    /// A theory that has no options.
    pub(crate) fn plain(
        py: Python,
        name: &'static str,
        a_over_b: f64,
        poisson: f64,
        cost: f64,
    ) -> PyResult<PyClassInitializer<Self>> {
        let given = arguments(py, a_over_b, poisson, &[])?;
        let made = prepare(py, name, a_over_b, poisson, &Solve::default())?;
        Ok(Theory::new(py, name, a_over_b, given, cost, made)?.add_subclass(Self))
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
        (self.ellipse.a(), self.ellipse.b())
    }

    /// Force and moment on the lower body.
    ///
    /// xi, eta, chi: dimensionless creepages and spin, floats or anything of which NumPy makes
    /// arrays of real numbers; they broadcast against each other. For floats a Force of floats,
    /// else a Force of arrays of the common shape. Arrays are solved by all cores with the GIL
    /// released, and Ctrl-C ends them; do not write to them meanwhile.
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
        let (shape, positions) = if x.is_none() && y.is_none() {
            mesh::cells(py, self.ellipse, points)?
        } else {
            let zero = Number::One(0.0);
            mesh::given(py, [x.unwrap_or(zero), y.unwrap_or(Number::One(0.0))])?
        };
        let found = py.detach(|| self.model.theory().field(creepage, &positions));
        results::field(py, &shape, self.ellipse, &found)
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
        let theory: &Theory = slf.as_super();
        let inputs = Inputs::new(py, NAMES, [xi, eta, chi])?;
        // A derivative costs a few forces.
        let answers = solve_all(
            py,
            &inputs,
            5.0 * theory.cost,
            || (),
            |(), [xi, eta, chi]| {
                let matrix = theory.model.derivative(Creepage::new(xi, eta, chi)?);
                let mut row = [f64::NAN; 9];
                row.copy_from_slice(matrix.unwrap_or([[f64::NAN; 3]; 3]).as_flattened());
                Ok((row, 0))
            },
        )?;
        answers.stacked(py, &[3, 3])
    }
}
