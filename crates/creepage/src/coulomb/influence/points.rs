//! Displacements at points, kept for themselves, and slip as any combination of them: what rolling
//! that is not steady needs, where the combination changes from step to step.

use super::{Coefficients, Influence, Place};
use crate::coulomb::cuts::Cuts;
use crate::coulomb::mesh::Mesh;

impl Influence {
    /// Displacements by tractions over `units`, one an element, in units of `pi G`, at `points` of
    /// every strip, a row a point in their order.
    pub(crate) fn displacements(
        mesh: &Mesh,
        poisson: f64,
        points: &[Vec<[f64; 2]>],
        units: Vec<f64>,
    ) -> Self {
        let (stored, mut cuts) = (stored(mesh), Cuts::new(mesh, units));
        let count: usize = points[..stored].iter().map(Vec::len).sum();
        let mut coefficients = Coefficients::with_length(count * mesh.len());
        for (row, at) in points[..stored].iter().flatten().enumerate() {
            let row = row * mesh.len()..(row + 1) * mesh.len();
            let by = coefficients.double.each_mut().map(|all| &mut all[row.clone()]);
            cuts.displace(poisson, *at, by);
        }
        let mut starts = vec![0];
        starts.extend(points.iter().scan(0, |end, points| {
            *end += points.len();
            Some(*end)
        }));
        let row = |(strip, k): (usize, usize)| {
            let (own, sign) = own_or_image(mesh, strip);
            Place { start: (starts[own] + k) * mesh.len(), block: mesh.elements(own), sign }
        };
        let strips = points.iter().enumerate();
        let rows = strips.flat_map(|(strip, at)| (0..at.len()).map(move |k| (strip, k))).map(row);
        Self {
            coefficients,
            rows: rows.collect(),
            offsets: mesh.offsets().to_vec(),
            mirrored: mesh.mirrored,
        }
    }

    /// Makes of `slip` the combinations of these displacements' rows, one an element: rows and
    /// factors.
    pub(crate) fn combine(&self, mesh: &Mesh, weights: &[[(usize, f64); 3]], slip: &mut Self) {
        let (n, stored) = (mesh.len(), stored(mesh));
        for (to, from) in slip.coefficients.double.iter_mut().zip(&self.coefficients.double) {
            to.clear();
            for [(a, wa), (b, wb), (c, wc)] in &weights[..mesh.offsets()[stored]] {
                let [a, b, c] = [*a, *b, *c].map(|row| {
                    let start = self.rows[row].start;
                    &from[start..start + n]
                });
                let rows = a.iter().zip(b).zip(c);
                to.extend(rows.map(|((a, b), c)| wa * a + wb * b + wc * c));
            }
        }
        slip.coefficients.copy_to_single();
    }
}

/// Strips whose coefficients are kept; those of the others are their mirror images.
fn stored(mesh: &Mesh) -> usize {
    let strips = mesh.strips.len();
    if mesh.mirrored { strips.div_ceil(2) } else { strips }
}

/// The strip whose coefficients a strip has, and their sign.
fn own_or_image(mesh: &Mesh, strip: usize) -> (usize, f64) {
    if strip < stored(mesh) { (strip, 1.0) } else { (mesh.strips.len() - 1 - strip, -1.0) }
}
