//! One case solved, with all that its theory can tell about it.

use std::fmt;
use std::sync::Arc;

use creepage::Ellipse;
use creepage::rolling::exact::{Exact, Workspace};
use creepage::rolling::variational::{Start, Variational};
use creepage::rolling::{Creepage, FieldPoint, Solution, Theory};

use crate::theories::prepared::{Answered, PreparedTheory};

/// A number that only one theory gives, such as the value of its functional.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Detail {
    /// Its key in `report.json`.
    pub key: &'static str,
    /// Its name in the text.
    pub label: &'static str,
    /// The number.
    pub value: f64,
}

/// One case solved, with all that its theory can tell about it. It is a [`Theory`] itself: asked
/// for the field at its own creepage, the full theory need not solve again.
pub struct Examination {
    /// Force, status and error bars.
    pub answered: Answered,
    /// Traction and slip at the theory's own points; where it has none, at the midpoints of
    /// 40 x 40 cells of the box around the ellipse, those inside it.
    pub points: Vec<FieldPoint>,
    /// Frictional power from force and creepage, over `mu N mu c V / rho`, where the theory knows
    /// of more: that of the slip by the pressure between unlike bodies.
    pub power: Option<f64>,
    /// Frictional power summed over the contact, over `mu N mu c V / rho`.
    pub dissipation: Option<f64>,
    /// The theory's own figures.
    pub details: Vec<Detail>,
    creepage: Creepage,
    theory: Arc<PreparedTheory>,
    /// The full theory's solution.
    at_hand: Option<(Exact, Workspace)>,
}

impl Examination {
    /// Solves one case by a theory that was prepared for its ellipse, in any unit of length.
    #[must_use]
    pub fn new(theory: Arc<PreparedTheory>, ellipse: Ellipse, creepage: Creepage) -> Self {
        match &*theory {
            PreparedTheory::Exact(exact) => {
                let exact = (**exact).clone();
                Self::of_exact(theory, exact, creepage)
            }
            PreparedTheory::Automatic(automatic) => {
                let level = automatic.level(creepage).0.clone();
                Self::of_exact(theory, level, creepage)
            }
            PreparedTheory::Variational(variational) => {
                of_variational(&theory, variational, creepage)
            }
            _ => of_any(theory, ellipse, creepage),
        }
    }

    /// The full theory: its elements, and how far its force may be off.
    pub(crate) fn of_exact(theory: Arc<PreparedTheory>, exact: Exact, creepage: Creepage) -> Self {
        let mut workspace = exact.workspace();
        let found = exact.solve_with(creepage, &mut workspace);
        let fields = exact.element_fields(&workspace);
        let mut details = vec![
            Detail { key: "fx_error", label: "error bar of f_x", value: found.error.fx },
            Detail { key: "fy_error", label: "error bar of f_y", value: found.error.fy },
            Detail { key: "mz_error", label: "error bar of m_z", value: found.error.mz },
            Detail { key: "elements", label: "elements", value: fields.len() as f64 },
        ];
        let value = exact.kappa_over_mu();
        if value != 0.0 {
            let label = "unlike bodies, kappa/mu";
            details.push(Detail { key: "kappa_over_mu", label, value });
        }
        Self {
            answered: found.into(),
            points: fields.iter().map(|element| element.point).collect(),
            power: Some(found.power),
            dissipation: Some(found.dissipation),
            details,
            creepage,
            theory,
            at_hand: Some((exact, workspace)),
        }
    }

    /// The creepage that was given or found.
    #[must_use]
    pub fn creepage(&self) -> Creepage {
        self.creepage
    }
}

/// The theory of chapter 5: the points of its integral, and how good the minimum is.
fn of_variational(
    theory: &Arc<PreparedTheory>,
    variational: &Variational,
    creepage: Creepage,
) -> Examination {
    let found = variational.solve_from(creepage, &Start::FullSliding);
    let details = vec![
        Detail { key: "iterations", label: "iterations", value: found.iterations as f64 },
        Detail { key: "mean_integrand", label: "mean of W T S", value: found.mean_integrand },
        Detail { key: "residual", label: "residual", value: found.residual },
        Detail { key: "aberrations", label: "aberrant points", value: found.aberrations as f64 },
    ];
    Examination {
        answered: found.solution.into(),
        points: found.points.iter().map(|point| point.field).collect(),
        power: None,
        dissipation: None,
        details,
        creepage,
        theory: Arc::clone(theory),
        at_hand: None,
    }
}

/// A theory without a mesh of its own: the field at the points of ours.
fn of_any(theory: Arc<PreparedTheory>, ellipse: Ellipse, creepage: Creepage) -> Examination {
    Examination {
        answered: theory.answer(creepage),
        points: theory.field(creepage, &usual_mesh(ellipse)),
        power: None,
        dissipation: None,
        details: Vec::new(),
        creepage,
        theory,
        at_hand: None,
    }
}

/// Midpoints of 40 x 40 cells of the box around the ellipse, those inside it, in units of `c`:
/// line by line from `-y`, each from `-x`.
fn usual_mesh(ellipse: Ellipse) -> Vec<[f64; 2]> {
    const CELLS: u8 = 40;
    let [a, b] = [ellipse.a() / ellipse.c(), ellipse.b() / ellipse.c()];
    let places = (0..CELLS).map(|i| (2.0 * f64::from(i) + 1.0) / f64::from(CELLS) - 1.0);
    let pairs = places.clone().flat_map(|y| places.clone().map(move |x| (x, y)));
    pairs.filter(|(x, y)| x.hypot(*y) < 1.0).map(|(x, y)| [a * x, b * y]).collect()
}

impl Theory for Examination {
    fn solve(&self, creepage: Creepage) -> Solution {
        if creepage == self.creepage { self.answered.solution } else { self.theory.solve(creepage) }
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        match &self.at_hand {
            Some((exact, workspace)) if creepage == self.creepage => {
                exact.field_of(workspace, positions)
            }
            _ => self.theory.field(creepage, positions),
        }
    }
}

impl fmt::Debug for Examination {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Examination")
            .field("creepage", &self.creepage)
            .field("answered", &self.answered)
            .field("power", &self.power)
            .field("dissipation", &self.dissipation)
            .field("details", &self.details)
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use creepage::rolling::exact::Resolution;

    #[test]
    fn a_solution_at_hand_has_the_field_that_solving_gives() {
        let exact = Exact::new(1.5, 0.28, Resolution::FAST).unwrap();
        let creepage = Creepage { xi: 0.5, eta: -0.3, chi: 0.8 };
        let theory = Arc::new(PreparedTheory::Exact(Box::new(exact.clone())));
        let found = Examination::new(theory, Ellipse::from_ratio(1.5).unwrap(), creepage);
        let places = [[0.1, 0.2], [-0.7, 0.1], [0.0, -0.6], [2.0, 0.0]];
        assert_eq!(found.field(creepage, &places), exact.field(creepage, &places));
        let other = Creepage { xi: 2.0, ..creepage };
        assert_eq!(found.field(other, &places), exact.field(other, &places));
        assert_eq!(found.solve(creepage), exact.solve(creepage));
    }

    #[test]
    fn the_usual_mesh_lies_in_the_ellipse_of_any_size() {
        let mesh = usual_mesh(Ellipse::new(9e-3, 4e-3).unwrap());
        // pi/4 of 1600 cells; those on the edge fall to one side or the other.
        assert!((mesh.len() as f64 - 1256.6).abs() < 20.0, "{}", mesh.len());
        assert!(mesh.iter().all(|[x, y]| (x / 1.5).hypot(y * 1.5) < 1.0));
    }
}
