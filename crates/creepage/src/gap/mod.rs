//! Undeformed distance `h(x, y)` of two bodies in the plane of contact: what Hertz takes as `A x^2 + B y^2`, here of any
//! shape.
//!
//! `x` is the rolling direction and `y` the direction across it; lengths are in metres. Pressed
//! together by the approach `delta`, undeformed bodies would penetrate by `delta - h`, with `h`
//! as given: its least value need not be zero.

mod cubic;
mod error;
mod grid;
mod polynomial;
mod reach;
mod section;
mod turned;
mod wells;

use std::fmt;
use std::sync::Arc;

pub use error::GapError;
pub use polynomial::Term;
pub use section::Rolling;

pub(crate) use cubic::Cubic;
pub(crate) use grid::in_rows;

use grid::Grid;
use polynomial::Polynomial;
use section::Section;
use turned::Turned;

/// A rectangle with sides along x and y (m); infinite where nothing bounds it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// Least and greatest x.
    pub x: [f64; 2],
    /// Least and greatest y.
    pub y: [f64; 2],
}

impl Rectangle {
    /// The whole plane.
    pub const PLANE: Self =
        Self { x: [f64::NEG_INFINITY, f64::INFINITY], y: [f64::NEG_INFINITY, f64::INFINITY] };

    /// Lengths along x and y (m).
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        [self.x[1] - self.x[0], self.y[1] - self.y[0]]
    }

    /// The part that lies in `other` too.
    #[must_use]
    pub fn within(&self, other: &Self) -> Self {
        let part = |one: [f64; 2], other: [f64; 2]| [one[0].max(other[0]), one[1].min(other[1])];
        Self { x: part(self.x, other.x), y: part(self.y, other.y) }
    }

    /// Whether a place lies in it.
    pub(crate) fn holds(&self, [x, y]: [f64; 2]) -> bool {
        self.x[0] <= x && x <= self.x[1] && self.y[0] <= y && y <= self.y[1]
    }

    /// The smallest rectangle that holds both.
    pub(crate) fn around(&self, other: &Self) -> Self {
        let part = |one: [f64; 2], other: [f64; 2]| [one[0].min(other[0]), one[1].max(other[1])];
        Self { x: part(self.x, other.x), y: part(self.y, other.y) }
    }
}

/// The undeformed distance of two bodies. Two are equal if they are made of the same numbers;
/// functions are known to be equal only if one is a clone of the other.
///
/// ```
/// use creepage::gap::{Gap, Rolling, Term};
/// // A wheel of radius 0.46 m on a rail head of radius 0.30 m, as a polynomial ...
/// let term = |x, y, coefficient| Term { x, y, coefficient };
/// let exact = Gap::polynomial(&[term(2, 0, 0.5 / 0.46), term(0, 2, 0.5 / 0.30)])?;
/// // ... and as a section measured at a few points.
/// let y: Vec<f64> = (-6..=6).map(|i| f64::from(i) * 2e-3).collect();
/// let h: Vec<f64> = y.iter().map(|y| y * y / 0.6).collect();
/// let measured = Gap::section(&y, &h, Rolling::Radius(0.46))?;
/// assert!((exact.at(2e-3, 3e-3) - measured.at(2e-3, 3e-3)).abs() < 1e-15);
/// # Ok::<(), creepage::gap::GapError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Gap {
    shape: Shape,
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Polynomial(Polynomial),
    Section(Section),
    Grid(Grid),
    Function(Function),
    Turned(Box<Turned>),
}

#[derive(Clone)]
struct Function {
    domain: Rectangle,
    at: Arc<dyn Fn(f64, f64) -> f64 + Send + Sync>,
}

impl PartialEq for Function {
    fn eq(&self, other: &Self) -> bool {
        self.domain == other.domain && Arc::ptr_eq(&self.at, &other.at)
    }
}

impl fmt::Debug for Function {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Function").field("domain", &self.domain).finish_non_exhaustive()
    }
}

impl Gap {
    /// `h = sum coefficient x^i y^j`.
    ///
    /// # Errors
    /// [`GapError`] when a coefficient is not finite, a power is above 24 or given twice.
    pub fn polynomial(terms: &[Term]) -> Result<Self, GapError> {
        Ok(Self { shape: Shape::Polynomial(Polynomial::new(terms)?) })
    }

    /// A section `h(y)` through points in any order, which opens along x as `rolling` says.
    /// Between the points the slope is continuous; a kink does not ring.
    ///
    /// # Errors
    /// [`GapError`] when a number is not finite, a radius not positive, the columns differ in
    /// length, two points have the same y, or there are fewer than three.
    pub fn section(y: &[f64], gap: &[f64], rolling: Rolling<'_>) -> Result<Self, GapError> {
        Ok(Self { shape: Shape::Section(Section::new(y, gap, rolling)?) })
    }

    /// The section with what the gap has beyond its parabolas (m), over the distance `d` from their lowest
    /// place and over `y`, both increasing, in rows of one `y`; its value and slope at `d = 0` are those of the
    /// parabola, 0. Beyond the grid the value of its edge goes on.
    ///
    /// # Errors
    /// [`GapError`] for a gap that is no section, numbers that are not finite or out of order, and columns
    /// that differ in length.
    pub fn with_excess(self, d: &[f64], y: &[f64], excess: &[f64]) -> Result<Self, GapError> {
        match self.shape {
            Shape::Section(section) => {
                Ok(Self { shape: Shape::Section(section.with_excess(d, y, excess)?) })
            }
            _ => Err(GapError::NoSection),
        }
    }

