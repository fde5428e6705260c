//! Hertz contact of two bodies of revolution: curvatures and load in, contact ellipse out
//! (3.36)-(3.52).
//!
//! The pressure (3.43), the axis ratio `g` of the ellipse for `a <= b` (3.48), with `A`, `B` the
//! relative curvatures along and across, and the approach (3.52), `s` the minor semi-axis:
//!
//! ```math
//! Z = \frac{3N}{2 \pi a b} \sqrt{1 - \frac{x^2}{a^2} - \frac{y^2}{b^2}}, \qquad
//! \frac{A}{B} = \frac{\mathbf{B}(g)}{g^2 \mathbf{D}(g)}, \qquad
//! \alpha = \frac{2 s^2 \mathbf{K}}{\rho \mathbf{E}}
//! ```

use std::f64::consts::PI;

use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;
use crate::solid::SolidPair;
use crate::special::CompleteIntegrals;

/// Principal radii of curvature of one body at the contact (m): positive where the body is
/// convex, negative where it is hollow, `f64::INFINITY` where it is flat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Radii {
    /// Radius of the section along the rolling direction, such as a wheel's rolling radius.
    pub rolling: f64,
    /// Radius of the section across the rolling direction, such as a rail head's.
    pub lateral: f64,
}

impl Radii {
    /// Curvatures along and across (1/m).
    fn curvatures(self) -> Result<[f64; 2], InvalidValue> {
        let valid = "a number other than zero, or infinity for a flat section";
        let check = |name, radius: f64| {
            check::require(!radius.is_nan() && radius.recip().is_finite(), name, radius, valid)
        };
        Ok([
            check("radius_rolling", self.rolling)?.recip(),
            check("radius_lateral", self.lateral)?.recip(),
        ])
    }
}

/// Error of two bodies without elliptic contact.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HertzError {
    /// A number is outside its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The bodies would touch at more than one point: a hollow is tighter than its counterpart.
    #[error(
        "the bodies cannot touch at a single point: the relative curvature {relative_curvature} \
         1/m {section} must be positive, but a hollow of one body is tighter than the other body"
    )]
    Hollow {
        /// Sum of both bodies' curvatures in that section, halved (1/m).
        relative_curvature: f64,
        /// Which principal section, in words.
        section: &'static str,
    },
    /// The bodies touch along a line, for which Hertz theory gives no ellipse.
    #[error(
        "line contact: the relative curvatures {along} 1/m along and {across} 1/m across differ \
         by more than a factor {max_ratio}, so the contact ellipse has no finite length"
    )]
    Line {
        /// Relative curvature `A` (1/m).
        along: f64,
        /// Relative curvature `B` (1/m).
        across: f64,
        /// Largest ratio of the two that is still solved.
        max_ratio: f64,
    },
}

/// Two bodies pressed together: the contact ellipse and the normal pressure in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hertz {
    pair: SolidPair,
    normal_force: f64,
    ellipse: Ellipse,
    angle: f64,
    rho: f64,
    /// `g` as it was found: the ellipse's own is a quotient of rounded semi-axes.
    g: f64,
    integrals: CompleteIntegrals,
}

impl Hertz {
    /// Largest ratio of the relative curvatures `A` and `B` (3.38) that counts as an ellipse.
    pub const MAX_CURVATURE_RATIO: f64 = 1e7;

    /// Presses two bodies together with `normal_force` `N` (N).
    ///
    /// `angle` (rad) is the angle from the upper body's rolling section to the lower body's
    /// (`omega`, (3.38)); zero for a wheel straight on a rail. The ellipse then lies at
    /// [`Hertz::angle`] from the upper body's rolling direction.
    ///
    /// # Errors
    /// [`HertzError`] when a number is out of range, when the bodies cannot touch at a single
    /// point, and in the limit of line contact.
    ///
    /// ```
    /// use creepage::{Hertz, Radii, Solid, SolidPair};
    /// let steel = Solid::new(82e9, 0.28)?;
    /// let wheel = Radii { rolling: 0.46, lateral: f64::INFINITY };
    /// let rail = Radii { rolling: f64::INFINITY, lateral: 0.30 };
    /// let contact = Hertz::new(SolidPair::new(steel, steel), wheel, rail, 0.0, 80e3)?;
    /// assert!((contact.ellipse().a() * 1e3 - 6.68).abs() < 0.01); // mm
    /// # Ok::<(), creepage::HertzError>(())
    /// ```
    pub fn new(
        pair: SolidPair,
        upper: Radii,
        lower: Radii,
        angle: f64,
        normal_force: f64,
    ) -> Result<Self, HertzError> {
        check::positive("normal_force", normal_force)?;
        check::finite("angle", angle)?;
        let relative = RelativeCurvature::new(upper.curvatures()?, lower.curvatures()?, angle)?;
        let g = axis_ratio(relative.ratio());
        let rho = 2.0 / (relative.along + relative.across);
        let integrals = CompleteIntegrals::new(g);
        // The ellipse is longer where the bodies curve less.
        let a_over_b = if relative.along > relative.across { g } else { g.recip() };
        let ellipse = Ellipse::from_ratio(a_over_b)?;
        let angle = relative.angle;
        let bodies = Self { pair, normal_force, ellipse, angle, rho, g, integrals };
        Ok(bodies.under(normal_force)?)
    }

