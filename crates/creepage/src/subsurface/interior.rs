//! Interior field of one body under the tractions on its surface.

use std::f64::consts::PI;

use rayon::prelude::*;

use super::edges::Edges;
use super::element::Element;
use super::far::PointForces;
use super::stress::Stress;
use super::tree::Tree;
use super::waves::Waves;
use crate::check::{self, InvalidValue};
use crate::halfspace::{Edge, Polynomial, PolynomialError, Traction};
use crate::hertz::Hertz;
use crate::solid::Solid;

/// One of the two bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Body {
    /// The body into which `z` points; tractions act on it as they are given.
    #[default]
    Lower,
    /// The body above; the reactions act on it, and its `z` points upwards, into it.
    Upper,
}

impl Body {
    /// Signs of `[X, Y, Z]` on the body, in its own frame.
    pub(super) fn signs(self) -> [f64; 3] {
        match self {
            Self::Lower => [1.0, 1.0, 1.0],
            Self::Upper => [-1.0, -1.0, 1.0],
        }
    }
}

/// Error of a field inside a body.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InteriorError {
    /// A number is outside its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// A traction has no finite coefficients.
    #[error(transparent)]
    Polynomial(#[from] PolynomialError),
}

/// The elastic field inside one body: prepared from tractions, asked at points.
///
/// Error beside the largest traction: below 1e-12 for polynomial tractions on ellipses down to
/// `a/b = 1e-3`, rounding for elements. A point costs some 10 us for a polynomial traction (some
/// 100 us close to its edge), and some 60 ns a side for elements. [`Interior::at`] takes elements far from a
/// point together: some microseconds for thousands of elements.
#[derive(Debug, Clone)]
pub struct Interior {
    solid: Solid,
    body: Body,
    waves: Vec<Waves>,
    edges: Edges,
    /// The elements seen from far away.
    far: PointForces,
    /// The elements in boxes, those far from a point taken together.
    tree: Tree,
}

/// Stress and displacement at one point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Inside {
    /// The stress.
    pub stress: Stress,
    /// Displacement `[u, v, w]` in the body's own frame.
    pub displacement: [f64; 3],
}

impl Interior {
    /// The body without tractions.
    #[must_use]
    pub fn new(solid: Solid, body: Body) -> Self {
        Self {
            solid,
            body,
            waves: vec![],
            edges: Edges::default(),
            far: PointForces::default(),
            tree: Tree::default(),
        }
    }

    /// Hertz's pressure with `X = friction[0] Z` and `Y = friction[1] Z`, which the upper body
    /// exerts on the lower sliding without spin.
    ///
    /// # Errors
    /// [`InteriorError`] unless both friction coefficients are finite.
    pub fn sliding(
        contact: &Hertz,
        friction: [f64; 2],
        solid: Solid,
        body: Body,
    ) -> Result<Self, InteriorError> {
        let constant = |value: f64| Polynomial::new(vec![value]);
        let [x, y, z] = [constant(friction[0])?, constant(friction[1])?, constant(1.0)?];
        let traction = Traction::new(contact.ellipse(), Edge::Vanishing, [&x, &y, &z])?;
        Ok(Self::new(solid, body).with_traction(&traction, contact.peak_pressure())?)
    }

    /// Adds a polynomial traction on the ellipse, given in parts of `unit`: the combined shear
    /// modulus for tractions of [`crate::halfspace`].
    ///
    /// # Errors
    /// [`InvalidValue`] unless `unit` is finite.
    pub fn with_traction(mut self, traction: &Traction, unit: f64) -> Result<Self, InvalidValue> {
        check::finite("unit", unit)?;
        self.waves.push(Waves::new(traction, self.body.signs().map(|sign| sign * unit)));
        Ok(self)
    }

    /// Gives the body constant tractions on elements, in place of any that it had. At the sides of
    /// elements stresses grow logarithmically towards the surface, as they must under a traction
    /// that jumps: half an element below they have settled.
    #[must_use]
    pub fn with_elements(mut self, elements: &[Element]) -> Self {
        let signs = self.body.signs();
        self.far = PointForces::of_elements(elements, signs);
        self.tree = Tree::new(elements, signs);
        self.edges = Edges::new(elements.iter().flat_map(|element| element.sides(signs)));
        self
    }

    /// The body.
    #[must_use]
    pub fn body(&self) -> Body {
        self.body
    }

    /// Its material.
    #[must_use]
    pub fn solid(&self) -> Solid {
        self.solid
    }

