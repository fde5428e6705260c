//! Normal contact of one wheel on its rail: its contacts and the pressure in each.

use super::WheelsetSolver;
use super::cross_patch;
use super::excess::Excess;
use crate::WheelsetError;
use crate::pose::Patches;
use crate::tilt::{Placed, distance};
use crate::warm_start::LateralForceRatios;
use creepage::SolidPair;
use creepage::gap::{Gap, Rolling};
use creepage::normal::{self, NormalContact, NormalError, Resolution};
use creepage_rail::{Across, Contact, Position, Side, WheelsetOnTrack};

/// Places across a contact at which the undeformed bodies are looked up.
const PLACES: usize = 161;
/// The same along `x` and across, where surfaces vary along rolling.
const LATTICE: [usize; 2] = [61, 81];
/// How far beyond the overlap they reach, over its width.
const MARGIN: f64 = 0.05;

/// Contact with its pressure.
#[derive(Debug, Clone)]
pub(crate) struct PressedContact<'a> {
    pub(crate) contact: Contact<'a>,
    pub(crate) normal: NormalContact,
}

/// A wheel at a height, with its contacts.
#[derive(Debug, Clone)]
pub(crate) struct PressedWheel<'a> {
    pub(crate) side: Side,
    pub(crate) position: Position,
    /// Height of the axle over the track at `z = 0` (m).
    pub(crate) radius: f64,
    pub(crate) contacts: Vec<PressedContact<'a>>,
}

/// Warm start of a contact's pressure, from a position close by.
#[derive(Debug, Clone)]
pub(crate) struct PatchWarmStart {
    side: Side,
    spot: [f64; 2],
    normal: NormalContact,
}

impl PatchWarmStart {
    pub(crate) fn new(side: Side, spot: [f64; 2], normal: &NormalContact) -> Self {
        Self { side, spot, normal: normal.clone() }
    }

    /// Those of some wheels.
    pub(crate) fn of(wheels: &[PressedWheel<'_>]) -> Vec<Self> {
        let contacts = wheels.iter().flat_map(|wheel| &wheel.contacts);
        contacts.map(|one| Self::new(one.contact.side, one.contact.spot(), &one.normal)).collect()
    }

    /// The one next to a spot on a rail.
    pub(crate) fn next_to(side: Side, spot: [f64; 2], all: &[Self]) -> Option<&NormalContact> {
        let own = all.iter().filter(|known| known.side == side);
        let distance = |known: &Self| distance(known.spot, spot);
        own.min_by(|a, b| distance(a).total_cmp(&distance(b))).map(|known| &known.normal)
    }

    /// Has its areas' sides moved as they drift.
    pub(crate) fn drift(&mut self, beyond: &[[f64; 2]], times: f64) {
        self.normal = self.normal.with_sides_moved(beyond, times);
    }
}

/// Solver of the normal contact of a wheel: all that pressing needs besides the position.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NormalSolver<'a> {
    pub(crate) running: &'a WheelsetOnTrack,
    pub(crate) pair: SolidPair,
    pub(crate) resolution: normal::Resolution,
    /// Whether areas in planes of their own feel each other.
    pub(crate) patches: Patches,
    /// Whether it is enough to follow a pressure known close by, without error bars of its own.
    pub(crate) follows: bool,
}

