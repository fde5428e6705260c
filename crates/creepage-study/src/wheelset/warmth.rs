//! Temperatures of a wheelset's contacts.

use creepage::SiCreepage;
use creepage::coulomb::ElementField;
use creepage_rail::RollingCreepage;

use super::error::side_word;
use super::solved::{SolvedContact, SolvedWheelset};
use crate::error::ReportError;
use crate::heat::{Heat, HeatWanted, PLACE_HEADER, of_elements};

impl SolvedWheelset {
    /// Computes the temperatures of every contact.
    pub(super) fn add_heat(&mut self, wanted: &HeatWanted, theory: &'static str) {
        let speed = self.motion.speed.abs();
        for wheel in self.left.iter_mut().chain(&mut self.right) {
            for contact in wheel.contacts_mut() {
                contact.add_heat(wanted, speed, theory);
            }
        }
    }

    /// Temperatures of all contacts, each in its own plane; `None` where none are wanted.
    pub(super) fn temperature_csv(&self) -> Result<Option<Vec<u8>>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(["side", "contact"].iter().chain(&PLACE_HEADER))?;
        let mut has_rows = false;
        for wheel in self.wheels() {
            for (contact, k) in wheel.contacts().iter().zip(1..) {
                let k: usize = k;
                let sense = if contact.is_reversed { -1.0 } else { 1.0 };
                for [x, y, numbers @ ..] in contact.heat.iter().flat_map(Heat::records) {
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
            let named = wheel.contacts().iter().zip(1..);
            named.filter_map(|(contact, k): (_, usize)| {
                let svg = contact.heat.as_ref()?.svg()?;
                Some((format!("{}_{k}_temperature", side_word(wheel.side)), svg))
            })
        });
        of_wheels.collect()
    }
}

impl SolvedContact {
    fn add_heat(&mut self, wanted: &HeatWanted, speed: f64, theory: &'static str) {
        let RollingCreepage { longitudinal, lateral, spin, .. } = self.creepage;
        // Heat is left behind: elements as they roll forward.
        let sense = if self.is_reversed { -1.0 } else { 1.0 };
        let creepage =
            SiCreepage { longitudinal: sense * longitudinal, lateral, spin: sense * spin };
        let elements = self.elements();
        let rows = if self.is_reversed {
            let forward: Vec<_> = elements.iter().map(ElementField::fore_and_aft).collect();
            of_elements(&forward, self.scaling, self.load(), creepage, speed)
        } else {
            of_elements(&elements, self.scaling, self.load(), creepage, speed)
        };
        let (heat, caution) = Heat::of(wanted, speed, creepage.longitudinal, rows, theory);
        self.heat = if self.is_reversed { heat.map(Heat::reversed) } else { heat };
        self.heat_caution = caution;
    }
}
