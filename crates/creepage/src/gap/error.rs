//! Errors of an undeformed distance.

use crate::check::InvalidValue;

/// Error of numbers that do not describe an undeformed distance.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GapError {
    /// A number is outside its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// A row holds a number that is not finite.
    #[error("{quantity} of point {index} is {value}: it must be a finite number")]
    NotFinite {
        /// Which column.
        quantity: &'static str,
        /// Row of the point as given, from 0.
        index: usize,
        /// The value.
        value: f64,
    },
    /// Columns of one table differ in length.
    #[error("{quantity} has {count} values, but there are {expected} points")]
    Lengths {
        /// Which column.
        quantity: &'static str,
        /// Its number of values.
        count: usize,
        /// The number of values of the first column.
        expected: usize,
    },
    /// Too few points to interpolate.
    #[error("{count} different values of {quantity}: at least {needed} are needed")]
    TooFew {
        /// Which coordinate.
        quantity: &'static str,
        /// How many different values there are.
        count: usize,
        /// How many are needed.
        needed: usize,
    },
    /// Places do not increase.
    #[error("{quantity} must increase from one to the next")]
    Order {
        /// Which coordinate.
        quantity: &'static str,
    },
    /// What a gap has beyond its parabolas, where it has none.
    #[error("only a section opens by parabolas along rolling and can have an excess over them")]
    NoSection,
    /// Two points of a section at one place.
    #[error("two points at y = {y}")]
    SameY {
        /// The place (m).
        y: f64,
    },
    /// Two points of a grid at one place.
    #[error("two points at x = {x}, y = {y}")]
    SamePlace {
        /// The place along rolling (m).
        x: f64,
        /// The place across (m).
        y: f64,
    },
    /// The points do not fill a rectangular grid.
    #[error(
        "no point at x = {x}, y = {y}: {columns} different x and {rows} different y make a grid \
         of {} points, but {count} are given", columns * rows
    )]
    Hole {
        /// The first place without a point, along rolling (m).
        x: f64,
        /// The same across (m).
        y: f64,
        /// Different values of x.
        columns: usize,
        /// Different values of y.
        rows: usize,
        /// Number of points given.
        count: usize,
    },
    /// Two terms of a polynomial with the same powers.
    #[error("two terms x^{x} y^{y}")]
    SameTerm {
        /// Power of x.
        x: u32,
        /// Power of y.
        y: u32,
    },
    /// A power too high to be meant.
    #[error("term x^{x} y^{y}: powers are at most {max}")]
    Power {
        /// Power of x.
        x: u32,
        /// Power of y.
        y: u32,
        /// The largest power.
        max: u32,
    },
}

/// The first value of a column that is not finite is an error.
pub(super) fn all_finite(quantity: &'static str, values: &[f64]) -> Result<(), GapError> {
    match values.iter().position(|value| !value.is_finite()) {
        Some(index) => Err(GapError::NotFinite { quantity, index, value: values[index] }),
        None => Ok(()),
    }
}