    /// The same bodies under another load: the ellipse keeps its shape and grows as the cube root of
    /// the load, by (3.50). The same numbers as of [`Hertz::new`], without its elliptic integrals.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `normal_force` (N) is finite and positive.
    ///
    /// ```
    /// use creepage::{Hertz, Radii, Solid, SolidPair};
    /// let steel = Solid::new(82e9, 0.28)?;
    /// let ball = Radii { rolling: 6e-3, lateral: 6e-3 };
    /// let contact = |load| Hertz::new(SolidPair::new(steel, steel), ball, ball, 0.0, load);
    /// assert_eq!(contact(10.0)?.under(80.0)?, contact(80.0)?);
    /// # Ok::<(), creepage::HertzError>(())
    /// ```
    pub fn under(&self, normal_force: f64) -> Result<Self, InvalidValue> {
        check::positive("normal_force", normal_force)?;
        let (pair, rho, g) = (self.pair, self.rho, self.g);
        // (3.50): 3 N (1 - sigma) rho E = 4 pi c^3 G sqrt(g).
        let c = (3.0 * normal_force * (1.0 - pair.poisson()) * rho * self.integrals.e
            / (4.0 * PI * pair.shear_modulus() * g.sqrt()))
        .cbrt();
        let ellipse = Ellipse::of_size(c, self.ellipse.ratio())?;
        Ok(Self { normal_force, ellipse, ..*self })
    }

    /// The contact whose ellipse is known, as from a measurement or another program; the
    /// curvatures follow from it by (3.50).
    ///
    /// # Errors
    /// [`InvalidValue`] unless `normal_force` is finite and positive.
    pub fn from_ellipse(
        pair: SolidPair,
        ellipse: Ellipse,
        normal_force: f64,
    ) -> Result<Self, InvalidValue> {
        check::positive("normal_force", normal_force)?;
        let integrals = ellipse.integrals();
        let rho = 4.0 * PI * ellipse.c().powi(3) * pair.shear_modulus() * ellipse.g().sqrt()
            / (3.0 * normal_force * (1.0 - pair.poisson()) * integrals.e);
        check::positive("curvature radius rho of that ellipse and force", rho)?;
        Ok(Self { pair, normal_force, ellipse, angle: 0.0, rho, g: ellipse.g(), integrals })
    }

    /// The equivalent solid.
    #[must_use]
    pub fn pair(&self) -> SolidPair {
        self.pair
    }

    /// Normal force `N` (N).
    #[must_use]
    pub fn normal_force(&self) -> f64 {
        self.normal_force
    }

    /// The contact ellipse (m).
    #[must_use]
    pub fn ellipse(&self) -> Ellipse {
        self.ellipse
    }

    /// Angle from the upper body's rolling direction to the ellipse's axis `a` (rad), within
    /// a quarter of pi either way; zero when the bodies are aligned.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// Characteristic length `rho`: `1/rho` is the mean of the four curvatures (m).
    #[must_use]
    pub fn rho(&self) -> f64 {
        self.rho
    }

    /// Largest normal pressure `G f00 = 3N / (2 pi a b)` (Pa) (3.43).
    #[must_use]
    pub fn peak_pressure(&self) -> f64 {
        1.5 * self.normal_force / self.ellipse.area()
    }

    /// Moment of the front half of the pressure about the lateral axis, over `N a`.
    pub const HYSTERESIS: f64 = 3.0 / 16.0;

    /// Moment against rolling by elastic hysteresis (N m): of the work of the front half of the contact
    /// the fraction `loss_factor` is not given back by the rear half, so that it is
    /// `3/16 loss_factor N a`.
    ///
    /// The thesis leaves it out (1.1), and names it as what spoils the moment `M_z` of experiments (5.31):
    /// about the normal it counts as far as the axis of a rig is inclined to the contact.
    ///
    /// J. A. Greenwood, H. Minshall and D. Tabor, Hysteresis losses in rolling and sliding friction, Proc. R.
    /// Soc. Lond. A 259 (1961) 480-507.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `loss_factor` lies between 0 and 1.
    pub fn hysteresis_moment(&self, loss_factor: f64) -> Result<f64, InvalidValue> {
        let valid = "between 0 and 1";
        check::require((0.0..=1.0).contains(&loss_factor), "loss_factor", loss_factor, valid)?;
        Ok(Self::HYSTERESIS * loss_factor * self.normal_force * self.ellipse.a())
    }

