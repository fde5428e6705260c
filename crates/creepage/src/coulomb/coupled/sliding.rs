//! Gross sliding of unlike bodies (6.1)-(6.3): the traction is `mu` times the pressure everywhere, in
//! one direction, and moves pressure and area.
//!
//! With `A Z` the integral of `Z/(pi R)` and `T Z` that of `Z (x' - x)/(pi R^2)`, both over the
//! area, in units of its frictionless radius `a`, of `p_0`, and of `(1 - sigma) p_0 a / G`, for
//! sliding in `+x` on a circle
//!
//! ```math
//! A Z - q \, T Z = \delta - \tfrac{\pi}{4} (x^2 + y^2), \qquad q = \frac{\kappa \mu}{1 - \sigma}
//! ```
//!
//! is to be solved with `Z > 0` on an unknown area. Proposition III of the thesis expands in `q`;
//! here are its terms. The circle is moved by `q d`, `Z = Z_0 + q Z_1 + q^2 Z_2` on it.
//!
//! **First order.** `A Z_1 = T Z_0 - (pi/2) d x`, where by Gauss's theorem
//! `T Z_0 = -(2/3) x [1 - (1 - r^2)^(3/2)]/r^2`. For a right-hand side `f(r) cos(m t)` Abel's
//! transform is `F(s) = s^(-m) d/ds int_0^s r^(m+1) f (s^2 - r^2)^(-1/2) dr`, and `Z` behaves
//! as `F(1)/pi (1 - r^2)^(-1/2)` at the edge, where it must not be infinite. Here `F = -(1 - s^2)
//! artanh s - s (1 + pi d)`... which is finite for
//!
//! ```math
//! d = -\frac{1}{\pi}, \qquad F(s) = -(1 - s^2) \operatorname{artanh} s .
//! ```
//!
//! **Second order.** `A Z_2 = T Z_1 + delta_2 - (pi/4) d^2` at constant load, which is the integral
//! of the right-hand side with `(1 - r^2)^(-1/2)`; with
//! `I = int_0^1 (1 - s^2) artanh^2 s ds = pi^2/18 - 1/3`
//!
//! ```math
//! \delta_2 = \frac{1}{\pi} \left( \frac14 + I \right), \qquad
//! r(t) = 1 + q^2 \rho (1 + \cos 2t), \qquad \rho = \frac{1}{\pi^2} \left( I + \frac12 \right):
//! ```
//!
//! the edge moves by the same amount with `m = 0` and `m = 2`, so that the area becomes longer in the
//! direction of sliding and, to this order, not wider.

use std::f64::consts::PI;

use super::Prescribed;
use super::normal::{Normal, PressedArea};
use super::normal_tangential_coupling::NormalInfluence;
use super::shape::Shape;
use crate::check::{self, InvalidValue};
use crate::coulomb::extrapolation::extrapolate;
use crate::coulomb::mesh::{Mesh, StripGrading};
use crate::coulomb::pressure::Pressure;
use crate::coulomb::resolution::Resolution;
use crate::ellipse::Ellipse;
use crate::numerics::anderson::AndersonAcceleration;

/// Error of gross sliding without a solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SlidingError {
    /// A number is outside its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// Pressure and area were still changing after the last turn.
    #[error("pressure and area do not converge: the last iteration changed them by {change:e}")]
    NotSettled {
        /// The last change, over `c` and the peak pressure.
        change: f64,
    },
}

/// Unlike bodies that slide over each other under a constant load.
///
/// Lengths are in units of `c` of the frictionless contact ellipse, pressures in units of its peak
/// pressure; `x` and `y` are the directions of its axes `a` and `b`.
///
/// ```
/// use creepage::Ellipse;
/// use creepage::coulomb::GrossSliding;
/// let sliding = GrossSliding::new(Ellipse::from_ratio(1.0)?, 0.1, 0.0)?;
/// let [shift, _] = sliding.shift();
/// // First order in q; what lacks is of third order.
/// assert!((shift / (0.1 * GrossSliding::SHIFT) - 1.0).abs() < 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct GrossSliding {
    coarse: Slid,
    fine: Slid,
}

/// One mesh.
#[derive(Debug, Clone)]
struct Slid {
    shape: Shape,
    pressed: PressedArea,
    frictionless: PressedArea,
}

impl GrossSliding {
    /// On a circle, shift of the area's middle along the sliding direction (that of the traction on the
    /// lower body) over `q a`: `-1/pi`.
    pub const SHIFT: f64 = -1.0 / PI;
    /// On a circle, growth of the semi-axis along the sliding direction over `q^2 a`:
    /// `1/9 + 1/(3 pi^2)`. That across does not grow.
    pub const LENGTHENING: f64 = 1.0 / 9.0 + 1.0 / (3.0 * PI * PI);
    /// On a circle, growth of the approach over `q^2` times the approach: `1/9 - 1/(6 pi^2)`.
    pub const DEEPENING: f64 = 1.0 / 9.0 - 1.0 / (6.0 * PI * PI);

    /// The contact whose frictionless ellipse is similar to `ellipse`, for
    /// `q = kappa mu/(1 - sigma)` and the angle (rad) from `x` to the traction on the lower body.
    ///
    /// # Errors
    /// [`SlidingError`] unless `|q| <= 0.5` (what real solids and `mu` up to 1 can have), `a/b` is
    /// between 1/20 and 20 and the angle finite, and when the iteration does not settle.
    pub fn new(ellipse: Ellipse, q: f64, angle: f64) -> Result<Self, SlidingError> {
        check::ratio(ellipse.ratio(), super::Coupled::RATIO_RANGE, "between 1/20 and 20")?;
        check::require(q.abs() <= 0.5, "q", q, "between -0.5 and 0.5")?;
        let (sin, cos) = check::finite("angle", angle)?.sin_cos();
        let ellipse = Ellipse::from_ratio(ellipse.ratio())?;
        let [along, across] = Resolution::FINE.coarse(ellipse.ratio());
        let q = [q * cos, q * sin];
        let mesh =
            |times| Mesh::with_sides(ellipse, times * along, times * across, StripGrading::NARROW);
        let [coarse, fine] = [1, 2].map(mesh);
        let coarse = Sliding::new(ellipse, &coarse)?.by_steps(q)?;
        let fine = Sliding::new(ellipse, &fine)?;
        let fine = fine.refined(&coarse, q).or_else(|_| fine.by_steps(q))?;
        Ok(Self { coarse, fine })
    }

