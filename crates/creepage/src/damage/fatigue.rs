//! Rolling contact fatigue numbers by the forces of a contact.

use std::f64::consts::PI;

use super::ElementState;

/// The whole life rail model: M. Burstow, *Whole life rail model application and development*, RSSB
/// reports of 2003 and 2004. *Unverified*; the scale, 1e-5 of a crack per wheel, differs between papers.
///
/// Damage by T gamma: none below 15 N, rising to 1 at 65 N, falling to zero at 175 N and on, for
/// there wear removes more than cracks grow.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Wlrm {
    /// T gamma below which cracks do not start (N): 15.
    pub start: f64,
    /// T gamma of the most damage (N): 65.
    pub worst: f64,
    /// T gamma at which wear and cracks are equal (N): 175.
    pub balance: f64,
    /// The most damage of one wheel: 1e-5.
    pub scale: f64,
}

impl Default for Wlrm {
    fn default() -> Self {
        Self { start: 15.0, worst: 65.0, balance: 175.0, scale: 1e-5 }
    }
}

impl Wlrm {
    /// Damage of the rail by one wheel, whatever the direction of the force; negative where wear
    /// prevails.
    #[must_use]
    pub fn damage(&self, t_gamma: f64) -> f64 {
        let rise = (t_gamma - self.start) / (self.worst - self.start);
        let fall = (self.balance - t_gamma) / (self.balance - self.worst);
        self.scale * if t_gamma <= self.worst { rise.max(0.0) } else { fall }
    }

    /// The same with the direction of the force taken into account: cracks grow under wheels that drive, which
    /// push the rail backwards, `F_x < 0` on the lower body; wear counts either way.
    #[must_use]
    pub fn directed_damage(&self, t_gamma: f64, longitudinal_force: f64) -> f64 {
        let damage = self.damage(t_gamma);
        if longitudinal_force < 0.0 { damage } else { damage.min(0.0) }
    }
}

/// The surface fatigue index, `|F|/N - k/p0`: positive when the surface ratchets by the shakedown map of
/// K.L. Johnson, *Contact mechanics*, 1985, whose surface branch is `p0/k = 1/mu`.
///
/// `traction` is the size of the tangential force and `normal` the normal force (N), `peak_pressure` `p0`
/// and `shear_yield` `k` (Pa). For an ellipse `k/p0 = 2 pi a b k/(3 N)`.
#[must_use]
pub fn surface_index(traction: f64, normal: f64, peak_pressure: f64, shear_yield: f64) -> f64 {
    traction / normal - shear_yield / peak_pressure
}

/// The same element by element, for contacts of any shape: the largest of `(|p_t| - k)/p_n` over
/// elements with pressure. In full sliding of a Hertz contact it is [`surface_index`]. `None` without a
/// loaded element.
#[must_use]
pub fn local_surface_index(elements: &[ElementState], shear_yield: f64) -> Option<f64> {
    let loaded = elements.iter().filter(|element| element.pressure > 0.0);
    loaded.map(|element| (element.shear() - shear_yield) / element.pressure).reduce(f64::max)
}

/// Fatigue of wheels below the surface: A. Ekberg, E. Kabo, H. Andersson, Fatigue & Fracture of
/// Engineering Materials & Structures 25 (2002) 899-909. *Unverified.*
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Ekberg {
    /// Weight of the hydrostatic residual stress: 1/3.
    pub residual_weight: f64,
    /// Hydrostatic residual stress (Pa): 0, positive in tension.
    pub residual: f64,
    /// Equivalent fatigue limit (Pa): 186e6.
    pub limit: f64,
}

impl Default for Ekberg {
    fn default() -> Self {
        Self { residual_weight: 1.0 / 3.0, residual: 0.0, limit: 186e6 }
    }
}

impl Ekberg {
    /// The subsurface fatigue index, `N (1 + f^2)/(4 pi a b) + c s_res` less the limit (Pa), `f` the
    /// friction used, `|F|/N`; positive when fatigue is predicted.
    #[must_use]
    pub fn index(&self, normal: f64, friction_used: f64, [a, b]: [f64; 2]) -> f64 {
        let shear = normal * (1.0 + friction_used * friction_used) / (4.0 * PI * a * b);
        shear + self.residual_weight * self.residual - self.limit
    }
}
