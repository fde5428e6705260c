//! The theory of Vermeulen and Johnson (1964) for creepage without spin, and that of Johnson
//! (1958), its case of the circle.
//!
//! The adhesion area is taken as an ellipse similar to the contact that touches it at the leading
//! point, and the traction as that of full sliding less that of full sliding in the adhesion
//! ellipse, in the direction of the force. The slip then vanishes in the adhesion area. But some
//! of the slip area lies ahead of it, where the slip is against the traction, so that the force
//! of small creepage comes out larger than linear theory's: by 27 % at `a/b = .05`, 20 % for
//! the circle, 11 % at `a/b = 5` (longitudinal, `sigma = .28`).
//!
//! In parts of `mu N`, in the direction of `tau` (4.88), (4.89):
//!
//! ```math
//! f = 1 - (1 - \tau/3)^3 \quad (\tau \le 3), \qquad
//! \tau = \frac{\pi G a b}{\mu N}
//! \left( \frac{\upsilon_x}{\varphi}, \frac{\upsilon_y}{\psi_1} \right)
//! ```
//!
//! ```math
//! \begin{aligned}
//! a \le b: & \quad \varphi = B - \sigma (D - C), & \psi_1 &= B - \sigma g^2 C \\
//! a \ge b: & \quad \varphi = g [D - \sigma (D - C)], & \psi_1 &= g [D - \sigma C]
//! \end{aligned}
//! ```

use super::cubic::{self, Cubic};
use super::linear::{bounded, checked, slip_unit};
use super::outside_chords::OutsideChords;
use crate::check::InvalidValue;
use crate::contact::Contact;
use crate::theory::{Jacobian, Solved, Stateless};
use crate::{Creepage, FieldPoint, Force, Region, Solution, Status, Theory};

/// Theory of Vermeulen and Johnson (1964): an ellipse, no spin.
///
/// Spin is ignored, and so is its moment: `m_z` is zero. With `chi` other than zero the status is
/// [`Status::SpinTooLarge`], the bound being zero.
///
/// ```
/// use creepage::approximate::vermeulen_johnson::VermeulenJohnson;
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let circle = VermeulenJohnson::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.25)?)?;
/// let creepage = Creepage::new(0.5, 0.0, 0.0)?;
/// let force = circle.solve(creepage).force;
/// let size = circle.adhesion(creepage);
/// assert!((force.fx - (1.0 - size.powi(3))).abs() < 1e-15);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct VermeulenJohnson {
    contact: Contact,
    slip_unit: f64,
    phi: f64,
    psi: f64,
    /// Linear force by creepage, `3 (1 - sigma) E/(4 sqrt g)` over `phi` and over `psi`.
    gains: [f64; 2],
    chords: OutsideChords,
}

impl VermeulenJohnson {
    /// Prepares the theory: [`phi`](Self::phi) and [`psi`](Self::psi) in closed form.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `1e-3 <= a/b <= 1e3`.
    pub fn new(contact: &Contact) -> Result<Self, InvalidValue> {
        let (ellipse, poisson) = (checked(contact)?, contact.poisson());
        let integrals = ellipse.integrals();
        let (b, c, d, g) = (integrals.b, integrals.c, integrals.d, ellipse.g());
        let (phi, psi) = if ellipse.ratio() <= 1.0 {
            (b - poisson * (d - c), b - poisson * g * g * c)
        } else {
            (g * (d - poisson * (d - c)), g * (d - poisson * c))
        };
        let slip_unit = slip_unit(ellipse, poisson);
        Ok(Self {
            contact: contact.clone(),
            slip_unit,
            phi,
            psi,
            gains: [1.5 * slip_unit / phi, 1.5 * slip_unit / psi],
            chords: OutsideChords::new(ellipse),
        })
    }

    /// `phi` of (4.88b): `F_x = pi G ab upsilon_x/phi` for small creepage.
    #[must_use]
    pub fn phi(&self) -> f64 {
        self.phi
    }

    /// `psi_1` of (4.88a), the sign before its second term corrected: `F_y = pi G ab
    /// upsilon_y/psi_1` for small creepage.
    #[must_use]
    pub fn psi(&self) -> f64 {
        self.psi
    }

