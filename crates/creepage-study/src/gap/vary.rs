//! Many contacts of any shape: what differs from row to row of a table.

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use creepage::gap::Gap;

use super::error::GapCaseError;
use super::file::{GapCase, GapFile};
use super::shape::GapSection;

/// A quantity that may have a value of its own in every row, in SI units.
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

/// A case with `[gap]` some of whose quantities have values of their own in every row. Each row is
/// a case by itself; [`GapSolver`](super::GapSolver) presses anew only where it must.
#[derive(Debug, Clone)]
pub struct GapRows {
    file: GapFile,
    directory: PathBuf,
    varied: Vec<GapVaried>,
    /// Gaps of the latest rows, which rows that follow mostly share.
    read: Arc<Mutex<VecDeque<(GapSection, Gap)>>>,
}

impl GapRows {
    /// The case of a file whose quantities `varied` differ from row to row; a row gives their values
    /// in that order. What does not vary is the file's; a shape, a load or an approach that varies
    /// replaces the file's. Files of points stand in `directory`; one that many rows name is not read
    /// again for each.
    #[must_use]
    pub fn new(file: GapFile, directory: PathBuf, varied: Vec<GapVaried>) -> Self {
        Self { file, directory, varied, read: Arc::default() }
    }

    /// What differs from row to row.
    #[must_use]
    pub fn varied(&self) -> &[GapVaried] {
        &self.varied
    }

    /// Whether rows have a rolling velocity, and so a frictional power.
    #[must_use]
    pub fn has_speed(&self) -> bool {
        self.varied.contains(&GapVaried::Speed) || self.file.has_speed()
    }

    /// The case of a row.
    ///
    /// # Errors
    /// [`GapCaseError`], as of a case file with these values.
    pub fn case(&self, values: &[GapValue]) -> Result<GapCase, GapCaseError> {
        let mut file = self.file.clone();
        for (varied, value) in self.varied.iter().zip(values) {
            file.set(*varied, value);
        }
        file.case_with(|section| self.gap(section))
    }

    fn gap(&self, section: &GapSection) -> Result<Gap, GapCaseError> {
        /// More than rows are worked at together.
        const KEPT: usize = 32;
        let read = || self.read.lock().unwrap_or_else(PoisonError::into_inner);
        let known = read().iter().find(|(known, _)| known == section).map(|(_, gap)| gap.clone());
        if let Some(gap) = known {
            return Ok(gap);
        }
        let gap = section.gap(&self.directory)?;
        let mut read = read();
        read.truncate(KEPT - 1);
        read.push_front((section.clone(), gap.clone()));
        Ok(gap)
    }
}
