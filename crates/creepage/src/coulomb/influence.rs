//! Influence matrix: the elastic slip of every element by the traction of every other.
//!
//! What is kept are the steps of displacement along each strip: those of the rear half are, in mirrored order,
//! the steps of the front half where the contact is its own mirror image fore and aft, and those of the
//! upper strips the steps of the lower ones where it is so across; see [`layout`]. Nothing outside of this
//! folder depends on that, but that a strip and its mirror image are gone through together.

mod coefficients;
mod layout;
mod points;
mod strip_points;
mod tractions;

use std::ops::Range;

use super::mesh::Mesh;
use super::product::{Block, Product, Row};
use super::stencil::SlipStencil;
use coefficients::{Coefficients, Folded};
use layout::{Layout, Symmetry, unfold};
pub(crate) use points::Displacements;
use strip_points::StripPoints;
pub(crate) use tractions::Tractions;

/// Precision of slip: sweeps only come near a solution, at twice the speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) enum Precision {
    #[default]
    Single,
    Double,
}

/// Coefficients of the slip of each element.
#[derive(Debug, Clone)]
pub(crate) struct Influence {
    coefficients: Coefficients,
    layout: Layout,
    /// First row of every kept strip, and the number of all.
    rows: Vec<usize>,
    /// Factors of the step at each element of a kept strip and of the one before in its slip.
    weights: Vec<[f64; 2]>,
    /// Where the blocks of every kept strip begin: of itself, then of its mirror image.
    blocks: Vec<usize>,
}

impl Influence {
    /// Slip by tractions over `units`, one an element, in units of `pi G`; `stencils` are those of the
    /// strips.
    pub(crate) fn new(
        mesh: &Mesh,
        poisson: f64,
        stencils: &[SlipStencil],
        units: Vec<f64>,
    ) -> Self {
        let symmetry = Symmetry::new(mesh.is_like_reversed(&units), mesh.mirrored);
        let layout = Layout::new(symmetry, mesh.offsets());
        let kept = 0..layout.kept();
        let count = |strip: usize| mesh.strips[strip].len();
        let rows = starts(kept.clone().map(|strip| kept_steps(symmetry, count(strip))));
        let blocks = starts(kept.clone().map(|strip| 2 * count(strip).pow(2)));
        let size = rows[layout.kept()] * 3 * layout.entries();
        let coefficients = Coefficients::with_length(size, blocks[layout.kept()]);
        let weights = stencils[kept.clone()].iter().flat_map(SlipStencil::of_steps).collect();
        let mut influence = Self { coefficients, layout, rows, weights, blocks };
        let mut points = StripPoints::new(mesh, poisson, units, &influence.layout);
        for (strip, stencil) in kept.zip(stencils) {
            influence.set_rows(strip, &stencil.points, &mut points);
            influence.set_blocks(strip, stencil, &points);
        }
        influence
    }

    /// Sets the rows of a kept strip by the displacements at its points.
    fn set_rows(&mut self, strip: usize, at: &[[f64; 2]], points: &mut StripPoints) {
        let Self { coefficients, layout, rows, .. } = self;
        let length = 3 * layout.entries();
        points.start(layout, strip);
        points.displace(layout, at[0]);
        let range = rows[strip] * length..rows[strip + 1] * length;
        let seen = if layout.symmetry.is_along() { 1 + at.len() / 2 } else { at.len() };
        for (k, row) in (1..).zip(coefficients.rows[range].chunks_exact_mut(length)) {
            if k < seen {
                points.displace(layout, at[k]);
            } else {
                points.mirror(layout);
            }
            let [before, here] = &points.folded;
            before.put_less(here, layout, row);
        }
        points.finish(seen, at.len());
    }

