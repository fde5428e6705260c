//! Building a table of a theory that Python prepares.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use creepage::rolling::{self, Creepage, FieldPoint, Force, Solution, Status};
use creepage_table::{Axis, BuildError, Spec, Table};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use crate::errors;
use crate::pool::pool;
use crate::theory::Theory;

/// Time between two looks at Python's signals.
const PATIENCE: Duration = Duration::from_millis(20);

/// A number, or the ends of a range.
#[derive(FromPyObject)]
pub(crate) enum Range {
    One(f64),
    Between(f64, f64),
}

impl Range {
    pub(crate) fn axis(&self, nodes: usize) -> Axis {
        match *self {
            Self::One(value) => Axis::fixed(value),
            Self::Between(low, high) => Axis { low, high, nodes },
        }
    }
}

/// "resolution = fast, ..."
pub(crate) fn words(options: Option<&Bound<PyDict>>) -> PyResult<String> {
    let mut words = Vec::new();
    for (name, value) in options.into_iter().flatten() {
        words.push(format!("{name} = {}", value.str()?));
    }
    Ok(words.join(", "))
}

/// The table of `creepage.theory(name, a_over_b, poisson, **options)`.
pub(crate) fn build(
    py: Python,
    spec: &Spec,
    name: &Bound<PyString>,
    options: Option<&Bound<PyDict>>,
) -> PyResult<Table> {
    let make = py.import("creepage")?.getattr("theory")?.unbind();
    let (name, options) = (name.clone().unbind(), options.map(|given| given.clone().unbind()));
    let pool = pool()?;
    let built = interruptible(py, |stop| {
        let prepare = |a_over_b: f64, poisson: f64| -> PyResult<Box<dyn rolling::Theory>> {
            Python::attach(|py| {
                let options = options.as_ref().map(|given| given.bind(py));
                let made = make.bind(py).call((&name, a_over_b, poisson), options)?;
                let theory = made.cast_into::<Theory>()?.unbind();
                Ok(Box::new(Asked { theory, stop: stop.clone() }) as Box<_>)
            })
        };
        pool.install(|| creepage_table::build(spec, prepare, &|| {}))
    })?;
    built.map_err(|error| match error {
        BuildError::Theory(error) => error,
        BuildError::Invalid(error) => errors::invalid(py, error),
        other => errors::no_table(py, &other.to_string()),
    })
}

/// A theory that Python prepared, asked without Python; once stopped, answered with nothing.
struct Asked {
    theory: Py<Theory>,
    stop: Arc<AtomicBool>,
}

impl rolling::Theory for Asked {
    fn solve(&self, creepage: Creepage) -> Solution {
        if self.stop.load(Ordering::Relaxed) {
            let force = Force { fx: 0.0, fy: 0.0, mz: 0.0 };
            return Solution { force, status: Status::NotConverged };
        }
        self.theory.get().model.theory().solve(creepage)
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.theory.get().model.theory().field(creepage, positions)
    }
}

/// Works in another thread, while this one answers signals; one that raises stops the work.
fn interruptible<T: Send>(
    py: Python,
    work: impl FnOnce(&Arc<AtomicBool>) -> T + Send,
) -> PyResult<T> {
    let (stop, here) = (Arc::new(AtomicBool::new(false)), thread::current());
    thread::scope(|scope| {
        let worker = scope.spawn(|| {
            let done = work(&stop);
            here.unpark();
            done
        });
        let mut raised = Ok(());
        while !worker.is_finished() {
            py.detach(|| thread::park_timeout(PATIENCE));
            raised = raised.and_then(|()| py.check_signals());
            stop.store(raised.is_err(), Ordering::Relaxed);
        }
        let done = worker.join().map_err(|_| errors::internal("building a table"))?;
        raised.map(|()| done)
    })
}
