//! Transient step of the numerical theory: displacements that change (4.15b).

use nalgebra::DVector;

use super::discretization::{Change, Displacements};
use super::functional::ElasticPower;
use super::{
    MeshPoint, Settings, TractionBound, Variational, VariationalError, VariationalSolution,
};
use crate::contact::Contact;
use crate::theory::Region;

/// The theory with displacements at its mesh points.
#[derive(Debug, Clone)]
pub(crate) struct Changing {
    steady: Variational,
    displacements: Displacements,
}

/// Force and power of a step's solution.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Rubbing {
    /// Share of the mesh points that adhere.
    pub(crate) adhesion_share: f64,
    /// Power of friction over `mu N mu c V / rho`.
    pub(crate) dissipation: f64,
}

impl Changing {
    /// The bound is kept unless it is to be looked at afterwards only: a contact that sticks all over
    /// makes `T S` zero however large its tractions, and from rest polynomials can do so.
    pub(crate) fn new(contact: &Contact, settings: Settings) -> Result<Self, VariationalError> {
        let bound = match settings.bound {
            TractionBound::Automatic => TractionBound::Kept,
            given => given,
        };
        let steady = Variational::new(contact, Settings { bound, ..settings })?;
        let displacements = steady.response.displacements(contact.poisson(), steady.mesh())?;
        Ok(Self { steady, displacements })
    }

    /// Where nothing changes.
    pub(crate) fn steady(&self) -> &Variational {
        &self.steady
    }

    /// In a step.
    pub(crate) fn in_step(&self, change: &Change) -> Variational {
        let (mesh, energy) =
            (self.steady.mesh.changing(&self.displacements, change), self.displacements.energy());
        let elastic = ElasticPower {
            present: 2.0 * change.present * energy,
            past: energy * DVector::from_column_slice(change.past),
        };
        Variational { mesh, elastic: Some(elastic), ..self.steady.clone() }
    }

    /// Number of unknowns.
    pub(crate) fn unknowns(&self) -> usize {
        self.steady.mesh.unknowns()
    }
}

impl Rubbing {
    /// Areas and power of a solution by the theory of its step.
    pub(crate) fn of(found: &VariationalSolution) -> Self {
        let count = found.points.len() as f64;
        let adhering = |point: &&MeshPoint| point.field.region == Region::Adhesion;
        let power = |point: &MeshPoint| {
            let ([x, y], [p, q]) = (point.field.traction, point.field.slip);
            if point.field.region == Region::Slip { x * p + y * q } else { 0.0 }
        };
        let sum: f64 = found.points.iter().map(power).sum();
        // The mean of the bound over the ellipse is 2/3 of its peak.
        Self {
            adhesion_share: found.points.iter().filter(adhering).count() as f64 / count,
            dissipation: 1.5 * sum / count,
        }
    }
}
