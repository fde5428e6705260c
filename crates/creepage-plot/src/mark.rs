//! Lines, marks and areas: different in grey print too.

use crate::ink::Ink;
use crate::scene::{Point, Scene};
use crate::theme;

/// Pens of curves: each differs from the others in grey print too.
const PENS: [(&str, &str, f64); 10] = [
    ("#10243a", "", 2.6),
    ("#c62828", "11 4", 2.4),
    ("#1565c0", "2.5 3.5", 2.8),
    ("#2e7d32", "13 4 2.5 4", 2.4),
    ("#8e24aa", "6 3", 2.2),
    ("#d07000", "14 3.5 2.5 3.5 2.5 3.5", 2.4),
    ("#00838f", "22 5", 2.2),
    ("#6d4c41", "2.5 7", 3.0),
    ("#78909c", "", 3.4),
    ("#ad1457", "6 3 6 3 2 3", 2.2),
];

/// Pen of a line: colour, dashes, width.
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
    pub const THIN: Self = Self { colour: theme::GREY, dashes: "", width: 1.1 };
    /// Where something lies.
    pub const GUIDE: Self = Self { colour: theme::GREY, dashes: "3 4", width: 1.3 };
    /// An outline.
    pub const OUTLINE: Self = Self { colour: theme::DARK, dashes: "", width: 1.8 };

    /// The pen of curve number `k`: colour, dashes and width all tell one from another.
    #[must_use]
    pub fn of(k: usize) -> Self {
        let (colour, dashes, width) = PENS[k % PENS.len()];
        Self { colour, dashes, width }
    }

    /// The same in another width.
    #[must_use]
    pub const fn wide(self, width: f64) -> Self {
        Self { width, ..self }
    }

    pub(crate) const fn ink(self) -> Ink {
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
    /// A ring with a point in it.
    Target,
}

/// Marker of a point.
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

    pub(crate) fn draw(self, scene: &mut Scene, [x, y]: Point) {
        let fill = Ink::fill(if self.filled { self.colour } else { "#ffffff" });
        let ink = fill.outlined(self.colour, 1.5);
        let r = self.size;
        let mut polygon = |corners: &[Point]| {
            let corners = corners.iter().map(|[u, v]| [x + r * u, y + r * v]).collect();
            scene.area(&[corners], ink);
        };
        match self.shape {
            Shape::Circle => scene.circle([x, y], r, ink),
            Shape::Target => {
                scene.circle([x, y], r, Ink::fill("#ffffff").outlined(self.colour, 2.2));
                scene.circle([x, y], 2.2, Ink::fill(self.colour));
            }
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

/// Fill of an area.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fill {
    /// As SVG has it.
    pub colour: &'static str,
    /// With slanted hatching over it.
    pub hatched: bool,
}

impl Fill {
    /// An area of adhesion.
    pub const ADHESION: Self = Self { colour: theme::FULL, hatched: false };
    /// An area of slip.
    pub const SLIP: Self = Self { colour: theme::FAINT, hatched: true };

    /// One colour.
    #[must_use]
    pub const fn plain(colour: &'static str) -> Self {
        Self { colour, hatched: false }
    }

    pub(crate) fn draw(self, scene: &mut Scene, polygons: &[Vec<Point>]) {
        scene.area(polygons, Ink::fill(self.colour));
        if self.hatched {
            scene.area(polygons, Ink::fill("url(#hatching)"));
        }
    }
}
