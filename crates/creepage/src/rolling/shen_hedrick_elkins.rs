//! The law of Shen, Hedrick and Elkins (1983): the cubic law of Vermeulen and Johnson with the
//! force of linear theory, spin included, as its argument.

use super::cubic::Cubic;
use super::linear::{CreepageCoefficients, checked, linear_force};
use super::{Creepage, FieldPoint, Force, Region, Solution, Status, Theory};
use crate::check::InvalidValue;
use crate::ellipse::Ellipse;

/// Law of Shen, Hedrick and Elkins (1983).
///
/// The force has the direction of linear theory's, in full sliding too; with `|tau| = 3 mu N` in
/// linear theory it reaches `mu N`. It is the best formula of its kind for little spin, and poor
/// beyond `chi` of about .5: for large spin it tends to `f_y = 1`, where the true force vanishes.
///
/// The moment is no part of the law. Given is linear theory's, reduced by the same factor as the
/// force: right for small creepage and spin, a makeshift otherwise.
///
/// The original paper could not be consulted. The law agrees with linear theory for small creepage
/// and spin, and with that of Vermeulen and Johnson in form; a second implementation gives
/// the same forces.
///
/// ```
/// use creepage::rolling::shen_hedrick_elkins::ShenHedrickElkins;
/// use creepage::rolling::{Creepage, Theory};
/// let law = ShenHedrickElkins::new(2.0, 0.28)?;
/// let force = law.solve(Creepage::new(5.0, 0.0, 0.0)?).force;
/// assert_eq!(force.fx, 1.0);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct ShenHedrickElkins {
    ellipse: Ellipse,
    /// Of linear theory.
    gains: [[f64; 3]; 3],
}

impl ShenHedrickElkins {
    /// Prepares the law; computes the creepage coefficients.
    ///
    /// # Errors
    /// As [`CreepageCoefficients::new`].
    pub fn new(a_over_b: f64, poisson: f64) -> Result<Self, InvalidValue> {
        let ellipse = checked(a_over_b, poisson)?;
        let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
        Ok(Self { ellipse, gains: coefficients.gains(ellipse, poisson) })
    }

    /// Derivative of `(f_x, f_y, m_z)` (rows) by `(xi, eta, chi)` (columns).
    #[must_use]
    pub fn derivative(&self, creepage: Creepage) -> [[f64; 3]; 3] {
        let (linear, law) = self.law(creepage);
        let [along, across, moment] = self.gains;
        let [xi, eta, chi] = [0, 1, 2].map(|column| {
            let change = [along[column], across[column]];
            let [fx, fy] = law.force_change(change);
            [fx, fy, law.factor * moment[column] + law.factor_change(change) * linear.mz]
        });
        [0, 1, 2].map(|row| [xi[row], eta[row], chi[row]])
    }

    /// The forces of linear theory, and the law there.
    fn law(&self, creepage: Creepage) -> (Force, Cubic) {
        let linear = linear_force(&self.gains, creepage);
        (linear, Cubic::new([linear.fx, linear.fy]))
    }
}

impl Theory for ShenHedrickElkins {
    fn solve(&self, creepage: Creepage) -> Solution {
        let (linear, law) = self.law(creepage);
        let [fx, fy] = law.force();
        Solution { force: Force { fx, fy, mz: law.factor * linear.mz }, status: Status::Solved }
    }

    /// The law has no tractions of its own. Given are those of the theory that it extends,
    /// Vermeulen and Johnson's, which carry the same force (and no moment): an adhesion ellipse
    /// similar to the contact, touching it at the leading point. The slip outside it is NaN.
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let (_, law) = self.law(creepage);
        let point = |&position: &[f64; 2]| {
            let (traction, slip, region) = match law.traction(self.ellipse, position) {
                None => ([0.0; 2], [0.0; 2], Region::Slip),
                Some((traction, true)) => (traction, [0.0; 2], Region::Adhesion),
                Some((traction, false)) => (traction, [f64::NAN; 2], Region::Slip),
            };
            FieldPoint { position, traction, slip, region }
        };
        positions.iter().map(point).collect()
    }
}
