//! Two bodies in contact, shifted to and fro: what they did before decides where they slip.

use super::partial_slip::{power_deficit, radius};
use super::{PartialSlipError, shift_compliances};
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;
use crate::hertz::Hertz;

/// An axis of the contact ellipse.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShiftAxis {
    /// Along `x`.
    X,
    /// Along `y`.
    Y,
}

/// A Hertz contact under a constant load whose tangential force along one axis goes to and fro below the limit of
/// friction (Mindlin and Deresiewicz).
///
/// After each turn the reversed slip begins at the edge again, by the same law with twice the friction. A loop that
/// closes is forgotten, and the path goes on as if there had been none. As in
/// [`PartialSlip`](super::PartialSlip) traction has the direction of the force; slip has it too only for `sigma = 0`.
///
/// ```
/// use creepage::statics::{ShiftAxis, ShiftPath};
/// use creepage::{Ellipse, Hertz, Solid, SolidPair};
/// let steel = Solid::new(82e9, 0.28)?;
/// let ellipse = Ellipse::new(4e-3, 4e-3)?;
/// let contact = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3)?;
/// let mut path = ShiftPath::new(&contact, 0.3, ShiftAxis::X)?;
/// path.to_force(12e3)?;
/// path.to_force(0.0)?; // the shift does not go back to zero
/// assert!((path.shift() / 0.9912e-6 - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Sources: C. Cattaneo, Rend. Accad. Lincei 27 (1938); R.D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20 (1953) 327-344.
#[derive(Debug, Clone)]
pub struct ShiftPath {
    contact: Ellipse,
    /// `mu N` (N), the shift at which the bodies would slide (m), `mu` times the peak pressure (Pa).
    limit: f64,
    unit: f64,
    bound: f64,
    /// Force and shift over their units where the path turned and where it is.
    turns: Vec<[f64; 2]>,
    at: [f64; 2],
    /// Over `mu N` times the unit of shift.
    dissipated: f64,
}

impl ShiftPath {
    /// The Hertz contact `contact` with coefficient of friction `friction`, pressed, and not shifted yet.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive.
    pub fn new(contact: &Hertz, friction: f64, axis: ShiftAxis) -> Result<Self, InvalidValue> {
        let friction = check::positive("friction", friction)?;
        let (pair, ellipse) = (contact.pair(), contact.ellipse());
        let bound = friction * contact.peak_pressure();
        let compliance = shift_compliances(ellipse, pair.poisson())[axis as usize];
        Ok(Self {
            contact: ellipse,
            limit: friction * contact.normal_force(),
            unit: bound / pair.shear_modulus() * ellipse.minor() * compliance,
            bound,
            turns: Vec::new(),
            at: [0.0; 2],
            dissipated: 0.0,
        })
    }

    /// The same contact, not shifted yet.
    #[must_use]
    pub fn fresh(&self) -> Self {
        Self { turns: Vec::new(), at: [0.0; 2], dissipated: 0.0, ..*self }
    }

    /// Goes on until the tangential force of the upper body on the lower is `force` (N).
    ///
    /// # Errors
    /// [`PartialSlipError::Sliding`] when the force reaches the limit of friction, [`PartialSlipError::Invalid`] unless
    /// it is finite; the path stays where it was.
    pub fn to_force(&mut self, force: f64) -> Result<(), PartialSlipError> {
        check::finite("force", force)?;
        if force.abs() >= self.limit {
            return Err(PartialSlipError::Sliding { force: force.abs(), limit: self.limit });
        }
        self.advance(0, force / self.limit);
        Ok(())
    }

    /// Goes on until the upper body is shifted by `shift` (m) against the lower, far from the contact.
    ///
    /// # Errors
    /// As [`ShiftPath::to_force`]: at [`ShiftPath::sliding_shift`] the bodies slide.
    pub fn to_shift(&mut self, shift: f64) -> Result<(), PartialSlipError> {
        check::finite("shift", shift)?;
        if shift.abs() >= self.unit {
            return Err(PartialSlipError::Sliding { force: self.limit, limit: self.limit });
        }
        self.advance(1, shift / self.unit);
        Ok(())
    }

