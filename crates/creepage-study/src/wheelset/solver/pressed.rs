//! One wheel pressed on its rail: its contacts and the pressure in each.

use creepage::SolidPair;
use creepage::gap::{Gap, Rolling};
use creepage::normal::{self, NormalContact, NormalError};
use creepage_rail::{Contact, Position, Running, Side};

use super::apart;
use crate::WheelsetError;

/// Places across a contact at which the undeformed bodies are looked up.
const PLACES: usize = 161;
/// How far beyond the overlap they reach, over its width.
const MARGIN: f64 = 0.05;

/// A place of contact with its pressure.
#[derive(Debug, Clone)]
pub(in crate::wheelset) struct Pressed<'a> {
    pub(in crate::wheelset) contact: Contact<'a>,
    pub(in crate::wheelset) normal: NormalContact,
}

/// A wheel at a height, with its contacts.
#[derive(Debug, Clone)]
pub(in crate::wheelset) struct PressedWheel<'a> {
    pub(in crate::wheelset) side: Side,
    pub(in crate::wheelset) position: Position,
    /// Height of the axle over the track at `z = 0` (m).
    pub(super) radius: f64,
    /// How far it was brought down from first touch to carry its load (m); zero where its height
    /// was given.
    pub(in crate::wheelset) depth: f64,
    pub(super) contacts: Vec<Pressed<'a>>,
}

/// What pressing needs to know besides the position.
#[derive(Debug, Clone, Copy)]
pub(super) struct Press<'a> {
    pub(super) running: &'a Running,
    pub(super) pair: SolidPair,
    pub(super) resolution: normal::Resolution,
}

impl<'a> Press<'a> {
    /// One wheel in a position; without contacts where it hangs above its rail.
    ///
    /// Contacts in one plane are one system; those in planes of their own feel each other as
    /// [`apart`] has it.
    pub(super) fn wheel(
        &self,
        side: Side,
        position: Position,
    ) -> Result<PressedWheel<'a>, WheelsetError> {
        const ROUNDS: usize = 12;
        const SETTLED: f64 = 1e-7;
        let geometry = |source| WheelsetError::Position { side, source };
        let contacts = self.running.contacts_of(side, &position).map_err(geometry)?;
        let alone = |contact: &Contact<'a>| self.pressed(contact, &[]);
        let mut pressed = contacts.iter().map(alone).collect::<Result<Vec<_>, _>>()?;
        for _ in 0..ROUNDS {
            if pressed.iter().flatten().count() < 2 {
                break;
            }
            let mut change = 0.0f64;
            for i in 0..contacts.len() {
                let others: Vec<Pressed<'a>> = (0..contacts.len())
                    .filter(|&j| j != i)
                    .filter_map(|j| pressed.get(j).cloned().flatten())
                    .collect();
                let (Some(contact), Some(known)) = (contacts.get(i), pressed.get_mut(i)) else {
                    continue;
                };
                let load = |one: &Option<Pressed>| one.as_ref().map_or(0.0, Pressed::load);
                let again = self.pressed(contact, &others)?;
                change = change
                    .max((load(&again) - load(known)).abs() / load(known).max(f64::MIN_POSITIVE));
                *known = again;
            }
            if change < SETTLED {
                break;
            }
        }
        let radius = self.running.wheelset().radius();
        Ok(PressedWheel {
            side,
            position,
            radius,
            depth: 0.0,
            contacts: pressed.into_iter().flatten().collect(),
        })
    }

    /// A contact beside others; `None` where these, or its own smallness, leave no pressure.
    fn pressed(
        &self,
        contact: &Contact<'a>,
        others: &[Pressed<'a>],
    ) -> Result<Option<Pressed<'a>>, WheelsetError> {
        let side = contact.side;
        let wrong = |source| WheelsetError::Pressure { side, source };
        let gap = gap(contact, |s, x| apart::sunk(contact, [x, s], others));
        let gap = gap.map_err(|source| WheelsetError::Shape { side, source })?;
        let approach = contact.approach;
        match NormalContact::at_approach(&gap, self.pair, approach, self.resolution) {
            Ok(normal) => Ok(Some(Pressed { contact: *contact, normal })),
            Err(NormalError::NoContact { .. }) => Ok(None),
            Err(source) => Err(wrong(source)),
        }
    }
}

