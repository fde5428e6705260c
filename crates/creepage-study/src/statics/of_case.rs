//! The report of a statics file.

use crate::{StaticsCase, StaticsError, StaticsProblem};

use super::StaticsReport;

impl<'a> StaticsReport<'a> {
    /// The report of a problem as its file has it.
    ///
    /// # Errors
    /// As of the seven problems; none for a case that was solved.
    pub fn new(case: &'a StaticsCase) -> Result<Self, StaticsError> {
        let report = match &case.problem {
            StaticsProblem::Die { solid, base, normal_force, offset, die } => {
                Self::die(*solid, *base, *normal_force, *offset, die)?
            }
            StaticsProblem::Shift { pair, ellipse, force, bonded } => {
                Self::shift(*pair, *ellipse, *force, bonded)?
            }
            StaticsProblem::Twist { pair, ellipse, moment, bonded } => {
                Self::twist(*pair, *ellipse, *moment, bonded)?
            }
            StaticsProblem::PartialSlip { contact, friction, force, partial } => {
                Self::partial_slip(contact, *friction, *force, partial)?
            }
            StaticsProblem::ShiftPath { contact, friction, axis, steps } => {
                Self::shift_path(contact, *friction, *axis, steps).ok_or(StaticsError::NoSteps)?
            }
            StaticsProblem::Compression { contact, compression } => {
                Self::compression(contact, compression)?
            }
            StaticsProblem::ShearedRectangle { pair, normal_force, friction, layer, steps } => {
                let given = [*normal_force, *friction];
                Self::sheared_rectangle(*pair, given, *layer, steps)?
            }
        };
        Ok(Self { cautions: case.cautions.clone(), ..report })
    }
}
