//! The solved fields of one grid: element by element, and interpolated between elements.

use super::grid::Grid;
use super::solver::State;
use super::stick_slip_boundary::Borders;
use crate::theory::{FieldPoint, Region};

/// Traction, slip and state of one element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementField {
    /// Traction at the centroid of the pressure, and slip, by Coulomb's law of the element as a whole.
    pub point: FieldPoint,
    /// Mean over the element of the traction bound over its largest value, both at rest.
    pub bound: f64,
    /// Share of the normal force that the element carries.
    pub share: f64,
    /// Frictional power of the element over `mu N mu c V / rho`.
    pub power: f64,
    /// Corners of the element, all around, in units of `c`.
    pub corners: [[f64; 2]; 4],
    /// How far each corner is from the border of adhesion along `x`, in units of `c`: negative in adhesion,
    /// positive in slip; -1 and 1 where elements adhere or slide as a whole.
    pub beyond: [f64; 4],
}

impl ElementField {
    /// [`ElementField::beyond`] of an element that adheres or slides as a whole.
    pub(crate) fn whole(region: Region) -> [f64; 4] {
        [if region == Region::Slip { 1.0 } else { -1.0 }; 4]
    }

    /// Its mirror image fore and aft: `x` the other way.
    #[must_use]
    pub fn fore_and_aft(&self) -> Self {
        let turned = |[x, y]: [f64; 2]| [-x, y];
        let FieldPoint { position, traction, slip, region } = self.point;
        let point = FieldPoint {
            position: turned(position),
            traction: turned(traction),
            slip: turned(slip),
            region,
        };
        // Corners stay in order around the element.
        let corner = |k: usize| turned(self.corners[3 - k]);
        Self {
            point,
            corners: [0, 1, 2, 3].map(corner),
            beyond: [0, 1, 2, 3].map(|k: usize| self.beyond[3 - k]),
            ..*self
        }
    }

    /// The part of the element that adheres: corners, all around; none where all of it slides.
    #[must_use]
    pub fn adhering(&self) -> Vec<[f64; 2]> {
        let mut polygon = Vec::with_capacity(5);
        for (one, other) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
            let [from, to] = [one, other].map(|k| self.beyond[k]);
            let [start, end] = [one, other].map(|k| self.corners[k]);
            if from <= 0.0 {
                polygon.push(start);
            }
            if (from <= 0.0) != (to <= 0.0) {
                let part = from / (from - to);
                polygon.push([0, 1].map(|k| start[k] + part * (end[k] - start[k])));
            }
        }
        polygon
    }
}

/// A grid's solution with its borders of adhesion.
#[derive(Debug)]
pub(crate) struct FieldInterpolation<'a> {
    grid: &'a Grid,
    state: &'a State,
    borders: Borders,
}

impl<'a> FieldInterpolation<'a> {
    pub(crate) fn new(grid: &'a Grid, state: &'a State) -> Self {
        Self { grid, state, borders: Borders::new(grid, state) }
    }

    /// Element `i` of a strip. Its region and slip are the whole element's, by Coulomb's law.
    pub(crate) fn element(&self, strip: usize, i: usize) -> ElementField {
        let (pressure, mesh) = (&self.grid.pressure, &self.grid.mesh);
        let element = mesh.elements(strip).start + i;
        let bound = pressure.bounds[element];
        let (traction, slip) = self.state.traction_and_slip(self.grid, element);
        ElementField {
            point: FieldPoint {
                position: pressure.centroids[element],
                traction: traction.map(|t| bound * t),
                slip: slip.unwrap_or_default(),
                region: if slip.is_some() { Region::Slip } else { Region::Adhesion },
            },
            bound,
            share: pressure.shares[element],
            power: self.state.power(self.grid, element),
            corners: mesh.strips[strip].corners(i),
            beyond: self.beyond_of_corners(strip, i),
        }
    }

    fn beyond_of_corners(&self, strip: usize, i: usize) -> [f64; 4] {
        let mesh = &self.grid.mesh;
        let corners = mesh.strips[strip].corners(i);
        corners.map(|[x, y]| self.borders.beyond(mesh.strips_across(strip, y), x))
    }

    /// At a position of the mesh in a strip, or beyond its sides, given also as its `x` over the
    /// half-length: between the middles of elements the traction over its bound and the slip are
    /// interpolated, the border of adhesion picks the region. `bound` is that there.
    pub(crate) fn at(
        &self,
        strip: usize,
        position: [f64; 2],
        along: f64,
        bound: f64,
    ) -> FieldPoint {
        let ([x, y], mesh) = (position, &self.grid.mesh);
        let ([mut p, mut q], [mut u, mut v]) = ([0.0; 2], [0.0; 2]);
        for (element, weight) in mesh.around(strip, y, along) {
            let (traction, slip) = self.state.traction_and_slip(self.grid, element);
            let slip = slip.unwrap_or_default();
            p += weight * traction[0];
            q += weight * traction[1];
            u += weight * slip[0];
            v += weight * slip[1];
        }
        let beyond = self.borders.beyond(mesh.strips_across(strip, y), x);
        let (region, slip) =
            if beyond <= 0.0 { (Region::Adhesion, [0.0; 2]) } else { (Region::Slip, [u, v]) };
        FieldPoint { position, traction: [bound * p, bound * q], slip, region }
    }
}

/// Adhesion area over contact area, 0 to 1.
#[must_use]
pub fn adhesion_share(elements: &[ElementField]) -> f64 {
    let adhering = |element: &ElementField| polygon_area(&element.adhering());
    let whole = |element: &ElementField| polygon_area(&element.corners);
    elements.iter().map(adhering).sum::<f64>() / elements.iter().map(whole).sum::<f64>()
}

fn polygon_area(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(p, q)| 0.5 * (p[0] * q[1] - p[1] * q[0])).sum::<f64>().abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &[[f64; 2]]) -> f64 {
        let next = polygon.iter().cycle().skip(1);
        0.5 * polygon.iter().zip(next).map(|([a, b], [c, d])| a * d - b * c).sum::<f64>()
    }

    #[test]
    fn an_element_is_cut_where_its_corners_say() {
        let corners = [[1.0, 0.0], [1.0, 2.0], [0.0, 2.0], [0.0, 0.0]];
        let point = FieldPoint::outside([0.5, 1.0]);
        let element = |beyond: [f64; 4]| ElementField {
            point,
            bound: 0.0,
            share: 0.0,
            power: 0.0,
            corners,
            beyond,
        };
        for (beyond, part) in [
            (ElementField::whole(Region::Adhesion), 2.0),
            (ElementField::whole(Region::Slip), 0.0),
            ([-1.0, -1.0, 3.0, 3.0], 0.5),
            ([-1.0, 1.0, 1.0, 1.0], 0.25),
            ([1.0, -3.0, 1.0, 3.0], 0.5625),
        ] {
            let found = area(&element(beyond).adhering());
            assert!((found - part).abs() < 1e-15, "{beyond:?} {found}");
        }
    }
}
