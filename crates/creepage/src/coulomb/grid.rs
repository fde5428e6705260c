//! One resolution, prepared: the slip of every element by the traction of every other.

use std::f64::consts::PI;

use super::elements::Elements;
use super::ends::Ends;
use super::influence::{Response, edge};
use super::row::Row;
use super::sampling::Sampling;
use super::unlike::{self, Drive};
use crate::Creepage;
use crate::ellipse::Ellipse;

/// Elements and their response.
///
/// The unknown of an element is its traction over its traction bound, a vector in the unit disc.
/// The slip of an element is `rigid slip at its place + slip by the pressure + sum of
/// coefficient * traction`.
///
/// The elastic slip over the step between the centres of two elements is the difference of their
/// displacements over its length. Where an element takes it from steps upstream only, nothing
/// downstream decides whether it adheres, and adhesion is the same equation everywhere: two
/// steps, extrapolated to the element's centre, are of second order.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    pub elements: Elements,
    /// Where each element's slip is that of the step extrapolated.
    pub places: Vec<[f64; 2]>,
    /// Coefficients of the lower half of the strips, row by row; the upper half mirrors them.
    coefficients: [Vec<f64>; 3],
    /// Where the tractions are summed up.
    pub sampling: Sampling,
    /// Slip of each element that the pressure causes between unlike bodies.
    pub pressure_slip: Vec<[f64; 2]>,
    /// Unit `mu c / rho` of slip over `mu` times the peak pressure over `G`.
    slip_unit: f64,
    /// Weight `r` of slip against traction in the projection of each element. Any has the same
    /// solution; with a share of the traction that its own slip asks for the iteration neither
    /// cycles nor crawls.
    pub weights: Vec<f64>,
}

/// Of the traction that an element's own slip asks for.
const WEIGHT: f64 = 0.3;

impl Grid {
    pub(super) fn new(ellipse: Ellipse, poisson: f64, along: usize, strips: usize) -> Self {
        let elements = Elements::new(ellipse, along, strips);
        // Slip in units of mu c / rho: (4.20) with the unit of slip mu f00.
        let slip_unit = (1.0 - poisson) * ellipse.integrals().e / (2.0 * ellipse.g().sqrt());
        let mut steps = Steps::new(&elements, poisson, 1.0 / (PI * slip_unit));
        let stored = strips.div_ceil(2) * along * elements.len();
        let mut grid = Self {
            places: Vec::with_capacity(elements.len()),
            coefficients: std::array::from_fn(|_| Vec::with_capacity(stored)),
            sampling: Sampling::new(along, strips, ellipse.ratio()),
            pressure_slip: vec![[0.0; 2]; elements.len()],
            slip_unit,
            weights: Vec::new(),
            elements,
        };
        for strip in 0..strips {
            let ends = Ends::new(&grid.elements, strip);
            grid.places.extend(ends.places());
            if strip < strips.div_ceil(2) {
                steps.compute(&grid.elements, &ends);
                steps.append(&ends, &mut grid.coefficients);
            }
        }
        grid.weights = (0..grid.elements.len()).map(|e| WEIGHT / grid.self_response(e)).collect();
        grid
    }

    /// Adds to the slip what the pressure causes between unlike bodies.
    pub(super) fn set_unlikeness(&mut self, ellipse: Ellipse, kappa_over_mu: f64) {
        let factor = kappa_over_mu / self.slip_unit;
        self.pressure_slip.clear();
        for strip in 0..self.elements.strips {
            let ends = Ends::new(&self.elements, strip);
            let displacement: Vec<_> = (0..=self.elements.along)
                .map(|end| unlike::displacement(ellipse, ends.at(end)).map(|d| factor * d))
                .collect();
            self.pressure_slip.extend(ends.slip(&displacement));
        }
    }

    fn self_response(&self, element: usize) -> f64 {
        let (row, column, _) = self.block(element / self.elements.along, element);
        let own = column + element % self.elements.along;
        row.xx[own].abs().max(row.yy[own].abs())
    }

    /// Coefficients of an element by all tractions, and -1 when these must be taken in the order
    /// of the mirror image.
    pub(super) fn row(&self, element: usize) -> (Row<'_>, f64) {
        let (along, n) = (self.elements.along, self.elements.len());
        let strip = element / along;
        let mirrored = self.elements.strips - 1 - strip;
        let (stored, sign) = if strip <= mirrored { (strip, 1.0) } else { (mirrored, -1.0) };
        let start = (stored * along + element % along) * n;
        let [xx, xy, yy] = &self.coefficients;
        let range = start..start + n;
        (Row { xx: &xx[range.clone()], xy: &xy[range.clone()], yy: &yy[range] }, sign)
    }

    /// An element's row, the column in it where the tractions of `strip` begin, and its sign.
    fn block(&self, strip: usize, element: usize) -> (Row<'_>, usize, f64) {
        let (row, sign) = self.row(element);
        let strip = if sign > 0.0 { strip } else { self.elements.strips - 1 - strip };
        (row, strip * self.elements.along, sign)
    }

