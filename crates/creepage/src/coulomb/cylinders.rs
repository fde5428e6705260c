//! Unlike cylinders with parallel axes: Carter's problem with `kappa`, coupled both ways.
//!
//! R. H. Bentall, K. L. Johnson, Slip in the rolling contact of two dissimilar elastic rollers,
//! Int. J. Mech. Sci. 9 (1967) 389-404. In units of the frictionless half-width `a` and peak pressure
//! `p_0`, tractions `mu p_0 t`, slip `mu a / rho`, creepage `xi = upsilon_x rho/(mu a)`, and with
//! the finite Hilbert transform `H`, slip and contact are
//!
//! ```math
//! s = \xi - 4 H[t] - 4 k Z, \quad H[Z] - q \, t = x, \qquad
//! H[f](x) = \frac{1}{\pi} \int \frac{f(x')}{x - x'} dx', \quad
//! k = \frac{\kappa}{\mu (1 - \sigma)}, \quad q = \frac{\kappa \mu}{1 - \sigma}.
//! ```
//!
//! The pressure is a sum of `(1 - s^2)^(1/2) U_k(s)`, `s` from end to end, whose transforms are
//! Chebyshev's `T_(k+1)`: the tractions on elements give its coefficients, the middle and the length of the
//! area in closed form. Friction and pressure are solved in turn.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{DMatrix, DVector};

use crate::check::{self, InvalidValue};
use crate::solid::SolidPair;
use crate::theory::Status;

/// Elements, closer towards the ends: angles of equal size.
const ELEMENTS: usize = 128;
/// Weight `r` of slip in the projection, as a fraction of the traction per slip of an element alone.
const WEIGHT: f64 = 0.3;

/// Unlike cylinders under a load, prepared for one coefficient of friction.
///
/// ```
/// use creepage::coulomb::Cylinders;
/// use creepage::{Solid, SolidPair};
/// // Bentall and Johnson: aluminium below steel rolls freely with creepage.
/// let (steel, aluminium) = (Solid::new(82e9, 0.28)?, Solid::new(23e9, 0.31)?);
/// let cylinders = Cylinders::new(SolidPair::new(steel, aluminium), 0.05)?;
/// let free = cylinders.find(0.0)?;
/// assert!(free.creepage() > 0.0 && free.force().abs() < 1e-8);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Cylinders {
    /// `k`.
    slip_by_pressure: f64,
    q: f64,
    /// Angles of the ends of the elements from the leading end, 0 to pi.
    angles: Vec<f64>,
}

/// Unlike cylinders solved at one creepage.
#[derive(Debug, Clone)]
pub struct CylindersSolved {
    creepage: f64,
    angles: Vec<f64>,
    state: State,
    /// Of the elements, in `mu a / rho`.
    slip: DVector<f64>,
    status: Status,
}

/// Area, pressure and tractions.
#[derive(Debug, Clone)]
struct State {
    middle: f64,
    half: f64,
    /// Of the pressure.
    coefficients: Vec<f64>,
    /// Tractions of the elements over their bounds, and these.
    used: DVector<f64>,
    bounds: Vec<f64>,
}

impl Cylinders {
    /// Prepares for a pair of bodies and the coefficient of friction; a large one keeps surfaces from slipping.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is between a millionth and 1000.
    pub fn new(pair: SolidPair, friction: f64) -> Result<Self, InvalidValue> {
        let valid = "between 1e-6 and 1000";
        check::require((1e-6..=1e3).contains(&friction), "friction", friction, valid)?;
        let kappa = pair.kappa() / (1.0 - pair.poisson());
        let angles = (0..=ELEMENTS).map(|i| PI * i as f64 / ELEMENTS as f64).collect();
        Ok(Self { slip_by_pressure: kappa / friction, q: kappa * friction, angles })
    }

    /// Solves at a creepage `xi = upsilon_x rho/(mu a)`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `creepage` is at most 1e9 in size.
    pub fn solve(&self, creepage: f64) -> Result<CylindersSolved, InvalidValue> {
        check::require(creepage.abs() <= 1e9, "creepage", creepage, "between -1e9 and 1e9")?;
        Ok(self.solve_from(State::frictionless(&self.angles), creepage))
    }

