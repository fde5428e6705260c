//! Studies of rolling contact: a case file is read, solved and reported.
//!
//! The map of this room, in the order in which data flows through it:
//!
//! | | |
//! |---|---|
//! | case files | [`CaseFile`], [`StaticsFile`], [`Sweep`], their schemas |
//! | cases | [`Case`] and its [`TheorySpec`](creepage::TheorySpec), [`theory_spec`] |
//! | histories | [`RollFile`] gives a [`RollCase`], which a [`History`] moves: [`HistoryRun`]; [`RollStepper`] |
//! | wheelsets | [`WheelsetFile`] gives a [`WheelsetCase`], this a [`SolvedWheelset`]; [`conicity`], [`WheelsetTable`] |
//! | solved | [`solve`] gives a [`SolvedCase`]; [`StaticsCase`], [`SweepRun`], [`Curves`], [`Stresses`] |
//! | bearings | [`BearingFile`] gives a [`BearingCase`], this a [`BearingReport`] |
//! | many | [`BulkCase`]: one case with [`Varied`] quantities in rows; [`Solver`]: many [`BulkQuery`]s |
//! | reported | [`SolvedCase::text`], [`SolvedCase::report`], [`SolvedCase::write`]; [`Caution`] |
//! | any shape | [`GapFile`] gives a [`GapCase`], [`solve_gap`] a [`SolvedCase`] like any other |
//! | fitted | [`MeasuredPoints`] over [`Curves`]; [`Fit`]: friction from measured forces, with its uncertainty |
//! | measured | [`measure`]: how far a theory is from the full one over [`steady_rolling`] or a [`grid()`]; [`SquareGrid`] |
//! | written | [`WholeFile`] and [`write_all`]: files that appear when they are whole |
//!
//! ```
//! use creepage_study::CaseFile;
//! let text = r#"
//!     [upper]                  # a wheel
//!     shear_modulus = 82e9
//!     poisson = 0.28
//!     radius_rolling = 0.46
//!     radius_lateral = "flat"
//!     [lower]                  # a rail
//!     shear_modulus = 82e9
//!     poisson = 0.28
//!     radius_rolling = "flat"
//!     radius_lateral = 0.30
//!     [contact]
//!     normal_force = 80e3
//!     friction = 0.3
//!     [creepage]
//!     longitudinal = -1.5e-3
//! "#;
//! let case = CaseFile::read(text)?.case()?;
//! assert!((case.creepage()?.xi() + 0.62).abs() < 0.01);
//!
//! let error = CaseFile::read(&text.replace("friction", "fricton")).unwrap_err();
//! assert_eq!(error.to_string(), "unknown key `fricton` in [contact]: did you mean `friction`?");
//! # Ok::<(), creepage_study::CaseError>(())
//! ```

mod accuracy;
mod any_case;
mod atomic_file;
mod bearing;
mod bulk;
mod case;
mod caution;
mod contact_picture;
mod cost;
mod curve_picture;
mod curve_words;
mod curves;
mod damage;
mod error;
mod file_set;
#[cfg(test)]
mod fuzz;
mod gap;
mod heat;
mod history;
mod line;
mod measured;
mod points;
mod recent;
mod report;
mod separator;
mod series;
mod solve;
mod sources;
mod stale_temp;
mod statics;
mod stress_picture;
mod stress_points;
mod stress_vtk;
mod stresses;
#[cfg(test)]
mod testing;
mod text;
mod unattainable;
mod vtk;
mod wheelset;
mod write;

pub use accuracy::{
    Accuracy, ReferenceCase, ReferenceError, Spread, SquareGrid, grid, measure, steady_rolling,
};
pub use any_case::{AnyCase, AnyCaseFile};
pub use atomic_file::WholeFile;
pub use bearing::{BearingCase, BearingCaseError, BearingFile, BearingReport, bearing_json_schema};
pub use bulk::{
    BulkAnswer, BulkCase, BulkColumn, BulkQuery, BulkRow, Reply, RowError, Solver, Varied,
};
pub use case::keys::{misspelt, plain_words};
pub use case::{
    Case, CaseError, CaseFile, Given, SecondStart, SpecError, StaticsCase, StaticsError,
    StaticsFile, StaticsProblem, Sweep, SweepCase, json_schema, statics_json_schema,
    sweep_json_schema, theory_spec,
};
pub use caution::Caution;
pub use cost::long_work;
pub use creepage_wheelset::{
    ANSWERS, ASKED, ContactChanges, Drive, ForceDerivative, FrictionOfPlace, Load, Patches,
    PitchRate, PlaceOnRail, RailFriction, RailSprings, Resultant, RigidSlip, SolvedContact,
    SolvedWheel, SolvedWheelset, StateVariable, SteppedWheelset, StepsStart, SurfaceLimits,
    WheelSteps, WheelsetDerivatives, WheelsetError, WheelsetPose, WheelsetSolver, WheelsetVelocity,
    asked,
};
pub use curves::{Component, Curves, LargestForce};
pub use damage::{Damage, DamageWanted, WearRow};
pub use error::ReportError;
pub use file_set::write_all;
pub use gap::{
    CurvedJson, GapCase, GapCaseError, GapFile, GapFileError, GapRows, GapSolver, GapValue,
    GapVaried, LoadOrApproach, Roller, SiGiven, gap_json_schema, pressed_text, solve_gap,
};
pub use heat::{Heat, HeatWanted, HeatedRow};
pub use history::{
    HISTORY_COLUMNS, History, HistoryError, HistoryMotion, HistoryRow, HistoryRun, HistoryWriter,
    MotionError, RollCase, RollFile, RollStart, RollStepper, history_animation, history_picture,
    roll_json_schema, to_png,
};
pub use line::{LineCase, LineFile, LinePoint, LineTheory, SolvedLine, line_json_schema};
pub use measured::{
    Fit, FitCaution, FitError, FitOptions, Fitted, FittedPoint, MeasuredError, MeasuredPoint,
    MeasuredPoints, UnreadRow,
};
pub use report::{PerUnit, Quantity, Report, Unit, hertz_report, pressed_report};
pub use series::{SeriesHead, SeriesRow, SweepRun, Tally, series_csv, series_json, series_netcdf};
pub use solve::{SolveError, SolvedCase, solve};
pub use sources::Sources;
pub use statics::StaticsReport;
pub use stress_points::{PointsError, read_points};
pub use stresses::{StressError, StressFileError, StressPoint, Stresses, stress_csv};
pub use text::hertz_text;
pub use unattainable::UnattainableForce;
pub use wheelset::{
    ConicityTable, MapBuildError, MapPlan, MapProgress, MapResolution, MapStage, PackedWheelset,
    ProfileNote, TableAxis, VehicleInCurve, WHEEL_STEP_COLUMNS, WHEEL_STEP_NUMBERS, Wear, WearEnd,
    WearError, WearLaw, WearLimit, WearMeasure, WearPlan, WearProgress, WearSituation, WearStop,
    WheelStepsRun, WheelTable, WheelTableError, WheelsetCase, WheelsetFile, WheelsetFileError,
    WheelsetReport, WheelsetTable, WornBodies, WornBody, WornProfile, WornSides, build_map,
    conicity, profile_pictures, radius_difference_csv, wear, wheelset_caution_words,
    wheelset_cautions, wheelset_json_schema,
};
