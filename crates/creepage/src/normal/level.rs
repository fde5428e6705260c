//! The element method on one lattice: pressures for a given approach.

use crate::gap::Gap;

use super::complementarity;
use super::error::{NormalError, Side};
use super::lattice::{Lattice, bounds, whole};
use super::overlap::widened;
use super::product::{Product, dot};

/// The solution on one lattice: cells that might touch, and the pressures on them.
#[derive(Debug, Clone)]
pub(super) struct ElementGrid {
    pub(super) lattice: Lattice,
    /// Pressures on all cells (Pa).
    pub(super) pressures: Vec<f64>,
    /// Cells near contact: those that a finer lattice must look at.
    near: Vec<bool>,
    pub(super) residual: f64,
    /// `dN/d(approach)` (N/m).
    pub(super) stiffness: f64,
}

/// Normal problem on one lattice.
#[derive(Debug, Clone, Copy)]
pub(super) struct NormalProblem<'a> {
    pub(super) gap: &'a Gap,
    /// `E* = G/(1 - sigma)` (Pa).
    pub(super) modulus: f64,
    pub(super) approach: f64,
}

/// Tolerances of a lattice's solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Accuracy {
    /// Largest residual, in parts of the greatest depth.
    pub(super) residual: f64,
    /// Largest residual of the stiffness's own equations; `None`: the stiffness is not asked for.
    pub(super) stiffness: Option<f64>,
}

impl Accuracy {
    /// To find out where contact is.
    pub(super) const LOOK: Self = Self { residual: 1e-2, stiffness: None };
    /// To begin with.
    pub(super) const START: Self = Self { residual: 1e-3, stiffness: Some(1e-2) };
    /// To give as the answer.
    pub(super) const ANSWER: Self = Self { residual: 1e-6, stiffness: Some(1e-4) };
}

impl ElementGrid {
    /// Solves on a lattice, looking at the cells near the contact of a coarser one, or at all.
    pub(super) fn solve(
        task: NormalProblem<'_>,
        lattice: Lattice,
        coarser: Option<&Self>,
        accuracy: Accuracy,
    ) -> Result<Self, NormalError> {
        let depths = lattice.depths(task.gap, task.approach)?;
        let mut looked_at: Vec<bool> = (0..lattice.cells())
            .map(|cell| coarser.is_none_or(|c| c.is_near(&lattice, cell)))
            .collect();
        let start = |cell: usize| match coarser {
            Some(coarser) => coarser.pressure_in(&lattice, cell),
            None => 0.0,
        };
        loop {
            let level = Self::on(task, &lattice, &depths, &looked_at, start, accuracy);
            if !level.grow(&depths, &mut looked_at) {
                return Ok(level);
            }
        }
    }

    /// Solves on the lattice of a contact close by, from pressures there. Bodies may touch beside that lattice alone.
    pub(super) fn warm_started(
        task: NormalProblem<'_>,
        lattice: Lattice,
        pressure: impl Fn(f64, f64) -> f64,
    ) -> Result<Self, NormalError> {
        let depths = lattice.depths(task.gap, task.approach)?;
        let deepest = depths.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if deepest <= 0.0 {
            let (approach, least_gap) = (task.approach, task.approach - deepest);
            return Err(NormalError::NoContact { approach, least_gap });
        }
        let looked_at = vec![true; lattice.cells()];
        let columns = lattice.count[0];
        let start = |cell: usize| pressure(lattice.x(cell % columns), lattice.y(cell / columns));
        Ok(Self::on(task, &lattice, &depths, &looked_at, start, Accuracy::ANSWER))
    }

    /// Whether pressed cells lie along a side of the lattice.
    pub(super) fn reaches_side(&self) -> bool {
        let [columns, rows] = self.lattice.count;
        self.bounds().is_none_or(|[[left, right], [low, high]]| {
            left == 0 || low == 0 || right + 1 == columns || high + 1 == rows
        })
    }

    fn on(
        task: NormalProblem<'_>,
        lattice: &Lattice,
        all_depths: &[f64],
        looked_at: &[bool],
        start: impl Fn(usize) -> f64,
        accuracy: Accuracy,
    ) -> Self {
        let cells: Vec<usize> = (0..lattice.cells())
            .filter(|&cell| looked_at[cell] && all_depths[cell] > 0.0)
            .collect();
        let scale = cells.iter().map(|&cell| all_depths[cell]).fold(0.0, f64::max);
        let depths: Vec<f64> = cells.iter().map(|&cell| all_depths[cell] / scale).collect();
        let length = lattice.cell_area().sqrt();
        let mut product = Product::new(lattice, &cells, length);
        let start: Vec<f64> = cells.iter().map(|&cell| start(cell)).collect();
        let start = if start.iter().any(|&p| p > 0.0) { start } else { depths.clone() };
        let pressed = complementarity::solve(&mut product, &depths, start, accuracy.residual);
        let unit = task.modulus * scale / length;
        let stiffness = accuracy.stiffness.map_or(f64::NAN, |tolerance| {
            flat_response(&mut product, &pressed.pressures, tolerance) * task.modulus * length
        });
        let mut level = Self {
            lattice: *lattice,
            pressures: vec![0.0; lattice.cells()],
            near: vec![false; lattice.cells()],
            residual: pressed.residual,
            stiffness,
        };
        for ((&cell, &pressure), &distance) in
            cells.iter().zip(&pressed.pressures).zip(&pressed.distance)
        {
            level.pressures[cell] = pressure * unit;
            level.near[cell] = distance < NEAR_CONTACT;
        }
        level
    }

