//! Polach's law (1999): a traction that grows in proportion along the contact until it meets the
//! bound, integrated in closed form; the lateral force of spin is added to it.
//!
//! In units of `mu N`, with `s_x, s_y, p` linear theory's `G ab upsilon_x/(mu N)` and so on, and
//! lengths in units of `c`:
//!
//! - `s_yC = s_y + p a` if that is larger in magnitude than `s_y`, otherwise `s_y`;
//!   `s_C = |(s_x, s_yC)|`;
//! - `eps = (pi/4) s_C |(C11 s_x, C22 s_y)|/|(s_x, s_y)|`;
//! - `F = (2/pi) (k_A eps/(1 + (k_A eps)^2) + atan(k_S eps))`;
//! - `f_x = F s_x/s_C`, `f_y = F s_y/s_C + F_S p/s_C`;
//! - `F_S = (3/8) a w e/(1 + e^2)^2`, `e = (8/3) b C23 |s_yC|/w`, `w = 1 + 6.3 (1 - exp(-a/b))`.
//!
//! The last line is Polach's `-(9/16) a w K_M`, with his cubic in `(e^2 - 1)/(e^2 + 1)` for `K_M`
//! multiplied out.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_4, PI};

use super::linear::{CreepageCoefficients, bounded, checked};
use crate::check::{self, InvalidValue};
use crate::contact::Contact;
use crate::numerics::bisect;
use crate::theory::{Jacobian, Solved, Stateless};
use crate::{Creepage, FieldPoint, Force, Region, Solution, Status, Theory};

/// Polach's law of 1999 (published 2000), with the two reduction factors of 2005.
///
/// Without spin it is FASTSIM with an elliptic traction bound, in closed form. With spin it is a
/// rough estimate, and does not always tend to linear theory: when `xi` and `chi` act together
/// the lateral force is too small by a factor, however small both are. It is continuous but has
/// kinks, where `s_y` takes over from `s_y + p a`. The law has no moment: `m_z` is zero.
///
/// Two transcriptions by others agree on the constants ([sources](crate::approximate)).
/// Verified are the limits (linear theory for `xi`, `eta` or `chi` alone, and for `eta` and `chi`
/// together; `mu N` for large creepage), and the identity with FASTSIM. Friction that falls with
/// speed (2005) is left out, since nothing was found to verify it by.
///
/// ```
/// use creepage::approximate::polach::Polach;
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let dry = Polach::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?)?;
/// let wet = dry.clone().with_reduction(0.3, 0.1)?;
/// let creepage = Creepage::new(0.1, 0.0, 0.0)?;
/// assert!(wet.solve(creepage).force.fx < dry.solve(creepage).force.fx);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Polach {
    contact: Contact,
    coefficients: CreepageCoefficients,
    /// `s` over creepage, `3 (1 - sigma) E/(4 pi sqrt g)`.
    unit: f64,
    /// `e/|s_yC|`.
    spin_slope: f64,
    /// `(3/8) a w`.
    spin_scale: f64,
    reduction_adhesion: f64,
    reduction_slip: f64,
}

/// The quantities of the law at one creepage.
struct Point {
    /// `s_x`, `s_y`, `p`.
    creep: [f64; 3],
    /// `s_yC`.
    lateral: f64,
    /// Derivative of `s_yC` by `p`: `a` or zero.
    arm: f64,
    /// `s_C`.
    total: f64,
    /// `1/(s_x^2 + s_y^2)`; zero for pure spin.
    per_size2: f64,
    /// `|(C11 s_x, C22 s_y)|/|(s_x, s_y)|`.
    stiffness: f64,
}

impl Polach {
    /// The law of 1999: both reduction factors 1. Interpolates the creepage coefficients.
    ///
    /// # Errors
    /// As [`CreepageCoefficients::new`].
    pub fn new(contact: &Contact) -> Result<Self, InvalidValue> {
        let (ellipse, poisson) = (checked(contact)?, contact.poisson());
        let coefficients = CreepageCoefficients::interpolated(contact)?;
        let spin_weight = 1.0 - 6.3 * (-ellipse.ratio()).exp_m1();
        Ok(Self {
            contact: contact.clone(),
            coefficients,
            spin_slope: 8.0 / 3.0 * ellipse.b() * coefficients.c23 / spin_weight,
            spin_scale: 0.375 * ellipse.a() * spin_weight,
            unit: coefficients.gains(ellipse, poisson)[0][0] / coefficients.c11,
            reduction_adhesion: 1.0,
            reduction_slip: 1.0,
        })
    }

