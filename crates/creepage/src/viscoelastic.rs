//! Viscoelastic cylinders in steady rolling: the pressure leans forward, and rolling costs energy.
//!
//! Both bodies are alike, with a shear compliance `J(t) = J_g (1 + f (1 - exp(-t/tau)))` and a constant Poisson's
//! ratio: glassy (stiff) when fast, `1 + f` times as soft when slow. With `D = V tau`, and the material running to `-x`, every
//! displacement obeys `(1 - D d/dx) u = (1 + f - D d/dx) u_e`, `u_e` that of a glassy body. The pressure then follows from
//!
//! ```math
//! h = (1+f)\, p - D\, p', \qquad
//! \mathrm{PV}\!\int_{-c}^{b} \frac{h(t)}{x - t}\, dt = \frac{x - D}{g_0 R}, \qquad g_0 = \frac{2 (1-\sigma)}{\pi G_g},
//! ```
//!
//! whose solution on a given area is a Chebyshev series of three terms over a root; that area follows from
//! no pressure behind and a smooth surface ahead. Friction that is less than `mu N` obeys Carter's
//! theorem with the leading half-length `b(N)` in place of the half-width:
//! `|creepage| = mu/R (b(N) - b(N - |F|/mu))`.
//!
//! Sources: S.C. Hunter, J. Appl. Mech. 28 (1961) 611-617; L.W. Morland, J. Appl. Mech. 29 (1962) 345-352;
//! the form with friction is derived here, and agrees with CONTACT's elements to their error.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::check::{self, InvalidValue};
use crate::numerics::gauss::HALF_OF_GAUSS_10;

/// Relaxation of a body: its compliance over time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relaxation {
    /// `f`: how much softer it is in the end, `G_g/G_r - 1`.
    pub ratio: f64,
    /// Retardation time `tau` of the compliance (s).
    pub time: f64,
}

/// Two like cylinders of a viscoelastic material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscoelasticCylinders {
    /// `pi g_0` (1/Pa).
    compliance: f64,
    ratio: f64,
    radius: f64,
    /// `D = V tau` (m).
    distance: f64,
}

/// Pressure between the cylinders under a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscoelasticPressure {
    cylinders: ViscoelasticCylinders,
    load: f64,
    middle: f64,
    half: f64,
    /// Of the Chebyshev series (Pa).
    series: [f64; 3],
}

/// Error of viscoelastic cylinders without a solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ViscoelasticError {
    /// A number out of its range.
    #[error(transparent)]
    Value(#[from] InvalidValue),
    /// The ends of the area were not found.
    #[error("the area of contact was not found: the equations are {residual:e} from zero")]
    NotFound {
        /// What was left of the equations.
        residual: f64,
    },
}

/// Ratios of the distance to the half-width between which the equations are solved; beyond, the limits differ from them
/// by less than a thousandth.
const RANGE: [f64; 2] = [1e-4, 1e5];

impl ViscoelasticCylinders {
    /// Cylinders of glassy shear modulus `G_g` (Pa) and Poisson's ratio, of combined radius `1/R = 1/R_1 + 1/R_2` (m),
    /// at the rolling velocity `speed` (m/s).
    ///
    /// # Errors
    /// [`InvalidValue`] unless all are finite and positive, Poisson's ratio is from 0 to 0.5 and the ratio not negative.
    pub fn new(
        glassy_shear_modulus: f64,
        poisson: f64,
        relaxation: Relaxation,
        radius: f64,
        speed: f64,
    ) -> Result<Self, InvalidValue> {
        check::positive("shear_modulus", glassy_shear_modulus)?;
        check::poisson(poisson)?;
        check::positive("radius", radius)?;
        check::positive("speed", speed)?;
        check::positive("relaxation time", relaxation.time)?;
        let Relaxation { ratio, time } = relaxation;
        let valid = "finite and not negative";
        check::require(ratio.is_finite() && ratio >= 0.0, "relaxation ratio", ratio, valid)?;
        let compliance = 2.0 * (1.0 - poisson) / glassy_shear_modulus;
        Ok(Self { compliance, ratio, radius, distance: speed * time })
    }

    /// Half the width of contact under a load per length (N/m), were the bodies elastic: `(glassy, rubbery)`.
    #[must_use]
    pub fn elastic_half_widths(&self, load: f64) -> [f64; 2] {
        let glassy = 2.0 * self.compliance * self.radius * load / PI;
        [glassy, (1.0 + self.ratio) * glassy].map(f64::sqrt)
    }

