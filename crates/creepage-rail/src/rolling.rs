//! Creepage and spin from the motion of two surfaces, (4.4) to (4.14) of the thesis.

/// Motion of a body's undeformed surface at the centre of the contact area, relative to that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceMotion {
    /// Velocity (m/s) along the contact axes `x` (rolling direction) and `y`.
    pub velocity: [f64; 2],
    /// Angular velocity about the contact's normal `z`, which points into the lower body (rad/s).
    pub turn: f64,
}

/// Creepage of the upper body relative to the lower, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingCreepage {
    /// Longitudinal creepage.
    pub longitudinal: f64,
    /// Lateral creepage.
    pub lateral: f64,
    /// Spin (rad/m).
    pub spin: f64,
    /// Rolling speed (m/s): the mean of the two surface speeds against `x`.
    pub speed: f64,
}

impl RollingCreepage {
    /// Creepage (4.11), spin (4.12) and rolling speed (4.9), its small angle with `x` left out.
    ///
    /// `None` unless the surfaces roll forward: a mean speed above zero.
    #[must_use]
    pub fn between(upper: SurfaceMotion, lower: SurfaceMotion) -> Option<Self> {
        let speed = -0.5 * (upper.velocity[0] + lower.velocity[0]);
        (speed > 0.0 && speed.is_finite()).then(|| Self {
            longitudinal: (upper.velocity[0] - lower.velocity[0]) / speed,
            lateral: (upper.velocity[1] - lower.velocity[1]) / speed,
            spin: (upper.turn - lower.turn) / speed,
            speed,
        })
    }
}

/// A body of revolution that rolls forward about its own axis.
///
/// ```
/// use creepage_rail::{Revolving, RollingCreepage};
///
/// // Two discs of one surface speed, the upper one yawed by 2 mrad and coned 1:20.
/// let upper = Revolving { radius: 0.46, rate: 4.0, yaw: 0.002, cone: 0.05 };
/// let lower = Revolving { radius: 0.23, rate: 8.0, yaw: 0.0, cone: 0.0 };
/// let creepage = RollingCreepage::between(upper.as_upper(), lower.as_lower()).unwrap();
/// assert!((creepage.lateral + 0.002).abs() < 1e-8);
/// assert!((creepage.spin + 0.05 / 0.46).abs() < 1e-4);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Revolving {
    /// Radius of the circle that rolls through the contact (m).
    pub radius: f64,
    /// Angular velocity about the axis (rad/s), positive when it rolls forward.
    pub rate: f64,
    /// Turn of the axis about the contact's `z` (rad): positive moves its `+y` end back.
    pub yaw: f64,
    /// Angle between the axis and the contact plane (rad): positive moves its `+y` end into the
    /// lower body.
    pub cone: f64,
}

impl Revolving {
    /// Motion of its surface when it is the upper body.
    #[must_use]
    pub fn as_upper(&self) -> SurfaceMotion {
        SurfaceMotion { velocity: self.velocity(), turn: -self.rate * self.cone.sin() }
    }

    /// Motion of its surface when it is the lower body.
    #[must_use]
    pub fn as_lower(&self) -> SurfaceMotion {
        SurfaceMotion { velocity: self.velocity(), turn: self.rate * self.cone.sin() }
    }

    fn velocity(&self) -> [f64; 2] {
        let speed = self.rate * self.radius;
        [-speed * self.yaw.cos(), -speed * self.yaw.sin()]
    }
}