    /// Approach of the bodies, `alpha = 2 s^2 K / (rho E)` (m) (3.52).
    #[must_use]
    pub fn approach(&self) -> f64 {
        2.0 * self.ellipse.minor().powi(2) * self.integrals.k / (self.rho * self.integrals.e)
    }

    /// Contact stiffness `dN/d(approach)` (N/m): the load goes as the approach to the power 3/2.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        1.5 * self.normal_force() / self.approach()
    }

    /// The approach over the load to the power 2/3 (m/N^(2/3)), which does not depend on the load.
    #[must_use]
    pub fn approach_constant(&self) -> f64 {
        self.approach() / self.normal_force().powf(2.0 / 3.0)
    }

    /// Relative curvatures `A` along and `B` across (1/m) (3.46).
    #[must_use]
    pub fn relative_curvatures(&self) -> [f64; 2] {
        let g2 = self.ellipse.g().powi(2);
        // A + B = 2/rho, and the two are as g^2 D to B (3.48).
        let (tight, slack) = (self.integrals.b, g2 * self.integrals.d);
        let scale = 2.0 / (self.rho * (tight + slack));
        if self.ellipse.a() <= self.ellipse.b() {
            [scale * tight, scale * slack]
        } else {
            [scale * slack, scale * tight]
        }
    }
}

/// The bodies' separation before loading is `A x^2 + B y^2` (3.37) in its principal axes.
struct RelativeCurvature {
    along: f64,
    across: f64,
    angle: f64,
}

impl RelativeCurvature {
    /// Adds the bodies' curvature tensors; their eigenvalues are `A` and `B`, for which
    /// `4 (A-B)^2 = d1^2 + d2^2 + 2 d1 d2 cos 2 omega` is the corrected (3.38).
    fn new(upper: [f64; 2], lower: [f64; 2], omega: f64) -> Result<Self, HertzError> {
        let mean = (upper[0] + upper[1] + lower[0] + lower[1]) / 4.0;
        let (upper_half, lower_half) = ((upper[0] - upper[1]) / 4.0, (lower[0] - lower[1]) / 4.0);
        let relative = if omega == 0.0 {
            // Exact sums: a wheel on a rail must not lose digits to a rotation by zero.
            Self {
                along: f64::midpoint(upper[0], lower[0]),
                across: f64::midpoint(upper[1], lower[1]),
                angle: 0.0,
            }
        } else {
            let (sin, cos) = (2.0 * omega).sin_cos();
            let (even, odd) = (upper_half + lower_half * cos, lower_half * sin);
            // Of the two principal axes, `along` is the one nearer to the rolling direction.
            let radius = even.hypot(odd).copysign(even);
            let angle = if radius == 0.0 { 0.0 } else { 0.5 * (odd / radius).asin() };
            Self { along: mean + radius, across: mean - radius, angle }
        };
        relative.check()
    }

    fn check(self) -> Result<Self, HertzError> {
        for (relative_curvature, section) in
            [(self.along, "along the rolling direction"), (self.across, "across it")]
        {
            if !(relative_curvature.is_finite() && relative_curvature >= 0.0) {
                return Err(HertzError::Hollow { relative_curvature, section });
            }
        }
        let max_ratio = Hertz::MAX_CURVATURE_RATIO;
        // Written so that two flat bodies, 0/0, are a line too.
        if self.ratio() <= max_ratio {
            Ok(self)
        } else {
            Err(HertzError::Line { along: self.along, across: self.across, max_ratio })
        }
    }

    fn ratio(&self) -> f64 {
        self.along.max(self.across) / self.along.min(self.across)
    }
}

/// Solves (3.48), `B / (g^2 D) = ratio` of the curvatures, for the axis ratio `g`.
///
/// `g <- sqrt(B / (D ratio))` contracts by a factor of four or more at every ratio.
fn axis_ratio(curvature_ratio: f64) -> f64 {
    let mut g = 1.0_f64;
    for _ in 0..100 {
        let integrals = CompleteIntegrals::new(g);
        let next = (integrals.b / (integrals.d * curvature_ratio)).sqrt().min(1.0);
        let change = (next - g).abs();
        g = next;
        if change <= 2.0 * f64::EPSILON * g {
            break;
        }
    }
    g
}
