//! A wheelset in its track: the case file, its conicity; profiles and what was done to them.
//!
//! Lengths in metres, angles in radians, forces in newtons; `x` forward, `y` to the right, `z`
//! down.

mod asked;
mod case;
mod conicity;
mod correction;
mod curving;
mod derivatives;
mod derivatives_json;
mod error;
mod field;
mod file;
mod free;
mod friction;
mod geometry_picture;
mod map;
mod nearby;
mod position;
mod profile;
mod profile_picture;
mod resultant;
mod rough;
mod sections;
mod solved;
mod solved_json;
mod solved_picture;
mod solved_text;
mod solved_write;
mod solver;
mod springs;
mod table;
mod warmth;
mod wear;

pub use asked::{ANSWERS, ASKED};
pub use case::{
    Drive, Load, Patches, PitchRate, ProfileNote, RigidSlip, Stance, Travel, WheelsetCase,
};
pub use conicity::{ConicityTable, conicity, radius_difference_csv};
pub use derivatives::{By, ForceDerivative, WheelsetDerivatives};
pub use derivatives_json::{DerivativesJson, ForceDerivativeJson};
pub use error::WheelsetError;
pub use file::{WheelsetFile, wheelset_json_schema};
pub use friction::{FrictionOfPlace, PlaceOnRail, RailFriction};
pub use map::{MapBuildError, MapPlan, MapProgress, MapResolution, MapStage, build_map};
pub use profile_picture::profile_pictures;
pub use resultant::Resultant;
pub use solved::{SolvedContact, SolvedWheel, SolvedWheelset};
pub use solved_json::{RailForceJson, WheelJson, WheelPatchJson, WheelsetReportJson};
pub use solver::WheelsetSolver;
pub use springs::RailSprings;
pub use table::WheelsetTable;
