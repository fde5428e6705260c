//! Strips of FaStrip: the solution of strip theory in each, and the direction of the traction in the slip areas of eight of them, by FASTSIM.

use crate::approximate::dual::Real;
use crate::approximate::fastsim::{LANES, Lanes, State};
use crate::approximate::strip::Strip;

/// A strip as strip theory has it, with the direction of its traction kept in the slip area.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row<R> {
    /// Force and moment per width, in units of `3/4 mu N`.
    pub(super) force: [R; 3],
    /// Direction of the traction.
    pub(super) direction: [R; 2],
    /// Where the slip area ends, in units of the half-length; -1 is the trailing edge.
    pub(super) border: R,
    /// FASTSIM's traction is taken as it is, and not brought to the bound.
    pub(super) keeps: bool,
}

impl<R: Real> Row<R> {
    /// The strip at `t = y/b` of half-length `a s`.
    pub(super) fn of_strip(strip: &Strip<R>, [t, s]: [f64; 2], axes: [f64; 2]) -> Self {
        let direction = strip.direction();
        let force = if strip.depth.value() < s {
            strip.force([R::constant(t), R::constant(s)], axes)
        } else {
            let [fx, fy] = direction.map(|n| n * (s * s));
            [fx, fy, fx * (-t * axes[1])]
        };
        Self { force, direction, border: strip.depth * (2.0 / s) + -1.0, keeps: false }
    }

    /// A strip in which all comes from FASTSIM: the border lies ahead of the leading edge.
    pub(super) fn fastsim(keeps: bool) -> Self {
        let zero = R::constant(0.0);
        Self { force: [zero; 3], direction: [zero; 2], border: R::constant(3.0), keeps }
    }
}

/// Eight rows, as lanes.
#[derive(Debug)]
pub(super) struct Turn<const K: usize> {
    direction: [Lanes; 2],
    border: Lanes,
    keeps: [bool; LANES],
    direction_tangent: [[Lanes; 2]; K],
    border_tangent: [Lanes; K],
}

impl<const K: usize> Turn<K> {
    pub(super) fn new<R: Real>(rows: &[Row<R>; LANES]) -> Self {
        let [x, y] = [0, 1].map(|i| rows.map(|row| row.direction[i]));
        let border = rows.map(|row| row.border);
        Self {
            direction: [x.map(R::value), y.map(R::value)],
            border: border.map(R::value),
            keeps: rows.map(|row| row.keeps),
            direction_tangent: std::array::from_fn(|k| [x, y].map(|n| n.map(|v| v.tangent(k)))),
            border_tangent: std::array::from_fn(|k| border.map(|v| v.tangent(k))),
        }
    }

    /// Change of the traction at the cell with centre `x`, in units of the strip's largest
    /// bound, given FASTSIM's traction there.
    #[inline]
    pub(super) fn at(
        &self,
        x: f64,
        cells_per_length: f64,
        bound: f64,
        fastsim: &State<K>,
    ) -> State<K> {
        let mut change = State::zero();
        for l in 0..LANES {
            let size = (fastsim.x[l] * fastsim.x[l] + fastsim.y[l] * fastsim.y[l]).sqrt();
            // Elsewhere than in the strips that keep FASTSIM's size, to the bound.
            let unit = if self.keeps[l] { bound } else { size };
            let inverse = if unit > 0.0 { 1.0 / unit } else { 0.0 };
            let turns = if self.keeps[l] { 0.0 } else { 1.0 };
            let (ux, uy) = (fastsim.x[l] * inverse, fastsim.y[l] * inverse);
            // The part of the cell that lies in the slip area.
            let part = (self.border[l] - x) * cells_per_length + 0.5;
            let split = part > 0.0 && part < 1.0;
            let part = bound * part.clamp(0.0, 1.0);
            let turn = [ux - self.direction[0][l], uy - self.direction[1][l]];
            change.x[l] = part * turn[0];
            change.y[l] = part * turn[1];
            for k in 0..K {
                let (dx, dy) = (fastsim.dx[k][l] * inverse, fastsim.dy[k][l] * inverse);
                let longer = turns * (ux * dx + uy * dy);
                let shift = if split { self.border_tangent[k][l] } else { 0.0 };
                let shift = shift * bound * cells_per_length;
                let [nx, ny] = self.direction_tangent[k];
                change.dx[k][l] = shift * turn[0] + part * (dx - ux * longer - nx[l]);
                change.dy[k][l] = shift * turn[1] + part * (dy - uy * longer - ny[l]);
            }
        }
        change
    }
}
