//! Grid of one resolution: elements, their pressure, and the influence of the traction of each on the slip of every
//! other.

use super::forcing::{self, SlipForcing};
use super::friction_bound::FrictionBound;
use super::influence::{Displacements, Influence};
use super::mesh::Mesh;
use super::pressure::Pressure;
use super::quadrature::Quadrature;
use super::spin_pole;
use super::stencil::SlipStencil;
use crate::ellipse::Ellipse;
use crate::friction_law::RollingFriction;
use crate::layer::Layer;
use crate::{Creepage, Scaling};

/// Weight `r` of slip in the projection, as a fraction of the traction per slip of an element alone.
const WEIGHT: f64 = 0.3;
/// Regularization half-width over the traction bound, `min(4/n, 0.15)` with `n` elements along: the traction changes
/// by some `1/n` from one element to the next.
const ROUNDING: [f64; 2] = [4.0, 0.15];

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
    /// Half-width of the rounded corner of [`project`](super::friction::project).
    pub rounding: f64,
    /// Whether less of it is left at strong spin.
    pub spin_narrowing: bool,
    /// Whether the contact is so long that the corner is narrow and monotone. Not on areas of any shape: they
    /// may become long as a wheelset moves, and forces must not jump.
    pub is_long: bool,
    /// For each element, those of the coarser grid to interpolate between, with their weights.
    pub coarser: Vec<[(usize, f64); 4]>,
    /// Half the width of each element's strip, where adhesion gives way to spin; empty elsewhere.
    pub half_widths: Vec<f64>,
    /// Where the traction bound depends on the slip.
    pub resistance: Option<FrictionBound>,
}

impl Grid {
    /// For steady rolling, the coarser grid and the finer with twice its elements along and across, by how
    /// many times there are as many.
    pub(crate) fn pair(make: impl Fn(usize) -> Self) -> [Self; 2] {
        let [mut coarse, mut fine] = [1, 2].map(make);
        coarse.rounding = 2.0 * fine.rounding;
        (coarse.spin_narrowing, fine.spin_narrowing) = (true, true);
        let strips = fine.mesh.strips.iter().enumerate();
        fine.coarser = strips
            .flat_map(|(j, strip)| {
                let coarse = &coarse.mesh;
                (0..strip.len())
                    .map(move |i| coarse.around(j / 2, strip.y(), strip.along.middles[i]))
            })
            .collect();
        [coarse, fine]
    }

    /// Hertz's contact, on a mesh of its ellipse, in units of `c`, of the largest traction bound, and
    /// of `mu c / rho`.
    pub(crate) fn hertz(ellipse: Ellipse, poisson: f64, kappa_over_mu: f64, mesh: Mesh) -> Self {
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
        let influence = Influence::new(&mesh, poisson, stencils, pressure.units(slip_unit));
        let strips = (0..mesh.strips.len()).flat_map(|s| mesh.elements(s).map(move |e| (s, e)));
        let places: Vec<_> = stencils.iter().flat_map(|s| s.places.iter().copied()).collect();
        Self {
            weights: strips.map(|(strip, e)| WEIGHT / influence.own(strip, e)).collect(),
            resistance: None,
            pressure_slip: vec![[0.0; 2]; mesh.len()],
            quadrature: Quadrature::new(&mesh, &pressure, &places),
            places,
            rounding: (ROUNDING[0] * mesh.strips.len() as f64 / mesh.len() as f64).min(ROUNDING[1]),
            spin_narrowing: false,
            is_long: false,
            coarser: Vec::new(),
            half_widths: Vec::new(),
            mesh,
            pressure,
            influence,
        }
    }

    /// The same with adhesion that gives way where spin turns the slip about within an element.
    pub(crate) fn with_spin_compliance(mut self) -> Self {
        let half_width = |(strip, _): (usize, usize)| {
            let [low, high] = self.mesh.strips[strip].borders();
            0.5 * (high - low)
        };
        self.half_widths = self.mesh.all().map(half_width).collect();
        self
    }

    /// The same with friction that depends on the slip and with a layer, in the units `scaling`.
    pub(crate) fn with_resistance(
        mut self,
        friction: Option<RollingFriction>,
        layer: Option<Layer>,
        scaling: Scaling,
    ) -> Self {
        if friction.is_none() && layer.is_none() {
            return self;
        }
        let stencils: Vec<_> = self.mesh.strips.iter().map(SlipStencil::steady).collect();
        self.resistance = FrictionBound::new(friction, layer, scaling, &stencils);
        let Some(layer) = layer else { return self };
        let own = self.displacements_of(layer, scaling);
        self.influence = self.influence.with_own_displacements(&stencils, &own);
        let own_slip = |weights: &[f64]| weights.iter().map(|weight| weight.recip()).sum::<f64>();
        let bare = own_slip(&self.weights);
        for (element, (strip, _)) in self.mesh.all().enumerate() {
            self.weights[element] = WEIGHT / self.influence.own(strip, element);
        }
        let softer = own_slip(&self.weights) / bare;
        // On springs the slip grows slowly from the border of adhesion: a rounded corner reaches far.
        self.rounding /= softer.sqrt();
        // What spin makes within an element counts by the slip that elements take up.
        self.half_widths.iter_mut().for_each(|half_width| *half_width /= softer);
        self.quadrature.set_elastic_slip(softer);
        self
    }

