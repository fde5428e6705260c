//! Rows of contact areas of any shape along rolling, each cut into equal cells.

use std::ops::Range;

use crate::normal::{Band, NormalContact};

/// A row of cells. Lengths are in the contact's unit, from the origin of coordinates.
#[derive(Debug, Clone)]
pub(super) struct Row {
    /// The patch that it belongs to.
    pub(super) patch: usize,
    pub(super) y: f64,
    pub(super) centre: f64,
    pub(super) half: f64,
    /// Lower and upper border in `y`.
    pub(super) borders: [f64; 2],
    /// Trailing and leading end on the lower and on the upper border.
    pub(super) ends: [[f64; 2]; 2],
    /// Its cells among all, from the leading end.
    pub(super) cells: Range<usize>,
    /// Force over `mu N` by a traction of one, the largest bound, in one cell.
    pub(super) weight: f64,
}

impl Row {
    /// Length of a cell.
    pub(super) fn step(&self) -> f64 {
        2.0 * self.half / self.cells.len() as f64
    }

    /// Middle of a cell, counted from the leading end.
    pub(super) fn middle(&self, i: usize) -> f64 {
        self.centre + self.half - (i as f64 + 0.5) * self.step()
    }

    /// Corners of a cell, all around.
    pub(super) fn corners(&self, i: usize) -> [[f64; 2]; 4] {
        let at = |border: usize, cut: usize| {
            let [rear, front] = self.ends[border];
            let share = cut as f64 / self.cells.len() as f64;
            [front - share * (front - rear), self.borders[border]]
        };
        [at(0, i), at(1, i), at(1, i + 1), at(0, i + 1)]
    }
}

/// The rows of all areas.
#[derive(Debug, Clone)]
pub(super) struct Rows {
    pub(super) rows: Vec<Row>,
    /// Traction bound in the middle of each cell over the largest.
    pub(super) bounds: Vec<f64>,
}

impl Rows {
    /// `along` cells in each row, `across` rows in the widest band and at least a quarter as many in
    /// the others.
    ///
    /// `share` is the friction at a `y` of the contact's unit over the largest.
    pub(super) fn new(
        contact: &NormalContact,
        length: f64,
        [along, across]: [usize; 2],
        share: impl Fn(f64) -> f64,
    ) -> Self {
        let width = |band: &Band| band.y()[1] - band.y()[0];
        let bands = || {
            let patches = contact.patches().iter().enumerate();
            patches.flat_map(|(index, patch)| patch.bands().iter().map(move |band| (index, band)))
        };
        let widest = bands().map(|(_, band)| width(band)).fold(0.0, f64::max);
        let mut rows = Self { rows: Vec::new(), bounds: Vec::new() };
        for (patch, band) in bands() {
            let count = part_of(across, (width(band) / widest).max(0.25));
            for j in 0..count {
                let [low, high] = band.y();
                let at = |j: usize| low + (high - low) * j as f64 / count as f64;
                rows.add(contact, band, patch, [at(j), at(j + 1)], [length, along as f64]);
            }
        }
        let total: f64 = rows.rows.iter().map(|row| row.weight * rows.sum(row)).sum();
        rows.rows.iter_mut().for_each(|row| row.weight /= total);
        for row in &rows.rows {
            let share = share(row.y);
            rows.bounds[row.cells.clone()].iter_mut().for_each(|bound| *bound *= share);
        }
        rows
    }

    fn sum(&self, row: &Row) -> f64 {
        self.bounds[row.cells.clone()].iter().sum()
    }

    /// Adds a row of a band between two `y` (m); one without length carries nothing.
    fn add(
        &mut self,
        contact: &NormalContact,
        band: &Band,
        patch: usize,
        borders: [f64; 2],
        [length, along]: [f64; 2],
    ) {
        let y = f64::midpoint(borders[0], borders[1]);
        let line = band.line(y);
        let load = band.moments(borders, [-1.0, 1.0]).force;
        if !(line.half > 0.0 && load > 0.0) {
            return;
        }
        let peak = contact.peak_pressure().value;
        let start = self.bounds.len();
        let places = std::iter::successors(Some(1.0 - 1.0 / along), |s| Some(s - 2.0 / along));
        let bounds = places.take_while(|s| *s > -1.0).map(|s| line.pressure(s) / peak);
        self.bounds.extend(bounds.map(|bound| bound.max(f64::MIN_POSITIVE)));
        let ends = borders.map(|y| band.ends(y).unwrap_or([line.centre; 2]));
        let mut row = Row {
            patch,
            y: y / length,
            centre: line.centre / length,
            half: line.half / length,
            borders: borders.map(|y| y / length),
            ends: ends.map(|ends| ends.map(|x| x / length)),
            cells: start..self.bounds.len(),
            weight: 0.0,
        };
        row.weight = load / self.sum(&row);
        self.rows.push(row);
    }
}

/// A part of a number, two at least.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // small and positive
fn part_of(count: usize, part: f64) -> usize {
    (count as f64 * part).round().max(2.0) as usize
}
