//! Forces at the nodes of one shape and one Poisson's ratio.

use crate::{Creepage, Force, Status, Theory};
use rayon::prelude::*;

use super::coordinates::Coordinates;
use super::hermite::Angle;

/// Intervals of a table along `theta`, `phi` and `t`.
///
/// A table has a node more along each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Intervals {
    /// From pure spin to no spin; the last quarter of them is twice as wide as the others, which
    /// see more change.
    pub theta: usize,
    /// From `-eta` over `xi` to `eta`; even, so that `xi` alone is a node.
    pub phi: usize,
    /// From no creepage to infinite creepage.
    pub t: usize,
}

impl Default for Intervals {
    /// 20 by 16 by 48: but for long contacts, and coarse elements, tables err by less than half a
    /// per cent of `mu N`.
    fn default() -> Self {
        Self { theta: 20, phi: 16, t: 48 }
    }
}

impl Intervals {
    /// The angle `theta`.
    pub(crate) fn theta_axis(self) -> Angle {
        Angle::new([0.0, std::f64::consts::FRAC_PI_2], self.theta, self.theta / 4)
    }

    /// The angle `phi`.
    pub(crate) fn phi_axis(self) -> Angle {
        let quarter = std::f64::consts::FRAC_PI_2;
        Angle::new([-quarter, quarter], self.phi, 0)
    }

    /// Number of nodes of a block.
    pub(crate) fn nodes(self) -> usize {
        (self.theta + 1) * (self.phi + 1) * (self.t + 1)
    }

    /// `theta`, `phi` and `t` in the middle of the cell after a node.
    pub(crate) fn middle(self, [theta, phi, t]: [usize; 3]) -> [f64; 3] {
        let half_way = |axis: Angle, k| 0.5 * (axis.node(k) + axis.node(k + 1));
        let t = (t as f64 + 0.5) / self.t as f64;
        [half_way(self.theta_axis(), theta), half_way(self.phi_axis(), phi), t]
    }

    /// Index of a node.
    pub(crate) fn index(self, theta: usize, phi: usize, t: usize) -> usize {
        (theta * (self.phi + 1) + phi) * (self.t + 1) + t
    }
}

/// Signs of `(fx, fy, mz)` when the sign of `xi` changes.
pub(crate) const MIRROR_X: [f64; 3] = [-1.0, 1.0, 1.0];
/// Signs of `(fx, fy, mz)` when the signs of `eta` and `chi` change.
pub(crate) const MIRROR_Y: [f64; 3] = [1.0, -1.0, -1.0];

/// Forces at the nodes, and what they are near zero.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Values {
    /// `(fx, fy, mz)`, `t` fastest, then `phi`, then `theta`.
    pub(crate) forces: Vec<[f64; 3]>,
    /// Derivative of `(fx, fy, mz)` (rows) by `(xi, eta, chi)` at zero.
    pub(crate) gains: [[f64; 3]; 3],
    /// Nodes whose force the theory itself does not call solved.
    pub(crate) doubtful: usize,
}

impl Values {
    /// Asks the theory at every node that is not the mirror image of another; `done` hears of
    /// every line of nodes.
    pub(crate) fn compute(
        theory: &dyn Theory,
        coordinates: &Coordinates,
        intervals: Intervals,
        done: &(dyn Fn() + Sync),
    ) -> Self {
        let lines: Vec<(usize, usize)> = Self::lines(intervals).collect();
        let solved: Vec<_> = lines
            .par_iter()
            .map(|&(theta, phi)| {
                let line = Self::line(theory, coordinates, intervals, theta, phi);
                done();
                line
            })
            .collect();
        let mut forces = vec![[0.0; 3]; intervals.nodes()];
        let mut doubtful = 0;
        for (&(theta, phi), (line, unsolved)) in lines.iter().zip(&solved) {
            doubtful += unsolved;
            for (t, force) in line.iter().enumerate() {
                Self::store(&mut forces, intervals, [theta, phi, t], *force);
            }
        }
        Self { forces, gains: gains(theory), doubtful }
    }

