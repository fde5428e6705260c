//! Every theory that Python can prepare.

use creepage::rolling::exact::{Automatic, Exact};
use creepage::rolling::fastrip::Fastrip;
use creepage::rolling::fastsim::Fastsim;
use creepage::rolling::linear::Linear;
use creepage::rolling::polach::Polach;
use creepage::rolling::saturated::Saturated;
use creepage::rolling::shen_hedrick_elkins::ShenHedrickElkins;
use creepage::rolling::strip::StripTheory;
use creepage::rolling::variational::{Start, Variational};
use creepage::rolling::vermeulen_johnson::VermeulenJohnson;
use creepage::rolling::{Creepage, FieldPoint, Solution, Theory};
use creepage_report::Detail;

/// A prepared theory.
pub(crate) enum Model {
    Exact(Box<Exact>),
    Automatic(Box<Automatic>),
    Variational(Box<Variational>),
    Fastrip(Box<Fastrip>),
    Fastsim(Box<Fastsim>),
    Strip(Box<StripTheory>),
    Polach(Polach),
    ShenHedrickElkins(ShenHedrickElkins),
    VermeulenJohnson(VermeulenJohnson),
    Linear(Linear),
    Saturated(Box<Saturated>),
}

/// One case with all that its theory can tell about it.
pub(crate) struct Examination {
    pub(crate) solution: Solution,
    pub(crate) points: Vec<FieldPoint>,
    pub(crate) details: Vec<Detail>,
}

impl Model {
    pub(crate) fn theory(&self) -> &dyn Theory {
        match self {
            Self::Exact(theory) => &**theory,
            Self::Automatic(theory) => &**theory,
            Self::Variational(theory) => &**theory,
            Self::Fastrip(theory) => &**theory,
            Self::Fastsim(theory) => &**theory,
            Self::Strip(theory) => &**theory,
            Self::Polach(theory) => theory,
            Self::ShenHedrickElkins(theory) => theory,
            Self::VermeulenJohnson(theory) => theory,
            Self::Linear(theory) => theory,
            Self::Saturated(theory) => &**theory,
        }
    }

    /// Rows `fx`, `fy`, `mz`; columns `xi`, `eta`, `chi`. `None` where a theory has none.
    pub(crate) fn derivative(&self, creepage: Creepage) -> Option<[[f64; 3]; 3]> {
        Some(match self {
            Self::Exact(theory) => {
                let mut workspace = theory.workspace();
                theory.solve_with(creepage, &mut workspace);
                theory.derivative(&mut workspace)
            }
            Self::Automatic(_) | Self::Variational(_) => return None,
            Self::Fastrip(theory) => theory.derivative(creepage),
            Self::Fastsim(theory) => theory.derivative(creepage),
            Self::Strip(theory) => theory.derivative(creepage),
            Self::Polach(theory) => theory.derivative(creepage),
            Self::ShenHedrickElkins(theory) => theory.derivative(creepage),
            Self::VermeulenJohnson(theory) => theory.derivative(creepage),
            Self::Linear(theory) => theory.derivative(creepage),
            Self::Saturated(theory) => theory.derivative(creepage),
        })
    }

    /// Solves one case; the field is that of the theory's own mesh where it has one, else at
    /// `mesh`.
    pub(crate) fn examine(&self, creepage: Creepage, mesh: &[[f64; 2]]) -> Examination {
        match self {
            Self::Exact(theory) => examine_exact(theory, creepage),
            Self::Variational(theory) => examine_variational(theory, creepage),
            _ => {
                let theory = self.theory();
                let (solution, points) = (theory.solve(creepage), theory.field(creepage, mesh));
                Examination { solution, points, details: Vec::new() }
            }
        }
    }
}

fn examine_exact(theory: &Exact, creepage: Creepage) -> Examination {
    let mut workspace = theory.workspace();
    let found = theory.solve_with(creepage, &mut workspace);
    let fields = theory.element_fields(&workspace);
    let details = vec![
        Detail { key: "fx_error", label: "error bar of f_x", value: found.error.fx },
        Detail { key: "fy_error", label: "error bar of f_y", value: found.error.fy },
        Detail { key: "mz_error", label: "error bar of m_z", value: found.error.mz },
        Detail { key: "elements", label: "elements", value: fields.len() as f64 },
    ];
    Examination {
        solution: Solution { force: found.force, status: found.status },
        points: fields.iter().map(|element| element.point).collect(),
        details,
    }
}

fn examine_variational(theory: &Variational, creepage: Creepage) -> Examination {
    let found = theory.solve_from(creepage, &Start::FullSliding);
    let details = vec![
        Detail { key: "iterations", label: "iterations", value: found.iterations as f64 },
        Detail { key: "mean_integrand", label: "mean of W T S", value: found.mean_integrand },
        Detail { key: "residual", label: "residual", value: found.residual },
        Detail { key: "aberrations", label: "aberrant points", value: found.aberrations as f64 },
    ];
    Examination {
        solution: found.solution,
        points: found.points.iter().map(|point| point.field).collect(),
        details,
    }
}
