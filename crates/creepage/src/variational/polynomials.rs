//! The solution as polynomials in the monomials of the thesis.

use super::Variational;
use crate::Creepage;
use crate::ellipse::Ellipse;
use crate::halfspace::{Polynomial, PolynomialError};

impl Variational {
    /// The traction polynomials `X'`, `Y'` of a solution, with the major semi-axis as unit of
    /// length, as the thesis prints them (TAU).
    ///
    /// # Errors
    /// [`PolynomialError`] when `tau` is not of this theory's degree, or not finite.
    pub fn traction_polynomials(&self, tau: &[f64]) -> Result<[Polynomial; 2], PolynomialError> {
        let unit = self.in_major_axes()?;
        let (x, y) = tau.split_at(tau.len() / 2);
        Ok([Polynomial::from_harmonics(unit, x)?, Polynomial::from_harmonics(unit, y)?])
    }

    /// The unknowns of given traction polynomials, in the order of
    /// [`VariationalSolution::tau`](super::VariationalSolution::tau): starting values (5.21 h).
    /// A polynomial below the theory's degree is filled up with zeros, one above it is cut.
    ///
    /// # Errors
    /// [`PolynomialError`] as of an ellipse too slender for its semi-axes to be finite.
    pub fn unknowns_of(&self, [x, y]: &[Polynomial; 2]) -> Result<Vec<f64>, PolynomialError> {
        let unit = self.in_major_axes()?;
        let half = self.mesh.unknowns() / 2;
        let mut tau = Vec::with_capacity(2 * half);
        for polynomial in [x, y] {
            let mut harmonics = polynomial.to_harmonics(unit);
            harmonics.resize(half, 0.0);
            tau.append(&mut harmonics);
        }
        Ok(tau)
    }

    /// The slip polynomials `P`, `Q` of a solution in units of `mu f00`, rigid slip included,
    /// with the major semi-axis as unit of length, as the thesis prints them (UVX).
    ///
    /// # Errors
    /// [`PolynomialError`] when `tau` is not of this theory's degree, or not finite.
    pub fn slip_polynomials(
        &self,
        creepage: Creepage,
        tau: &[f64],
    ) -> Result<[Polynomial; 2], PolynomialError> {
        if tau.len() != self.mesh.unknowns() {
            return Err(PolynomialError::Count { given: tau.len() / 2 });
        }
        let unit = self.in_major_axes()?;
        let [p, q] = self.response.slip(tau);
        let [p, q] = [Polynomial::from_harmonics(unit, &p)?, Polynomial::from_harmonics(unit, &q)?];
        let scale = self.slip_scale();
        let spin = scale * creepage.chi * self.ellipse().major();
        let [mut p, mut q] = [p, q].map(|polynomial| polynomial.coefficients().to_vec());
        p[Polynomial::index(0, 0)] += scale * creepage.xi;
        p[Polynomial::index(0, 1)] -= spin;
        q[Polynomial::index(0, 0)] += scale * creepage.eta;
        q[Polynomial::index(1, 0)] += spin;
        Ok([Polynomial::new(p)?, Polynomial::new(q)?])
    }

    /// Coefficients `tau_k` of (5.1): of `X'`, then of `Y'`.
    pub(super) fn monomials(&self, tau: &[f64]) -> Vec<f64> {
        self.traction_polynomials(tau)
            .map(|polynomials| polynomials.iter().flat_map(|p| p.coefficients().to_vec()).collect())
            .unwrap_or_default()
    }

    fn in_major_axes(&self) -> Result<Ellipse, PolynomialError> {
        let ellipse = self.response.ellipse();
        let major = ellipse.major();
        Ok(Ellipse::new(ellipse.a() / major, ellipse.b() / major)?)
    }
}