    /// Sets the slip of a kept strip's elements by its own tractions, and by those of its mirror image.
    fn set_blocks(&mut self, strip: usize, stencil: &SlipStencil, points: &StripPoints) {
        let n = self.layout.elements(strip).len();
        let blocks = self.blocks[strip]..self.blocks[strip + 1];
        for (to, from) in self.coefficients.blocks.iter_mut().zip(&points.blocks) {
            let from = from.each_ref().map(|of| of.chunks_exact(n).collect::<Vec<_>>());
            let rows = from.iter().flat_map(|of| stencil.weights.iter().map(move |w| (of, w)));
            for (to, (of, weights)) in to[blocks.clone()].chunks_exact_mut(n).zip(rows) {
                let [(a, wa), (b, wb), (c, wc)] = *weights;
                let entries = to.iter_mut().zip(of[a].iter().zip(of[b]).zip(of[c]));
                entries.for_each(|(to, ((a, b), c))| *to = wa * a + wb * b + wc * c);
            }
        }
    }

    /// The same where every element moves the surface at itself, and nowhere else, by `own` more.
    pub(crate) fn with_own_displacements(mut self, stencils: &[SlipStencil], own: &[f64]) -> Self {
        let Self { coefficients, layout, rows, blocks, .. } = &mut self;
        let length = 3 * layout.entries();
        let [mut folded, none] = [(); 2].map(|()| Folded::new(layout));
        let [mut more, zeros] = [(); 2].map(|()| vec![0.0; layout.len()]);
        let mut row_of_own = vec![0.0; length];
        for strip in 0..layout.kept() {
            let elements = layout.elements(strip);
            for (step, row) in (rows[strip]..rows[strip + 1]).enumerate() {
                // Point 0 is the leading edge, then comes the centre of each element.
                let here = elements.start + step;
                more.fill(0.0);
                more[here] = -own[here];
                if step > 0 {
                    more[here - 1] = own[here - 1];
                }
                folded.set(layout, [&more, &zeros, &more]);
                folded.put_less(&none, layout, &mut row_of_own);
                let row = &mut coefficients.rows[row * length..(row + 1) * length];
                row.iter_mut().zip(&row_of_own).for_each(|(row, more): (&mut f32, _)| *row += more);
            }
            for (i, weights) in stencils[strip].weights.iter().enumerate() {
                for (point, weight) in weights.iter().filter(|(point, _)| *point > 0) {
                    let entry = blocks[strip] + i * elements.len() + point - 1;
                    let more = weight * own[elements.start + point - 1];
                    coefficients.blocks[0][entry] += more;
                    coefficients.blocks[2][entry] += more;
                }
            }
        }
        self
    }

    /// Strips that are to be gone through, each with its mirror image.
    pub(crate) fn strips(&self) -> usize {
        self.layout.kept()
    }

    /// The mirror image of a strip, where it is another strip and shares the coefficients.
    pub(crate) fn image(&self, strip: usize) -> Option<usize> {
        let image = self.layout.image(strip);
        (image != strip).then_some(image)
    }

    /// Computes the slip of every element of a strip and of its mirror image.
    pub(crate) fn slip(
        &self,
        precision: Precision,
        strip: usize,
        tractions: &Tractions,
        slip: &mut [Vec<f64>; 2],
    ) {
        let Self { coefficients, layout, rows, .. } = self;
        let images = [strip, layout.image(strip)].map(|strip| layout.elements(strip).start);
        let count = layout.elements(strip).len();
        let put = |step: usize, parts: [[f64; 4]; 2]| {
            for (slip, parts) in slip.iter_mut().zip(parts) {
                put_steps(layout.symmetry, images, count, step, unfold(parts), slip);
            }
        };
        let length = 3 * layout.entries();
        let rows = &coefficients.rows[rows[strip] * length..rows[strip + 1] * length];
        let pairs = layout.symmetry.parts() / 2;
        match precision {
            Precision::Single => {
                Product { rows, tractions: &tractions.single[..], pairs, put }.compute();
            }
            Precision::Double => {
                Product { rows, tractions: &tractions.double[..], pairs, put }.compute();
            }
        }
        self.combine_steps(strip, images[0], slip);
        if let Some(image) = self.image(strip) {
            self.combine_steps(strip, self.layout.elements[image], slip);
        }
    }

