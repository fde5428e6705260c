//! State of a wheelset, with which a contact map is asked, and the map's answer.

use crate::Side;
use crate::patch::Report;
use crate::wheel::{CellError, PLACES, WheelActs};

/// Position and motion of a wheelset, with which a map is asked. Axes of the track: `x` forward, `y` to the
/// right, `z` down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Its centre to the right of the track centre (m).
    pub y: f64,
    /// Turn about `z` (rad).
    pub yaw: f64,
    /// Turn about `x` (rad); found where `None`: both rails then carry the same.
    pub roll: Option<f64>,
    /// What holds it down.
    pub pressed: HeightOrLoad,
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
        let pressed =
            given(z).map(HeightOrLoad::Height).or(given(load).map(HeightOrLoad::AxleLoad));
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

/// Vertical constraint of a wheelset: its height or its load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HeightOrLoad {
    /// Its height (m, down).
    Height(f64),
    /// Vertical force of the wheelset on the track (N).
    AxleLoad(f64),
}

/// Answer of one contact, in track axes.
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

/// Answer of one wheel.
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

/// Answer of a map.
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

impl WheelAnswer {
    pub(crate) fn of(side: Side, acts: &WheelActs<f64>) -> Self {
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
    pub(crate) fn of(report: &Report, load: f64, sense: f64) -> Self {
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
