//! Problems without rolling: text, JSON, points, picture.

mod build;
mod compression;
mod field;
mod output;
mod path;
mod picture;
mod sheared_rectangle;
mod slip_angle;

use creepage::Ellipse;

use crate::report::Report;
use crate::{Caution, StaticsCase, StaticsError, StaticsProblem};

use field::Field;
use path::Path;

/// One solved problem of statics, ready to be shown.
///
/// ```
/// use creepage::statics::Die;
/// use creepage::{Ellipse, Solid};
/// use creepage_study::StaticsReport;
/// let (steel, base) = (Solid::new(82e9, 0.28)?, Ellipse::new(5e-3, 10e-3)?);
/// let die = Die::new(steel, base, 20e3, [1e-3, 0.0])?;
/// let report = StaticsReport::die(steel, base, 20e3, [1e-3, 0.0], &die)?;
/// assert!((report.json()["found"]["indentation_m"].as_f64().unwrap() - 6.02e-6).abs() < 1e-8);
/// println!("{}", report.text());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StaticsReport<'a> {
    /// The problem's name in a file.
    problem: &'static str,
    title: &'static str,
    ellipse: Ellipse,
    /// What was given and what was found, in sections of these names.
    numbers: Report,
    field: Field<'a>,
    /// A path after each of its steps.
    path: Path<'a>,
    cautions: Vec<Caution>,
}

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
