//! Wear and fatigue of a wheelset's contacts, and the depth of wear on its profiles.

use creepage::SiCreepage;
use creepage_rail::RollingCreepage;

use super::error::side_word;
use super::solved::{SolvedContact, SolvedWheel, SolvedWheelset};
use crate::damage::{DamageInput, DamageWanted, WearRow, of_elements};
use crate::error::ReportError;

const HEADER: [&str; 7] =
    ["side", "contact", "y_rail", "y_wheel", "usfd_depth", "archard_depth", "archard_zone"];

impl SolvedWheelset {
    /// Computes wear and fatigue numbers of every contact by the laws that are wanted; a wheel's
    /// diameter that is not given is twice its radius.
    pub(super) fn add_damage(&mut self, wanted: &DamageWanted, radius: f64) {
        let speed = self.motion.speed.abs();
        let diameter = wanted.wheel_diameter.or(Some(2.0 * radius));
        let wanted = DamageWanted { wheel_diameter: diameter, ..*wanted };
        for wheel in self.left.iter_mut().chain(&mut self.right) {
            for contact in wheel.contacts_mut() {
                contact.add_damage(&wanted, speed);
            }
        }
    }

    /// The depth of one passage on the profiles: a row for each strip of elements of every contact,
    /// lengths in metres; `None` where no wear is wanted.
    pub(super) fn wear_csv(&self) -> Result<Option<Vec<u8>>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(HEADER)?;
        let mut has_rows = false;
        for wheel in self.wheels() {
            for (k, contact) in wheel.contacts().iter().enumerate() {
                for row in contact.damage.iter().flat_map(|damage| &damage.across) {
                    writer.write_record(record(wheel, k + 1, contact, row))?;
                    has_rows = true;
                }
            }
        }
        let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
        Ok(has_rows.then_some(bytes))
    }
}

fn record(wheel: &SolvedWheel, k: usize, contact: &SolvedContact, row: &WearRow) -> [String; 7] {
    let [y_rail, y_wheel] = contact.on_profiles(row.y);
    let number = |value: f64| format!("{value:e}");
    [
        side_word(wheel.side).to_owned(),
        k.to_string(),
        number(y_rail),
        number(y_wheel),
        number(row.usfd_depth),
        row.archard_depth.map(number).unwrap_or_default(),
        row.zone.map_or("", |zone| zone.name()).to_owned(),
    ]
}

impl SolvedContact {
    fn add_damage(&mut self, wanted: &DamageWanted, speed: f64) {
        let normal = self.load();
        let (RollingCreepage { longitudinal, lateral, spin, .. }, contact) =
            (self.creepage, &self.normal);
        let creepage = SiCreepage { longitudinal, lateral, spin };
        let rows = of_elements(&self.elements(), self.scaling, normal, creepage);
        let ground = DamageInput {
            force: self.force,
            creepage,
            normal,
            area: contact.area().value,
            peak: contact.peak_pressure().value,
            speed: Some(speed),
            rows: Some(&rows),
        };
        self.damage = Some(crate::Damage::new(wanted, &ground, None));
    }

    /// `y` in the profiles of rail and wheel (m) at the place `s` across the contact, along its
    /// tangent: to first order, the rail's cant neglected in the slope.
    fn on_profiles(&self, s: f64) -> [f64; 2] {
        let along = self.side.sense() * s * self.angle.cos();
        [self.y_rail + along, self.y_wheel + along]
    }
}
