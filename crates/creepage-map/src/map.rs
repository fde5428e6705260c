//! Contact map of a wheelset: its two wheels, its accuracy, and its evaluation with derivatives.

use std::sync::Arc;

use creepage::table::Table;

use crate::Side;
use crate::answer::{Answer, HeightOrLoad, State, WheelAnswer};
use crate::equilibrium::{PITCH, ROLL, Unknowns, Z, implicit_derivatives};
use crate::error::{MapError, Quantity};
use crate::normal::Placed;
use crate::patch::{WheelsetState, cross};
use crate::scalar::{Dual, Scalar};
use crate::wheel::{WheelActs, WheelMap};

/// Description of the wheelset in a map's file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Head {
    /// Height of the axle over the track at `z = 0` (m).
    pub radius: f64,
    /// Half the distance between the tape circles (m).
    pub half_distance: f64,
    /// Origins of the left and the right rail's profile, on the right-hand image of each (m).
    pub rail_origins: [[f64; 2]; 2],
    /// Combined Poisson's ratio.
    pub poisson: f64,
    /// Least and largest coefficient of friction.
    pub friction: [f64; 2],
    /// Largest yaw (rad) to either side.
    pub yaw: f64,
    /// Largest roll (rad) to either side of a wheelset that rolls freely.
    pub roll: f64,
    /// The wheelset's own state, for what is left out of a question.
    pub own: State,
}

/// Distribution of a measured error.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Spread {
    /// Number of fresh states.
    pub states: usize,
    /// Root of the mean square.
    pub rms: f64,
    /// Half of the states err by less.
    pub median: f64,
    /// 95 of 100 states err by less.
    pub p95: f64,
    /// Largest.
    pub worst: f64,
}

/// The map's error against the full theory on states drawn afresh when it was built.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MapAccuracy {
    /// Tangential force, in parts of `mu N`: away from places where areas join, and there.
    pub tangential: [Spread; 2],
    /// Normal force, in parts of `N`, likewise.
    pub normal: [Spread; 2],
    /// The whole force from position and motion alone, in parts of `mu N`, likewise.
    pub total: [Spread; 2],
}

/// The contact map of a wheelset.
#[derive(Debug, Clone)]
pub struct ContactMap {
    pub(crate) head: Head,
    pub(crate) table: Arc<Table>,
    /// Of the left and the right wheel, both on the right-hand image.
    pub(crate) wheels: [Arc<WheelMap>; 2],
    pub(crate) accuracy: MapAccuracy,
    /// The wheelset's file, from which it was built.
    pub(crate) source: String,
}

/// By what a map's forces are differentiated: y, z, roll, yaw, speed, pitch rate, lateral velocity, yaw rate.
pub const VARIABLES: usize = 8;

/// Derivatives of the forces and moments of both wheels, as those of an answer, by [`VARIABLES`] numbers;
/// NaN by those that are found and not given, which follow.
pub type Derivatives = [[[f64; VARIABLES]; 6]; 2];

/// All numbers of position and motion.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Numbers<S> {
    pub(crate) y: S,
    pub(crate) z: S,
    pub(crate) roll: S,
    pub(crate) yaw: S,
    pub(crate) speed: S,
    pub(crate) pitch_rate: S,
    pub(crate) lateral_velocity: S,
    pub(crate) vertical_velocity: S,
    pub(crate) roll_rate: S,
    pub(crate) yaw_rate: S,
    pub(crate) friction: S,
}

impl<S: Scalar> Numbers<S> {
    /// Seen in a mirror along the track where the side is the left one.
    fn on(self, side: Side) -> Self {
        if side == Side::Right {
            return self;
        }
        Self {
            y: -self.y,
            roll: -self.roll,
            yaw: -self.yaw,
            lateral_velocity: -self.lateral_velocity,
            roll_rate: -self.roll_rate,
            yaw_rate: -self.yaw_rate,
            ..self
        }
    }
}

pub(crate) const SIDES: [Side; 2] = [Side::Left, Side::Right];

impl ContactMap {
    /// From its parts; both wheels on the right-hand image of their side.
    #[must_use]
    pub fn new(
        head: Head,
        table: Arc<Table>,
        wheels: [Arc<WheelMap>; 2],
        accuracy: MapAccuracy,
        source: String,
    ) -> Self {
        Self { head, table, wheels, accuracy, source }
    }

