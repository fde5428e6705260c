//! Elastic energy lost at the trailing edge, the paradox of 4.3: without slip anywhere the linear theory dissipates, for
//! the traction of its bodies is infinite at that edge.

use std::f64::consts::{FRAC_PI_2, PI};
use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;

use super::traction::Traction;
use super::{Linear, bounded, slip_unit};
use crate::{Creepage, Theory};

/// Quadrature points on each half of the edge, beyond the degree of the strengths.
const EDGE_POINTS: usize = 300;

/// Elastic energy that the bodies lose at the edge of the contact per length rolled, in units of
/// `mu N mu c/rho`, as power is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgeEnergy {
    /// At the trailing edge.
    pub trailing: f64,
    /// At the leading edge: of the finite degree alone, as the traction is finite there (4.35).
    pub leading: f64,
}

impl EdgeEnergy {
    /// Of the whole edge.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.trailing + self.leading
    }
}

impl Linear {
    /// The elastic energy that is lost at the edge, per length rolled.
    ///
    /// Inside the edge the traction is `(X', Y')/(B sqrt u)` (4.40), (4.53), at the distance `u`; outside the
    /// slip is that of (4.41), whose integral opens the surfaces by `sqrt(u')`. Closing the one by the other
    /// over a small advance of the edge (Irwin) gives, for each area swept by the edge,
    ///
    /// ```math
    /// \frac{\pi}{G B^2} \left[ X'^2 + Y'^2 - \sigma (X' \cos\psi + Y' \sin\psi)^2 \right]
    /// ```
    ///
    /// with `psi` the direction of the inner normal; rolling by `dx` sweeps `dx dy`. It equals force times
    /// creepage, `F_x upsilon_x + F_y upsilon_y + M_z phi`: what the theory dissipates though nothing slips.
    ///
    /// ```
    /// use creepage::approximate::linear::Linear;
    /// use creepage::{Contact, Creepage, Ellipse, Theory};
    /// let linear = Linear::new(&Contact::new(Ellipse::from_ratio(1.5)?, 0.28)?)?;
    /// let creepage = Creepage::new(0.02, 0.01, 0.03)?;
    /// let power = linear.solved(creepage).power();
    /// let energy = linear.edge_energy(creepage);
    /// assert!((energy.trailing / power - 1.0).abs() < 1e-5);
    /// assert!(energy.leading.abs() < 1e-5 * power);
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    #[must_use]
    pub fn edge_energy(&self, creepage: Creepage) -> EdgeEnergy {
        let traction = self.traction_at(creepage);
        let mut density = self.density(&traction);
        let rule = GaussLegendre::new(NonZeroUsize::MIN.saturating_add(EDGE_POINTS));
        // Each half of the edge from one end of the axis b to the other; dy = b |cos t| dt.
        let mut half = |centre: f64| -> f64 {
            let point = |&(node, weight): &(f64, f64)| {
                let t = centre + FRAC_PI_2 * node;
                FRAC_PI_2 * weight * t.cos().abs() * density(t)
            };
            rule.iter().map(point).sum()
        };
        EdgeEnergy { trailing: half(PI), leading: -half(0.0) }
    }

    /// The energy lost at the point `y` of the trailing edge, per length rolled and per length of `y/b`.
    ///
    /// `y_over_b` lies between -1 and 1; the density is zero beyond.
    #[must_use]
    pub fn edge_energy_density(&self, creepage: Creepage, y_over_b: f64) -> f64 {
        if y_over_b.is_nan() || y_over_b.abs() >= 1.0 {
            return 0.0;
        }
        let traction = self.traction_at(creepage);
        let mut density = self.density(&traction);
        density(PI - y_over_b.asin())
    }

    fn traction_at(&self, creepage: Creepage) -> Traction {
        let Creepage { xi, eta, chi } = bounded(creepage);
        Traction::sum(&self.tractions(), [xi, eta, chi])
    }

    /// At `(a cos t, b sin t)`, per length of `y/b`.
    fn density(&self, traction: &Traction) -> impl FnMut(f64) -> f64 {
        let (ellipse, poisson) = (self.contact().ellipse(), self.contact().poisson());
        let (a, b) = (ellipse.a(), ellipse.b());
        // Of (4.17) and (4.21): forces over mu N, creepage over its unit, G = 1.
        let unit = 3.0 / (2.0 * PI) / slip_unit(ellipse, poisson);
        let mut strength = traction.on_edge();
        move |t| {
            let (sin, cos) = t.sin_cos();
            // The gradient of r^2/2; B^2 is twice its size.
            let (along, across) = (cos / a, sin / b);
            let size = along.hypot(across);
            let [x, y] = strength(t);
            let normal = (x * along + y * across) / size;
            unit * b * PI / (2.0 * size) * (x * x + y * y - poisson * normal * normal)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Contact, Ellipse};

    #[test]
    fn what_is_lost_at_the_edge_is_force_times_creepage() {
        for (a_over_b, poisson) in
            [(0.2, 0.0), (0.5, 0.28), (1.0, 0.28), (1.0, 0.5), (3.0, 0.3), (5.0, 0.5)]
        {
            let contact = Contact::new(Ellipse::from_ratio(a_over_b).unwrap(), poisson).unwrap();
            let linear = Linear::new(&contact).unwrap();
            for [xi, eta, chi] in
                [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.3, -0.5, 0.7]]
            {
                let creepage = Creepage::new(xi, eta, chi).unwrap();
                let (power, energy) =
                    (linear.solved(creepage).power(), linear.edge_energy(creepage));
                // The coefficients are interpolated to 1e-6, and at finite degree C23 and -C32 differ by
                // as much.
                assert!(
                    (energy.total() / power - 1.0).abs() < 5e-6,
                    "{a_over_b} {poisson}: {energy:?} {power}"
                );
                assert!(energy.leading.abs() < 5e-6 * power, "{a_over_b} {poisson}: {energy:?}");
            }
        }
    }

    #[test]
    fn the_density_sums_up() {
        let contact = Contact::new(Ellipse::from_ratio(2.0).unwrap(), 0.28).unwrap();
        let linear = Linear::new(&contact).unwrap();
        let creepage = Creepage::new(0.2, 0.3, 0.4).unwrap();
        let points = 4000;
        let sum: f64 = (0..points)
            .map(|k| (2.0 * (f64::from(k) + 0.5) / f64::from(points)) - 1.0)
            .map(|y| linear.edge_energy_density(creepage, y) * 2.0 / f64::from(points))
            .sum();
        // The midpoint rule beside the root at both ends: its error is of the power 3/2 of the step.
        assert!((sum / linear.edge_energy(creepage).trailing - 1.0).abs() < 1e-4);
        assert!(linear.edge_energy_density(creepage, 1.5).abs() < f64::MIN_POSITIVE);
    }
}