    /// The reduction factors `k_A` (area of adhesion) and `k_S` (area of slip), by which the slope
    /// at small creepage is measured against that of a clean, dry surface. The slope is reduced
    /// by `(k_A + k_S)/2`; the lateral force of spin is not touched.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `0 < slip <= adhesion <= 1`.
    pub fn with_reduction(self, adhesion: f64, slip: f64) -> Result<Self, InvalidValue> {
        let valid = "greater than zero and at most 1";
        check::require(adhesion > 0.0 && adhesion <= 1.0, "adhesion", adhesion, valid)?;
        let valid = "greater than zero and at most the factor of adhesion";
        check::require(slip > 0.0 && slip <= adhesion, "slip", slip, valid)?;
        Ok(Self { reduction_adhesion: adhesion, reduction_slip: slip, ..self })
    }

    fn slope_at_rest(&self, column: usize) -> [f64; 2] {
        let CreepageCoefficients { c11, c22, c23, .. } = self.coefficients;
        let reduction = 0.5 * (self.reduction_adhesion + self.reduction_slip);
        [[reduction * c11, 0.0], [0.0, reduction * c22], [0.0, c23]][column]
    }

    /// Change of `(f_x, f_y)` with one of `s_x, s_y, p`.
    fn change(&self, point: &Point, column: usize) -> [f64; 2] {
        let share = point.creep.map(|component| component / point.total);
        let mut unit = [0.0; 3];
        unit[column] = 1.0;
        let lateral = unit[1] + point.arm * unit[2];
        let total = share[0] * unit[0] + point.lateral / point.total * lateral;
        // The stiffness, and its change.
        let own = [self.coefficients.c11, self.coefficients.c22, point.stiffness][column];
        let (stiffness, stiffening) = if point.stiffness > 0.0 {
            let turn = (own * own - point.stiffness * point.stiffness) / point.stiffness;
            (point.stiffness, turn * point.per_size2 * point.creep[column])
        } else {
            (own, 0.0)
        };
        let [force, by_stress] = self.saturation(stiffness * point.total);
        let [spin_force, by_lateral] = self.spin_force(point.lateral.abs());
        let part = |i: usize| {
            by_stress * (stiffness * total * share[i] + stiffening * point.creep[i])
                + force / point.total * (unit[i] - share[i] * total)
        };
        let spin = by_lateral * point.lateral.signum() * lateral * share[2]
            + spin_force / point.total * (unit[2] - share[2] * total);
        [part(0), part(1) + spin]
    }

    fn point(&self, creepage: Creepage) -> Point {
        let Creepage { xi, eta, chi } = bounded(creepage);
        // So small that its square would vanish.
        let flush = |s: f64| if s.abs() < 1e-140 { 0.0 } else { s };
        let [sx, sy, p] = [xi, eta, chi].map(|component| flush(self.unit * component));
        let with_spin = sy + p * self.contact.ellipse().a();
        let (lateral, arm) = if with_spin.abs() > sy.abs() {
            (with_spin, self.contact.ellipse().a())
        } else {
            (sy, 0.0)
        };
        let (c11, c22) = (self.coefficients.c11, self.coefficients.c22);
        let size2 = sx * sx + sy * sy;
        let per_size2 = if size2 > 0.0 { size2.recip() } else { 0.0 };
        let stiffness2 = c11 * c11 * sx * sx + c22 * c22 * sy * sy;
        Point {
            creep: [sx, sy, p],
            lateral,
            arm,
            total: (sx * sx + lateral * lateral).sqrt(),
            per_size2,
            stiffness: (stiffness2 * per_size2).sqrt(),
        }
    }