    /// The distance rolled in the retardation time, `V tau` (m).
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// The pressure under a load per length (N/m).
    ///
    /// ```
    /// use creepage::viscoelastic::{Relaxation, ViscoelasticCylinders};
    /// // Polymer cylinders, 600 N/mm; D = 9 mm.
    /// let soft = Relaxation { ratio: 1.0, time: 9e-3 };
    /// let cylinders = ViscoelasticCylinders::new(1143e6, 0.4, soft, 50e-3, 1.0)?;
    /// let pressure = cylinders.pressed(600e3)?;
    /// let [peak, x] = pressure.largest();
    /// assert!((peak / 78.73363e6 - 1.0).abs() < 1e-6 && (x / 2.02498e-3 - 1.0).abs() < 1e-3);
    /// assert!((pressure.rolling_resistance() - 600e3 * 1.222176e-3 / 50e-3).abs() < 0.1); // N/m
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ViscoelasticError`] for a load that is not positive, and where the distance is so far from the half-width
    /// (below 1e-4 or above 1e5 times) that the elastic limits are meant.
    pub fn pressed(&self, load: f64) -> Result<ViscoelasticPressure, ViscoelasticError> {
        check::positive("load", load)?;
        let [glassy, rubbery] = self.elastic_half_widths(load);
        let relative = self.distance / rubbery;
        let valid = "from 1e-4 to 1e5: beyond, the bodies are elastic, rubbery or glassy";
        let inside = (RANGE[0]..=RANGE[1]).contains(&relative);
        check::require(inside, "V tau over the half-width", relative, valid)?;
        // From the softer and the stiffer end towards the middle, in the logarithm of the distance.
        let weight = 1.0 / (1.0 + relative);
        let half = glassy + weight * (rubbery - glassy);
        let lean = self.ratio * self.distance / (1.0 + self.ratio + relative * relative);
        let mut at = [0.5 * lean.min(0.3 * half), half];
        let mut residual = self.residual(load, at);
        for _ in 0..MAX_NEWTON_STEPS {
            let size = residual[0].hypot(residual[1]);
            if size < EXACT {
                break;
            }
            let step = self.newton(load, at, residual, half);
            let mut part = 1.0;
            loop {
                let next = [at[0] + part * step[0], at[1] + part * step[1]];
                let found = if next[1] > 0.0 { self.residual(load, next) } else { [f64::NAN; 2] };
                if found[0].hypot(found[1]) < size {
                    (at, residual) = (next, found);
                    break;
                }
                part *= 0.5;
                if part < 1e-6 {
                    break;
                }
            }
            if part < 1e-6 {
                break;
            }
        }
        let left = residual[0].hypot(residual[1]);
        if left.is_nan() || left > RESIDUAL_TOLERANCE {
            return Err(ViscoelasticError::NotFound { residual: left });
        }
        Ok(self.pressure(load, at))
    }

    fn pressure(&self, load: f64, [middle, half]: [f64; 2]) -> ViscoelasticPressure {
        let by = 1.0 / (self.compliance * self.radius);
        let series = [
            (1.0 + self.ratio) * load / (PI * half),
            -(middle - self.distance) * by,
            -0.5 * half * by,
        ];
        ViscoelasticPressure { cylinders: *self, load, middle, half, series }
    }

    /// The pressure at the trailing edge, and how far the surface ahead is from smooth, both without dimension.
    fn residual(&self, load: f64, at: [f64; 2]) -> [f64; 2] {
        let pressure = self.pressure(load, at);
        let behind = pressure.at_angle(PI) / pressure.series[0];
        let [c0, c1, c2] = pressure.series;
        let length = at[1] / self.distance;
        let slope = |t: f64| {
            let away = (-t).exp();
            // cosh t - 1 without cancellation.
            let sinh = (0.5 * t).sinh();
            (-2.0 * length * sinh * sinh).exp() * (c0 + away * (c1 + away * c2))
        };
        // The integrand falls as exp(-length t^2/2), and where the length is small as exp(-length exp(t)/2).
        let reach =
            if length > 1.0 { 9.0 / length.sqrt() } else { 2.0 * (80.0 / length).ln().max(1.0) };
        let ahead = self.compliance * length * integral(slope, [0.0, reach], PANELS);
        let leading = (at[0] + at[1]) / self.radius;
        [behind, ahead * self.radius / at[1] - leading * self.radius / at[1]]
    }

    /// Newton's step with differences.
    fn newton(&self, load: f64, at: [f64; 2], residual: [f64; 2], size: f64) -> [f64; 2] {
        let by = 1e-6 * size;
        let column = |k: usize| {
            let moved = |sign: f64| {
                let mut next = at;
                next[k] += sign * by;
                self.residual(load, next)
            };
            let (more, less) = (moved(1.0), moved(-1.0));
            [0, 1].map(|i: usize| 0.5 * (more[i] - less[i]) / by)
        };
        let ([a, c], [b, d]) = (column(0), column(1));
        let determinant = a * d - b * c;
        [
            -(d * residual[0] - b * residual[1]) / determinant,
            -(a * residual[1] - c * residual[0]) / determinant,
        ]
    }

    /// Where the area of contact ends ahead under a load (m), also where the bodies are all but elastic.
    fn leading_edge(&self, load: f64) -> Result<f64, ViscoelasticError> {
        let [glassy, rubbery] = self.elastic_half_widths(load);
        match self.distance / rubbery {
            relative if relative > RANGE[1] => Ok(glassy),
            relative if relative < RANGE[0] => Ok(rubbery),
            _ => Ok(self.pressed(load)?.ends()[1]),
        }
    }

    /// The creepage at which a tangential force per length (N/m), less than `friction` times the load, rolls them:
    /// of the force's sign.
    ///
    /// # Errors
    /// As [`ViscoelasticCylinders::rolling_under`].
    pub fn creepage(&self, load: f64, friction: f64, force: f64) -> Result<f64, ViscoelasticError> {
        Ok(self.rolling_under(load, friction, force)?.creepage)
    }

    /// Steady rolling under a load and a tangential force on the lower cylinder (N/m).
    ///
    /// ```
    /// use creepage::viscoelastic::{Relaxation, ViscoelasticCylinders};
    /// let soft = Relaxation { ratio: 1.0, time: 9e-3 };
    /// let cylinders = ViscoelasticCylinders::new(1143e6, 0.4, soft, 50e-3, 1.0)?;
    /// let rolling = cylinders.rolling_under(600e3, 0.3, 108e3)?;
    /// let again = cylinders.rolling_at(600e3, 0.3, rolling.creepage())?;
    /// assert!((again.force() / 108e3 - 1.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`ViscoelasticCylinders::pressed`], and for a force that friction does not bear.
    pub fn rolling_under(
        &self,
        load: f64,
        friction: f64,
        force: f64,
    ) -> Result<ViscoelasticRolling, ViscoelasticError> {
        check::positive("friction", friction)?;
        check::finite("force", force)?;
        let left = load - force.abs() / friction;
        check::require(left > 0.0, "force", force, "less than friction times the load")?;
        let ahead = self.leading_edge(load)? - self.leading_edge(left)?;
        self.rolling(load, friction, left, (ahead, force.signum()))
    }

