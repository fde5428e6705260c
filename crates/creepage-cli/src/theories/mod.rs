//! The theories that the command knows by name. A new theory is a new entry of [`registry`].

mod choice;
mod prepare;
mod registry;
mod table;

use creepage::rolling::variational::{Start, Variational, VariationalError};
use creepage::rolling::{Creepage, FieldPoint, Solution, Theory};
use creepage::{Ellipse, InvalidValue};
use creepage_case::Solve;
use creepage_report::Detail;

pub(crate) use choice::{ChoiceError, UnknownTheory, choose, find};
pub(crate) use registry::ENTRIES;
pub(crate) use table::table;

/// One theory: its name, what a user should know of it, and how to run it.
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    /// Year of publication.
    pub(crate) year: u16,
    pub(crate) assumes: &'static str,
    /// One force on one core, by the library's benchmarks.
    pub(crate) cost: &'static str,
    /// Root mean square error of the force in per cent of `mu N`, by `creepage accuracy`.
    pub(crate) error: f64,
    pub(crate) good_for: &'static str,
    /// The options in `[solve]` that it knows.
    pub(crate) options: &'static [&'static str],
    /// Prepares the theory for `a/b` and the combined Poisson's ratio.
    pub(crate) prepare: Prepare,
    /// Solves one case with all that the theory can tell about it.
    examine: Examine,
}

pub(crate) type Prepared = Result<Box<dyn Theory>, TheoryError>;
pub(crate) type Prepare = fn(a_over_b: f64, poisson: f64, &Solve) -> Prepared;
type Examine =
    fn(Prepare, a_over_b: f64, poisson: f64, &Solve, Creepage) -> Result<Examination, TheoryError>;

/// One case solved, with all that the theory can tell about it.
pub(crate) struct Examination {
    pub(crate) theory: Box<dyn Theory>,
    pub(crate) solution: Solution,
    /// Traction and slip at the points of a mesh.
    pub(crate) points: Vec<FieldPoint>,
    /// The theory's own figures.
    pub(crate) details: Vec<Detail>,
}

/// Why a theory cannot be prepared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum TheoryError {
    #[error(transparent)]
    Variational(#[from] VariationalError),
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
}

impl Entry {
    /// Solves one case with all that the theory can tell about it.
    pub(crate) fn examine(
        &self,
        a_over_b: f64,
        poisson: f64,
        solve: &Solve,
        creepage: Creepage,
    ) -> Result<Examination, TheoryError> {
        (self.examine)(self.prepare, a_over_b, poisson, solve, creepage)
    }
}

/// A theory without a mesh of its own: the field at the points of ours.
fn examine_any(
    prepare: Prepare,
    a_over_b: f64,
    poisson: f64,
    solve: &Solve,
    creepage: Creepage,
) -> Result<Examination, TheoryError> {
    let theory = prepare(a_over_b, poisson, solve)?;
    let solution = theory.solve(creepage);
    let points = theory.field(creepage, &usual_mesh(Ellipse::from_ratio(a_over_b)?));
    Ok(Examination { theory, solution, points, details: Vec::new() })
}

/// Midpoints of 40 x 40 cells of the box around the ellipse, those inside it, in units of `c`:
/// line by line from `-y`, each from `-x`.
fn usual_mesh(ellipse: Ellipse) -> Vec<[f64; 2]> {
    const CELLS: u8 = 40;
    let places = (0..CELLS).map(|i| (2.0 * f64::from(i) + 1.0) / f64::from(CELLS) - 1.0);
    let pairs = places.clone().flat_map(|y| places.clone().map(move |x| (x, y)));
    pairs
        .filter(|(x, y)| x.hypot(*y) < 1.0)
        .map(|(x, y)| [ellipse.a() * x, ellipse.b() * y])
        .collect()
}

/// The full theory: its elements, and how far its force may be off.
fn examine_exact(
    _: Prepare,
    a_over_b: f64,
    poisson: f64,
    solve: &Solve,
    creepage: Creepage,
) -> Result<Examination, TheoryError> {
    let theory = prepare::exact_theory(a_over_b, poisson, solve)?;
    let mut workspace = theory.workspace();
    let found = theory.solve_with(creepage, &mut workspace);
    let fields = theory.element_fields(&workspace);
    let details = vec![
        Detail { key: "fx_error", label: "error bar of f_x", value: found.error.fx },
        Detail { key: "fy_error", label: "error bar of f_y", value: found.error.fy },
        Detail { key: "mz_error", label: "error bar of m_z", value: found.error.mz },
        Detail { key: "elements", label: "elements", value: fields.len() as f64 },
    ];
    Ok(Examination {
        theory: Box::new(theory),
        solution: Solution { force: found.force, status: found.status },
        points: fields.iter().map(|element| element.point).collect(),
        details,
    })
}

/// The theory of chapter 5: the points of its integral, and how good the minimum is.
fn examine_variational(
    _: Prepare,
    a_over_b: f64,
    poisson: f64,
    solve: &Solve,
    creepage: Creepage,
) -> Result<Examination, TheoryError> {
    let theory = Variational::new(a_over_b, poisson, prepare::variational_settings(solve))?;
    let found = theory.solve_from(creepage, &Start::FullSliding);
    let details = vec![
        Detail { key: "iterations", label: "iterations", value: found.iterations as f64 },
        Detail { key: "mean_integrand", label: "mean of W T S", value: found.mean_integrand },
        Detail { key: "residual", label: "residual", value: found.residual },
        Detail { key: "aberrations", label: "aberrant points", value: found.aberrations as f64 },
    ];
    Ok(Examination {
        theory: Box::new(theory),
        solution: found.solution,
        points: found.points.iter().map(|point| point.field).collect(),
        details,
    })
}
