//! Equilibrium of rings and balls by Newton's method: each ball between its grooves under load, centrifugal force and
//! what friction does across, and the displacement of the inner ring that carries the bearing's load (Jones 1960,
//! Harris).

use creepage::numerics::{self, NewtonLimits};
use nalgebra::{SMatrix, SVector};

use crate::bearing::{BallBearing, BearingLoad, INNER, OUTER};
use crate::error::BearingError;

/// Of the load, to which an equilibrium is found.
const TOLERANCE: f64 = 1e-9;
/// What may be left of it where rounding ends the search.
const ACCEPTED: f64 = 1e-6;

/// Where `residual` vanishes to `tolerance`, from `start`, by Newton's method; `steps` are those of the differences. Where
/// it stagnates, the best place; and the largest component of what is left.
///
/// # Errors
/// The first of `residual` at the start or in a difference.
pub(crate) fn newton<const N: usize, E>(
    start: SVector<f64, N>,
    steps: SVector<f64, N>,
    tolerance: f64,
    mut residual: impl FnMut(&SVector<f64, N>) -> Result<SVector<f64, N>, E>,
) -> Result<(SVector<f64, N>, f64), E> {
    let limits = NewtonLimits { tolerance, max_steps: 60, max_halvings: 12, least_decrease: 0.1 };
    let found = numerics::newton(start, &steps, limits, |at| Ok(((), residual(at)?)))?;
    let left = found.largest();
    Ok((found.at, left))
}

/// Steps in which a radial load grows where Newton's method stagnates at once.
const CONTINUATION: u32 = 16;

/// Load on a ball beside those of its races.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct BallForces {
    /// Centrifugal force (N).
    pub(crate) centrifugal: f64,
    /// Friction across in the inner and the outer contact (N), positive where it carries the gyroscopic moment.
    pub(crate) across: [f64; 2],
}

/// Equilibrium of one ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BallEquilibrium {
    /// Contact angles (rad).
    pub(crate) angles: [f64; 2],
    /// Loads (N); zero at the inner race where the ball does not reach it.
    pub(crate) loads: [f64; 2],
    /// The ball's centre from the outer groove's, along the axis and out (m).
    centre: [f64; 2],
}

/// The displacement of the inner ring along the axis and towards azimuth zero (m).
pub(crate) type Displacement = [f64; 2];

impl BallBearing {
    /// Distance of the grooves' centres (m), on balls without load.
    fn groove_distance(&self) -> f64 {
        (self.osculation[INNER] + self.osculation[OUTER] - 1.0) * self.ball_diameter
    }

    /// Place of the inner groove's centre from the outer one's, at a ball (m).
    fn grooves(&self, displacement: Displacement, azimuth: f64) -> [f64; 2] {
        let (sin, cos) = self.contact_angle.sin_cos();
        let apart = self.groove_distance();
        [apart * sin + displacement[0], apart * cos + displacement[1] * azimuth.cos()]
    }

    /// Load (N) of a race whose ball is pressed by `depth` (m), zero where it is not.
    fn load_at(&self, race: usize, angle: f64, depth: f64) -> Result<f64, BearingError> {
        if depth <= 0.0 {
            return Ok(0.0);
        }
        let constant = self.pressed(race, angle, 1.0)?.approach_constant();
        Ok((depth / constant).powf(1.5))
    }

    /// A ball between its grooves.
    pub(crate) fn ball_equilibrium(
        &self,
        displacement: Displacement,
        azimuth: f64,
        acting: &BallForces,
    ) -> Result<BallEquilibrium, BearingError> {
        let grooves = self.grooves(displacement, azimuth);
        let free = [INNER, OUTER].map(|race| (self.osculation[race] - 0.5) * self.ball_diameter);
        if let Some(alone) = self.on_outer_race(grooves, free, acting)? {
            return Ok(alone);
        }
        let ball = |centre: [f64; 2]| {
            let to_inner = [grooves[0] - centre[0], grooves[1] - centre[1]];
            let lengths = [to_inner[0].hypot(to_inner[1]), centre[0].hypot(centre[1])];
            let angles = [to_inner[0].atan2(to_inner[1]), centre[0].atan2(centre[1])];
            let load = |race: usize| self.load_at(race, angles[race], lengths[race] - free[race]);
            Ok::<_, BearingError>(BallEquilibrium {
                angles,
                loads: [load(INNER)?, load(OUTER)?],
                centre,
            })
        };
        let start = SVector::from(self.least_energy(grooves, free, acting)?);
        let pressed = ball([start[0], start[1]])?;
        let unit = pressed.loads[INNER].max(pressed.loads[OUTER]).max(acting.centrifugal).max(1e-9);
        let [inner, outer] = acting.across;
        // Small beside the depth to which a load of this size presses.
        let depth = self.pressed(OUTER, angles_of(&pressed), 1.0)?.approach_constant()
            * (unit * unit).cbrt();
        let steps = SVector::from([1e-5 * depth; 2]);
        let (found, left) = newton(start, steps, TOLERANCE, |centre| {
            let BallEquilibrium { angles, loads, .. } = ball([centre[0], centre[1]])?;
            let [(si, ci), (so, co)] = angles.map(f64::sin_cos);
            let [qi, qo] = loads;
            Ok::<_, BearingError>(SVector::from([
                (qi * si - qo * so + inner * ci - outer * co) / unit,
                (qi * ci - qo * co + acting.centrifugal - inner * si + outer * so) / unit,
            ]))
        })?;
        if left > ACCEPTED {
            return Err(BearingError::LoadNotFound);
        }
        ball([found[0], found[1]])
    }

