//! Cross influence of contacts of one wheel in planes of their own: how one sinks under the load of another.
//!
//! In like bodies a load presses both surfaces down alike and shifts them sideways alike, so that
//! the undeformed distance grows along the normal of the *loaded* contact alone: by
//! `sum p / (pi E* r)`, of which the other contact sees the part along its own normal.

use std::f64::consts::PI;

use creepage::normal::{Band, Moments, NormalContact, Patch};
use creepage_rail::Contact;

use crate::tilt::{Placed, Tilt};

/// Parts of a band, whose load is taken at its centre.
const PARTS: u32 = 12;

/// The loads of contacts, as points in track axes.
#[derive(Debug, Clone, Default)]
pub(crate) struct PointLoads {
    /// Force over `pi E*` (m^2), place (m) and how its contact lies.
    loads: Vec<(f64, [f64; 3], Tilt)>,
    /// Their sum (N).
    pub(crate) total: f64,
}

impl PointLoads {
    pub(crate) fn add(&mut self, contact: &Contact<'_>, normal: &NormalContact) {
        let pair = normal.pair();
        let unit = (1.0 - pair.poisson()) / (PI * pair.shear_modulus());
        let bands = normal.patches().iter().flat_map(Patch::bands);
        self.loads.extend(
            bands
                .flat_map(loads)
                .map(|(force, place)| (force * unit, in_track(contact, place), contact.tilt())),
        );
        self.total += normal.load().value;
    }

    /// How much the distance at `(x, s)` of a contact has grown (m) under these loads.
    pub(crate) fn deflection(&self, contact: &Contact<'_>, place: [f64; 2]) -> f64 {
        let here = in_track(contact, place);
        let by = |(force, there, tilt): &(f64, [f64; 3], Tilt)| {
            let distance = (0..3).map(|i| (here[i] - there[i]).powi(2)).sum::<f64>().sqrt();
            force / distance * tilt.facing(contact.tilt())
        };
        self.loads.iter().map(by).sum()
    }
}

/// Parts of a band as point loads `(N, [x, s])`.
fn loads(band: &Band) -> impl Iterator<Item = (f64, [f64; 2])> {
    let [low, high] = band.y();
    let side = move |k: u32| low + (high - low) * f64::from(k) / f64::from(PARTS);
    (0..PARTS).filter_map(move |k| {
        let Moments { force, by_x, by_y } = band.moments([side(k), side(k + 1)], [-1.0, 1.0]);
        (force > 0.0).then(|| (force, [by_x / force, by_y / force]))
    })
}

/// A place of a contact plane in track axes.
pub(crate) fn in_track(contact: &Contact<'_>, [x, s]: [f64; 2]) -> [f64; 3] {
    contact.tilt().place(contact.reference, [x, s])
}