    /// Steady rolling under a load (N/m) at a creepage of the upper cylinder against the lower.
    ///
    /// # Errors
    /// As [`ViscoelasticCylinders::pressed`], and for a creepage that is not finite.
    pub fn rolling_at(
        &self,
        load: f64,
        friction: f64,
        creepage: f64,
    ) -> Result<ViscoelasticRolling, ViscoelasticError> {
        check::positive("friction", friction)?;
        check::finite("creepage", creepage)?;
        let whole = self.leading_edge(load)?;
        let ahead = creepage.abs() * self.radius / friction;
        let wanted = whole - ahead;
        let mut left = 0.0;
        if wanted > 0.0 {
            // The load whose area ends there: the edge grows with it.
            let [mut low, mut high] = [0.0, load];
            while high - low > 1e-13 * load {
                let middle = 0.5 * (low + high);
                *(if self.leading_edge(middle)? > wanted { &mut high } else { &mut low }) = middle;
            }
            left = 0.5 * (low + high);
        }
        let mut found = self.rolling(load, friction, left, (ahead, creepage.signum()))?;
        found.creepage = creepage;
        Ok(found)
    }

    /// Carter's theorem: what slides under the whole load, less what slides under `left` of it, moved ahead so that both
    /// areas end at one place.
    fn rolling(
        &self,
        load: f64,
        friction: f64,
        left: f64,
        (ahead, sense): (f64, f64),
    ) -> Result<ViscoelasticRolling, ViscoelasticError> {
        let pressure = self.pressed(load)?;
        // So small an area that its bodies are elastic has no part in the traction.
        let is_there = left > 0.0 && self.distance <= RANGE[1] * self.elastic_half_widths(left)[1];
        let adhering = if is_there { Some((self.pressed(left)?, ahead)) } else { None };
        let force = sense * friction * (load - left);
        let creepage = sense * friction / self.radius * ahead;
        Ok(ViscoelasticRolling { pressure, adhering, friction, force, creepage })
    }
}

/// Viscoelastic cylinders in steady rolling, with friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscoelasticRolling {
    pressure: ViscoelasticPressure,
    /// The pressure that counts where surfaces adhere, and how far it is moved ahead (m); none in full sliding.
    adhering: Option<(ViscoelasticPressure, f64)>,
    friction: f64,
    force: f64,
    creepage: f64,
}

impl ViscoelasticRolling {
    /// The pressure.
    #[must_use]
    pub fn pressure(&self) -> &ViscoelasticPressure {
        &self.pressure
    }

    /// The tangential force per length on the lower cylinder (N/m).
    #[must_use]
    pub fn force(&self) -> f64 {
        self.force
    }

