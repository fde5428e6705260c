//! The law of Shen, Hedrick and Elkins (1983): the cubic law of Vermeulen and Johnson with the
//! force of linear theory, spin included, as its argument.

use super::cubic::Cubic;
use super::linear::{CreepageCoefficients, checked, linear_force};
use crate::check::InvalidValue;
use crate::contact::Contact;
use crate::theory::{Jacobian, Solved, Stateless};
use crate::{Creepage, FieldPoint, Force, Region, Solution, Status, Theory};

/// Law of Shen, Hedrick and Elkins (1983).
///
/// The force has the direction of linear theory's, in full sliding too; with `|tau| = 3 mu N` in
/// linear theory it reaches `mu N`. It is the best formula of its kind for little spin, and poor
/// beyond `chi` of about .5: for large spin it tends to `f_y = 1`, where the true force vanishes.
///
/// The law has no moment. The library gives linear theory's moment, reduced by the same factor as
/// the force: right for small creepage and spin, a rough estimate otherwise.
///
/// [Sources](crate::approximate). The law agrees with linear theory for small creepage
/// and spin, and with that of Vermeulen and Johnson in form; a second implementation gives
/// the same forces.
///
/// ```
/// use creepage::approximate::shen_hedrick_elkins::ShenHedrickElkins;
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let law = ShenHedrickElkins::new(&Contact::new(Ellipse::from_ratio(2.0)?, 0.28)?)?;
/// let force = law.solve(Creepage::new(5.0, 0.0, 0.0)?).force;
/// assert!((force.fx - 1.0).abs() < 1e-12);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct ShenHedrickElkins {
    contact: Contact,
    /// Of linear theory.
    gains: [[f64; 3]; 3],
}

impl ShenHedrickElkins {
    /// Prepares the law; interpolates the creepage coefficients.
    ///
    /// # Errors
    /// As [`CreepageCoefficients::new`].
    pub fn new(contact: &Contact) -> Result<Self, InvalidValue> {
        let (ellipse, poisson) = (checked(contact)?, contact.poisson());
        let coefficients = CreepageCoefficients::interpolated(contact)?;
        Ok(Self { contact: contact.clone(), gains: coefficients.gains(ellipse, poisson) })
    }

    /// The forces of linear theory, and the law there.
    fn law(&self, creepage: Creepage) -> (Force, Cubic) {
        let linear = linear_force(&self.gains, creepage);
        (linear, Cubic::new([linear.fx, linear.fy]))
    }
}

impl Theory for ShenHedrickElkins {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        let (linear, law) = self.law(creepage);
        let [fx, fy] = law.force();
        let force = Force { fx, fy, mz: law.factor * linear.mz };
        Solution::closed_form(force, Status::Solved)
    }

    /// The law has no tractions of its own. Given are those of the theory that it extends,
    /// Vermeulen and Johnson's, which carry the same force (and no moment): an adhesion ellipse
    /// similar to the contact, touching it at the leading point. The slip outside it is NaN.
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let (_, law) = self.law(creepage);
        let point = |&position: &[f64; 2]| {
            let (traction, slip, region) = match law.traction(self.contact.ellipse(), position) {
                None => return FieldPoint::outside(position),
                Some((traction, true)) => (traction, [0.0; 2], Region::Adhesion),
                Some((traction, false)) => (traction, [f64::NAN; 2], Region::Slip),
            };
            FieldPoint { position, traction, slip, region }
        };
        positions.iter().map(point).collect()
    }

    /// Derivative of `(f_x, f_y, m_z)` (rows) by `(xi, eta, chi)` (columns).
    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        let (linear, law) = self.law(creepage);
        let [along, across, moment] = self.gains;
        let [xi, eta, chi] = [0, 1, 2].map(|column| {
            let change = [along[column], across[column]];
            let [fx, fy] = law.force_change(change);
            [fx, fy, law.factor * moment[column] + law.factor_change(change) * linear.mz]
        });
        Some([0, 1, 2].map(|row| [xi[row], eta[row], chi[row]]))
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Stateless::boxed(self, creepage)
    }
}
