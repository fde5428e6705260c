//! Measured forces: read from a table, laid over creep-force curves, and friction fitted to them (Figs 14 and 15,
//! (5.31): the experiments of Johnson and of Haines and Ollerton).
//!
//! [`MeasuredPoints`] are the table; [`Fit`] is what they say of friction by a theory, with its
//! uncertainty and the points that do not belong to the others.

mod fit;
mod fitted;
mod least_squares;
mod model;
mod over_curves;
pub(crate) mod picture;
mod points;
mod report;

pub use fitted::{Fit, FitCaution, FitError, FitOptions, Fitted, FittedPoint};
pub(crate) use over_curves::Overlaid;
pub use points::{MeasuredError, MeasuredPoint, MeasuredPoints, UnreadRow};
