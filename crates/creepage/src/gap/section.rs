//! Gap by a section across rolling, and a radius along it.

use super::cubic::{Cell, Cubic};
use super::error::{GapError, all_finite};
use super::grid::Grid;
use crate::check;

/// Shape of the gap along the rolling direction on either side of its locus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rolling<'a> {
    /// One radius for all y: `h = h(y) + x^2 / (2 R)` (m).
    Radius(f64),
    /// `h = h(y) + (x - x0(y))^2 / (2 R(y))`: radius and locus at each y of the section (m).
    Varying {
        /// Radii `R`, as many as points.
        radius: &'a [f64],
        /// Places `x0`, as many as points; empty for zero.
        locus: &'a [f64],
    },
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Section {
    y: Vec<f64>,
    height: Cubic,
    along: CurvatureAlong,
    /// What the gap has beyond its parabolas, over `x - x0` and y.
    excess: Option<Box<Grid>>,
}

#[derive(Debug, Clone, PartialEq)]
enum CurvatureAlong {
    Constant(f64),
    Varying { curvature: Cubic, locus: Option<Cubic> },
}

impl Section {
    pub(super) fn new(y: &[f64], gap: &[f64], rolling: Rolling) -> Result<Self, GapError> {
        const NEEDED: usize = 3;
        let order = sorted("y", y)?;
        let column = |quantity, values: &[f64]| column(quantity, values, &order);
        let (sorted_y, height) = (column("y", y)?, column("gap", gap)?);
        if order.len() < NEEDED {
            return Err(GapError::TooFew { quantity: "y", count: order.len(), needed: NEEDED });
        }
        let curve = |values| Cubic::new(sorted_y.clone(), values);
        let along = match rolling {
            Rolling::Radius(radius) => {
                CurvatureAlong::Constant(0.5 / check::positive("radius_rolling", radius)?)
            }
            Rolling::Varying { radius, locus } => {
                for &radius in radius {
                    check::positive("radius_rolling", radius)?;
                }
                let radius = column("radius_rolling", radius)?;
                let locus = (!locus.is_empty()).then(|| column("x", locus)).transpose()?;
                let curvature = curve(radius.into_iter().map(|radius| 0.5 / radius).collect());
                CurvatureAlong::Varying { curvature, locus: locus.map(curve) }
            }
        };
        Ok(Self { height: curve(height), y: sorted_y, along, excess: None })
    }

    /// The same with an excess over its parabolas, `d = x - x0` and y increasing, in rows of one y.
    pub(super) fn with_excess(
        self,
        d: &[f64],
        y: &[f64],
        excess: &[f64],
    ) -> Result<Self, GapError> {
        const NEEDED: usize = 3;
        for (quantity, values) in [("d", d), ("y", y)] {
            if values.len() < NEEDED {
                let count = values.len();
                return Err(GapError::TooFew { quantity, count, needed: NEEDED });
            }
            all_finite(quantity, values)?;
            if values.windows(2).any(|pair| pair[0] >= pair[1]) {
                return Err(GapError::Order { quantity });
            }
        }
        let (count, expected) = (excess.len(), d.len() * y.len());
        if count != expected {
            return Err(GapError::Lengths { quantity: "excess", count, expected });
        }
        all_finite("excess", excess)?;
        let grid = Grid::of(d.to_vec(), y.to_vec(), excess);
        Ok(Self { excess: Some(Box::new(grid)), ..self })
    }

    /// Whether every section along x is a parabola.
    pub(super) fn is_parabola_along(&self) -> bool {
        self.excess.is_none()
    }

    /// The gap at many places of one y.
    pub(super) fn fill_row(&self, y: f64, xs: &[f64], out: &mut [f64]) {
        let [height, half, locus] = self.row(y);
        for (out, &x) in out.iter_mut().zip(xs) {
            let d = x - locus;
            let excess = self.excess.as_ref().map_or(0.0, |grid| grid.within(d, y));
            *out = height + half * d * d + excess;
        }
    }

    /// Height at the locus, half the curvature along, and the locus.
    pub(super) fn row(&self, y: f64) -> [f64; 3] {
        let cell = Cell::new(&self.y, y);
        let height = self.height.in_cell(&cell);
        match &self.along {
            CurvatureAlong::Constant(half) => [height, *half, 0.0],
            CurvatureAlong::Varying { curvature, locus } => {
                let locus = locus.as_ref().map_or(0.0, |locus| locus.in_cell(&cell));
                [height, curvature.in_cell(&cell), locus]
            }
        }
    }

    pub(super) fn locus(&self, y: f64) -> f64 {
        match &self.along {
            CurvatureAlong::Varying { locus: Some(locus), .. } => locus.at(y),
            _ => 0.0,
        }
    }

    /// The locus, where it is the same everywhere.
    pub(super) fn axis(&self) -> Option<f64> {
        match &self.along {
            _ if self.excess.is_some() => None,
            CurvatureAlong::Constant(_) | CurvatureAlong::Varying { locus: None, .. } => Some(0.0),
            CurvatureAlong::Varying { locus: Some(locus), .. } => locus.constant(),
        }
    }

    /// The points' y, increasing.
    pub(super) fn y(&self) -> &[f64] {
        &self.y
    }
}

/// The order that sorts a column.
fn sorted(quantity: &'static str, values: &[f64]) -> Result<Vec<usize>, GapError> {
    all_finite(quantity, values)?;
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&one, &other| values[one].total_cmp(&values[other]));
    match order.windows(2).find(|pair| values[pair[1]] - values[pair[0]] <= 0.0) {
        Some(pair) => Err(GapError::SameY { y: values[pair[0]] }),
        None => Ok(order),
    }
}

fn column(quantity: &'static str, values: &[f64], order: &[usize]) -> Result<Vec<f64>, GapError> {
    if values.len() != order.len() {
        let (count, expected) = (values.len(), order.len());
        return Err(GapError::Lengths { quantity, count, expected });
    }
    all_finite(quantity, values)?;
    Ok(order.iter().map(|&i| values[i]).collect())
}