    fn solve_from(&self, mut state: State, creepage: f64) -> CylindersSolved {
        const TURNS: usize = 100;
        const TOLERANCE: f64 = 1e-10;
        let mut status = Status::NotConverged;
        for _ in 0..TURNS {
            let rubbed = self.solve_tangential(creepage, &mut state);
            let next = state.pressed(&self.angles, self.q);
            let change = state.apart(&next);
            state = next;
            if change <= TOLERANCE {
                status = if rubbed { Status::Solved } else { status };
                break;
            }
        }
        let (matrix, forcing) = self.slip(creepage, &state);
        let slip = matrix * &state.used + forcing;
        CylindersSolved { creepage, angles: self.angles.clone(), state, slip, status }
    }

    /// The creepage at which the force is `force` (in `mu N`), as zero in free rolling.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `force` is between -0.999 and 0.999.
    pub fn find(&self, force: f64) -> Result<CylindersSolved, InvalidValue> {
        const MAX_ROOT_STEPS: usize = 100;
        const FORCE_TOLERANCE: f64 = 1e-9;
        check::require(force.abs() <= 0.999, "force", force, "between -0.999 and 0.999")?;
        let wide = 8.0 + 8.0 * self.slip_by_pressure.abs();
        // Creepage and what the force has too much there.
        let [mut low, mut high] = [(-wide, -1.0 - force), (wide, 1.0 - force)];
        let mut solved = self.solve(0.0)?;
        for step in 0..MAX_ROOT_STEPS {
            let here = (solved.creepage, solved.force() - force);
            if here.1.abs() < FORCE_TOLERANCE {
                break;
            }
            *(if here.1 < 0.0 { &mut low } else { &mut high }) = here;
            let by_secant = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
            // A secant that keeps one end creeps.
            let halves = step % 3 == 2;
            let next = if halves { f64::midpoint(low.0, high.0) } else { by_secant };
            solved = self.solve_from(solved.state, next);
        }
        Ok(solved)
    }

    /// Tractions that obey friction at the present pressure; whether they do.
    fn solve_tangential(&self, creepage: f64, state: &mut State) -> bool {
        const MAX_NEWTON_STEPS: usize = 60;
        const TOLERANCE: f64 = 1e-11;
        let n = state.used.len();
        let (matrix, forcing) = self.slip(creepage, state);
        let weights: Vec<f64> = (0..n).map(|i| WEIGHT / matrix[(i, i)].abs()).collect();
        for step in 0..MAX_NEWTON_STEPS {
            let slip = &matrix * &state.used + &forcing;
            let trial: Vec<f64> = (0..n).map(|i| state.used[i] + weights[i] * slip[i]).collect();
            let adheres = |i: usize| trial[i].abs() <= 1.0;
            let residual = DVector::from_fn(n, |i, _| {
                if adheres(i) { -slip[i] } else { trial[i].signum() - state.used[i] }
            });
            let scaled = |i: usize| if adheres(i) { weights[i] * residual[i] } else { residual[i] };
            if (0..n).all(|i| scaled(i).abs() <= TOLERANCE) {
                return true;
            }
            let entry = |i: usize, k: usize| {
                if adheres(i) { matrix[(i, k)] } else { f64::from(u8::from(i == k)) }
            };
            let Some(change) = DMatrix::from_fn(n, n, entry).lu().solve(&residual) else {
                return false;
            };
            // Late steps are halved, for full ones may swing between two states.
            state.used += change * if step < MAX_NEWTON_STEPS / 2 { 1.0 } else { 0.5 };
        }
        false
    }

