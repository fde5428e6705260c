//! Long work of a single call: Ctrl-C is answered while it goes on.

use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

use crate::errors;

/// Between two looks at Python's signals.
const PATIENCE: Duration = Duration::from_millis(100);

/// Works in another thread, while this one answers signals. Where one raises, the work goes on
/// unseen to its end, and what it found is dropped.
pub(crate) fn answered<T: Send + 'static>(
    py: Python,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (sender, mut found) = sync_channel(1);
    // Nobody may be there any more to receive it.
    thread::Builder::new().spawn(move || drop(sender.send(work())))?;
    loop {
        let found = &mut found;
        match py.detach(move || found.recv_timeout(PATIENCE)) {
            Ok(found) => return Ok(found),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => return Err(errors::internal("solving a case")),
        }
    }
}
