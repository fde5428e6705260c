//! The strip system: strips along rolling whose pressures vanish as a root at ends that are unknowns
//! themselves, and Newton's method finds both. All is in the solver's units, and nothing is known of gaps
//! and contact areas but the depth at a place.

mod kernel;
mod newton;
mod peak_pressure;
mod rules;
mod side;
mod sources;
mod strip;
mod system;

pub(crate) use kernel::profile;
pub(super) use newton::StripFailure;
pub(crate) use newton::{Factors, StripProblem, StripSolution, solve};
pub(super) use peak_pressure::height;
pub(super) use rules::CENTRED;
pub(crate) use rules::MAX_TERMS;
pub(super) use sources::Sources;
pub(crate) use strip::Strip;
pub(super) use strip::{peak, top};
pub(super) use system::Depth;