    /// Slip of the elements by used tractions, and without any: differences of displacements between
    /// centres, extrapolated downstream to each element's own.
    fn slip(&self, creepage: f64, state: &State) -> (DMatrix<f64>, DVector<f64>) {
        let n = state.used.len();
        let cuts: Vec<f64> = self.angles.iter().map(|angle| state.x(angle.cos())).collect();
        let mut points = vec![cuts[0]];
        points.extend(cuts.windows(2).map(|pair| f64::midpoint(pair[0], pair[1])));
        let primitive = |t: f64| if t == 0.0 { 0.0 } else { t * t.abs().ln() - t };
        // Of ln|x - x'| over an element.
        let potential = |at: f64, k: usize| primitive(at - cuts[k + 1]) - primitive(at - cuts[k]);
        let slopes = DMatrix::from_fn(n, n, |i, k| {
            let [ahead, behind] = [points[i], points[i + 1]];
            (potential(ahead, k) - potential(behind, k)) / (ahead - behind)
        });
        let middle = |i: usize| f64::midpoint(points[i], points[i + 1]);
        let matrix = DMatrix::from_fn(n, n, |i, k| {
            let scale = -4.0 / PI * state.bounds[k];
            let last = slopes[(i, k)];
            if i == 0 {
                return scale * last;
            }
            let by = (middle(i) - points[i + 1]) / (middle(i - 1) - middle(i));
            scale * (last + by * (last - slopes[(i - 1, k)]))
        });
        let forcing = DVector::from_fn(n, |i, _| {
            let at = if i == 0 { middle(0) } else { points[i + 1] };
            creepage - 4.0 * self.slip_by_pressure * state.pressure(at)
        });
        (matrix, forcing)
    }
}

impl State {
    fn frictionless(angles: &[f64]) -> Self {
        let n = angles.len() - 1;
        let none = Self {
            middle: 0.0,
            half: 1.0,
            coefficients: Vec::new(),
            used: DVector::zeros(n),
            bounds: vec![0.0; n],
        };
        none.pressed(angles, 0.0)
    }

    fn x(&self, s: f64) -> f64 {
        self.middle + self.half * s
    }

    fn apart(&self, other: &Self) -> f64 {
        let area = (self.middle - other.middle).abs() + (self.half - other.half).abs();
        let bounds = self.bounds.iter().zip(&other.bounds).map(|(p, q)| (p - q).abs());
        bounds.fold(area, f64::max)
    }

    /// Area and pressure under the present tractions.
    fn pressed(&self, angles: &[f64], q: f64) -> Self {
        let tractions: Vec<f64> =
            self.used.iter().zip(&self.bounds).map(|(used, bound)| q * used * bound).collect();
        let elements = || angles.windows(2).zip(&tractions);
        let mean = elements().map(|(ends, t)| t * (ends[1] - ends[0])).sum::<f64>() / PI;
        // In Chebyshev's polynomials of the first kind.
        let wave = |j: usize| {
            let j = j as f64;
            let part = |ends: &[f64]| ((j * ends[1]).sin() - (j * ends[0]).sin()) / j;
            2.0 / PI * elements().map(|(ends, t)| t * part(ends)).sum::<f64>()
        };
        let first = wave(1);
        // The load is that without friction: half (half + first) = 1.
        let half = 0.5 * ((first * first + 4.0).sqrt() - first);
        let mut coefficients = vec![half + first];
        coefficients.extend((2..=self.used.len() / 2).map(wave));
        let bounds = angles.windows(2).map(|ends| bound(&coefficients, ends)).collect();
        Self { middle: -mean, half, coefficients, used: self.used.clone(), bounds }
    }

    fn pressure(&self, x: f64) -> f64 {
        let angle = ((x - self.middle) / self.half).clamp(-1.0, 1.0).acos();
        let waves = self.coefficients.iter().enumerate();
        waves.map(|(k, c)| c * ((k + 1) as f64 * angle).sin()).sum()
    }
}

