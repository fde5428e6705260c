//! A table in memory, and how it is asked.

use creepage::InvalidValue;
use creepage::rolling::{Creepage, Force};

use crate::accuracy::Accuracy;
use crate::axis::Axis;
use crate::coordinates::Coordinates;
use crate::hermite::{Angle, Weights, cubic};
use crate::slopes::{self, Node};
use crate::values::{Intervals, MIRROR_X, MIRROR_Y, Values};

/// Where a table comes from.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Provenance {
    /// Name of the theory.
    pub theory: String,
    /// Its options, as a person would write them; may be empty.
    pub options: String,
    /// Program and version that built the table.
    pub program: String,
}

/// Creep force of one theory over the shape of the contact, Poisson's ratio, creepage and spin.
#[derive(Debug, Clone)]
pub struct Table {
    pub(crate) provenance: Provenance,
    pub(crate) a_over_b: Axis,
    pub(crate) poisson: Axis,
    pub(crate) intervals: Intervals,
    pub(crate) accuracy: Accuracy,
    /// Poisson's ratio by Poisson's ratio, each ratio `a/b` by ratio.
    pub(crate) blocks: Vec<Values>,
    angles: [Angle; 2],
    /// Of all blocks.
    nodes: Vec<Node>,
}

/// A table at one ratio `a/b` and one Poisson's ratio.
#[derive(Debug, Clone, Copy)]
pub struct Slice<'a> {
    table: &'a Table,
    coordinates: Coordinates,
    /// First node of each block that counts, and its weight.
    blocks: [(usize, f32); 16],
    count: usize,
}

type Lanes = [f64; 4];

impl Table {
    pub(crate) fn new(
        provenance: Provenance,
        [a_over_b, poisson]: [Axis; 2],
        intervals: Intervals,
        blocks: Vec<Values>,
        accuracy: Accuracy,
    ) -> Self {
        let shapes = (0..poisson.nodes).flat_map(|_| a_over_b.shares());
        let nodes = blocks
            .iter()
            .zip(shapes)
            .flat_map(|(values, share)| {
                let coordinates = Coordinates::new(a_over_b.geometric(share));
                slopes::nodes(values, &coordinates, intervals)
            })
            .collect();
        let angles = [intervals.theta_axis(), intervals.phi_axis()];
        Self { provenance, a_over_b, poisson, intervals, accuracy, blocks, angles, nodes }
    }

    /// Where the table comes from.
    #[must_use]
    pub fn provenance(&self) -> &Provenance {
        &self.provenance
    }

    /// The range of `a/b`.
    #[must_use]
    pub fn a_over_b(&self) -> Axis {
        self.a_over_b
    }

    /// The range of Poisson's ratio.
    #[must_use]
    pub fn poisson(&self) -> Axis {
        self.poisson
    }

    /// Number of intervals in creepage and spin.
    #[must_use]
    pub fn intervals(&self) -> Intervals {
        self.intervals
    }

    /// The error against the theory, as measured when the table was built.
    #[must_use]
    pub fn accuracy(&self) -> Accuracy {
        self.accuracy
    }

    /// Nodes at which the theory did not call its force solved.
    #[must_use]
    pub fn doubtful(&self) -> usize {
        self.blocks.iter().map(|block| block.doubtful).sum()
    }

    /// The table for one Poisson's ratio, as a simulation of given materials needs: look-ups in it
    /// mix four blocks at most, not sixteen.
    ///
    /// # Errors
    /// [`InvalidValue`] when `poisson` is outside the table's range.
    pub fn with_poisson(&self, poisson: f64) -> Result<Self, InvalidValue> {
        let share = self.poisson.share_even("poisson", poisson)?;
        let (materials, weights) = self.poisson.weights(share);
        let shapes = self.a_over_b.nodes;
        let mixed = |shape| {
            let parts = materials.map(|material| &self.blocks[material * shapes + shape]);
            Values::mixed(parts.into_iter().zip(weights))
        };
        let blocks = (0..shapes).map(mixed).collect();
        let axes = [self.a_over_b, Axis::fixed(poisson)];
        Ok(Self::new(self.provenance.clone(), axes, self.intervals, blocks, self.accuracy))
    }

    /// The table at one ratio of semi-axes and one Poisson's ratio.
    ///
    /// # Errors
    /// [`InvalidValue`] when either is outside the table's range.
    pub fn at(&self, a_over_b: f64, poisson: f64) -> Result<Slice<'_>, InvalidValue> {
        let share = self.a_over_b.share_geometric("a_over_b", a_over_b)?;
        let (shapes, shape_weights) = self.a_over_b.weights(share);
        let share = self.poisson.share_even("poisson", poisson)?;
        let (materials, material_weights) = self.poisson.weights(share);
        let mut blocks = [(0, 0.0); 16];
        let mut count = 0;
        for (material, by_material) in materials.into_iter().zip(material_weights) {
            for (shape, by_shape) in shapes.into_iter().zip(shape_weights) {
                let weight = by_material * by_shape;
                if weight != 0.0 {
                    let block = material * self.a_over_b.nodes + shape;
                    #[allow(clippy::cast_possible_truncation)] // as precise as the nodes
                    let weight = weight as f32;
                    blocks[count] = (block * self.intervals.nodes(), weight);
                    count += 1;
                }
            }
        }
        Ok(Slice { table: self, coordinates: Coordinates::new(a_over_b), blocks, count })
    }
}