    /// Tangential force of the upper body on the lower (N).
    #[must_use]
    pub fn force(&self) -> f64 {
        self.limit * self.at[0]
    }

    /// Shift of the upper body relative to the lower (m).
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.unit * self.at[1]
    }

    /// The shift at which the bodies slide (m).
    #[must_use]
    pub fn sliding_shift(&self) -> f64 {
        self.unit
    }

    /// Energy turned to heat since the bodies were pressed (J).
    #[must_use]
    pub fn dissipated(&self) -> f64 {
        self.limit * self.unit * self.dissipated
    }

    /// Semi-axes of the area that adheres, over those of the contact.
    #[must_use]
    pub fn adhesion(&self) -> f64 {
        1.0 - power_deficit(self.amplitude(), 1.0 / 3.0)
    }

    /// Traction on the lower body along the axis at `[x, y]` (Pa), zero outside the contact.
    #[must_use]
    pub fn traction(&self, point: [f64; 2]) -> f64 {
        let r = radius(self.contact, point);
        // Full sliding less what the area of adhesion is relieved of, for a force of so many mu N.
        let virgin = |share: f64| {
            let ratio = 1.0 - power_deficit(share.abs(), 1.0 / 3.0);
            let root = |r: f64| ((1.0 - r) * (1.0 + r)).max(0.0).sqrt();
            let relief = if ratio > 0.0 { ratio * root(r / ratio) } else { 0.0 };
            share.signum() * (root(r) - relief)
        };
        let stops = self.turns.iter().chain([&self.at]);
        let mut before = None;
        let parts = stops.map(|[force, _]| {
            let from = before.replace(*force);
            from.map_or_else(|| virgin(*force), |from| 2.0 * virgin(0.5 * (force - from)))
        });
        self.bound * parts.sum::<f64>()
    }

    /// The force since the last turn, half of it, or since the bodies were pressed.
    fn amplitude(&self) -> f64 {
        self.turns.last().map_or(self.at[0].abs(), |turn| 0.5 * (self.at[0] - turn[0]).abs())
    }

    /// Goes to a force (`axis` 0) or a shift (1), and forgets the loops that close on the way.
    fn advance(&mut self, axis: usize, target: f64) {
        let way = target - self.at[axis];
        if way == 0.0 {
            return;
        }
        let start = self.turns.last().copied().unwrap_or_default();
        // A turn.
        if way * (self.at[axis] - start[axis]) < 0.0 {
            self.turns.push(self.at);
        }
        while let Some(&last) = self.turns.last() {
            // The loop closes where it began; the first one at the mirror image of the first turn.
            let count = self.turns.len();
            let closing = if count > 1 { self.turns[count - 2] } else { last.map(|part| -part) };
            if (target - closing[axis]) * way < 0.0 {
                break;
            }
            self.move_to(closing);
            self.turns.truncate(count.saturating_sub(2));
        }
        self.move_to(self.on_branch(axis, target));
    }

    fn move_to(&mut self, at: [f64; 2]) {
        let spent = |path: &Self| {
            let whole = dissipation(path.amplitude());
            if path.turns.is_empty() { whole } else { 2.0 * whole }
        };
        let before = spent(self);
        self.at = at;
        self.dissipated += spent(self) - before;
    }

    /// Force and shift where one of them is given, on the branch since the last turn.
    fn on_branch(&self, axis: usize, target: f64) -> [f64; 2] {
        let (start, times) = self.turns.last().map_or(([0.0; 2], 1.0), |turn| (*turn, 2.0));
        let way = target - start[axis];
        // (3.65), and its inverse.
        let power = if axis == 0 { 2.0 / 3.0 } else { 1.5 };
        let other = times * power_deficit(way.abs() / times, power) * way.signum();
        let mut at = [target; 2];
        at[1 - axis] = start[1 - axis] + other;
        at
    }
}

/// Energy turned to heat on the way from zero to a force of so many `mu N`, over `mu N` and the unit of shift.
fn dissipation(share: f64) -> f64 {
    let gap = power_deficit(share, 1.0 / 3.0);
    let ratio = 1.0 - gap;
    gap.powi(3) * (1.0 + 3.0 * ratio + ratio * ratio) / 5.0
}