/// Mean of the pressure over an element; never zero, for tractions are unknown over it.
fn bound(coefficients: &[f64], ends: &[f64]) -> f64 {
    /// Of the scale of the pressure: lower bound of an element's mean.
    const MIN_PRESSURE: f64 = 1e-9;
    let wave = |k: usize, angle: f64| {
        let m = k as f64;
        let low = if k == 0 { angle } else { (m * angle).sin() / m };
        0.5 * (low - ((m + 2.0) * angle).sin() / (m + 2.0))
    };
    let part = |(k, c): (usize, &f64)| c * (wave(k, ends[1]) - wave(k, ends[0]));
    let sum: f64 = coefficients.iter().enumerate().map(part).sum();
    (sum / (ends[0].cos() - ends[1].cos())).max(MIN_PRESSURE)
}

impl CylindersSolved {
    /// The creepage, in `mu a / rho`.
    #[must_use]
    pub fn creepage(&self) -> f64 {
        self.creepage
    }

    /// Whether friction and pressure settled.
    #[must_use]
    pub fn status(&self) -> Status {
        self.status
    }

    /// Force per length on the lower cylinder, in `mu N`.
    #[must_use]
    pub fn force(&self) -> f64 {
        let State { half, used, bounds, .. } = &self.state;
        let tractions = used.iter().zip(bounds).zip(self.angles.windows(2));
        let parts = tractions.map(|((t, bound), ends)| t * bound * (ends[0].cos() - ends[1].cos()));
        half * parts.sum::<f64>() / FRAC_PI_2
    }

    /// The trailing and the leading end of the contact, in `a`.
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        [self.state.x(-1.0), self.state.x(1.0)]
    }

    /// Pressure at `x` (in `a`), in the frictionless peak pressure; zero outside.
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        let [trailing, leading] = self.ends();
        if x > trailing && x < leading { self.state.pressure(x).max(0.0) } else { 0.0 }
    }

    /// Traction on the lower cylinder at `x` (in `a`), in `mu` times the frictionless peak pressure;
    /// zero outside.
    #[must_use]
    pub fn traction(&self, x: f64) -> f64 {
        self.element(x).map_or(0.0, |element| self.state.used[element] * self.pressure(x))
    }

    /// Slip of the upper cylinder against the lower at `x` (in `a`), in `mu a / rho`; zero outside and where
    /// surfaces adhere.
    #[must_use]
    pub fn slip(&self, x: f64) -> f64 {
        self.element(x).filter(|k| self.slides(*k)).map_or(0.0, |k| self.slip[k])
    }

    /// Energy that turns to heat per length rolled and length of the cylinders, by traction and slip, in
    /// `(mu N) (mu a / rho)`; with unlike bodies it is not zero in free rolling.
    #[must_use]
    pub fn dissipation(&self) -> f64 {
        let State { half, used, bounds, .. } = &self.state;
        let elements = self.angles.windows(2).enumerate().filter(|(k, _)| self.slides(*k));
        let parts = elements
            .map(|(k, ends)| used[k] * bounds[k] * self.slip[k] * (ends[0].cos() - ends[1].cos()));
        half * parts.sum::<f64>() / FRAC_PI_2
    }

    /// Middles of the elements (in `a`), from the trailing to the leading end: between them tractions are not known.
    #[must_use]
    pub fn middles(&self) -> Vec<f64> {
        let middle = |ends: &[f64]| self.state.x(0.5 * (ends[0].cos() + ends[1].cos()));
        self.angles.windows(2).rev().map(middle).collect()
    }

    fn slides(&self, element: usize) -> bool {
        self.state.used[element].abs() >= 1.0 - 1e-9
    }

    fn element(&self, x: f64) -> Option<usize> {
        let angle = ((x - self.state.middle) / self.state.half).acos();
        let place = self.angles.partition_point(|end| *end <= angle).checked_sub(1)?;
        (angle.is_finite() && place < self.state.used.len()).then_some(place)
    }

    /// Part of the contact's length that adheres.
    #[must_use]
    pub fn adhesion(&self) -> f64 {
        let elements = self.angles.windows(2).enumerate();
        let adhering = elements.filter(|(k, _)| !self.slides(*k));
        0.5 * adhering.map(|(_, ends)| ends[0].cos() - ends[1].cos()).sum::<f64>()
    }
}
