//! Wear over a distance: a wheelset in many situations, whose profiles are worn step by step.

mod error;
mod limits;
mod nodes;
mod output;
mod picture;
mod rates;
mod run;
mod section;
mod state;
#[cfg(test)]
mod tests;

pub use error::WearError;
pub use limits::{WearEnd, WearLimit, WearMeasure};
pub use run::{Wear, WearProgress, wear};
pub(super) use section::WearSection;
pub use section::{WearLaw, WearPlan, WearSituation, WornBodies, WornSides};
pub use state::{WearStop, WornBody, WornProfile};
