//! Equivalent ellipse of a patch, and the springs and coefficients that follow from it.

use std::f64::consts::PI;

use super::rows::Row;
use crate::approximate::dual::Real;
use crate::approximate::fastsim::{Flexibilities, Flexibility};
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
    /// In units of its radius.
    flexibilities: Flexibilities,
}

impl Springs {
    /// `rows` are those of the patch; `gain` is the linear force over what friction bears in this patch, by
    /// a creepage of one with a coefficient and a length of one.
    pub(super) fn new<'r>(
        patch: &Patch,
        rows: impl Iterator<Item = &'r Row>,
        poisson: f64,
        [length, gain]: [f64; 2],
    ) -> Result<Self, InvalidValue> {
        let (longest, [low, high]) = rows.fold(
            (0.0_f64, [f64::INFINITY, f64::NEG_INFINITY]),
            |(longest, [low, high]), row| {
                let [from, to] = row.borders;
                (longest.max(2.0 * row.half), [low.min(from), high.max(to)])
            },
        );
        let ratio = (longest / (high - low)).clamp(RATIO[0], RATIO[1]);
        let ellipse = Ellipse::from_ratio(ratio)?;
        let contact = Contact::new(ellipse, poisson)?;
        let coefficients = CreepageCoefficients::interpolated(&contact)?;
        let radius = (patch.area() / PI).sqrt() / length;
        let kappa = gain * radius * radius;
        let flexibilities = Flexibilities::with_kappa(&ellipse, kappa, &coefficients)?;
        let centroid = patch.centroid().map(|at| at / length);
        Ok(Self { centroid, radius, ratio, coefficients, flexibilities })
    }

    /// The creepage at the centre of pressure, from that at the origin.
    pub(super) fn at_centre<R: Real>(&self, [xi, eta, chi]: [R; 3], more: [f64; 2]) -> [R; 3] {
        let [x, y] = self.centroid;
        [xi - chi * y + more[0], eta + chi * x + more[1], chi]
    }

    /// Reciprocals of `G L1`, `G L2` and `G L3` at a creepage at the centre of pressure, blended as
    /// [`Flexibility::Blended`] on the ellipse.
    pub(super) fn stiffnesses<R: Real>(&self, [xi, eta, chi]: [R; 3]) -> [R; 3] {
        let own = [xi, eta, chi * self.radius];
        let flexibilities = self.flexibilities.effective(Flexibility::Blended, own);
        flexibilities.map(|l| R::constant(self.radius.recip()) / l)
    }

    /// Growth of the traction times `1/G` by creepages at the centre of pressure, at a place, with a
    /// spring for each: `[x, y]` over a step of one.
    pub(super) fn three<R: Real>(&self, [xi, eta, chi]: [R; 3], at: [f64; 2]) -> [R; 2] {
        let zero = [0.0; 3];
        let [l1, l2, l3] = self.flexibilities.effective(Flexibility::Three, zero);
        let [l1, l2, l3] = [l1, l2, l3].map(|l| (l * self.radius).recip());
        let [x, y] = [0, 1].map(|k| at[k] - self.centroid[k]);
        [xi * l1 - chi * (l3 * y), eta * l2 + chi * (l3 * x)]
    }
}

/// The coefficients are known within these ratios.
const RATIO: [f64; 2] = [1e-2, 1e2];
