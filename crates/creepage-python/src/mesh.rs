//! Positions of a field's points, from Python's arrays.

use creepage::Ellipse;
use pyo3::exceptions::{PyMemoryError, PyValueError};
use pyo3::prelude::*;

use crate::number::{Inputs, Number};

/// Shape, and positions in units of `c`.
pub(crate) type Mesh = (Vec<usize>, Vec<[f64; 2]>);

/// Most cells along a side.
const MAX_CELLS: usize = 10_000;

/// Midpoints of `count` x `count` cells of the box around the ellipse, line by line from `-y`.
pub(crate) fn cells(py: Python, ellipse: Ellipse, count: usize) -> PyResult<Mesh> {
    if !(1..=MAX_CELLS).contains(&count) {
        let message =
            format!("points = {count} is not valid: it must be between 1 and {MAX_CELLS}");
        return Err(PyValueError::new_err(message));
    }
    fits(count * count)?;
    let place = |k: usize| (2.0 * k as f64 + 1.0) / count as f64 - 1.0;
    let line = |j| (0..count).map(move |i| [ellipse.a() * place(i), ellipse.b() * place(j)]);
    Ok((vec![count, count], py.detach(|| (0..count).flat_map(line).collect())))
}

/// Raises MemoryError where there is no room for a field of so many points: what the library and the
/// arrays take is tried for, because the library itself cannot fail so gently.
fn fits(count: usize) -> PyResult<()> {
    const BYTES: usize = 240;
    let mut room = Vec::<[u8; BYTES]>::new();
    room.try_reserve_exact(count).map_err(|error| PyMemoryError::new_err(error.to_string()))?;
    // Else the attempt might be optimized away.
    std::hint::black_box(&room);
    Ok(())
}

/// The positions of arrays `x` and `y`.
pub(crate) fn given<'py>(py: Python<'py>, numbers: [Number<'py>; 2]) -> PyResult<Mesh> {
    let inputs = Inputs::new(py, ["x", "y"], numbers)?;
    let [x, y] = inputs.columns()?;
    let count = inputs.shape.iter().product();
    fits(count)?;
    let positions: Vec<_> = (0..count).map(|k| [x.at(k), y.at(k)]).collect();
    if let Some([x, y]) = positions.iter().find(|[x, y]| !(x.is_finite() && y.is_finite())) {
        let message = format!("position ({x}, {y}) is not valid: it must be finite");
        return Err(PyValueError::new_err(message));
    }
    Ok((inputs.shape, positions))
}
