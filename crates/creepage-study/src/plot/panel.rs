//! One frame with its axes, and what is drawn in it.

use super::ink::{Fill, Mark, Pen};
use super::scale::Scale;
use crate::clip::clip;
use crate::label::Label;
use crate::scene::{Anchor, Ink, Point, Scene, Type};
use crate::sheet::{Area, DARK, GREY, PALE};

const NUMBERS: Type = Type { size: 15.5, colour: DARK, bold: false, anchor: Anchor::Middle };
const WORDS: Type = Type { size: 17.0, colour: DARK, bold: false, anchor: Anchor::Middle };
const TICK: f64 = 5.0;

/// A frame with two axes, and what is drawn over it, in the order in which it is added. What
/// leaves the frame is cut, but for texts.
#[derive(Debug, Clone)]
pub struct Panel {
    x: Scale,
    y: Scale,
    heading: Option<Label>,
    height: f64,
    to_scale: bool,
    bare: bool,
    items: Vec<Item>,
}

#[derive(Debug, Clone)]
enum Item {
    Curve(Vec<Point>, Pen),
    Marks(Vec<Point>, Mark),
    Area(Vec<Vec<Point>>, Fill),
    Arrow([Point; 2], f64, &'static str),
    Text(Point, Anchor, Label),
}

impl Panel {
    /// An empty panel.
    #[must_use]
    pub fn new(x: Scale, y: Scale) -> Self {
        let (heading, items) = (None, Vec::new());
        Self { x, y, heading, height: 380.0, to_scale: false, bare: false, items }
    }

    /// With words above it, beside the name of the upright axis.
    #[must_use]
    pub fn heading(self, heading: Label) -> Self {
        Self { heading: Some(heading), ..self }
    }

    /// With a frame of this height, in units of the sheet, which is 760 wide.
    #[must_use]
    pub const fn height(mut self, height: f64) -> Self {
        self.height = height;
        self
    }

    /// With a unit of one axis as long as that of the other: the height follows from the width.
    #[must_use]
    pub const fn to_scale(mut self) -> Self {
        self.to_scale = true;
        self
    }

    /// Without frame, grid and numbers.
    #[must_use]
    pub const fn bare(mut self) -> Self {
        self.bare = true;
        self
    }

    /// Adds a line.
    #[must_use]
    pub fn curve(self, points: Vec<Point>, pen: Pen) -> Self {
        self.with(Item::Curve(points, pen))
    }

    /// Adds marks.
    #[must_use]
    pub fn marks(self, points: Vec<Point>, mark: Mark) -> Self {
        self.with(Item::Marks(points, mark))
    }

    /// Adds an area between closed polygons, one inside another being a hole. Polygons must not
    /// leave the frame.
    #[must_use]
    pub fn area(self, polygons: Vec<Vec<Point>>, fill: Fill) -> Self {
        self.with(Item::Area(polygons, fill))
    }

    /// Adds an arrow of a width in units of the sheet.
    #[must_use]
    pub fn arrow(self, from: Point, to: Point, width: f64, colour: &'static str) -> Self {
        self.with(Item::Arrow([from, to], width, colour))
    }

    /// Adds words; the place is on their baseline.
    #[must_use]
    pub fn text(self, at: Point, anchor: Anchor, label: Label) -> Self {
        self.with(Item::Text(at, anchor, label))
    }

    fn with(mut self, item: Item) -> Self {
        self.items.push(item);
        self
    }

    /// Room above and below the frame.
    pub(super) fn margins(&self) -> [f64; 2] {
        match (self.bare, self.heading.is_some()) {
            (true, false) => [6.0, 6.0],
            (true, true) => [36.0, 6.0],
            _ => [38.0, 62.0],
        }
    }

    /// Height of the frame in a sheet that leaves it this width.
    pub(super) fn frame_height(&self, width: f64) -> f64 {
        if self.to_scale { width * self.y.span() / self.x.span() } else { self.height }
    }