    /// `F`, and its derivative by `stress`.
    fn saturation(&self, stress: f64) -> [f64; 2] {
        let eps = FRAC_PI_4 * stress;
        let (adhering, sliding) = (self.reduction_adhesion * eps, self.reduction_slip * eps);
        // One over 1 + x^2, safe from overflow because creepage is bounded.
        let (adhering_part, sliding_part) =
            ((1.0 + adhering * adhering).recip(), (1.0 + sliding * sliding).recip());
        let force = adhering * adhering_part + sliding.atan();
        let by_eps =
            self.reduction_adhesion * (1.0 - adhering * adhering) * adhering_part * adhering_part
                + self.reduction_slip * sliding_part;
        [FRAC_2_PI * force, FRAC_2_PI * FRAC_PI_4 * by_eps]
    }

    /// `F_S`, and its derivative by `|s_yC|`.
    fn spin_force(&self, lateral: f64) -> [f64; 2] {
        let e = self.spin_slope * lateral;
        let decay = (1.0 + e * e).recip();
        let by_e = (1.0 - 3.0 * e * e) * decay * decay * decay;
        [self.spin_scale * e * decay * decay, self.spin_scale * self.spin_slope * by_e]
    }
}

impl Theory for Polach {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        let point = self.point(creepage);
        let mut force = Force::default();
        if point.total > 0.0 {
            let per_total = point.total.recip();
            let [sx, sy, p] = point.creep.map(|component| component * per_total);
            let [friction, _] = self.saturation(point.stiffness * point.total);
            let [spin_force, _] = self.spin_force(point.lateral.abs());
            force.fx = friction * sx;
            force.fy = friction * sy + spin_force * p;
        }
        Solution::closed_form(force, Status::Solved)
    }

    /// Polach's picture of the traction, in the direction of the force: from the leading edge it
    /// grows in proportion to the distance, until it meets the bound. The proportion is the one
    /// that makes the tractions carry the force (without spin, and with reduction factors of 1, it
    /// is the law's own). There is no moment. The slip in the slip area is NaN.
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let force = self.solve(creepage).force;
        let magnitude = force.magnitude();
        let [nx, ny] =
            [force.fx, force.fy].map(|f| if magnitude > 0.0 { f / magnitude } else { 0.0 });
        let growth = growth(magnitude.min(1.0));
        let point = |&position: &[f64; 2]| {
            let [x, y] = [
                position[0] / self.contact.ellipse().a(),
                position[1] / self.contact.ellipse().b(),
            ];
            let half = (1.0 - y * y).max(0.0).sqrt();
            let (ahead, behind) = (half - x, half + x);
            if ahead.is_nan() || ahead <= 0.0 || behind <= 0.0 {
                return FieldPoint::outside(position);
            }
            let (grown, bound) = (growth * ahead, (ahead * behind).sqrt());
            let (size, slip, region) = if grown < bound {
                (grown, [0.0; 2], Region::Adhesion)
            } else {
                (bound, [f64::NAN; 2], Region::Slip)
            };
            FieldPoint { position, traction: [size * nx, size * ny], slip, region }
        };
        positions.iter().map(point).collect()
    }

    /// Derivative of `(f_x, f_y, m_z)` (rows) by `(xi, eta, chi)` (columns). On a kink it is that
    /// of one side; for pure spin, and at rest, every column is that along its own axis.
    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        let point = self.point(creepage);
        let [xi, eta, chi] = [0, 1, 2].map(|column| {
            let change = if point.total > 0.0 {
                self.change(&point, column)
            } else {
                self.slope_at_rest(column)
            };
            change.map(|f| self.unit * f)
        });
        Some([[xi[0], eta[0], chi[0]], [xi[1], eta[1], chi[1]], [0.0; 3]])
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Stateless::boxed(self, creepage)
    }
}

/// The `eps` at which the tractions carry `force`: with `eps = tan(t/2)` the law without reduction
/// is `t + sin t = pi force`, solved by bisection.
fn growth(force: f64) -> f64 {
    let turn = bisect(0.0, PI, 60, |turn| turn + turn.sin() < PI * force);
    (0.5 * turn).tan()
}
