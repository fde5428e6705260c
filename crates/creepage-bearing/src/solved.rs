//! Solved bearing: displacement, every ball, friction and heat.

use creepage::{Hertz, Status};
use rayon::prelude::*;

use crate::bearing::{BallBearing, BearingLoad, Control, INNER, OUTER, Operation};
use crate::equilibrium::{BallEquilibrium, BallForces, Displacement};
use crate::error::BearingError;
use crate::friction::{BearingTheory, RaceContact, RaceField, RaceFriction};
use crate::motion::{Ball, BallMotion};

/// Rounds of loads and friction, and the change of loads, in parts of them, at which they end.
const MAX_ROUNDS: usize = 40;
const SETTLED: [f64; 2] = [1e-7, 1e-5];

/// Solved bearing.
#[derive(Debug, Clone)]
pub struct SolvedBearing {
    /// Displacement of the inner ring along the axis and towards azimuth zero (m).
    pub displacement: Displacement,
    /// What the balls carry along the axis and radially (N).
    pub load: [f64; 2],
    /// Every ball that differs: one where there is no radial load.
    pub balls: Vec<SolvedBall>,
    /// How many balls are like each of these.
    pub alike: usize,
    /// Heat of all contacts (W).
    pub heat: f64,
    /// Moment of friction on the inner ring about the axis (N m), by the tractions on it, against its turning; under
    /// the control of a race, where balls are out of balance, that of the heat.
    pub moment: f64,
}

/// One ball.
#[derive(Debug, Clone)]
pub struct SolvedBall {
    /// Its place (rad).
    pub azimuth: f64,
    /// Centrifugal force (N).
    pub centrifugal: f64,
    /// Gyroscopic moment (N m).
    pub gyroscopic: f64,
    /// Its motion; `None` where it does not reach the inner race.
    pub motion: Option<BallMotion>,
    /// The inner and the outer contact; `None` where the ball does not touch a race.
    pub races: [Option<SolvedRace>; 2],
}

/// One contact of a ball and a ring.
#[derive(Debug, Clone, Copy)]
pub struct SolvedRace {
    /// Contact angle (rad).
    pub angle: f64,
    /// Ellipse and pressure.
    pub hertz: Hertz,
    /// What friction does; `None` on a ball that nothing drives.
    pub friction: Option<RaceFriction>,
    /// Heat (W).
    pub heat: f64,
    /// The largest sliding speed (m/s).
    pub sliding_speed: f64,
}

