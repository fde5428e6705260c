//! Model of a fit: forces of a theory at the measured points, for any coefficient of friction.

use std::path::Path;
use std::sync::Arc;

use creepage::normal::NormalContact;
use creepage::{Contact, Creepage, Layer, SiCreepage, Solution, Status, TheorySpec};
use rayon::prelude::*;

use super::fitted::FitError;
use super::points::MeasuredPoints;
use crate::{AnyCase, AnyCaseFile, BulkCase, BulkQuery, CaseError, Solver, Varied};

/// A force by the theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Predicted {
    /// Longitudinal and lateral (N).
    pub(super) force: [f64; 2],
    /// The tangential force over `mu N`.
    pub(super) share: f64,
    pub(super) status: Status,
}

/// The contacts of the points, at a coefficient of friction to be found.
pub(super) struct Model {
    spec: TheorySpec,
    contacts: Contacts,
    /// Creepages of the points: what the table does not have is the case's.
    pub(super) creepages: Vec<SiCreepage>,
    /// Normal forces of the points (N).
    pub(super) loads: Vec<f64>,
    /// The case as it is given.
    contact: Contact,
    rows: Vec<usize>,
}

enum Contacts {
    /// Hertz's ellipses, whose size follows the load of each point.
    Ellipses { bulk: Box<BulkCase>, solver: Solver },
    /// Areas of any shape, pressed once.
    Areas { areas: Arc<NormalContact>, layer: Option<Layer> },
}

const VARIED: [Varied; 5] =
    [Varied::Longitudinal, Varied::Lateral, Varied::Spin, Varied::NormalForce, Varied::Friction];

impl Model {
    pub(super) fn new(
        file: &AnyCaseFile,
        directory: &Path,
        spec: &TheorySpec,
        measured: &MeasuredPoints,
    ) -> Result<Self, FitError> {
        let case = file.case(directory).map_err(|error| FitError::Case(Box::new(error)))?;
        let wrong = |error| FitError::Case(Box::new(error));
        case.lies_in_a_plane("fits").map_err(wrong)?;
        let contact = case.contact().map_err(wrong)?;
        if contact.added_slip().is_some() {
            return Err(wrong(CaseError::SlipOfRows.into()));
        }
        if contact.rolling_friction().is_some() {
            return Err(FitError::FrictionLaw);
        }
        let scaling = contact.scaling();
        let own =
            case.creepage(&contact).map_err(|error| FitError::Case(Box::new(error.into())))?;
        let own = scaling.si_creepage(own);
        let normal = scaling.force / case.friction();
        let creepages = measured.points.iter().map(|point| {
            let [longitudinal, lateral, spin] = point.creepage;
            SiCreepage {
                longitudinal: longitudinal.unwrap_or(own.longitudinal),
                lateral: lateral.unwrap_or(own.lateral),
                spin: spin.unwrap_or(own.spin),
            }
        });
        let creepages = creepages.collect();
        let contacts = match (file, contact.areas()) {
            (AnyCaseFile::Ellipse(file), _) => {
                let bulk = BulkCase::new(file, VARIED.to_vec());
                let wrong = |error: CaseError| FitError::Case(Box::new(error.into()));
                let solver = Solver::new(spec.clone());
                Contacts::Ellipses { bulk: Box::new(bulk.map_err(wrong)?), solver }
            }
            (AnyCaseFile::Gap(_), Some(areas)) => {
                if measured.points.iter().any(|point| point.normal_force.is_some()) {
                    return Err(FitError::LoadOfAreas);
                }
                Contacts::Areas { areas: Arc::clone(areas), layer: layer_of(&case) }
            }
            (AnyCaseFile::Gap(_), None) => return Err(FitError::LoadOfAreas),
        };
        let loads = measured.points.iter().map(|point| point.normal_force.unwrap_or(normal));
        let loads = loads.collect();
        let rows = measured.points.iter().map(|point| point.row).collect();
        Ok(Self { spec: spec.clone(), contacts, creepages, loads, contact, rows })
    }

    /// The forces at the points: friction `mu`, and creepages `slope` times as large.
    pub(super) fn forces(&self, mu: f64, slope: f64) -> Result<Vec<Predicted>, FitError> {
        let creepages: Vec<_> = self.creepages.iter().copied().zip(self.loads.clone()).collect();
        self.at(mu, slope, &creepages)
    }

    /// The same at any creepages, each with its normal force.
    pub(super) fn at(
        &self,
        mu: f64,
        slope: f64,
        asked: &[(SiCreepage, f64)],
    ) -> Result<Vec<Predicted>, FitError> {
        let in_row = |k: usize| {
            let row = self.rows.get(k).copied().unwrap_or(0);
            move |source| FitError::Row { row, source }
        };
        match &self.contacts {
            Contacts::Ellipses { bulk, solver } => {
                let query = |(si, load): &(SiCreepage, f64)| {
                    let row = bulk.row(&[si.longitudinal, si.lateral, si.spin, *load, mu])?;
                    let query = row.query();
                    let creepage = scaled(query.creepage, slope)?;
                    Ok(BulkQuery { creepage, ..query })
                };
                let queries: Vec<_> = asked.iter().map(query).collect();
                let contacts: Vec<_> = queries
                    .iter()
                    .map(|one| one.as_ref().ok().map(|q| q.contact.clone()))
                    .collect();
                let replies = solver.solve::<crate::RowError>(queries);
                replies
                    .into_iter()
                    .zip(contacts)
                    .enumerate()
                    .map(|(k, (reply, contact))| {
                        let solution = reply.map_err(in_row(k))?.solution;
                        Ok(predicted(contact.as_ref().unwrap_or(&self.contact), &solution))
                    })
                    .collect()
            }
            Contacts::Areas { areas, layer } => {
                let contact = Contact::of_areas(Arc::clone(areas), mu)?;
                let contact = match layer {
                    Some(layer) => contact.with_layer(*layer),
                    None => contact,
                };
                let theory = self.spec.prepare(&contact).map_err(FitError::Theory)?;
                asked
                    .par_iter()
                    .enumerate()
                    .map(|(k, (si, _))| {
                        let creepage = contact.scaling().creepage(*si);
                        let creepage = creepage.and_then(|creepage| scaled(creepage, slope));
                        let creepage = creepage.map_err(|error| in_row(k)(error.into()))?;
                        Ok(predicted(&contact, &theory.solve(creepage)))
                    })
                    .collect()
            }
        }
    }
}

/// A layer between areas is in units of the contact at the case's own friction, which none of its
/// numbers depends on.
fn layer_of(case: &AnyCase) -> Option<Layer> {
    match case {
        AnyCase::Gap(case) => case.layer,
        AnyCase::Ellipse(_) => None,
    }
}

fn scaled(creepage: Creepage, by: f64) -> Result<Creepage, creepage::InvalidValue> {
    let [xi, eta, chi] = creepage.components();
    Creepage::new(by * xi, by * eta, by * chi)
}

fn predicted(contact: &Contact, solution: &Solution) -> Predicted {
    let si = contact.scaling().si_force(solution.force);
    let force = [si.longitudinal, si.lateral];
    Predicted { force, share: solution.force.magnitude(), status: solution.status }
}
