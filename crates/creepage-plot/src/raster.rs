//! SVG to PNG, with the font carried along: the same bytes on every machine.

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{self, Options, Tree, fontdb};
use std::sync::Arc;

/// Family that the scenes ask for; one of its faces.
pub(crate) const FONT_FAMILY: &str = "DejaVu Sans";

/// Pixels for each unit of the scene.
const PIXELS_PER_UNIT: u16 = 2;

/// Renders an SVG of this crate as PNG at twice its size, as screens and print want it. The font is
/// carried along: the same bytes on every machine.
///
/// # Errors
/// [`PlotError::Picture`] when it is not an SVG, [`PlotError::Pixels`] when it is too large.
pub fn png(svg: &str) -> Result<Vec<u8>, PlotError> {
    let pixels = pixels(svg, PIXELS_PER_UNIT)?;
    let (width, height) = (pixels.width(), pixels.height());
    pixels.encode_png().map_err(|_| PlotError::Pixels { width, height })
}

/// An SVG of this crate in pixels, so many for each unit of the scene.
pub(crate) fn pixels(svg: &str, pixels_per_unit: u16) -> Result<Pixmap, PlotError> {
    let tree = tree(svg)?;
    let size = tree.size().to_int_size();
    let side = |units: u32| units.saturating_mul(u32::from(pixels_per_unit));
    let (width, height) = (side(size.width()), side(size.height()));
    let mut pixels = Pixmap::new(width, height).ok_or(PlotError::Pixels { width, height })?;
    let zoom = f32::from(pixels_per_unit);
    resvg::render(&tree, Transform::from_scale(zoom, zoom), &mut pixels.as_mut());
    Ok(pixels)
}

/// The parsed picture, its text laid out in the bundled font.
pub(crate) fn tree(svg: &str) -> Result<Tree, PlotError> {
    let mut fonts = fontdb::Database::new();
    for face in [
        dejavu::sans_condensed::regular(),
        dejavu::sans_condensed::oblique(),
        dejavu::sans_condensed::bold(),
    ] {
        fonts.load_font_data(face.to_vec());
    }
    fonts.set_sans_serif_family(FONT_FAMILY);
    let options =
        Options { font_family: FONT_FAMILY.into(), fontdb: Arc::new(fonts), ..Options::default() };
    Ok(Tree::from_str(svg, &options)?)
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ink::Ink;
    use crate::label::Label;
    use crate::scene::{Scene, Type};

    #[test]
    fn text_is_drawn_without_any_installed_font() {
        let mut scene = Scene::new();
        let label = Label::default().symbol("ξηχμυφ").plain("N").indexed("F", "x");
        scene.text([5.0, 30.0], Type::new(24.0, "#000000"), &label);
        let pixels = Pixmap::decode_png(&png(&scene.finish([200.0, 40.0], "")).unwrap()).unwrap();
        assert_eq!((pixels.width(), pixels.height()), (400, 80));
        assert!(pixels.pixels().iter().filter(|pixel| pixel.red() < 128).count() > 500);
    }

    #[test]
    fn a_sheet_without_size_is_an_error() {
        let mut scene = Scene::new();
        scene.line(&[[0.0, 0.0], [1.0, 1.0]], Ink::line("#000000", 1.0));
        let svg = scene.finish([0.0, 10.0], "");
        assert!(matches!(png(&svg), Err(PlotError::Picture(_))));
    }
}
