//! Signal checks during long work of a single call: Ctrl-C is answered while it goes on.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

use crate::errors;
use crate::pool::pool;

/// Between two looks at Python's signals.
const PATIENCE: Duration = Duration::from_millis(100);

/// Works in another thread, while this one answers signals. Where one raises, the work goes on
/// unseen to its end, and what it found is dropped.
pub(crate) fn answered<T: Send + 'static>(
    py: Python,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    stoppable(py, |_| work())
}

/// The same for work of many parts, which begins no other one once it is stopped.
pub(crate) fn stoppable<T: Send + 'static>(
    py: Python,
    work: impl FnOnce(&AtomicBool) -> T + Send + 'static,
) -> PyResult<T> {
    let (pool, stop) = (pool()?, Arc::new(AtomicBool::new(false)));
    let (sender, mut found) = sync_channel(1);
    let stopped = stop.clone();
    // Nobody may be there any more to receive it.
    let work = move || drop(sender.send(pool.install(|| work(&stopped))));
    thread::Builder::new().spawn(work)?;
    loop {
        let found = &mut found;
        match py.detach(move || found.recv_timeout(PATIENCE)) {
            Ok(found) => return Ok(found),
            Err(RecvTimeoutError::Timeout) => py.check_signals().inspect_err(|_| {
                stop.store(true, Ordering::Relaxed);
            })?,
            Err(RecvTimeoutError::Disconnected) => return Err(errors::internal("solving a case")),
        }
    }
}
