//! `[contact] slip`: rigid slip that differs from place to place, beside creepage and spin.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use creepage::AddedSlip;
use schemars::JsonSchema;
use serde::Deserialize;

use super::error::CaseError;
use crate::gap::Points;

/// A rigid slip by its points: the name of a CSV file beside the case file, or columns in the case itself.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(transparent)]
pub(crate) struct SlipPoints(Points);

/// Places (m), and slips over the rolling velocity.
const COLUMNS: [&str; 4] = ["x", "y", "longitudinal", "lateral"];

impl SlipPoints {
    /// The slip; a file of points stands in `directory`. Of the sections that go by creepage and spin alone, those
    /// that the case has.
    pub(crate) fn read(
        &self,
        directory: &Path,
        others: impl IntoIterator<Item = (&'static str, bool)>,
    ) -> Result<Arc<AddedSlip>, CaseError> {
        if let Some((section, _)) = others.into_iter().find(|(_, is_given)| *is_given) {
            return Err(CaseError::SlipWith { section });
        }
        let told = |why: String| CaseError::Slip { points: self.0.shape("slip"), why };
        let columns =
            self.0.read(directory, &COLUMNS, &[]).map_err(|error| told(error.to_string()))?;
        let [x, y, along, across] = COLUMNS.map(|name| columns.column(name));
        let places = x.iter().zip(y).zip(along.iter().zip(across));
        let points: Vec<_> =
            places.map(|((x, y), (along, across))| [*x, *y, *along, *across]).collect();
        AddedSlip::new(&points).map(Arc::new).map_err(|error| told(error.to_string()))
    }

    /// The file of its points, where one has them.
    pub(crate) fn file(&self, directory: &Path) -> Option<PathBuf> {
        self.0.file(directory)
    }
}
