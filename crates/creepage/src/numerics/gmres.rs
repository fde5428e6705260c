//! GMRES (Saad and Schultz 1986) for the fixed point of an affine map; room for a direction is made when it is
//! first needed.

/// Directions that are combined before it restarts from what they gave.
const KRYLOV_DIMENSION: usize = 40;
const RESTARTS: usize = 5;

/// Evaluate the affine map, or its linear part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Part {
    Whole,
    /// Without the constant.
    Linear,
}

#[derive(Debug, Clone, Default)]
pub(crate) struct Gmres {
    /// Orthonormal directions.
    directions: Vec<Vec<f64>>,
    /// Column `k`: `direction k - its image`, by the directions; after rotation, triangular.
    columns: Vec<Vec<f64>>,
    /// Cosine and sine of the rotations that make it triangular.
    rotations: Vec<[f64; 2]>,
    right: Vec<f64>,
}

impl Gmres {
    pub(crate) fn new(unknowns: usize) -> Self {
        Self {
            directions: vec![vec![0.0; unknowns]],
            columns: vec![vec![0.0; KRYLOV_DIMENSION + 1]; KRYLOV_DIMENSION],
            rotations: vec![[0.0; 2]; KRYLOV_DIMENSION],
            right: vec![0.0; KRYLOV_DIMENSION + 1],
        }
    }

    /// Improves `x` until the map moves it by `accuracy` times as far as at first.
    /// `map(part, from, to)` fills `to` with the image of `from`.
    pub(crate) fn fixed_point(
        &mut self,
        x: &mut [f64],
        accuracy: f64,
        mut map: impl FnMut(Part, &[f64], &mut [f64]),
    ) {
        let mut goal = 0.0;
        for restart in 0..RESTARTS {
            let first = &mut self.directions[0];
            map(Part::Whole, x, first);
            first.iter_mut().zip(&*x).for_each(|(first, x)| *first -= x);
            let size = norm(first);
            if restart == 0 {
                goal = accuracy * size;
            }
            if size.is_nan() || size <= goal {
                return;
            }
            scale(first, 1.0 / size);
            self.right[0] = size;
            let count = self.explore(goal, &mut map);
            self.combine(count, x);
            if self.right[count].abs() <= goal {
                return;
            }
        }
    }

    /// Adds directions until a combination of them comes near enough; their number.
    fn explore(&mut self, goal: f64, map: &mut impl FnMut(Part, &[f64], &mut [f64])) -> usize {
        for k in 0..KRYLOV_DIMENSION {
            if self.directions.len() == k + 1 {
                self.directions.push(vec![0.0; self.directions[k].len()]);
            }
            let (known, next) = self.directions.split_at_mut(k + 1);
            let next = &mut next[0];
            map(Part::Linear, &known[k], next);
            next.iter_mut().zip(&known[k]).for_each(|(next, v)| *next = v - *next);
            let column = &mut self.columns[k];
            for (entry, direction) in column.iter_mut().zip(&*known) {
                *entry = dot(direction, next);
                next.iter_mut().zip(direction).for_each(|(next, v)| *next -= *entry * v);
            }
            column[k + 1] = norm(next);
            if column[k + 1] > 0.0 {
                scale(next, 1.0 / column[k + 1]);
            }
            self.rotate(k);
            if self.right[k + 1].is_nan() || self.right[k + 1].abs() <= goal {
                return k + 1;
            }
        }
        KRYLOV_DIMENSION
    }

    /// Makes column `k` triangular.
    fn rotate(&mut self, k: usize) {
        let column = &mut self.columns[k];
        for (i, [cos, sin]) in self.rotations.iter().take(k).enumerate() {
            let [p, q] = [column[i], column[i + 1]];
            column[i] = cos * p + sin * q;
            column[i + 1] = cos * q - sin * p;
        }
        let size = column[k].hypot(column[k + 1]);
        let [cos, sin] = [column[k] / size, column[k + 1] / size];
        self.rotations[k] = [cos, sin];
        column[k] = size;
        self.right[k + 1] = -sin * self.right[k];
        self.right[k] *= cos;
    }

    /// Adds to `x` the combination of `count` directions that the map moves least.
    fn combine(&mut self, count: usize, x: &mut [f64]) {
        for k in (0..count).rev() {
            let weight = self.right[k] / self.columns[k][k];
            for i in 0..k {
                self.right[i] -= weight * self.columns[k][i];
            }
            x.iter_mut().zip(&self.directions[k]).for_each(|(x, v)| *x += weight * v);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn scale(a: &mut [f64], by: f64) {
    for a in a {
        *a *= by;
    }
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A map that expands, which iteration would leave: as many directions as unknowns solve it.
    #[test]
    fn finds_the_fixed_point_of_a_map_that_expands() {
        let matrix = [[1.9, 0.2, -0.4], [-0.1, 0.8, 2.0], [0.5, -1.5, -0.7]];
        let constant = [1.0, 2.0, -0.5];
        let map = |part, from: &[f64], to: &mut [f64]| {
            for i in 0..3 {
                to[i] = dot(&matrix[i], from) + if part == Part::Whole { constant[i] } else { 0.0 };
            }
        };
        let mut x = [0.0; 3];
        Gmres::new(3).fixed_point(&mut x, 1e-14, map);
        let mut image = [0.0; 3];
        map(Part::Whole, &x, &mut image);
        for (x, image) in x.iter().zip(image) {
            // Rounding times a condition number of order ten.
            assert!((x - image).abs() < 1e-13, "{x} {image}");
        }
    }
}
