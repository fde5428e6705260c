//! Specification of a table to build.

use crate::InvalidValue;

use super::axis::Axis;
use super::in_memory::Provenance;
use super::values::{Intervals, Values};

/// Specification of a table to build.
#[derive(Debug, Clone, PartialEq)]
pub struct Spec {
    /// Nodes along the ratio of semi-axes.
    pub a_over_b: Axis,
    /// Nodes along Poisson's ratio.
    pub poisson: Axis,
    /// Intervals in creepage and spin.
    pub intervals: Intervals,
    /// At how many random places to measure the error, 1 to a million, and at about as many hard ones.
    pub places: usize,
    /// Where the table comes from.
    pub provenance: Provenance,
}

impl Spec {
    /// Most nodes of a table: 24 bytes each.
    const MOST_NODES: usize = 100_000_000;
    /// Most random places: minutes of the full theory.
    const MOST_PLACES: usize = 1_000_000;
    const PLACES: &str = "between 1 and 1000000: without any the table's error is not known";

    /// Number of steps of which [`build`](crate::table::build()) tells; none where the specification
    /// makes no sense.
    #[must_use]
    pub fn steps(&self) -> usize {
        if self.check().is_err() {
            return 0;
        }
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
        range("poisson", self.poisson, 0.0)?;
        let nodes = self.intervals.nodes() * self.a_over_b.nodes * self.poisson.nodes;
        within("nodes in all", nodes, 1..=Self::MOST_NODES, "at most 100 million (2.4 GB)")?;
        within("places", self.places, 1..=Self::MOST_PLACES, Self::PLACES)
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
