//! Contacts of one wheel in planes of their own: how one sinks under the load of another.
//!
//! In like bodies a load presses both surfaces down alike and shifts them sideways alike, so that
//! the undeformed distance grows along the normal of the *loaded* contact alone: by
//! `sum p / (pi E* r)`, of which the other contact sees the part along its own normal.

use std::f64::consts::PI;

use creepage::normal::{Band, Moments};
use creepage_rail::Contact;

use super::pressed::Pressed;

/// Parts of a band, whose load is taken at its centre.
const PARTS: u32 = 12;

/// How much the distance at `(x, s)` of a contact has grown (m) under the load of others.
pub(super) fn sunk(contact: &Contact<'_>, place: [f64; 2], others: &[Pressed<'_>]) -> f64 {
    let here = in_track(contact, place);
    others.iter().map(|other| by(other, here) * (other.contact.angle - contact.angle).cos()).sum()
}

/// The same along the other's normal.
fn by(other: &Pressed<'_>, here: [f64; 3]) -> f64 {
    let pair = other.normal.pair();
    let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
    let bands = other.normal.patches().iter().flat_map(creepage::normal::Patch::bands);
    let sum: f64 = bands
        .flat_map(loads)
        .map(|(force, place)| {
            let there = in_track(&other.contact, place);
            let distance = (0..3).map(|i| (here[i] - there[i]).powi(2)).sum::<f64>().sqrt();
            force / distance
        })
        .sum();
    sum / (PI * modulus)
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
pub(super) fn in_track(contact: &Contact<'_>, [x, s]: [f64; 2]) -> [f64; 3] {
    let (sin, cos) = contact.angle.sin_cos();
    let [a, b, c] = contact.reference;
    [a + x, b + s * cos, c + s * sin]
}
