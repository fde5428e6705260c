//! Table in memory, with its provenance.

use crate::InvalidValue;

use super::axis::{Axis, Logarithms, Window};
use super::coordinates::Coordinates;
use super::hermite::Angle;
use super::measure::Accuracy;
use super::slopes::{self, Node};
use super::values::{Intervals, Values};

/// Provenance of a table.
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
    /// `theta` and `phi`.
    pub(crate) angles: [Angle; 2],
    /// Node by node, of each all blocks: those of a look-up lie together.
    pub(crate) nodes: Vec<Node>,
    pub(crate) logarithms: Logarithms,
}

impl Table {
    pub(crate) fn new(
        provenance: Provenance,
        [a_over_b, poisson]: [Axis; 2],
        intervals: Intervals,
        blocks: Vec<Values>,
        accuracy: Accuracy,
    ) -> Self {
        let mut nodes = vec![Node::default(); blocks.len() * intervals.nodes()];
        let shapes = (0..poisson.nodes).flat_map(|_| a_over_b.shares());
        for (block, (values, share)) in blocks.iter().zip(shapes).enumerate() {
            let coordinates = Coordinates::new(a_over_b.geometric(share));
            let found = slopes::nodes(values, &coordinates, intervals);
            let places = nodes.iter_mut().skip(block).step_by(blocks.len());
            places.zip(found).for_each(|(place, node)| *place = node);
        }
        let angles = [intervals.theta_axis(), intervals.phi_axis()];
        let logarithms = a_over_b.logarithms();
        Self {
            provenance,
            a_over_b,
            poisson,
            intervals,
            accuracy,
            blocks,
            angles,
            nodes,
            logarithms,
        }
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
        let materials = self.poisson.window(share);
        let blocks = (0..self.a_over_b.nodes)
            .map(|shape| self.mixed([Window::only(shape), materials]))
            .collect();
        let axes = [self.a_over_b, Axis::fixed(poisson)];
        Ok(Self::new(self.provenance.clone(), axes, self.intervals, blocks, self.accuracy))
    }

    /// The blocks that count for a shape and a Poisson's ratio, given by their shares.
    pub(crate) fn windows(&self, [a_over_b, poisson]: [f64; 2]) -> [Window; 2] {
        [self.a_over_b.window(a_over_b), self.poisson.window(poisson)]
    }

    /// The forces of blocks, mixed.
    pub(crate) fn mixed(&self, [shapes, materials]: [Window; 2]) -> Values {
        Values::mixed(materials.parts().flat_map(|(material, by_material)| {
            shapes.parts().map(move |(shape, by_shape)| {
                let block = material * self.a_over_b.nodes + shape;
                (&self.blocks[block], by_material * by_shape)
            })
        }))
    }
}