    /// The creepage of the upper cylinder against the lower.
    #[must_use]
    pub fn creepage(&self) -> f64 {
        self.creepage
    }

    /// The traction on the lower cylinder at a place (Pa).
    #[must_use]
    pub fn traction(&self, x: f64) -> f64 {
        let less = self.adhering.map_or(0.0, |(pressure, ahead)| pressure.at(x - ahead));
        let sense = if self.creepage < 0.0 { -1.0 } else { 1.0 };
        sense * self.friction * (self.pressure.at(x) - less)
    }

    /// Where the area of adhesion begins (m), which borders on the leading edge; `None` in full sliding.
    #[must_use]
    pub fn adhesion_edge(&self) -> Option<f64> {
        self.adhering.map(|(pressure, ahead)| pressure.ends()[0] + ahead)
    }
}

impl ViscoelasticPressure {
    /// Trailing and leading edge (m).
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        [self.middle - self.half, self.middle + self.half]
    }

    /// The load per length (N/m).
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Pressure at a place (Pa), zero outside.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        let s = (x - self.middle) / self.half;
        if s.abs() >= 1.0 { 0.0 } else { self.at_angle(s.acos()).max(0.0) }
    }

    /// The pressure at `middle + half cos(angle)`: what runs in from the leading edge, and relaxes.
    fn at_angle(&self, angle: f64) -> f64 {
        let [c0, c1, c2] = self.series;
        let rate = (1.0 + self.cylinders.ratio) * self.half / self.cylinders.distance;
        let run = |back: f64| {
            let theta = angle - back;
            // cos(theta) - cos(angle) without cancellation.
            let ahead = 2.0 * (0.5 * back).sin() * (angle - 0.5 * back).sin();
            (c0 + c1 * theta.cos() + c2 * (2.0 * theta).cos()) * (-rate * ahead).exp()
        };
        self.half / self.cylinders.distance * graded(run, angle, rate)
    }

    /// The largest pressure (Pa) and its place (m).
    #[must_use]
    pub fn largest(&self) -> [f64; 2] {
        const SAMPLES: u16 = 64;
        let angle = |k: u16| PI * f64::from(k) / f64::from(SAMPLES);
        let highest = (1..SAMPLES)
            .max_by(|i, j| self.at_angle(angle(*i)).total_cmp(&self.at_angle(angle(*j))))
            .unwrap_or(SAMPLES / 2);
        let [mut low, mut high] = [angle(highest - 1), angle(highest + 1)];
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        for _ in 0..50 {
            let [one, other] = [high - golden * (high - low), low + golden * (high - low)];
            if self.at_angle(one) > self.at_angle(other) { high = other } else { low = one }
        }
        let top = 0.5 * (low + high);
        [self.at_angle(top), self.middle + self.half * top.cos()]
    }

    /// How far the centre of pressure lies ahead (m).
    #[must_use]
    pub fn centre(&self) -> f64 {
        let ViscoelasticCylinders { ratio, distance, .. } = self.cylinders;
        let [c0, c1, _] = self.series;
        let by_x = PI * self.half * (c0 * self.middle + 0.5 * c1 * self.half);
        (by_x / self.load - distance) / (1.0 + ratio)
    }

    /// The force per length (N/m) against which they roll, also the energy lost per metre rolled and length (J/m2).
    #[must_use]
    pub fn rolling_resistance(&self) -> f64 {
        self.load * self.centre() / self.cylinders.radius
    }
}

const MAX_NEWTON_STEPS: usize = 60;
/// Residuals that are zero but for rounding, and that are small enough.
const EXACT: f64 = 1e-13;
const RESIDUAL_TOLERANCE: f64 = 1e-8;
const PANELS: u16 = 24;

/// An integral over equal panels.
fn integral(of: impl Fn(f64) -> f64, [from, to]: [f64; 2], panels: u16) -> f64 {
    let width = (to - from) / f64::from(panels);
    let panel = |k: u16| {
        let middle = from + width * (f64::from(k) + 0.5);
        HALF_OF_GAUSS_10
            .iter()
            .map(|(at, weight)| {
                let away = 0.5 * width * at;
                0.5 * width * weight * (of(middle - away) + of(middle + away))
            })
            .sum::<f64>()
    };
    (0..panels).map(panel).sum()
}

/// An integral back from a place at which a function falls at this rate, or as the square root of it at an edge: panels
/// that double from there.
fn graded(of: impl Fn(f64) -> f64, length: f64, rate: f64) -> f64 {
    let (mut from, mut sum) = (0.0, 0.0);
    let mut width = (1.0 / rate.max(1.0)).min(FRAC_PI_2 * 0.25);
    while from < length {
        let to = (from + width).min(length);
        sum += integral(&of, [from, to], 2);
        (from, width) = (to, (1.6 * width).min(0.4));
    }
    sum
}
