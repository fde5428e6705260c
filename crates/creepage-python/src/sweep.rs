//! Python class of sweeps: series of cases of the numerical theory, chain by chain.

use std::ops::Range;

use creepage::variational::{Chain, Variational};
use creepage_study::{SeriesHead, SeriesRow, Sweep, series_csv};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use rayon::prelude::*;

use crate::errors;
use crate::pool::pool;

/// Chains in hand, a thread, and cases of each between two looks at Python's signals.
const CHAINS: usize = 4;
const CASES: usize = 64;

/// The text of a sweep file, read and checked.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct SweepData {
    sweep: Sweep,
    theory: Variational,
}

#[pymethods]
impl SweepData {
    #[new]
    fn new(py: Python, text: &str) -> PyResult<Self> {
        let wrong = |error| errors::case(py, error);
        let sweep = Sweep::read(text).map_err(wrong)?;
        let theory = sweep.theory().map_err(wrong)?;
        Ok(Self { sweep, theory })
    }

    /// Number of cases.
    #[getter]
    fn cases(&self) -> usize {
        self.sweep.cases()
    }

    /// Number of chains; each is solved from its first case on, by itself.
    #[getter]
    fn chains(&self) -> usize {
        self.sweep.cases() / self.sweep.chain_length()
    }

    /// What all cases share: (a/b, Poisson's ratio, degree, mesh).
    #[getter]
    fn shared(&self) -> (f64, f64, usize, [usize; 2]) {
        let head = SeriesHead::from(&self.sweep);
        (head.a_over_b, head.poisson, head.degree, head.mesh)
    }

    /// Solves `count` chains from `first` on; a table in CSV, a row a case.
    fn solve<'py>(
        &self,
        py: Python<'py>,
        first: usize,
        count: usize,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let end = first.checked_add(count).filter(|end| *end <= self.chains());
        let end = end.ok_or_else(|| PyIndexError::new_err("there are not so many chains"))?;
        let (pool, length) = (pool()?, self.sweep.chain_length());
        let group = CHAINS * pool.current_num_threads();
        let mut rows = Vec::new();
        for first in (first..end).step_by(group) {
            let chains = first..end.min(first + group);
            let mut chains: Vec<_> = chains.map(|number| (self.start(number), vec![])).collect();
            for done in (0..length).step_by(CASES) {
                let cases = done..length.min(done + CASES);
                let solve = |(chain, found): &mut (_, Vec<_>)| {
                    self.solve_cases(chain, found, cases.clone());
                };
                py.detach(|| pool.install(|| chains.par_iter_mut().for_each(solve)));
                py.check_signals()?;
            }
            rows.extend(chains.into_iter().flat_map(|(_, found)| found));
        }
        let mut table = Vec::new();
        let rows = rows.into_iter().map(Ok::<_, std::io::Error>);
        series_csv(&SeriesHead::from(&self.sweep), rows, &mut table).map_err(errors::report)?;
        Ok(PyBytes::new(py, &table))
    }
}

impl SweepData {
    /// A chain before its first case, whose number comes with it.
    fn start(&self, number: usize) -> (Chain<'_>, usize) {
        let first = number * self.sweep.chain_length();
        (self.sweep.chain(&self.theory, first), first)
    }

    /// Solves some of a chain's cases, which follow those before.
    fn solve_cases(
        &self,
        (chain, first): &mut (Chain<'_>, usize),
        found: &mut Vec<SeriesRow>,
        cases: Range<usize>,
    ) {
        for index in cases {
            let case = self.sweep.case(*first + index);
            let solved = chain.solve(case.creepage, None);
            let difference =
                self.sweep.second_start_difference(&self.theory, case.creepage, &solved.found);
            found.push(SeriesRow::new(&case, &solved, difference));
        }
    }
}
