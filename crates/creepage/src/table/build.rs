//! Construction of a table: the theory at all nodes, in parallel, and the table's measured error.

use super::coordinates::Coordinates;
use super::in_memory::Table;
use super::measure::{Accuracy, Measure};
use super::spec::Spec;
use super::values::Values;
use crate::{Contact, Ellipse, InvalidValue, Theory};

/// Builds a table, on all cores, and measures its error.
///
/// `prepare` gives the theory for a contact; `done` is called after each of [`Spec::steps`] steps.
///
/// # Errors
/// [`BuildError`] for a [`Spec`] or a theory of which there can be no table.
pub fn build<E: std::error::Error>(
    spec: &Spec,
    prepare: impl Fn(&Contact) -> Result<Box<dyn Theory>, E>,
    done: &(dyn Fn() + Sync),
) -> Result<Table, BuildError<E>> {
    spec.check()?;
    let Spec { a_over_b, poisson, intervals, .. } = *spec;
    let mut blocks = Vec::with_capacity(a_over_b.nodes * poisson.nodes);
    for material in poisson.shares() {
        for shape in a_over_b.shares() {
            let ratio = a_over_b.geometric(shape);
            let contact = Contact::new(Ellipse::from_ratio(ratio)?, poisson.even(material))?;
            let theory = prepare(&contact).map_err(BuildError::Theory)?;
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

/// Error of a table's build.
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
