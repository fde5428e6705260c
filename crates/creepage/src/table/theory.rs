//! Table at one contact, as a theory.

use super::in_memory::Table;
use super::slice::Slice;
use crate::check::InvalidValue;
use crate::theory::{Jacobian, Solved, Stateless};
use crate::{Contact, Creepage, FieldPoint, Region, Solution, Status, Theory};

/// A table prepared for a contact. It has forces and their derivative; tractions and slip are NaN
/// inside the contact, for a table does not hold them.
#[derive(Debug, Clone)]
pub struct TableTheory<'a> {
    contact: Contact,
    slice: Slice<'a>,
}

impl Table {
    /// The table as a theory, for one contact.
    ///
    /// # Errors
    /// [`InvalidValue`] when the ratio of the semi-axes or Poisson's ratio is outside the table's
    /// range.
    pub fn prepare(&self, contact: &Contact) -> Result<TableTheory<'_>, InvalidValue> {
        let slice = self.at(contact.hertz_ellipse()?.ratio(), contact.poisson())?;
        Ok(TableTheory { contact: contact.clone(), slice })
    }
}

impl Theory for TableTheory<'_> {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        Solution::closed_form(self.slice.force(creepage), Status::Solved)
    }

    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        Some(self.slice.force_and_derivative(creepage).1)
    }

    fn field(&self, _: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let ellipse = self.contact.ellipse();
        let unknown = [f64::NAN; 2];
        let point = |&position: &[f64; 2]| {
            let inside = (position[0] / ellipse.a()).hypot(position[1] / ellipse.b()) < 1.0;
            if inside {
                FieldPoint { position, traction: unknown, slip: unknown, region: Region::Slip }
            } else {
                FieldPoint::outside(position)
            }
        };
        positions.iter().map(point).collect()
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Stateless::boxed(self, creepage)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::approximate::polach::Polach;
    use crate::ellipse::Ellipse;
    use crate::table::{Axis, Intervals, Provenance, Spec, build};

    #[test]
    fn a_table_is_a_theory() {
        let spec = Spec {
            a_over_b: Axis::fixed(1.0),
            poisson: Axis::fixed(0.28),
            intervals: Intervals { theta: 8, phi: 12, t: 16 },
            places: 100,
            provenance: Provenance::default(),
        };
        let polach = |contact: &Contact| -> Result<Box<dyn Theory>, InvalidValue> {
            Ok(Box::new(Polach::new(contact)?))
        };
        let table = build(&spec, polach, &|| {}).unwrap();
        let contact = Contact::new(Ellipse::from_ratio(1.0).unwrap(), 0.28).unwrap();
        let (theory, law) = (table.prepare(&contact).unwrap(), polach(&contact).unwrap());
        let at = Creepage { xi: 0.4, eta: -0.2, chi: 0.3 };
        let [found, right] = [theory.solve(at).force, law.solve(at).force];
        let error = (found.fx - right.fx).hypot(found.fy - right.fy);
        assert!(error < table.accuracy().force.worst, "{error}");
        let regions: Vec<_> =
            theory.field(at, &[[0.1, 0.2], [0.8, 0.7]]).iter().map(|point| point.region).collect();
        assert_eq!(regions, [Region::Slip, Region::Outside]);
        let other = Contact::new(Ellipse::from_ratio(2.0).unwrap(), 0.28).unwrap();
        assert_eq!(table.prepare(&other).unwrap_err().quantity, "a_over_b");
    }
}
