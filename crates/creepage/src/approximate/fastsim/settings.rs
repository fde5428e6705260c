//! Settings of FASTSIM: its variants and its grid.

use super::grid::Profile;

/// How the three flexibilities `L1 = 8a / (3 G C11)`, `L2 = 8a / (3 G C22)` and
/// `L3 = pi a sqrt(a/b) / (4 G C23)` are used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Flexibility {
    /// One, their mean weighted with the creepages and spin (Kalker 1982):
    /// `(|upsilon_x| L1 + |upsilon_y| L2 + c |phi| L3) / |(upsilon_x, upsilon_y, c phi)|`.
    One,
    /// All three, each for its own creepage or spin (Kalker 1982).
    Three,
    /// From three for small creepage to one for large creepage: E. A. H. Vollebregt, J. Voltr,
    /// Improved accuracy for FASTSIM using one or three flexibility values, Vehicle System
    /// Dynamics 61 (2023) 309-317. The best of the three with spin, as the traction of full
    /// sliding then takes the direction of the rigid slip; the same as `Three` without spin
    /// as long as one creepage alone is present.
    #[default]
    Blended,
}

/// The bound of the traction within FASTSIM.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum TractionBound {
    /// A paraboloid of the same total (Kalker 1982): 4/3 of the true bound at the centre. Sliding
    /// is complete at finite creepage.
    Parabolic,
    /// `mu` times the Hertz pressure. Sliding is complete at infinite creepage only.
    ///
    /// The default by its errors with blended flexibilities at 50 x 50, in root mean square over
    /// 132 cases of the full theory: with spin the force errs by .039 of `mu N` (parabolic .054)
    /// and the moment by .017 of `mu N c` (.074: the parabola's moment of full sliding is wrong).
    /// Without spin the parabola's force is better (.021 against .029), the moment is not.
    #[default]
    Elliptic,
}

impl TractionBound {
    /// The bound, `factor` times higher than `mu N` demands.
    pub(crate) fn profile(self, factor: f64) -> Profile {
        match self {
            Self::Parabolic => Profile::Parabolic { factor },
            Self::Elliptic => Profile::Elliptic,
        }
    }
}

/// Which FASTSIM, and how fine.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Settings {
    /// Use of the flexibilities.
    pub flexibility: Flexibility,
    /// Bound of the traction.
    pub bound: TractionBound,
    /// Cells in each strip along the rolling direction, and strips across: `[nx, ny]`.
    pub grid: [usize; 2],
    /// Factors [k0, alpha, beta] of surfaces that are not clean and dry: the slope of the traction is
    /// `k0 (alpha + (1 - alpha)/(1 + beta eps))` times theirs, where `eps`, the ratio of the areas of slip and of
    /// adhesion, grows with creepage. 0 < k0 <= 1, 0 < alpha <= 1, beta >= 0; [1, 1, 0] by default.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "is_clean"))]
    pub reduction: [f64; 3],
}

/// Whether it is what is not written.
#[cfg(feature = "serde")]
#[allow(clippy::float_cmp)] // given or not
fn is_clean(reduction: &[f64; 3]) -> bool {
    *reduction == Settings::CLEAN
}

impl Settings {
    /// Most cells in a strip, and most strips.
    pub const MAX_CELLS: usize = 10_000;

    /// The reduction of clean and dry surfaces: none.
    pub const CLEAN: [f64; 3] = [1.0, 1.0, 0.0];
}

impl Settings {
    /// Whether the slope of the traction is that of clean and dry surfaces.
    #[allow(clippy::float_cmp)] // factors of one
    pub(crate) fn is_clean(&self) -> bool {
        self.reduction[..2] == [1.0; 2]
    }
}

impl Default for Settings {
    /// Blended flexibilities, elliptic bound, 50 x 50 cells, clean and dry.
    fn default() -> Self {
        Self {
            flexibility: Flexibility::default(),
            bound: TractionBound::default(),
            grid: [50, 50],
            reduction: Self::CLEAN,
        }
    }
}