impl BallBearing {
    /// Solves the bearing.
    ///
    /// Balls are alike where there is no radial load, and one is solved. What it leaves out: the lubricant's film, the
    /// cage (no force on balls), tilt of the rings, and the changes of rings and clearance by heat and fit.
    ///
    /// # Errors
    /// [`BearingError`] for numbers out of range, loads that nothing carries, and balls whose motion is not found.
    ///
    /// ```
    /// use creepage::Solid;
    /// use creepage_bearing::{BallBearing, BearingLoad, BearingTheory, Control, Operation};
    ///
    /// let steel = Solid::from_young_modulus(208e9, 0.3)?;
    /// let bearing = BallBearing {
    ///     ball_diameter: 12.7e-3, pitch_diameter: 60e-3, balls: 12, contact_angle: 40_f64.to_radians(),
    ///     osculation: [0.52, 0.52], ball: steel, density: 7850.0, rings: [steel, steel], friction: 0.07,
    /// };
    /// let load = BearingLoad::Rings { axial: 2e3, radial: 0.0 };
    /// let runs = Operation { load, speed: [628.0, 0.0], control: Control::Balance };
    /// let solved = bearing.solve(&runs, BearingTheory::Sliding)?;
    /// assert!((solved.load[0] - 2e3).abs() < 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn solve(
        &self,
        operation: &Operation,
        theory: BearingTheory,
    ) -> Result<SolvedBearing, BearingError> {
        self.checked()?;
        operation.checked()?;
        let is_radial =
            matches!(operation.load, BearingLoad::Rings { radial, .. } if radial.abs() > 0.0);
        let count = if is_radial { self.balls } else { 1 };
        // By sliding friction first, which costs nothing, then by the theory.
        let stages = [(BearingTheory::Sliding, SETTLED[0]), (theory, SETTLED[1])];
        let mut known = IterationState::new(count, self.nominal_orbit(operation), self);
        let mut balls = Vec::new();
        for (stage, settled) in stages {
            for _ in 0..MAX_ROUNDS {
                let (displacement, standing) =
                    self.carry(operation.load, &known.acting, known.displacement)?;
                let roll = |(k, standing): (usize, &BallEquilibrium)| {
                    self.roll(operation, (k, standing), stage, known.motions[k].as_ref())
                };
                balls = standing.par_iter().enumerate().map(roll).collect::<Result<Vec<_>, _>>()?;
                if known.update(self, displacement, &standing, &balls, operation.control) <= settled
                {
                    break;
                }
            }
        }
        Ok(self.summed(operation, &known, balls, self.balls / count))
    }

    /// The orbit of balls that roll at the nominal contact angle (rad/s).
    fn nominal_orbit(&self, operation: &Operation) -> f64 {
        let angles = [self.contact_angle; 2];
        let ball = Ball { bearing: self, operation, azimuth: 0.0, angles };
        ball.motion([0.0; 2], ball.controlled_pitch(OUTER), 0.0).orbit
    }

    fn roll(
        &self,
        operation: &Operation,
        (k, standing): (usize, &BallEquilibrium),
        theory: BearingTheory,
        before: Option<&BallMotion>,
    ) -> Result<SolvedBall, BearingError> {
        let BallEquilibrium { angles, loads, .. } = *standing;
        let azimuth = self.azimuth(k);
        let pressed = |race: usize| -> Result<Option<Hertz>, BearingError> {
            (loads[race] > 0.0).then(|| self.pressed(race, angles[race], loads[race])).transpose()
        };
        let hertz = [pressed(INNER)?, pressed(OUTER)?];
        let still = |race: usize| {
            let hertz = hertz[race]?;
            Some(SolvedRace {
                angle: angles[race],
                hertz,
                friction: None,
                heat: 0.0,
                sliding_speed: 0.0,
            })
        };
        let ball = Ball { bearing: self, operation, azimuth, angles };
        let turns = operation.speed[INNER] - operation.speed[OUTER];
        let ([Some(inner), Some(outer)], true) = (hertz, turns.abs() > 0.0) else {
            let races = [still(INNER), still(OUTER)];
            return Ok(SolvedBall {
                azimuth,
                centrifugal: 0.0,
                gyroscopic: 0.0,
                motion: None,
                races,
            });
        };
        let contacts = [
            RaceContact::new(inner, self.friction, theory, INNER)?,
            RaceContact::new(outer, self.friction, theory, OUTER)?,
        ];
        let (motion, friction) = ball.roll(&contacts, before)?;
        let races = [INNER, OUTER].map(|race| {
            let (friction, speed) = (friction[race], motion.speed[race]);
            Some(SolvedRace {
                friction: Some(friction),
                heat: friction.heat * speed,
                sliding_speed: friction.largest_slip * speed,
                ..still(race)?
            })
        });
        let gyroscopic = ball.gyroscopic(&motion);
        Ok(SolvedBall { azimuth, centrifugal: 0.0, gyroscopic, motion: Some(motion), races })
    }

    /// What happens in the elements of a ball's inner (0) or outer (1) contact; `None` where nothing rolls or all slides by
    /// assumption.
    ///
    /// # Errors
    /// As [`BallBearing::solve`].
    pub fn race_field(
        &self,
        ball: &SolvedBall,
        race: usize,
        theory: BearingTheory,
    ) -> Result<Option<RaceField>, BearingError> {
        let found = ball.races.get(race).copied().flatten();
        let (Some(motion), Some(found)) = (ball.motion, found) else { return Ok(None) };
        let contact = RaceContact::new(found.hertz, self.friction, theory, race)?;
        Ok(contact.field(&motion.slip[race])?)
    }

    fn summed(
        &self,
        operation: &Operation,
        known: &IterationState,
        mut balls: Vec<SolvedBall>,
        alike: usize,
    ) -> SolvedBearing {
        for (ball, acting) in balls.iter_mut().zip(&known.acting) {
            ball.centrifugal = acting.centrifugal;
        }
        let times = alike as f64;
        let heat: f64 =
            balls.iter().flat_map(|ball| ball.races.iter().flatten()).map(|race| race.heat).sum();
        let moment: f64 = balls.iter().map(|ball| self.moment_on_inner_ring(ball)).sum();
        let load = self.carried(&known.standing, &known.acting);
        let load = if balls.len() == 1 { [times * load[0], 0.0] } else { load };
        let relative = operation.speed[INNER] - operation.speed[OUTER];
        // A ball that a race controls is out of balance: the rings' moments differ, and the heat gives the mean.
        let moment = match operation.control {
            Control::Balance => -relative.signum() * moment,
            Control::Inner | Control::Outer if relative == 0.0 => 0.0,
            Control::Inner | Control::Outer => heat / relative.abs(),
        };
        SolvedBearing {
            displacement: known.displacement.unwrap_or_default(),
            load,
            balls,
            alike,
            heat: times * heat,
            moment: times * moment,
        }
    }

    /// Moment of a ball's tractions on the inner ring about the axis (N m): at the contact's radius, by the moment about
    /// its normal, and by how far the surface rises across.
    fn moment_on_inner_ring(&self, ball: &SolvedBall) -> f64 {
        let (Some(motion), Some(race)) = (ball.motion, ball.races[INNER]) else { return 0.0 };
        let Some(friction) = race.friction else { return 0.0 };
        let (sin, cos) = race.angle.sin_cos();
        let sense = motion.sense[INNER];
        sense * friction.force.longitudinal * self.contact_radius(INNER, race.angle)
            - friction.force.moment * sin
            + sense * cos * friction.bent / (2.0 * self.conforming_radius(INNER))
    }
}

