//! The contact map of a wheelset, and how it is asked.

use std::sync::Arc;

use creepage::table::Table;

use crate::Side;
use crate::error::{MapError, Quantity};
use crate::normal::Placed;
use crate::patch::{Asked, Report, cross};
use crate::scalar::{Dual, Scalar};
use crate::wheel::{CellError, PLACES, WheelActs, WheelMap};

/// What a map knows of its wheelset.
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

/// Where a wheelset stands and how it moves: what a map is asked with. Axes of the track: `x` forward,
/// `y` to the right, `z` down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Its centre to the right of the track centre (m).
    pub y: f64,
    /// Turn about `z` (rad).
    pub yaw: f64,
    /// Turn about `x` (rad); found where `None`: both rails then carry the same.
    pub roll: Option<f64>,
    /// What holds it down.
    pub pressed: Pressed,
    /// Speed along the track (m/s).
    pub speed: f64,
    /// Angular velocity about the axle (rad/s); where `None` that at which friction has no moment about it.
    pub pitch_rate: Option<f64>,
    /// Velocity to the right (m/s).
    pub lateral_velocity: f64,
    /// Velocity downwards (m/s).
    pub vertical_velocity: f64,
    /// Angular velocity about `x` (rad/s).
    pub roll_rate: f64,
    /// Angular velocity about `z` (rad/s).
    pub yaw_rate: f64,
    /// Coefficient of friction.
    pub friction: f64,
}

impl State {
    /// This state with other numbers where they are given and not NaN: y, z, roll, yaw, axle load; speed,
    /// pitch rate, lateral and vertical velocity, roll and yaw rate; friction.
    #[must_use]
    pub fn with(&self, numbers: &[f64; 12]) -> Self {
        let or = |value: f64, own: f64| if value.is_nan() { own } else { value };
        let given = |value: f64| (!value.is_nan()).then_some(value);
        let [y, z, roll, yaw, load, speed, rate, lateral, vertical, roll_rate, yaw_rate, friction] =
            *numbers;
        let pressed = given(z).map(Pressed::Height).or(given(load).map(Pressed::AxleLoad));
        Self {
            y: or(y, self.y),
            yaw: or(yaw, self.yaw),
            roll: given(roll).or(self.roll),
            pressed: pressed.unwrap_or(self.pressed),
            speed: or(speed, self.speed),
            pitch_rate: given(rate).or(self.pitch_rate),
            lateral_velocity: or(lateral, self.lateral_velocity),
            vertical_velocity: or(vertical, self.vertical_velocity),
            roll_rate: or(roll_rate, self.roll_rate),
            yaw_rate: or(yaw_rate, self.yaw_rate),
            friction: or(friction, self.friction),
        }
    }
}

/// What holds a wheelset down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pressed {
    /// Its height (m, down).
    Height(f64),
    /// Vertical force of the wheelset on the track (N).
    AxleLoad(f64),
}

/// One place of contact of an answer, in track axes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PatchAnswer {
    /// Reference point in track axes (m).
    pub reference: [f64; 3],
    /// From the track's `z` to the normal into the rail, about `x` (rad).
    pub angle: f64,
    /// Normal force (N); zero where there is no such place.
    pub normal_force: f64,
    /// Largest pressure (Pa).
    pub peak_pressure: f64,
    /// Area (m^2).
    pub area: f64,
    /// Longitudinal and lateral creepage, spin (rad/m).
    pub creepage: [f64; 3],
    /// On the rail, in the contact plane: longitudinal, lateral (N), moment about the normal (N m).
    pub friction: [f64; 3],
}

impl PatchAnswer {
    /// Energy turned to heat per metre rolled (J/m), `T gamma` of laws of wear: force times creepage, with
    /// spin.
    #[must_use]
    pub fn dissipation(&self) -> f64 {
        self.friction.iter().zip(self.creepage).map(|(force, creepage)| force * creepage).sum()
    }
}

