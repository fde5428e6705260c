//! Subdivision of a strip into elements, and of elements into subcells.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// Subcells of an element, along and across; see [`super::quadrature`].
pub(crate) const SUBCELLS: usize = 4;

/// Places along a strip over its half-length, from 1 at the leading edge to -1; strips that are cut alike share
/// them.
#[derive(Debug, Clone)]
pub(crate) struct Pieces {
    /// Cuts between subcells; every [`SUBCELLS`]th one is between elements.
    pub cuts: Vec<f64>,
    /// Middle between the cuts of each element.
    pub middles: Vec<f64>,
    /// The angle in the middle of each element, whose sine is a place.
    pub angles: Vec<f64>,
}

impl Pieces {
    /// Of elements and subcells between some cuts.
    pub(crate) fn new(cuts: Vec<f64>) -> Arc<Self> {
        let ends: Vec<f64> = cuts.iter().step_by(SUBCELLS).copied().collect();
        let middle = |pair: &[f64]| 0.5 * (pair[0] + pair[1]);
        let angles: Vec<f64> = ends.iter().map(|cut| cut.asin()).collect();
        Arc::new(Self {
            cuts,
            middles: ends.windows(2).map(middle).collect(),
            angles: angles.windows(2).map(middle).collect(),
        })
    }

    /// Of so many elements, at equal steps of the angle.
    pub(crate) fn of_equal_angles(elements: usize) -> Arc<Self> {
        let pieces = (SUBCELLS * elements) as f64;
        let cut = |piece: usize| (FRAC_PI_2 * (1.0 - 2.0 * piece as f64 / pieces)).sin();
        Self::new((0..=SUBCELLS * elements).map(cut).collect())
    }

    /// Number of elements.
    pub(crate) fn len(&self) -> usize {
        self.middles.len()
    }

    /// Cut `i` of the elements.
    pub(crate) fn cut(&self, i: usize) -> f64 {
        self.cuts[SUBCELLS * i]
    }

    /// The element that holds a place.
    pub(crate) fn element_at(&self, place: f64) -> usize {
        let last = self.len().saturating_sub(1);
        (0..last).find(|i| self.cut(i + 1) < place).unwrap_or(last)
    }
}
