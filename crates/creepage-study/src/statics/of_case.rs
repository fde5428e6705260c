//! The report of a statics file.

use crate::{StaticsCase, StaticsError};

use super::StaticsReport;

impl<'a> StaticsReport<'a> {
    /// The report of a problem as its file has it.
    ///
    /// # Errors
    /// As of the four problems; none for a case that was solved.
    pub fn new(case: &'a StaticsCase) -> Result<Self, StaticsError> {
        Ok(match case {
            StaticsCase::Die { solid, base, normal_force, offset, die } => {
                Self::die(*solid, *base, *normal_force, *offset, die)?
            }
            StaticsCase::Shift { pair, ellipse, force, bonded } => {
                Self::shift(*pair, *ellipse, *force, bonded)?
            }
            StaticsCase::Twist { pair, ellipse, moment, bonded } => {
                Self::twist(*pair, *ellipse, *moment, bonded)?
            }
            StaticsCase::PartialSlip { contact, friction, force, partial } => {
                Self::partial_slip(contact, *friction, *force, partial)?
            }
        })
    }
}