/// One wheel of an answer.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WheelAnswer {
    /// Force on the rail along the track's axes (N).
    pub force: [f64; 3],
    /// Moment about the origin of the rail's profile (N m).
    pub moment: [f64; 3],
    /// Places of contact; those without a normal force are none.
    pub patches: [PatchAnswer; PLACES],
    /// Largest errors on the fresh states of this stretch of the map.
    pub error: CellError,
}

/// What a map answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// The left wheel.
    pub left: WheelAnswer,
    /// The right wheel.
    pub right: WheelAnswer,
    /// Force (N) and moment (N m) of the rails on the wheelset about its centre, in track axes.
    pub wrench: [f64; 6],
    /// Height (m, down), given or found.
    pub z: f64,
    /// Roll (rad), given or found.
    pub roll: f64,
    /// Angular velocity about the axle (rad/s), given or found.
    pub pitch_rate: f64,
}

impl Answer {
    /// Forces and moments on the left and on the right rail, the wrench on the wheelset, z, roll, pitch rate.
    #[must_use]
    pub fn numbers(&self) -> [f64; 21] {
        let mut all = [0.0; 21];
        let wheels = [&self.left, &self.right];
        let parts =
            wheels.into_iter().flat_map(|wheel| wheel.force.into_iter().chain(wheel.moment));
        let parts = parts.chain(self.wrench).chain([self.z, self.roll, self.pitch_rate]);
        all.iter_mut().zip(parts).for_each(|(to, from)| *to = from);
        all
    }
}

/// By what a map's forces are differentiated: y, z, roll, yaw, speed, pitch rate, lateral velocity, yaw rate.
pub const VARIABLES: usize = 8;

/// The numbers that a wheelset may find for itself.
const Z: usize = 1;
const ROLL: usize = 2;
const PITCH: usize = 5;

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

const SIDES: [Side; 2] = [Side::Left, Side::Right];

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
        let (Pressed::Height(z), Some(roll), Some(rate)) =
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
        follow(state, &wheels, &mut all)?;
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
    fn on_rail<S: Scalar>(
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
        let Head { radius, half_distance, .. } = self.head;
        let half_square = image.yaw * image.yaw * 0.5;
        let plain = image.y - image.roll * radius - half_square * half_distance;
        let placed =
            self.wheel(side).heights.placed(plain, [image.z, image.roll], half_square * radius)?;
        let (value, most) = (placed.further.value(), self.head.roll);
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
        Ok([self.wheel(side).heights.under(&placed, load), placed.place])
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
            Pressed::Height(z) => z,
            Pressed::AxleLoad(load) => {
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
            Pressed::Height(z) => z,
            Pressed::AxleLoad(_) => 0.0,
        };
        if matches!((state.pressed, state.roll), (Pressed::Height(_), Some(_))) {
            return Ok([z, roll, rate]);
        }
        let mut loads = match state.pressed {
            Pressed::AxleLoad(load) => 0.5 * load,
            Pressed::Height(_) => self.wheels[0].loads().sum::<f64>() / 5.0,
        };
        for _ in 0..ROUNDS {
            let height = |side| {
                let image = numbers::<f64>(state, [z, roll, rate]).on(side);
                let wrong = |error| MapError::Wheel { side, error: Box::new(error) };
                let placed = self.placed(side, &image).map_err(wrong)?;
                Ok::<_, MapError>(self.wheel(side).heights.under(&placed, loads))
            };
            let [left, right] = [height(Side::Left)?, height(Side::Right)?];
            if state.roll.is_none() {
                roll -= 0.5 * (left - right) / self.head.half_distance;
            }
            match state.pressed {
                Pressed::AxleLoad(_) => z = left.midpoint(right),
                // Deeper by so much: about as the power 3/2 of some 60 um.
                Pressed::Height(z) => {
                    let deeper = (z - left.midpoint(right)) / 60e-6;
                    loads *= (1.5 * deeper).clamp(-1.0, 1.0).exp();
                }
            }
        }
        Ok([z, roll, rate])
    }
}

