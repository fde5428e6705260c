//! Many cases at once: broadcast, in parallel, without the GIL, open to Ctrl-C.

use std::sync::atomic::{AtomicUsize, Ordering};

use creepage::InvalidValue;
use numpy::{Element, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use rayon::prelude::*;

use crate::errors;
use crate::number::Inputs;
use crate::pool::pool;

/// Seconds between two looks at Python's signals.
const PATIENCE: f64 = 0.1;
/// Seconds of work worth handing to another thread.
const GRAIN: f64 = 2e-4;

/// Numbers found, and a code (a status or a region).
pub(crate) type Row<const W: usize> = ([f64; W], u8);

/// Columns of numbers, and the codes.
pub(crate) struct Answers<'py, const W: usize> {
    pub(crate) numbers: [Bound<'py, PyArrayDyn<f64>>; W],
    pub(crate) codes: Bound<'py, PyArrayDyn<u8>>,
}

/// Consecutive elements of the answers, to be filled by one thread.
struct Piece<'a, const W: usize> {
    first: usize,
    numbers: [&'a mut [f64]; W],
    codes: &'a mut [u8],
}

/// Solves every element; `cost` is that of one element in seconds, `prepare` makes what a thread
/// needs for itself.
pub(crate) fn solve_all<'py, const N: usize, const W: usize, S>(
    py: Python<'py>,
    inputs: &Inputs<'py, N>,
    cost: f64,
    prepare: impl Fn() -> S + Sync,
    solve: impl Fn(&mut S, [f64; N]) -> Result<Row<W>, InvalidValue> + Sync,
) -> PyResult<Answers<'py, W>> {
    let columns = inputs.columns()?;
    let arguments = |index: usize| columns.each_ref().map(|column| column.at(index));
    let answers = Answers::<W>::new(py, &inputs.shape)?;
    let invalid = AtomicUsize::new(usize::MAX);
    let fill = |own: &mut S, piece: Piece<W>| {
        if piece.first > invalid.load(Ordering::Relaxed) {
            return;
        }
        let bad = piece.fill(|index| solve(own, arguments(index)).ok());
        invalid.fetch_min(bad.unwrap_or(usize::MAX), Ordering::Relaxed);
    };
    answers
        .fill(py, cost, &invalid, prepare, fill, |index, own| solve(own, arguments(index)).err())?;
    Ok(answers)
}

impl<'py, const W: usize> Answers<'py, W> {
    fn new(py: Python<'py>, shape: &[usize]) -> PyResult<Self> {
        let mut numbers = Vec::with_capacity(W);
        for _ in 0..W {
            numbers.push(zeros(py, shape, "float64")?);
        }
        let numbers = numbers.try_into().map_err(|_| errors::internal("columns"))?;
        Ok(Self { numbers, codes: zeros(py, shape, "uint8")? })
    }

    /// Runs the pieces in groups short enough for signals to be answered. `complain` tells what
    /// is wrong with the first invalid element, which ends the run.
    fn fill<S>(
        &self,
        py: Python<'py>,
        cost: f64,
        invalid: &AtomicUsize,
        prepare: impl Fn() -> S + Sync,
        fill: impl Fn(&mut S, Piece<W>) + Sync,
        complain: impl Fn(usize, &mut S) -> Option<InvalidValue>,
    ) -> PyResult<()> {
        let mut numbers = Vec::with_capacity(W);
        for column in &self.numbers {
            numbers.push(column.try_readwrite()?);
        }
        let mut codes = self.codes.try_readwrite()?;
        let mut slices = Vec::with_capacity(W);
        for column in &mut numbers {
            slices.push(column.as_slice_mut()?);
        }
        let slices = slices.try_into().map_err(|_| errors::internal("columns"))?;
        let (pool, size) = (pool()?, at_least_one(GRAIN / cost).min(4096));
        let group = at_least_one(PATIENCE * pool.current_num_threads() as f64 / cost) / size;
        let mut pieces = pieces(slices, codes.as_slice_mut()?, size);
        loop {
            let some: Vec<_> = pieces.by_ref().take(group.max(1)).collect();
            if some.is_empty() {
                return Ok(());
            }
            py.detach(|| pool.install(|| some.into_par_iter().for_each_init(&prepare, &fill)));
            py.check_signals()?;
            let index = invalid.load(Ordering::Relaxed);
            if let Some(error) = (index < usize::MAX).then(|| complain(index, &mut prepare())) {
                let shape = self.codes.getattr("shape")?.cast_into::<PyTuple>()?.extract()?;
                return Err(errors::invalid_element(py, error, index, shape));
            }
        }
    }

    /// The columns side by side in a last dimension, or in the last dimensions `inner`.
    pub(crate) fn stacked(self, py: Python<'py>, inner: &[usize]) -> PyResult<Bound<'py, PyAny>> {
        let shape: Vec<usize> = self.codes.getattr("shape")?.extract()?;
        let stack = py.import("numpy")?.call_method1("stack", (self.numbers.to_vec(), -1))?;
        stack.call_method1("reshape", (PyTuple::new(py, [&shape, inner].concat())?,))
    }
}

impl<const W: usize> Piece<'_, W> {
    /// Fills it up to the first element without an answer, whose index is given.
    fn fill(mut self, mut solve: impl FnMut(usize) -> Option<Row<W>>) -> Option<usize> {
        for k in 0..self.codes.len() {
            let Some((row, code)) = solve(self.first + k) else {
                return Some(self.first + k);
            };
            for (column, value) in self.numbers.iter_mut().zip(row) {
                column[k] = value;
            }
            self.codes[k] = code;
        }
        None
    }
}

fn pieces<'a, const W: usize>(
    mut numbers: [&'a mut [f64]; W],
    mut codes: &'a mut [u8],
    size: usize,
) -> impl Iterator<Item = Piece<'a, W>> {
    let mut first = 0;
    std::iter::from_fn(move || {
        let length = size.min(codes.len());
        let piece = Piece {
            first,
            numbers: numbers
                .each_mut()
                .map(|column| column.split_off_mut(..length).unwrap_or_default()),
            codes: codes.split_off_mut(..length).unwrap_or_default(),
        };
        first += length;
        (length > 0).then_some(piece)
    })
}

/// A new array; Python's own error where there is no room for it.
pub(crate) fn zeros<'py, T: Element>(
    py: Python<'py>,
    shape: &[usize],
    dtype: &str,
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    let array = py.import("numpy")?.call_method1("zeros", (PyTuple::new(py, shape)?, dtype))?;
    Ok(array.cast_into()?)
}

// What is too large for a count saturates.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn at_least_one(count: f64) -> usize {
    count.max(1.0) as usize
}