    /// Axes of the adhesion ellipse over those of the contact; zero in full sliding. It touches the
    /// contact at the leading point `(a, 0)`.
    #[must_use]
    pub fn adhesion(&self, creepage: Creepage) -> f64 {
        self.law(creepage).adhesion()
    }

    fn law(&self, creepage: Creepage) -> Cubic {
        let Creepage { xi, eta, .. } = bounded(creepage);
        Cubic::new([self.gains[0] * xi, self.gains[1] * eta])
    }

    /// Slip in the slip area, at `(x/a, y/b)`.
    fn slip(&self, law: Cubic, creepage: Creepage, [x, y]: [f64; 2]) -> [f64; 2] {
        let size = law.adhesion();
        let whole = self.inside_gradient(law, [x, y]);
        let relief = if size > 0.0 {
            self.outside_gradient(law, cubic::inner(size, [x, y]).map(|q| q / size))
        } else {
            [0.0; 2]
        };
        let rigid = [creepage.xi, creepage.eta];
        [0, 1].map(|i| rigid[i] + (whole[i] - size * relief[i]) / self.slip_unit)
    }

    /// `d(u, v)/dx` in the contact due to the traction `(1 - r^2)^(1/2)` over `G`, in the force's
    /// direction: linear in `x/a` and `y/b`.
    fn inside_gradient(&self, law: Cubic, [x, y]: [f64; 2]) -> [f64; 2] {
        let [nx, ny] = law.direction();
        let cross = 2.0
            * self.contact.poisson()
            * self.contact.ellipse().b()
            * self.contact.ellipse().integrals().c
            / self.contact.ellipse().major().powi(3);
        [-2.0 * self.phi * nx * x + cross * ny * y, cross * nx * y - 2.0 * self.psi * ny * x]
    }

    /// The same outside the contact, by quadrature over the chords through the point.
    fn outside_gradient(&self, law: Cubic, [x, y]: [f64; 2]) -> [f64; 2] {
        let distance = x.hypot(y).max(1.0);
        let (b, [nx, ny]) = (self.contact.ellipse().b(), law.direction());
        let mut gradient = [0.0; 2];
        for chord in self.chords.through([-x / distance, -y / distance], distance.recip()) {
            let [c, s] = chord.direction;
            let share = b / distance * chord.weight * chord.offset * chord.circle[1] * chord.per_q;
            let along = self.contact.poisson() * (c * ny - s * nx);
            gradient[0] += share * (nx + along * s);
            gradient[1] += share * (ny - along * c);
        }
        gradient
    }
}

impl Theory for VermeulenJohnson {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        let [fx, fy] = self.law(creepage).force();
        let status = if creepage.chi == 0.0 { Status::Solved } else { Status::SpinTooLarge };
        Solution::closed_form(Force { fx, fy, mz: 0.0 }, status)
    }

    /// The slip is that of the tractions, from the half-space's response; spin is ignored.
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        let (law, creepage) = (self.law(creepage), bounded(creepage));
        let point = |&position: &[f64; 2]| {
            let still = [0.0; 2];
            match law.traction(self.contact.ellipse(), position) {
                None => FieldPoint::outside(position),
                Some((traction, true)) => {
                    FieldPoint { position, traction, slip: still, region: Region::Adhesion }
                }
                Some((traction, false)) => {
                    let [x, y] = [
                        position[0] / self.contact.ellipse().a(),
                        position[1] / self.contact.ellipse().b(),
                    ];
                    let slip = self.slip(law, creepage, [x, y]);
                    FieldPoint { position, traction, slip, region: Region::Slip }
                }
            }
        };
        positions.iter().map(point).collect()
    }

    /// Derivative of `(f_x, f_y, m_z)` (rows) by `(xi, eta, chi)` (columns).
    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        let law = self.law(creepage);
        let [by_xi, by_eta] = [[self.gains[0], 0.0], [0.0, self.gains[1]]];
        let [[xx, yx], [xy, yy]] = [by_xi, by_eta].map(|dp| law.force_change(dp));
        Some([[xx, xy, 0.0], [yx, yy, 0.0], [0.0; 3]])
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Stateless::boxed(self, creepage)
    }
}
