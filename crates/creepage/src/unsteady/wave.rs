//! Linear theory of harmonic creepage `exp(2 pi i q / wavelength)`: all adheres.
//!
//! With all amplitudes complex, the displacement of a particle grows from one point of displacement to
//! the next downstream, `g` apart, by the rigid slip on its way:
//!
//! ```math
//! U_0 - e^{-i \kappa g} U_1 = \int_0^g w e^{-i \kappa t} dt, \qquad \kappa = 2 \pi / \lambda
//! ```
//!
//! which is the equation of [`Rolling`](super::Rolling) where nothing slides, without steps.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix};

use super::elements::{Element, Elements};
use crate::approximate::linear::CreepageCoefficients;
use crate::check::{self, InvalidValue};
use crate::coulomb::extrapolation::extrapolate;
use crate::coulomb::influence::Tractions;
use crate::coulomb::{Exact, Resolution};
use crate::numerics::gauss::GAUSS_3;
use crate::{Contact, Ellipse};

type Number = Complex<f64>;
/// Force and moment by each component of the creepage.
type Response = [[Number; 3]; 3];

/// The amplitude of a force over that of a creepage, as a complex number: with the creepage
/// `cos(2 pi q / wavelength)` times its amplitude, the force is `real cos - imaginary sin` times it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// The part in phase with the creepage.
    pub real: f64,
    /// The part a quarter of a wavelength ahead of it; negative where the force lags.
    pub imaginary: f64,
}

/// Creepage and spin coefficients of creepage that varies harmonically with the distance rolled: units
/// and signs are those of [`CreepageCoefficients`], its limit for long waves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HarmonicCoefficients {
    /// Longitudinal force by longitudinal creepage.
    pub c11: Harmonic,
    /// Lateral force by lateral creepage.
    pub c22: Harmonic,
    /// Lateral force by spin.
    pub c23: Harmonic,
    /// Moment by lateral creepage.
    pub c32: Harmonic,
    /// Moment by spin.
    pub c33: Harmonic,
}

/// A contact prepared for harmonic creepage without slip.
///
/// ```
/// use creepage::unsteady::HarmonicCreepage;
/// use creepage::{Contact, Ellipse};
/// let contact = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
/// let harmonic = HarmonicCreepage::new(&contact)?;
/// let [long, short] = [100.0, 2.0].map(|wavelength| harmonic.coefficients(wavelength));
/// let (long, short) = (long?.c11, short?.c11);
/// // The force lags, and short waves hardly move it.
/// assert!(long.imaginary < 0.0 && short.magnitude() < 0.3 * long.magnitude());
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug)]
pub struct HarmonicCreepage {
    /// The steady coefficients.
    steady: CreepageCoefficients,
    semi_axis: f64,
    waves: [Wave; 2],
    /// Of an infinite wavelength, on both grids.
    infinite: [Response; 2],
}

/// One grid: elements, and the displacement of each point by each unknown.
#[derive(Debug)]
struct Wave {
    elements: Elements,
    displacements: DMatrix<f64>,
}

/// Shorter waves than this, in semi-axes, are shorter than elements.
const SHORTEST: f64 = 0.5;

impl Harmonic {
    /// Amplitude of the force over that of the creepage.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        self.real.hypot(self.imaginary)
    }

    /// By which angle the force is ahead of the creepage (rad); negative where it lags.
    #[must_use]
    pub fn phase(&self) -> f64 {
        self.imaginary.atan2(self.real)
    }
}

impl HarmonicCreepage {
    /// # Errors
    /// [`InvalidValue`] as [`Exact::new`].
    pub fn new(contact: &Contact) -> Result<Self, InvalidValue> {
        let ellipse = contact.ellipse();
        check::ratio(ellipse.ratio(), Exact::RATIO_RANGE, "between 1/64 and 64")?;
        let steady = CreepageCoefficients::new(contact)?;
        let [along, across] = Resolution::FAST.coarse(ellipse.ratio());
        let waves =
            [1, 2].map(|k| Wave::new(ellipse, contact.poisson(), [2 * k * along, k * across]));
        let infinite = waves.each_ref().map(|wave| wave.response(0.0));
        let [Some(coarse), Some(fine)] = infinite else { return Err(singular(f64::INFINITY)) };
        Ok(Self { steady, semi_axis: ellipse.a(), waves, infinite: [coarse, fine] })
    }

