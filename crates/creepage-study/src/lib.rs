//! Studies of rolling contact: a case file is read, solved and reported.
//!
//! The map of this room, in the order in which data flows through it:
//!
//! | | |
//! |---|---|
//! | case files | [`CaseFile`], [`StaticsFile`], [`Sweep`], their schemas |
//! | theories by name | [`choose`], [`find`], [`PreparedTheory`] |
//! | solved | [`SolvedCase`], [`StaticsCase`] |
//! | reported | [`Report`], [`StaticsReport`], [`Curves`]; a sweep by [`SweepRun`] and [`series_csv`] |
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
//! assert!((case.creepage.xi + 0.62).abs() < 0.01);
//!
//! let error = CaseFile::read(&text.replace("friction", "fricton")).unwrap_err();
//! assert_eq!(error.to_string(), "unknown key `fricton` in [contact]: did you mean `friction`?");
//! # Ok::<(), creepage_study::CaseError>(())
//! ```

mod areas;
mod axis;
mod caption;
mod case;
mod clip;
mod contact_json;
mod contact_picture;
mod contact_view;
mod curve_axes;
mod curve_legend;
mod curve_panel;
mod curve_picture;
mod curves;
mod error;
mod format;
mod json;
mod label;
mod legend;
mod page;
mod plane;
pub mod plot;
mod points;
mod raster;
mod report;
mod scene;
mod series;
mod sheet;
mod statics;
#[cfg(test)]
mod testing;
mod text;
mod theories;
mod vtk;
mod whole_file;
mod write;

pub use areas::Areas;
pub use case::{
    Bound, Case, CaseError, CaseFile, Flexibility, InverseCase, Resolution, SecondStart, Solve,
    StaticsCase, StaticsError, StaticsFile, Sweep, SweepCase, Variant, Weight, json_schema,
    statics_json_schema, sweep_json_schema,
};
pub use contact_json::{HertzJson, SolidJson, hertz_json};
pub use curves::{Component, Curves};
pub use error::ReportError;
pub use json::{AreasJson, CreepageJson, DetailJson, DimensionlessJson, ForceJson, ReportJson};
pub use page::{Page, PageStyle};
pub use raster::{png, tree as picture};
pub use report::{Answer, Extras, Report};
pub use series::{SeriesHead, SeriesRow, SweepRun, Tally, series_csv, series_json, series_netcdf};
pub use statics::StaticsReport;
pub use text::hertz_text;
pub use theories::{
    Answered, Choice, ChoiceError, Detail, ENTRIES, Entry, Examination, FindError, LeftOut,
    PreparedTheory, SolvedCase, TheoryError, UnknownTheory, Unreachable, choose, find,
    kappa_over_mu, variational_settings, wanted_accuracy,
};
pub use whole_file::{WholeFile, write_all};
