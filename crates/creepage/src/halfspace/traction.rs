//! Tractions on an ellipse: a polynomial times the square root that rules the edge.

use std::f64::consts::TAU;

use super::polynomial::{Polynomial, PolynomialError};
use super::{harmonics, vanishing};
use crate::ellipse::Ellipse;

/// Asymptotic behaviour of a traction at the edge of the contact, `r^2 = (x/a)^2 + (y/b)^2 = 1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Edge {
    /// `(1 - r^2)^(-1/2)` times a polynomial: chapter 2, contact without slip, sharp dies.
    Singular,
    /// `(1 - r^2)^(1/2)` times a polynomial: chapter 3, as Hertz's pressure.
    Vanishing,
}

/// Force and moment of a [`Traction`], over `G`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Resultants {
    /// `F_x` over `G` [length^2].
    pub fx: f64,
    /// `F_y` over `G` [length^2].
    pub fy: f64,
    /// Normal force `N` over `G` [length^2].
    pub n: f64,
    /// Moment `M_z` about the centre, the integral of `x Y - y X`, over `G` [length^3].
    pub mz: f64,
}

/// A traction `[X, Y, Z]` over `G`, exerted on the lower body.
#[derive(Debug, Clone, PartialEq)]
pub struct Traction {
    ellipse: Ellipse,
    edge: Edge,
    degree: usize,
    harmonics: [Vec<f64>; 3],
    singular: [Vec<f64>; 3],
}

impl Traction {
    /// The traction whose components are `(1 - r^2)^(-1/2)` or `(1 - r^2)^(1/2)` times
    /// `polynomials` `[X, Y, Z]`: (2.32), (3.3).
    ///
    /// # Errors
    /// [`PolynomialError`] when a coefficient overflows in the harmonics of the ellipse.
    ///
    /// ```
    /// use creepage::Ellipse;
    /// use creepage::halfspace::{Edge, Polynomial, Traction};
    /// let (none, f00) = (Polynomial::zero(0), Polynomial::new(vec![0.1])?);
    /// let hertz = Traction::new(Ellipse::new(2.0, 1.0)?, Edge::Vanishing, [&none, &none, &f00])?;
    /// let n = 2.0 / 3.0 * std::f64::consts::PI * 2.0 * 0.1; // (3.43)
    /// assert!((hertz.resultants().n - n).abs() < 1e-15);
    /// assert!((hertz.at([1.2, 0.0])[2] - 0.08).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        ellipse: Ellipse,
        edge: Edge,
        polynomials: [&Polynomial; 3],
    ) -> Result<Self, PolynomialError> {
        Self::from_harmonics(ellipse, edge, polynomials.map(|p| p.to_harmonics(ellipse)))
    }

    /// The traction whose polynomials have these coefficients in the harmonics of the ellipse,
    /// in the order of [`harmonics::even_indices`].
    ///
    /// # Errors
    /// [`PolynomialError`] when a number of coefficients fits no degree, or a coefficient is
    /// not finite.
    pub fn from_harmonics(
        ellipse: Ellipse,
        edge: Edge,
        coefficients: [Vec<f64>; 3],
    ) -> Result<Self, PolynomialError> {
        let mut degree = 0;
        for table in &coefficients {
            degree = degree.max(Polynomial::new(table.clone())?.degree());
        }
        let harmonics = coefficients.map(|mut table| {
            table.resize(harmonics::polynomial_count(degree), 0.0);
            table
        });
        let singular = match edge {
            Edge::Singular => harmonics.clone(),
            Edge::Vanishing => harmonics.clone().map(|p| vanishing::as_singular(degree, &p)),
        };
        Ok(Self { ellipse, edge, degree, harmonics, singular })
    }

    /// The ellipse that the traction acts on.
    #[must_use]
    pub fn ellipse(&self) -> Ellipse {
        self.ellipse
    }

    /// The behaviour at the edge.
    #[must_use]
    pub fn edge(&self) -> Edge {
        self.edge
    }

    /// Degree of the polynomials.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The polynomials' coefficients in harmonics.
    #[must_use]
    pub fn harmonics(&self) -> [&[f64]; 3] {
        self.harmonics.each_ref().map(Vec::as_slice)
    }

    /// The polynomials in `x`, `y`; see [`Polynomial::from_harmonics`] for their accuracy.
    ///
    /// # Errors
    /// [`PolynomialError`] when a coefficient overflows.
    pub fn polynomials(&self) -> Result<[Polynomial; 3], PolynomialError> {
        let [x, y, z] = self.harmonics();
        let polynomial = |table| Polynomial::from_harmonics(self.ellipse, table);
        Ok([polynomial(x)?, polynomial(y)?, polynomial(z)?])
    }

    /// Degree of the same traction written as `(1 - r^2)^(-1/2)` times polynomials, which is
    /// that of the displacement differences.
    #[must_use]
    pub fn singular_degree(&self) -> usize {
        match self.edge {
            Edge::Singular => self.degree,
            Edge::Vanishing => self.degree + 2,
        }
    }

    /// Coefficients of the same traction written as `(1 - r^2)^(-1/2)` times polynomials.
    #[must_use]
    pub fn singular(&self) -> [&[f64]; 3] {
        self.singular.each_ref().map(Vec::as_slice)
    }

    /// `[X, Y, Z]` over `G` at `[x, y]`; zero outside the ellipse and on its edge.
    #[must_use]
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let point = [x / self.ellipse.a(), y / self.ellipse.b()];
        let square = (1.0 - point[0].hypot(point[1])) * (1.0 + point[0].hypot(point[1]));
        if square.is_nan() || square <= 0.0 {
            return [0.0; 3];
        }
        let factor = match self.edge {
            Edge::Singular => square.sqrt().recip(),
            Edge::Vanishing => square.sqrt(),
        };
        harmonics::sum(self.degree, point, self.harmonics()).map(|value| factor * value)
    }

    /// Forces and moment over `G`: the harmonics of degree zero and one.
    #[must_use]
    pub fn resultants(&self) -> Resultants {
        let area = self.ellipse.a() * self.ellipse.b();
        let [x, y, z] = self.singular();
        let coefficient =
            |table: &[f64], n, m| table.get(harmonics::position(n, m)).copied().unwrap_or(0.0);
        let force = |table| area * TAU.sqrt() * coefficient(table, 0, 0);
        let arm =
            self.ellipse.a() * coefficient(y, 1, 1) - self.ellipse.b() * coefficient(x, 1, -1);
        Resultants { fx: force(x), fy: force(y), n: force(z), mz: area * (TAU / 3.0).sqrt() * arm }
    }

    /// The derivative `d/dx` of a traction that vanishes at the edge: it is singular there, and
    /// causes the derivative of the displacement differences, hence the slip of steady rolling.
    /// `None` for a traction that is singular already: it would not be integrable.
    #[must_use]
    pub fn x_derivative(&self) -> Option<Self> {
        if self.edge == Edge::Singular {
            return None;
        }
        let harmonics = self.harmonics().map(|p| {
            let mut slope = vanishing::x_derivative(self.degree, p);
            for value in &mut slope {
                *value /= self.ellipse.a();
            }
            slope
        });
        Self::from_harmonics(self.ellipse, Edge::Singular, harmonics).ok()
    }
}
