//! Derivatives of the forces on the rails by the wheelset's position and motion.

use creepage_rail::Side;

/// Variable of the wheelset's position or motion, by which forces on the rails are differentiated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StateVariable {
    /// Its lateral position, to the right (m).
    Y,
    /// Its height, downwards (m).
    Z,
    /// Its turn about `x` (rad).
    Roll,
    /// Its turn about `z` (rad).
    Yaw,
    /// Its speed along the track (m/s).
    Speed,
    /// Its angular velocity about the axle (rad/s).
    PitchRate,
    /// Its velocity to the right (m/s).
    LateralVelocity,
    /// Its angular velocity about `z` (rad/s).
    YawRate,
}

impl StateVariable {
    /// All of them: the position, then the motion.
    pub const ALL: [Self; 8] = [
        Self::Y,
        Self::Z,
        Self::Roll,
        Self::Yaw,
        Self::Speed,
        Self::PitchRate,
        Self::LateralVelocity,
        Self::YawRate,
    ];

    /// Its key in the report's JSON, with its unit.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::Y => "y_m",
            Self::Z => "z_m",
            Self::Roll => "roll_rad",
            Self::Yaw => "yaw_rad",
            Self::Speed => "speed_m_per_s",
            Self::PitchRate => "pitch_rate_rad_per_s",
            Self::LateralVelocity => "lateral_velocity_m_per_s",
            Self::YawRate => "yaw_rate_rad_per_s",
        }
    }

    /// Its place in [`StateVariable::ALL`].
    pub(crate) fn index(self) -> usize {
        self as usize
    }
}

/// Derivative of a wheel's force and moment on its rail, in track axes and per unit of [`StateVariable`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceDerivative {
    /// Of the force along `x`, `y`, `z` (N).
    pub force: [f64; 3],
    /// What the differences may have made of it (N), as of [`WheelsetDerivatives`].
    pub force_error: [f64; 3],
    /// Of the moment about `x`, `y`, `z` through the origin of the rail's profile (N m).
    pub moment: [f64; 3],
    /// What the differences may have made of it (N m).
    pub moment_error: [f64; 3],
}

/// Derivatives of the forces on the rails, for the Jacobian of a vehicle.
///
/// They are total ones: with an axle load, height and roll follow what changes so that the rails
/// carry the load still, friction's part of it included; with a pitch rate that is free, it follows
/// so that friction has no moment about the axle. What is given and what is found is that of
/// [`WheelsetPose`](crate::WheelsetPose) and [`WheelsetVelocity`](crate::WheelsetVelocity).
///
/// By the position they are central differences at places next to the solved one, each of which
/// has its own pressure and friction; by the motion they are the theory's exact derivatives. Their
/// error is the difference from those with twice the step: large where the forces have a kink nearby,
/// such as a second place of contact that is about to carry. It knows nothing of what the
/// resolution leaves out.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelsetDerivatives {
    pub(crate) left: Option<Row>,
    pub(crate) right: Option<Row>,
}

/// Derivatives of one wheel's force by [`StateVariable::ALL`]; `None` where that is found and not given.
pub(crate) type Row = [Option<ForceDerivative>; StateVariable::ALL.len()];

impl WheelsetDerivatives {
    /// The derivative of the force on the rail of one side; `None` where that wheel is not solved, or
    /// where the quantity is not given but found.
    #[must_use]
    pub fn of(&self, side: Side, by: StateVariable) -> Option<ForceDerivative> {
        let row = match side {
            Side::Left => self.left,
            Side::Right => self.right,
        };
        row?[by.index()]
    }

    /// Those of the mirror image fore and aft.
    pub(crate) fn fore_and_aft(&self) -> Self {
        // Forces along x, moments about y and z, and what turns the wheelset about them, change sign.
        let turns = |by: StateVariable| {
            let is_odd = matches!(
                by,
                StateVariable::Yaw
                    | StateVariable::Speed
                    | StateVariable::PitchRate
                    | StateVariable::YawRate
            );
            if is_odd { -1.0 } else { 1.0 }
        };
        let turned = |row: &Row| -> Row {
            StateVariable::ALL.map(|by| {
                let one = row[by.index()]?;
                let (force, moment) = ([-1.0, 1.0, 1.0], [1.0, -1.0, -1.0]);
                Some(ForceDerivative {
                    force: [0, 1, 2].map(|k: usize| turns(by) * force[k] * one.force[k]),
                    moment: [0, 1, 2].map(|k: usize| turns(by) * moment[k] * one.moment[k]),
                    ..one
                })
            })
        };
        Self { left: self.left.as_ref().map(turned), right: self.right.as_ref().map(turned) }
    }

    /// All of them as one array: of the left and the right wheel; force along `x`, `y`, `z`, moment
    /// about `x`, `y`, `z`; by [`StateVariable::ALL`]. NaN where there is none.
    #[must_use]
    pub fn values(&self) -> [[[f64; 8]; 6]; 2] {
        self.array(|one| [one.force, one.moment])
    }

    /// Their errors, in the same way.
    #[must_use]
    pub fn errors(&self) -> [[[f64; 8]; 6]; 2] {
        self.array(|one| [one.force_error, one.moment_error])
    }

    fn array(&self, parts: impl Fn(&ForceDerivative) -> [[f64; 3]; 2]) -> [[[f64; 8]; 6]; 2] {
        let value = |row: &Option<Row>, i: usize, k: usize| {
            let derivative = row.as_ref().and_then(|row| row[k].as_ref());
            derivative.map_or(f64::NAN, |one| parts(one)[i / 3][i % 3])
        };
        [&self.left, &self.right]
            .map(|row| std::array::from_fn(|i| std::array::from_fn(|k| value(row, i, k))))
    }
}
