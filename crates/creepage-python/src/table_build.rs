//! Construction of a table, open to Ctrl-C.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use creepage::table::{self, Axis, BuildError, Spec, Table};
use creepage::theory::{Jacobian, Solved};
use creepage::{
    Contact, Creepage, FieldPoint, Force, InvalidValue, Solution, Statistics, Status, Theory,
    TheorySpec,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors;
use crate::pool::pool;

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

/// The table of a theory.
pub(crate) fn build(py: Python, spec: &Spec, theory: &TheorySpec) -> PyResult<Table> {
    let pool = pool()?;
    let built = interruptible(py, |stop| {
        let prepare = |contact: &Contact| {
            let stop = stop.clone();
            if stop.load(Ordering::Relaxed) {
                // Ends the building; what is told is what stopped it.
                let valid = "not stopped";
                return Err(InvalidValue { quantity: "building", value: 0.0, valid }.into());
            }
            Ok(Box::new(InterruptibleTheory { theory: theory.prepare(contact)?, stop }) as Box<_>)
        };
        pool.install(|| table::build(spec, prepare, &|| {}))
    })?;
    built.map_err(|error| match error {
        BuildError::Theory(error) => errors::theory(py, error),
        BuildError::Invalid(error) => errors::invalid(py, error),
        other => errors::no_table(py, &other.to_string()),
    })
}

/// A theory that, once stopped, answers with nothing.
struct InterruptibleTheory {
    theory: Box<dyn Theory>,
    stop: Arc<AtomicBool>,
}

impl Theory for InterruptibleTheory {
    fn contact(&self) -> &Contact {
        self.theory.contact()
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        if self.stop.load(Ordering::Relaxed) {
            let (status, statistics) = (Status::NotConverged, Statistics::default());
            return Solution { force: Force::default(), error: None, status, statistics };
        }
        self.theory.solve(creepage)
    }

    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        self.theory.jacobian(creepage)
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.theory.field(creepage, positions)
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        self.theory.solved(creepage)
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
