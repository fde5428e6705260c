//! Influence on displacements at points, and slip as any combination of them: what rolling that is not steady needs,
//! where the combination changes from step to step.

use super::coefficients::{Coefficients, Folded, Number};
use super::layout::{Layout, Symmetry, unfold};
use super::{Influence, Tractions, starts};
use crate::coulomb::boussinesq_cerruti::Cuts;
use crate::coulomb::mesh::Mesh;
use crate::coulomb::product::Product;

/// Displacements at some points of every strip, by the traction of every element.
#[derive(Debug, Clone)]
pub(crate) struct Displacements {
    /// Rows as [`Product`] reads them.
    rows: Vec<f64>,
    /// Those by each strip itself and by its mirror image: in `x` by `x`; in `x` by `y` and in `y` by `x`; in `y`
    /// by `y`.
    by_strips: [Vec<f64>; 3],
    layout: Layout,
    /// First point of every strip, and the number of all: the rows are those of the kept strips, in order.
    points: Vec<usize>,
    /// Where the blocks of every kept strip begin: of itself, then of its mirror image.
    blocks: Vec<usize>,
}

impl Displacements {
    /// By tractions over `units`, one an element, in units of `pi G`, at `points` of every strip.
    pub(crate) fn new(
        mesh: &Mesh,
        poisson: f64,
        points: &[Vec<[f64; 2]>],
        units: Vec<f64>,
    ) -> Self {
        let layout = Layout::new(Symmetry::new(false, mesh.mirrored), mesh.offsets());
        let kept = layout.kept();
        let block = |strip: usize| 2 * points[strip].len() * mesh.strips[strip].len();
        let (blocks, first) = (starts((0..kept).map(block)), starts(points.iter().map(Vec::len)));
        let length = 3 * layout.entries();
        let mut rows = vec![0.0; first[kept] * length];
        let mut by_strips = std::array::from_fn(|_| vec![0.0; blocks[kept]]);
        let [mut folded, none] = [(); 2].map(|()| Folded::new(&layout));
        let mut cuts = Cuts::new(mesh, units);
        let mut by: [Vec<f64>; 3] = std::array::from_fn(|_| vec![0.0; mesh.len()]);
        let mut all = rows.chunks_exact_mut(length);
        for (strip, points) in points[..kept].iter().enumerate() {
            for ((k, point), row) in points.iter().enumerate().zip(&mut all) {
                cuts.displace(poisson, *point, by.each_mut().map(Vec::as_mut_slice));
                folded.set(&layout, by.each_ref().map(Vec::as_slice));
                folded.put_less(&none, &layout, row);
                for (image, by_strip) in [strip, layout.image(strip)].into_iter().enumerate() {
                    let elements = layout.elements(by_strip);
                    let start = blocks[strip] + (image * points.len() + k) * elements.len();
                    for (block, by) in by_strips.iter_mut().zip(&by) {
                        block[start..start + elements.len()].copy_from_slice(&by[elements.clone()]);
                    }
                }
            }
        }
        Self { rows, by_strips, layout, points: first, blocks }
    }

    /// The same where every element moves the surface at its centre, the point after the leading edge and
    /// those of the elements before it, and nowhere else, by `own` more.
    pub(crate) fn with_own(mut self, own: &[f64]) -> Self {
        let Self { rows, by_strips, layout, points, blocks } = &mut self;
        let length = 3 * layout.entries();
        let [mut folded, none] = [(); 2].map(|()| Folded::new(layout));
        let [mut more, zeros] = [(); 2].map(|()| vec![0.0; layout.len()]);
        let mut row_of_own = vec![0.0; length];
        for strip in 0..layout.kept() {
            let elements = layout.elements(strip);
            for (i, element) in elements.clone().enumerate() {
                more[element] = own[element];
                folded.set(layout, [&more, &zeros, &more]);
                folded.put_less(&none, layout, &mut row_of_own);
                more[element] = 0.0;
                let row = &mut rows[(points[strip] + i + 1) * length..][..length];
                row.iter_mut().zip(&row_of_own).for_each(|(row, more): (&mut f64, _)| *row += more);
                let entry = blocks[strip] + (i + 1) * elements.len() + i;
                by_strips[0][entry] += own[element];
                by_strips[2][entry] += own[element];
            }
        }
        self
    }

    /// Displacements at all points by some tractions.
    pub(crate) fn by(&self, tractions: &Tractions) -> [Vec<f64>; 2] {
        let Self { rows, layout, points, .. } = self;
        let mut all = [0, 1].map(|_| vec![0.0; points[points.len() - 1]]);
        let length = 3 * layout.entries();
        for strip in 0..layout.kept() {
            let images = [strip, layout.image(strip)].map(|strip| points[strip]);
            let put = |k: usize, parts: [[f64; 4]; 2]| {
                for (all, parts) in all.iter_mut().zip(parts) {
                    let [here, _, across, _] = unfold(parts);
                    all[images[0] + k] = here;
                    if layout.symmetry.is_across() {
                        all[images[1] + k] = across;
                    }
                }
            };
            let rows = &rows[points[strip] * length..points[strip + 1] * length];
            let (tractions, pairs) = (&tractions.double[..], layout.symmetry.parts() / 2);
            Product { rows, tractions, pairs, put }.compute();
        }
        all
    }

    /// Slip of each element as combinations of displacements that are still to be set by
    /// [`Displacements::combine`].
    pub(crate) fn slip(&self) -> Influence {
        let layout = self.layout.clone();
        let kept = layout.kept();
        let rows = layout.elements[..=kept].to_vec();
        let blocks = starts((0..kept).map(|strip| 2 * layout.elements(strip).len().pow(2)));
        let size = rows[kept] * 3 * layout.entries();
        let coefficients = Coefficients::with_length(size, blocks[kept]);
        let weights = vec![[1.0, 0.0]; rows[kept]];
        Influence { coefficients, layout, rows, weights, blocks }
    }

    /// Makes of `slip` the combinations of these displacements, one an element: points and factors.
    pub(crate) fn combine(&self, weights: &[[(usize, f64); 3]], slip: &mut Influence) {
        let length = 3 * self.layout.entries();
        let rows = slip.coefficients.rows.chunks_exact_mut(length);
        for (row, weights) in rows.zip(weights) {
            combination(&self.rows, weights, |point| point * length, row);
        }
        for strip in 0..self.layout.kept() {
            let elements = self.layout.elements(strip);
            let (n, points) = (elements.len(), &self.points[strip..=strip + 1]);
            let size = n * (points[1] - points[0]);
            for (image, i) in [0, 1].into_iter().flat_map(|image| (0..n).map(move |i| (image, i))) {
                let start = self.blocks[strip] + image * size;
                let at = |point: usize| start + (point - points[0]) * n;
                let row = slip.blocks[strip] + (image * n + i) * n;
                let (from, to) = (&self.by_strips, &mut slip.coefficients.blocks);
                for (from, to) in from.iter().zip(to) {
                    combination(from, &weights[elements.start + i], at, &mut to[row..row + n]);
                }
            }
        }
    }
}

/// Three rows times factors; `at` is where each begins.
fn combination<C: Number>(
    from: &[f64],
    weights: &[(usize, f64); 3],
    at: impl Fn(usize) -> usize,
    row: &mut [C],
) {
    let [(a, wa), (b, wb), (c, wc)] = *weights;
    let [a, b, c] = [a, b, c].map(|point| &from[at(point)..][..row.len()]);
    let entries = row.iter_mut().zip(a.iter().zip(b).zip(c));
    entries.for_each(|(row, ((a, b), c))| *row = C::of(wa * a + wb * b + wc * c));
}
