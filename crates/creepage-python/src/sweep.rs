//! Sweeps: series of cases of the numerical theory, chain by chain.

use creepage::rolling::Region;
use creepage::rolling::variational::{Chain, ChainCase, Variational};
use creepage_case::{Sweep, SweepCase};
use creepage_report::{SeriesHead, SeriesRow, series_csv};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use rayon::prelude::*;

use crate::errors;
use crate::pool::pool;

/// Chains solved between two looks at Python's signals, a thread.
const CHAINS: usize = 4;

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
        let head = self.head();
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
        let pool = pool()?;
        let group = CHAINS * pool.current_num_threads();
        let mut rows = Vec::new();
        for first in (first..end).step_by(group) {
            let chains = first..end.min(first + group);
            let solve = || chains.into_par_iter().map(|chain| self.chain(chain)).collect();
            let some: Vec<Vec<SeriesRow>> = py.detach(|| pool.install(solve));
            rows.extend(some.into_iter().flatten());
            py.check_signals()?;
        }
        let mut table = Vec::new();
        let rows = rows.into_iter().map(Ok::<_, std::io::Error>);
        series_csv(&self.head(), rows, &mut table).map_err(errors::report)?;
        Ok(PyBytes::new(py, &table))
    }
}

impl SweepData {
    fn head(&self) -> SeriesHead {
        SeriesHead {
            a_over_b: self.sweep.a_over_b,
            poisson: self.sweep.poisson,
            degree: self.sweep.settings.degree,
            mesh: self.sweep.settings.mesh,
            cases: self.sweep.cases(),
        }
    }

    fn chain(&self, number: usize) -> Vec<SeriesRow> {
        let (sweep, length) = (&self.sweep, self.sweep.chain_length());
        let first = number * length;
        let given = sweep.starting_values.as_ref();
        let tau = given.and_then(|polynomials| self.theory.unknowns_of(polynomials).ok());
        let creepage = sweep.case(first).creepage;
        let mut chain = match tau {
            Some(tau) => Chain::from(&self.theory, sweep.procedure, creepage, tau),
            None => Chain::new(&self.theory, sweep.procedure),
        };
        (first..first + length)
            .map(|index| {
                let case = sweep.case(index);
                let solved = chain.solve(case.creepage, None);
                self.row(&case, &solved)
            })
            .collect()
    }

    fn row(&self, case: &SweepCase, solved: &ChainCase) -> SeriesRow {
        let found = &solved.found;
        let adhering =
            found.points.iter().filter(|point| point.field.region == Region::Adhesion).count();
        let second = self
            .sweep
            .second_start
            .map_or(f64::NAN, |second| self.theory.check_by(case.creepage, found, &second.start()));
        SeriesRow {
            alpha: case.alpha,
            upsilon: case.upsilon,
            creepage: case.creepage,
            force: found.solution.force,
            status: found.solution.status,
            iterations: found.iterations,
            steps_from_previous: solved.steps_from_previous,
            mean_integrand: found.mean_integrand,
            residual: found.residual,
            aberrations: found.aberrations,
            adhesion_share: adhering as f64 / found.points.len() as f64,
            second_start_difference: second,
        }
    }
}