    /// What it knows of its wheelset.
    #[must_use]
    pub fn head(&self) -> &Head {
        &self.head
    }

    /// The map of a wheel.
    #[must_use]
    pub fn wheel(&self, side: Side) -> &WheelMap {
        &self.wheels[usize::from(side == Side::Right)]
    }

    /// The table of ellipses.
    #[must_use]
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// Its error against the full theory, as measured when it was built.
    #[must_use]
    pub fn accuracy(&self) -> &MapAccuracy {
        &self.accuracy
    }

    /// The text of the wheelset's file from which it was built.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// Forces of both wheels in a position and motion.
    ///
    /// Given `z`, roll and pitch rate, this takes the same time everywhere in the map; what is to be found
    /// is found by Newton's method, in a few times as long.
    ///
    /// # Errors
    /// [`MapError`] where the state lies outside the map, or what it leaves open is not found.
    pub fn solve(&self, state: &State) -> Result<Answer, MapError> {
        let found = self.found(state)?;
        self.answer(state, found)
    }

    /// The same of one wheel, of a state that leaves nothing to be found.
    ///
    /// # Errors
    /// [`MapError`] where the state lies outside the map; [`MapError::NoLoad`] where height, roll or pitch rate
    /// are missing.
    pub fn solve_wheel(&self, side: Side, state: &State) -> Result<WheelAnswer, MapError> {
        self.check(state)?;
        let (HeightOrLoad::Height(z), Some(roll), Some(rate)) =
            (state.pressed, state.roll, state.pitch_rate)
        else {
            return Err(MapError::NoLoad);
        };
        let acts = self.on_rail(side, &numbers::<f64>(state, [z, roll, rate]))?;
        Ok(WheelAnswer::of(side, &acts))
    }

    /// The same with derivatives of the forces; those by what is given, with what is found following.
    ///
    /// # Errors
    /// As [`ContactMap::solve`], and [`MapError::NotDifferentiable`].
    pub fn solve_with_derivatives(&self, state: &State) -> Result<(Answer, Derivatives), MapError> {
        let found = self.found(state)?;
        let answer = self.answer(state, found)?;
        let [z, roll, pitch_rate] = found;
        let variable = Dual::<VARIABLES>::variable;
        let numbers = Numbers {
            y: variable(state.y, 0),
            z: variable(z, Z),
            roll: variable(roll, ROLL),
            yaw: variable(state.yaw, 3),
            speed: variable(state.speed, 4),
            pitch_rate: variable(pitch_rate, PITCH),
            lateral_velocity: variable(state.lateral_velocity, 6),
            yaw_rate: variable(state.yaw_rate, 7),
            vertical_velocity: Scalar::constant(state.vertical_velocity),
            roll_rate: Scalar::constant(state.roll_rate),
            friction: Scalar::constant(state.friction),
        };
        let [left, right] = SIDES.map(|side| self.on_rail(side, &numbers));
        let wheels = [left?, right?];
        let mut all = [[[0.0; VARIABLES]; 6]; 2];
        for (rows, wheel) in all.iter_mut().zip(&wheels) {
            let parts = wheel.force.iter().chain(&wheel.moment);
            rows.iter_mut().zip(parts).for_each(|(row, part)| *row = part.d);
        }
        implicit_derivatives(state, &wheels, &mut all)?;
        Ok((answer, all))
    }

    fn answer(&self, state: &State, [z, roll, pitch_rate]: [f64; 3]) -> Result<Answer, MapError> {
        let numbers = numbers::<f64>(state, [z, roll, pitch_rate]);
        let [left, right] = SIDES.map(|side| self.on_rail(side, &numbers));
        let wheels = [left?, right?];
        let centre = [state.y, z - self.head.radius];
        let mut wrench = [0.0; 6];
        for (side, wheel) in SIDES.into_iter().zip(&wheels) {
            let [y, height] = self.origin(side);
            let arm = [0.0, y - centre[0], height - centre[1]];
            let lever = cross(arm, wheel.force);
            for k in 0..3 {
                wrench[k] -= wheel.force[k];
                wrench[3 + k] -= wheel.moment[k] + lever[k];
            }
        }
        let [left, right] = [0, 1].map(|k: usize| WheelAnswer::of(SIDES[k], &wheels[k]));
        Ok(Answer { left, right, wrench, z, roll, pitch_rate })
    }

