//! Slice of a table: look-up at one shape and one Poisson's ratio, then at creepages.

use crate::InvalidValue;
use crate::{Creepage, Force};

use super::axis::Window;
use super::coordinates::{Coordinates, Place};
use super::hermite::{Weights, cubic};
use super::in_memory::Table;
use super::slopes::Node;
use super::values::{MIRROR_X, MIRROR_Y};

/// A table at one ratio `a/b` and one Poisson's ratio.
#[derive(Debug, Clone, Copy)]
pub struct Slice<'a> {
    table: &'a Table,
    coordinates: Coordinates,
    shapes: Window,
    materials: Window,
}

/// A ratio of semi-axes and a Poisson's ratio placed in a table: prepared once, asked many times.
#[derive(Debug, Clone, Copy)]
pub struct Shape {
    coordinates: Coordinates,
    shapes: Window,
    materials: Window,
}

/// Of a component of the force: derived by neither angle, by `phi`, by `theta`, by both.
type Lanes = [f64; 4];

impl Table {
    /// The table at one ratio of semi-axes and one Poisson's ratio.
    ///
    /// # Errors
    /// [`InvalidValue`] when either is outside the table's range.
    #[inline]
    pub fn at(&self, a_over_b: f64, poisson: f64) -> Result<Slice<'_>, InvalidValue> {
        let shape = self.a_over_b.share_geometric("a_over_b", a_over_b, self.logarithms)?;
        let material = self.poisson.share_even("poisson", poisson)?;
        Ok(Slice::new(self, Coordinates::new(a_over_b), self.windows([shape, material])))
    }
}

impl Table {
    /// A ratio of semi-axes and a Poisson's ratio, prepared for [`Table::slice`].
    ///
    /// # Errors
    /// [`InvalidValue`] when either is outside the table's range.
    pub fn shape(&self, a_over_b: f64, poisson: f64) -> Result<Shape, InvalidValue> {
        let Slice { coordinates, shapes, materials, .. } = self.at(a_over_b, poisson)?;
        Ok(Shape { coordinates, shapes, materials })
    }

    /// The table at a place that [`Table::shape`] of this table prepared.
    ///
    /// # Panics
    /// Where another table prepared the shape and is larger than this one, the slice panics when asked.
    #[must_use]
    #[inline]
    pub fn slice(&self, shape: &Shape) -> Slice<'_> {
        let Shape { coordinates, shapes, materials } = *shape;
        Slice::new(self, coordinates, [shapes, materials])
    }
}

impl<'a> Slice<'a> {
    #[inline]
    pub(crate) fn new(
        table: &'a Table,
        coordinates: Coordinates,
        [shapes, materials]: [Window; 2],
    ) -> Self {
        Self { table, coordinates, shapes, materials }
    }

    /// Force and moment at `creepage`.
    #[must_use]
    pub fn force(&self, creepage: Creepage) -> Force {
        let place = self.coordinates.place(creepage);
        let [value] = self.interpolate(&place);
        reflected(creepage, place.mirror, value)
    }

    /// Force and moment at `creepage`, and the derivative of `(fx, fy, mz)` (rows) by
    /// `(xi, eta, chi)` (columns): that of the interpolation, without further error.
    #[must_use]
    pub fn force_and_derivative(&self, creepage: Creepage) -> (Force, [[f64; 3]; 3]) {
        let (place, by_creepage) = self.coordinates.place_and_slopes(creepage);
        let [value, slopes @ ..] = self.interpolate::<4>(&place);
        let sign = signs(place.mirror);
        let mut derivative = [[0.0; 3]; 3];
        for (i, row) in derivative.iter_mut().enumerate() {
            for (k, entry) in row.iter_mut().enumerate() {
                let along = (0..3).map(|q| slopes[q][i] * by_creepage[q][k]);
                *entry = sign[i] * along.sum::<f64>();
            }
        }
        if place.aside {
            return (self.force(creepage), derivative);
        }
        (reflected(creepage, place.mirror, value), derivative)
    }

