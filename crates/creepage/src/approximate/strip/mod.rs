//! Strip theory: the contact is cut into narrow strips along the rolling direction, each of
//! which is a plane problem as Carter's.
//!
//! D. J. Haines, E. Ollerton, Contact stress distributions on elliptical contact surfaces
//! subjected to radial and tangential forces, Proc. Inst. Mech. Eng. 177 (1963) 95-114
//! (longitudinal creepage); J. J. Kalker, A strip theory for rolling with slip and spin, Proc.
//! Kon. Ned. Akad. Wet. B 70 (1967) 10-62 (lateral creepage and moderate spin). The equations
//! are derived from the plane-strain limit of the half-space ([sources](crate::approximate)). They
//! are verified by an independent plane integral, which finds no slip in the adhesion area, by
//! the limits of small creepage, and by the closed form without spin.
//!
//! In the strip at `y`, of half-length `a_y`, where slip reaches `2 d` in from the trailing edge:
//!
//! ```math
//! (X, Y) = \frac{\mu p_0}{a}
//! \left[ n \sqrt{a_y^2 - x^2} - m \sqrt{(a_y - d)^2 - (x - d)^2} \right],
//! \qquad |n| = 1
//! ```
//!
//! # Range
//! Made for slender contacts across the rolling direction, `a/b << 1`: without spin the error is
//! about 1 % of `mu N` at `a/b = 0.2`, and 10 % for the circle. The spin is bounded by
//! `|psi| < 1`, `psi = (1 - nu) E chi a / (4 sqrt(g))` in units of `c`; beyond, a strip's
//! equations have no solution, and the answer is that of full sliding with
//! [`Status::SpinTooLarge`].
//!
//! Strips that slide over their whole length take the direction of the rigid bodies' slip, which
//! is right for large creepage. How Kalker treated them is unknown to us. Where sliding and
//! adhering strips meet, the direction therefore jumps, by a small angle unless spin prevails.
//! In the slip area of adhering strips traction and slip make an angle; that is the theory's
//! approximation.
//!
//! The quadrature across the strips is good to 1e-12 without spin, and to 1e-10 with spin unless
//! the spin pole lies in or near strips that slide over their whole length: then to 1e-5.

mod across;
mod numbers;
mod sliding;

use super::dual::{self, Real};
use crate::contact::Contact;
use crate::ellipse::Ellipse;
use crate::theory::{Jacobian, Solved, Stateless};
use crate::{Creepage, FieldPoint, Region, Solution, Status, Theory};

use across::{Across, half_tangent};
pub(crate) use numbers::{Strip, StripNumbers};
use sliding::Sliding;
pub(crate) use sliding::unit;

/// Strip theory, prepared for one ratio of semi-axes and one Poisson's ratio.
///
/// ```
/// use creepage::{Contact, Creepage, Ellipse, Status, Theory};
/// use creepage::approximate::strip::StripTheory;
/// let theory = StripTheory::new(&Contact::new(Ellipse::from_ratio(0.2)?, 0.28)?);
/// let solution = theory.solve(Creepage::new(0.5, 0.0, 0.0)?);
/// assert!((solution.force.fx - 0.563).abs() < 5e-4);
/// let spinning = theory.solve(Creepage::new(0.5, 0.0, 6.0)?);
/// assert_eq!(spinning.status, Status::SpinTooLarge);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct StripTheory {
    contact: Contact,
    slope: f64,
    across: Across,
    sliding: Sliding,
}

impl StripTheory {
    /// Prepares the theory; every contact is within its range.
    #[must_use]
    pub fn new(contact: &Contact) -> Self {
        Self {
            contact: contact.clone(),
            slope: strip_slope(&contact.ellipse(), contact.poisson()),
            across: Across::new(),
            sliding: Sliding::new(),
        }
    }

    /// The largest spin: the theory holds for `|chi|` below it (`|psi| < 1`).
    #[must_use]
    pub fn spin_bound(&self) -> f64 {
        (self.slope * self.contact.ellipse().a()).recip()
    }

    fn spin_is_moderate(&self, creepage: Creepage) -> bool {
        (creepage.chi * (self.slope * self.contact.ellipse().a())).abs() < 1.0
    }

    fn numbers<R: Real>(&self, [xi, eta, chi]: [R; 3]) -> StripNumbers<R> {
        let free = 1.0 - self.contact.poisson();
        StripNumbers {
            longitudinal: xi * (self.slope / free),
            lateral: eta * self.slope,
            spin: chi * (self.slope * self.contact.ellipse().a()),
            shear: self.contact.ellipse().b() / (self.contact.ellipse().a() * free),
        }
    }

