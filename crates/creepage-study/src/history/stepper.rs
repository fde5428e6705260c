//! Stepper of transient rolling, as a larger program asks for it.

use creepage::unsteady::{Rolled, SavedError};

use super::case::RollCase;
use super::columns::HistoryRow;
use super::error::{HistoryError, MotionError};
use super::roller::TransientSolver;

/// A contact that rolls step by step, in SI units, from the start that its case names.
///
/// ```
/// use creepage_study::{RollFile, RollStepper};
/// let text = r#"
///     upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = "flat" }
///     lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = "flat", radius_lateral = 0.30 }
///     contact = { normal_force = 80e3, friction = 0.3 }
///     solve = { resolution = [8, 8] }
/// "#;
/// let mut stepper = RollStepper::new(RollFile::read(text)?.case(".".as_ref())?)?;
/// let before = stepper.save();
/// let first = stepper.step(&[("distance", 1e-3), ("longitudinal", -1e-3)])?;
/// // The larger program rejects the step, and tries it again.
/// stepper.restore(&before)?;
/// assert_eq!(stepper.step(&[("distance", 1e-3), ("longitudinal", -1e-3)])?, first);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct RollStepper {
    case: RollCase,
    /// Tells one case from another.
    key: [u8; 4],
    rolling: TransientSolver,
}

impl RollStepper {
    /// Prepares the contact.
    ///
    /// # Errors
    /// [`HistoryError::Contact`] when it cannot be prepared.
    pub fn new(case: RollCase) -> Result<Self, HistoryError> {
        let rolling = case.prepared()?;
        let key = crc32fast::hash(format!("{case:?}").as_bytes()).to_le_bytes();
        Ok(Self { case, key, rolling })
    }

    /// Rolls on: `given` has numbers by the names of a history's columns, `distance` the length of
    /// the step (m). The first step starts as the case says.
    ///
    /// # Errors
    /// [`HistoryError`] that names the quantity; the contact is then as it was.
    pub fn step(&mut self, given: &[(&str, f64)]) -> Result<Rolled, HistoryError> {
        let row = HistoryRow::of_step(given, &self.case)?;
        if self.rolling.distance() == 0.0 {
            self.case.start(&mut self.rolling, &row.motion).map_err(HistoryError::Contact)?;
        }
        let rolled = self.case.roll(&mut self.rolling, row.distance, &row.motion);
        rolled.map_err(|error| HistoryError::Step(MotionError::Value(error)))
    }

    /// What the contact remembers, for [`RollStepper::restore`]: as many bytes as its elements ask for.
    #[must_use]
    pub fn save(&self) -> Vec<u8> {
        [&self.key[..], &self.rolling.save()].concat()
    }

    /// Goes back, or on, to what was saved: all is then as it was, to the last bit.
    ///
    /// # Errors
    /// [`SavedError`] for bytes that are no state of a contact of the same case.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SavedError> {
        let (key, saved) = bytes.split_at_checked(4).ok_or(SavedError::NoState)?;
        if key != self.key {
            return Err(SavedError::OtherContact);
        }
        self.rolling.restore(saved)
    }

    /// The contact that rolls.
    #[must_use]
    pub fn case(&self) -> &RollCase {
        &self.case
    }
}
