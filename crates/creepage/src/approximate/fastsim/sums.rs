//! Sums of tractions over cells: force and moment, with derivatives.

use super::grid::{Block, LANES, Lanes};
use super::march::State;
use crate::approximate::dual::Real;

/// Force and moment in units of `mu N` and `c`, and their derivatives by `K` components of
/// creepage.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Totals<const K: usize> {
    pub(crate) force: [f64; 3],
    pub(crate) tangents: [[f64; 3]; K],
}

impl<const K: usize> Totals<K> {
    pub(crate) fn zero() -> Self {
        Self { force: [0.0; 3], tangents: [[0.0; 3]; K] }
    }

    /// Adds a force that carries its derivatives itself.
    pub(crate) fn add<R: Real>(&mut self, force: [R; 3], weight: f64) {
        for (i, part) in force.into_iter().enumerate() {
            self.force[i] += weight * part.value();
            for (k, tangent) in self.tangents.iter_mut().enumerate() {
                tangent[i] += weight * part.tangent(k);
            }
        }
    }
}

impl<const K: usize> Totals<K> {
    /// As far as friction goes: the sum of the bound over cells is larger than `mu N` by the error of its
    /// quadrature. What is nearest within `mu N` is nearer to the integral too.
    pub(crate) fn within_friction(mut self) -> Self {
        let [fx, fy, _] = self.force;
        let size = fx.hypot(fy);
        if size > 1.0 {
            let [x, y] = [fx / size, fy / size];
            (self.force[0], self.force[1]) = (x, y);
            for tangent in &mut self.tangents {
                let across = (x * tangent[1] - y * tangent[0]) / size;
                (tangent[0], tangent[1]) = (-y * across, x * across);
            }
        }
        self
    }
}

impl Totals<3> {
    /// Rows `fx`, `fy`, `mz`; columns `xi`, `eta`, `chi`.
    pub(crate) fn jacobian(&self) -> [[f64; 3]; 3] {
        [0, 1, 2].map(|row| self.tangents.map(|column| column[row]))
    }
}

/// Sums over the cells of eight strips.
#[derive(Debug)]
pub(crate) struct Sums<const K: usize> {
    value: Moments,
    tangents: [Moments; K],
}

impl<const K: usize> Sums<K> {
    pub(crate) fn zero() -> Self {
        Self { value: Moments::default(), tangents: [Moments::default(); K] }
    }

    /// Adds the tractions at the cells with centres at `place`.
    #[inline]
    pub(crate) fn add(&mut self, place: f64, state: &State<K>) {
        self.value.add(place, &state.x, &state.y);
        for (sums, (dx, dy)) in self.tangents.iter_mut().zip(state.dx.iter().zip(&state.dy)) {
            sums.add(place, dx, dy);
        }
    }

    /// Adds the strips' forces and moments to `totals`.
    pub(crate) fn collect(&self, block: &Block, totals: &mut Totals<K>) {
        self.value.collect(block, &mut totals.force);
        for (sums, tangent) in self.tangents.iter().zip(&mut totals.tangents) {
            sums.collect(block, tangent);
        }
    }
}

#[derive(Debug, Clone, Copy, Default)]
struct Moments {
    x: Lanes,
    y: Lanes,
    x_times_y: Lanes,
}

impl Moments {
    #[inline]
    fn add(&mut self, place: f64, x: &Lanes, y: &Lanes) {
        for l in 0..LANES {
            self.x[l] += x[l];
            self.y[l] += y[l];
            self.x_times_y[l] += place * y[l];
        }
    }

    fn collect(&self, block: &Block, force: &mut [f64; 3]) {
        for l in 0..LANES {
            let weight = block.weight[l];
            force[0] += weight * self.x[l];
            force[1] += weight * self.y[l];
            force[2] +=
                weight * (block.half_length[l] * self.x_times_y[l] - block.y[l] * self.x[l]);
        }
    }
}
