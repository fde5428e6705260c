//! Strips along rolling whose pressure is a root at both ends, which move, times a polynomial of degree 7:
//! those of `normal`, with more polynomials.

pub(super) mod kernel;
pub(super) mod newton;

use kernel::MOST;

/// A strip along rolling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Strip {
    pub y: f64,
    /// Half its width across rolling.
    pub width: f64,
    pub centre: f64,
    pub half: f64,
    /// The pressure is `sqrt(1 - s^2)` times these of Chebyshev's polynomials `U_k(s)`.
    pub pressure: [f64; MOST],
}

impl Strip {
    pub(super) fn load(&self) -> f64 {
        std::f64::consts::PI * self.width * self.half * self.pressure[0]
    }
}
