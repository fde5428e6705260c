//! Wheel pressed on its rail without rolling: what a contact map is built of.

use creepage::normal::{NormalContact, Resolution};
use creepage_rail::{Contact, Position, Side};

use super::WheelsetSolver;
use super::normal_contact::{NormalSolver, PatchWarmStart};
use crate::WheelsetError;
use crate::tilt::Placed;

/// The contacts of a wheel with their pressures.
pub type PressedContacts<'a> = Vec<(Contact<'a>, NormalContact)>;

impl<'a> WheelsetSolver<'a> {
    /// One wheel in a position, from its contacts in one nearby; without contacts where it hangs above its rail.
    ///
    /// # Errors
    /// [`WheelsetError`] where wheel and rail do not meet as they should, or a contact has no pressure.
    pub fn stand(
        &self,
        (side, position): (Side, Position),
        resolution: Resolution,
        near: &[(Contact<'_>, NormalContact)],
    ) -> Result<PressedContacts<'a>, WheelsetError> {
        let known =
            near.iter().map(|(contact, normal)| PatchWarmStart::new(side, contact.spot(), normal));
        let press = NormalSolver { resolution, follows: false, ..self.press };
        let wheel = press.wheel(side, position, &known.collect::<Vec<_>>())?;
        let contacts = wheel.contacts.into_iter();
        Ok(contacts.map(|pressed| (pressed.contact, pressed.normal)).collect())
    }
}
