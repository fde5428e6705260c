//! A small SVG builder: shapes, arrows and labels on a white sheet, y downwards.

use std::fmt::Write as _;

use crate::format::fixed;
use crate::ink::Ink;
use crate::label::Label;
use crate::raster::FONT_FAMILY;

/// A place on the sheet with `y` downwards, or in units of a panel's axes.
pub type Point = [f64; 2];

/// Anchor of a label: the part of it that its place names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
    /// Its right end.
    End,
}

/// Typeface of a label.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Type {
    pub(crate) size: f64,
    pub(crate) colour: &'static str,
    pub(crate) bold: bool,
    pub(crate) anchor: Anchor,
}

impl Type {
    /// Regular text that starts at its place.
    pub(crate) fn new(size: f64, colour: &'static str) -> Self {
        Self { size, colour, bold: false, anchor: Anchor::Start }
    }

    /// The same in bold.
    pub(crate) fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// The same with another part at its place.
    pub(crate) fn anchored(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }
}

/// A sheet under construction.
#[derive(Debug)]
pub(crate) struct Scene {
    definitions: String,
    body: String,
}

impl Scene {
    /// An empty sheet.
    pub(crate) fn new() -> Self {
        Self { definitions: String::new(), body: String::new() }
    }

    /// The sheet of `width` by `height` as SVG, described in words for those who cannot see it.
    pub(crate) fn finish(self, [width, height]: [f64; 2], description: &str) -> String {
        let (width, height) = (number(width), number(height));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"'{FONT_FAMILY} Condensed', \
             '{FONT_FAMILY}', sans-serif\" font-stretch=\"condensed\">\n\
             <title>{}</title>\n<defs>\n{}</defs>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{}</svg>\n",
            Label::new(description).svg(),
            self.definitions,
            self.body
        )
    }

    /// Defines the slanted hatching that [`Ink::fill`] takes as `url(#id)`.
    pub(crate) fn hatching(&mut self, id: &str, colour: &str, spacing: f64, width: f64) {
        let (spacing, middle) = (number(spacing), number(0.5 * spacing));
        let _ = writeln!(
            self.definitions,
            "<pattern id=\"{id}\" width=\"{spacing}\" height=\"{spacing}\" \
             patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">\
             <path d=\"M{middle} 0V{spacing}\" stroke=\"{colour}\" stroke-width=\"{width}\"/>\
             </pattern>"
        );
    }

    /// A rectangle with rounded corners.
    pub(crate) fn rectangle(&mut self, [x, y]: Point, size: [f64; 2], radius: f64, ink: Ink) {
        self.element(
            &format!(
                "rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"{}\"",
                number(x),
                number(y),
                number(size[0]),
                number(size[1]),
                number(radius)
            ),
            ink,
        );
    }

    /// An ellipse with semi-axes along x and y.
    pub(crate) fn ellipse(&mut self, centre: Point, semi_axes: [f64; 2], ink: Ink) {
        self.element(
            &format!(
                "ellipse cx=\"{}\" cy=\"{}\" rx=\"{}\" ry=\"{}\"",
                number(centre[0]),
                number(centre[1]),
                number(semi_axes[0]),
                number(semi_axes[1])
            ),
            ink,
        );
    }

    /// A circle.
    pub(crate) fn circle(&mut self, centre: Point, radius: f64, ink: Ink) {
        self.ellipse(centre, [radius, radius], ink);
    }

    /// An open line through `points`.
    pub(crate) fn line(&mut self, points: &[Point], ink: Ink) {
        let data = path_data(points);
        self.element(&format!("path d=\"{data}\" stroke-linejoin=\"round\""), ink);
    }

    /// Closed polygons drawn as one area; one inside another is a hole.
    pub(crate) fn area(&mut self, polygons: &[Vec<Point>], ink: Ink) {
        let data: String = polygons.iter().map(|polygon| path_data(polygon) + "Z").collect();
        self.element(
            &format!("path d=\"{data}\" fill-rule=\"evenodd\" stroke-linejoin=\"round\""),
            ink,
        );
    }

    /// A straight arrow. Its head shrinks with a short arrow; a point where it has no length.
    pub(crate) fn arrow(&mut self, from: Point, to: Point, width: f64, colour: &'static str) {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let length = dx.hypot(dy);
        if length < width {
            let middle = [f64::midpoint(from[0], to[0]), f64::midpoint(from[1], to[1])];
            return self.circle(middle, 0.5 * width, Ink::fill(colour));
        }
        let (along, across) = ([dx / length, dy / length], [-dy / length, dx / length]);
        let head = (4.6 * width).min(0.6 * length);
        let (half, barb) = (0.5 * width * (head / (4.6 * width)).sqrt(), 0.4 * head);
        let corner = |l: f64, w: f64| [0, 1].map(|i| from[i] + l * along[i] + w * across[i]);
        let (neck, back) = (length - 0.86 * head, length - head);
        let outline = vec![
            corner(0.0, half),
            corner(neck, half),
            corner(back, barb),
            to,
            corner(back, -barb),
            corner(neck, -half),
            corner(0.0, -half),
        ];
        self.area(&[outline], Ink::fill(colour));
    }

    /// A label whose baseline passes through `at`, white around its letters.
    pub(crate) fn haloed_text(&mut self, at: Point, style: Type, label: &Label) {
        let halo = " stroke=\"#ffffff\" stroke-width=\"10\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
        self.styled_text(at, style, label, halo);
    }

    /// A label whose baseline passes through `at`.
    pub(crate) fn text(&mut self, at: Point, style: Type, label: &Label) {
        self.styled_text(at, style, label, "");
    }

    fn styled_text(&mut self, at: Point, style: Type, label: &Label, more: &str) {
        let anchor = match style.anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let weight = if style.bold { " font-weight=\"bold\"" } else { "" };
        let _ = writeln!(
            self.body,
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{anchor}\"{weight}{more}>\
             {}</text>",
            number(at[0]),
            number(at[1]),
            number(style.size),
            style.colour,
            label.svg()
        );
    }

    fn element(&mut self, element: &str, ink: Ink) {
        let _ = writeln!(self.body, "<{element} {}/>", ink.attributes());
    }
}

fn path_data(points: &[Point]) -> String {
    let mut data = String::new();
    for (k, point) in points.iter().enumerate() {
        let command = if k == 0 { 'M' } else { 'L' };
        let _ = write!(data, "{command}{} {}", number(point[0]), number(point[1]));
    }
    data
}

/// A coordinate to a hundredth of a unit.
fn number(value: f64) -> String {
    fixed(value, 2).trim_end_matches('0').trim_end_matches('.').to_string()
}
