//! Kinematics of a ball between its races: rotation and orbit, spin and creepage of both contacts, and the motion at
//! which friction balances the ball.
//!
//! Axes of a ball: along the bearing's axis (the inner ring is pressed that way), out from it, and around it; the frame
//! turns with the ball's orbit. A contact has `z` from the ball into the ring, `x` the way it travels over the surfaces,
//! `y = z x x`.

use creepage::SiCreepage;
use nalgebra::SVector;

use crate::bearing::{BallBearing, Control, INNER, OUTER, Operation};
use crate::equilibrium::newton;
use crate::error::BearingError;
use crate::friction::{RaceContact, RaceFriction, RaceSlip};

/// Residual of the balance, in parts of the friction of both contacts, at which a motion is found.
const TOLERANCE: f64 = 1e-6;
/// What is left at most where the line search ends before: contact solvers scatter by their own tolerance.
const ACCEPTED: f64 = 1e-3;

/// Steps in which the ball's inertia grows where Newton's method stagnates at once.
const CONTINUATION: u32 = 8;

/// Motion of a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallMotion {
    /// Angular velocity of its orbit (rad/s), that of a cage.
    pub orbit: f64,
    /// Its own angular velocity in the frame of the orbit (rad/s), negative where it turns against the inner ring.
    pub rotation: f64,
    /// Angle of its axis of rotation from the bearing's (rad).
    pub pitch: f64,
    /// Its angular velocity about the direction around the bearing (rad/s): gyroscopic slip.
    pub yaw_rate: f64,
    /// Rolling speeds at the inner and the outer contact (m/s).
    pub speed: [f64; 2],
    /// Slip of both contacts.
    pub slip: [RaceSlip; 2],
    /// Sense of `x` in both contacts around the bearing: 1 or -1.
    pub(crate) sense: [f64; 2],
}

/// What a motion is found from: creepages along rolling in both contacts, pitch, yaw rate over a rolling rate.
type Unknowns = SVector<f64, 4>;

/// A ball between its races.
#[derive(Debug)]
pub(crate) struct Ball<'a> {
    pub(crate) bearing: &'a BallBearing,
    pub(crate) operation: &'a Operation,
    pub(crate) azimuth: f64,
    /// Contact angles (rad).
    pub(crate) angles: [f64; 2],
}