    fn value(&self, of: impl Fn(&Slid) -> f64) -> f64 {
        extrapolate(of(&self.coarse), of(&self.fine))
    }

    /// The ends of the area along `x`, and along `y`.
    #[must_use]
    pub fn extents(&self) -> [[f64; 2]; 2] {
        let value = |i: usize, k: usize| self.value(|slid| slid.shape.extents()[i][k]);
        [[value(0, 0), value(0, 1)], [value(1, 0), value(1, 1)]]
    }

    /// Where the middle of the area has gone.
    #[must_use]
    pub fn shift(&self) -> [f64; 2] {
        self.extents().map(|[low, high]| f64::midpoint(low, high))
    }

    /// Half the lengths of the area along `x` and along `y`.
    #[must_use]
    pub fn semi_axes(&self) -> [f64; 2] {
        self.extents().map(|[low, high]| 0.5 * (high - low))
    }

    /// The area's edge: `count` points, from `+x` on towards `+y`, those of the frictionless ellipse at equal
    /// steps of its eccentric angle, moved.
    #[must_use]
    pub fn outline(&self, count: usize) -> Vec<[f64; 2]> {
        let angle = |k: usize| 2.0 * PI * k as f64 / count as f64;
        let place = |k: usize, i: usize| self.value(|slid| slid.shape.edge(angle(k))[i]);
        (0..count).map(|k| [place(k, 0), place(k, 1)]).collect()
    }

    /// Approach over that of the frictionless contact.
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.value(|slid| slid.pressed.approach / slid.frictionless.approach)
    }

    /// Area over that of the frictionless contact.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.value(|slid| slid.shape.area())
    }

    /// Largest pressure over that of the frictionless contact.
    #[must_use]
    pub fn peak(&self) -> f64 {
        self.value(|slid| slid.shape.peak())
    }

    /// Pressure at a position; zero outside the area.
    #[must_use]
    pub fn pressure(&self, at: [f64; 2]) -> f64 {
        self.fine.shape.place(at).map_or(0.0, |place| self.fine.shape.pressure(place))
    }
}

/// Largest change of a turn in a solution: ten times what the normal problem leaves in slender contacts.
const TOLERANCE: f64 = 2e-6;
/// The same on the way there.
const ROUGH: f64 = 1e-3;

/// One mesh, prepared.
struct Sliding<'a> {
    hertz: &'a Mesh,
    pressure: Pressure,
    normal: Normal,
}

impl<'a> Sliding<'a> {
    fn new(ellipse: Ellipse, hertz: &'a Mesh) -> Result<Self, SlidingError> {
        const STRIPS: usize = 32;
        let count = hertz.strips.len().min(STRIPS);
        let normal = Normal::new(ellipse, count);
        let normal = normal.ok_or(SlidingError::NotSettled { change: f64::NAN })?;
        Ok(Self { hertz, pressure: Pressure::hertz(ellipse, hertz), normal })
    }

    /// From the frictionless contact, by as many steps of `q` along and across as it takes.
    fn by_steps(&self, [along, across]: [f64; 2]) -> Result<Slid, SlidingError> {
        const LONGEST: f64 = 0.08;
        let steps = (along.hypot(across) / LONGEST).ceil().max(1.0);
        let mut pressed = self.normal.frictionless.clone();
        let mut step = 1.0;
        while step < steps {
            let q = [along, across].map(|q| q * step / steps);
            pressed = self.settle(pressed, q, ROUGH)?.pressed;
            step += 1.0;
        }
        self.settle(pressed, [along, across], TOLERANCE)
    }

    /// From another mesh.
    fn refined(&self, coarse: &Slid, q: [f64; 2]) -> Result<Slid, SlidingError> {
        let start = coarse.shape.start(&self.normal, &coarse.pressed, &coarse.frictionless);
        self.settle(start, q, TOLERANCE)
    }

    /// Pressure and area in turn until both hold.
    fn settle(
        &self,
        mut pressed: PressedArea,
        q: [f64; 2],
        tolerance: f64,
    ) -> Result<Slid, SlidingError> {
        const TURNS: usize = 60;
        let (mut change, mut mixing) = (f64::INFINITY, AndersonAcceleration::default());
        for _ in 0..TURNS {
            let shape = Shape::new(&self.normal, &pressed);
            let normal_influence = NormalInfluence::new(&shape.mesh(self.hertz));
            let bounds = shape.pressed(&self.pressure, 1.0).bounds;
            let tractions: Vec<_> = bounds.iter().map(|bound| q.map(|q| -q * bound / PI)).collect();
            let more = |at: [f64; 2]| normal_influence.by_traction(at, &tractions);
            let Some(next) = self.normal.solve(&pressed, more, Prescribed::Load) else { break };
            change = pressed.apart(&next);
            if change <= tolerance {
                let frictionless = self.normal.frictionless.clone();
                return Ok(Slid { shape, pressed, frictionless });
            }
            pressed.accelerate(&mut mixing, &next);
        }
        Err(SlidingError::NotSettled { change })
    }
}
