//! Gap as a polynomial in x and y.

use super::error::GapError;
use super::wells::{Well, wells};
use crate::check;

/// One term `coefficient x^i y^j` of a polynomial gap, in metres throughout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term {
    /// Power of x.
    pub x: u32,
    /// Power of y.
    pub y: u32,
    /// Coefficient (m^(1-i-j)).
    pub coefficient: f64,
}

/// Coefficients by power of x, each a polynomial in y.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Polynomial {
    columns: Vec<Vec<f64>>,
    /// The deepest first.
    wells: Vec<Well>,
}

impl Polynomial {
    const MAX_POWER: u32 = 24;

    pub(super) fn new(terms: &[Term]) -> Result<Self, GapError> {
        let mut columns: Vec<Vec<f64>> = Vec::new();
        for (index, &Term { x, y, coefficient }) in terms.iter().enumerate() {
            check::finite("coefficient", coefficient)?;
            if x > Self::MAX_POWER || y > Self::MAX_POWER {
                return Err(GapError::Power { x, y, max: Self::MAX_POWER });
            }
            if terms[..index].iter().any(|other| (other.x, other.y) == (x, y)) {
                return Err(GapError::SameTerm { x, y });
            }
            let (x, y) = (x as usize, y as usize);
            columns.resize(columns.len().max(x + 1), Vec::new());
            let column = &mut columns[x];
            column.resize(column.len().max(y + 1), 0.0);
            column[y] = coefficient;
        }
        let at = |[x, y]: [f64; 2]| columns_at(&columns, x, y);
        let wells = wells(terms, at);
        Ok(Self { columns, wells })
    }

    pub(super) fn at(&self, x: f64, y: f64) -> f64 {
        columns_at(&self.columns, x, y)
    }

    pub(super) fn fill_row(&self, y: f64, xs: &[f64], out: &mut [f64]) {
        const COLUMNS: usize = Polynomial::MAX_POWER as usize + 1;
        let mut row = [0.0; COLUMNS];
        for (value, column) in row.iter_mut().zip(&self.columns) {
            *value = horner(column, y);
        }
        let row = &row[..self.columns.len()];
        for (out, &x) in out.iter_mut().zip(xs) {
            *out = horner(row, x);
        }
    }

    /// Its wells, the deepest first; one at least.
    pub(super) fn wells(&self) -> &[Well] {
        &self.wells
    }

    /// The gap in the deepest of them.
    pub(super) fn least(&self) -> f64 {
        self.wells.first().map_or(0.0, |well| well.height)
    }

    pub(super) fn power_of_x(&self) -> usize {
        self.columns.len().saturating_sub(1)
    }

    /// At `y`, where it opens as a parabola: height at the locus, half the curvature, the locus.
    pub(super) fn parabola(&self, y: f64) -> Option<[f64; 3]> {
        let at = |power: usize| self.columns.get(power).map_or(0.0, |column| horner(column, y));
        let [height, slope, bend] = [at(0), at(1), at(2)];
        let locus = -0.5 * slope / bend;
        let opens = self.power_of_x() == 2 && bend > 0.0;
        opens.then_some([height + 0.5 * slope * locus, bend, locus])
    }

    /// Whether it is a parabola along x about x = 0 everywhere.
    pub(super) fn is_even_parabola(&self) -> bool {
        let slopes = self.columns.get(1).into_iter().flatten();
        self.power_of_x() == 2 && slopes.into_iter().all(|coefficient| *coefficient == 0.0)
    }
}

fn columns_at(columns: &[Vec<f64>], x: f64, y: f64) -> f64 {
    columns.iter().rev().fold(0.0, |sum, column| sum * x + horner(column, y))
}

fn horner(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}