    /// The coefficients for a `wavelength` over the contact's semi-axis along the rolling direction.
    ///
    /// Those of elements over the same of an infinite wavelength, times the steady coefficients: errors
    /// are below 1 % for wavelengths of two semi-axes and more.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `wavelength` is at least half a semi-axis.
    pub fn coefficients(&self, wavelength: f64) -> Result<HarmonicCoefficients, InvalidValue> {
        let valid = "at least half a semi-axis";
        check::require(wavelength >= SHORTEST, "wavelength", wavelength, valid)?;
        let wave_number = TAU / (wavelength * self.semi_axis);
        let [coarse, fine] = self.waves.each_ref().map(|wave| wave.response(wave_number));
        let (Some(coarse), Some(fine)) = (coarse, fine) else { return Err(singular(wavelength)) };
        let of = |force: usize, creepage: usize, steady: f64| {
            let at = |response: &Response| response[creepage][force];
            let ratio = |grid: usize, found: &Response| at(found) / at(&self.infinite[grid]);
            let (coarse, fine) = (ratio(0, &coarse), ratio(1, &fine));
            Harmonic {
                real: steady * extrapolate(coarse.re, fine.re),
                imaginary: steady * extrapolate(coarse.im, fine.im),
            }
        };
        let CreepageCoefficients { c11, c22, c23, c32, c33 } = self.steady;
        Ok(HarmonicCoefficients {
            c11: of(0, 0, c11),
            c22: of(1, 1, c22),
            c23: of(1, 2, c23),
            c32: of(2, 1, c32),
            c33: of(2, 2, c33),
        })
    }
}

fn singular(wavelength: f64) -> InvalidValue {
    InvalidValue { quantity: "wavelength", value: wavelength, valid: "one with a solution" }
}

impl Wave {
    fn new(ellipse: Ellipse, poisson: f64, counts: [usize; 2]) -> Self {
        let elements = Elements::hertz(ellipse, poisson, 0.0, counts);
        let n = elements.all.len();
        let mut displacements = DMatrix::zeros(2 * elements.points(), 2 * n);
        let mut unit = Tractions::zeros(&elements.steady.influence);
        for (column, mut by) in displacements.column_iter_mut().enumerate() {
            let (element, component) = (column / 2, column % 2);
            let traction = [[1.0, 0.0], [0.0, 1.0]][component];
            unit.set(|other| if other == element { traction } else { [0.0; 2] });
            let [x, y] = elements.displacements.by(&unit);
            for (point, (x, y)) in x.into_iter().zip(y).enumerate() {
                (by[2 * point], by[2 * point + 1]) = (x, y);
            }
        }
        Self { elements, displacements }
    }

    /// Force and moment by a unit of each component of the creepage; `None` where the equations are
    /// singular.
    fn response(&self, wave_number: f64) -> Option<Response> {
        let n = self.elements.all.len();
        let turned = |way: f64| Number::from_polar(1.0, -wave_number * way);
        let matrix = DMatrix::from_fn(2 * n, 2 * n, |row, column| {
            let Element { nodes: [own, upstream, _], steps: [step, _], .. } =
                self.elements.all[row / 2];
            let at = |point: usize| self.displacements[(2 * point + row % 2, column)];
            Number::from(at(own)) - turned(step) * at(upstream)
        });
        let rigid = DMatrix::from_fn(2 * n, 3, |row, creepage| {
            rigid(&self.elements.all[row / 2], wave_number)[creepage][row % 2]
        });
        let tractions = matrix.lu().solve(&rigid)?;
        Some([0, 1, 2].map(|creepage| self.force(|row| tractions[(row, creepage)])))
    }

    fn force(&self, traction: impl Fn(usize) -> Number) -> [Number; 3] {
        let pressure = &self.elements.steady.pressure;
        let mut sum = [Number::from(0.0); 3];
        for (element, (share, [x, y])) in
            pressure.shares.iter().zip(&pressure.centroids).enumerate()
        {
            let [p, q] = [0, 1].map(|k| traction(2 * element + k) * *share);
            sum = [sum[0] + p, sum[1] + q, sum[2] + q * *x - p * *y];
        }
        sum
    }
}

/// The rigid slip over the way from the upstream point, by a unit of each component of the creepage.
fn rigid(element: &Element, wave_number: f64) -> [[Number; 2]; 3] {
    let zero = Number::from(0.0);
    let step = element.steps[0];
    let (mut sum, mut moment) = (zero, zero);
    for (place, weight) in GAUSS_3 {
        let at = 0.5 * (1.0 + place);
        let part = Number::from_polar(0.5 * weight * step, -wave_number * at * step);
        sum += part;
        moment += part * (at * step);
    }
    [[sum, zero], [zero, sum], [-sum * element.y, sum * element.x + moment]]
}
