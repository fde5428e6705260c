//! The elastic slip of every element by the traction of every other.
//!
//! Where the strips are mirror images of one another about the `x` axis, the coefficients of the
//! upper half are those of the lower by the tractions in mirrored order: only half is computed and
//! kept. Nothing outside of this file and of [`Tractions`] depends on that.

mod coefficients;
mod points;
mod tractions;

use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};

use super::cuts::Cuts;
use super::mesh::Mesh;
use super::product::{Block, Row};
use super::stencil::SlipStencil;
use coefficients::Coefficients;
pub(crate) use tractions::Tractions;

/// How precisely slip is needed: sweeps only come near a solution, with half the memory to read.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) enum Precision {
    #[default]
    Single,
    Double,
}

/// Coefficients of the slip of each element, row by row.
#[derive(Debug, Clone)]
pub(crate) struct Influence {
    coefficients: Coefficients,
    rows: Vec<Place>,
    /// First element of every strip, and the number of all.
    offsets: Vec<usize>,
    mirrored: bool,
}

/// Where the coefficients of an element are.
#[derive(Debug, Clone)]
struct Place {
    start: usize,
    /// Those of its own strip, in the row.
    block: Range<usize>,
    /// -1 when they are those of the mirror image.
    sign: f64,
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
        let strips = stencils.len();
        let stored = if mesh.mirrored { strips.div_ceil(2) } else { strips };
        let size = mesh.offsets()[stored] * mesh.len();
        let is_like_reversed = mesh.is_like_reversed(&units);
        let mut cuts = Cuts::new(mesh, units);
        let (mut coefficients, n) = (Coefficients::with_length(size).with_single(), mesh.len());
        let most = stencils.iter().map(|stencil| stencil.points.len()).max().unwrap_or(0);
        let mut displacements: [Vec<f64>; 3] = std::array::from_fn(|_| vec![0.0; most * n]);
        for (strip, stencil) in stencils[..stored].iter().enumerate() {
            let count = stencil.points.len();
            // The leading edge, then the elements' centres.
            let seen = if is_like_reversed { 1 + count / 2 } else { count };
            for (k, point) in stencil.points.iter().enumerate().take(seen) {
                let by = displacements.each_mut().map(|all| &mut all[k * n..(k + 1) * n]);
                cuts.displace(poisson, *point, by);
            }
            for k in seen..count {
                reverse(mesh, &mut displacements, k, count - k);
            }
            let elements = mesh.elements(strip);
            let rows = elements.start * n..elements.end * n;
            let Coefficients { double, single } = &mut coefficients;
            for ((double, single), by) in double.iter_mut().zip(single).zip(&displacements) {
                let (to, single) = (&mut double[rows.clone()], &mut single[rows.clone()]);
                Arch::new().dispatch(Rows { stencil, by, n, to, single });
            }
        }
        let rows = mesh.all().map(|(strip, i)| place(mesh, stored, strip, i)).collect();
        let offsets = mesh.offsets().to_vec();
        Self { coefficients, rows, offsets, mirrored: mesh.mirrored }
    }

    /// The same where every element moves the surface at itself, and nowhere else, by `own` more.
    pub(crate) fn with_own_displacements(mut self, stencils: &[SlipStencil], own: &[f64]) -> Self {
        for (strip, stencil) in stencils.iter().enumerate() {
            let elements = self.offsets[strip]..self.offsets[strip + 1];
            for (element, weights) in elements.clone().zip(&stencil.weights) {
                let Place { start, sign, .. } = self.rows[element];
                if sign < 0.0 {
                    continue;
                }
                // Point 0 is the leading edge, then comes the centre of each element.
                for (point, weight) in weights.iter().filter(|(point, _)| *point > 0) {
                    let by = elements.start + point - 1;
                    self.coefficients.double[0][start + by] += weight * own[by];
                    self.coefficients.double[2][start + by] += weight * own[by];
                }
            }
        }
        self.coefficients.copy_to_single();
        self
    }

    /// Slip of an element.
    pub(crate) fn apply(
        &self,
        precision: Precision,
        element: usize,
        tractions: &Tractions,
    ) -> [f64; 2] {
        let Place { start, sign, .. } = self.rows[element];
        let (image, range) = (usize::from(sign < 0.0), start..start + self.columns());
        match precision {
            Precision::Single => {
                let [x, y] = &tractions.single[image];
                let [xx, xy, yy] = self.coefficients.single.each_ref().map(|c| &c[range.clone()]);
                Row { xx, xy, yy }.apply(sign, x, y)
            }
            Precision::Double => {
                let [x, y] = if image == 0 { &tractions.own } else { &tractions.mirrored };
                self.row(range).apply(sign, x, y)
            }
        }
    }

    /// Strips that are to be gone through, each with its mirror image.
    pub(crate) fn strips(&self) -> usize {
        let strips = self.offsets.len() - 1;
        if self.mirrored { strips.div_ceil(2) } else { strips }
    }

    /// The mirror image of a strip, where it is another strip and shares the coefficients.
    pub(crate) fn image(&self, strip: usize) -> Option<usize> {
        let image = self.offsets.len() - 2 - strip;
        (self.mirrored && image != strip).then_some(image)
    }

    /// Slip of every element of a strip and of its mirror image, reading coefficients once.
    pub(crate) fn slip(
        &self,
        precision: Precision,
        strip: usize,
        tractions: &Tractions,
        mut take: impl FnMut(usize, [f64; 2]),
    ) {
        let elements = self.offsets[strip]..self.offsets[strip + 1];
        let Some(image) = self.image(strip) else {
            elements.for_each(|element| take(element, self.apply(precision, element, tractions)));
            return;
        };
        for (element, other) in elements.zip(self.offsets[image]..) {
            let [own, mirrored] = self.apply_to_both(precision, element, tractions);
            take(element, own);
            take(other, mirrored);
        }
    }

    /// Slip of an element of the stored half, and of its mirror image.
    fn apply_to_both(
        &self,
        precision: Precision,
        element: usize,
        tractions: &Tractions,
    ) -> [[f64; 2]; 2] {
        let start = self.rows[element].start;
        let range = start..start + self.columns();
        match precision {
            Precision::Single => {
                let [xx, xy, yy] = self.coefficients.single.each_ref().map(|c| &c[range.clone()]);
                let tractions = tractions.single.each_ref().map(|of| of.each_ref().map(|t| &t[..]));
                Row { xx, xy, yy }.apply_to_both(tractions)
            }
            Precision::Double => {
                let tractions =
                    [&tractions.own, &tractions.mirrored].map(|of| of.each_ref().map(|t| &t[..]));
                self.row(range).apply_to_both(tractions)
            }
        }
    }

    /// Coefficients of an element by the tractions of its own strip, and the sign of `xy`.
    pub(crate) fn strip_block(&self, element: usize) -> (Row<'_>, f64) {
        let Place { start, block, sign } = &self.rows[element];
        (self.row(start + block.start..start + block.end), *sign)
    }

    /// Coefficients of a strip's elements by its own tractions.
    pub(crate) fn own_block(&self, strip: usize) -> Block<'_> {
        self.block(strip, self.rows[self.offsets[strip]].block.clone())
    }

    /// Coefficients of the elements of a mirror image by the tractions of the strip that it is the
    /// image of.
    pub(crate) fn image_block(&self, image: usize) -> Block<'_> {
        // Tractions are in mirrored order.
        self.block(image, self.offsets[image]..self.offsets[image + 1])
    }

    /// Some columns of a strip's rows.
    fn block(&self, strip: usize, columns: Range<usize>) -> Block<'_> {
        let elements = self.offsets[strip]..self.offsets[strip + 1];
        let Place { start, sign, .. } = self.rows[elements.start];
        let stride = self.columns();
        let end = start + (elements.len() - 1) * stride + columns.end;
        let rows = self.row(start + columns.start..end);
        Block { rows, stride, columns: columns.len(), sign, first: elements.start }
    }

    /// The larger of the coefficients by an element's own traction.
    pub(crate) fn own(&self, strip: usize, element: usize) -> f64 {
        let (row, k) = (self.strip_block(element).0, element - self.offsets[strip]);
        row.xx[k].abs().max(row.yy[k].abs())
    }

    /// The number of elements; there may be more rows.
    pub(super) fn columns(&self) -> usize {
        self.offsets.last().copied().unwrap_or_default()
    }

    fn row(&self, range: Range<usize>) -> Row<'_> {
        let [xx, xy, yy] = &self.coefficients.double;
        Row { xx: &xx[range.clone()], xy: &xy[range.clone()], yy: &yy[range] }
    }
}

