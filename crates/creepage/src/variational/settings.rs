//! Settings of the numerical theory of chapter 5.

use crate::check::InvalidValue;

/// Weight of a point in the integral (5.8).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Weight {
    /// `W = 1`.
    Uniform,
    /// `W = W1 = 1 - (x/a)^2 - (y/b)^2` (5.14), the thesis's choice.
    #[default]
    Elliptic,
    /// `W = sqrt(W1)`, which the thesis tried as well (5.22).
    RootElliptic,
}

impl Weight {
    /// The weight at the distance `r` from the centre, `r = 1` on the edge.
    #[must_use]
    pub fn at(self, r_squared: f64) -> f64 {
        match self {
            Self::Uniform => 1.0,
            Self::Elliptic => 1.0 - r_squared,
            Self::RootElliptic => (1.0 - r_squared).max(0.0).sqrt(),
        }
    }
}

/// What is done about `|X'| <= 1` (5.7), which (5.9) leaves to be verified afterwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum TractionBound {
    /// Kept where `a/b >= 3`: there `I` has several minima near the peak of pure spin, and the
    /// lowest can break the bound all over the contact.
    #[default]
    Automatic,
    /// Verified afterwards only, as in the thesis.
    Unchecked,
    /// Kept: the least loss of power takes the place of (5.9). This is a convex functional that
    /// has one minimum, zero for the solution of the problem as that of (5.9), with the bound as a
    /// penalty. It weighs a point by `Z`, whatever the [`Weight`]. Only [`Method::Damped`] with
    /// the integrand `T S` keeps the bound.
    ///
    /// [`Method::Damped`]: super::Method::Damped
    Kept,
}

impl TractionBound {
    /// The ratio `a/b` from which [`TractionBound::Automatic`] keeps the bound.
    pub const SLENDER_RATIO: f64 = 3.0;

    pub(super) fn is_kept(self, a_over_b: f64) -> bool {
        match self {
            Self::Automatic => a_over_b >= Self::SLENDER_RATIO,
            Self::Unchecked => false,
            Self::Kept => true,
        }
    }
}

/// Degree, mesh, weight and treatment of the bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Settings {
    /// Degree `M` of the traction polynomials `X'`, `Y'`: at most [`Settings::MAX_DEGREE`].
    pub degree: usize,
    /// Cells along `x` and `y` of the box around the ellipse; the integral is the mean over
    /// the midpoints that lie inside the ellipse.
    pub mesh: [usize; 2],
    /// Weight of the points.
    pub weight: Weight,
    /// Whether tractions are kept within their bound.
    pub bound: TractionBound,
    /// Weight `W3` of the slip in the area of adhesion in [`Method::Areas`], whose `W2` in the area of
    /// slip is `weight`; the same as that where it is not given.
    ///
    /// [`Method::Areas`]: super::Method::Areas
    pub adhesion_weight: Option<Weight>,
}

impl Settings {
    /// Highest degree; 182 unknowns, more than any accuracy of this method asks for.
    pub const MAX_DEGREE: usize = 12;
    /// Most cells along one side of the mesh.
    pub const MAX_CELLS: usize = 400;

    /// The settings of the thesis for degree `M`: 80 points up to degree 3, more beyond.
    #[must_use]
    pub fn of_degree(degree: usize) -> Self {
        let cells = 10.max(2 * degree.min(Self::MAX_DEGREE) + 4);
        Self {
            degree,
            mesh: [cells; 2],
            weight: Weight::default(),
            bound: TractionBound::default(),
            adhesion_weight: None,
        }
    }
}

impl Default for Settings {
    /// Degree 3, 10 x 10 cells, elliptic weight: the thesis's choice for its catalogue.
    fn default() -> Self {
        Self::of_degree(3)
    }
}

/// Stopping criteria of an iteration (5.12c).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// `delta`: the iteration ends when the largest change of an unknown is below `delta` times
    /// the largest unknown. The error that is left is about `delta^2`.
    pub delta: f64,
    /// Most steps of the iteration.
    pub max_iterations: usize,
}

impl Limits {
    /// Those of the thesis: `delta = 0.001`, 12 iterations (5.21).
    pub const OF_1967: Self = Self { delta: 1e-3, max_iterations: 12 };
}

impl Default for Limits {
    /// `delta = 1e-6`, 200 iterations.
    fn default() -> Self {
        Self { delta: 1e-6, max_iterations: 200 }
    }
}

/// Error of preparing the numerical theory.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VariationalError {
    /// A number is outside its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The polynomial degree is too high.
    #[error("degree = {degree} is not valid: it must be between 0 and {max}")]
    Degree {
        /// The degree that was asked for.
        degree: usize,
        /// [`Settings::MAX_DEGREE`].
        max: usize,
    },
    /// The mesh cannot tell the polynomials apart, or is absurdly fine.
    #[error(
        "mesh = {} x {} is not valid: degree {degree} needs between {min} and {max} cells a side",
        mesh[0], mesh[1]
    )]
    Mesh {
        /// The mesh that was asked for.
        mesh: [usize; 2],
        /// Degree of the polynomials.
        degree: usize,
        /// Fewest cells a side.
        min: usize,
        /// Most cells a side.
        max: usize,
    },
    /// A derivative of the user's integrand is not that of the function.
    #[error("{name} = {given} is not valid: the difference at T = {t}, S = {s} is {difference}")]
    Derivative {
        /// Which derivative, in the notation of (5.17): `f*`, `f.`, `f**`, `f*.`, `f..`.
        name: &'static str,
        /// What the user's function says.
        given: f64,
        /// What the difference quotient says.
        difference: f64,
        /// `T` where they differ.
        t: f64,
        /// `S` where they differ.
        s: f64,
    },
}

impl Settings {
    pub(super) fn check(&self) -> Result<(), VariationalError> {
        let Self { degree, mesh, .. } = *self;
        if degree > Self::MAX_DEGREE {
            return Err(VariationalError::Degree { degree, max: Self::MAX_DEGREE });
        }
        let (min, max) = (degree + 3, Self::MAX_CELLS);
        if mesh.iter().any(|cells| !(min..=max).contains(cells)) {
            return Err(VariationalError::Mesh { mesh, degree, min, max });
        }
        Ok(())
    }
}
