//! A class a theory: its constructor, and what only it can be asked.

mod exact;
mod limits;
mod saturation;
mod springs;
mod strip;
mod variational;

pub(crate) use exact::{Automatic, Exact};
pub(crate) use limits::{Linear, Saturated};
pub(crate) use saturation::{Polach, ShenHedrickElkins, VermeulenJohnson};
pub(crate) use springs::{Fastrip, Fastsim};
pub(crate) use strip::Strip;
pub(crate) use variational::Variational;