impl Slice<'_> {
    /// Force and moment at `creepage`.
    #[must_use]
    pub fn force(&self, creepage: Creepage) -> Force {
        let place = self.coordinates.place(creepage);
        let [value, ..] = self.interpolate::<false>(place.at);
        reflected(creepage, place.mirror, value)
    }

    /// Force and moment at `creepage`, and the derivative of `(fx, fy, mz)` (rows) by
    /// `(xi, eta, chi)` (columns): that of the interpolation, without further error.
    #[must_use]
    pub fn force_and_derivative(&self, creepage: Creepage) -> (Force, [[f64; 3]; 3]) {
        let (place, by_creepage) = self.coordinates.place_and_slopes(creepage);
        let [value, slopes @ ..] = self.interpolate::<true>(place.at);
        let sign = signs(place.mirror);
        let derivative = [0, 1, 2].map(|i| {
            [0, 1, 2].map(|k| {
                let along = (0..3).map(|q| slopes[q][i] * by_creepage[q][k]);
                sign[i] * along.sum::<f64>()
            })
        });
        if place.aside {
            return (self.force(creepage), derivative);
        }
        (reflected(creepage, place.mirror, value), derivative)
    }

    /// Value and derivatives by `theta`, `phi` and `t`; the latter zero unless `SLOPES`.
    fn interpolate<const SLOPES: bool>(&self, [theta, phi, t]: [f64; 3]) -> [Lanes; 4] {
        let intervals = self.table.intervals;
        let (i, by_theta, theta_slope) = self.table.angles[0].weights(theta);
        let (j, by_phi, phi_slope) = self.table.angles[1].weights(phi);
        let (k, by_t, t_slope) = cubic(t, intervals.t);
        let mut result = [[0.0; 4]; 4];
        for p in 0..2 {
            let mut row = [[[0.0; 4]; 3]; 2];
            for q in 0..2 {
                let index = intervals.index(i + p, j + q, k);
                let mixed;
                let pair = if self.count == 1 {
                    self.pair(self.blocks[0].0 + index)
                } else {
                    mixed = self.blended(index);
                    &mixed
                };
                let values = if SLOPES { along_t(pair, &by_t) } else { along_t_apart(pair, &by_t) };
                let slopes = if SLOPES { along_t(pair, &t_slope) } else { [[0.0; 4]; 4] };
                for (derived, row) in row.iter_mut().enumerate() {
                    for n in 0..2 {
                        let value = values[2 * derived + n];
                        add(&mut row[0], by_phi[q][n], value);
                        if SLOPES {
                            add(&mut row[1], phi_slope[q][n], value);
                            add(&mut row[2], by_phi[q][n], slopes[2 * derived + n]);
                        }
                    }
                }
            }
            for (derived, [value, by_phi, by_t]) in row.into_iter().enumerate() {
                add(&mut result[0], by_theta[p][derived], value);
                if SLOPES {
                    add(&mut result[1], theta_slope[p][derived], value);
                    add(&mut result[2], by_theta[p][derived], by_phi);
                    add(&mut result[3], by_theta[p][derived], by_t);
                }
            }
        }
        result
    }

    /// Two nodes that follow each other along `t`, as the blocks' weights mix them.
    fn blended(&self, index: usize) -> [Node; 2] {
        let mut mixed = [[[0.0; 4]; 8]; 2];
        let sums = mixed.as_flattened_mut().as_flattened_mut();
        for &(first, weight) in &self.blocks[..self.count] {
            let pair = self.pair(first + index);
            for (sum, value) in sums.iter_mut().zip(pair.as_flattened().as_flattened()) {
                *sum += weight * value;
            }
        }
        mixed
    }

    /// A node and the next along `t`.
    fn pair(&self, index: usize) -> &[Node] {
        &self.table.nodes[index..index + 2]
    }
}

/// Between two nodes along `t`: the force and its derivatives by the angles.
#[allow(clippy::inline_always)] // a tenth of a look-up with derivatives
#[inline(always)]
fn along_t(pair: &[Node], weights: &Weights) -> [Lanes; 4] {
    let mut sums = [[0.0; 4]; 4];
    for (node, [value, slope]) in pair.iter().zip(weights) {
        for (derived, sum) in sums.iter_mut().enumerate() {
            add(sum, *value, node[2 * derived].map(f64::from));
            add(sum, *slope, node[2 * derived + 1].map(f64::from));
        }
    }
    sums
}

/// For the force alone: inlined, the compiler makes vectors across the derivatives instead of
/// along the lanes, which is slower.
#[inline(never)]
fn along_t_apart(pair: &[Node], weights: &Weights) -> [Lanes; 4] {
    along_t(pair, weights)
}

fn add(sum: &mut Lanes, weight: f64, value: Lanes) {
    for (sum, value) in sum.iter_mut().zip(value) {
        *sum += weight * value;
    }
}

/// The force of `creepage` from that of its mirror image; zero where it is its own.
fn reflected(creepage: Creepage, mirror: [f64; 2], value: Lanes) -> Force {
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
