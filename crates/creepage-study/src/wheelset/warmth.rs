//! Temperatures of a wheelset's contacts, by the moving source of heat.

use creepage::SiCreepage;
use creepage::coulomb::ElementField;
use creepage_rail::{RollingCreepage, Side};
use creepage_wheelset::{SolvedContact, side_word};

use super::report::WheelsetReport;
use crate::Caution;
use crate::error::ReportError;
use crate::heat::{Heat, HeatWanted, PLACE_HEADER, of_elements};

impl WheelsetReport {
    /// Computes the temperatures of every contact.
    pub(super) fn add_heat(&mut self, wanted: &HeatWanted, theory: &'static str) {
        let speed = self.motion.speed.abs();
        let is_reversed = self.is_reversed;
        for wheel in self.solved.wheels() {
            let of = |contact| of_contact(contact, is_reversed, (wanted, speed, theory));
            self.heat[usize::from(wheel.side == Side::Right)] =
                wheel.contacts().iter().map(of).collect();
        }
    }

    /// Temperatures of all contacts, each in its own plane; `None` where none are wanted.
    pub(super) fn temperature_csv(&self) -> Result<Option<Vec<u8>>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(["side", "contact"].iter().chain(&PLACE_HEADER))?;
        let mut has_rows = false;
        for wheel in self.wheels() {
            for k in 1..=wheel.contacts().len() {
                let sense = if self.is_reversed { -1.0 } else { 1.0 };
                for [x, y, numbers @ ..] in
                    self.heat(wheel.side, k - 1).into_iter().flat_map(Heat::records)
                {
                    let place = [sense * x, y].into_iter().chain(numbers);
                    let of = [side_word(wheel.side).to_owned(), k.to_string()];
                    writer.write_record(of.into_iter().chain(place.map(|n| format!("{n:e}"))))?;
                    has_rows = true;
                }
            }
        }
        let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
        Ok(has_rows.then_some(bytes))
    }

    /// Temperatures along the hottest row of each contact, by the name of its file.
    pub(super) fn temperature_svgs(&self) -> Vec<(String, String)> {
        let of_wheels = self.wheels().flat_map(|wheel| {
            (1..=wheel.contacts().len()).filter_map(|k| {
                let svg = self.heat(wheel.side, k - 1)?.svg()?;
                Some((format!("{}_{k}_temperature", side_word(wheel.side)), svg))
            })
        });
        of_wheels.collect()
    }
}

fn of_contact(
    contact: &SolvedContact,
    is_reversed: bool,
    (wanted, speed, theory): (&HeatWanted, f64, &'static str),
) -> (Option<Heat>, Vec<Caution>) {
    let RollingCreepage { longitudinal, lateral, spin, .. } = contact.creepage;
    // Heat is left behind: elements as they roll forward.
    let sense = if is_reversed { -1.0 } else { 1.0 };
    let creepage = SiCreepage { longitudinal: sense * longitudinal, lateral, spin: sense * spin };
    let elements = contact.elements();
    let rows = if is_reversed {
        let forward: Vec<_> = elements.iter().map(ElementField::fore_and_aft).collect();
        of_elements(&forward, contact.scaling, contact.load(), creepage, speed)
    } else {
        of_elements(&elements, contact.scaling, contact.load(), creepage, speed)
    };
    let (heat, cautions) = Heat::of(wanted, speed, creepage.longitudinal, rows, theory);
    (if is_reversed { heat.map(Heat::reversed) } else { heat }, cautions)
}