impl Drop for Influence {
    fn drop(&mut self) {
        std::mem::take(&mut self.coefficients).keep();
    }
}

/// The displacements at point `k` from those at its mirror image fore and aft: a traction across moves that
/// forward by as much as this back.
fn reverse(mesh: &Mesh, displacements: &mut [Vec<f64>; 3], k: usize, image: usize) {
    let n = mesh.len();
    for (all, sign) in displacements.iter_mut().zip([1.0, -1.0, 1.0]) {
        let (known, rest) = all.split_at_mut(k * n);
        let (from, to) = (&known[image * n..(image + 1) * n], &mut rest[..n]);
        for ends in mesh.offsets().windows(2) {
            let elements = ends[0]..ends[1];
            let pairs = to[elements.clone()].iter_mut().zip(from[elements].iter().rev());
            pairs.for_each(|(to, from)| *to = sign * from);
        }
    }
}

fn place(mesh: &Mesh, stored: usize, strip: usize, i: usize) -> Place {
    let (strip, sign) =
        if strip < stored { (strip, 1.0) } else { (mesh.strips.len() - 1 - strip, -1.0) };
    let block = mesh.elements(strip);
    Place { start: (block.start + i) * mesh.len(), block, sign }
}

/// The rows of a strip's elements from the displacements of all its points, each of `n` numbers.
struct Rows<'a> {
    stencil: &'a SlipStencil,
    by: &'a [f64],
    n: usize,
    to: &'a mut [f64],
    /// The same in single precision.
    single: &'a mut [f32],
}

