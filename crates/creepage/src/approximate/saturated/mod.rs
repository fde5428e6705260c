//! Large creepage and spin (4.4): the elastic slip is negligible, all of the contact slides.
//!
//! The traction is then `mu Z` in the direction of the rigid slip, a rotation about the spin
//! pole `x' = -c eta/chi`, `y' = c xi/chi`. Force and moment (4.97) are the gradient by
//! `(xi, eta, chi)` of
//!
//! ```math
//! \frac{3}{2 \pi a b} \iint \sqrt{1 - r^2} \; |w| \, dx \, dy, \qquad
//! w = (\xi - \chi y/c, \; \eta + \chi x/c), \quad r^2 = (x/a)^2 + (y/b)^2
//! ```

mod inside;
mod outside;

use inside::PoleInside;
use outside::PoleOutside;

use super::linear::bounded;
use crate::check::{self, InvalidValue};
use crate::contact::Contact;
use crate::theory::{Jacobian, Solved, Stateless};
use crate::{Creepage, FieldPoint, Force, Region, Solution, Status, Theory};

/// Theory of large creepage and spin (4.97), for any position of the spin pole.
///
/// Forces depend on the ratios `xi : eta : chi` only, not on Poisson's ratio nor on how large the
/// creepage is: it is always taken as large. Without creepage and spin there is no direction
/// to slide in: the force is then zero, with [`Status::CreepageTooSmall`].
///
/// Absolute error below 1e-11. A call costs 20 ns with the spin pole in the contact, otherwise 1 us
/// for round shapes, growing as `1/sqrt g` to 16 us.
///
/// ```
/// use creepage::approximate::saturated::Saturated;
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let circle = Saturated::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?)?;
/// // The spin pole on the edge: f_x = 9 pi/32.
/// let force = circle.solve(Creepage::new(1.0, 0.0, 1.0)?).force;
/// assert!((force.fx - 9.0 * std::f64::consts::PI / 32.0).abs() < 1e-14);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Saturated {
    contact: Contact,
    inside: PoleInside,
    outside: PoleOutside,
}

/// Where the spin pole lies.
enum Pole {
    /// Nowhere: no creepage and no spin.
    Nowhere,
    /// In the contact or on its edge.
    Inside,
    /// Outside the contact, or at infinity.
    Outside,
}

impl Saturated {
    /// Range of `a_over_b` in which the quadrature was examined.
    pub const RATIO_RANGE: [f64; 2] = [1e-3, 1e3];

    /// Prepares the theory; only the ratio `a/b` of the contact matters.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `a/b` lies within [`Saturated::RATIO_RANGE`].
    pub fn new(contact: &Contact) -> Result<Self, InvalidValue> {
        let ellipse = contact.hertz_ellipse()?;
        check::ratio(ellipse.ratio(), Self::RATIO_RANGE, "between 1e-3 and 1e3")?;
        Ok(Self {
            contact: contact.clone(),
            inside: PoleInside::new(ellipse),
            outside: PoleOutside::new(ellipse),
        })
    }

    fn pole(&self, creepage: Creepage) -> Pole {
        let spin = creepage.chi.abs();
        if spin < outside::reach(self.contact.ellipse(), creepage) {
            Pole::Outside
        } else if spin > 0.0 {
            Pole::Inside
        } else {
            Pole::Nowhere
        }
    }
}

/// Creepage divided by its largest component, since only ratios count; and that component.
fn normalised(creepage: Creepage) -> (Creepage, f64) {
    let Creepage { xi, eta, chi } = creepage;
    let size = xi.abs().max(eta.abs()).max(chi.abs());
    if size > 0.0 {
        (Creepage { xi: xi / size, eta: eta / size, chi: chi / size }, size)
    } else {
        (Creepage::default(), size)
    }
}

impl Theory for Saturated {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        let (creepage, _) = normalised(creepage);
        let (force, status) = match self.pole(creepage) {
            Pole::Nowhere => (Force::default(), Status::CreepageTooSmall),
            Pole::Inside => (self.inside.force(creepage), Status::Solved),
            Pole::Outside => (self.outside.force(creepage), Status::Solved),
        };
        Solution::closed_form(force, status)
    }

    /// The slip is the rigid one. At the spin pole itself the traction is given as zero.
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let creepage = bounded(creepage);
        let (direction, _) = normalised(creepage);
        let point = |&position: &[f64; 2]| {
            let r = (position[0] / self.contact.ellipse().a())
                .hypot(position[1] / self.contact.ellipse().b());
            if r >= 1.0 || r.is_nan() {
                return FieldPoint::outside(position);
            }
            let along = direction.rigid_slip(position);
            let speed = along[0].hypot(along[1]);
            let bound = ((1.0 - r) * (1.0 + r)).sqrt();
            let traction = along.map(|s| if speed > 0.0 { bound * (s / speed) } else { 0.0 });
            let slip = creepage.rigid_slip(position);
            FieldPoint { position, traction, slip, region: Region::Slip }
        };
        positions.iter().map(point).collect()
    }

    /// Derivative of `(f_x, f_y, m_z)` (rows) by `(xi, eta, chi)` (columns): symmetric, positive
    /// semidefinite, and zero along `(xi, eta, chi)` itself. Zero where there is no creepage.
    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        let (creepage, size) = normalised(creepage);
        let matrix = match self.pole(creepage) {
            Pole::Nowhere => return Some([[0.0; 3]; 3]),
            Pole::Inside => self.inside.derivative(creepage),
            Pole::Outside => self.outside.derivative(creepage),
        };
        Some(matrix.map(|row| row.map(|entry| entry / size)))
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Stateless::boxed(self, creepage)
    }
}
