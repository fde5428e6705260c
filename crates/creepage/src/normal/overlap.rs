//! Overlap of the undeformed bodies: contact lies inside, for pressure only pushes apart.

use crate::gap::{Gap, Rectangle};

use super::error::NormalError;
use super::lattice::{Lattice, bounds, mean_chords};

/// The overlap of the undeformed bodies at an approach.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Overlap {
    /// A rectangle that holds it, close around it.
    pub(super) rectangle: Rectangle,
    /// Mean lengths of its chords along x and y (m).
    pub(super) chords: [f64; 2],
    /// Its area (m^2).
    pub(super) area: f64,
    /// Its greatest depth (m).
    pub(super) depth: f64,
}

impl Overlap {
    /// Looks for the overlap on lattices that close in on it.
    pub(super) fn find(gap: &Gap, approach: f64) -> Result<Self, NormalError> {
        const CELLS: usize = 48;
        /// Where several wells lie far apart.
        const MOST_CELLS: usize = 768;
        const LOOKS: usize = 60;
        const FILLED: f64 = 0.7;
        let mut rectangle = gap.reach(approach).ok_or(NormalError::Unbounded { approach })?;
        let mut deepest = f64::NEG_INFINITY;
        // A lattice that closes in on one well would lose the others.
        let has_several = gap.wells_below(approach) > 1;
        let mut cells = CELLS;
        for _ in 0..LOOKS {
            let lattice = Lattice::dividing(&rectangle, [cells; 2]);
            let depths = lattice.depths(gap, approach)?;
            let (at, depth) = greatest(&depths);
            let improves = depth > deepest;
            deepest = deepest.max(depth);
            let possible = bounds(&lattice, |cell| may_overlap(&lattice, &depths, cell));
            let Some([columns, rows]) = possible else {
                if !improves {
                    break;
                }
                rectangle = around(&lattice, at).within(&rectangle);
                continue;
            };
            let closer = lattice.rectangle(widened(columns, cells), widened(rows, cells));
            let filled = |axis: usize| closer.size()[axis] > FILLED * rectangle.size()[axis];
            if !(filled(0) && filled(1)) {
                rectangle = closer;
            } else if has_several && cells < MOST_CELLS && is_coarse(&lattice, &depths) {
                cells *= 2;
            } else if depth > 0.0 {
                let inside = |cell: usize| depths[cell] > 0.0;
                let chords = mean_chords(&lattice, inside).unwrap_or(lattice.step);
                let overlapping = depths.iter().filter(|&&depth| depth > 0.0).count();
                let area = overlapping as f64 * lattice.cell_area();
                // About one of several wells the first look was lopsided.
                let rectangle = if has_several { closely(&lattice, &depths) } else { closer };
                return Ok(Self { rectangle, chords, area, depth });
            } else if improves {
                rectangle = around(&lattice, at).within(&rectangle);
            } else {
                break;
            }
        }
        let least_gap = (approach - deepest).min(gap.least().unwrap_or(f64::INFINITY));
        Err(NormalError::NoContact { approach, least_gap })
    }
}

/// The rectangle one cell beyond the ends of an overlap, which lie where depths between cells come to zero: it is the
/// same wherever one began to look, and a gap alike on both sides has elements alike.
fn closely(lattice: &Lattice, depths: &[f64]) -> Rectangle {
    let [columns, rows] = lattice.count;
    // From a cell's centre, in cells; the cell's own end at the border of what is looked at.
    let end = |cell: usize, next: Option<usize>| match next.map(|next| depths[next]) {
        Some(apart) if apart <= 0.0 => depths[cell] / (depths[cell] - apart),
        _ => 0.5,
    };
    let mut sides = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for cell in (0..depths.len()).filter(|&cell| depths[cell] > 0.0) {
        let (column, row) = (cell % columns, cell / columns);
        let places =
            [(lattice.x(column), column, columns, 1), (lattice.y(row), row, rows, columns)];
        for (axis, (at, index, count, stride)) in places.into_iter().enumerate() {
            let before = (index > 0).then(|| cell - stride);
            let after = (index + 1 < count).then_some(cell + stride);
            let [low, high] =
                [before, after].map(|next| (1.0 + end(cell, next)) * lattice.step[axis]);
            sides[axis] = [sides[axis][0].min(at - low), sides[axis][1].max(at + high)];
        }
    }
    let [x, y] = sides;
    Rectangle { x, y }
}

/// Whether few cells overlap across, so that another place of overlap may lie between them.
fn is_coarse(lattice: &Lattice, depths: &[f64]) -> bool {
    const FEW: f64 = 4.0;
    let chords = mean_chords(lattice, |cell| depths[cell] > 0.0);
    chords.is_none_or(|chords| (0..2).any(|axis| chords[axis] < FEW * lattice.step[axis]))
}

/// Whether a cell overlaps at its centre, or would if it went on as steeply as to a neighbour.
fn may_overlap(lattice: &Lattice, depths: &[f64], cell: usize) -> bool {
    let depth = depths[cell];
    if depth > 0.0 {
        return true;
    }
    let [columns, rows] = lattice.count;
    let (column, row) = (cell % columns, cell / columns);
    let reaches = |other: usize| depth + (depth - depths[other]).abs() > 0.0;
    (column > 0 && reaches(cell - 1))
        || (column + 1 < columns && reaches(cell + 1))
        || (row > 0 && reaches(cell - columns))
        || (row + 1 < rows && reaches(cell + columns))
}

fn greatest(depths: &[f64]) -> (usize, f64) {
    depths
        .iter()
        .copied()
        .enumerate()
        .fold((0, f64::NEG_INFINITY), |best, next| if next.1 > best.1 { next } else { best })
}

/// A cell with two neighbours on every side.
fn around(lattice: &Lattice, cell: usize) -> Rectangle {
    let centre = [cell % lattice.count[0], cell / lattice.count[0]];
    let [columns, rows] = [0, 1].map(|axis| {
        let first = centre[axis].saturating_sub(2);
        [first, (centre[axis] + 2).min(lattice.count[axis] - 1)]
    });
    lattice.rectangle(columns, rows)
}

/// One more on either side, inside the lattice.
pub(super) fn widened([first, last]: [usize; 2], count: usize) -> [usize; 2] {
    [first.saturating_sub(1), (last + 1).min(count - 1)]
}