    /// Makes of the steps from an element on, those of a kept strip or its mirror image, the slip of each.
    fn combine_steps(&self, strip: usize, first: usize, slip: &mut [Vec<f64>; 2]) {
        let weights = &self.weights[self.layout.elements(strip)];
        for slip in slip {
            let mut before = 0.0;
            for (slip, [own, upstream]) in slip[first..].iter_mut().zip(weights) {
                let step = *slip;
                *slip = own * step + upstream * before;
                before = step;
            }
        }
    }

    /// Coefficients of an element by the tractions of its strip, and the sign of `xy`.
    pub(crate) fn strip_block(&self, strip: usize, element: usize) -> (Row<'_>, f64) {
        let elements = self.layout.elements(strip);
        let (start, sign) = self.place(strip);
        let start = start + (element - elements.start) * elements.len();
        (self.row(start..start + elements.len()), sign)
    }

    /// Coefficients of a strip's elements by its own tractions.
    pub(crate) fn own_block(&self, strip: usize) -> Block<'_> {
        let elements = self.layout.elements(strip);
        let (start, sign) = self.place(strip);
        let rows = self.row(start..start + elements.len().pow(2));
        Block { rows, columns: elements.len(), sign, first: elements.start }
    }

    /// Coefficients of the elements of a mirror image by the tractions of the strip that it is the
    /// image of.
    pub(crate) fn image_block(&self, image: usize) -> Block<'_> {
        let elements = self.layout.elements(image);
        let (start, sign) = self.place(image);
        let size = elements.len().pow(2);
        let rows = self.row(start + size..start + 2 * size);
        Block { rows, columns: elements.len(), sign, first: elements.start }
    }

    /// Where a strip's blocks begin, and the sign of `xy`: -1 when they are those of its mirror image.
    fn place(&self, strip: usize) -> (usize, f64) {
        let original = self.layout.original(strip);
        (self.blocks[original], if original == strip { 1.0 } else { -1.0 })
    }

    /// The larger of the coefficients by an element's own traction.
    pub(crate) fn own(&self, strip: usize, element: usize) -> f64 {
        let row = self.strip_block(strip, element).0;
        let k = element - self.layout.elements(strip).start;
        row.xx[k].abs().max(row.yy[k].abs())
    }

    fn row(&self, range: Range<usize>) -> Row<'_> {
        let [xx, xy, yy] = &self.coefficients.blocks;
        Row { xx: &xx[range.clone()], xy: &xy[range.clone()], yy: &yy[range] }
    }
}

/// Steps of a strip of so many elements whose rows are kept: that from the leading edge, and of the others the
/// front half where the rear half mirrors it.
fn kept_steps(symmetry: Symmetry, count: usize) -> usize {
    if symmetry.is_along() { 1 + count / 2 } else { count }
}

/// Where each of some parts begins, and their sum.
fn starts(lengths: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut starts = vec![0];
    starts.extend(lengths.scan(0, |end, length| {
        *end += length;
        Some(*end)
    }));
    starts
}

