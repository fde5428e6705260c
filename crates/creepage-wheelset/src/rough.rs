//! Measured profiles where they touch: roughness, by which bodies meet on the crests of waves and the pressure says more
//! about the measurement than about the wheel; and stretches without points.

use creepage::SolidPair;
use creepage::normal::NormalContact;
use creepage_rail::{Contact, Profile, RadiusDifference, Role, Side, Waves, WheelsetOnTrack};

/// Beyond a contact's area on either side, waves are looked for as far as this (m): between two
/// crests the area may be narrower than a wave.
const BEYOND: f64 = 2e-3;
/// Whole waves from which on a profile is rough: a joint of arcs or a kink is no more than one.
const WAVES: usize = 2;
/// Mean length (m) up to which waves are no shape: the arcs of treads and heads are 10 mm and longer.
const SHORT: f64 = 8e-3;
/// Without a load every so many positions are looked at, that far to either side of where wheel
/// and rail touch (m).
const EVERY: usize = 5;
const REACH: f64 = 7e-3;
/// Peak pressure of a smooth contact of wheel and rail (Pa), where that is not known.
const PRESSURE: f64 = 1e9;
/// Pressure that flattens the smallest wave that counts, over the peak pressure.
const COUNTS: f64 = 0.1;

/// Roughness of a profile: waves that are many, short, and high enough for the pressure to rest on their crests.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness {
    /// The body whose profile it is.
    pub body: Role,
    /// Mean length of a wave (m).
    pub length: f64,
    /// By how much the surface turns from one side of a wave to the other (rad).
    pub swing: f64,
    /// The pressure that presses the waves flat (Pa).
    pub pressure: f64,
}

/// Stretch without points on a measured profile, where it touches: its shape there is made up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unmeasured {
    /// The body whose profile it is.
    pub body: Role,
    /// Length of the stretch (m).
    pub length: f64,
}

/// The profiles without points somewhere in the areas of a contact.
pub(crate) fn unmeasured(contact: &Contact<'_>, normal: &NormalContact) -> Vec<Unmeasured> {
    let areas = across(normal);
    let of = |body| Some(Unmeasured { body, length: contact.unmeasured(body, areas)? });
    [Role::Wheel, Role::Rail].into_iter().filter_map(of).collect()
}

/// The rough profiles of a contact with this pressure.
///
/// Pressing a wave of length `l` and height `a` flat takes the pressure `pi E* a / l` on its crests
/// (Westergaard 1939): a quarter of `E*` for each radian from the slope of one side to the other.
pub(crate) fn of_contact(contact: &Contact<'_>, normal: &NormalContact) -> Vec<Roughness> {
    let by_swing = by_swing(&normal.pair());
    let peak = normal.peak_pressure().value;
    let [low, high] = across(normal);
    let rough = |body: Role| {
        // Crests raise the peak: what counts stays that of a smooth contact.
        let least = COUNTS * peak.min(PRESSURE) / by_swing;
        let waves = contact.waves(body, [low - BEYOND, high + BEYOND], least)?;
        roughness(body, waves, by_swing)
    };
    [Role::Wheel, Role::Rail].into_iter().filter_map(rough).collect()
}

/// Pressure that presses waves flat, by how far they turn (Pa/rad).
fn by_swing(pair: &SolidPair) -> f64 {
    0.25 * pair.shear_modulus() / (1.0 - pair.poisson())
}

/// Of waves that are many and short.
fn roughness(body: Role, waves: Waves, by_swing: f64) -> Option<Roughness> {
    let Waves { count, length, swing } = waves;
    let pressure = by_swing * swing;
    (count >= WAVES && length < SHORT).then_some(Roughness { body, length, swing, pressure })
}

/// Profiles that are rough where wheel and rail touch, at positions of a radius difference: contact then jumps
/// between the crests of their waves, and the difference with it. Each profile once, where it is worst. Waves
/// count as under a pressure of 1e9 Pa. With `rolls` the wheelset rolls until it rests on both rails.
#[must_use]
pub fn rough_profiles(
    running: &WheelsetOnTrack,
    pair: &SolidPair,
    difference: &RadiusDifference,
    rolls: bool,
) -> Vec<(Side, Roughness)> {
    let by_swing = by_swing(pair);
    let least = COUNTS * PRESSURE / by_swing;
    let mut worst: Vec<(Side, Role, Waves)> = Vec::new();
    for (side, body, profile, at) in touching(running, difference, rolls) {
        let Some(waves) = profile.waves(at, REACH, least) else { continue };
        if roughness(body, waves, by_swing).is_none() {
            continue;
        }
        let known = worst.iter_mut().find(|(s, b, _)| *s == side && *b == body);
        match known {
            Some((.., known)) if known.swing >= waves.swing => {}
            Some((.., known)) => *known = waves,
            None => worst.push((side, body, waves)),
        }
    }
    let rough = |(side, body, waves)| Some((side, roughness(body, waves, by_swing)?));
    worst.into_iter().filter_map(rough).collect()
}

/// Profiles without points where wheel and rail touch at positions of a radius difference, each once.
#[must_use]
pub fn unmeasured_profiles(
    running: &WheelsetOnTrack,
    difference: &RadiusDifference,
    rolls: bool,
) -> Vec<(Side, Unmeasured)> {
    let mut all: Vec<(Side, Unmeasured)> = Vec::new();
    for (side, body, profile, at) in touching(running, difference, rolls) {
        let Some(length) = profile.unmeasured_at(at) else { continue };
        if !all.iter().any(|(s, known)| *s == side && known.body == body) {
            all.push((side, Unmeasured { body, length }));
        }
    }
    all
}

/// Wheels and rails at positions of a radius difference, each with the `y` (m) of its profile at which it touches.
fn touching<'a>(
    running: &'a WheelsetOnTrack,
    difference: &'a RadiusDifference,
    rolls: bool,
) -> impl Iterator<Item = (Side, Role, &'a Profile, f64)> {
    let looked_at = difference.rows().step_by(EVERY).filter_map(move |(y, _)| {
        let roll = if rolls { running.resting(y, 0.0, None).map(|p| p.roll) } else { Ok(0.0) };
        Some((y, roll.ok()?))
    });
    looked_at.flat_map(move |(y, roll)| {
        let sides = [Side::Left, Side::Right].into_iter();
        let touches =
            sides.filter_map(move |side| Some((side, running.touch(side, y, roll, 0.0).ok()?)));
        touches.flat_map(|(side, touch)| {
            let [wheel, rail] = running.profiles(side);
            [(side, Role::Wheel, wheel, touch.y_wheel), (side, Role::Rail, rail, touch.y_rail)]
        })
    })
}

/// Where the areas of a contact begin and end across (m).
fn across(normal: &NormalContact) -> [f64; 2] {
    let ends = normal.patches().iter().map(|patch| patch.extent().y);
    ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [from, to]| {
        [low.min(from), high.max(to)]
    })
}
