//! March of FASTSIM from the leading to the trailing edge, eight strips at a time.

// Loops over lanes index several arrays at once: the plainest form, and the one that becomes SIMD.
#![allow(clippy::needless_range_loop)]

use super::flexibility::Slopes;
use super::grid::{Block, Cell, Grid, LANES, Lanes};
use crate::approximate::dual::Real;

/// What each strip's traction would grow by without slip, over a step of the strip's
/// half-length, in units of its largest bound: `(x, y + spin * x')` at `x'`; and the derivatives
/// of the same by the `K` components of creepage.
#[derive(Debug)]
pub(crate) struct Increments<const K: usize> {
    value: [Lanes; 3],
    tangent: [[Lanes; 3]; K],
}

impl<const K: usize> Increments<K> {
    /// From the slopes of the traction in each strip.
    #[inline]
    pub(crate) fn new<R: Real>(block: &Block, slopes: &[Slopes<R>; LANES]) -> Self {
        let mut increments = Self { value: [[0.0; LANES]; 3], tangent: [[[0.0; LANES]; 3]; K] };
        for l in 0..LANES {
            let Slopes { x, y, spin } = slopes[l];
            let growth = [x - spin * block.y[l], y, spin * block.half_length[l]];
            for (i, growth) in growth.into_iter().enumerate() {
                let growth = growth * block.gain[l];
                increments.value[i][l] = growth.value();
                for k in 0..K {
                    increments.tangent[k][i][l] = growth.tangent(k);
                }
            }
        }
        increments
    }
}

/// Tractions of eight strips at one cell, in units of each strip's largest bound, and their
/// derivatives.
#[derive(Debug)]
pub(crate) struct State<const K: usize> {
    pub(crate) x: Lanes,
    pub(crate) y: Lanes,
    pub(crate) dx: [Lanes; K],
    pub(crate) dy: [Lanes; K],
}

impl<const K: usize> State<K> {
    #[inline]
    pub(crate) fn zero() -> Self {
        Self { x: [0.0; LANES], y: [0.0; LANES], dx: [[0.0; LANES]; K], dy: [[0.0; LANES]; K] }
    }

    /// What a step without slip would lead to.
    #[inline]
    fn grow(&mut self, cell: &Cell, increments: &Increments<K>) {
        let Increments { value, tangent } = increments;
        for l in 0..LANES {
            self.x[l] += cell.step * value[0][l];
            self.y[l] += cell.step * (value[1][l] + cell.middle * value[2][l]);
        }
        for k in 0..K {
            for l in 0..LANES {
                self.dx[k][l] += cell.step * tangent[k][0][l];
                self.dy[k][l] += cell.step * (tangent[k][1][l] + cell.middle * tangent[k][2][l]);
            }
        }
    }

    /// Coulomb's law: too large a traction is shortened to the bound.
    #[inline]
    fn clip(&mut self, bound: f64) {
        let mut scale = [0.0; LANES];
        for l in 0..LANES {
            let ratio = bound / (self.x[l] * self.x[l] + self.y[l] * self.y[l]).sqrt();
            scale[l] = if ratio < 1.0 { ratio } else { 1.0 };
            self.x[l] *= scale[l];
            self.y[l] *= scale[l];
        }
        for k in 0..K {
            for l in 0..LANES {
                // What lengthens the traction is lost in slip.
                let slides = if scale[l] < 1.0 { 1.0 / (bound * bound) } else { 0.0 };
                let along = slides * (self.x[l] * self.dx[k][l] + self.y[l] * self.dy[k][l]);
                self.dx[k][l] = scale[l] * (self.dx[k][l] - along * self.x[l]);
                self.dy[k][l] = scale[l] * (self.dy[k][l] - along * self.y[l]);
            }
        }
    }
}

/// Marches through a block of strips and shows the tractions at every cell to `visit`.
#[inline]
pub(crate) fn march<const K: usize>(
    grid: &Grid,
    increments: &Increments<K>,
    mut visit: impl FnMut(&Cell, &State<K>),
) {
    let mut state = State::zero();
    for cell in &grid.cells {
        state.grow(cell, increments);
        state.clip(cell.bound);
        visit(cell, &state);
    }
}
