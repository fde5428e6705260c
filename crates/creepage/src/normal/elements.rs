//! The element method: rectangles of constant pressure on lattices that follow the contact.

use crate::gap::{Gap, Rectangle};

use super::error::{NormalError, Side};
use super::lattice::{Lattice, mean_chords, whole};
use super::level::{Accuracy, ElementGrid, NormalProblem};
use super::overlap::{Overlap, widened};

/// Cells that a lattice may have at most.
const MOST_CELLS: f64 = 250_000.0;

/// The first look: a lattice over the whole overlap.
pub(super) fn first(
    task: NormalProblem<'_>,
    overlap: &Overlap,
) -> Result<ElementGrid, NormalError> {
    const PER_CHORD: f64 = 8.0;
    let lattice = spanning(&overlap.rectangle, overlap.chords, PER_CHORD);
    ElementGrid::solve(task, lattice, None, Accuracy::LOOK)
}

/// A lattice closely about the contact of another, with `per_chord` cells in its mean chord.
pub(super) fn refined(
    task: NormalProblem<'_>,
    level: &ElementGrid,
    per_chord: f64,
    accuracy: Accuracy,
) -> Result<ElementGrid, NormalError> {
    let none = || NormalError::NoContact { approach: task.approach, least_gap: task.approach };
    let [columns, rows] = level.bounds().ok_or_else(none)?;
    let chords =
        mean_chords(&level.lattice, |cell| level.pressures[cell] > 0.0).ok_or_else(none)?;
    let count = level.lattice.count;
    let rectangle = level.lattice.rectangle(widened(columns, count[0]), widened(rows, count[1]));
    let lattice = spanning(&rectangle, chords, per_chord);
    ElementGrid::solve(task, lattice, Some(level), accuracy)
}

/// Divides a rectangle so that a chord has the given number of cells, within the limit of cells.
fn spanning(rectangle: &Rectangle, chords: [f64; 2], per_chord: f64) -> Lattice {
    /// Cells along each side of the rectangle, at least.
    const MIN_CELLS: f64 = 4.0;
    // A count that is whole but for rounding stays so at any scale of the lengths.
    const ROUNDING: f64 = 1e-6;
    let size = rectangle.size();
    let wanted = [0, 1].map(|axis| (size[axis] / chords[axis] * per_chord).max(MIN_CELLS));
    let shrink = (MOST_CELLS / (wanted[0] * wanted[1])).sqrt().min(1.0);
    let count = wanted
        .map(|n| whole(((n * shrink).clamp(MIN_CELLS, MOST_CELLS / MIN_CELLS) - ROUNDING).ceil()));
    Lattice::dividing(rectangle, count)
}

/// The error of a contact that reaches the side of the known gap.
pub(super) fn edge_error(task: NormalProblem<'_>, level: &ElementGrid, side: Side) -> NormalError {
    NormalError::ReachesEdge { side, beyond: beyond(task.gap, task.approach, level, side) }
}

/// How far beyond a side the gap, continued by its last parabolas, stays below the approach; infinite where it does so
/// for as far as `FAR` times the known gap.
fn beyond(gap: &Gap, approach: f64, level: &ElementGrid, side: Side) -> f64 {
    const FAR: f64 = 100.0;
    let lattice = &level.lattice;
    let [columns, rows] = lattice.count;
    let domain = gap.domain();
    let overlaps = |distance: f64| match side {
        Side::LowX => (0..rows).any(|j| gap.at(domain.x[0] - distance, lattice.y(j)) < approach),
        Side::HighX => (0..rows).any(|j| gap.at(domain.x[1] + distance, lattice.y(j)) < approach),
        Side::LowY => (0..columns).any(|i| gap.at(lattice.x(i), domain.y[0] - distance) < approach),
        Side::HighY => {
            (0..columns).any(|i| gap.at(lattice.x(i), domain.y[1] + distance) < approach)
        }
    };
    let (step, [low, high]) = match side {
        Side::LowX | Side::HighX => (lattice.step[0], domain.x),
        Side::LowY | Side::HighY => (lattice.step[1], domain.y),
    };
    // Steps that grow by an eighth each.
    let mut distance = step;
    while distance < FAR * (high - low) {
        if !overlaps(distance) {
            return distance;
        }
        distance *= 1.125;
    }
    f64::INFINITY
}
