//! Search for the cells where the force bends most from node to node, and so a table errs most.

use super::values::{Intervals, Values};

/// The `count` cells about whose corners fourth differences of the force are largest: `theta`,
/// `phi` and `t` of the corner before each.
///
/// The error of interpolation is in proportion to these where the force is smooth, and largest
/// where it is not.
pub(crate) fn cells(values: &Values, intervals: Intervals, count: usize) -> Vec<[usize; 3]> {
    let bends = bends(&values.forces, intervals);
    let worst = |[theta, phi, t]: [usize; 3]| {
        let corner = |n: usize| intervals.index(theta + (n & 1), phi + (n >> 1 & 1), t + (n >> 2));
        (0..8).map(|n| bends[corner(n)]).fold(0.0, f64::max)
    };
    let mut cells: Vec<([usize; 3], f64)> =
        places([intervals.theta, intervals.phi, intervals.t]).map(|at| (at, worst(at))).collect();
    cells.sort_by(|one, other| other.1.total_cmp(&one.1));
    cells.into_iter().map(|(cell, _)| cell).take(count).collect()
}

/// Of each node the sum of fourth differences along `theta`, `phi` and `t`, where near an end
/// those of the first or last five nodes.
fn bends(forces: &[[f64; 3]], intervals: Intervals) -> Vec<f64> {
    let ends = [intervals.theta, intervals.phi, intervals.t];
    let bend = |at: [usize; 3], axis: usize| {
        let first = at[axis].saturating_sub(2).min(ends[axis] - 4);
        let node = |offset| {
            let mut place = at;
            place[axis] = first + offset;
            forces[intervals.index(place[0], place[1], place[2])]
        };
        let nodes = [0, 1, 2, 3, 4].map(node);
        let difference = |i: usize| {
            let [a, b, c, d, e] = nodes.map(|force| force[i]);
            (a + e - 4.0 * (b + d) + 6.0 * c).abs()
        };
        (0..3).map(difference).fold(0.0, f64::max)
    };
    places(ends.map(|end| end + 1)).map(|at| (0..3).map(|axis| bend(at, axis)).sum()).collect()
}

/// All places of a box, as nodes are ordered.
fn places([theta, phi, t]: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    (0..theta).flat_map(move |i| (0..phi).flat_map(move |j| (0..t).map(move |k| [i, j, k])))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A kink is seen in the cells beside it, and nowhere else.
    #[test]
    fn the_cells_of_a_kink_come_first() {
        let intervals = Intervals { theta: 6, phi: 8, t: 12 };
        let force = |[theta, phi, t]: [usize; 3]| {
            let smooth = theta as f64 - 0.5 * phi as f64;
            [smooth, smooth, (t as f64 - 7.0).abs()]
        };
        let forces = places([7, 9, 13]).map(force).collect();
        let values = Values { forces, gains: [[0.0; 3]; 3], doubtful: 0 };
        let found = cells(&values, intervals, 6 * 8 * 2);
        assert!(found.iter().all(|[.., t]| *t == 6 || *t == 7), "{found:?}");
    }
}
