//! Data of a ball bearing (geometry, materials, friction) and its operating point (load and speed).

use std::f64::consts::PI;

use creepage::{Hertz, HertzError, InvalidValue, Radii, Solid, SolidPair};

use crate::error::BearingError;

/// A single-row ball bearing: deep groove or angular contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallBearing {
    /// Diameter of a ball (m).
    pub ball_diameter: f64,
    /// Diameter of the circle of the balls' centres (m).
    pub pitch_diameter: f64,
    /// Number of balls.
    pub balls: usize,
    /// Contact angle without load (rad).
    pub contact_angle: f64,
    /// Radius of the inner and of the outer groove over the ball's diameter, above one half.
    pub osculation: [f64; 2],
    /// The balls' material, and their density (kg/m3).
    pub ball: Solid,
    /// Density of the balls (kg/m3).
    pub density: f64,
    /// Materials of the inner and of the outer ring.
    pub rings: [Solid; 2],
    /// Coefficient of friction in both contacts.
    pub friction: f64,
}

/// Operating point of a bearing: load and speeds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Operation {
    /// What holds it.
    pub load: BearingLoad,
    /// Angular velocities of the inner and of the outer ring (rad/s), about the same axis.
    pub speed: [f64; 2],
    /// How a ball's axis is found.
    pub control: Control,
}

/// Load of the inner ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BearingLoad {
    /// Forces on the inner ring (N): along the axis, and radial, towards the ball at azimuth zero.
    Rings {
        /// Along the axis, positive where it closes the contacts.
        axial: f64,
        /// Radial.
        radial: f64,
    },
    /// The load of every ball on the inner race (N), by an axial force that is found.
    Ball(f64),
}

/// Kinematic hypothesis that gives the axis of a ball's rotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Control {
    /// By the balance of all moments of friction on the ball: both races spin.
    #[default]
    Balance,
    /// The inner race does not spin (Jones); half of the gyroscopic moment on either race.
    Inner,
    /// The outer race does not spin.
    Outer,
}

/// The two races.
pub(crate) const RACES: [&str; 2] = ["inner", "outer"];
pub(crate) const INNER: usize = 0;
pub(crate) const OUTER: usize = 1;

impl BallBearing {
    /// Checks every number.
    ///
    /// # Errors
    /// [`InvalidValue`] that names the first that is out of range.
    pub fn checked(&self) -> Result<(), InvalidValue> {
        let positive = "positive and finite";
        let check = |quantity, value: f64, is_valid: bool, valid| {
            if is_valid { Ok(()) } else { Err(InvalidValue { quantity, value, valid }) }
        };
        let is_positive = |value: f64| value > 0.0 && value.is_finite();
        // A number above it is in another unit.
        let (ball, valid) = (self.ball_diameter, "positive, at most 1 m");
        check("ball diameter", ball, ball > 0.0 && ball <= 1.0, valid)?;
        let density = self.density;
        check("density", density, density >= 10.0 && density.is_finite(), "at least 10 kg/m3")?;
        check("friction", self.friction, is_positive(self.friction), positive)?;
        let pitch = self.pitch_diameter;
        let valid = "above the ball's diameter, at most 20 m";
        check("pitch diameter", pitch, pitch > self.ball_diameter && pitch <= 20.0, valid)?;
        let (count, room) = (self.balls as f64, PI / (self.ball_diameter / pitch).asin());
        check(
            "balls",
            count,
            count >= 1.0 && count <= room,
            "1 to as many as the pitch circle has room for",
        )?;
        let angle = self.contact_angle;
        check("contact angle", angle, (0.0..1.5).contains(&angle), "0 to 1.5 rad")?;
        for value in self.osculation {
            check("osculation", value, value > 0.5 && value < 1.0, "above 0.5 and below 1")?;
        }
        Ok(())
    }

    /// Mass of a ball (kg).
    #[must_use]
    pub fn ball_mass(&self) -> f64 {
        self.density * PI / 6.0 * self.ball_diameter.powi(3)
    }

    /// Its moment of inertia (kg m2).
    #[must_use]
    pub fn ball_inertia(&self) -> f64 {
        0.1 * self.ball_mass() * self.ball_diameter.powi(2)
    }

    /// Distance of a contact from the bearing's axis (m), at its contact angle.
    pub(crate) fn contact_radius(&self, race: usize, angle: f64) -> f64 {
        let out = if race == INNER { -0.5 } else { 0.5 };
        0.5 * self.pitch_diameter + out * self.ball_diameter * angle.cos()
    }

    /// Radii of a ring at a contact (m): along rolling, hollow at the outer race, and the hollow groove.
    fn ring_radii(&self, race: usize, angle: f64) -> Radii {
        let along = 0.5 * self.pitch_diameter / angle.cos();
        let half = 0.5 * self.ball_diameter;
        let rolling = if race == INNER { along - half } else { -(along + half) };
        Radii { rolling, lateral: -self.osculation[race] * self.ball_diameter }
    }

    /// Ball and ring pressed by a load (N) at a contact angle.
    ///
    /// # Errors
    /// [`BearingError::Hertz`].
    pub(crate) fn pressed(
        &self,
        race: usize,
        angle: f64,
        load: f64,
    ) -> Result<Hertz, BearingError> {
        let half = 0.5 * self.ball_diameter;
        let ball = Radii { rolling: half, lateral: half };
        let pair = SolidPair::new(self.ball, self.rings[race]);
        let hertz = Hertz::new(pair, ball, self.ring_radii(race, angle), 0.0, load);
        hertz.map_err(|source: HertzError| BearingError::Hertz { race: RACES[race], source })
    }

    /// Heathcote's creepage over the square of the place across (1/m2): the surface of contact is curved across with
    /// the radius `R_d = 2 r_g r_b/(r_g + r_b)`, and slip grows by `S_x y^2/(2 R_d)` from its middle, with the sum
    /// `S_x` of curvatures along rolling.
    pub(crate) fn heathcote(&self, race: usize, angle: f64) -> f64 {
        let sum = 2.0 / self.ball_diameter + self.ring_radii(race, angle).rolling.recip();
        0.5 * sum / self.conforming_radius(race)
    }

    /// Radius across of the surface of contact between ball and groove (m).
    #[must_use]
    pub fn conforming_radius(&self, race: usize) -> f64 {
        let (ball, groove) = (0.5 * self.ball_diameter, self.osculation[race] * self.ball_diameter);
        2.0 * groove * ball / (groove + ball)
    }
}
