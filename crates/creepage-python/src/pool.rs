//! Thread pool that shares the work of an array.

use std::process;
use std::sync::{Arc, Mutex, PoisonError};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// The pool, and the process that it belongs to: after a fork the child has none of its threads.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// The pool of this process, as wide as the machine, or as `RAYON_NUM_THREADS` says.
pub(crate) fn pool() -> PyResult<Arc<ThreadPool>> {
    let mut held = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((owner, pool)) = &*held
        && *owner == process::id()
    {
        return Ok(pool.clone());
    }
    let build = ThreadPoolBuilder::new().thread_name(|k| format!("creepage {k}")).build();
    let pool = Arc::new(build.map_err(|error| PyRuntimeError::new_err(error.to_string()))?);
    // The parent's pool is forgotten rather than dropped: its locks may be held for ever here.
    std::mem::forget(held.replace((process::id(), pool.clone())));
    Ok(pool)
}

/// Works without Python's lock on the threads of this process's pool, those of the library included: its
/// own, of the whole process, have gone in a child after a fork, which would wait for them for ever.
pub(crate) fn detached<T: Send>(py: Python, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let pool = pool()?;
    Ok(py.detach(|| pool.install(work)))
}
