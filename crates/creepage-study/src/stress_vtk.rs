//! `stresses.vtk`: the stresses in a block of the body, for `ParaView` and others that read VTK's legacy
//! format.

use std::fmt::Write as _;

use crate::stresses::{StressError, StressPoint, Stresses};

/// Points along, across and down.
const GRID_POINTS: [u32; 3] = [41, 21, 21];

impl Stresses {
    /// A block from `-2a` to `2a`, `-1.5b` to `1.5b` and down to `2a`, from the depth where the stresses
    /// have settled: along `x` first, then `y`, then down.
    ///
    /// # Errors
    /// As [`Stresses::at`]; none.
    pub fn block(&self) -> Result<Vec<StressPoint>, StressError> {
        let [low, high] = self.corners();
        let at = |axis: usize, k: u32| {
            low[axis] + (high[axis] - low[axis]) * f64::from(k) / f64::from(GRID_POINTS[axis] - 1)
        };
        let rows = (0..GRID_POINTS[2]).flat_map(|k| (0..GRID_POINTS[1]).map(move |j| (j, k)));
        let points = rows
            .flat_map(|(j, k)| (0..GRID_POINTS[0]).map(move |i| [at(0, i), at(1, j), at(2, k)]));
        self.at(&points.collect::<Vec<_>>())
    }

    fn corners(&self) -> [[f64; 3]; 2] {
        let [[x, y], [a, b]] = self.solved.box_around();
        let (a, b) = (2.0 * a, 1.5 * b);
        [[x - a, y - b, self.settled_depth()], [x + a, y + b, a]]
    }

    /// The block as VTK, in SI units, `z` from the surface into the body.
    #[must_use]
    pub fn vtk(&self, block: &[StressPoint]) -> String {
        let [low, high] = self.corners();
        let step = |axis: usize| (high[axis] - low[axis]) / f64::from(GRID_POINTS[axis] - 1);
        let [along, across, down] = GRID_POINTS;
        let mut vtk = format!(
            "# vtk DataFile Version 3.0\n\
             creepage {}: theory {}; stresses in the {} body, z into it, SI units\n\
             ASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS {along} {across} {down}\n\
             ORIGIN {:e} {:e} {:e}\nSPACING {:e} {:e} {:e}\nPOINT_DATA {}\n",
            env!("CARGO_PKG_VERSION"),
            self.solved.theory.name,
            self.body(),
            low[0],
            low[1],
            low[2],
            step(0),
            step(1),
            step(2),
            block.len()
        );
        // Writing to a String cannot fail.
        for (name, of) in
            [("von_mises_pa", von_mises as fn(&StressPoint) -> f64), ("tresca_pa", tresca)]
        {
            let _ = writeln!(vtk, "SCALARS {name} float 1\nLOOKUP_TABLE default");
            for point in block {
                let _ = writeln!(vtk, "{:e}", single(of(point)));
            }
        }
        let _ = writeln!(vtk, "TENSORS stress_pa float");
        for point in block {
            let [xx, yy, zz, xy, yz, xz] = point.stress.components();
            for row in [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]] {
                let [x, y, z] = row.map(single);
                let _ = writeln!(vtk, "{x:e} {y:e} {z:e}");
            }
        }
        vtk
    }
}

fn von_mises(point: &StressPoint) -> f64 {
    point.stress.von_mises()
}

fn tresca(point: &StressPoint) -> f64 {
    point.stress.tresca()
}

/// Seven digits are enough for pictures.
#[allow(clippy::cast_possible_truncation)]
fn single(value: f64) -> f32 {
    value as f32
}