    /// The weighted sum of some, of as many nodes each.
    pub(crate) fn mixed<'a>(parts: impl Iterator<Item = (&'a Self, f64)>) -> Self {
        let mut sum = Self { forces: Vec::new(), gains: [[0.0; 3]; 3], doubtful: 0 };
        for (part, weight) in parts.filter(|(_, weight)| *weight != 0.0) {
            sum.forces.resize(part.forces.len(), [0.0; 3]);
            sum.doubtful += part.doubtful;
            let values = part.forces.as_flattened().iter().chain(part.gains.as_flattened());
            let sums = sum.forces.as_flattened_mut().iter_mut();
            for (sum, value) in sums.chain(sum.gains.as_flattened_mut()).zip(values) {
                *sum += weight * value;
            }
        }
        sum
    }

    /// The lines of nodes to solve: the axis of spin once, and without spin one half.
    pub(crate) fn lines(intervals: Intervals) -> impl Iterator<Item = (usize, usize)> {
        let half = intervals.phi / 2;
        let first = move |theta| if theta == 0 || theta == intervals.theta { half } else { 0 };
        let last = move |theta| if theta == 0 { half } else { intervals.phi };
        (0..=intervals.theta)
            .flat_map(move |theta| (first(theta)..=last(theta)).map(move |phi| (theta, phi)))
    }

    fn line(
        theory: &dyn Theory,
        coordinates: &Coordinates,
        intervals: Intervals,
        theta: usize,
        phi: usize,
    ) -> (Vec<[f64; 3]>, usize) {
        let angles = [intervals.theta_axis().node(theta), intervals.phi_axis().node(phi)];
        let mut doubtful = 0;
        let ahead = (1..=intervals.t).map(|k| {
            let t = k as f64 / intervals.t as f64;
            let creepage = coordinates.creepage([angles[0], angles[1], t]);
            let solution = theory.solve(creepage);
            doubtful += usize::from(solution.status != Status::Solved);
            symmetric(creepage, solution.force)
        });
        (std::iter::once([0.0; 3]).chain(ahead).collect(), doubtful)
    }

    /// A force at its node and at the nodes that are the same place or its image.
    fn store(
        forces: &mut [[f64; 3]],
        intervals: Intervals,
        [theta, phi, t]: [usize; 3],
        force: [f64; 3],
    ) {
        if theta == 0 {
            (0..=intervals.phi).for_each(|phi| forces[intervals.index(0, phi, t)] = force);
            return;
        }
        forces[intervals.index(theta, phi, t)] = force;
        if theta == intervals.theta {
            let image = [0, 1, 2].map(|i| MIRROR_Y[i] * force[i]);
            let other = intervals.phi - phi;
            forces[intervals.index(theta, other, t)] = if other == phi { force } else { image };
        }
    }
}

/// What must vanish by symmetry is zero to the last bit.
fn symmetric(creepage: Creepage, force: Force) -> [f64; 3] {
    let pure = creepage.eta == 0.0 && creepage.chi == 0.0;
    let fx = if creepage.xi == 0.0 { 0.0 } else { force.fx };
    if pure { [fx, 0.0, 0.0] } else { [fx, force.fy, force.mz] }
}

/// Derivative of the force at zero, from forces at creepages so small that nothing slides.
fn gains(theory: &dyn Theory) -> [[f64; 3]; 3] {
    const SMALL: f64 = 1e-4;
    let at = |xi, eta, chi| {
        let force = theory.solve(Creepage { xi, eta, chi }).force;
        [force.fx, force.fy, force.mz].map(|f| f / SMALL)
    };
    let (x, y, z) = (at(SMALL, 0.0, 0.0), at(0.0, SMALL, 0.0), at(0.0, 0.0, SMALL));
    [[x[0], 0.0, 0.0], [0.0, y[1], z[1]], [0.0, y[2], z[2]]]
}