/// The undeformed distance over the plane of a contact, opened by `more` at `(s, x)`.
fn gap(
    contact: &Contact<'_>,
    more: impl Fn(f64, f64) -> f64,
) -> Result<Gap, creepage::gap::GapError> {
    let section = contact.section(PLACES, MARGIN);
    let column = |value: fn(&creepage_rail::Across) -> f64| section.iter().map(value).collect();
    let [s, radius, locus]: [Vec<f64>; 3] =
        [column(|a| a.s), column(|a| a.rolling_radius), column(|a| a.x)];
    let gap: Vec<f64> = section.iter().map(|a| a.gap + more(a.s, a.x)).collect();
    Gap::section(&s, &gap, Rolling::Varying { radius: &radius, locus: &locus })
}

impl Pressed<'_> {
    pub(super) fn load(&self) -> f64 {
        self.normal.load().value
    }

    /// Vertical part of its force on the rail for a lateral force of `share` times the load.
    fn rise(&self, share: f64) -> f64 {
        let (sin, cos) = self.contact.angle.sin_cos();
        cos + share * sin
    }
}

/// What is known of the vertical loads from a position that was solved before.
#[derive(Debug, Clone)]
pub(super) struct Shares {
    /// Lateral force over load of contacts by their place on the rail: what friction adds.
    lateral: Vec<(Side, f64, f64)>,
    /// Vertical force over what a coarse solution has, left and right.
    scale: [f64; 2],
}

impl Default for Shares {
    fn default() -> Self {
        Self { lateral: Vec::new(), scale: [1.0; 2] }
    }
}

impl Shares {
    /// Remembers a contact by its place on the rail.
    pub(super) fn push(&mut self, side: Side, y_rail: f64, share: f64) {
        self.lateral.push((side, y_rail, share));
    }

    /// Remembers how much a wheel carries over what it carries in a coarse solution.
    pub(super) fn set_scale(&mut self, side: Side, scale: f64) {
        if scale > 0.0 && scale.is_finite() {
            self.scale[usize::from(side == Side::Right)] = scale;
        }
    }

    fn scale(&self, side: Side) -> f64 {
        self.scale[usize::from(side == Side::Right)]
    }

    /// That of the contact nearest on the rail; nothing where none is known.
    fn of(&self, contact: &Contact<'_>) -> f64 {
        let own = self.lateral.iter().filter(|(side, ..)| *side == contact.side);
        let distance = |y: f64| (y - contact.y_rail).abs();
        own.min_by(|a, b| distance(a.1).total_cmp(&distance(b.1))).map_or(0.0, |&(.., share)| share)
    }
}

impl PressedWheel<'_> {
    /// Force on the rail along the track's `z` (N).
    pub(super) fn vertical(&self, shares: &Shares) -> f64 {
        self.contacts.iter().map(|one| one.load() * one.rise(shares.of(&one.contact))).sum()
    }

    /// The same (N) as expected of a finer solution.
    pub(super) fn expected(&self, shares: &Shares) -> f64 {
        shares.scale(self.side) * self.vertical(shares)
    }

    /// Change of the expected force (N/m) when every contact goes down by `fall` times what the
    /// wheelset does.
    pub(super) fn stiffness(&self, shares: &Shares, fall: impl Fn(&Contact<'_>) -> f64) -> f64 {
        let of = |one: &Pressed<'_>| {
            let along = one.contact.angle.cos() * fall(&one.contact);
            one.normal.stiffness() * along * one.rise(shares.of(&one.contact))
        };
        shares.scale(self.side) * self.contacts.iter().map(of).sum::<f64>()
    }

    /// Where its load stands across the track (m), weighed by vertical force.
    pub(super) fn y(&self) -> Option<f64> {
        let force = |one: &Pressed<'_>| one.load() * one.contact.angle.cos();
        let total: f64 = self.contacts.iter().map(force).sum();
        let moment: f64 =
            self.contacts.iter().map(|one| force(one) * one.contact.reference[1]).sum();
        (total > 0.0).then_some(moment / total)
    }
}
