//! The full theory in the middle of a contact that is slender across the rolling direction: as
//! near to Carter's plane problem as it comes.

use creepage::InvalidValue;
use creepage::coulomb::{ElementField, Exact, Resolution};

use crate::prelude::*;

/// Ratio of the semi-axes.
const A_OVER_B: f64 = 1.0 / 32.0;

/// The full theory, asked by Carter's creepage `upsilon rho/(mu a)`.
pub(super) struct Middle {
    theory: Exact,
    /// Carter's creepage over `xi`: equal adhesion areas in the limit of a slender contact.
    scale: f64,
}

impl Middle {
    pub(super) fn new() -> Result<Self, InvalidValue> {
        let theory = Exact::new(&like_bodies(A_OVER_B, STEEL)?, Resolution::new(80, 20)?)?;
        let ellipse = creepage::Ellipse::from_ratio(A_OVER_B)?;
        Ok(Self { theory, scale: ellipse.integrals().e / ellipse.g().sqrt() })
    }

    /// `(x/a, traction over the largest bound)` in the middle strip.
    pub(super) fn tractions(&self, creepage: f64) -> Vec<[f64; 2]> {
        let half_length = A_OVER_B.sqrt();
        let at = |element: &ElementField| {
            [element.point.position[0] / half_length, element.point.traction[0]]
        };
        let mut points: Vec<_> = self.elements(creepage).iter().map(at).collect();
        points.sort_by(|one, two| one[0].total_cmp(&two[0]));
        points
    }

    /// Force of the middle strip over `mu` times its load.
    pub(super) fn force(&self, creepage: f64) -> f64 {
        let sum = |of: fn(&ElementField) -> f64, elements: &[ElementField]| -> f64 {
            elements.iter().map(of).sum()
        };
        let elements = self.elements(creepage);
        let force = sum(|e| e.share * e.point.traction[0] / e.bound, &elements);
        force / sum(|e| e.share, &elements)
    }

    /// The elements of the strip next to the middle.
    fn elements(&self, creepage: f64) -> Vec<ElementField> {
        let solved = self.theory.solve_contact(rolling_at([creepage / self.scale, 0.0, 0.0]));
        let [along, strips] = self.theory.elements();
        let middle = strips / 2 * along;
        solved.elements().into_iter().skip(middle).take(along).collect()
    }
}