    /// Origin of a rail's profile in track axes, lateral and vertical (m).
    fn origin(&self, side: Side) -> [f64; 2] {
        let [y, z] = self.head.rail_origins[usize::from(side == Side::Right)];
        [if side == Side::Right { y } else { -y }, z]
    }

    /// What one wheel does to its rail, in track axes; moments about the rail's origin.
    pub(crate) fn on_rail<S: Scalar>(
        &self,
        side: Side,
        numbers: &Numbers<S>,
    ) -> Result<WheelActs<S>, MapError> {
        let wrong = |error| MapError::Wheel { side, error: Box::new(error) };
        let image = numbers.on(side);
        let placed = self.placed(side, &image).map_err(wrong)?;
        let acts = self.wheel(side).act(&self.table, &placed, &asked(&self.head, side, &image));
        let mut acts = acts.map_err(wrong)?;
        if side == Side::Left {
            // A mirror turns lateral forces and all moments but the lateral one.
            acts.force[1] = -acts.force[1];
            acts.moment[0] = -acts.moment[0];
            acts.moment[2] = -acts.moment[2];
        }
        Ok(acts)
    }

    /// Where a wheel stands on its rail, on the right-hand image.
    pub(crate) fn placed<S: Scalar>(
        &self,
        side: Side,
        image: &Numbers<S>,
    ) -> Result<Placed<S>, MapError> {
        let Head { radius, half_distance, yaw, roll: most, .. } = self.head;
        let square = image.yaw * image.yaw;
        let plain = image.y - image.roll * radius - square * (0.5 * half_distance);
        let part = if yaw > 0.0 { square * (yaw * yaw).recip() } else { S::constant(0.0) };
        let heights = &self.wheel(side).heights;
        let placed = heights.placed(plain, [image.z, image.roll], (most, part))?;
        let value = placed.further.value();
        if !(-most..=most).contains(&value) {
            let quantity = Quantity::Roll;
            return Err(MapError::Outside { quantity, value, low: -most, high: most });
        }
        Ok(placed)
    }

    /// Where a wheel stands under a vertical load (N): its height (m), with roll and yaw of `state`, on the
    /// right-hand image; its place in the map (m).
    ///
    /// # Errors
    /// [`MapError::Outside`].
    pub fn height_under(&self, side: Side, state: &State, load: f64) -> Result<[f64; 2], MapError> {
        let image = numbers::<f64>(state, [0.0, state.roll.unwrap_or(0.0), 0.0]);
        let placed = self.placed(side, &image)?;
        self.wheel(side).heights.under(&placed, load)
    }

    /// Checks a state, and finds what it leaves open: z, roll, pitch rate.
    fn found(&self, state: &State) -> Result<[f64; 3], MapError> {
        self.check(state)?;
        let start = self.start(state)?;
        Unknowns::of(state).find(self, state, start)
    }

    fn check(&self, state: &State) -> Result<(), MapError> {
        let Head { friction, yaw, .. } = self.head;
        let within = |quantity, value: f64, [low, high]: [f64; 2]| {
            let inside = (low..=high).contains(&value);
            inside.then_some(()).ok_or(MapError::Outside { quantity, value, low, high })
        };
        within(Quantity::Friction, state.friction, friction)?;
        within(Quantity::Yaw, state.yaw, [-yaw, yaw])?;
        within(Quantity::Speed, state.speed, [f64::MIN_POSITIVE, 1e6])?;
        let pressed = match state.pressed {
            HeightOrLoad::Height(z) => z,
            HeightOrLoad::AxleLoad(load) => {
                let most = self.wheels.iter().flat_map(|wheel| wheel.loads()).fold(0.0, f64::max);
                within(Quantity::Load, 0.5 * load, [0.0, most])?;
                load
            }
        };
        let State { y, lateral_velocity, vertical_velocity, roll_rate, yaw_rate, .. } = *state;
        let others = [state.roll, state.pitch_rate].map(|given| given.unwrap_or(0.0));
        let finite = [pressed, y, lateral_velocity, vertical_velocity, roll_rate, yaw_rate];
        for value in finite.into_iter().chain(others) {
            within(Quantity::Finite, value, [-1e12, 1e12])?;
        }
        Ok(())
    }

