//! Profile of the traction bound along a strip.

use std::f64::consts::PI;

/// The traction bound: in every strip the same profile, of a height that depends on the strip.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Profile {
    /// `factor * 2 / (pi a b) * (1 - (x/a)^2 - (y/b)^2)`, in units of `mu N`.
    Parabolic { factor: f64 },
    /// `3 / (2 pi a b) * sqrt(1 - (x/a)^2 - (y/b)^2)`.
    Elliptic,
}

impl Profile {
    /// Largest value of the Hertz bound, in units of `mu N / c^2`.
    pub(crate) const HERTZ_PEAK: f64 = 1.5 / PI;

    /// Largest bound in the strip of half-length `a s`.
    pub(crate) fn peak(self, s: f64) -> f64 {
        match self {
            Self::Parabolic { factor } => factor * 2.0 / PI * s * s,
            Self::Elliptic => Self::HERTZ_PEAK * s,
        }
    }

    /// The bound at `x`, in units of the half-length, over the strip's largest.
    pub(crate) fn along(self, x: f64) -> f64 {
        let profile = ((1.0 - x) * (1.0 + x)).max(0.0);
        match self {
            Self::Parabolic { .. } => profile,
            Self::Elliptic => profile.sqrt(),
        }
    }
}
