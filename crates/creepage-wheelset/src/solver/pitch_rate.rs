//! Search for the pitch rate at which friction balances the torque on the axle, or pulls as wanted.

use creepage::Scaling;
use creepage::numerics::Root;
use creepage_rail::{Motion, Side};
use rayon::prelude::*;

use super::tangential::{Rolled, Rolling};
use crate::pose::{Drive, PitchRate};
use crate::warm_start::PitchState;
use crate::{WheelsetError, WheelsetVelocity};

/// Of the moment of all friction about the axle, in parts of what it could be: as small beside its error bar
/// as what a load may miss.
pub(crate) const BALANCED: f64 = 1e-5;

/// Pitch rate of the wheels, with their contacts' rolling at it.
pub(crate) struct Turning<'r> {
    /// Of the left and of the right wheel.
    pub(crate) motions: [Motion; 2],
    pub(crate) rolled: Vec<Rolled<'r>>,
    /// What a position nearby may start from, of both wheels.
    pub(crate) pitch: [PitchState; 2],
}

/// Rolls in a motion with its pitch rates: given ones, or those at which friction balances the torque, or
/// pulls as wanted, to `moment_tolerance` of what it could.
pub(crate) fn turning<'r>(
    rollings: &'r [Rolling<'_, '_>],
    travel: &WheelsetVelocity,
    radius: f64,
    (guess, moment_tolerance): ([PitchState; 2], f64),
) -> Result<Turning<'r>, WheelsetError> {
    match travel.pitch {
        PitchRate::Rigid(rate) => {
            let search = PitchSearch { travel, rate, radius, guess: guess[0], moment_tolerance };
            let (motion, rolled, pitch) = search.run(rollings)?;
            Ok(Turning { motions: [motion; 2], rolled, pitch: [pitch; 2] })
        }
        PitchRate::Independent(rates) => {
            let count = rollings.iter().filter(|one| one.wheel.side == Side::Left).count();
            let (left, right) = rollings.split_at(count);
            let search = |k: usize| PitchSearch {
                travel,
                rate: rates[k],
                radius,
                guess: guess[k],
                moment_tolerance,
            };
            let (on_left, mut rolled, pitch_left) = search(0).run(left)?;
            let (on_right, more, pitch_right) = search(1).run(right)?;
            rolled.extend(more);
            let (motions, pitch) = ([on_left, on_right], [pitch_left, pitch_right]);
            Ok(Turning { motions, rolled, pitch })
        }
    }
}

/// The search for the pitch rate of wheels that turn together.
struct PitchSearch<'t> {
    travel: &'t WheelsetVelocity,
    rate: Option<f64>,
    radius: f64,
    guess: PitchState,
    moment_tolerance: f64,
}