    /// Adds overlapping neighbours of pressed cells that were not looked at.
    fn grow(&self, depths: &[f64], looked_at: &mut [bool]) -> bool {
        let mut grown = false;
        for cell in (0..self.pressures.len()).filter(|&cell| self.pressures[cell] > 0.0) {
            self.for_neighbours(cell, |other| {
                let new = !looked_at[other] && depths[other] > 0.0;
                looked_at[other] |= new;
                grown |= new;
            });
        }
        grown
    }

    fn for_neighbours(&self, cell: usize, mut visit: impl FnMut(usize)) {
        let [columns, rows] = self.lattice.count;
        let span = |at: usize, count: usize| {
            let [first, last] = widened([at, at], count);
            first..=last
        };
        for row in span(cell / columns, rows) {
            for column in span(cell % columns, columns) {
                visit(row * columns + column);
            }
        }
    }

    /// Whether a finer lattice's cell lies near contact.
    fn is_near(&self, finer: &Lattice, cell: usize) -> bool {
        let place = [finer.x(cell % finer.count[0]), finer.y(cell / finer.count[0])];
        let Some([column, row]) = self.lattice.holding(place[0], place[1]) else { return false };
        let mut near = false;
        self.for_neighbours(row * self.lattice.count[0] + column, |other| {
            near |= self.near[other] || self.pressures[other] > 0.0;
        });
        near
    }

    /// The pressure at the centre of another lattice's cell, between this one's centres.
    fn pressure_in(&self, other: &Lattice, cell: usize) -> f64 {
        let place = [other.x(cell % other.count[0]), other.y(cell / other.count[0])];
        let [t, u] = [0, 1]
            .map(|axis| (place[axis] - self.lattice.corner[axis]) / self.lattice.step[axis] - 0.5);
        let at = |column: f64, row: f64| {
            let [columns, rows] = self.lattice.count;
            let inside =
                column >= 0.0 && row >= 0.0 && column < columns as f64 && row < rows as f64;
            if inside { self.pressures[whole(row) * columns + whole(column)] } else { 0.0 }
        };
        let (i, j) = (t.floor(), u.floor());
        let (t, u) = (t - i, u - j);
        let low = (1.0 - t) * at(i, j) + t * at(i + 1.0, j);
        let high = (1.0 - t) * at(i, j + 1.0) + t * at(i + 1.0, j + 1.0);
        (1.0 - u) * low + u * high
    }

    pub(super) fn load(&self) -> f64 {
        self.pressures.iter().sum::<f64>() * self.lattice.cell_area()
    }

    /// First and last pressed columns and rows.
    pub(super) fn bounds(&self) -> Option<[[usize; 2]; 2]> {
        bounds(&self.lattice, |cell| self.pressures[cell] > 0.0)
    }

    /// The first side of the gap's domain that pressed cells lie along.
    pub(super) fn side_reached(&self, gap: &Gap) -> Option<Side> {
        let [columns, rows] = self.bounds()?;
        let pressed = self.lattice.rectangle(columns, rows);
        let domain = gap.domain();
        let [dx, dy] = self.lattice.step;
        [
            (Side::LowX, pressed.x[0] - domain.x[0], dx),
            (Side::HighX, domain.x[1] - pressed.x[1], dx),
            (Side::LowY, pressed.y[0] - domain.y[0], dy),
            (Side::HighY, domain.y[1] - pressed.y[1], dy),
        ]
        .into_iter()
        .find(|(_, distance, step)| *distance < 0.5 * step)
        .map(|(side, ..)| side)
    }
}

/// Deformed distance, in parts of the greatest depth, below which a cell is looked at again.
const NEAR_CONTACT: f64 = 0.03;

/// Sum of the pressures that displace all pressed cells by one: conjugate gradients.
fn flat_response(product: &mut Product, pressed: &[f64], tolerance: f64) -> f64 {
    const MAX_STEPS: usize = 300;
    let free = |values: &mut [f64]| {
        for (value, &p) in values.iter_mut().zip(pressed) {
            *value = if p > 0.0 { *value } else { 0.0 };
        }
    };
    let mut rest = vec![1.0; pressed.len()];
    free(&mut rest);
    // Contact pressures fall towards the edge where these rise: start from what is uniform.
    let (mut direction, mut image) = (rest.clone(), vec![0.0; pressed.len()]);
    let (mut sum, mut square) = (0.0, dot(&rest, &rest));
    let square_tolerance = tolerance * tolerance * square;
    for _ in 0..MAX_STEPS {
        if square <= square_tolerance {
            break;
        }
        product.apply(&direction, &mut image);
        free(&mut image);
        let length = square / dot(&direction, &image);
        sum += length * direction.iter().sum::<f64>();
        for (rest, image) in rest.iter_mut().zip(&image) {
            *rest -= length * image;
        }
        let next = dot(&rest, &rest);
        for (direction, rest) in direction.iter_mut().zip(&rest) {
            *direction = rest + next / square * *direction;
        }
        square = next;
    }
    sum
}