    /// Displacement of a layer by the largest traction of every element.
    pub(crate) fn displacements_of(&self, layer: Layer, scaling: Scaling) -> Vec<f64> {
        let flexibility = layer.dimensionless_flexibility(scaling);
        self.pressure.bounds.iter().map(|bound| flexibility * bound).collect()
    }

    /// Makes the slip of every element another combination of displacements: rows and factors.
    pub(crate) fn combine(&mut self, displacements: &Displacements, weights: &[[(usize, f64); 3]]) {
        displacements.combine(weights, &mut self.influence);
        self.weights.clear();
        for strip in 0..self.mesh.strips.len() {
            let own = self.mesh.elements(strip).map(|e| WEIGHT / self.influence.own(strip, e));
            self.weights.extend(own);
        }
    }

    /// The part of [`Grid::rounding`] that is left at a spin, and its derivative.
    pub(crate) fn corner(&self, spin: f64) -> [f64; 2] {
        if self.spin_narrowing { spin_pole::corner(spin) } else { [1.0, 0.0] }
    }

    /// Sets what drives the slip; `side` is the sign of the pressure's part.
    pub(crate) fn set_forcing(&self, creepage: Creepage, side: f64, forcing: &mut SlipForcing) {
        forcing.set(creepage, &self.places, side, &self.pressure_slip);
        spin_pole::set_spin_compliance(&self.half_widths, &self.weights, forcing);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Force;
    use crate::coulomb::influence::{Precision, Tractions};
    use crate::coulomb::solver::{Equations, State};
    use crate::coulomb::subdivision::Pieces;

    const POISSON: f64 = 0.28;

    fn ellipse() -> Ellipse {
        Ellipse::from_ratio(1.6).unwrap()
    }

    fn slip_unit() -> f64 {
        (1.0 - POISSON) * ellipse().integrals().e / (2.0 * ellipse().g().sqrt())
    }

    /// Hertz's contact on any strips that fit the ellipse, in the units of [`Grid::hertz`].
    fn on(mesh: Mesh) -> Grid {
        let pressure = Pressure::hertz(ellipse(), &mesh);
        let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
        Grid::new(mesh, pressure, POISSON, slip_unit(), &stencils)
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
        let half = Grid::hertz(ellipse(), POISSON, 0.0, Mesh::ellipse(ellipse(), 12, 10));
        let dense = on(Mesh::new(Mesh::ellipse(ellipse(), 12, 10).strips));
        let [by_half, by_dense] = [&half, &dense].map(|grid| slips(&grid.influence));
        for (half, dense) in by_half.iter().zip(&by_dense) {
            // Rounding of some hundred coefficients to 6e-8 each.
            assert!((half - dense).abs() < 2e-7, "{half} {dense}");
        }
        for case in CASES {
            for (half, dense) in force(&half, case).into_iter().zip(force(&dense, case)) {
                // Where the solver stops: strips are solved in another order.
                assert!((half - dense).abs() < 1e-6, "{case:?}: {half} {dense}");
            }
        }
    }

    /// Slip of every element by tractions without symmetry.
    fn slips(influence: &Influence) -> Vec<f64> {
        let mut tractions = Tractions::zeros(influence);
        let n = tractions.own[0].len();
        let vector: Vec<f64> = (0..2 * n).map(|k| (k as f64).sin()).collect();
        tractions.copy_from(&vector);
        tractions.fold_all(Precision::Double);
        let mut slips = [0, 1].map(|_| vec![0.0; n]);
        for strip in 0..influence.strips() {
            influence.slip(Precision::Double, strip, &tractions, &mut slips);
        }
        slips.concat()
    }

    /// Strips with `n`, `n + 2` and `n + 4` elements by turns.
    fn unequal(n: usize, strips: usize) -> Mesh {
        let mut mesh = Mesh::ellipse(ellipse(), n, strips);
        for (j, strip) in mesh.strips.iter_mut().enumerate() {
            let count = n + 2 * (j % 3);
            strip.along = Pieces::of_equal_angles(count);
        }
        Mesh::new(mesh.strips)
    }

    /// Two refinements by two, against a finer mesh of equal strips: the error of second order falls
    /// to a sixteenth; from case to case it depends on where the border of adhesion falls.
    #[test]
    fn strips_of_unequal_numbers_of_elements_converge() {
        let truth = Grid::hertz(ellipse(), POISSON, 0.0, Mesh::ellipse(ellipse(), 56, 40));
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