impl Operation {
    /// Checks every number.
    ///
    /// # Errors
    /// [`BearingError::Invalid`] that names the first that is out of range.
    pub fn checked(&self) -> Result<(), BearingError> {
        let check = |quantity, value: f64, is_valid: bool, valid| {
            let invalid = creepage::InvalidValue { quantity, value, valid };
            if is_valid { Ok(()) } else { Err(BearingError::from(invalid)) }
        };
        match self.load {
            BearingLoad::Rings { axial, radial } => {
                check(
                    "axial load",
                    axial,
                    axial >= 0.0 && axial.is_finite(),
                    "finite and not negative",
                )?;
                check(
                    "radial load",
                    radial,
                    radial >= 0.0 && radial.is_finite(),
                    "finite and not negative",
                )?;
                let valid = "positive: an axial or a radial load";
                check("load", axial.hypot(radial), axial + radial > 0.0, valid)?;
            }
            BearingLoad::Ball(load) => {
                check("ball load", load, load > 0.0 && load.is_finite(), "positive and finite")?;
            }
        }
        let speed = self.speed[INNER];
        check("inner speed", speed, speed.is_finite(), "finite")?;
        let speed = self.speed[OUTER];
        check("outer speed", speed, speed.is_finite(), "finite")
    }
}

/// State of the outer iteration on loads and friction, from round to round.
struct IterationState {
    displacement: Option<Displacement>,
    acting: Vec<BallForces>,
    standing: Vec<BallEquilibrium>,
    motions: Vec<Option<BallMotion>>,
}

impl IterationState {
    fn new(count: usize, orbit: f64, bearing: &BallBearing) -> Self {
        let centrifugal = bearing.centrifugal(orbit);
        let acting = vec![BallForces { centrifugal, across: [0.0; 2] }; count];
        Self { displacement: None, acting, standing: Vec::new(), motions: vec![None; count] }
    }

    /// Takes over what was found; by how much it changes the forces on balls, in parts of the largest load.
    fn update(
        &mut self,
        bearing: &BallBearing,
        displacement: Displacement,
        standing: &[BallEquilibrium],
        balls: &[SolvedBall],
        control: Control,
    ) -> f64 {
        let most = standing.iter().flat_map(|ball| ball.loads).fold(0.0, f64::max);
        let mut change = 0.0_f64;
        for ((acting, known), ball) in self.acting.iter_mut().zip(&mut self.motions).zip(balls) {
            let Some(motion) = ball.motion else { continue };
            let across = match control {
                Control::Balance => [INNER, OUTER].map(|race| {
                    let friction = ball.races[race].and_then(|race| race.friction);
                    friction.map_or(0.0, |f| motion.sense[race] * f.force.lateral)
                }),
                Control::Inner | Control::Outer => [ball.gyroscopic / bearing.ball_diameter; 2],
            };
            let next = BallForces { centrifugal: bearing.centrifugal(motion.orbit), across };
            change = change.max((next.centrifugal - acting.centrifugal).abs());
            for race in [INNER, OUTER] {
                change = change.max((next.across[race] - acting.across[race]).abs());
            }
            (*acting, *known) = (next, Some(motion));
        }
        self.displacement = Some(displacement);
        self.standing = standing.to_vec();
        change / most
    }
}

impl BallBearing {
    /// Centrifugal force of a ball in an orbit (N).
    fn centrifugal(&self, orbit: f64) -> f64 {
        0.5 * self.ball_mass() * self.pitch_diameter * orbit * orbit
    }
}

impl SolvedBearing {
    /// The ball whose contacts make the most heat, or carry most where none does.
    #[must_use]
    pub fn worst(&self) -> Option<&SolvedBall> {
        let size = |ball: &SolvedBall| {
            let races = ball.races.iter().flatten();
            races.map(|race| race.heat + 1e-12 * race.hertz.normal_force()).sum::<f64>()
        };
        self.balls.iter().max_by(|one, other| size(one).total_cmp(&size(other)))
    }

    /// Whether every contact was solved: the first status that is another.
    #[must_use]
    pub fn status(&self) -> Status {
        let contacts = self.balls.iter().flat_map(|ball| ball.races.iter().flatten());
        let statuses = contacts.filter_map(|race| Some(race.friction?.status));
        statuses.fold(
            Status::Solved,
            |worst, status| if worst == Status::Solved { status } else { worst },
        )
    }
}
