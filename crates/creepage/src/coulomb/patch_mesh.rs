//! The mesh and the pressure of contact areas of any shape, from strips of their patches.

use std::ops::Range;
use std::sync::Arc;

use super::grid::Grid;
use super::mesh::{Mesh, Strip, StripGrading, border, fit};
use super::pressure::{Moments, Pressure};
use super::resolution::Resolution;
use super::stencil::SlipStencil;
use super::subdivision::{Pieces, SUBCELLS};
use crate::normal::{Band, ChordPoint, NormalContact, Patch, SLIP_UNIT};
use crate::numerics::gauss::GAUSS_2;

/// Least pressure over the largest: tractions are unknown over their bound, which must not vanish.
const MIN_PRESSURE: f64 = 1e-4;
/// Least half-length over the unit of length: an element must not vanish, as near a tip where the
/// ends of a band cross.
const LEAST_LENGTH: f64 = 1e-3;
/// A band of small load gets fewer elements, down to this part along and across.
const FEWEST: f64 = 0.5;

/// Origin and unit of the lengths of a mesh (m).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    pub origin: [f64; 2],
    pub length: f64,
}

impl Frame {
    pub(crate) fn inward(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [(x - self.origin[0]) / self.length, (y - self.origin[1]) / self.length]
    }

    pub(crate) fn outward(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.origin[0] + self.length * x, self.origin[1] + self.length * y]
    }
}

/// The bands of a contact and how many elements each has along and across.
#[derive(Debug)]
pub(crate) struct Bands<'a> {
    contact: &'a NormalContact,
    frame: Frame,
    parts: Vec<(&'a Band, [usize; 2])>,
}

impl<'a> Bands<'a> {
    /// The bands with the elements of the coarser grid.
    pub(crate) fn new(contact: &'a NormalContact, frame: Frame, resolution: Resolution) -> Self {
        let bands = contact.patches().iter().flat_map(Patch::bands);
        let loads: Vec<(&Band, f64)> = bands.map(|band| (band, band.total().force)).collect();
        let largest = loads.iter().map(|(_, load)| *load).fold(0.0, f64::max);
        let counted = |(band, load): (&'a Band, f64)| {
            let part = (load / largest).max(0.0).sqrt().clamp(FEWEST, 1.0);
            let counts = resolution.coarse(ratio(band)).map(|n| scaled(n, part));
            (band, counts)
        };
        Self { contact, frame, parts: loads.into_iter().map(counted).collect() }
    }

    /// The same with half as many more elements along.
    pub(crate) fn with_more_along(mut self) -> Self {
        self.parts.iter_mut().for_each(|(_, [along, _])| *along += *along / 2);
        self
    }

    /// The grid of [`Bands::mesh`].
    pub(crate) fn grid(&self, times: usize) -> Grid {
        let mesh = self.mesh(times);
        let pressure = self.pressure(&mesh);
        let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
        Grid::new(mesh, pressure, self.contact.pair().poisson(), SLIP_UNIT, &stencils)
    }

    /// The elements, `times` as many along and across.
    pub(crate) fn mesh(&self, times: usize) -> Mesh {
        let mut strips = Vec::new();
        for (band, [along, across]) in &self.parts {
            let patch = strips.len()..strips.len() + times * across;
            let pieces = Pieces::of_equal_angles(times * along);
            for j in 0..times * across {
                strips.push(self.strip(band, j, &pieces, patch.clone()));
            }
        }
        Mesh::new(strips)
    }

    fn strip(&self, band: &Band, j: usize, pieces: &Arc<Pieces>, patch: Range<usize>) -> Strip {
        let (fit, [low, high]) = (fit(ratio(band)), band.y());
        let at = |t: f64| (f64::midpoint(low, high) + 0.5 * (high - low) * t).clamp(low, high);
        let border =
            |k: usize| at(border(broken(SUBCELLS * j + k), patch.len(), fit, StripGrading::NARROW));
        let y: [f64; SUBCELLS + 1] = std::array::from_fn(border);
        let ends = [y[0], y[SUBCELLS]].map(|y| self.section(band, y));
        let mean = 0.5 * band.area_between([y[0], y[SUBCELLS]]) / (y[SUBCELLS] - y[0]);
        Strip {
            across: y.map(|y| self.frame.inward([0.0, y])[1]),
            middle: ends.map(|[middle, _]| self.frame.inward([middle, 0.0])[0]),
            half_length: ends
                .map(|[_, half]| (fit * half + (1.0 - fit) * mean) / self.frame.length),
            along: Arc::clone(pieces),
            patch,
        }
    }

    /// Middle and half-length at `y` (m).
    fn section(&self, band: &Band, y: f64) -> [f64; 2] {
        let [rear, front] = band.ends(y).unwrap_or_default();
        [f64::midpoint(rear, front), (0.5 * (front - rear)).max(self.least_length())]
    }

    /// Least half-length (m).
    fn least_length(&self) -> f64 {
        LEAST_LENGTH * self.frame.length
    }

