//! One resolution, prepared: elements, their pressure, and the slip of each by the traction of
//! every other.

use std::f64::consts::PI;

use super::forcing::{self, SlipForcing};
use super::influence::Influence;
use super::mesh::Mesh;
use super::pressure::Pressure;
use super::quadrature::Quadrature;
use super::stencil::SlipStencil;
use crate::ellipse::Ellipse;
use crate::Creepage;

/// Of the traction that an element's own slip asks for.
const WEIGHT: f64 = 0.3;

/// Everything that is prepared for one resolution.
///
/// The unknown of an element is its traction over its traction bound, a vector in the unit disc.
/// The slip of an element is its [`SlipForcing`] and the sum of coefficient times traction.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub mesh: Mesh,
    pub pressure: Pressure,
    /// By tractions over their bounds.
    pub influence: Influence,
    /// Where each element's slip is taken.
    pub places: Vec<[f64; 2]>,
    /// Slip of each element by the pressure of unlike bodies.
    pub pressure_slip: Vec<[f64; 2]>,
    pub quadrature: Quadrature,
    /// Weight `r` of slip against traction in the projection of each element. Any has the same
    /// solution; with a fraction of the traction that its own slip asks for the iteration neither
    /// cycles nor crawls.
    pub weights: Vec<f64>,
}

impl Grid {
    /// Hertz's contact, in units of `c`, of the largest traction bound, and of `mu c / rho`.
    pub(crate) fn hertz(
        ellipse: Ellipse,
        poisson: f64,
        kappa_over_mu: f64,
        [along, strips]: [usize; 2],
    ) -> Self {
        let mesh = Mesh::ellipse(ellipse, along, strips);
        let pressure = Pressure::hertz(ellipse, &mesh);
        // Slip in units of mu c / rho: (4.20) with the unit of slip mu f00.
        let slip_unit = (1.0 - poisson) * ellipse.integrals().e / (2.0 * ellipse.g().sqrt());
        let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
        let mut grid = Self::new(mesh, pressure, poisson, slip_unit, &stencils);
        if kappa_over_mu != 0.0 {
            let factor = kappa_over_mu / slip_unit;
            let by_pressure = forcing::by_hertz_pressure(ellipse, &stencils);
            grid.pressure_slip = by_pressure.into_iter().map(|s| s.map(|s| factor * s)).collect();
        }
        grid
    }

    /// Any mesh and pressure; `slip_unit` is the unit of slip over the largest traction bound in
    /// units of `G`.
    pub(crate) fn new(
        mesh: Mesh,
        pressure: Pressure,
        poisson: f64,
        slip_unit: f64,
        stencils: &[SlipStencil],
    ) -> Self {
        let scale = 1.0 / (PI * slip_unit);
        let factors: Vec<f64> = pressure.bounds.iter().map(|bound| scale * bound).collect();
        let influence = Influence::new(&mesh, poisson, stencils).with_columns_times(&factors);
        let strips = (0..mesh.strips.len()).flat_map(|s| mesh.elements(s).map(move |e| (s, e)));
        Self {
            weights: strips.map(|(strip, e)| WEIGHT / influence.own(strip, e)).collect(),
            places: stencils.iter().flat_map(|s| s.places.iter().copied()).collect(),
            pressure_slip: vec![[0.0; 2]; mesh.len()],
            quadrature: Quadrature::new(&mesh, &pressure),
            mesh,
            pressure,
            influence,
        }
    }

    /// Sets what drives the slip; `side` is the sign of the pressure's part.
    pub(crate) fn force(&self, creepage: Creepage, side: f64, forcing: &mut SlipForcing) {
        forcing.set(creepage, &self.places, side, &self.pressure_slip);
    }
}
