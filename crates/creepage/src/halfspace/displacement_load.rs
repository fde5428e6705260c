//! The load-displacement equations solved for the traction: 2.4 and 3.1 read backwards.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::load_displacement::of_degree;
use super::{Edge, LoadDisplacement, Polynomial, ResponseError, Traction, harmonics, vanishing};

/// The tractions that cause given displacement differences inside the ellipse.
///
/// The equations are symmetric (Betti) and positive (elastic energy), so every block has a
/// Cholesky factor; it is prepared once.
///
/// ```
/// use creepage::Ellipse;
/// use creepage::halfspace::{LoadDisplacement, Polynomial};
/// // The traction that shifts the unit circle by 1 along x: F_x = 2 G / (1 - sigma/2).
/// let response = LoadDisplacement::new(Ellipse::new(1.0, 1.0)?, 0.25, 0)?;
/// let (one, zero) = (Polynomial::new(vec![1.0])?, Polynomial::zero(0));
/// let traction = response.inverse()?.singular([&one, &zero, &zero])?;
/// assert!((traction.resultants().fx - 2.0 / 0.875).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct DisplacementLoad {
    response: LoadDisplacement,
    tangential: Vec<Cholesky<f64, Dyn>>,
    normal: Vec<Cholesky<f64, Dyn>>,
}

impl LoadDisplacement {
    /// Prepares the equations for the opposite direction.
    ///
    /// # Errors
    /// [`ResponseError::Singular`] when rounding has spoilt a block, which takes an extreme
    /// ellipse and degree.
    pub fn inverse(&self) -> Result<DisplacementLoad, ResponseError> {
        let (mut tangential, mut normal) = (vec![], vec![]);
        for (degree, block) in self.blocks().iter().enumerate() {
            let singular = ResponseError::Singular { degree };
            let n = degree + 1;
            let mut both = DMatrix::zeros(2 * n, 2 * n);
            both.view_mut((0, 0), (n, n)).copy_from(&block.ux);
            both.view_mut((n, 0), (n, n)).copy_from(&block.uy);
            both.view_mut((0, n), (n, n)).copy_from(&block.uy);
            both.view_mut((n, n), (n, n)).copy_from(&block.vy);
            tangential.push(Cholesky::new(both).ok_or_else(|| singular.clone())?);
            normal.push(Cholesky::new(block.wz.clone()).ok_or(singular)?);
        }
        Ok(DisplacementLoad { response: self.clone(), tangential, normal })
    }
}

impl DisplacementLoad {
    /// Harmonics of the singular traction `[X, Y]` that causes `[u, v]`; tables as in
    /// [`LoadDisplacement::tangential`], whose inverse this is.
    #[must_use]
    pub fn tangential(&self, [u, v]: [&[f64]; 2]) -> [Vec<f64>; 2] {
        let mut traction = [vec![], vec![]];
        for (n, factor) in self.tangential.iter().enumerate() {
            let (u, v) = (of_degree(u, n), of_degree(v, n));
            let solution =
                factor.solve(&DVector::from_iterator(2 * n + 2, u.iter().chain(&v).copied()));
            traction[0].extend(solution.rows(0, n + 1).iter());
            traction[1].extend(solution.rows(n + 1, n + 1).iter());
        }
        traction
    }

    /// Harmonics of the singular pressure `Z` that causes `w`.
    #[must_use]
    pub fn normal(&self, w: &[f64]) -> Vec<f64> {
        let mut pressure = vec![];
        for (n, factor) in self.normal.iter().enumerate() {
            pressure.extend(factor.solve(&of_degree(w, n)).iter());
        }
        pressure
    }

    /// The traction, singular at the edge, that causes the displacement differences
    /// `[u, v, w]`: it always exists (2.22).
    ///
    /// # Errors
    /// [`ResponseError`] when a degree is higher than prepared, or on overflow.
    pub fn singular(&self, displacement: [&Polynomial; 3]) -> Result<Traction, ResponseError> {
        let tables = self.solve(displacement.map(|p| p.to_harmonics(self.response.ellipse())))?;
        Ok(Traction::from_harmonics(self.response.ellipse(), Edge::Singular, tables)?)
    }

    /// The traction, vanishing at the edge, that causes `[u, v, w]`, of two degrees less than
    /// these: the rectangular system of 3.1. It exists for special displacements only.
    ///
    /// # Errors
    /// [`ResponseError::Unreachable`] when there is none, to one part in 1e9; otherwise
    /// as [`DisplacementLoad::singular`].
    pub fn vanishing(&self, displacement: [&Polynomial; 3]) -> Result<Traction, ResponseError> {
        const REACHED: f64 = 1e-9;
        let ellipse = self.response.ellipse();
        let wanted = displacement.map(|p| p.to_harmonics(ellipse));
        let singular = self.solve(wanted.clone())?;
        let quotient = singular
            .map(|table| vanishing::from_singular(harmonics::degree_of(table.len()), &table));
        let traction = Traction::from_harmonics(ellipse, Edge::Vanishing, quotient)?;
        let residual = self.residual(&traction, &wanted);
        if residual <= REACHED {
            Ok(traction)
        } else {
            Err(ResponseError::Unreachable { residual })
        }
    }

    fn solve(&self, [u, v, w]: [Vec<f64>; 3]) -> Result<[Vec<f64>; 3], ResponseError> {
        let longest = u.len().max(v.len()).max(w.len());
        let degree = harmonics::degree_of(longest);
        self.response.check(self.response.ellipse(), degree)?;
        let [mut x, mut y] = self.tangential([&u, &v]);
        let mut z = self.normal(&w);
        for table in [&mut x, &mut y, &mut z] {
            table.truncate(harmonics::polynomial_count(degree));
        }
        Ok([x, y, z])
    }

    /// By how much a traction misses the wanted displacement, relative to its size.
    fn residual(&self, traction: &Traction, wanted: &[Vec<f64>; 3]) -> f64 {
        let [x, y, z] = traction.singular();
        let [u, v] = self.response.tangential([x, y]);
        let reached = [u, v, self.response.normal(z)];
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let size = largest(&mut wanted.iter().flatten().map(|value| value.abs()));
        let miss = largest(&mut reached.iter().zip(wanted).flat_map(|(reached, wanted)| {
            let wanted = wanted.iter().chain(std::iter::repeat(&0.0));
            reached.iter().zip(wanted).map(|(reached, wanted)| (reached - wanted).abs())
        }));
        if size == 0.0 { 0.0 } else { miss / size }
    }
}
