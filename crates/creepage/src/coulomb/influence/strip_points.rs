//! Displacements at the points of one strip after the other, by unit tractions of every element.

use std::ops::Range;

use super::coefficients::Folded;
use super::layout::Layout;
use crate::coulomb::boussinesq_cerruti::Cuts;
use crate::coulomb::mesh::Mesh;

/// The points of one strip after the other, in the order of its stencil.
pub(super) struct StripPoints {
    cuts: Cuts,
    poisson: f64,
    /// In `x` by `x`; in `x` by `y` and in `y` by `x`; in `y` by `y`.
    by: [Vec<f64>; 3],
    /// Their parts at the point before and here.
    pub(super) folded: [Folded; 2],
    /// The strip and its mirror image.
    strips: [Range<usize>; 2],
    /// The displacements by these two, at all points.
    pub(super) blocks: [[Vec<f64>; 2]; 3],
}

impl StripPoints {
    pub(super) fn new(mesh: &Mesh, poisson: f64, units: Vec<f64>, layout: &Layout) -> Self {
        Self {
            cuts: Cuts::new(mesh, units),
            poisson,
            by: std::array::from_fn(|_| vec![0.0; mesh.len()]),
            folded: [(); 2].map(|()| Folded::new(layout)),
            strips: [0..0, 0..0],
            blocks: Default::default(),
        }
    }

    /// Starts with a strip.
    pub(super) fn start(&mut self, layout: &Layout, strip: usize) {
        self.strips = [strip, layout.image(strip)].map(|strip| layout.elements(strip));
        self.blocks.as_flattened_mut().iter_mut().for_each(Vec::clear);
    }

    /// Goes on to a point.
    pub(super) fn displace(&mut self, layout: &Layout, at: [f64; 2]) {
        self.cuts.displace(self.poisson, at, self.by.each_mut().map(Vec::as_mut_slice));
        for (blocks, by) in self.blocks.iter_mut().zip(&self.by) {
            for (block, elements) in blocks.iter_mut().zip(&self.strips) {
                block.extend_from_slice(&by[elements.clone()]);
            }
        }
        self.fold(layout);
    }

    /// Goes on to the mirror image of the last point fore and aft.
    pub(super) fn mirror(&mut self, layout: &Layout) {
        for strip in 0..layout.elements.len() - 1 {
            let elements = layout.elements(strip);
            self.by.iter_mut().for_each(|by| by[elements.clone()].reverse());
        }
        self.by[1].iter_mut().for_each(|by| *by = -*by);
        self.fold(layout);
    }

    fn fold(&mut self, layout: &Layout) {
        self.folded.swap(0, 1);
        self.folded[1].set(layout, self.by.each_ref().map(Vec::as_slice));
    }

    /// Completes the blocks of the first of some points with those of their mirror images: a traction across
    /// moves these forward by as much as those back.
    pub(super) fn finish(&mut self, seen: usize, points: usize) {
        for (blocks, sign) in self.blocks.iter_mut().zip([1.0, -1.0, 1.0]) {
            for (block, elements) in blocks.iter_mut().zip(&self.strips) {
                for k in seen..points {
                    let image = (points - k) * elements.len();
                    let reversed = (image..image + elements.len()).rev();
                    reversed.for_each(|entry| block.push(sign * block[entry]));
                }
            }
        }
    }
}
