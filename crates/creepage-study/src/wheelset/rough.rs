//! Profiles that are rough where they touch: bodies then meet on the crests of their waves, and the
//! pressure says more about the measurement than about the wheel.

use creepage::normal::NormalContact;
use creepage_rail::{Contact, Role};

use crate::Caution;

/// Beyond a contact's area on either side, waves are looked for as far as this (m): between two
/// crests the area may be narrower than a wave.
const BEYOND: f64 = 2e-3;
/// Whole waves from which on a profile is rough: a joint of arcs or a kink is no more than one.
const WAVES: usize = 2;
/// Mean length (m) up to which waves are no shape: the arcs of treads and heads are 10 mm and longer.
const SHORT: f64 = 4e-3;
/// Pressure that flattens the smallest wave that counts, over the peak pressure.
const COUNTS: f64 = 0.2;

/// What is to be held against the profiles of a contact with this pressure.
///
/// Pressing a wave of length `l` and height `a` flat takes the pressure `pi E* a / l` on its crests
/// (Westergaard 1939): a quarter of `E*` for each radian from the slope of one side to the other.
pub(super) fn cautions(contact: &Contact<'_>, normal: &NormalContact) -> Vec<Caution> {
    let pair = normal.pair();
    let by_swing = 0.25 * pair.shear_modulus() / (1.0 - pair.poisson());
    let peak = normal.peak_pressure().value;
    let [low, high] = across(normal);
    let rough = |body: Role| {
        let least = COUNTS * peak / by_swing;
        let waves = contact.waves(body, [low - BEYOND, high + BEYOND], least)?;
        let pressure = by_swing * waves.swing;
        let caution = Caution::Rough { body, length: waves.length, swing: waves.swing, pressure };
        (waves.count >= WAVES && waves.length < SHORT).then_some(caution)
    };
    [Role::Wheel, Role::Rail].into_iter().filter_map(rough).collect()
}

/// Where the areas of a contact begin and end across (m).
fn across(normal: &NormalContact) -> [f64; 2] {
    let ends = normal.patches().iter().map(|patch| patch.extent().y);
    ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [from, to]| {
        [low.min(from), high.max(to)]
    })
}