impl<'a> NormalSolver<'a> {
    /// One wheel in a position, from what is known close by; without contacts where it hangs above
    /// its rail.
    ///
    /// Contacts in one plane are one system; those in planes of their own feel each other as
    /// [`cross_patch`] has it.
    pub(crate) fn wheel(
        &self,
        side: Side,
        position: Position,
        known: &[PatchWarmStart],
    ) -> Result<PressedWheel<'a>, WheelsetError> {
        let geometry = |source| WheelsetError::Position { side, source };
        let contacts = self.running.contacts_of(side, &position).map_err(geometry)?;
        let near = |contact: &Contact<'a>| {
            PatchWarmStart::next_to(contact.side, contact.spot(), known).cloned()
        };
        let mut pressed: Vec<CrossPatch<'a>> =
            contacts.into_iter().map(|contact| CrossPatch::new(contact, near(&contact))).collect();
        self.press_beside(&mut pressed)?;
        let radius = self.running.wheelset().radius();
        let contacts = pressed.into_iter().filter_map(CrossPatch::pressed).collect();
        Ok(PressedWheel { side, position, radius, contacts })
    }

    /// Presses each contact under the load of the others until nothing changes.
    fn press_beside(&self, all: &mut [CrossPatch<'a>]) -> Result<(), WheelsetError> {
        const ROUNDS: usize = 16;
        const SETTLED: f64 = 1e-6;
        /// So little more or less from the others changes no error bar.
        const SLIGHT: f64 = 1e-3;
        for _ in 0..ROUNDS {
            let mut is_settled = true;
            for i in 0..all.len() {
                let mut others = cross_patch::PointLoads::default();
                let is_apart = self.patches == Patches::Apart;
                // A guard rail is a body of its own, its plane across that of the tread.
                let on_guard = all.get(i).is_some_and(|own| own.contact.is_on_guard);
                let feels = |(j, other): &(usize, &CrossPatch<'_>)| {
                    *j != i && !is_apart && other.contact.is_on_guard == on_guard
                };
                for (_, other) in all.iter().enumerate().filter(feels) {
                    other.normal.iter().for_each(|normal| others.add(&other.contact, normal));
                }
                let Some(own) = all.get_mut(i) else { continue };
                let change =
                    own.load_of_others.map_or(f64::INFINITY, |load| (load - others.total).abs());
                let load = own.load().max(others.total);
                if change > SETTLED * load {
                    let press =
                        NormalSolver { follows: self.follows || change < SLIGHT * load, ..*self };
                    own.normal = press.pressed(&own.contact, &others, own.normal.as_ref())?;
                    own.load_of_others = Some(others.total);
                    is_settled = false;
                }
            }
            if is_settled {
                break;
            }
        }
        Ok(())
    }

    /// A contact under the loads of others; `None` where these, or its own smallness, leave no
    /// pressure.
    fn pressed(
        &self,
        contact: &Contact<'a>,
        others: &cross_patch::PointLoads,
        near: Option<&NormalContact>,
    ) -> Result<Option<NormalContact>, WheelsetError> {
        let side = contact.side;
        let gap = gap(contact, |s, x| others.deflection(contact, [x, s]));
        let gap = gap.map_err(|source| WheelsetError::Shape { side, source })?;
        let approach = contact.approach;
        let followed = near.filter(|_| self.follows).and_then(|near| near.follow(&gap, approach));
        let normal = match (followed, near) {
            (Some(followed), _) if followed.keeps_error_bars() => Ok(followed),
            (Some(followed), _) => followed.next(&gap, approach, self.resolution),
            (None, Some(near)) => near.next(&gap, approach, self.resolution),
            (None, None) => NormalContact::at_approach(&gap, self.pair, approach, self.resolution),
        };
        match normal {
            Ok(normal) => Ok(Some(normal)),
            Err(NormalError::NoContact { .. }) => Ok(None),
            Err(source) => Err(WheelsetError::Pressure { side, source }),
        }
    }
}

/// A contact among others, as far as it is known.
struct CrossPatch<'a> {
    contact: Contact<'a>,
    /// The pressure; at first that of a position close by.
    normal: Option<NormalContact>,
    /// The load of the others (N) under which it was found, once it was.
    load_of_others: Option<f64>,
}

impl<'a> CrossPatch<'a> {
    #[expect(clippy::large_types_passed_by_value, reason = "it is kept")]
    fn new(contact: Contact<'a>, near: Option<NormalContact>) -> Self {
        Self { contact, normal: near, load_of_others: None }
    }

    fn load(&self) -> f64 {
        self.normal.as_ref().map_or(0.0, |normal| normal.load().value)
    }

    fn pressed(self) -> Option<PressedContact<'a>> {
        let Self { contact, normal, .. } = self;
        normal.map(|normal| PressedContact { contact, normal })
    }
}

/// The undeformed distance over the plane of a contact, opened by `more` at `(s, x)`: parabolas along `x`, and on
/// surfaces that vary along rolling a lattice.
fn gap(
    contact: &Contact<'_>,
    more: impl Fn(f64, f64) -> f64,
) -> Result<Gap, creepage::gap::GapError> {
    if contact.varies() {
        let mut points = contact.lattice(LATTICE, MARGIN);
        for [x, s, gap] in &mut points {
            *gap += more(*s, *x);
        }
        return Gap::grid(&points);
    }
    let section = contact.section(PLACES, MARGIN);
    let column = |value: fn(&Across) -> f64| section.iter().map(value).collect();
    let [s, mut radius, locus]: [Vec<f64>; 3] =
        [column(|a| a.s), column(|a| a.rolling_radius), column(|a| a.x)];
    let gap: Vec<f64> = section.iter().map(|a| a.gap + more(a.s, a.x)).collect();
    let excess = Excess::of(contact, &section);
    if let Some(excess) = &excess {
        radius.clone_from(&excess.radius);
    }
    let gap = Gap::section(&s, &gap, Rolling::Varying { radius: &radius, locus: &locus })?;
    match excess {
        Some(Excess { d, s, values, .. }) => gap.with_excess(&d, &s, &values),
        None => Ok(gap),
    }
}

