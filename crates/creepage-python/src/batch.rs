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

/// Solves every element; `cost` is that of one element in seconds.
pub(crate) fn solve_all<'py, const N: usize, const W: usize>(
    py: Python<'py>,
    inputs: &Inputs<'py, N>,
    cost: f64,
    solve: impl Fn([f64; N]) -> Result<Row<W>, InvalidValue> + Sync,
) -> PyResult<Answers<'py, W>> {
    let columns = inputs.columns()?;
    let solve = |index: usize| solve(columns.each_ref().map(|column| column.at(index)));
    let answers = Answers::<W>::new(py, &inputs.shape)?;
    if let Some(index) = answers.fill(py, cost, |index| solve(index).ok())? {
        return Err(errors::invalid_element(py, solve(index).err(), index, &inputs.shape));
    }
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

    /// Runs the pieces in groups short enough for signals to be answered. The first element without
    /// an answer, if there is one, ends the run and is given.
    fn fill(
        &self,
        py: Python<'py>,
        cost: f64,
        solve: impl Fn(usize) -> Option<Row<W>> + Sync,
    ) -> PyResult<Option<usize>> {
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
        let codes = codes.as_slice_mut()?;
        let size = at_least_one(GRAIN / cost).min(4096);
        if codes.len() <= size {
            let all = Piece { first: 0, numbers: slices, codes };
            return Ok(py.detach(|| all.fill(&solve)));
        }
        let pool = pool()?;
        let group = at_least_one(PATIENCE * pool.current_num_threads() as f64 / cost) / size;
        let (bad, mut pieces) = (AtomicUsize::new(usize::MAX), pieces(slices, codes, size));
        let fill = |piece: Piece<W>| {
            if piece.first <= bad.load(Ordering::Relaxed) {
                bad.fetch_min(piece.fill(&solve).unwrap_or(usize::MAX), Ordering::Relaxed);
            }
        };
        loop {
            let some: Vec<_> = pieces.by_ref().take(group.max(1)).collect();
            let first_bad = bad.load(Ordering::Relaxed);
            if some.is_empty() || first_bad < usize::MAX {
                return Ok(Some(first_bad).filter(|index| *index < usize::MAX));
            }
            py.detach(|| pool.install(|| some.into_par_iter().for_each(fill)));
            py.check_signals()?;
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
    fn fill(mut self, solve: impl Fn(usize) -> Option<Row<W>>) -> Option<usize> {
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
