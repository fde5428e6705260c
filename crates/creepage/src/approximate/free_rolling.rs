//! Free rolling of unlike bodies on a circle without slip (6.7), as 6.2 of the thesis proposes: by
//! potential theory.
//!
//! Hertz's pressure moves the surfaces by (2.11a,b); a traction without a singularity at the edge must
//! undo that up to `u = -upsilon_x x`, for then nothing slips. It is radial as the displacement is:
//! with `G/(1 - sigma)` times the displacement, in units of `a`, and Abel's transform of its radial
//! part,
//!
//! ```math
//! f(r) = \frac{\kappa p_0}{1 - \sigma} \left[ -c \, r + \frac{2}{3} \frac{1 - (1 - r^2)^{3/2}}{r} \right],
//! \qquad F(t) = \frac1t \frac{d}{dt} \int_0^t \frac{r^2 f \, dr}{\sqrt{t^2 - r^2}}
//!   = \frac{\kappa p_0}{1 - \sigma} \left[ t (1 - 2c) + (1 - t^2) \operatorname{artanh} t \right],
//! ```
//!
//! the traction is `-1/pi d/dr int_r^1 F (t^2 - r^2)^(-1/2) dt`, singular at the edge as `F(1)`. So
//! `c = 1/2`: the bodies roll freely with
//!
//! ```math
//! \upsilon_x = \frac{\kappa p_0}{2 G}
//!   = \frac34 \cdot \frac{2 \kappa p_0}{3 G}, \qquad
//! q(r) = \frac{\kappa p_0}{1 - \sigma} \frac{r}{\pi} \int_r^1
//!   \left[ \Big( 1 + \frac{1}{t^2} \Big) \operatorname{artanh} t - \frac1t \right]
//!   \frac{dt}{\sqrt{t^2 - r^2}}.
//! ```
//!
//! Finite friction lets the rim slip, and the creepage becomes larger, up to 1.2516903 in place of 3/4
//! where friction vanishes and all slips.

use std::num::NonZeroUsize;
use std::sync::LazyLock;

use gauss_quad::GaussLegendre;

use crate::check::{self, InvalidValue};

/// Free rolling of unlike bodies on a circular contact without slip.
///
/// Creepage is in units of `mu a / rho`, traction in units of `mu p_0`, as in the theories.
///
/// ```
/// use creepage::approximate::free_rolling::FreeRolling;
/// let free = FreeRolling::new(0.8, 0.25)?;
/// // The middle does not know of the rim; at the rim friction would have to be infinite.
/// assert!(free.creepage() > 0.0 && free.traction(0.5) < free.traction(0.9));
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeRolling {
    /// `kappa / (mu (1 - sigma))`.
    dissimilarity: f64,
}

impl FreeRolling {
    /// The creepage over `2 kappa p_0 / (3 G)` without slip.
    pub const RATIO: f64 = 0.75;

    /// For `kappa` over the coefficient of friction, and the combined Poisson's ratio.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `kappa_over_mu` is finite, and `poisson` between 0 and 0.5.
    pub fn new(kappa_over_mu: f64, poisson: f64) -> Result<Self, InvalidValue> {
        check::finite("kappa_over_mu", kappa_over_mu)?;
        Ok(Self { dissimilarity: kappa_over_mu / (1.0 - check::poisson(poisson)?) })
    }

    /// The creepage `xi` with which the bodies roll freely.
    #[must_use]
    pub fn creepage(&self) -> f64 {
        std::f64::consts::FRAC_2_PI * self.dissimilarity
    }

    /// Traction away from the axis on the lower body, at `r` in units of `a`; zero outside.
    #[must_use]
    pub fn traction(&self, r: f64) -> f64 {
        if !(0.0..1.0).contains(&r) {
            return 0.0;
        }
        let most = ((1.0 - r) * (1.0 + r)).sqrt();
        // t^2 = r^2 + v^2, and v = most (1 - y^3) smooths the logarithm at t = 1.
        let term = |(y, weight): &(f64, f64)| {
            let v = most * (1.0 - y.powi(3));
            let t = r.hypot(v);
            weight
                * 3.0
                * y
                * y
                * most
                * integrand(t, most * most * (1.0 - (1.0 - y.powi(3)).powi(2)))
        };
        self.dissimilarity * r / std::f64::consts::PI * GAUSS_RULE.iter().map(term).sum::<f64>()
    }
}

/// `[(1 + 1/t^2) artanh t - 1/t]/t`, with `rest = 1 - t^2`.
fn integrand(t: f64, rest: f64) -> f64 {
    if t < 1e-3 {
        // artanh t = t + t^3/3: what cancels is left out.
        return 4.0 / 3.0;
    }
    let artanh = 0.5 * ((1.0 + t).powi(2) / rest).ln();
    ((1.0 + 1.0 / (t * t)) * artanh - 1.0 / t) / t
}

/// Gauss's points and weights on (0, 1).
static GAUSS_RULE: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| {
    let count = NonZeroUsize::new(48);
    let rule = count.map(|count| GaussLegendre::new(count).as_node_weight_pairs().to_vec());
    rule.unwrap_or_default().iter().map(|(x, w)| (0.5 * (1.0 + x), 0.5 * w)).collect()
});

#[cfg(test)]
mod tests {
    use super::*;

    /// The traction obtained in closed form from the transform at the middle: `q/r` there is
    /// `1/pi` times the integral of the bracket over `t^2`, by midpoints.
    #[test]
    fn the_middle_is_the_plain_integral() {
        const CELLS: u32 = 200_000;
        let term = |k: u32| {
            let t = (f64::from(k) + 0.5) / f64::from(CELLS);
            integrand(t, (1.0 - t) * (1.0 + t)) / f64::from(CELLS)
        };
        let expected = (0..CELLS).map(term).sum::<f64>() / std::f64::consts::PI;
        let found = FreeRolling::new(1.0, 0.0).unwrap().traction(1e-6) / 1e-6;
        // Half a cell of the logarithm at the rim.
        assert!((found - expected).abs() < 1e-4, "{found} {expected}");
    }
}
