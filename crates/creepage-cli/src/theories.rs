//! The theories that the command knows by name. A new theory is a new entry.

use std::fmt::Write;

use creepage::rolling::variational::{Settings, Start, Variational, VariationalError};
use creepage::rolling::{Creepage, FieldPoint, Solution, Theory};
use creepage_case::Solve;
use creepage_report::Detail;

/// One theory: its name, what a user should know of it, and how to run it.
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    /// Year of publication.
    pub(crate) year: u16,
    pub(crate) assumes: &'static str,
    pub(crate) good_for: &'static str,
    /// Prepares the theory for `a/b` and the combined Poisson's ratio.
    pub(crate) prepare: Prepare,
    /// Solves one case with all that the theory can tell about it.
    pub(crate) examine: Examine,
}

type Prepare = fn(a_over_b: f64, poisson: f64, &Solve) -> Result<Box<dyn Theory>, TheoryError>;
type Examine =
    fn(a_over_b: f64, poisson: f64, &Solve, Creepage) -> Result<Examination, TheoryError>;

/// One case solved, with all that the theory can tell about it.
pub(crate) struct Examination {
    pub(crate) theory: Box<dyn Theory>,
    pub(crate) solution: Solution,
    /// Traction and slip where the theory computes them.
    pub(crate) points: Vec<FieldPoint>,
    /// The theory's own figures.
    pub(crate) details: Vec<Detail>,
}

/// Why a theory cannot be prepared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum TheoryError {
    #[error(transparent)]
    Variational(#[from] VariationalError),
}

/// A name that no theory has.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("unknown theory `{name}`: {hint}")]
pub(crate) struct UnknownTheory {
    name: String,
    hint: String,
}

/// The theory of a case that names none.
pub(crate) const DEFAULT: &str = "variational";

const ENTRIES: &[Entry] = &[Entry {
    name: "variational",
    year: 1967,
    assumes: "elastic half-spaces, polynomial tractions, friction met in the mean",
    good_for: "any creepage and spin but the smallest; forces to 2-10 %",
    prepare: |a_over_b, poisson, solve| {
        Ok(Box::new(Variational::new(a_over_b, poisson, variational_settings(solve))?))
    },
    examine: examine_variational,
}];

fn variational_settings(solve: &Solve) -> Settings {
    let default = Settings::default();
    let usual = solve.degree.map_or(default, Settings::of_degree);
    Settings {
        mesh: solve.mesh.unwrap_or(usual.mesh),
        weight: solve.weight.map_or(usual.weight, Into::into),
        ..usual
    }
}

fn examine_variational(
    a_over_b: f64,
    poisson: f64,
    solve: &Solve,
    creepage: Creepage,
) -> Result<Examination, TheoryError> {
    let theory = Variational::new(a_over_b, poisson, variational_settings(solve))?;
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

/// The theory of that name.
pub(crate) fn find(name: &str) -> Result<&'static Entry, UnknownTheory> {
    ENTRIES.iter().find(|entry| entry.name == name).ok_or_else(|| {
        let likeness = |entry: &&Entry| strsim::jaro_winkler(name, entry.name);
        let nearest = ENTRIES.iter().max_by(|one, two| likeness(one).total_cmp(&likeness(two)));
        let hint = match nearest {
            Some(entry) if likeness(&entry) > 0.8 => format!("did you mean `{}`?", entry.name),
            _ => "`creepage theories` lists them".into(),
        };
        UnknownTheory { name: name.into(), hint }
    })
}

/// The theories as a table for a person.
pub(crate) fn table() -> String {
    let width = |text: fn(&Entry) -> &str, head: &str| {
        ENTRIES.iter().map(|entry| text(entry).len()).max().unwrap_or(0).max(head.len())
    };
    let name = width(|entry| entry.name, "THEORY");
    let assumes = width(|entry| entry.assumes, "ASSUMES");
    let mut table = format!("{:name$}  YEAR  {:assumes$}  GOOD FOR\n", "THEORY", "ASSUMES");
    for entry in ENTRIES {
        // Writing to a string cannot fail.
        let _ = writeln!(
            table,
            "{:name$}  {:4}  {:assumes$}  {}",
            entry.name, entry.year, entry.assumes, entry.good_for
        );
    }
    table
}
