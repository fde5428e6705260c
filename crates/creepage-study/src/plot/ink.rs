//! Lines, marks and areas: different in grey print too.

use crate::scene::{Ink, Point, Scene};
use crate::sheet;

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    /// As SVG has it: `#10243a`.
    pub colour: &'static str,
    /// Lengths of dashes and gaps as in `stroke-dasharray`; unbroken where empty.
    pub dashes: &'static str,
    /// In units of the sheet.
    pub width: f64,
}

impl Pen {
    /// A hairline for what should stand back.
    pub const THIN: Self = Self { colour: sheet::GREY, dashes: "", width: 1.1 };
    /// Where something lies.
    pub const GUIDE: Self = Self { colour: sheet::GREY, dashes: "3 4", width: 1.3 };
    /// An outline.
    pub const OUTLINE: Self = Self { colour: sheet::DARK, dashes: "", width: 1.8 };

    /// The pen of curve number `k`: colour, dashes and width all tell one from another.
    #[must_use]
    pub fn of(k: usize) -> Self {
        let (colour, dashes, width) =
            crate::curve_legend::PENS[k % crate::curve_legend::PENS.len()];
        Self { colour, dashes, width }
    }

    /// The same in another width.
    #[must_use]
    pub const fn wide(self, width: f64) -> Self {
        Self { width, ..self }
    }

    pub(super) const fn ink(self) -> Ink {
        Ink::broken_line(self.colour, self.width, self.dashes)
    }
}

/// Outline of a [`Mark`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shape {
    /// A circle.
    Circle,
    /// A square on its side.
    Square,
    /// A square on its corner.
    Diamond,
    /// A triangle on its side.
    Triangle,
    /// Two crossing strokes.
    Cross,
}

/// How a point is marked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mark {
    /// Its outline.
    pub shape: Shape,
    /// As SVG has it.
    pub colour: &'static str,
    /// Filled with its colour, or with white.
    pub filled: bool,
    /// Half its width, in units of the sheet.
    pub size: f64,
}

impl Mark {
    /// A mark of the usual size, white inside.
    #[must_use]
    pub const fn open(shape: Shape, colour: &'static str) -> Self {
        Self { shape, colour, filled: false, size: 4.2 }
    }

    /// A mark of the usual size, filled.
    #[must_use]
    pub const fn full(shape: Shape, colour: &'static str) -> Self {
        Self { shape, colour, filled: true, size: 4.2 }
    }

    pub(super) fn draw(self, scene: &mut Scene, [x, y]: Point) {
        let fill = Ink::fill(if self.filled { self.colour } else { "#ffffff" });
        let ink = fill.outlined(self.colour, 1.5);
        let r = self.size;
        let mut polygon = |corners: &[Point]| {
            let corners = corners.iter().map(|[u, v]| [x + r * u, y + r * v]).collect();
            scene.area(&[corners], ink);
        };
        match self.shape {
            Shape::Circle => scene.circle([x, y], r, ink),
            Shape::Square => polygon(&[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]]),
            Shape::Diamond => polygon(&[[0.0, -1.25], [1.25, 0.0], [0.0, 1.25], [-1.25, 0.0]]),
            Shape::Triangle => polygon(&[[0.0, -1.3], [1.2, 0.85], [-1.2, 0.85]]),
            Shape::Cross => {
                for sign in [-1.0, 1.0] {
                    let ends = [[x - r, y - sign * r], [x + r, y + sign * r]];
                    scene.line(&ends, Ink::line(self.colour, 1.9));
                }
            }
        }
    }
}

/// How an area is filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fill {
    /// As SVG has it.
    pub colour: &'static str,
    /// With slanted hatching over it.
    pub hatched: bool,
}

impl Fill {
    /// The area of adhesion, as in all pictures.
    pub const ADHESION: Self = Self { colour: sheet::ADHESION, hatched: false };
    /// The area of slip, as in all pictures.
    pub const SLIP: Self = Self { colour: sheet::SLIP, hatched: true };

    /// One colour.
    #[must_use]
    pub const fn plain(colour: &'static str) -> Self {
        Self { colour, hatched: false }
    }

    pub(super) fn draw(self, scene: &mut Scene, polygons: &[Vec<Point>]) {
        scene.area(polygons, Ink::fill(self.colour));
        if self.hatched {
            scene.area(polygons, Ink::fill("url(#hatching)"));
        }
    }
}