/// Puts a step and its mirror images, a component of displacement of which are given, where they are in the strip
/// and its mirror image, whose first elements are given. Mirrored fore and aft a step goes the other way.
#[allow(clippy::inline_always)] // in products
#[inline(always)]
fn put_steps(
    symmetry: Symmetry,
    [own, image]: [usize; 2],
    count: usize,
    step: usize,
    [here, along, across, both]: [f64; 4],
    slip: &mut [f64],
) {
    slip[own + step] = here;
    if symmetry.is_across() {
        slip[image + step] = across;
    }
    if symmetry.is_along() && step > 0 {
        slip[own + count - step] = -along;
        if symmetry.is_across() {
            slip[image + count - step] = -both;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ellipse::Ellipse;

    /// Slips of all elements by tractions without symmetry.
    fn slips(influence: &Influence, precision: Precision) -> [Vec<f64>; 2] {
        let mut tractions = Tractions::zeros(influence);
        let n = tractions.own[0].len();
        tractions.copy_from(&(0..2 * n).map(|k| (k as f64).sin()).collect::<Vec<_>>());
        tractions.fold_all(precision);
        slips_by(influence, precision, &tractions)
    }

    fn slips_by(
        influence: &Influence,
        precision: Precision,
        tractions: &Tractions,
    ) -> [Vec<f64>; 2] {
        let mut slips = tractions.own.each_ref().map(|own| vec![0.0; own.len()]);
        for strip in 0..influence.strips() {
            influence.slip(precision, strip, tractions, &mut slips);
        }
        slips
    }

    /// The slip of a strip and of its mirror image by the strip's tractions alone, found twice.
    #[test]
    fn blocks_are_parts_of_rows() {
        /// Over the largest slip: rows are rounded to 6e-8.
        const ROUNDING: f64 = 2e-7;
        for (along, across) in [(5, 4), (6, 5)] {
            let mesh = Mesh::ellipse(Ellipse::from_ratio(0.7).unwrap(), along, across);
            let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
            let influence = Influence::new(&mesh, 0.3, &stencils, vec![1.0; mesh.len()]);
            for strip in 0..across {
                let mut tractions = Tractions::zeros(&influence);
                let change: Vec<f64> = (0..2 * along).map(|k| (k as f64).sin()).collect();
                tractions.add(strip, &change);
                tractions.fold(influence.layout.original(strip), Precision::Double);
                let expected = slips_by(&influence, Precision::Double, &tractions);
                let largest = expected.iter().flatten().fold(0.0, |most: f64, s| most.max(s.abs()));
                let (x, y) = change.split_at(along);
                let mut found = expected.each_ref().map(|slip| vec![0.0; slip.len()]);
                influence.own_block(strip).add_slip([x, y], &mut found);
                let image = across - 1 - strip;
                let by_image = (strip < image).then(|| influence.image_block(image));
                if let Some(block) = by_image {
                    block.add_slip([x, y], &mut found);
                }
                for strip in std::iter::once(strip).chain(by_image.map(|_| image)) {
                    for element in mesh.elements(strip) {
                        for (found, expected) in found.iter().zip(&expected) {
                            let apart = (found[element] - expected[element]).abs();
                            assert!(apart < ROUNDING * largest, "{strip} {element}: {apart:e}");
                        }
                    }
                }
            }
        }
    }

    /// Contacts that are their own mirror images both ways, one way or not at all, by a hair, and with
    /// mirror images told or untold: odd numbers of strips and of elements have some in the middle.
    #[test]
    fn symmetry_is_a_saving_only() {
        const OFF: f64 = 1e-10;
        /// Over the largest slip: rounding of sums of some tens of terms to 6e-8 each, of coefficients and in
        /// single precision of sums too.
        const ROUNDING: [f64; 2] = [2e-7, 3e-6];
        for (along, across) in [(5, 4), (6, 5), (5, 5), (6, 4), (2, 3)] {
            let mesh = Mesh::ellipse(Ellipse::from_ratio(0.7).unwrap(), along, across);
            let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
            let one = vec![1.0; mesh.len()];
            let mut off = one.clone();
            off[0] += OFF;
            let untold = Mesh::new(mesh.strips.clone());
            let [both, over, fore, none] =
                [(&mesh, &one), (&mesh, &off), (&untold, &one), (&untold, &off)]
                    .map(|(mesh, units)| Influence::new(mesh, 0.3, &stencils, units.clone()));
            let symmetries = [&both, &over, &fore].map(|influence| influence.layout.symmetry);
            if along > 1 {
                assert_eq!(symmetries, [Symmetry::Both, Symmetry::Across, Symmetry::Along]);
                assert_eq!(none.layout.symmetry, Symmetry::None);
            }
            let expected = slips(&none, Precision::Double);
            let largest = expected.iter().flatten().fold(0.0, |most: f64, c| most.max(c.abs()));
            let precisions = [Precision::Double, Precision::Single].into_iter().zip(ROUNDING);
            for (influence, (precision, rounding)) in [&both, &over, &fore, &none]
                .into_iter()
                .flat_map(|one| precisions.clone().map(move |precision| (one, precision)))
            {
                let found = slips(influence, precision);
                for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
                    assert!((found - expected).abs() < rounding * largest, "{found} {expected}");
                }
            }
        }
    }
}
