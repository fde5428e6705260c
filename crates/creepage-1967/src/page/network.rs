//! The points of the mesh as a network: its lines and columns, and the connected areas.

use creepage::Region;
use creepage::variational::MeshPoint;

/// A point of the network.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Cell {
    /// Column and line, counted from the middle as on the page.
    pub(super) place: [isize; 2],
    pub(super) region: Region,
    pub(super) aberrant: bool,
    /// Number of its area of adhesion, or minus that of its area of slip; counted from 1.
    pub(super) area: isize,
}

/// The mesh with its areas.
#[derive(Debug)]
pub(super) struct Network {
    columns: usize,
    /// Line by line; `None` outside the ellipse.
    cells: Vec<Option<Cell>>,
}

impl Network {
    /// From the places `(x/a, y/b)` of the points.
    // Places lie between -1 and 1, so that columns and lines lie between 0 and their number.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub(super) fn new(
        mesh @ [columns, lines]: [usize; 2],
        places: impl Iterator<Item = [f64; 2]>,
        points: &[MeshPoint],
    ) -> Self {
        let mut cells = vec![None; columns * lines];
        for (place, point) in places.zip(points) {
            let at = |i: usize| {
                let cell = (0.5 * (place[i] + 1.0) * mesh[i] as f64) as usize;
                cell.min(mesh[i] - 1)
            };
            let middle = |i: usize| ((mesh[i] - 1) / 2).cast_signed();
            cells[at(0) + columns * at(1)] = Some(Cell {
                place: [at(0).cast_signed() - middle(0), at(1).cast_signed() - middle(1)],
                region: point.field.region,
                aberrant: point.aberrant,
                area: 0,
            });
        }
        let mut network = Self { columns, cells };
        network.number_areas();
        network
    }

    /// The lines from `-y`, each from `-x`, with their number.
    pub(super) fn lines(&self) -> impl Iterator<Item = (isize, &[Option<Cell>])> {
        let middle = ((self.cells.len() / self.columns - 1) / 2).cast_signed();
        self.cells
            .chunks(self.columns)
            .enumerate()
            .map(move |(line, cells)| (line.cast_signed() - middle, cells))
    }

    /// The place of each point, in the order of the solution's points.
    pub(super) fn places(&self) -> impl Iterator<Item = [isize; 2]> {
        self.cells.iter().flatten().map(|cell| cell.place)
    }

    /// Number of connected areas of slip, and of adhesion.
    pub(super) fn areas(&self) -> [isize; 2] {
        let areas = self.cells.iter().flatten().map(|cell| cell.area);
        areas.fold([0; 2], |[slip, adhesion], area| [slip.max(-area), adhesion.max(area)])
    }

    /// Number of points in the areas of adhesion.
    pub(super) fn adhering(&self) -> usize {
        self.cells.iter().flatten().filter(|cell| cell.region == Region::Adhesion).count()
    }

    fn number_areas(&mut self) {
        for start in 0..self.cells.len() {
            let Some(Cell { area: 0, region, .. }) = self.cells[start] else { continue };
            let [slip, adhesion] = self.areas();
            let number = if region == Region::Slip { -slip - 1 } else { adhesion + 1 };
            self.fill(start, region, number);
        }
    }

    /// Gives `number` to all points of `region` that are connected to `start` along the lines
    /// and columns.
    fn fill(&mut self, start: usize, region: Region, number: isize) {
        let mut left = vec![start];
        while let Some(at) = left.pop() {
            let Some(Some(cell)) = self.cells.get_mut(at) else { continue };
            if cell.area != 0 || cell.region != region {
                continue;
            }
            cell.area = number;
            let column = at % self.columns;
            left.extend((column > 0).then(|| at - 1));
            left.extend((column + 1 < self.columns).then_some(at + 1));
            left.extend(at.checked_sub(self.columns));
            left.push(at + self.columns);
        }
    }
}