impl PitchSearch<'_> {
    const MAX_STEPS: usize = 60;
    /// Of the rate of a wheel that rolls on its nominal circle: the narrowest bracket.
    const NARROW: f64 = 1e-13;
    /// The same: between these every wheel slides.
    const BRACKET: [f64; 2] = [0.2, 5.0];

    fn motion(&self, pitch_rate: f64) -> Motion {
        let WheelsetVelocity {
            speed,
            lateral_velocity,
            vertical_velocity,
            roll_rate,
            yaw_rate,
            ..
        } = *self.travel;
        let WheelsetVelocity { curvature, rails, .. } = *self.travel;
        Motion {
            speed,
            pitch_rate,
            lateral_velocity,
            vertical_velocity,
            roll_rate,
            yaw_rate,
            curvature,
            rails,
        }
    }

    fn at<'r>(
        &self,
        rollings: &'r [Rolling<'_, '_>],
        rate: f64,
        before: Vec<Rolled<'r>>,
    ) -> Result<(Motion, Vec<Rolled<'r>>, PitchState), WheelsetError> {
        let motion = self.motion(rate);
        let mut before: Vec<_> = before.into_iter().map(Some).collect();
        before.resize_with(rollings.len(), || None);
        let pairs = rollings.par_iter().zip(before);
        let rolled = pairs.map(|(one, before)| one.roll(&motion, before));
        let rolled = rolled.collect::<Result<Vec<_>, WheelsetError>>()?;
        Ok((motion, rolled, PitchState { rate: Some(rate), slope: self.guess.slope }))
    }

    fn run<'r>(
        &self,
        rollings: &'r [Rolling<'_, '_>],
    ) -> Result<(Motion, Vec<Rolled<'r>>, PitchState), WheelsetError> {
        let nominal = self.travel.speed / self.radius;
        if let Some(rate) = self.rate {
            return self.at(rollings, rate, Vec::new());
        }
        let most = self.most(rollings);
        if rollings.is_empty() {
            return match self.travel.drive {
                Drive::Torque(wanted) | Drive::Force(wanted) if wanted != 0.0 => {
                    Err(WheelsetError::TractionNotFound { wanted, most })
                }
                _ => self.at(rollings, nominal, Vec::new()),
            };
        }
        let slope = self.guess.slope.unwrap_or_else(|| self.first_slope(rollings));
        let bracket = Self::BRACKET.map(|times| times * nominal);
        let mut search = Root::new(self.guess.rate.unwrap_or(nominal), bracket);
        let mut before = Vec::new();
        for _ in 0..Self::MAX_STEPS {
            let (motion, rolled, pitch) = self.at(rollings, search.at, before)?;
            let excess = self.excess(rollings, &rolled);
            let is_found = excess.abs() < self.moment_tolerance * most;
            if is_found || search.is_spent(Self::NARROW * nominal) {
                if !is_found && bracket.iter().any(|end| (search.at / end - 1.0).abs() < 1e-6) {
                    let (Drive::Torque(wanted) | Drive::Force(wanted)) = self.travel.drive;
                    return Err(WheelsetError::TractionNotFound { wanted, most });
                }
                let known = search.slope().or(self.guess.slope);
                search.next_by_chord(excess, slope);
                let rate = if is_found { Some(search.at) } else { pitch.rate };
                return Ok((motion, rolled, PitchState { rate, slope: known }));
            }
            search.next_by_chord(excess, slope);
            before = rolled;
        }
        Err(WheelsetError::PitchNotFound)
    }

    /// The largest moment or force that friction can have.
    fn most(&self, rollings: &[Rolling<'_, '_>]) -> f64 {
        let lever = match self.travel.drive {
            Drive::Torque(_) => self.radius,
            Drive::Force(_) => 1.0,
        };
        rollings
            .iter()
            .map(|one| one.theory.scaling().force * lever)
            .fold(0.0, |sum, one| sum + one)
    }

    /// How much more friction holds the wheels back than wanted: rises with the pitch rate, for a wheel that
    /// turns faster drags the rail back.
    fn excess(&self, rollings: &[Rolling<'_, '_>], rolled: &[Rolled<'_>]) -> f64 {
        match self.travel.drive {
            Drive::Torque(torque) => {
                let pairs = rollings.iter().zip(rolled);
                let moment =
                    |(one, rolled): (&Rolling<'_, '_>, &Rolled<'_>)| -one.axle_moment(rolled.force);
                pairs.map(moment).sum::<f64>() - torque
            }
            Drive::Force(force) => {
                let pairs = rollings.iter().zip(rolled);
                force - pairs.map(|(one, rolled)| one.along_track(rolled.force)).sum::<f64>()
            }
        }
    }

    /// Change of the excess with the pitch rate, about: a slip unit of creepage is what it takes for a force
    /// unit.
    fn first_slope(&self, rollings: &[Rolling<'_, '_>]) -> f64 {
        let lever = match self.travel.drive {
            Drive::Torque(_) => self.radius,
            Drive::Force(_) => 1.0,
        };
        let by_slip = |one: &Rolling<'_, '_>| {
            let Scaling { force, slip, .. } = one.theory.scaling();
            2.0 * force / slip * self.radius * lever / self.travel.speed
        };
        rollings.iter().map(by_slip).sum()
    }
}
