//! Wheelsets in their track: case file, conicity, profiles, solution and reports.
//!
//! Lengths in metres, angles in radians, forces in newtons; `x` forward, `y` to the right, `z`
//! down.

mod case;
mod conicity;
mod error;
mod file;
mod free;
mod friction;
mod geometry_picture;
mod guard;
mod map;
mod packed;
mod position;
mod profile;
mod quantities;
mod rails;
mod report;
mod sections;
mod solved_picture;
mod solved_text;
mod solved_write;
mod steps;
mod steps_picture;
mod table;
mod varying;
mod vehicle;
mod warmth;
mod wear;
mod worn;

pub use case::{ProfileNote, WheelsetCase};
pub use conicity::{ConicityTable, conicity, radius_difference_csv};
pub use error::WheelsetFileError;
pub use file::{WheelsetFile, wheelset_json_schema};
pub use geometry_picture::profile_pictures;
pub use map::{MapBuildError, MapPlan, MapProgress, MapResolution, MapStage, build_map};
pub use packed::PackedWheelset;
pub use report::{WheelsetReport, wheelset_caution_words, wheelset_cautions};
pub use steps::{
    WHEEL_STEP_COLUMNS, WHEEL_STEP_NUMBERS, WheelStepsRun, WheelTable, WheelTableError,
};
pub use table::{TableAxis, WheelsetTable};
pub use vehicle::VehicleInCurve;
pub use worn::{
    Wear, WearEnd, WearError, WearLaw, WearLimit, WearMeasure, WearPlan, WearProgress,
    WearSituation, WearStop, WornBodies, WornBody, WornProfile, WornSides, wear,
};
