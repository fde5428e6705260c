//! Bodies of any shape pressed together.

use creepage::normal::{self, NormalContact, NormalError};

use super::case::{GapCase, LoadOrApproach};
use super::error::GapCaseError;

/// As many rows along a roller, whose ends are short beside it, through every door.
const ALONG_A_ROLLER: usize = 100;

/// The bodies pressed together.
pub(crate) fn pressed(
    case: &GapCase,
    resolution: normal::Resolution,
) -> Result<NormalContact, GapCaseError> {
    pressed_together(case, resolution).map_err(|source| not_pressed(case, source))
}

pub(super) fn pressed_together(
    case: &GapCase,
    resolution: normal::Resolution,
) -> Result<NormalContact, NormalError> {
    let fine = case.roller.and_then(|_| normal::Resolution::new(ALONG_A_ROLLER).ok());
    let resolution = fine.unwrap_or(resolution);
    match case.pressed {
        LoadOrApproach::Load(load) => {
            NormalContact::under_load(&case.gap, case.pair, load, resolution)
        }
        LoadOrApproach::Approach(approach) => {
            NormalContact::at_approach(&case.gap, case.pair, approach, resolution)
        }
    }
}

/// The error of bodies that have no contact.
pub(super) fn not_pressed(case: &GapCase, source: NormalError) -> GapCaseError {
    let pressed = match case.pressed {
        LoadOrApproach::Load(load) => format!("normal_force = {load}"),
        LoadOrApproach::Approach(approach) => format!("approach = {approach}"),
    };
    GapCaseError::Normal { shape: case.shape.clone(), pressed, source }
}

/// The largest distance of the contact from the origin of coordinates (m), or a little more.
pub(super) fn reach(contact: &NormalContact) -> f64 {
    let largest = |[low, high]: [f64; 2]| low.abs().max(high.abs());
    let extents = contact.patches().iter().map(normal::Patch::extent);
    extents.map(|extent| largest(extent.x).hypot(largest(extent.y))).fold(0.0, f64::max)
}