    /// Points `[x, y, h]` of a rectangular grid, in any order, at even or uneven steps.
    /// Between them the slope is continuous; a kink does not ring.
    ///
    /// # Errors
    /// [`GapError`] when a number is not finite, two points lie at one place, one is missing, or
    /// there are fewer than three different x or y.
    pub fn grid(points: &[[f64; 3]]) -> Result<Self, GapError> {
        Ok(Self { shape: Shape::Grid(Grid::new(points)?) })
    }

    /// A function of x and y, known inside `domain` (finite on all sides).
    ///
    /// # Errors
    /// [`GapError`] when a side of the domain is not finite, or it is empty.
    pub fn function(
        domain: Rectangle,
        at: impl Fn(f64, f64) -> f64 + Send + Sync + 'static,
    ) -> Result<Self, GapError> {
        for ([low, high], size) in [(domain.x, "width along x"), (domain.y, "width along y")] {
            crate::check::finite("side of the domain", low)?;
            crate::check::finite("side of the domain", high)?;
            crate::check::positive(size, high - low)?;
        }
        Ok(Self { shape: Shape::Function(Function { domain, at: Arc::new(at) }) })
    }

    /// The distance at a place (m). Beyond the points of a section or grid its outer parabolas
    /// go on, for what little a solver needs there.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> f64 {
        match &self.shape {
            Shape::Polynomial(polynomial) => polynomial.at(x, y),
            Shape::Section(section) => {
                let mut out = [0.0];
                section.fill_row(y, &[x], &mut out);
                out[0]
            }
            Shape::Grid(grid) => grid.at(x, y),
            Shape::Function(function) => (function.at)(x, y),
            Shape::Turned(turned) => turned.at(x, y),
        }
    }

    /// Distances at many places of one y; `out` is as long as `xs`.
    pub fn fill_row(&self, y: f64, xs: &[f64], out: &mut [f64]) {
        match &self.shape {
            Shape::Polynomial(polynomial) => polynomial.fill_row(y, xs, out),
            Shape::Section(section) => section.fill_row(y, xs, out),
            Shape::Grid(_) | Shape::Function(_) | Shape::Turned(_) => {
                for (out, &x) in out.iter_mut().zip(xs) {
                    *out = self.at(x, y);
                }
            }
        }
    }

    /// Where the distance is known: the plane for a polynomial, a band for a section, else a
    /// rectangle.
    #[must_use]
    pub fn domain(&self) -> Rectangle {
        let ends = |values: &[f64]| {
            [values.first().copied().unwrap_or(0.0), values.last().copied().unwrap_or(0.0)]
        };
        match &self.shape {
            Shape::Polynomial(_) => Rectangle::PLANE,
            Shape::Section(section) => Rectangle { y: ends(section.y()), ..Rectangle::PLANE },
            Shape::Grid(grid) => Rectangle { x: ends(grid.x()), y: ends(grid.y()) },
            Shape::Function(function) => function.domain,
            Shape::Turned(turned) => turned.domain(),
        }
    }

    /// The same in axes turned by an angle (rad) about a place, for what lies in `extent`.
    pub(crate) fn turned(&self, about: [f64; 2], angle: f64, extent: &Rectangle) -> Self {
        Self { shape: Shape::Turned(Box::new(Turned::new(self, about, angle, extent))) }
    }

    /// Whether every section along x is a parabola.
    pub(crate) fn is_parabola_along(&self) -> bool {
        match &self.shape {
            Shape::Polynomial(polynomial) => polynomial.power_of_x() <= 2,
            Shape::Section(section) => section.is_parabola_along(),
            Shape::Grid(_) | Shape::Function(_) | Shape::Turned(_) => false,
        }
    }

    /// Whether every section along x has one lowest place, its locus.
    pub(crate) fn has_locus(&self) -> bool {
        match &self.shape {
            Shape::Section(_) => true,
            Shape::Turned(turned) => turned.gap().has_locus(),
            _ => self.is_parabola_along(),
        }
    }

    /// The parabola along x at `y` at its lowest place, where it has one: height there, half its
    /// curvature, the locus.
    pub(crate) fn parabola(&self, y: f64) -> Option<[f64; 3]> {
        match &self.shape {
            Shape::Polynomial(polynomial) => polynomial.parabola(y),
            Shape::Section(section) => Some(section.row(y)),
            Shape::Grid(_) | Shape::Function(_) | Shape::Turned(_) => None,
        }
    }

    /// Where the section along x at `y` is lowest, where it has one such place.
    pub(crate) fn locus(&self, y: f64) -> Option<f64> {
        match &self.shape {
            Shape::Section(section) => Some(section.locus(y)),
            Shape::Turned(turned) => turned.gap().has_locus().then(|| turned.locus(y)),
            _ => self.parabola(y).map(|[_, _, locus]| locus),
        }
    }

    /// The x about which parabolas along x are symmetric, where all have the same.
    pub(crate) fn axis(&self) -> Option<f64> {
        match &self.shape {
            Shape::Polynomial(polynomial) => polynomial.is_even_parabola().then_some(0.0),
            Shape::Section(section) => section.axis(),
            Shape::Grid(_) | Shape::Function(_) | Shape::Turned(_) => None,
        }
    }

    /// How many of the given points lie in a rectangle, along x and along y; `None` for a
    /// formula, which has as many as are wanted.
    #[must_use]
    pub fn points_within(&self, rectangle: &Rectangle) -> [Option<usize>; 2] {
        let count = |values: &[f64], [low, high]: [f64; 2]| {
            Some(values.iter().filter(|value| (low..=high).contains(value)).count())
        };
        match &self.shape {
            Shape::Polynomial(_) | Shape::Function(_) | Shape::Turned(_) => [None, None],
            Shape::Section(section) => [None, count(section.y(), rectangle.y)],
            Shape::Grid(grid) => [count(grid.x(), rectangle.x), count(grid.y(), rectangle.y)],
        }
    }
}