    /// The first `N` of the value and its derivatives by `theta`, `phi` and `t`.
    #[inline]
    fn interpolate<const N: usize>(&self, place: &Place) -> [[f64; 3]; N] {
        let intervals = self.table.intervals;
        let [theta_axis, phi_axis] = &self.table.angles;
        let (i, by_theta, theta_slope) = theta_axis.weights(place.theta);
        let (j, by_phi, phi_slope) = phi_axis.weights(place.phi);
        let (k, by_t, t_slope) = cubic(place.t, intervals.t);
        let mut sums = [[[0.0; 4]; 3]; N];
        for p in 0..2 {
            for q in 0..2 {
                let index = intervals.index(i + p, j + q, k);
                let mixed;
                let pair = if self.table.blocks.len() == 1 {
                    &self.table.nodes[index..index + 2]
                } else {
                    mixed = [self.mixed(index), self.mixed(index + 1)];
                    &mixed
                };
                let values = along_t(pair, &by_t);
                let both = products(by_theta[p], by_phi[q]);
                add(&mut sums[0], both, &values);
                if N > 1 {
                    add(&mut sums[1], products(theta_slope[p], by_phi[q]), &values);
                    add(&mut sums[2], products(by_theta[p], phi_slope[q]), &values);
                    add(&mut sums[3], both, &along_t(pair, &t_slope));
                }
            }
        }
        closed(&sums)
    }

    /// A node as the weights of shape and Poisson's ratio mix it.
    #[inline]
    fn mixed(&self, index: usize) -> Node {
        let table = self.table;
        let mut mixed = Node::default();
        for (material, by_material) in self.materials.parts() {
            let row = index * table.blocks.len() + material * table.a_over_b.nodes;
            let first = row + self.shapes.first;
            let nodes = &table.nodes[first..first + self.shapes.count];
            for (node, by_shape) in nodes.iter().zip(&self.shapes.weights) {
                #[allow(clippy::cast_possible_truncation)] // as precise as the nodes
                let weight = (by_material * by_shape) as f32;
                let sums = mixed.as_flattened_mut().as_flattened_mut();
                for (sum, value) in sums.iter_mut().zip(node.as_flattened().as_flattened()) {
                    *sum += weight * value;
                }
            }
        }
        mixed
    }
}

/// Between two nodes along `t`.
#[inline]
fn along_t(pair: &[Node], weights: &Weights) -> [Lanes; 3] {
    let mut sums = [[0.0; 4]; 3];
    for (node, weights) in pair.iter().zip(weights) {
        for (sum, component) in sums.iter_mut().zip(node) {
            for (weight, values) in weights.iter().zip(component) {
                for (sum, value) in sum.iter_mut().zip(values) {
                    *sum += weight * f64::from(*value);
                }
            }
        }
    }
    sums
}

/// Weights of the value and of its derivatives by `phi`, by `theta` and by both.
#[inline]
fn products(theta: [f64; 2], phi: [f64; 2]) -> Lanes {
    [theta[0] * phi[0], theta[0] * phi[1], theta[1] * phi[0], theta[1] * phi[1]]
}

#[inline]
fn add(sums: &mut [Lanes; 3], weights: Lanes, values: &[Lanes; 3]) {
    for (sum, values) in sums.iter_mut().zip(values) {
        for lane in 0..4 {
            sum[lane] += weights[lane] * values[lane];
        }
    }
}

/// The sums over the lanes.
#[inline]
fn closed<const N: usize>(sums: &[[Lanes; 3]; N]) -> [[f64; 3]; N] {
    let mut closed = [[0.0; 3]; N];
    for (to, from) in closed.as_flattened_mut().iter_mut().zip(sums.as_flattened()) {
        *to = (from[0] + from[1]) + (from[2] + from[3]);
    }
    closed
}

/// The force of `creepage` from that of its mirror image; zero where it is its own.
fn reflected(creepage: Creepage, mirror: [f64; 2], value: [f64; 3]) -> Force {
    let Creepage { xi, eta, chi } = creepage;
    let [along, across] =
        [xi != 0.0, eta != 0.0 || chi != 0.0].map(|other| f64::from(u8::from(other)));
    let [x, y, z] = signs(mirror);
    Force { fx: along * x * value[0], fy: across * y * value[1], mz: across * z * value[2] }
}

fn signs([x, y]: [f64; 2]) -> [f64; 3] {
    let flip = |sign: f64, mirror: f64| if sign < 0.0 { mirror } else { 1.0 };
    [0, 1, 2].map(|i| flip(x, MIRROR_X[i]) * flip(y, MIRROR_Y[i]))
}
