//! The spin pole in the contact: the closed form (4.106).

use crate::ellipse::Ellipse;
use crate::{Creepage, Force};

/// `(3/2 pi ab) int int sqrt(1 - r^2) R dx dy`, `R` being the distance from `(x', y')`: in the
/// ellipse a polynomial, whose gradient is the force,
///
/// `p0 + (p2x x'^2 + p2y y'^2)/2 - (p4x x'^4 + 2 p22 x'^2 y'^2 + p4y y'^4)/4`.
#[derive(Debug, Clone)]
pub(super) struct PoleInside {
    p0: f64,
    p2: [f64; 2],
    p22: f64,
    p4: [f64; 2],
}

impl PoleInside {
    /// The chords through the pole give the coefficients as integrals over their direction,
    /// `int sin^2 f/Q` and the like, which are those of [`crate::special`].
    pub(super) fn new(ellipse: Ellipse) -> Self {
        let (a, b, major) = (ellipse.a(), ellipse.b(), ellipse.major());
        let integrals = ellipse.integrals();
        let mixed = (integrals.d - integrals.c) / 3.0;
        // int cos^2/Q and int sin^2/Q; int sin^4/Q, each over 2/major.
        let ([cos2, sin2], sin4) = if a > b {
            ([integrals.b, integrals.d], integrals.d - mixed)
        } else {
            ([integrals.d, integrals.b], integrals.b - mixed)
        };
        let factor = 1.5 / major;
        Self {
            p0: 0.375 * major * integrals.e,
            p2: [factor * cos2, factor * sin2],
            p22: factor * (sin4 - 2.0 * mixed) / (a * a),
            p4: [factor * mixed / (a * a), factor * mixed / (b * b)],
        }
    }

    pub(super) fn force(&self, creepage: Creepage) -> Force {
        let Creepage { xi, eta, chi } = creepage;
        let (x, y) = (-eta / chi, xi / chi);
        let (xx, yy) = (x * x, y * y);
        let ([p2x, p2y], [p4x, p4y]) = (self.p2, self.p4);
        let by_x = x * (p2x - p4x * xx - self.p22 * yy);
        let by_y = y * (p2y - p4y * yy - self.p22 * xx);
        let moment = self.p0 - 0.5 * (p2x * xx + p2y * yy)
            + 0.75 * (p4x * xx * xx + 2.0 * self.p22 * xx * yy + p4y * yy * yy);
        let sign = chi.signum();
        Force { fx: sign * by_y, fy: -sign * by_x, mz: sign * moment }
    }

    pub(super) fn derivative(&self, creepage: Creepage) -> [[f64; 3]; 3] {
        let Creepage { xi, eta, chi } = creepage;
        let (x, y) = (-eta / chi, xi / chi);
        let (xx, yy) = (x * x, y * y);
        let ([p2x, p2y], [p4x, p4y]) = (self.p2, self.p4);
        let unit = chi.abs().recip();
        let by_xx = unit * (p2x - 3.0 * p4x * xx - self.p22 * yy);
        let by_yy = unit * (p2y - 3.0 * p4y * yy - self.p22 * xx);
        let by_xy = unit * (-2.0 * self.p22 * x * y);
        let (x_spin, y_spin) = (by_xy * x + by_yy * y, by_xx * x + by_xy * y);
        [
            [by_yy, -by_xy, -x_spin],
            [-by_xy, by_xx, y_spin],
            [-x_spin, y_spin, x * y_spin + y * x_spin],
        ]
    }
}