    pub(super) fn draw(&self, scene: &mut Scene, frame: Area) {
        let view = View { x: &self.x, y: &self.y, frame };
        if !self.bare {
            view.grid(scene);
        }
        for item in &self.items {
            view.item(scene, item);
        }
        if !self.bare {
            view.axes(scene);
        }
        if let Some(heading) = &self.heading {
            let (x, anchor) = if self.bare {
                (f64::midpoint(frame.from[0], frame.to[0]), Anchor::Middle)
            } else {
                (frame.to[0], Anchor::End)
            };
            scene.text([x, frame.from[1] - 17.0], WORDS.anchored(anchor), heading);
        }
    }
}

/// A frame on the sheet and its scales.
struct View<'a> {
    x: &'a Scale,
    y: &'a Scale,
    frame: Area,
}

impl View<'_> {
    fn at(&self, [x, y]: Point) -> Point {
        let Area { from: [left, top], to: [right, bottom] } = self.frame;
        [left + self.x.share(x) * (right - left), bottom - self.y.share(y) * (bottom - top)]
    }

    fn grid(&self, scene: &mut Scene) {
        let Area { from: [left, top], to: [right, bottom] } = self.frame;
        let ink = |value: f64| match value {
            0.0 => Ink::line(GREY, 1.0),
            _ => Ink::line(PALE, 0.8),
        };
        for (value, _) in self.x.numbers() {
            let [x, _] = self.at([value, 0.0]);
            scene.line(&[[x, top], [x, bottom]], ink(value));
        }
        for (value, _) in self.y.numbers() {
            let [_, y] = self.at([0.0, value]);
            scene.line(&[[left, y], [right, y]], ink(value));
        }
    }

    fn axes(&self, scene: &mut Scene) {
        let Area { from: [left, top], to: [right, bottom] } = self.frame;
        scene.rectangle([left, top], [right - left, bottom - top], 0.0, Ink::line(GREY, 1.2));
        for (value, text) in self.x.numbers() {
            let [x, _] = self.at([value, 0.0]);
            scene.line(&[[x, bottom], [x, bottom + TICK]], Ink::line(GREY, 1.2));
            scene.text([x, bottom + TICK + 19.0], NUMBERS, &Label::default().number(&text));
        }
        for (value, text) in self.y.numbers() {
            let [_, y] = self.at([0.0, value]);
            scene.line(&[[left - TICK, y], [left, y]], Ink::line(GREY, 1.2));
            let style = NUMBERS.anchored(Anchor::End);
            scene.text([left - TICK - 4.0, y + 5.5], style, &Label::default().number(&text));
        }
        let middle = f64::midpoint(left, right);
        scene.text([middle, bottom + 48.0], WORDS, self.x.label());
        scene.text([left - 34.0, top - 17.0], WORDS.anchored(Anchor::Start), self.y.label());
    }

    fn item(&self, scene: &mut Scene, item: &Item) {
        let place = |points: &[Point]| points.iter().map(|p| self.at(*p)).collect::<Vec<_>>();
        match item {
            Item::Curve(points, pen) => {
                for part in clip(&place(points), self.frame) {
                    scene.line(&part, pen.ink());
                }
            }
            Item::Marks(points, mark) => {
                for point in place(points).into_iter().filter(|point| self.holds(*point)) {
                    mark.draw(scene, point);
                }
            }
            Item::Area(polygons, fill) => {
                let polygons: Vec<_> = polygons.iter().map(|polygon| place(polygon)).collect();
                fill.draw(scene, &polygons);
            }
            Item::Arrow([from, to], width, colour) => {
                scene.arrow(self.at(*from), self.at(*to), *width, colour);
            }
            Item::Text(at, anchor, label) => {
                scene.text(self.at(*at), NUMBERS.anchored(*anchor), label);
            }
        }
    }

    /// Whether a place on the sheet lies in the frame.
    fn holds(&self, place: Point) -> bool {
        // A mark on the edge is in.
        let inside =
            |i: usize| place[i] > self.frame.from[i] - 0.5 && place[i] < self.frame.to[i] + 0.5;
        inside(0) && inside(1)
    }
}