impl PressedContact<'_> {
    pub(crate) fn load(&self) -> f64 {
        self.normal.load().value
    }

    fn vertical_ratio(&self, shares: [f64; 2]) -> f64 {
        self.contact.tilt().vertical_ratio(shares)
    }
}

/// How much nearer a contact comes when the wheelset rolls about its centre (m/rad).
pub(crate) fn roll_lever(contact: &Contact<'_>, centre: [f64; 2]) -> f64 {
    let [_, aside, down] = contact.tilt().axes()[2];
    let [_, y, z] = contact.reference;
    (y - centre[0]) * down - (z - centre[1]) * aside
}

impl PressedWheel<'_> {
    /// Force on the rail along the track's `z` (N).
    pub(crate) fn vertical(&self, shares: &LateralForceRatios) -> f64 {
        self.contacts
            .iter()
            .map(|one| one.load() * one.vertical_ratio(shares.of(&one.contact)))
            .sum()
    }

    /// Error bar of its contacts' loads where they stand (N).
    pub(crate) fn load_error(&self) -> f64 {
        self.contacts.iter().map(|one| one.normal.load().error).sum()
    }

    /// Change of the vertical force (N/m) when the wheelset goes down.
    pub(crate) fn stiffness(&self, shares: &LateralForceRatios) -> f64 {
        self.change(shares, |contact| contact.tilt().down()[2])
    }

    /// Change of the vertical force (N/rad) when the wheelset rolls about its centre: on a flange
    /// the sideways part of that counts as much as the fall.
    pub(crate) fn stiffness_by_roll(&self, shares: &LateralForceRatios) -> f64 {
        let Position { y, z, .. } = self.position;
        let centre = [y, z - self.radius];
        self.change(shares, |contact| roll_lever(contact, centre))
    }

    /// Change of the vertical force when every contact comes nearer by `approach`.
    fn change(&self, shares: &LateralForceRatios, approach: impl Fn(&Contact<'_>) -> f64) -> f64 {
        let of = |one: &PressedContact<'_>| {
            one.normal.stiffness()
                * approach(&one.contact)
                * one.vertical_ratio(shares.of(&one.contact))
        };
        self.contacts.iter().map(of).sum::<f64>()
    }
}

/// The contacts of a wheel with their pressures.
pub type PressedContacts<'a> = Vec<(Contact<'a>, NormalContact)>;

impl<'a> WheelsetSolver<'a> {
    /// One wheel in a position, from its contacts in one nearby; without contacts where it hangs above its rail.
    ///
    /// # Errors
    /// [`WheelsetError`] where wheel and rail do not meet as they should, or a contact has no pressure.
    pub fn press_at(
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use creepage_rail::{Place, Position, Side, Standard, Track, Wheelset};

    use super::gap;

    /// What is pressed on the flange of a yawed wheel is the true gap where the bodies overlap by a third of the approach or
    /// more, and contact is: a thousandth of the approach is some .15 % of the load.
    #[test]
    fn gap_of_a_yawed_flange_is_the_true_one() {
        let track =
            Track::new(&Standard::Uic60.profile(), 0.025f64.atan(), Place::gauge(1.435, 0.014));
        let wheelset = Wheelset::like(&Standard::S1002.profile(), 0.46, 1.36).unwrap();
        let running = wheelset.on(track.unwrap());
        for z in [-3.1e-3, -3.0e-3, -2.9e-3] {
            let position = Position { y: 6.5e-3, z, roll: -0.0044, yaw: 0.0156 };
            for contact in running.contacts_of(Side::Right, &position).unwrap() {
                let pressed = gap(&contact, |_, _| 0.0).unwrap();
                let [x, s] = contact.extent;
                let place =
                    |[low, high]: [f64; 2], i: i32| low + (high - low) * f64::from(i) / 60.0;
                let mut worst = (0.0_f64, 0.0, 0.0);
                for (i, j) in (0..=60).flat_map(|i| (0..=60).map(move |j| (i, j))) {
                    let (x, s) = (place(x, i), place(s, j));
                    let Some(own) = contact.gap(x, s) else { continue };
                    if own < 0.67 * contact.approach {
                        let off = (pressed.at(x, s) - own).abs() / contact.approach;
                        if off > worst.0 {
                            worst = (off, x, s);
                        }
                    }
                }
                assert!(worst.0 < 1e-3, "{worst:?}");
            }
        }
    }
}
