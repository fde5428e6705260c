//! The two theories that most figures compare: chapter 5, and the full one.

use creepage::InvalidValue;
use creepage::coulomb::{Exact, Resolution};
use creepage::variational::{Chain, Procedure, Settings, Variational, VariationalError, Weight};
use creepage::{Contact, Creepage, Ellipse, Force, Solution};

/// Like bodies in a contact of this shape.
pub(crate) fn like_bodies(a_over_b: f64, poisson: f64) -> Result<Contact, InvalidValue> {
    Contact::new(Ellipse::from_ratio(a_over_b)?, poisson)
}

/// Creepage and spin of a figure: fixed numbers, of which none is without bound.
pub(crate) fn rolling_at([xi, eta, chi]: [f64; 3]) -> Creepage {
    Creepage::new(xi, eta, chi).unwrap_or_default()
}

/// Points of a curve.
pub(crate) type Curve = Vec<[f64; 2]>;

/// Combined Poisson's ratio of the steel in chapter 5.
pub(crate) const STEEL: f64 = 0.28;

/// The catalogue (5.29): ratios of the semi-axes and their spins.
pub(crate) const CATALOGUE: [(f64, [f64; 6]); 4] = [
    (2.0, [0.0, 0.5, 1.0, 2.0, 3.5, 7.0]),
    (1.0, [0.0, 0.5, 1.0, 2.0, 5.0, 10.0]),
    (0.5, [0.0, 1.0, 2.0, 3.0, 5.0, 10.0]),
    (0.2, [0.0, 0.5, 1.0, 2.0, 5.0, 10.0]),
];

/// The numerical theory of chapter 5 as the thesis used it, for degree `M` and a weight.
pub(crate) fn chapter_5(
    a_over_b: f64,
    poisson: f64,
    degree: usize,
    weight: Weight,
) -> Result<Variational, VariationalError> {
    let cells = if degree > 3 { 11 } else { 10 };
    let settings = Settings { mesh: [cells; 2], weight, ..Settings::of_degree(degree) };
    Variational::new(&like_bodies(a_over_b, poisson)?, settings)
}

/// Forces along a curve of creepages, in a chain from the last to the first, as 1967 ran them.
pub(crate) fn chained(theory: &Variational, creepages: &[Creepage]) -> Vec<Force> {
    let mut chain = Chain::new(theory, Procedure::default());
    let backwards = creepages.iter().rev();
    let mut forces: Vec<_> =
        backwards.map(|creepage| chain.solve(*creepage, None).found.solution.force).collect();
    forces.reverse();
    forces
}

/// Forces along a curve of creepages by the full theory.
pub(crate) fn full(
    a_over_b: f64,
    poisson: f64,
    creepages: &[Creepage],
) -> Result<Vec<Force>, InvalidValue> {
    Ok(full_solutions(a_over_b, poisson, creepages)?.iter().map(|found| found.force).collect())
}

/// The same with error bars.
pub(crate) fn full_solutions(
    a_over_b: f64,
    poisson: f64,
    creepages: &[Creepage],
) -> Result<Vec<Solution>, InvalidValue> {
    let theory = Exact::new(&like_bodies(a_over_b, poisson)?, Resolution::STANDARD)?;
    Ok(theory.curve(creepages))
}

/// Between the ends of the error bars of a component of the force, within a frame.
pub(crate) fn band(
    x: &[f64],
    found: &[Solution],
    of: fn(&Force) -> f64,
    [low, high]: [f64; 2],
) -> Curve {
    let end = |sign: f64| {
        x.iter().zip(found).map(move |(x, found)| {
            let bar = found.error.as_ref().map_or(0.0, of);
            [*x, (of(&found.force) + sign * bar).clamp(low, high)]
        })
    };
    let mut band: Curve = end(1.0).collect();
    band.extend(end(-1.0).rev());
    band
}

/// `count + 1` values from `from` to `to`.
pub(crate) fn spaced(from: f64, to: f64, count: u32) -> Vec<f64> {
    (0..=count).map(|k| from + (to - from) * f64::from(k) / f64::from(count)).collect()
}

/// Points of a curve: a component of the force over the abscissae.
pub(crate) fn points(x: &[f64], forces: &[Force], of: fn(&Force) -> f64) -> Vec<[f64; 2]> {
    x.iter().zip(forces).map(|(x, force)| [*x, of(force)]).collect()
}

/// The largest distance between two curves of the same abscissae.
pub(crate) fn farthest(one: &[[f64; 2]], two: &[[f64; 2]]) -> f64 {
    one.iter().zip(two).map(|(p, q)| (p[1] - q[1]).abs()).fold(0.0, f64::max)
}
