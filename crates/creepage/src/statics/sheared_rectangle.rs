//! Rectangle of uniform pressure, sheared to and fro: the law of a layer, with the bodies as its spring.

use std::f64::consts::PI;

use super::ShiftAxis;
use crate::check::{self, InvalidValue};
use crate::layer::{Layer, Plasticity};
use crate::solid::SolidPair;

/// Two bodies under a uniform pressure on a rectangle, whose uniform traction along one axis goes to and fro: what
/// a shear test measures of a layer, and what one element of a grid does.
///
/// The shift is that of the rectangle's centre. It is elastic in the bodies (Cerruti) and in the layer, until the
/// traction reaches the smaller of the layer's yield stress and friction. Beyond, the layer yields, and its yield
/// stress changes by [`Plasticity::slope`] with the plastic displacement gathered, to and fro alike; or the surfaces
/// slide. Bodies are taken as like ones: pressure of unlike ones does not move the centre of a rectangle.
///
/// ```
/// use creepage::statics::{ShearedRectangle, ShiftAxis};
/// use creepage::{Layer, Plasticity, Solid, SolidPair};
/// let steel = Solid::new(82e9, 0.28)?;
/// let clay = Layer::elastic(20e-6, 106.25e6)?
///     .with_plasticity(Plasticity { yield_stress: 200e6, slope: 435e9 })?;
/// let pair = SolidPair::new(steel, steel);
/// // A square of 1 mm under 900 N.
/// let mut test = ShearedRectangle::new(pair, [0.5e-3; 2], 900.0, 0.7, Some(clay), ShiftAxis::X)?;
/// test.to_shift(-40e-6)?; // elastic so far
/// test.to_shift(-80e-6)?;
/// assert!((test.force() + 216.0).abs() < 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Sources: V. Cerruti 1882 as in K.L. Johnson, *Contact Mechanics*, 3.6; K. Hou, J. Kalousek, E. Magel, Wear 211
/// (1997) 134-140, for the layer.
#[derive(Debug, Clone, PartialEq)]
pub struct ShearedRectangle {
    half_lengths: [f64; 2],
    pair: SolidPair,
    axis: ShiftAxis,
    normal_force: f64,
    /// Bound by friction (Pa), and the layer's yield.
    bound: f64,
    plasticity: Option<Plasticity>,
    /// Elastic shift over traction (m/Pa), of bodies and layer.
    flexibility: f64,
    /// Traction (Pa), shift (m), plastic displacement gathered (m), way slid (m), work turned to heat (J/m2).
    traction: f64,
    shift: f64,
    plastic: f64,
    slid: f64,
    dissipated: f64,
    state: Shearing,
}

/// State of a rectangle at the end of its path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shearing {
    /// Elastic.
    Sticks,
    /// The layer yields.
    Yields,
    /// The surfaces slide over each other.
    Slides,
}

impl Shearing {
    /// In a word.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Sticks => "sticks",
            Self::Yields => "yields",
            Self::Slides => "slides",
        }
    }
}

/// Error of a force that is not reached.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShearError {
    /// A number that is not finite.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// Beyond what the layer or friction bears.
    #[error("the force {force} N is not reachable: friction and the layer bear {most} N at most")]
    Beyond {
        /// Its size (N).
        force: f64,
        /// The most (N).
        most: f64,
    },
}