    /// Where to begin: z and roll at which normal forces alone carry the load, the rate of the nominal circle.
    fn start(&self, state: &State) -> Result<[f64; 3], MapError> {
        const ROUNDS: usize = 6;
        let rate = state.pitch_rate.unwrap_or(state.speed / self.head.radius);
        // Where the right wheel's nodes were pressed: both wheels then touch.
        let free = || self.wheels[1].heights.free_roll(state.y, self.head.radius);
        let mut roll = state.roll.unwrap_or_else(free);
        let mut z = match state.pressed {
            HeightOrLoad::Height(z) => z,
            HeightOrLoad::AxleLoad(_) => 0.0,
        };
        if matches!((state.pressed, state.roll), (HeightOrLoad::Height(_), Some(_))) {
            return Ok([z, roll, rate]);
        }
        let mut loads = match state.pressed {
            HeightOrLoad::AxleLoad(load) => 0.5 * load,
            HeightOrLoad::Height(_) => self.wheels[0].loads().sum::<f64>() / 5.0,
        };
        for _ in 0..ROUNDS {
            let height = |side| {
                let image = numbers::<f64>(state, [z, roll, rate]).on(side);
                let wrong = |error| MapError::Wheel { side, error: Box::new(error) };
                let placed = self.placed(side, &image).map_err(wrong)?;
                let [height, _] = self.wheel(side).heights.under(&placed, loads).map_err(wrong)?;
                Ok::<_, MapError>(height)
            };
            let [left, right] = [height(Side::Left)?, height(Side::Right)?];
            if state.roll.is_none() {
                roll -= 0.5 * (left - right) / self.head.half_distance;
            }
            match state.pressed {
                HeightOrLoad::AxleLoad(_) => z = left.midpoint(right),
                // Deeper by so much: about as the power 3/2 of some 60 um.
                HeightOrLoad::Height(z) => {
                    let deeper = (z - left.midpoint(right)) / 60e-6;
                    loads *= (1.5 * deeper).clamp(-1.0, 1.0).exp();
                }
            }
        }
        Ok([z, roll, rate])
    }
}

/// What its patches are asked with, on the right-hand image.
fn asked<S: Scalar>(head: &Head, side: Side, image: &Numbers<S>) -> WheelsetState<S> {
    let (roll, yaw) = (image.roll.sin_cos(), image.yaw.sin_cos());
    // The axle's turning, yawed, then rolled.
    let [x, y] = [image.pitch_rate * yaw.0, -image.pitch_rate * yaw.1];
    WheelsetState {
        centre: [image.y, image.z - head.radius],
        roll,
        yaw,
        tan_yaw: yaw.0 / yaw.1,
        turning: [x + image.roll_rate, y * roll.1, y * roll.0 + image.yaw_rate],
        velocity: [image.speed, image.lateral_velocity, image.vertical_velocity],
        friction: image.friction,
        about: head.rail_origins[usize::from(side == Side::Right)],
    }
}

pub(crate) fn numbers<S: Scalar>(state: &State, [z, roll, pitch_rate]: [f64; 3]) -> Numbers<S> {
    let constant = S::constant;
    Numbers {
        y: constant(state.y),
        z: constant(z),
        roll: constant(roll),
        yaw: constant(state.yaw),
        speed: constant(state.speed),
        pitch_rate: constant(pitch_rate),
        lateral_velocity: constant(state.lateral_velocity),
        vertical_velocity: constant(state.vertical_velocity),
        roll_rate: constant(state.roll_rate),
        yaw_rate: constant(state.yaw_rate),
        friction: constant(state.friction),
    }
}

impl WheelMap {
    /// What this wheel does at a place of the map (m) under a vertical load (N) in a state whose height, roll
    /// and pitch rate are given, all on the right-hand image; heights are not asked.
    ///
    /// # Errors
    /// [`MapError`] as [`ContactMap::solve`].
    pub fn forces_under(
        &self,
        (head, table): (&Head, &Table),
        state: &State,
        [place, load]: [f64; 2],
    ) -> Result<WheelAnswer, MapError> {
        let z = match state.pressed {
            HeightOrLoad::Height(z) => z,
            HeightOrLoad::AxleLoad(_) => return Err(MapError::NoLoad),
        };
        let given = [z, state.roll.unwrap_or(0.0), state.pitch_rate.unwrap_or(0.0)];
        let asked = asked(head, Side::Right, &numbers::<f64>(state, given));
        let acts = self.act_under(table, place, load, &asked)?;
        Ok(WheelAnswer::of(Side::Right, &acts))
    }
}
