//! Bulk solution of many rows, each a case or an error: of one case in SI units, or of
//! dimensionless contacts and creepages.

use std::ops::Range;

use creepage::Creepage;
use creepage_study::{
    BulkCase, BulkColumn, BulkQuery, Caution, Damage, Reply, RowError, Solver, Varied,
};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::case::CaseData;
use crate::number::{Column, Inputs, Number};
use crate::pool::pool;
use crate::table::Table;
use crate::theory::cost;
use crate::{errors, options, results};

/// Seconds between two looks at Python's signals.
const PATIENCE: f64 = 0.1;
/// Seconds of work worth handing to other threads.
const GRAIN: f64 = 2e-4;
/// Seconds that a row in SI units costs besides its theory.
const ROW: f64 = 6e-6;
/// The code of a row that is no case, in `creepage.Status`.
const INVALID: u8 = 4;

/// What answers, and the seconds of one answer, roughly.
fn solver(
    py: Python,
    theory: &str,
    given: &Bound<PyDict>,
    table: Option<&Table>,
) -> PyResult<(Solver, f64)> {
    if let Some(table) = table {
        return Ok((Solver::of_table(table.shared()), 3e-7));
    }
    let spec = options::spec(py, theory, Some(given))?;
    let cost = cost(&spec);
    Ok((Solver::new(spec), cost))
}

/// Forces of a case some of whose quantities are arrays: columns by name, `status` as numbers of
/// creepage.Status, and `messages`, pairs of an index and the cautions about that row.
#[pyfunction]
#[pyo3(signature = (case, theory, options, table, quantities))]
pub(crate) fn case_forces<'py>(
    py: Python<'py>,
    case: &CaseData,
    theory: &str,
    options: &Bound<'py, PyDict>,
    table: Option<PyRef<'py, Table>>,
    quantities: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let (solver, cost) = solver(py, theory, options, table.as_deref())?;
    let (varied, inputs) = columns_of(py, quantities)?;
    let bulk = BulkCase::new(case.file(), varied).map_err(|error| errors::case(py, error))?;
    let columns = inputs.columns()?;
    let given: Vec<Column> = Varied::ALL
        .iter()
        .zip(columns)
        .filter_map(|(quantity, column)| bulk.varied().contains(quantity).then_some(column))
        .collect();
    let values = |row: usize| -> Vec<f64> { given.iter().map(|column| column.at(row)).collect() };
    let one = |row: usize| bulk.solve_one(&solver, &values(row));
    let many = |rows: Range<usize>| {
        let values: Vec<_> = rows.map(values).collect();
        bulk.solve(&solver, &values.iter().map(Vec::as_slice).collect::<Vec<_>>())
    };
    let answers = run(py, inputs.shape.iter().product(), cost + ROW, one, many)?;
    let damage = bulk.damage().map_or(&[][..], |_| &Damage::OF_ROWS[..]);
    let names = if bulk.has_speed() { &SI[..] } else { &SI[..4] };
    let mut found = Columns::new(&[names, damage].concat(), solver.error_bars());
    for answer in answers {
        found.push(answer.map(|answer| (answer.numbers(bulk.damage()).collect(), answer.reply)));
    }
    found.into_dict(py, &inputs.shape)
}

/// Python's names of [`BulkColumn::ALL`].
const SI: [&str; BulkColumn::ALL.len()] =
    ["longitudinal", "lateral", "moment", "heat_per_metre", "power"];
const CONTACT: [&str; 6] = ["a_over_b", "poisson", "kappa_over_mu", "xi", "eta", "chi"];

/// Forces of dimensionless rows, as `case_forces` gives them; `columns` are a_over_b, poisson,
/// kappa_over_mu, xi, eta, chi.
#[pyfunction]
#[pyo3(signature = (theory, options, table, columns))]
pub(crate) fn row_forces<'py>(
    py: Python<'py>,
    theory: &str,
    options: &Bound<'py, PyDict>,
    table: Option<PyRef<'py, Table>>,
    columns: [Number<'py>; 6],
) -> PyResult<Bound<'py, PyDict>> {
    let (solver, cost) = solver(py, theory, options, table.as_deref())?;
    let inputs = Inputs::new(py, CONTACT, columns)?;
    let columns = inputs.columns()?;
    let query = |row: usize| -> Result<BulkQuery, RowError> {
        let [a_over_b, poisson, kappa_over_mu, xi, eta, chi] =
            columns.each_ref().map(|column| column.at(row));
        let contact = crate::options::contact(a_over_b, poisson, kappa_over_mu)?;
        Ok(BulkQuery { contact, creepage: Creepage::new(xi, eta, chi)?, touches: true })
    };
    let one = |row: usize| solver.solve_one(&query(row)?);
    let many = |rows: Range<usize>| solver.solve(rows.map(query).collect());
    let answers = run(py, inputs.shape.iter().product(), cost, one, many)?;
    let mut found = Columns::new(&[], solver.error_bars());
    for answer in answers {
        found.push(answer.map(|reply| (Vec::new(), reply)));
    }
    found.into_dict(py, &inputs.shape)
}