    /// Stress and displacement at `[x, y, z]` by what [`Interior::stress`] and
    /// [`Interior::displacement`] add up element by element, but with the elements far from the point
    /// taken together.
    ///
    /// At 10,000 random points below rolling contacts both ways agree to 1e-5 of the largest traction, on
    /// the surface, at the edge and far away, and to 1e-4 below elements whose tractions have no order
    /// at all; displacements to a tenth of that. The same point has the same field, to the last bit, whichever
    /// points are asked with it.
    ///
    /// ```
    /// use creepage::Solid;
    /// use creepage::subsurface::{Body, Element, Interior};
    /// let at = |k: u32| [f64::from(k % 40), f64::from(k / 40)].map(|x| 1e-4 * x);
    /// let square = |k| Element::rectangle(at(k), [1e-4; 2], [0.0, 0.0, 1e9]);
    /// let squares = (0..1600).map(square).collect::<Result<Vec<_>, _>>()?;
    /// let rail = Interior::new(Solid::new(82e9, 0.28)?, Body::Lower).with_elements(&squares);
    /// let point = [2e-3, 2e-3, 1e-3];
    /// let [near, all] = [rail.at(point)?.stress, rail.stress(point)?].map(|stress| stress.zz);
    /// assert!((near / all - 1.0).abs() < 1e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As of [`Interior::stress`].
    pub fn at(&self, point: [f64; 3]) -> Result<Inside, InvalidValue> {
        check_point(point)?;
        let poisson = self.solid.poisson();
        let mut sum = [0.0; 9];
        if self.far.is_far(point) {
            sum[..6].copy_from_slice(&self.far.stress(point, poisson));
            sum[6..].copy_from_slice(&self.far.displacement(point, poisson));
        } else if !self.tree.is_empty() {
            sum = self.tree.field(point, poisson);
        }
        for waves in &self.waves {
            let part = waves.field(point, poisson);
            sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
        let [xx, yy, zz, xy, yz, xz, u, v, w] = sum.map(|value| value / (4.0 * PI));
        let stress = Stress::from_components([xx, yy, zz, xy, yz, xz]);
        Ok(Inside { stress, displacement: [u, v, w].map(|part| part / self.solid.shear_modulus()) })
    }

    /// The same at many points on all cores, in their order.
    ///
    /// # Errors
    /// As of [`Interior::stress`].
    pub fn at_all(&self, points: &[[f64; 3]]) -> Result<Vec<Inside>, InvalidValue> {
        points.par_iter().map(|point| self.at(*point)).collect()
    }

    /// Stress at `[x, y, z]`, `z` into the body; on the surface, the limit from inside.
    ///
    /// # Errors
    /// [`InvalidValue`] unless the coordinates are finite and `z` is not negative.
    pub fn stress(&self, point: [f64; 3]) -> Result<Stress, InvalidValue> {
        check_point(point)?;
        let poisson = self.solid.poisson();
        let mut sum = if self.far.is_far(point) {
            self.far.stress(point, poisson)
        } else {
            self.edges.stress(point, poisson)
        };
        for waves in &self.waves {
            let part = waves.stress(point, poisson);
            sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
        Ok(Stress::from_components(sum.map(|value| value / (4.0 * PI))))
    }

    /// Displacement `[u, v, w]` at `[x, y, z]`, all in the body's own frame: `w` is positive into
    /// the body. It vanishes far away.
    ///
    /// # Errors
    /// As of [`Interior::stress`].
    pub fn displacement(&self, point: [f64; 3]) -> Result<[f64; 3], InvalidValue> {
        check_point(point)?;
        let poisson = self.solid.poisson();
        let mut sum = if self.far.is_far(point) {
            self.far.displacement(point, poisson)
        } else {
            self.edges.displacement(point, poisson)
        };
        for waves in &self.waves {
            let part = waves.displacement(point, poisson);
            sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
        Ok(sum.map(|value| value / (4.0 * PI * self.solid.shear_modulus())))
    }

    /// Strain at `[x, y, z]`, `xy` being half the change of the angle.
    ///
    /// # Errors
    /// As of [`Interior::stress`].
    pub fn strain(&self, point: [f64; 3]) -> Result<Stress, InvalidValue> {
        Ok(self.stress(point)?.strain(self.solid))
    }
}

fn check_point([x, y, z]: [f64; 3]) -> Result<(), InvalidValue> {
    check::finite("x", x)?;
    check::finite("y", y)?;
    check::require(z.is_finite() && z >= 0.0, "z", z, "finite and not negative: into the body")?;
    Ok(())
}
