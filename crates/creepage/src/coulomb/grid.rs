//! One resolution, prepared: elements, their pressure, and the slip of each by the traction of
//! every other.

use std::f64::consts::PI;

use super::forcing::{self, SlipForcing};
use super::influence::Influence;
use super::mesh::Mesh;
use super::pressure::Pressure;
use super::quadrature::Quadrature;
use super::stencil::SlipStencil;
use crate::Creepage;
use crate::ellipse::Ellipse;

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
    /// Slip of each element by the pressure of dissimilar bodies.
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
    pub(crate) fn set_forcing(&self, creepage: Creepage, side: f64, forcing: &mut SlipForcing) {
        forcing.set(creepage, &self.places, side, &self.pressure_slip);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Force;
    use crate::coulomb::mesh::{SUBCELLS, cut};
    use crate::coulomb::solver::{Equations, State};

    const POISSON: f64 = 0.28;

    fn ellipse() -> Ellipse {
        Ellipse::from_ratio(1.6).unwrap()
    }

    /// Hertz's contact on any strips that fit the ellipse, in the units of [`Grid::hertz`].
    fn on(mesh: Mesh) -> Grid {
        let ellipse = ellipse();
        let pressure = Pressure::hertz(ellipse, &mesh);
        let slip_unit = (1.0 - POISSON) * ellipse.integrals().e / (2.0 * ellipse.g().sqrt());
        let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
        Grid::new(mesh, pressure, POISSON, slip_unit, &stencils)
    }

    fn force(grid: &Grid, [xi, eta, chi]: [f64; 3]) -> [f64; 3] {
        let (mut state, mut equations) = (State::new(grid), Equations::new(grid));
        grid.set_forcing(Creepage::new(xi, eta, chi).unwrap(), 1.0, &mut state.forcing);
        assert!(state.solve(grid, &mut equations).converged);
        let Force { fx, fy, mz } = state.sum(grid, 1.0).force;
        [fx, fy, mz]
    }

    const CASES: [[f64; 3]; 4] =
        [[0.5, 0.3, 0.4], [0.0, 0.8, -1.0], [1.0, -0.4, 3.0], [-0.3, 0.1, 0.0]];

    #[test]
    fn the_mirror_image_is_a_saving_only() {
        let half = Grid::hertz(ellipse(), POISSON, 0.0, [12, 10]);
        let dense = on(Mesh::new(Mesh::ellipse(ellipse(), 12, 10).strips));
        for case in CASES {
            for (half, dense) in force(&half, case).into_iter().zip(force(&dense, case)) {
                // Rounding, over a condition number of some tens.
                assert!((half - dense).abs() < 1e-12, "{case:?}: {half} {dense}");
            }
        }
    }

    /// Strips with `n`, `n + 2` and `n + 4` elements by turns.
    fn unequal(n: usize, strips: usize) -> Mesh {
        let mut mesh = Mesh::ellipse(ellipse(), n, strips);
        for (j, strip) in mesh.strips.iter_mut().enumerate() {
            let count = n + 2 * (j % 3);
            let cuts = (0..=SUBCELLS * count).map(|p| cut(p as f64 / SUBCELLS as f64, count));
            strip.along = cuts.collect();
        }
        Mesh::new(mesh.strips)
    }

    /// Two refinements by two, against a finer mesh of equal strips: the error of second order falls
    /// to a sixteenth; from case to case it depends on where the border of adhesion falls.
    #[test]
    fn strips_of_unequal_numbers_of_elements_converge() {
        let truth = Grid::hertz(ellipse(), POISSON, 0.0, [56, 40]);
        let grids = [(8, 6), (16, 12), (32, 24)].map(|(n, strips)| on(unequal(n, strips)));
        let mut errors = [0.0; 3];
        for case in CASES {
            let truth = force(&truth, case);
            for (error, grid) in errors.iter_mut().zip(&grids) {
                let found = force(grid, case);
                *error += (0..3).map(|k| (found[k] - truth[k]).abs()).sum::<f64>();
            }
        }
        assert!(errors[2] < errors[0] / 8.0 && errors[2] < 0.01, "{errors:?}");
    }
}
