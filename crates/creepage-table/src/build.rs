//! Building a table.

use creepage::InvalidValue;
use creepage::rolling::Theory;

use crate::accuracy::{Accuracy, Measure};
use crate::axis::Axis;
use crate::coordinates::Coordinates;
use crate::table::{Provenance, Table};
use crate::values::{Intervals, Values};

/// What table to build.
#[derive(Debug, Clone, PartialEq)]
pub struct Spec {
    /// Nodes along the ratio of semi-axes.
    pub a_over_b: Axis,
    /// Nodes along Poisson's ratio.
    pub poisson: Axis,
    /// Intervals in creepage and spin.
    pub intervals: Intervals,
    /// At how many random places to measure the error, and at about as many hard ones.
    pub places: usize,
    /// Where the table comes from.
    pub provenance: Provenance,
}

/// Why a table cannot be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BuildError<E: std::error::Error> {
    /// A number of the [`Spec`] makes no sense.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The theory cannot be prepared for a node.
    #[error("{0}")]
    Theory(E),
    /// Doubling a tiny creepage does not double the force.
    #[error(
        "the theory's force is not in proportion to tiny creepage at a/b = {a_over_b}, as \
             interpolation from zero needs"
    )]
    NotLinearAtZero {
        /// The ratio of the node.
        a_over_b: f64,
    },
    /// The force at infinite creepage is above `mu N`.
    #[error(
        "the theory's force is {size} mu N at infinite creepage, a/b = {a_over_b}: there is no \
             table to infinity of it"
    )]
    Unbounded {
        /// The ratio of the node.
        a_over_b: f64,
        /// Largest force in parts of `mu N`.
        size: f64,
    },
}

impl Spec {
    /// Number of steps of which [`build`] tells.
    #[must_use]
    pub fn steps(&self) -> usize {
        let blocks = self.a_over_b.nodes * self.poisson.nodes;
        blocks * Values::lines(self.intervals).count() + self.places + self.hard_places()
    }

    /// Half-way between neighbours of shapes and of Poisson's ratios: where mixing errs most.
    pub(crate) fn middles(&self) -> impl Iterator<Item = [f64; 2]> {
        let shapes = self.a_over_b.middles();
        self.poisson
            .middles()
            .flat_map(move |poisson| shapes.clone().map(move |shape| [shape, poisson]))
    }

    /// Number of hard places at which the error is measured.
    pub(crate) fn hard_places(&self) -> usize {
        self.middles().count() * self.hard_places_each()
    }

    /// The same at each of the [`Spec::middles`]: at most one in every cell.
    pub(crate) fn hard_places_each(&self) -> usize {
        let Intervals { theta, phi, t } = self.intervals;
        self.places
            .div_ceil(self.middles().count())
            .min(theta.saturating_mul(phi).saturating_mul(t))
    }

    pub(crate) fn check(&self) -> Result<(), InvalidValue> {
        let Intervals { theta, phi, t } = self.intervals;
        let within = |quantity, count: usize, range: std::ops::RangeInclusive<usize>, valid| {
            let value = count as f64;
            let good = range.contains(&count);
            if good { Ok(()) } else { Err(InvalidValue { quantity, value, valid }) }
        };
        within("theta", theta, 4..=400, "between 4 and 400")?;
        within("phi", phi / 2, 2..=200, "even and between 4 and 400")?;
        within("phi", phi, phi & !1..=phi & !1, "even and between 4 and 400")?;
        within("t", t, 4..=400, "between 4 and 400")?;
        within("a_over_b nodes", self.a_over_b.nodes, 1..=100, "between 1 and 100")?;
        within("poisson nodes", self.poisson.nodes, 1..=20, "between 1 and 20")?;
        range("a_over_b", self.a_over_b, f64::MIN_POSITIVE)?;
        range("poisson", self.poisson, 0.0)
    }
}

fn range(quantity: &'static str, axis: Axis, least: f64) -> Result<(), InvalidValue> {
    let Axis { low, high, nodes } = axis;
    let fixed = nodes == 1;
    let error = |value, valid| Err(InvalidValue { quantity, value, valid });
    if !(low >= least && low.is_finite()) {
        return error(low, "finite and not negative; a ratio of axes greater than zero");
    }
    if !high.is_finite() || (fixed && (high - low).abs() > 0.0) || (!fixed && high <= low) {
        return error(high, "above the first value, or the same where there is one node");
    }
    Ok(())
}

/// Builds a table, on all cores, and measures its error.
///
/// `prepare` takes `a/b` and Poisson's ratio; `done` is told of each of [`Spec::steps`] steps.
///
/// # Errors
/// [`BuildError`] for a [`Spec`] or a theory of which there can be no table.
pub fn build<E: std::error::Error>(
    spec: &Spec,
    prepare: impl Fn(f64, f64) -> Result<Box<dyn Theory>, E>,
    done: &(dyn Fn() + Sync),
) -> Result<Table, BuildError<E>> {
    spec.check()?;
    let Spec { a_over_b, poisson, intervals, .. } = *spec;
    let mut blocks = Vec::with_capacity(a_over_b.nodes * poisson.nodes);
    for material in poisson.shares() {
        for shape in a_over_b.shares() {
            let ratio = a_over_b.geometric(shape);
            let theory = prepare(ratio, poisson.even(material)).map_err(BuildError::Theory)?;
            fits(&*theory, ratio)?;
            let coordinates = Coordinates::new(ratio);
            blocks.push(Values::compute(&*theory, &coordinates, intervals, done));
        }
    }
    let axes = [a_over_b, poisson];
    let provenance = spec.provenance.clone();
    let mut table = Table::new(provenance, axes, intervals, blocks, Accuracy::default());
    table.accuracy = Measure { table: &table, prepare, done }.accuracy(spec)?;
    Ok(table)
}

/// A table needs a force that starts in proportion to creepage and ends bounded.
fn fits<E: std::error::Error>(theory: &dyn Theory, a_over_b: f64) -> Result<(), BuildError<E>> {
    let coordinates = Coordinates::new(a_over_b);
    for [theta, phi] in [[1.5, 0.0], [1.5, 1.5], [0.1, 0.5]] {
        let force = |t| theory.solve(coordinates.creepage([theta, phi, t])).force;
        let size = force(1.0).magnitude();
        if size.is_nan() || size > 1.01 {
            return Err(BuildError::Unbounded { a_over_b, size });
        }
        let (one, two) = (force(1e-5).magnitude(), force(2e-5).magnitude());
        // Slip makes the ratio less than two by about the force itself.
        if (two - 2.0 * one).abs() > 0.01 * two {
            return Err(BuildError::NotLinearAtZero { a_over_b });
        }
    }
    Ok(())
}
