//! Wear and fatigue of a wheelset's contacts, and the depth of wear on its profiles.

use creepage::SiCreepage;
use creepage_rail::{RollingCreepage, Side};
use creepage_wheelset::{SolvedContact, SolvedWheel, side_word};

use super::report::WheelsetReport;
use crate::damage::{Damage, DamageInput, DamageWanted, WearRow, of_elements};
use crate::error::ReportError;

const HEADER: [&str; 7] =
    ["side", "contact", "y_rail", "y_wheel", "usfd_depth", "archard_depth", "archard_zone"];

impl WheelsetReport {
    /// Computes wear and fatigue numbers of every contact by the laws that are wanted; a wheel's
    /// diameter that is not given is twice its radius.
    pub(super) fn add_damage(&mut self, wanted: &DamageWanted, radius: f64) {
        let speed = self.motion.speed.abs();
        let diameter = wanted.wheel_diameter.or(Some(2.0 * radius));
        let wanted = DamageWanted { wheel_diameter: diameter, ..*wanted };
        for wheel in self.solved.wheels() {
            let all = wheel.contacts().iter().map(|contact| damage(contact, &wanted, speed));
            self.damage[usize::from(wheel.side == Side::Right)] = all.collect();
        }
    }

    /// The depth of one passage on the profiles: a row for each strip of elements of every contact,
    /// lengths in metres; `None` where no wear is wanted.
    pub(super) fn wear_csv(&self) -> Result<Option<Vec<u8>>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(HEADER)?;
        let mut has_rows = false;
        for wheel in self.wheels() {
            for (k, (contact, damage)) in
                wheel.contacts().iter().zip(self.damage(wheel.side)).enumerate()
            {
                for row in &damage.across {
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
    let [y_rail, y_wheel] = on_profiles(contact, row.y);
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

fn damage(contact: &SolvedContact, wanted: &DamageWanted, speed: f64) -> Damage {
    let normal = contact.load();
    let RollingCreepage { longitudinal, lateral, spin, .. } = contact.creepage;
    let creepage = SiCreepage { longitudinal, lateral, spin };
    let rows = of_elements(&contact.elements(), contact.scaling, normal, creepage);
    let input = DamageInput {
        force: contact.force,
        creepage,
        normal,
        area: contact.normal.area().value,
        peak: contact.normal.peak_pressure().value,
        speed: Some(speed),
        rows: Some(&rows),
    };
    Damage::new(wanted, &input, None)
}

/// `y` in the profiles of rail and wheel (m) at the place `s` across the contact, along its
/// tangent: to first order, the rail's cant neglected in the slope.
fn on_profiles(contact: &SolvedContact, s: f64) -> [f64; 2] {
    let along = contact.side.sense() * s * contact.angle.cos();
    [contact.y_rail + along, contact.y_wheel + along]
}