/// What its patches are asked with, on the right-hand image.
fn asked<S: Scalar>(head: &Head, side: Side, image: &Numbers<S>) -> Asked<S> {
    let (roll, yaw) = (image.roll.sin_cos(), image.yaw.sin_cos());
    // The axle's turning, yawed, then rolled.
    let [x, y] = [image.pitch_rate * yaw.0, -image.pitch_rate * yaw.1];
    Asked {
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

/// Lets what is found follow what is given.
fn follow(
    state: &State,
    wheels: &[WheelActs<Dual<VARIABLES>>; 2],
    all: &mut Derivatives,
) -> Result<(), MapError> {
    let unknowns = Unknowns::of(state);
    let kept: Vec<[f64; VARIABLES]> = kept(state, wheels).into_iter().map(|kept| kept.d).collect();
    let open: Vec<usize> = unknowns.open.iter().copied().collect();
    if open.is_empty() {
        return Ok(());
    }
    let by = nalgebra::DMatrix::from_fn(open.len(), open.len(), |i, j| kept[i][open[j]]).lu();
    for given in 0..VARIABLES {
        let is_open = open.contains(&given);
        let right = nalgebra::DVector::from_fn(open.len(), |i, _| -kept[i][given]);
        let moved = by.solve(&right).ok_or(MapError::NotDifferentiable)?;
        for row in all.as_flattened_mut() {
            let follow: f64 = open.iter().zip(&moved).map(|(k, moved)| row[*k] * moved).sum();
            // The columns of what is found are needed until the last.
            if !is_open {
                row[given] += follow;
            }
        }
    }
    for row in all.as_flattened_mut() {
        for k in &open {
            row[*k] = f64::NAN;
        }
    }
    Ok(())
}

fn numbers<S: Scalar>(state: &State, [z, roll, pitch_rate]: [f64; 3]) -> Numbers<S> {
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

/// What a wheelset finds for itself.
struct Unknowns {
    /// Their places among the variables.
    open: Few,
}

/// Up to three numbers.
#[derive(Default)]
struct Few {
    all: [usize; 3],
    count: usize,
}

impl Few {
    fn push(&mut self, one: usize) {
        self.all[self.count] = one;
        self.count += 1;
    }

    fn iter(&self) -> std::slice::Iter<'_, usize> {
        self.all[..self.count].iter()
    }
}

impl Unknowns {
    fn of(state: &State) -> Self {
        let mut open = Few::default();
        if matches!(state.pressed, Pressed::AxleLoad(_)) {
            open.push(Z);
        }
        if state.roll.is_none() {
            open.push(ROLL);
        }
        if state.pitch_rate.is_none() {
            open.push(PITCH);
        }
        Self { open }
    }

    /// Newton's method from a start, each step no longer than the map believes in.
    fn find(&self, map: &ContactMap, state: &State, start: [f64; 3]) -> Result<[f64; 3], MapError> {
        const STEPS: usize = 40;
        /// Of the load, and of the load times a metre.
        const MET: f64 = 1e-9;
        let count = self.open.count;
        let mut at = start;
        if count == 0 {
            return Ok(at);
        }
        // Longest steps: 20 um, .1 mrad, .5 % of the rate.
        let longest = [20e-6, 1e-4, 5e-3 * state.speed / map.head.radius];
        let mut left = f64::INFINITY;
        for _ in 0..STEPS {
            let mut numbers = numbers::<Dual<3>>(state, at);
            for (k, open) in self.open.iter().enumerate() {
                match *open {
                    Z => numbers.z = Dual::variable(at[0], k),
                    ROLL => numbers.roll = Dual::variable(at[1], k),
                    _ => numbers.pitch_rate = Dual::variable(at[2], k),
                }
            }
            let [one, other] = SIDES.map(|side| map.on_rail(side, &numbers));
            let wheels = [one?, other?];
            let (mut residuals, mut filled) = ([Dual::<3>::constant(0.0); 3], 0);
            residuals_of(state, &wheels, |residual| {
                residuals[filled] = residual;
                filled += 1;
            });
            left = residuals[..count].iter().map(|r| r.v.abs()).fold(0.0, f64::max);
            if left < MET {
                return Ok(at);
            }
            let Some(step) = newton_step(&residuals, count) else { break };
            let place = |open: usize| match open {
                Z => 0,
                ROLL => 1,
                _ => 2,
            };
            let over =
                self.open.iter().zip(step).map(|(k, step)| (step / longest[place(*k)]).abs());
            let shorten = over.fold(1.0, f64::max).recip();
            for (open, step) in self.open.iter().zip(step) {
                at[place(*open)] += shorten * step;
            }
        }
        // Rounding of large heights is no failure.
        if left < 1e-6 { Ok(at) } else { Err(MapError::NotFound { left }) }
    }
}

/// What the unknowns make zero: forces over the load, and friction's moment about the axle over load and
/// metre.
fn kept<S: Scalar>(state: &State, wheels: &[WheelActs<S>; 2]) -> Vec<S> {
    let mut kept = Vec::with_capacity(3);
    residuals_of(state, wheels, |residual| kept.push(residual));
    kept
}

fn residuals_of<S: Scalar>(state: &State, wheels: &[WheelActs<S>; 2], mut add: impl FnMut(S)) {
    let [left, right] = wheels;
    let sum = left.force[2] + right.force[2];
    if let Pressed::AxleLoad(load) = state.pressed {
        add((sum - load) * load.recip());
    }
    let scale = match state.pressed {
        Pressed::AxleLoad(load) => load,
        Pressed::Height(_) => sum.value().max(1.0),
    };
    if state.roll.is_none() {
        add((right.force[2] - left.force[2]) * scale.recip());
    }
    if state.pitch_rate.is_none() {
        add((left.axle + right.axle) * scale.recip());
    }
}

/// The step that makes up to three residuals zero.
fn newton_step(residuals: &[Dual<3>; 3], count: usize) -> Option<[f64; 3]> {
    // Unused rows are those of the identity.
    let matrix = nalgebra::Matrix3::from_fn(|i, j| {
        if i < count && j < count { residuals[i].d[j] } else { f64::from(u8::from(i == j)) }
    });
    let right = nalgebra::Vector3::from_fn(|i, _| if i < count { -residuals[i].v } else { 0.0 });
    let step = matrix.lu().solve(&right)?;
    let step = [step[0], step[1], step[2]];
    step.iter().all(|part| part.is_finite()).then_some(step)
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
            Pressed::Height(z) => z,
            Pressed::AxleLoad(_) => return Err(MapError::NoLoad),
        };
        let given = [z, state.roll.unwrap_or(0.0), state.pitch_rate.unwrap_or(0.0)];
        let asked = asked(head, Side::Right, &numbers::<f64>(state, given));
        let acts = self.act_under(table, place, load, &asked)?;
        Ok(WheelAnswer::of(Side::Right, &acts))
    }
}

impl WheelAnswer {
    fn of(side: Side, acts: &WheelActs<f64>) -> Self {
        let sense = if side == Side::Right { 1.0 } else { -1.0 };
        let patch = |report: &Report| PatchAnswer::of(report, acts.load, sense);
        Self {
            force: acts.force,
            moment: acts.moment,
            patches: [patch(&acts.reports[0]), patch(&acts.reports[1])],
            error: acts.error,
        }
    }
}

impl PatchAnswer {
    fn of(report: &Report, load: f64, sense: f64) -> Self {
        let [x, y, z] = report.reference;
        let [along, across, spin] = report.creepage;
        let [fx, fs, mz] = report.friction.map(|force| force * load);
        Self {
            reference: [x, sense * y, z],
            angle: sense * report.angle,
            normal_force: report.share * load,
            peak_pressure: report.peak_pressure,
            area: report.area,
            creepage: [along, sense * across, sense * spin],
            friction: [fx, sense * fs, sense * mz],
        }
    }
}