impl ShearedRectangle {
    /// A rectangle of `half_lengths` (m) along `x` and `y`, pressed by `normal_force` (N), with coefficient of
    /// friction `friction`, sheared along `axis`, not shifted yet.
    ///
    /// # Errors
    /// [`InvalidValue`] unless lengths, force and friction are finite and positive; and for a layer that softens
    /// faster than bodies and layer spring back, which snaps.
    pub fn new(
        pair: SolidPair,
        half_lengths: [f64; 2],
        normal_force: f64,
        friction: f64,
        layer: Option<Layer>,
        axis: ShiftAxis,
    ) -> Result<Self, InvalidValue> {
        let [a, b] = half_lengths;
        check::positive("half-length along x", a)?;
        check::positive("half-length along y", b)?;
        check::positive("normal_force", normal_force)?;
        check::positive("friction", friction)?;
        let soft = layer.map_or(0.0, |layer| layer.flexibility());
        let flexibility = soft + compliances(pair, half_lengths)[axis as usize];
        let plasticity = layer.and_then(|layer| layer.plasticity());
        if let Some(Plasticity { slope, .. }) = plasticity {
            let valid = "above minus the stiffness of bodies and layer";
            check::require(slope * flexibility > -1.0, "slope", slope, valid)?;
        }
        Ok(Self {
            half_lengths,
            pair,
            axis,
            normal_force,
            bound: check::finite("pressure", friction * normal_force / (4.0 * a * b))?,
            plasticity,
            flexibility: check::finite("flexibility", flexibility)?,
            traction: 0.0,
            shift: 0.0,
            plastic: 0.0,
            slid: 0.0,
            dissipated: 0.0,
            state: Shearing::Sticks,
        })
    }

    /// The same rectangle, not shifted yet.
    #[must_use]
    pub fn fresh(&self) -> Self {
        Self {
            traction: 0.0,
            shift: 0.0,
            plastic: 0.0,
            slid: 0.0,
            dissipated: 0.0,
            state: Shearing::Sticks,
            ..self.clone()
        }
    }

    /// Goes on until the upper body is shifted by `shift` (m) against the lower, seen from where it was pressed.
    ///
    /// # Errors
    /// [`ShearError::Invalid`] unless it is finite.
    pub fn to_shift(&mut self, shift: f64) -> Result<(), ShearError> {
        let mut way = check::finite("shift", shift)? - self.shift;
        let sign = way.signum();
        // Elastic up to the bound on that side.
        let room = (sign * self.limit() - self.traction) * self.flexibility;
        self.state = Shearing::Sticks;
        if way.abs() < room.abs() {
            self.traction += way / self.flexibility;
            way = 0.0;
        } else if way != 0.0 {
            self.traction = sign * self.limit();
            way = self.yield_by(way - room);
        }
        if way != 0.0 {
            self.slid += way.abs();
            self.dissipated += self.limit() * way.abs();
            self.state = Shearing::Slides;
        }
        self.shift = shift;
        Ok(())
    }

    /// Goes on until the tangential force of the upper body on the lower is `force` (N): elastically, or by yield
    /// of a layer that hardens.
    ///
    /// # Errors
    /// [`ShearError::Beyond`] where neither reaches it: the path stays where it was.
    pub fn to_force(&mut self, force: f64) -> Result<(), ShearError> {
        let traction = check::finite("force", force)? / self.area();
        let shift = if traction.abs() <= self.limit() {
            self.shift + (traction - self.traction) * self.flexibility
        } else {
            let most = self.most();
            if traction.abs() > most {
                return Err(ShearError::Beyond { force: force.abs(), most: most * self.area() });
            }
            let slope = self.plasticity.map_or(f64::INFINITY, |plasticity| plasticity.slope);
            let plastic = (traction.abs() - self.limit()) / slope;
            let elastic = (traction - self.traction) * self.flexibility;
            self.shift + elastic + traction.signum() * plastic
        };
        self.to_shift(shift)?;
        // But for rounding.
        self.traction = traction;
        Ok(())
    }

    /// Yields on a way beyond the elastic one: gives back the way that is left, on which the surfaces slide.
    fn yield_by(&mut self, way: f64) -> f64 {
        let Some(Plasticity { slope, .. }) = self.plasticity else { return way };
        let before = self.traction.abs();
        if self.yield_stress().is_none_or(|yields| yields >= self.bound) {
            return way;
        }
        self.state = Shearing::Yields;
        // Plastic displacement on the way, and the most until friction is reached or nothing is left to soften.
        let wanted = way.abs() / (1.0 + slope * self.flexibility);
        let most = if slope > 0.0 {
            (self.bound - before) / slope
        } else if slope < 0.0 {
            before / -slope
        } else {
            f64::INFINITY
        };
        let plastic = wanted.min(most);
        let after = before + slope * plastic;
        self.plastic += plastic;
        self.dissipated += 0.5 * (before + after) * plastic;
        self.traction = after.clamp(0.0, self.bound).copysign(way);
        if wanted <= most {
            return 0.0;
        }
        let left = (way.abs() - plastic * (1.0 + slope * self.flexibility)).copysign(way);
        if slope > 0.0 {
            return left;
        }
        // A layer that bears nothing any more is sheared freely.
        self.plastic += left.abs();
        0.0
    }