impl WithSimd for Rows<'_> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[allow(clippy::cast_possible_truncation)] // single precision is meant
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { stencil, by, n, to, single } = self;
        let rows = to.chunks_exact_mut(n).zip(single.chunks_exact_mut(n));
        for ((row, single), weights) in rows.zip(&stencil.weights) {
            let [(a, wa), (b, wb), (c, wc)] = *weights;
            let [a, b, c] = [a, b, c].map(|point| &by[point * n..(point + 1) * n]);
            let entries = row.iter_mut().zip(single);
            for ((row, single), ((a, b), c)) in entries.zip(a.iter().zip(b).zip(c)) {
                *row = wa * a + wb * b + wc * c;
                *single = *row as f32;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ellipse::Ellipse;

    /// Strips that are their own mirror images fore and aft, against the same by a hair off.
    #[test]
    fn the_rear_half_mirrors_the_front() {
        const OFF: f64 = 1e-10;
        for along in [5, 6] {
            let mesh = Mesh::ellipse(Ellipse::from_ratio(0.7).unwrap(), along, 4);
            let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
            let units = vec![1.0; 4 * along];
            let mut off = units.clone();
            off[0] += OFF;
            assert!(mesh.is_like_reversed(&units) && !mesh.is_like_reversed(&off));
            let [half, all] =
                [units, off].map(|units| Influence::new(&mesh, 0.3, &stencils, units));
            let largest = half
                .coefficients
                .double
                .iter()
                .flatten()
                .fold(0.0, |most: f64, c| most.max(c.abs()));
            for (half, all) in half.coefficients.double.iter().zip(&all.coefficients.double) {
                for (half, all) in half.iter().zip(all.iter()) {
                    assert!((half - all).abs() < 2.0 * OFF * largest, "{half} {all}");
                }
            }
        }
    }

    /// The stored half and its mirror image, against the coefficients of all elements.
    #[test]
    fn the_upper_half_mirrors_the_lower() {
        let mesh = Mesh::ellipse(Ellipse::from_ratio(0.7).unwrap(), 5, 4);
        let stencils: Vec<_> = mesh.strips.iter().map(SlipStencil::steady).collect();
        let one = vec![1.0; 20];
        let half = Influence::new(&mesh, 0.3, &stencils, one.clone());
        let all = Influence::new(&Mesh::new(mesh.strips), 0.3, &stencils, one);
        let vector: Vec<f64> = (0..40).map(|k| f64::from(k).sin()).collect();
        let [of_half, of_all] = [&half, &all].map(|influence| {
            let mut tractions = Tractions::zeros(influence);
            tractions.copy_from(&vector);
            tractions
        });
        for element in 0..20 {
            let [found, single] = [Precision::Double, Precision::Single]
                .map(|precision| half.apply(precision, element, &of_half));
            let expected = all.apply(Precision::Double, element, &of_all);
            for k in 0..2 {
                // Rounding of sums of 40 terms of order one.
                assert!((found[k] - expected[k]).abs() < 1e-12);
                assert!((single[k] - expected[k]).abs() < 1e-5);
            }
        }
    }
}