    /// Coefficients of an element by the tractions of its own strip; `xy` needs the sign.
    pub(super) fn own_strip(&self, element: usize) -> (Row<'_>, f64) {
        let along = self.elements.along;
        let (row, start, sign) = self.block(element / along, element);
        let range = start..start + along;
        (Row { xx: &row.xx[range.clone()], xy: &row.xy[range.clone()], yy: &row.yy[range] }, sign)
    }

    pub(super) fn rigid_slip(&self, creepage: Creepage, element: usize) -> [f64; 2] {
        creepage.rigid_slip(self.places[element])
    }

    /// Slip of an element by all but the tangential tractions.
    pub(super) fn driven_slip(&self, drive: Drive, element: usize) -> [f64; 2] {
        let (rigid, by_pressure) =
            (self.rigid_slip(drive.creepage, element), self.pressure_slip[element]);
        [0, 1].map(|k| rigid[k] + drive.side * by_pressure[k])
    }
}

/// Displacements and their differences along one strip, by all elements.
struct Steps {
    poisson: f64,
    scale: f64,
    along: usize,
    displacement: Vec<Response>,
    previous: Vec<Response>,
    /// Elastic slip over each step, step by step.
    slip: Vec<Response>,
}

impl Steps {
    fn new(elements: &Elements, poisson: f64, scale: f64) -> Self {
        let along = elements.along;
        let blank = vec![[0.0; 3]; elements.len()];
        Self {
            poisson,
            scale,
            along,
            displacement: blank.clone(),
            previous: blank,
            slip: vec![[0.0; 3]; elements.len() * along],
        }
    }

    fn compute(&mut self, elements: &Elements, ends: &Ends) {
        let n = elements.len();
        for end in 0..=self.along {
            std::mem::swap(&mut self.displacement, &mut self.previous);
            self.displace(elements, ends.at(end));
            if end == 0 {
                continue;
            }
            let length = ends.length(end);
            for j in 0..n {
                self.slip[(end - 1) * n + j] = std::array::from_fn(|k| {
                    (self.previous[j][k] - self.displacement[j][k]) / length
                });
            }
        }
    }

    /// Displacement at a point by every element at its bound. Neighbours in a strip share the
    /// cut between them, and what it adds.
    fn displace(&mut self, elements: &Elements, [x, y]: [f64; 2]) {
        for strip in 0..elements.strips {
            let ends = |i: usize| elements.cut_ends(strip, i).map(|[p, q]| [p - x, q - y]);
            let mut front = ends(0);
            let mut ahead = edge(self.poisson, front[0], front[1]);
            for i in 0..self.along {
                let rear = ends(i + 1);
                let behind = edge(self.poisson, rear[0], rear[1]);
                let lower = edge(self.poisson, rear[0], front[0]);
                let upper = edge(self.poisson, rear[1], front[1]);
                let element = strip * self.along + i;
                let factor = self.scale * elements.bounds[element];
                self.displacement[element] =
                    std::array::from_fn(|k| factor * (ahead[k] - behind[k] + lower[k] - upper[k]));
                (front, ahead) = (rear, behind);
            }
        }
    }

    fn append(&self, ends: &Ends, coefficients: &mut [Vec<f64>; 3]) {
        let n = self.displacement.len();
        for i in 0..self.along {
            let by = ends.extrapolation(i);
            let last = &self.slip[i * n..(i + 1) * n];
            let before = if i == 0 { last } else { &self.slip[(i - 1) * n..i * n] };
            for (k, row) in coefficients.iter_mut().enumerate() {
                row.extend(last.iter().zip(before).map(|(l, b)| l[k] + by * (l[k] - b[k])));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stored half and its mirror image, against a grid computed without the symmetry.
    #[test]
    fn the_upper_half_mirrors_the_lower() {
        let grid = Grid::new(Ellipse::from_ratio(0.7).unwrap(), 0.3, 5, 4);
        let elements = &grid.elements;
        let mut steps = Steps::new(elements, 0.3, 1.0);
        let scale = {
            let mut lower = Steps::new(elements, 0.3, 1.0);
            lower.compute(elements, &Ends::new(elements, 0));
            grid.row(0).0.xx[0] / lower.slip[0][0]
        };
        steps.scale = scale;
        let ends = Ends::new(elements, 3);
        steps.compute(elements, &ends);
        let mut direct: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::new());
        steps.append(&ends, &mut direct);
        let x: Vec<f64> = (0..20).map(|k| f64::from(k).sin()).collect();
        let y: Vec<f64> = (0..20).map(|k| f64::from(k).cos()).collect();
        let mirror = |v: &[f64]| v.chunks(5).rev().flatten().copied().collect::<Vec<_>>();
        for i in 0..5 {
            let (row, sign) = grid.row(15 + i);
            assert!(sign < 0.0);
            let found = row.apply(sign, &mirror(&x), &mirror(&y));
            let own = |k: usize| &direct[k][i * 20..(i + 1) * 20];
            let expected = Row { xx: own(0), xy: own(1), yy: own(2) }.apply(1.0, &x, &y);
            for k in 0..2 {
                // Rounding of sums of 40 terms of order one.
                assert!((found[k] - expected[k]).abs() < 1e-12);
            }
        }
    }
}
