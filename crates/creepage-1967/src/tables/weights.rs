//! Shared computation of Tables 4 and 5: lateral forces with both weights, over creepages and meshes that fit the words
//! of the thesis, which states neither.

use creepage::Creepage;
use creepage::variational::{Settings, Variational, Weight};

use crate::prelude::*;

/// Pure lateral creepage, or pure spin.
pub(super) const CREEPAGES: [fn(f64) -> Creepage; 2] =
    [|eta| rolling_at([0.0, eta, 0.0]), |chi| rolling_at([0.0, 0.0, chi])];
/// Degree 4 with "about 100 points": 112, whose numbers are given, and 97.
pub(super) const MESHES: [usize; 2] = [12, 11];
/// Degree 3 with 80 points, as the thesis says.
pub(super) const MESH_OF_3: usize = 10;
/// Why the print need not be met.
pub(super) const REASON: &str = "the thesis does not state its creepages; our number changes as much \
    when η starts at 0.2 to 0.7 and ends at 2 or 2.6, χ ends at 6, 7 or 8, and the mesh has 97 or 112 points";

/// Largest and mean difference.
pub(super) type Spread = [f64; 2];

/// Sets of creepage or spin in steps of 0.1 and 0.5; smaller creepage is below what degree 3 resolves.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few steps
pub(super) fn sets(kind: usize) -> Vec<Vec<f64>> {
    let lateral = |from: f64, to: f64| spaced(from, to, (10.0 * (to - from)).round() as u32);
    match kind {
        0 => [[0.3, 2.6], [0.2, 2.6], [0.4, 2.6], [0.5, 2.0], [0.6, 2.0], [0.7, 2.0]]
            .map(|[from, to]| lateral(from, to))
            .to_vec(),
        _ => [(6.0, 11), (7.0, 13), (8.0, 15)].map(|(to, count)| spaced(0.5, to, count)).to_vec(),
    }
}

/// Lateral forces on a circle, by degree and weight.
pub(super) fn forces(
    mesh: usize,
    degree: usize,
    weight: Weight,
    creepages: &[Creepage],
) -> Result<Vec<f64>, GalleryError> {
    let settings = Settings { mesh: [mesh; 2], weight, ..Settings::of_degree(degree) };
    let theory = Variational::new(&like_bodies(1.0, STEEL)?, settings)?;
    Ok(chained(&theory, creepages).iter().map(|force| force.fy).collect())
}

/// Largest and mean distance of two lists.
pub(super) fn spread(one: &[f64], two: &[f64]) -> Spread {
    let apart = || one.iter().zip(two).map(|(one, two)| (one - two).abs());
    [apart().fold(0.0, f64::max), apart().sum::<f64>() / one.len() as f64]
}

/// Spreads for every mesh and set of creepages; first that which is given as ours.
pub(super) fn variants(
    kind: usize,
    of: impl Fn(usize, &[Creepage]) -> Result<Spread, GalleryError>,
) -> Result<Vec<Spread>, GalleryError> {
    let mut spreads = Vec::new();
    for set in sets(kind) {
        let creepages: Vec<_> = set.into_iter().map(CREEPAGES[kind]).collect();
        for mesh in MESHES {
            spreads.push(of(mesh, &creepages)?);
        }
    }
    Ok(spreads)
}

/// Largest and mean against the print; as close as our own variants are to each other.
pub(super) fn compared(name: &str, printed: [&str; 2], variants: &[Spread]) -> [Comparison; 2] {
    let line = |i: usize, what: &str| {
        let ours = variants[0][i];
        let varies = variants.iter().map(|other| (other[i] - ours).abs()).fold(0.0, f64::max);
        // The print is rounded, too.
        Comparison::number(format!("{name}, {what}"), printed[i], ours)
            .within(varies + 5e-4, REASON)
            .because(REASON_OUTSIDE)
    };
    [line(0, "largest"), line(1, "mean")]
}

const REASON_OUTSIDE: &str = "none of the sets of creepages and two meshes gives the print; the \
    thesis does not state its creepages";

/// Title and heads of the table as text.
pub(super) fn heading(title: &str) -> String {
    let line = |cells: [&str; 4]| {
        let [a, b, c, d] = cells;
        format!("  {:<32}{a:>9}{b:>9}{c:>9}{d:>9}", "").trim_end().to_owned() + "\n"
    };
    let heads = ["printed", "", "ours", ""];
    format!("{title}\n\n{}{}", line(heads), line(["max", "mean", "max", "mean"]))
}

/// A row of the table as text.
pub(super) fn row(name: &str, [p, q]: [&str; 2], [max, mean]: Spread) -> String {
    format!("  {name:<32}{p:>9}{q:>9}{max:>9.4}{mean:>9.4}\n")
}
