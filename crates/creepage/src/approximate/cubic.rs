//! The cubic law of saturation, `f = 1 - (1 - tau/3)^3`, and the tractions behind it: those of
//! full sliding, less those of full sliding in a smaller, similar ellipse that touches the contact
//! at its leading point.

use crate::ellipse::Ellipse;

/// The law at one linear force `p`, in parts of `mu N`; `tau = |p|`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cubic {
    linear: [f64; 2],
    tau: f64,
    /// Force over linear force.
    pub(super) factor: f64,
}

impl Cubic {
    pub(super) fn new(linear: [f64; 2]) -> Self {
        let tau = (linear[0] * linear[0] + linear[1] * linear[1]).sqrt();
        let factor = if tau < 3.0 { 1.0 - tau / 3.0 + tau * tau / 27.0 } else { tau.recip() };
        Self { linear, tau, factor }
    }

    /// `(f_x, f_y)`.
    pub(super) fn force(self) -> [f64; 2] {
        self.linear.map(|p| self.factor * p)
    }

    /// `p/|p|`, zero when there is no force.
    pub(super) fn direction(self) -> [f64; 2] {
        self.linear.map(|p| if self.tau > 0.0 { p / self.tau } else { 0.0 })
    }

    /// Size of the adhesion ellipse relative to the contact.
    pub(super) fn adhesion(self) -> f64 {
        (1.0 - self.tau / 3.0).max(0.0)
    }

    /// Change of `factor` with the change `dp` of the linear force.
    pub(super) fn factor_change(self, dp: [f64; 2]) -> f64 {
        let slope = if self.tau < 3.0 {
            2.0 * self.tau / 27.0 - 1.0 / 3.0
        } else {
            -(self.factor * self.factor)
        };
        let [nx, ny] = self.direction();
        slope * (nx * dp[0] + ny * dp[1])
    }

    /// Change of `(f_x, f_y)` with the change `dp` of the linear force.
    pub(super) fn force_change(self, dp: [f64; 2]) -> [f64; 2] {
        let change = self.factor_change(dp);
        [0, 1].map(|i| self.factor * dp[i] + change * self.linear[i])
    }

    /// Traction at `position` in units of `mu` times the peak pressure, and whether it lies in
    /// the area of adhesion; `None` outside the contact.
    pub(super) fn traction(self, ellipse: Ellipse, position: [f64; 2]) -> Option<([f64; 2], bool)> {
        let [x, y] = [position[0] / ellipse.a(), position[1] / ellipse.b()];
        let bound = 1.0 - x * x - y * y;
        if bound.is_nan() || bound <= 0.0 {
            return None;
        }
        let size = self.adhesion();
        let [inner_x, inner_y] = inner(size, [x, y]);
        let relief = size * size - inner_x * inner_x - inner_y * inner_y;
        let magnitude = bound.sqrt() - relief.max(0.0).sqrt();
        Some((self.direction().map(|n| magnitude * n), relief > 0.0))
    }
}

/// Position relative to the centre of the adhesion ellipse of relative `size`, in coordinates
/// that make the contact the unit circle.
pub(super) fn inner(size: f64, [x, y]: [f64; 2]) -> [f64; 2] {
    [x - (1.0 - size), y]
}
