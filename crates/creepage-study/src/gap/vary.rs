//! Quantities of a contact of any shape that may differ from row to row of a table.

/// Quantity that may have a value of its own in every row, in SI units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GapVaried {
    /// File with the section of the gap.
    Section,
    /// File with the gap on a grid.
    Grid,
    /// Radius along the rolling direction that goes with a section (m).
    RadiusRolling,
    /// Normal force (N).
    NormalForce,
    /// Approach (m).
    Approach,
    /// Coefficient of friction.
    Friction,
    /// Longitudinal creepage.
    Longitudinal,
    /// Lateral creepage.
    Lateral,
    /// Spin (rad/m).
    Spin,
    /// Rolling velocity (m/s).
    Speed,
    /// Wanted longitudinal force (N).
    LongitudinalForce,
    /// Wanted lateral force (N).
    LateralForce,
    /// Wanted moment (N m).
    Moment,
}

/// A value of a row.
#[derive(Debug, Clone, PartialEq)]
pub enum GapValue {
    /// A file's name.
    File(String),
    /// A number.
    Number(f64),
}

impl GapVaried {
    /// All of them, as tables have their columns.
    pub const ALL: [Self; 13] = [
        Self::Section,
        Self::Grid,
        Self::RadiusRolling,
        Self::NormalForce,
        Self::Approach,
        Self::Friction,
        Self::Longitudinal,
        Self::Lateral,
        Self::Spin,
        Self::Speed,
        Self::LongitudinalForce,
        Self::LateralForce,
        Self::Moment,
    ];

    /// The name of its column: that of the key of a case file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Section => "section",
            Self::Grid => "grid",
            Self::RadiusRolling => "radius_rolling",
            Self::NormalForce => "normal_force",
            Self::Approach => "approach",
            Self::Friction => "friction",
            Self::Longitudinal => "longitudinal",
            Self::Lateral => "lateral",
            Self::Spin => "spin",
            Self::Speed => "speed",
            Self::LongitudinalForce => "longitudinal_force",
            Self::LateralForce => "lateral_force",
            Self::Moment => "moment",
        }
    }

    /// Whether its values are names of files.
    #[must_use]
    pub fn is_file(self) -> bool {
        matches!(self, Self::Section | Self::Grid)
    }
}
