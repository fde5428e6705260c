//! Carter's theory, strip theory, FASTSIM and FaStrip.

mod carter;
mod cases;
mod derivatives;
mod fastrip;
mod fastsim;
mod plane;
mod properties;
mod strip;
