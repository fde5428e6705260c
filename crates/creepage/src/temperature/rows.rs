//! Heated rows of elements, and the integral over the heat that was set free ahead.

use std::f64::consts::PI;

use super::HeatedPair;
use crate::check::{self, InvalidValue};

/// One element of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeatedElement {
    /// Where it ends and begins, the trailing end first (m).
    pub ends: [f64; 2],
    /// Mean heat of friction over the element (W/m2).
    pub heat: f64,
}

/// A row of elements along the rolling direction, from the leading to the trailing edge. The heat within an
/// element is linear, with the mean that is given; its slope is by the elements beside it, so small that no
/// heat is negative.
///
/// ```
/// use creepage::temperature::{HeatRow, HeatedElement, HeatedPair, ThermalSolid};
/// // The same heat all along: 2 sqrt 2 of the unit at the trailing edge.
/// let row = HeatRow::new(&[HeatedElement { ends: [-5e-3, 5e-3], heat: 1e8 }])?;
/// let pair = HeatedPair::new([ThermalSolid::STEEL; 2], [30.0; 2], [0.0; 2])?;
/// let (rise, unit) = (pair.weight().recip() * row.integral(-5e-3), pair.unit(1e8, 5e-3));
/// assert!((rise / unit - 8.0_f64.sqrt()).abs() < 1e-12);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct HeatRow {
    elements: Vec<Piece>,
}

/// An element with its slope of heat.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    ends: [f64; 2],
    heat: f64,
    slope: f64,
}

impl Piece {
    fn middle(&self) -> f64 {
        0.5 * (self.ends[0] + self.ends[1])
    }

    fn length(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }
}

impl HeatRow {
    /// A row of elements from the leading edge; they do not overlap.
    ///
    /// # Errors
    /// [`InvalidValue`] for ends that are not finite or not in that order, and for heat that is not finite or
    /// negative.
    pub fn new(elements: &[HeatedElement]) -> Result<Self, InvalidValue> {
        let mut ahead = f64::INFINITY;
        for HeatedElement { ends: [from, to], heat } in elements {
            check::finite("end of an element", *from)?;
            // Ends that two elements share differ by their rounding.
            let overlap = 1e-6 * (to - from);
            let valid = "before the element ahead of it";
            check::require(from < to && *to <= ahead + overlap, "end of an element", *to, valid)?;
            let valid = "finite and not negative";
            check::require(heat.is_finite() && *heat >= 0.0, "heat of an element", *heat, valid)?;
            ahead = *from;
        }
        let piece =
            |&HeatedElement { ends, heat }: &HeatedElement| Piece { ends, heat, slope: 0.0 };
        let mut row = Self { elements: elements.iter().map(piece).collect() };
        row.set_slopes();
        Ok(row)
    }

    /// Slopes by the differences to the elements beside (monotonized central differences): none at an
    /// extremum, and nowhere so steep that heat passes that of a neighbour.
    fn set_slopes(&mut self) {
        let slope = |one: &Piece, other: &Piece| {
            let apart = one.middle() - other.middle();
            let adjoin = apart <= 0.6 * (one.length() + other.length());
            (adjoin && apart > 0.0).then(|| (one.heat - other.heat) / apart)
        };
        let slopes: Vec<f64> = (0..self.elements.len())
            .map(|k| {
                let here = &self.elements[k];
                let ahead = k.checked_sub(1).and_then(|k| slope(&self.elements[k], here));
                let behind = self.elements.get(k + 1).and_then(|next| slope(here, next));
                let wanted = match (ahead, behind) {
                    (Some(ahead), Some(behind)) if ahead * behind <= 0.0 => 0.0,
                    (Some(ahead), Some(behind)) => {
                        let least = 2.0 * ahead.abs().min(behind.abs());
                        (0.5 * (ahead + behind)).clamp(-least, least)
                    }
                    (Some(only), None) | (None, Some(only)) => only,
                    (None, None) => 0.0,
                };
                let most = 2.0 * here.heat / here.length();
                wanted.clamp(-most, most)
            })
            .collect();
        for (piece, slope) in self.elements.iter_mut().zip(slopes) {
            piece.slope = slope;
        }
    }

    /// `1/sqrt(pi)` times the integral of the [equations](super) at `x` (m), ahead of, in or behind the row:
    /// over [`HeatedPair::weight`] it is the rise of the temperature.
    #[must_use]
    pub fn integral(&self, x: f64) -> f64 {
        let pieces = self.elements.iter().take_while(|piece| piece.ends[1] > x);
        let sum: f64 = pieces
            .map(|piece| {
                // With t the distance ahead, q = here + slope t; int q/sqrt(t) = 2 here sqrt(t) + 2/3 slope t^1.5.
                let here = piece.heat + piece.slope * (x - piece.middle());
                let at = |end: f64| {
                    let ahead = (end - x).max(0.0);
                    ahead.sqrt() * (2.0 * here + 2.0 / 3.0 * piece.slope * ahead)
                };
                at(piece.ends[1]) - at(piece.ends[0])
            })
            .sum();
        sum.max(0.0) / PI.sqrt()
    }

    /// Heat over the row's width (W/m).
    #[must_use]
    pub fn power(&self) -> f64 {
        self.elements.iter().map(|piece| piece.heat * piece.length()).sum()
    }

    /// Trailing and leading end (m); `None` without elements.
    #[must_use]
    pub fn ends(&self) -> Option<[f64; 2]> {
        let (first, last) = (self.elements.first()?, self.elements.last()?);
        Some([last.ends[0], first.ends[1]])
    }

    /// Ends and middles of all elements, from the leading edge: where the temperature is looked at.
    pub fn places(&self) -> impl Iterator<Item = f64> + '_ {
        let leading = self.elements.first().map(|piece| piece.ends[1]);
        let others = self.elements.iter().flat_map(|piece| [piece.middle(), piece.ends[0]]);
        leading.into_iter().chain(others)
    }

    /// Heat at `x` (W/m2), zero beside all elements.
    #[must_use]
    pub fn heat(&self, x: f64) -> f64 {
        let here = self.elements.iter().find(|piece| piece.ends[0] <= x && x <= piece.ends[1]);
        here.map_or(0.0, |piece| piece.heat + piece.slope * (x - piece.middle()))
    }

    /// The largest rise in the row by the heat of all `ahead`, and its place `x` (m): the highest of the
    /// [places](Self::places), and from there by golden sections. `None` without elements.
    #[must_use]
    pub fn hottest(
        &self,
        pair: &HeatedPair,
        rise_by_others: impl Fn(f64) -> f64,
    ) -> Option<[f64; 2]> {
        let rise = |x: f64| self.integral(x) / pair.weight() + rise_by_others(x);
        let places: Vec<f64> = self.places().collect();
        let rises: Vec<f64> = places.iter().map(|x| rise(*x)).collect();
        let highest = (0..places.len()).max_by(|i, j| rises[*i].total_cmp(&rises[*j]))?;
        let mut low = *places.get(highest + 1).unwrap_or(&places[highest]);
        let mut high = places[highest.saturating_sub(1)];
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        for _ in 0..SECTIONS {
            let [one, other] = [high - golden * (high - low), low + golden * (high - low)];
            if rise(one) > rise(other) { high = other } else { low = one }
        }
        let middle = 0.5 * (low + high);
        let found = rise(middle);
        let best = if found > rises[highest] {
            [found, middle]
        } else {
            [rises[highest], places[highest]]
        };
        Some(best)
    }
}

/// Golden sections of two halves of an element: to 1e-7 of it.
const SECTIONS: usize = 36;