    /// Where a ball's potential energy is least: that of two contacts of constant stiffness, less the work of the
    /// centrifugal force. It is convex, so that Newton's method with a line search on it always ends.
    fn least_energy(
        &self,
        grooves: [f64; 2],
        free: [f64; 2],
        acting: &BallForces,
    ) -> Result<[f64; 2], BearingError> {
        const MAX_NEWTON_STEPS: usize = 100;
        let constants = [
            self.pressed(INNER, self.contact_angle, 1.0)?.approach_constant(),
            self.pressed(OUTER, self.contact_angle, 1.0)?.approach_constant(),
        ];
        // Energy, gradient and Hessian: loads along both normals, stiffness along and across them.
        let at = |centre: &SVector<f64, 2>| {
            let mut energy = -acting.centrifugal * centre[1];
            let mut gradient = SVector::from([0.0, -acting.centrifugal]);
            let mut hessian = SMatrix::<f64, 2, 2>::zeros();
            let to_inner = SVector::from(grooves) - centre;
            for (race, arm, sense) in [(INNER, to_inner, -1.0), (OUTER, *centre, 1.0)] {
                let length = arm.norm();
                let (depth, unit) = ((length - free[race]).max(0.0), arm / length);
                let load = (depth / constants[race]).powf(1.5);
                energy += 0.4 * load * depth;
                gradient += unit * (sense * load);
                let along = unit * unit.transpose();
                let stiffness = if depth > 0.0 { 1.5 * load / depth } else { 0.0 };
                hessian += along * stiffness + (SMatrix::identity() - along) * (load / length);
            }
            (energy, gradient, hessian)
        };
        let whole = SVector::from(grooves);
        let pressed = constants[OUTER] * (acting.centrifugal * acting.centrifugal).cbrt();
        let mut centre = whole * ((free[OUTER] + pressed.max(1e-7)) / whole.norm());
        let (mut energy, mut gradient, mut hessian) = at(&centre);
        for _ in 0..MAX_NEWTON_STEPS {
            // A little stiffness where nothing is pressed.
            let size = hessian.norm().max(1.0);
            let stiff = hessian + SMatrix::identity() * (1e-9 * size);
            let Some(inverse) = stiff.try_inverse() else { break };
            let mut step = -(inverse * gradient);
            let longest = 0.1 * free[OUTER];
            if step.norm() > longest {
                step *= longest / step.norm();
            }
            let mut taken = false;
            for _ in 0..40 {
                let next = at(&(centre + step));
                if next.0 < energy + 1e-4 * gradient.dot(&step) {
                    centre += step;
                    (energy, gradient, hessian) = next;
                    taken = true;
                    break;
                }
                step *= 0.5;
            }
            if !taken {
                break;
            }
        }
        Ok([centre[0], centre[1]])
    }

    /// A ball that its centrifugal force alone presses into the outer groove's bottom, where it does not reach the
    /// inner race.
    fn on_outer_race(
        &self,
        grooves: [f64; 2],
        free: [f64; 2],
        acting: &BallForces,
    ) -> Result<Option<BallEquilibrium>, BearingError> {
        let force = acting.centrifugal;
        let constant = self.pressed(OUTER, 0.0, 1.0)?.approach_constant();
        let centre = [0.0, free[OUTER] + constant * (force * force).cbrt()];
        let to_inner = [grooves[0] - centre[0], grooves[1] - centre[1]];
        let reaches = to_inner[0].hypot(to_inner[1]) > free[INNER]
            || grooves[0].hypot(grooves[1]) > free[INNER] + free[OUTER];
        let angles = [self.contact_angle, 0.0];
        Ok((!reaches).then_some(BallEquilibrium { angles, loads: [0.0, force], centre }))
    }

