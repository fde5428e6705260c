//! A contact of any shape that rolls.

use creepage::coulomb::Resolution;
use creepage::normal;

use super::case::{Kind, RollCase, Start, resolution};
use super::error::HistoryError;
use crate::CaseError;
use crate::gap::{GapCase, GapTheory, pressed, resolutions};

/// The case of a history from the one of steady rolling.
pub(super) fn case(case: &GapCase) -> Result<RollCase, HistoryError> {
    let options = match case.theory {
        GapTheory::Exact(options) => options,
        GapTheory::Simplified(..) if case.theory.name() == "fastsim" => {
            return Err(HistoryError::NotOfFastsim { what: "[gap]" });
        }
        GapTheory::Simplified(..) => {
            return Err(HistoryError::Theory { theory: case.theory.name() });
        }
    };
    resolutions(options)?;
    let resolution = resolution(&options)?;
    let fineness = match resolution {
        Resolution::FAST => normal::Resolution::FAST,
        _ => normal::Resolution::FINE,
    };
    let contact = pressed(case, fineness)?;
    let scaling = contact.scaling(case.friction).map_err(CaseError::invalid("contact"))?;
    let load = contact.load().value;
    let kind = Kind::Areas { contact, resolution, friction: case.rolling_friction };
    Ok(RollCase { scaling, load, friction: case.friction, kind, start: Start::None })
}
