//! The ellipse that stands for a patch, and the springs and coefficients that follow from it.

use std::f64::consts::PI;

use super::rows::Row;
use crate::approximate::dual::Real;
use crate::approximate::linear::CreepageCoefficients;
use crate::check::InvalidValue;
use crate::normal::Patch;
use crate::{Contact, Ellipse};

/// A patch in the units of the contact, replaced by an ellipse of the same area whose axes are as
/// the longest row to the width.
#[derive(Debug, Clone)]
pub(super) struct Springs {
    /// Centre of pressure.
    pub(super) centroid: [f64; 2],
    /// Root of the ellipse's axes' product.
    pub(super) radius: f64,
    /// Its axes' ratio `a/b`.
    pub(super) ratio: f64,
    pub(super) coefficients: CreepageCoefficients,
    /// `L1`, `L2`, `L3` times `G`.
    flexibilities: [f64; 3],
}

impl Springs {
    /// `rows` are those of the patch.
    pub(super) fn new<'r>(
        patch: &Patch,
        rows: impl Iterator<Item = &'r Row>,
        poisson: f64,
        length: f64,
    ) -> Result<Self, InvalidValue> {
        let (longest, [low, high]) = rows.fold(
            (0.0_f64, [f64::INFINITY, f64::NEG_INFINITY]),
            |(longest, [low, high]), row| {
                let [from, to] = row.borders;
                (longest.max(2.0 * row.half), [low.min(from), high.max(to)])
            },
        );
        let ratio = (longest / (high - low)).clamp(RATIO[0], RATIO[1]);
        let contact = Contact::new(Ellipse::from_ratio(ratio)?, poisson)?;
        let coefficients = CreepageCoefficients::interpolated(&contact)?;
        let radius = (patch.area() / PI).sqrt() / length;
        let CreepageCoefficients { c11, c22, c23, .. } = coefficients;
        let a = radius * ratio.sqrt();
        let along = 8.0 * a / 3.0;
        let flexibilities = [along / c11, along / c22, PI * a * ratio.sqrt() / (4.0 * c23)];
        let centroid = patch.centroid().map(|at| at / length);
        Ok(Self { centroid, radius, ratio, coefficients, flexibilities })
    }

    /// The creepage at the centre of pressure, from that at the origin.
    pub(super) fn at_centre<R: Real>(&self, [xi, eta, chi]: [R; 3], more: [f64; 2]) -> [R; 3] {
        let [x, y] = self.centroid;
        [xi - chi * y + more[0], eta + chi * x + more[1], chi]
    }

    /// One flexibility times `G`, at a creepage at the centre of pressure:
    /// `1/L^2 = sum (w_i/L_i)^2 / sum w_i^2`, `w = (xi, eta, chi sqrt(ab))`.
    pub(super) fn flexibility<R: Real>(&self, [xi, eta, chi]: [R; 3]) -> R {
        let parts = [xi, eta, chi * self.radius];
        let largest = parts.iter().fold(0.0_f64, |m, v| m.max(v.value().abs()));
        if !(largest > 0.0 && largest.recip().is_finite()) {
            return R::constant(self.flexibilities[0]);
        }
        // A ratio of creepages: scaled, no square of them underflows.
        let squares = parts.map(|v| v * largest.recip()).map(|v| v * v);
        let weighted = [0, 1, 2].map(|i| squares[i] * self.flexibilities[i].powi(-2));
        ((squares[0] + squares[1] + squares[2]) / (weighted[0] + weighted[1] + weighted[2])).sqrt()
    }

    /// Growth of the traction times `1/G` by creepages at the centre of pressure, at a place, with a
    /// spring for each: `[x, y]` over a step of one.
    pub(super) fn three<R: Real>(&self, [xi, eta, chi]: [R; 3], at: [f64; 2]) -> [R; 2] {
        let [l1, l2, l3] = self.flexibilities.map(f64::recip);
        let [x, y] = [0, 1].map(|k| at[k] - self.centroid[k]);
        [xi * l1 - chi * (l3 * y), eta * l2 + chi * (l3 * x)]
    }
}

/// The coefficients are known within these ratios.
const RATIO: [f64; 2] = [1e-2, 1e2];