impl Ball<'_> {
    /// The motion in which both contacts have given creepages along rolling, and a pitch.
    ///
    /// With the ring's surface at `v` the ball's is at `v (1 - creepage)`: two linear equations for rotation and orbit.
    pub(crate) fn motion(&self, creepage: [f64; 2], pitch: f64, yaw_rate: f64) -> BallMotion {
        let (bearing, half) = (self.bearing, 0.5 * self.bearing.ball_diameter);
        let radii = [INNER, OUTER].map(|race| bearing.contact_radius(race, self.angles[race]));
        // The ball's surface moves by `lever * rotation` around the bearing.
        let levers =
            [-half * (self.angles[INNER] - pitch).cos(), half * (self.angles[OUTER] - pitch).cos()];
        let factors = [INNER, OUTER].map(|race| (1.0 - creepage[race]) * radii[race]);
        let [inner, outer] = self.operation.speed;
        // levers[k] rotation + factors[k] orbit = factors[k] speed[k].
        let rights = [factors[INNER] * inner, factors[OUTER] * outer];
        let determinant = levers[INNER] * factors[OUTER] - levers[OUTER] * factors[INNER];
        let rotation =
            (rights[INNER] * factors[OUTER] - rights[OUTER] * factors[INNER]) / determinant;
        let orbit = (levers[INNER] * rights[OUTER] - levers[OUTER] * rights[INNER]) / determinant;
        let surface = [INNER, OUTER].map(|race| (self.operation.speed[race] - orbit) * radii[race]);
        let sense = surface.map(|speed| -speed.signum());
        let speed = surface.map(f64::abs);
        let turns = [
            -rotation * (self.angles[INNER] - pitch).sin()
                + (inner - orbit) * self.angles[INNER].sin(),
            rotation * (self.angles[OUTER] - pitch).sin()
                - (outer - orbit) * self.angles[OUTER].sin(),
        ];
        let slip = [INNER, OUTER].map(|race| RaceSlip {
            creepage: SiCreepage {
                longitudinal: creepage[race],
                lateral: -sense[race] * half * yaw_rate / speed[race],
                spin: turns[race] / speed[race],
            },
            heathcote: bearing.heathcote(race, self.angles[race]),
        });
        BallMotion { orbit, rotation, pitch, yaw_rate, speed, slip, sense }
    }

    /// The pitch at which a race does not spin, from no slip at both contacts.
    pub(crate) fn controlled_pitch(&self, race: usize) -> f64 {
        let ratio = self.bearing.ball_diameter / self.bearing.pitch_diameter;
        let (sin, cos) = self.angles[race].sin_cos();
        let out = if race == INNER { -ratio } else { ratio };
        sin.atan2(cos + out)
    }

    /// Gyroscopic moment about the direction around the bearing (N m).
    pub(crate) fn gyroscopic(&self, motion: &BallMotion) -> f64 {
        -self.bearing.ball_inertia() * motion.orbit * motion.rotation * motion.pitch.sin()
    }

    /// The motion as `control` asks, and friction in both contacts.
    pub(crate) fn roll(
        &self,
        contacts: &[RaceContact; 2],
        before: Option<&BallMotion>,
    ) -> Result<(BallMotion, [RaceFriction; 2]), BearingError> {
        match self.operation.control {
            Control::Balance => self.balanced(contacts, before),
            Control::Inner => self.controlled(contacts, INNER),
            Control::Outer => self.controlled(contacts, OUTER),
        }
    }

    /// One race without spin; creepage along rolling so that neither contact has a force along it.
    fn controlled(
        &self,
        contacts: &[RaceContact; 2],
        race: usize,
    ) -> Result<(BallMotion, [RaceFriction; 2]), BearingError> {
        let pitch = self.controlled_pitch(race);
        let start = self.start(contacts);
        let unit = contacts.each_ref().map(RaceContact::bound);
        let steps = SVector::from([1e-6, 1e-6]);
        let (found, left) = newton(start, steps, TOLERANCE, |creepage| {
            let motion = self.motion([creepage[0], creepage[1]], pitch, 0.0);
            let friction = solved(contacts, &motion)?;
            Ok::<_, BearingError>(SVector::from(
                [0, 1].map(|k: usize| friction[k].force.longitudinal / unit[k]),
            ))
        })?;
        self.accepted(left)?;
        let motion = self.motion([found[0], found[1]], pitch, 0.0);
        let friction = solved(contacts, &motion)?;
        Ok((motion, friction))
    }

    /// Creepage along rolling at which Heathcote's slip has no force where all slides.
    fn start(&self, contacts: &[RaceContact; 2]) -> SVector<f64, 2> {
        /// Place of no slip over the semi-axis across, `2 sin 10 degrees`.
        const BAND: f64 = 0.347_296_355_333_860_7;
        SVector::from([INNER, OUTER].map(|race| {
            let half = contacts[race].half_width();
            -self.bearing.heathcote(race, self.angles[race]) * (BAND * half).powi(2)
        }))
    }

    /// All of friction in balance: along the orbit, and the three moments about the ball's centre.
    fn balanced(
        &self,
        contacts: &[RaceContact; 2],
        before: Option<&BallMotion>,
    ) -> Result<(BallMotion, [RaceFriction; 2]), BearingError> {
        let half = 0.5 * self.bearing.ball_diameter;
        let pitches = [INNER, OUTER].map(|race| self.controlled_pitch(race));
        let fresh = |pitch: f64| {
            let creepage = self.start(contacts);
            Unknowns::from([creepage[0], creepage[1], pitch, 0.0])
        };
        let start = if let Some(motion) = before {
            Unknowns::from([
                motion.slip[INNER].creepage.longitudinal,
                motion.slip[OUTER].creepage.longitudinal,
                motion.pitch,
                motion.yaw_rate / motion.rotation,
            ])
        } else {
            fresh(0.5 * (pitches[INNER] + pitches[OUTER]))
        };
        let motion_of = |at: &Unknowns| {
            let turning = self.motion([at[0], at[1]], at[2], 0.0);
            self.motion([at[0], at[1]], at[2], at[3] * turning.rotation)
        };
        let bound: f64 = contacts.iter().map(RaceContact::bound).sum();
        let width = contacts.iter().map(RaceContact::half_width).fold(0.0, f64::max);
        let normals = self.normals();
        // By a share of the ball's inertia.
        let residual = |at: &Unknowns, share: f64| {
            let motion = motion_of(at);
            let friction = solved(contacts, &motion)?;
            let (mut along, mut moment) = (0.0, [0.0; 3]);
            for race in [INNER, OUTER] {
                let ([p, q], sense) = (normals[race], motion.sense[race]);
                let creepage::SiForce { longitudinal, lateral, moment: spin } =
                    friction[race].force;
                // The surface of contact is nearer to the ball's centre off its middle.
                let nearer = friction[race].bent / (2.0 * self.bearing.conforming_radius(race));
                let turning = half * longitudinal - nearer;
                along -= sense * longitudinal;
                moment[0] += -turning * sense * q - spin * p;
                moment[1] += turning * sense * p - spin * q;
                moment[2] += half * sense * lateral;
            }
            // The change of the ball's angular momentum as its orbit turns it.
            let turned = share * self.bearing.ball_inertia() * motion.orbit;
            moment[1] += turned * motion.yaw_rate;
            moment[2] += turned * motion.rotation * motion.pitch.sin();
            let mean = [0, 1].map(|k: usize| normals[OUTER][k] - normals[INNER][k]);
            let size = mean[0].hypot(mean[1]);
            let [m, n] = mean.map(|part| part / size);
            Ok::<_, BearingError>(Unknowns::from([
                along / bound,
                (moment[0] * n - moment[1] * m) / (bound * half),
                (moment[0] * m + moment[1] * n) / (bound * width),
                moment[2] / (bound * half),
            ]))
        };
        let apart = (pitches[INNER] - pitches[OUTER]).abs().max(1e-6);
        let steps = Unknowns::from([1e-6, 1e-6, 1e-4 * apart, 1e-6]);
        let at_share = |start, share| newton(start, steps, TOLERANCE, |at| residual(at, share));
        let (mut found, mut left) = at_share(start, 1.0)?;
        // Continuation from a ball without inertia, which either race may control.
        for pitch in [pitches[OUTER], pitches[INNER]] {
            if left <= ACCEPTED {
                break;
            }
            let mut at = fresh(pitch);
            for part in 0..=CONTINUATION {
                (at, left) = at_share(at, f64::from(part) / f64::from(CONTINUATION))?;
            }
            found = at;
        }
        // The true cause comes first: an area as wide as the ball has no motion.
        if left > ACCEPTED && width > half {
            return Err(BearingError::LargeContact {
                azimuth: self.azimuth,
                half_width: width,
                radius: half,
            });
        }
        let motion = motion_of(&found);
        let (gyroscopic, most) = (self.gyroscopic(&motion), bound * half);
        if left > ACCEPTED && gyroscopic.abs() > 0.9 * most {
            return Err(BearingError::BallSlides { azimuth: self.azimuth, gyroscopic, most });
        }
        self.accepted(left)?;
        let friction = solved(contacts, &motion)?;
        Ok((motion, friction))
    }

    fn accepted(&self, residual: f64) -> Result<(), BearingError> {
        if residual <= ACCEPTED {
            return Ok(());
        }
        Err(BearingError::MotionNotFound { azimuth: self.azimuth, residual })
    }

    /// Normals from the ball into both rings, along the axis and out from it.
    pub(crate) fn normals(&self) -> [[f64; 2]; 2] {
        let [inner, outer] = self.angles.map(f64::sin_cos);
        [[-inner.0, -inner.1], [outer.0, outer.1]]
    }
}

fn solved(
    contacts: &[RaceContact; 2],
    motion: &BallMotion,
) -> Result<[RaceFriction; 2], BearingError> {
    Ok([contacts[INNER].solve(&motion.slip[INNER])?, contacts[OUTER].solve(&motion.slip[OUTER])?])
}
