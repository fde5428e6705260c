//! A theory prepared for one contact, and what it can be asked beyond its force and field.

use creepage::rolling::exact::{Automatic, Exact, Found, InverseError, Known, Workspace};
use creepage::rolling::variational::{Start, Variational};
use creepage::rolling::{Creepage, FieldPoint, Force, Solution, Theory};
use creepage::{Ellipse, InvalidValue};
use creepage_report::Detail;

/// A theory prepared for one contact; those by name that can do more than any [`Theory`].
pub(crate) enum PreparedTheory {
    Exact(Box<Exact>),
    Automatic(Box<Automatic>),
    Variational(Box<Variational>),
    Other(Box<dyn Theory>),
}

/// A force, and how far it may be off where the theory knows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Answered {
    pub(crate) solution: Solution,
    pub(crate) error: Option<Force>,
}

/// One case solved, with all that the theory can tell about it.
pub(crate) struct Examination {
    pub(crate) theory: Box<dyn Theory>,
    pub(crate) answered: Answered,
    /// Traction and slip at the points of a mesh.
    pub(crate) points: Vec<FieldPoint>,
    /// Frictional power summed over the contact, over `mu N mu c V / rho`.
    pub(crate) dissipation: Option<f64>,
    /// The theory's own figures.
    pub(crate) details: Vec<Detail>,
}

/// Why no creepage was found for wanted forces.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum FindError {
    #[error("[wanted] needs the theory exact: {0} does not find creepages")]
    Theory(&'static str),
    #[error(transparent)]
    Inverse(#[from] InverseError),
}

impl PreparedTheory {
    /// Any theory that can do no more than all can.
    pub(super) fn other(theory: impl Theory + 'static) -> Self {
        Self::Other(Box::new(theory))
    }

    /// Force, status and error bars.
    pub(crate) fn answer(&self, creepage: Creepage) -> Answered {
        let found = match self {
            Self::Exact(theory) => theory.solve_with(creepage, &mut theory.workspace()),
            Self::Automatic(theory) => theory.solve_to_accuracy(creepage),
            Self::Variational(theory) => return plain(theory.solve(creepage)),
            Self::Other(theory) => return plain(theory.solve(creepage)),
        };
        let solution = Solution { force: found.force, status: found.status };
        Answered { solution, error: Some(found.error) }
    }

    /// Solves one case with all that the theory can tell about it.
    pub(crate) fn examine(
        self,
        ellipse: Ellipse,
        creepage: Creepage,
    ) -> Result<Examination, InvalidValue> {
        match self {
            Self::Exact(theory) => Ok(examine_exact(*theory, creepage)),
            Self::Automatic(theory) => {
                Ok(examine_exact(theory.level(creepage).0.clone(), creepage))
            }
            Self::Variational(theory) => Ok(examine_variational(*theory, creepage)),
            Self::Other(theory) => examine_any(theory, ellipse, creepage),
        }
    }

    /// The creepage at which the known quantities hold, and all about it.
    pub(crate) fn find(
        self,
        name: &'static str,
        known: Known,
    ) -> Result<(Found, Examination), FindError> {
        let (theory, found) = match self {
            Self::Exact(theory) => {
                let found = theory.find(known, &mut theory.workspace())?;
                (*theory, found)
            }
            Self::Automatic(theory) => {
                let (level, found) = theory.find(known)?;
                (level.clone(), found)
            }
            Self::Variational(_) | Self::Other(_) => return Err(FindError::Theory(name)),
        };
        Ok((found, examine_exact(theory, found.creepage)))
    }

    fn theory(&self) -> &dyn Theory {
        match self {
            Self::Exact(theory) => &**theory,
            Self::Automatic(theory) => &**theory,
            Self::Variational(theory) => &**theory,
            Self::Other(theory) => &**theory,
        }
    }
}

impl Theory for PreparedTheory {
    fn solve(&self, creepage: Creepage) -> Solution {
        self.theory().solve(creepage)
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.theory().field(creepage, positions)
    }
}

fn plain(solution: Solution) -> Answered {
    Answered { solution, error: None }
}

/// The full theory with one solution at hand: asked for its field, it need not solve again.
struct Solved {
    theory: Exact,
    creepage: Creepage,
    workspace: Workspace,
}

impl Theory for Solved {
    fn solve(&self, creepage: Creepage) -> Solution {
        self.theory.solve(creepage)
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        if creepage == self.creepage {
            self.theory.field_of(&self.workspace, positions)
        } else {
            self.theory.field(creepage, positions)
        }
    }
}

/// The full theory: its elements, and how far its force may be off.
fn examine_exact(theory: Exact, creepage: Creepage) -> Examination {
    let mut workspace = theory.workspace();
    let found = theory.solve_with(creepage, &mut workspace);
    let fields = theory.element_fields(&workspace);
    let details = vec![
        Detail { key: "fx_error", label: "error bar of f_x", value: found.error.fx },
        Detail { key: "fy_error", label: "error bar of f_y", value: found.error.fy },
        Detail { key: "mz_error", label: "error bar of m_z", value: found.error.mz },
        Detail { key: "elements", label: "elements", value: fields.len() as f64 },
    ];
    let solution = Solution { force: found.force, status: found.status };
    Examination {
        theory: Box::new(Solved { theory, creepage, workspace }),
        answered: Answered { solution, error: Some(found.error) },
        points: fields.iter().map(|element| element.point).collect(),
        dissipation: Some(found.dissipation),
        details,
    }
}

/// The theory of chapter 5: the points of its integral, and how good the minimum is.
fn examine_variational(theory: Variational, creepage: Creepage) -> Examination {
    let found = theory.solve_from(creepage, &Start::FullSliding);
    let details = vec![
        Detail { key: "iterations", label: "iterations", value: found.iterations as f64 },
        Detail { key: "mean_integrand", label: "mean of W T S", value: found.mean_integrand },
        Detail { key: "residual", label: "residual", value: found.residual },
        Detail { key: "aberrations", label: "aberrant points", value: found.aberrations as f64 },
    ];
    Examination {
        theory: Box::new(theory),
        answered: plain(found.solution),
        points: found.points.iter().map(|point| point.field).collect(),
        dissipation: None,
        details,
    }
}

/// A theory without a mesh of its own: the field at the points of ours.
fn examine_any(
    theory: Box<dyn Theory>,
    ellipse: Ellipse,
    creepage: Creepage,
) -> Result<Examination, InvalidValue> {
    let answered = plain(theory.solve(creepage));
    let points = theory.field(creepage, &usual_mesh(Ellipse::from_ratio(ellipse.ratio())?));
    Ok(Examination { theory, answered, points, dissipation: None, details: Vec::new() })
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

#[cfg(test)]
mod tests {
    use super::*;
    use creepage::rolling::exact::Resolution;

    #[test]
    fn a_solution_at_hand_has_the_field_that_solving_gives() {
        let theory = Exact::new(1.5, 0.28, Resolution::FAST).unwrap();
        let creepage = Creepage { xi: 0.5, eta: -0.3, chi: 0.8 };
        let solved = examine_exact(theory.clone(), creepage);
        let places = [[0.1, 0.2], [-0.7, 0.1], [0.0, -0.6], [2.0, 0.0]];
        assert_eq!(solved.theory.field(creepage, &places), theory.field(creepage, &places));
        let other = Creepage { xi: 2.0, ..creepage };
        assert_eq!(solved.theory.field(other, &places), theory.field(other, &places));
    }
}
