//! Table of contacts of any shape: each row is a case by itself.

use std::path::PathBuf;
use std::sync::Arc;

use creepage::SolidPair;
use creepage::gap::Gap;

use super::case::GapCase;
use super::error::GapCaseError;
use super::file::GapFile;
use super::shape::GapSection;
use super::vary::{GapValue, GapVaried};
use crate::recent::Recent;

/// Gaps that are kept: more than rows are worked at together.
const KEPT: usize = 32;

/// A case with `[gap]` some of whose quantities have values of their own in every row. Each row is
/// a case by itself; [`GapSolver`](super::GapSolver) presses anew only where it must.
#[derive(Debug, Clone)]
pub struct GapRows {
    file: GapFile,
    directory: PathBuf,
    varied: Vec<GapVaried>,
    /// Gaps of the latest rows, which rows that follow mostly share.
    read: Arc<Recent<GapSection, Gap>>,
}

impl GapRows {
    /// The case of a file whose quantities `varied` differ from row to row; a row gives their values
    /// in that order. What does not vary is the file's; a shape, a load or an approach that varies
    /// replaces the file's. Files of points stand in `directory`; one that many rows name is not read
    /// again for each.
    #[must_use]
    pub fn new(file: GapFile, directory: PathBuf, varied: Vec<GapVaried>) -> Self {
        Self { file, directory, varied, read: Arc::new(Recent::new(|| KEPT)) }
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

    /// Whether rows have temperatures.
    #[must_use]
    pub fn has_heat(&self) -> bool {
        self.file.has_heat()
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
        file.case_with(&self.directory, |section, pair| self.gap(section, pair))
    }

    fn gap(&self, section: &GapSection, pair: SolidPair) -> Result<Gap, GapCaseError> {
        if let Some(known) = self.read.find(section) {
            return Ok((*known).clone());
        }
        let gap = section.gap(&self.directory, pair)?;
        Ok((*self.read.keep(section, gap)).clone())
    }
}
