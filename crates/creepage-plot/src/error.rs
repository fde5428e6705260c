//! Error of a picture that could not be made.

use resvg::usvg;

/// Error of a rasterization.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// The picture could not be read back for rasterising.
    #[error("cannot read the picture back: {0}")]
    Picture(#[from] usvg::Error),
    /// The picture could not be turned into pixels.
    #[error("cannot make a picture of {width} x {height} pixels")]
    Pixels {
        /// Width (pixels).
        width: u32,
        /// Height (pixels).
        height: u32,
    },
    /// An animation has no pictures.
    #[error("an animation needs a picture")]
    NoPicture,
    /// An animation could not be put together.
    #[error("cannot put the pictures of an animation together: {0}")]
    Animation(#[from] png::EncodingError),
}