/// The quantities that are given, and all of them broadcast.
fn columns_of<'py>(
    py: Python<'py>,
    quantities: &Bound<'py, PyDict>,
) -> PyResult<(Vec<Varied>, Inputs<'py, 12>)> {
    let mut varied = Vec::new();
    let mut numbers = [const { Number::One(f64::NAN) }; 12];
    for (quantity, number) in Varied::ALL.iter().zip(&mut numbers) {
        if let Some(value) = quantities.get_item(quantity.name())? {
            varied.push(*quantity);
            *number = value.extract()?;
        }
    }
    Ok((varied, Inputs::new(py, Varied::ALL.map(Varied::name), numbers)?))
}

/// The answers to so many rows: here where that is quick, else by all threads, in portions short
/// enough for signals to be answered.
fn run<A: Send>(
    py: Python,
    count: usize,
    cost: f64,
    one: impl Fn(usize) -> A + Sync,
    many: impl Fn(Range<usize>) -> Vec<A> + Sync,
) -> PyResult<Vec<A>> {
    if count as f64 * cost < GRAIN || count == 1 {
        return Ok(py.detach(|| (0..count).map(&one).collect()));
    }
    let pool = pool()?;
    // What is too large for a count saturates.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let portion =
        (PATIENCE * pool.current_num_threads() as f64 / cost).clamp(1.0, 65536.0) as usize;
    let mut answers = Vec::with_capacity(count);
    for first in (0..count).step_by(portion) {
        let rows = first..count.min(first + portion);
        answers.append(&mut py.detach(|| pool.install(|| many(rows))));
        py.check_signals()?;
    }
    Ok(answers)
}

/// Columns as they fill.
struct Columns {
    names: Vec<&'static str>,
    error_bars: bool,
    numbers: Vec<Vec<f64>>,
    codes: Vec<u8>,
    messages: Vec<(usize, String)>,
}

impl Columns {
    fn new(si: &[&'static str], error_bars: bool) -> Self {
        let errors = ["fx_error", "fy_error", "mz_error"];
        let errors = if error_bars { &errors[..] } else { &[] };
        let names = [si, &["fx", "fy", "mz"], errors].concat();
        let numbers = vec![Vec::new(); names.len()];
        Self { names, error_bars, numbers, codes: Vec::new(), messages: Vec::new() }
    }

    fn push(&mut self, answer: Result<(Vec<f64>, Reply), RowError>) {
        let (row, code, words) = match answer {
            Ok((si, Reply { solution, cautions, .. })) => {
                let error = solution.error.filter(|_| self.error_bars);
                let forces = [Some(solution.force), error].into_iter().flatten();
                let forces = forces.flat_map(|force| force.components());
                let row: Vec<_> = si.into_iter().chain(forces).collect();
                (row, results::code(solution.status), Caution::words(&cautions))
            }
            Err(error) => (Vec::new(), INVALID, error.to_string()),
        };
        for (k, column) in self.numbers.iter_mut().enumerate() {
            column.push(row.get(k).copied().unwrap_or(f64::NAN));
        }
        if !words.is_empty() {
            self.messages.push((self.codes.len(), words));
        }
        self.codes.push(code);
    }

    fn into_dict<'py>(self, py: Python<'py>, shape: &[usize]) -> PyResult<Bound<'py, PyDict>> {
        let found = PyDict::new(py);
        for (name, column) in self.names.into_iter().zip(self.numbers) {
            found.set_item(name, column.into_pyarray(py).reshape(shape.to_vec())?)?;
        }
        found.set_item("status", self.codes.into_pyarray(py).reshape(shape.to_vec())?)?;
        found.set_item("messages", self.messages)?;
        Ok(found)
    }
}