    /// The largest traction now (Pa).
    fn limit(&self) -> f64 {
        self.yield_stress().map_or(self.bound, |yields| yields.min(self.bound))
    }

    /// The largest traction that a force reaches (Pa).
    fn most(&self) -> f64 {
        let hardens = self.plasticity.is_none_or(|plasticity| plasticity.slope > 0.0);
        if hardens { self.bound } else { self.limit() }
    }

    /// The layer's yield stress after all that it has yielded (Pa), where it has one.
    #[must_use]
    pub fn yield_stress(&self) -> Option<f64> {
        let now = |p: Plasticity| (p.yield_stress + p.slope * self.plastic).max(0.0);
        self.plasticity.map(now)
    }

    /// Half-lengths along `x` and `y` (m).
    #[must_use]
    pub fn half_lengths(&self) -> [f64; 2] {
        self.half_lengths
    }

    /// The axis along which it is sheared.
    #[must_use]
    pub fn axis(&self) -> ShiftAxis {
        self.axis
    }

    /// Area (m2).
    #[must_use]
    pub fn area(&self) -> f64 {
        4.0 * self.half_lengths[0] * self.half_lengths[1]
    }

    /// Uniform pressure (Pa).
    #[must_use]
    pub fn pressure(&self) -> f64 {
        self.normal_force / self.area()
    }

    /// Approach of the bodies at the rectangle's centre (m), by Love's displacement.
    #[must_use]
    pub fn approach(&self) -> f64 {
        let [along, across] = asinhs(self.half_lengths);
        let compliance = (1.0 - self.pair.poisson()) / (PI * self.pair.shear_modulus());
        self.pressure() * compliance * 4.0 * (along + across)
    }

    /// Traction on the lower body along the axis (Pa).
    #[must_use]
    pub fn traction(&self) -> f64 {
        self.traction
    }

    /// Tangential force of the upper body on the lower (N).
    #[must_use]
    pub fn force(&self) -> f64 {
        self.traction * self.area()
    }

    /// The force that friction bears (N).
    #[must_use]
    pub fn friction_force(&self) -> f64 {
        self.bound * self.area()
    }

    /// Shift of the upper body relative to the lower (m).
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.shift
    }

    /// Plastic displacement of the layer gathered on the path, to and fro alike (m).
    #[must_use]
    pub fn plastic_displacement(&self) -> f64 {
        self.plastic
    }

    /// The way that the surfaces slid over each other, to and fro alike (m).
    #[must_use]
    pub fn sliding_way(&self) -> f64 {
        self.slid
    }

    /// Elastic shift over force (m/N).
    #[must_use]
    pub fn compliance(&self) -> f64 {
        self.flexibility / self.area()
    }

    /// Work turned to heat since the bodies were pressed, by yield and by sliding (J).
    #[must_use]
    pub fn dissipated(&self) -> f64 {
        self.dissipated * self.area()
    }

    /// What it does at the end of the path.
    #[must_use]
    pub fn state(&self) -> Shearing {
        self.state
    }
}

/// `b asinh(a/b)` and `a asinh(b/a)`.
fn asinhs([a, b]: [f64; 2]) -> [f64; 2] {
    [b * (a / b).asinh(), a * (b / a).asinh()]
}

/// Shift of the centre along `x` and `y` over a uniform traction of both bodies (m/Pa): the integrals of `1/r`
/// and of `x^2/r^3`, or `y^2/r^3`, over the rectangle are `4 (p + q)` and `4 p`, or `4 q`, with these two.
fn compliances(pair: SolidPair, half_lengths: [f64; 2]) -> [f64; 2] {
    let (poisson, parts) = (pair.poisson(), asinhs(half_lengths));
    let sum = parts[0] + parts[1];
    parts.map(|own| 4.0 * ((1.0 - poisson) * sum + poisson * own) / (PI * pair.shear_modulus()))
}
