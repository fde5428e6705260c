//! Wheelset as a function of numbers, as simulations ask it: position and motion in, forces out.

use crate::error::WheelsetError;
use crate::pose::{Load, PitchRate, WheelsetPose, WheelsetVelocity};
use crate::solved::{SolvedWheel, SolvedWheelset};

/// What a wheelset is asked by, in this order: position, what presses it, motion. Metres, radians,
/// newtons, seconds.
pub const ASKED: [&str; 12] = [
    "y",
    "z",
    "roll",
    "yaw",
    "axle_load",
    "roll_moment",
    "speed",
    "pitch_rate",
    "lateral_velocity",
    "vertical_velocity",
    "roll_rate",
    "yaw_rate",
];

/// What it answers, in this order and by these names, which end in units: force along `x`, `y`, `z` and moment about the
/// origin of the rail's profile on the left rail, then on the right one; force and moment of the rails on the wheelset about
/// its centre; height, roll, pitch rates of the left and of the right wheel.
pub const ANSWERS: [&str; 22] = [
    "left_longitudinal_n",
    "left_lateral_n",
    "left_vertical_n",
    "left_moment_x_n_m",
    "left_moment_y_n_m",
    "left_moment_z_n_m",
    "right_longitudinal_n",
    "right_lateral_n",
    "right_vertical_n",
    "right_moment_x_n_m",
    "right_moment_y_n_m",
    "right_moment_z_n_m",
    "wrench_x_n",
    "wrench_y_n",
    "wrench_z_n",
    "wrench_moment_x_n_m",
    "wrench_moment_y_n_m",
    "wrench_moment_z_n_m",
    "found_z_m",
    "found_roll_rad",
    "left_pitch_rate_rad_per_s",
    "right_pitch_rate_rad_per_s",
];

/// The position and the motion of numbers as of [`ASKED`]; NaN is the wheelset's `own`.
///
/// # Errors
/// [`WheelsetError`] for numbers that are not finite or contradict each other.
pub fn asked(
    (own, travel): (WheelsetPose, WheelsetVelocity),
    numbers: &[f64; ASKED.len()],
) -> Result<(WheelsetPose, WheelsetVelocity), WheelsetError> {
    let [y, z, roll, yaw, axle_load, roll_moment, motion @ ..] = *numbers;
    let [speed, pitch_rate, lateral, vertical, roll_rate, yaw_rate] = motion;
    let or = |value: f64, own: f64| if value.is_nan() { own } else { value };
    let given = |value: f64| (!value.is_nan()).then_some(value);
    let roll = given(roll).or(own.roll);
    let load = loaded(own.load, [z, axle_load, roll_moment], roll)?;
    let stance = WheelsetPose { y: or(y, own.y), yaw: or(yaw, own.yaw), roll, load, ..own };
    let pitch = match (given(pitch_rate), travel.pitch) {
        (None, own) => own,
        (Some(rate), PitchRate::Rigid(_)) => PitchRate::Rigid(Some(rate)),
        (Some(rate), PitchRate::Independent(_)) => PitchRate::Independent([Some(rate); 2]),
    };
    let travel = WheelsetVelocity {
        speed: or(speed, travel.speed),
        pitch,
        lateral_velocity: or(lateral, travel.lateral_velocity),
        vertical_velocity: or(vertical, travel.vertical_velocity),
        roll_rate: or(roll_rate, travel.roll_rate),
        yaw_rate: or(yaw_rate, travel.yaw_rate),
        ..travel
    };
    stance.checked()?;
    travel.checked()?;
    Ok((stance, travel))
}

/// What presses a wheelset that is asked so, of its own load.
fn loaded(
    own: Option<Load>,
    [z, axle_load, roll_moment]: [f64; 3],
    roll: Option<f64>,
) -> Result<Option<Load>, WheelsetError> {
    let conflict = |one, other| Err(WheelsetError::Conflict { section: "wheelset", one, other });
    let asked = [("axle_load", axle_load), ("roll_moment", roll_moment)];
    if !z.is_nan() {
        return match asked.into_iter().find(|(_, value)| !value.is_nan()) {
            Some((key, _)) => conflict(key, "z"),
            None => Ok(Some(Load::Height(z))),
        };
    }
    let load = match (own, axle_load.is_nan()) {
        (Some(Load::Loaded { moment, .. }), false) if roll.is_none() => {
            Some(Load::Loaded { load: axle_load, moment })
        }
        (_, false) => Some(Load::Axle(axle_load)),
        (own, true) => own,
    };
    match (load, roll_moment.is_nan()) {
        (load, true) => Ok(load),
        (Some(Load::Axle(load) | Load::Loaded { load, .. }), false) if roll.is_none() => {
            Ok(Some(Load::Loaded { load, moment: roll_moment }))
        }
        (Some(Load::Axle(_) | Load::Loaded { .. }), false) => conflict("roll_moment", "roll"),
        (load, false) => conflict("roll_moment", load.map_or("z", Load::key)),
    }
}

impl SolvedWheelset {
    /// What it answers, as of [`ANSWERS`]; NaN for a wheel that was not solved.
    #[must_use]
    pub fn answers(&self) -> [f64; ANSWERS.len()] {
        let mut all = [f64::NAN; ANSWERS.len()];
        let wheels = [&self.left, &self.right].map(|wheel| {
            wheel.as_ref().map_or([[f64::NAN; 3]; 2], |wheel| {
                let on_rail = wheel.on_rail();
                [on_rail.force, on_rail.moment]
            })
        });
        let position = self.position();
        let rate = |wheel: &Option<SolvedWheel>| wheel.as_ref().map_or(f64::NAN, |w| w.pitch_rate);
        let found = [position.z, position.roll, rate(&self.left), rate(&self.right)];
        let wrench = self.wrench(self.radius);
        let parts = wheels.as_flattened().iter().chain(&wrench).flatten().chain(&found);
        all.iter_mut().zip(parts).for_each(|(place, number)| *place = *number);
        all
    }
}