    /// The displacement that carries the load, and every ball there.
    pub(crate) fn carry(
        &self,
        load: BearingLoad,
        acting: &[BallForces],
        before: Option<Displacement>,
    ) -> Result<(Displacement, Vec<BallEquilibrium>), BearingError> {
        let balls = |displacement: Displacement| -> Result<Vec<BallEquilibrium>, BearingError> {
            let each = acting.iter().enumerate();
            each.map(|(k, acting)| self.ball_equilibrium(displacement, self.azimuth(k), acting))
                .collect()
        };
        let start = match before {
            Some(displacement) => displacement,
            None => self.first_displacement(load)?,
        };
        let step = 1e-9_f64.max(1e-6 * self.groove_distance());
        let displacement = match load {
            BearingLoad::Rings { axial, radial } if radial.abs() > 0.0 => {
                let unit = size(load);
                let under = |start: Displacement, radial: f64| {
                    let steps = SVector::from([step; 2]);
                    newton(SVector::from(start), steps, TOLERANCE, |at| {
                        let carried = self.carried(&balls([at[0], at[1]])?, acting);
                        Ok::<_, BearingError>(SVector::from([
                            (carried[0] - axial) / unit,
                            (carried[1] - radial) / unit,
                        ]))
                    })
                };
                let (mut found, mut left) = under(start, radial)?;
                if left > ACCEPTED && axial.abs() > 0.0 {
                    // Continuation from the axial load alone, under which all balls carry alike.
                    let alone =
                        self.first_displacement(BearingLoad::Rings { axial, radial: 0.0 })?;
                    found = SVector::from(alone);
                    for part in 0..=CONTINUATION {
                        let share = f64::from(part) / f64::from(CONTINUATION);
                        (found, left) = under([found[0], found[1]], share * radial)?;
                    }
                }
                found_to(left)?;
                [found[0], found[1]]
            }
            _ => {
                let (found, left) =
                    newton(SVector::from([start[0]]), SVector::from([step]), TOLERANCE, |at| {
                        let ball = self.ball_equilibrium([at[0], 0.0], 0.0, &acting[0])?;
                        let missed = match load {
                            BearingLoad::Ball(load) => ball.loads[INNER] / load - 1.0,
                            BearingLoad::Rings { axial, .. } => {
                                let one = self.carried(&[ball], &acting[..1])[0];
                                one * self.balls as f64 / axial - 1.0
                            }
                        };
                        Ok::<_, BearingError>(SVector::from([missed]))
                    })?;
                found_to(left)?;
                [found[0], 0.0]
            }
        };
        Ok((displacement, balls(displacement)?))
    }

    /// Azimuth of a ball (rad).
    pub(crate) fn azimuth(&self, ball: usize) -> f64 {
        std::f64::consts::TAU * ball as f64 / self.balls as f64
    }

    /// What balls carry of the inner ring's load, along the axis and radially (N).
    pub(crate) fn carried(&self, balls: &[BallEquilibrium], acting: &[BallForces]) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for (k, (ball, acting)) in balls.iter().zip(acting).enumerate() {
            let ((sin, cos), load) = (ball.angles[INNER].sin_cos(), ball.loads[INNER]);
            let across = if load > 0.0 { acting.across[INNER] } else { 0.0 };
            sum[0] += load * sin + across * cos;
            sum[1] += (load * cos - across * sin) * self.azimuth(k).cos();
        }
        sum
    }

    /// A displacement at which balls carry about the load.
    fn first_displacement(&self, load: BearingLoad) -> Result<Displacement, BearingError> {
        let steep = self.contact_angle.sin().max(0.15);
        let count = self.balls as f64;
        let constant = self.pressed(INNER, self.contact_angle, 1.0)?.approach_constant()
            + self.pressed(OUTER, self.contact_angle, 1.0)?.approach_constant();
        let depth = |load: f64| constant * (load * load).cbrt();
        let (axial, radial) = match load {
            BearingLoad::Rings { axial, radial } => (axial / (count * steep), radial),
            BearingLoad::Ball(load) => (load, 0.0),
        };
        let apart = self.groove_distance();
        let across = apart * self.contact_angle.cos();
        let along = ((apart + depth(axial.abs())).powi(2) - across * across).max(0.0).sqrt();
        // Stribeck: the most loaded ball carries some five times the mean.
        let most = 5.0 * radial.abs() / (count * self.contact_angle.cos());
        let sunk = depth(most) * radial.signum();
        Ok([along - apart * self.contact_angle.sin(), if radial.abs() > 0.0 { sunk } else { 0.0 }])
    }
}

/// Whether what is left of a load is rounding.
fn found_to(left: f64) -> Result<(), BearingError> {
    if left <= ACCEPTED { Ok(()) } else { Err(BearingError::LoadNotFound) }
}

fn angles_of(ball: &BallEquilibrium) -> f64 {
    ball.angles[OUTER]
}

/// The size of a load (N).
fn size(load: BearingLoad) -> f64 {
    match load {
        BearingLoad::Rings { axial, radial } => axial.hypot(radial),
        BearingLoad::Ball(load) => load,
    }
}