    fn force<R: Real>(&self, creepage: [R; 3], spin_is_moderate: bool) -> [R; 3] {
        let numbers = self.numbers(creepage);
        let adhering = if spin_is_moderate { numbers.adhering() } else { None };
        let edge = R::constant(1.0);
        let [from, to] = adhering.map_or([edge, edge], |edges| edges.map(half_tangent));
        let axes = [self.contact.ellipse().a(), self.contact.ellipse().b()];
        let mut force = [R::constant(0.0); 3];
        let mut add = |part: [R; 3]| force = [0, 1, 2].map(|i| force[i] + part[i] * 0.75);
        for piece in self.pieces([from, to], creepage).into_iter().flatten() {
            add(self.across.integrate(piece, 0, |[t, s]| numbers.strip_at(t).force([t, s], axes)));
        }
        // With spin the averages over sliding strips are good to 1e-10 only.
        let fewer = if creepage[2].value() == 0.0 { 0 } else { 2 };
        for slides in [[-edge, from], [to, edge]] {
            for piece in self.pieces(slides, creepage).into_iter().flatten() {
                add(self
                    .across
                    .integrate(piece, fewer, |at| self.sliding.force(creepage, at, axes)));
            }
        }
        force
    }

    /// Cuts an interval where the rigid bodies do not slip along: there is a kink.
    ///
    /// It is weak unless the spin pole lies in or near the contact. Elsewhere the cut need not
    /// move with the pole, and its derivative, which may be huge, is better left out.
    fn pieces<R: Real>(&self, [from, to]: [R; 2], [xi, eta, chi]: [R; 3]) -> [Option<[R; 2]>; 2] {
        if from.value() >= to.value() {
            return [None, None];
        }
        let pole = xi / (chi * self.contact.ellipse().b());
        if pole.value().abs() < 1.0 {
            let spin = chi.value().abs();
            let near = eta.value().abs() < 2.0 * self.contact.ellipse().a() * spin;
            let cut = half_tangent(pole);
            let cut = if near && spin > 1e-6 * self.spin_bound() {
                cut
            } else {
                R::constant(cut.value())
            };
            if from.value() < cut.value() && cut.value() < to.value() {
                return [Some([from, cut]), Some([cut, to])];
            }
        }
        [Some([from, to]), None]
    }

    fn field_point(&self, creepage: Creepage, position: [f64; 2]) -> FieldPoint {
        let [u, t] =
            [position[0] / self.contact.ellipse().a(), position[1] / self.contact.ellipse().b()];
        let s = ((1.0 - t) * (1.0 + t)).max(0.0).sqrt();
        let outside = FieldPoint::outside(position);
        if u.hypot(t) >= 1.0 || u.is_nan() || t.is_nan() {
            return outside;
        }
        let numbers = dual::plain(creepage);
        let strip = self.numbers(numbers).strip(t);
        if !self.spin_is_moderate(creepage) || strip.depth >= s {
            let bound = ((s - u) * (s + u)).max(0.0).sqrt();
            let [xi, eta, chi] = numbers;
            let slip = Creepage { xi, eta, chi }.rigid_slip(position);
            let traction = unit(slip).map(|n| n * bound);
            return FieldPoint { position, traction, slip, region: Region::Slip };
        }
        let adheres = strip.inside(u, s) > 0.0;
        FieldPoint {
            traction: strip.traction(u, s),
            slip: strip.slip(u, s, self.contact.poisson()).map(|v| v / self.slope),
            region: if adheres { Region::Adhesion } else { Region::Slip },
            ..outside
        }
    }
}

impl Theory for StripTheory {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        let moderate = self.spin_is_moderate(creepage);
        let status = if moderate { Status::Solved } else { Status::SpinTooLarge };
        let force = dual::force(self.force(dual::plain(creepage), moderate));
        Solution::closed_form(force, status)
    }

    /// In strips that slide over their whole length the slip is that of the rigid bodies.
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        positions.iter().map(|&position| self.field_point(creepage, position)).collect()
    }

    /// Exact derivative of the force: rows `fx`, `fy`, `mz`; columns `xi`, `eta`, `chi`.
    ///
    /// At a kink (zero creepage; the first sliding strip) it is one of the one-sided values.
    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        let variables = dual::variables(creepage);
        Some(dual::jacobian(self.force(variables, self.spin_is_moderate(creepage))))
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Stateless::boxed(self, creepage)
    }
}

/// `G upsilon / (2 mu p0)` of the creepage `upsilon = mu c / rho`: `(1 - nu) E / (4 sqrt(g))`.
pub(crate) fn strip_slope(ellipse: &Ellipse, poisson: f64) -> f64 {
    (1.0 - poisson) * ellipse.integrals().e / (4.0 * ellipse.g().sqrt())
}