    /// The pressure on the elements of [`Bands::mesh`]; its unit is the largest.
    pub(crate) fn pressure(&self, mesh: &Mesh) -> Pressure {
        let mut pressure = Pressure {
            bounds: Vec::with_capacity(mesh.len()),
            shares: Vec::with_capacity(mesh.len()),
            centroids: Vec::with_capacity(mesh.len()),
            subcells: Vec::with_capacity(mesh.len()),
        };
        let bands = self.parts.iter().flat_map(|(band, [_, across])| {
            let times = mesh.strips.len() / self.strips();
            std::iter::repeat_n(*band, times * across)
        });
        let (mut before, mut nodes) = (None, Vec::new());
        for (strip, band) in mesh.strips.iter().zip(bands) {
            if !before.is_some_and(|before| Arc::ptr_eq(before, &strip.along)) {
                before = Some(&strip.along);
                nodes = strip.along.cuts.windows(2).map(nodes_between).collect();
            }
            self.add_strip(strip, band, &nodes, &mut pressure);
        }
        let total: f64 = pressure.shares.iter().sum();
        pressure.scale(total.recip(), self.contact.load().value / total);
        pressure
    }

    /// Strips of the coarser grid.
    fn strips(&self) -> usize {
        self.parts.iter().map(|(_, [_, across])| across).sum()
    }

    /// Adds a strip's elements, with forces (N) for shares, by the nodes along it.
    fn add_strip(&self, strip: &Strip, band: &Band, nodes: &[[Node; 2]], pressure: &mut Pressure) {
        let peak = self.contact.peak_pressure().value;
        let y = strip.across.map(|y| self.frame.outward([0.0, y])[1]);
        let rows: [Vec<Cell>; SUBCELLS] =
            std::array::from_fn(|k| self.row(nodes, band, [y[k], y[k + 1]]));
        for i in 0..strip.len() {
            let cells: [[Cell; SUBCELLS]; SUBCELLS] =
                std::array::from_fn(|k| std::array::from_fn(|m| rows[k][SUBCELLS * i + m]));
            let mut sum = Cell::default();
            cells.as_flattened().iter().for_each(|cell| sum.add(cell));
            let whole = sum.moments();
            pressure.bounds.push(whole.share / (sum.area * peak));
            pressure.shares.push(whole.share);
            pressure.centroids.push(whole.centroid);
            pressure.subcells.push(cells.map(|row| row.map(Cell::moments)));
        }
    }

    /// The subcells of a strip between two `y` (m), by their nodes along.
    fn row(&self, nodes: &[[Node; 2]], band: &Band, [low, high]: [f64; 2]) -> Vec<Cell> {
        let (middle, half) = (f64::midpoint(low, high), 0.5 * (high - low));
        let lines = GAUSS_2.map(|(t, _)| {
            let y = middle + half * t;
            let line = band.line(y);
            let length = line.half.max(self.least_length());
            let [x, y] = self.frame.inward([line.centre, y]);
            (half * length, [x, length / self.frame.length, y], line)
        });
        let least = MIN_PRESSURE * self.contact.peak_pressure().value;
        let cell = |nodes: &[Node; 2]| {
            let mut sum = Cell::default();
            for (area, [x, length, y], line) in &lines {
                for Node { spot, weight } in nodes {
                    let area = area * weight;
                    let force = area * line.pressure_at(spot).max(least);
                    let by = [x + length * spot.s, *y, spot.s].map(|at| force * at);
                    sum.add(&Cell { area, force, by });
                }
            }
            sum
        };
        nodes.iter().map(cell).collect()
    }
}

/// A point of quadrature along a strip, and its part of the half-length.
#[derive(Debug, Clone, Copy)]
struct Node {
    spot: ChordPoint,
    weight: f64,
}

/// Gauss's points between two cuts, in the angle whose sine is cut: there the pressure is smooth.
fn nodes_between(ends: &[f64]) -> [Node; 2] {
    let (front, rear) = (ends[0].asin(), ends[1].asin());
    let (middle, turn) = (f64::midpoint(front, rear), 0.5 * (front - rear));
    GAUSS_2.map(|(t, _)| {
        let (s, cos) = (middle + turn * t).sin_cos();
        Node { spot: ChordPoint::new(s), weight: turn * cos }
    })
}

/// Area (m^2) and force (N) of a piece, and the force's moments by `x`, `y` and the position along
/// the strip.
#[derive(Debug, Clone, Copy, Default)]
struct Cell {
    area: f64,
    force: f64,
    by: [f64; 3],
}

impl Cell {
    fn add(&mut self, other: &Self) {
        self.area += other.area;
        self.force += other.force;
        self.by.iter_mut().zip(other.by).for_each(|(by, other)| *by += other);
    }

    fn moments(self) -> Moments {
        let [x, y, along] = self.by.map(|by| by / self.force);
        Moments { share: self.force, centroid: [x, y], along }
    }
}

/// A number of pieces in elements.
fn broken(piece: usize) -> f64 {
    piece as f64 / SUBCELLS as f64
}

/// Length along over width across.
fn ratio(band: &Band) -> f64 {
    let length = |y: f64| band.ends(y).map_or(0.0, |[rear, front]| front - rear);
    let [low, high] = band.y();
    band.rows().map(length).fold(0.0, f64::max) / (high - low)
}

/// A number of elements times a part.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // small and positive
fn scaled(n: usize, part: f64) -> usize {
    (n as f64 * part).round().max(3.0) as usize
}
