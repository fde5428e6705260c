//! The contact for programs: ellipse, pressure, equivalent solid.

use creepage::{Hertz, SolidPair};
use serde::Serialize;

use crate::Caution;

/// The contact of two bodies, as [`hertz_json`] gives it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HertzJson {
    /// Normal force `N` (N).
    pub normal_force_n: f64,
    /// Semi-axis `a` along the rolling direction (m).
    pub semi_axis_rolling_m: f64,
    /// Semi-axis `b` across (m).
    pub semi_axis_lateral_m: f64,
    /// The ratio `a/b`.
    pub a_over_b: f64,
    /// Largest normal pressure (Pa).
    pub peak_pressure_pa: f64,
    /// Approach of the bodies (m).
    pub approach_m: f64,
    /// Contact stiffness `dN/d(approach)` (N/m).
    pub stiffness_n_per_m: f64,
    /// Approach over the load to the power 2/3, the same for every load (m/N^(2/3)).
    pub approach_constant_m_per_n_2_3: f64,
    /// Curvature length `rho` (m).
    pub rho_m: f64,
    /// Angle from the upper body's rolling direction to the axis `a` (rad).
    pub angle_rad: f64,
    /// Relative curvature `A` along the axis `a` (1/m).
    pub relative_curvature_rolling_per_m: f64,
    /// Relative curvature `B` along the axis `b` (1/m).
    pub relative_curvature_lateral_per_m: f64,
    /// The equivalent solid of both bodies.
    pub solid: SolidJson,
}

/// The solid that stands for both bodies (2.10).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SolidJson {
    /// Combined shear modulus `G` (Pa).
    pub shear_modulus_pa: f64,
    /// Combined Poisson's ratio `sigma`.
    pub poisson: f64,
    /// Measure of how unlike the bodies are.
    pub kappa: f64,
}

/// The contact alone as a report.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HertzReportJson {
    /// The contact.
    #[serde(flatten)]
    pub contact: HertzJson,
    /// What looks like a number in another unit, in words; else `null`.
    pub caution: Option<String>,
}

impl HertzReportJson {
    /// The contact and its cautions.
    #[must_use]
    pub fn new(contact: &Hertz, cautions: &[Caution]) -> Self {
        let caution = (!cautions.is_empty()).then(|| Caution::words(cautions));
        Self { contact: hertz_json(contact), caution }
    }
}

/// The contact alone, ready for `serde_json`.
#[must_use]
pub fn hertz_json(contact: &Hertz) -> HertzJson {
    let ellipse = contact.ellipse();
    let [along, across] = contact.relative_curvatures();
    HertzJson {
        normal_force_n: contact.normal_force(),
        semi_axis_rolling_m: ellipse.a(),
        semi_axis_lateral_m: ellipse.b(),
        a_over_b: ellipse.ratio(),
        peak_pressure_pa: contact.peak_pressure(),
        approach_m: contact.approach(),
        stiffness_n_per_m: contact.stiffness(),
        approach_constant_m_per_n_2_3: contact.approach_constant(),
        rho_m: contact.rho(),
        angle_rad: contact.angle(),
        relative_curvature_rolling_per_m: along,
        relative_curvature_lateral_per_m: across,
        solid: contact.pair().into(),
    }
}

impl From<SolidPair> for SolidJson {
    fn from(pair: SolidPair) -> Self {
        Self {
            shear_modulus_pa: pair.shear_modulus(),
            poisson: pair.poisson(),
            kappa: pair.kappa(),
        }
    }
}
