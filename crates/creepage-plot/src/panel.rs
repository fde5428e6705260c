//! Panel: one frame with its axes, and what is drawn in it.

use crate::axis::Axis;
use crate::clip::{Frame, clip};
use crate::contour::closed;
use crate::ink::Ink;
use crate::label::Label;
use crate::mark::{Fill, Mark, Pen};
use crate::names::{self, Name};
use crate::scene::{Anchor, Point, Scene, Type};
use crate::theme::{DARK, GREY, PALE};

const NUMBERS: Type = Type { size: 15.5, colour: DARK, bold: false, anchor: Anchor::Middle };
const WORDS: Type = Type { size: 17.0, colour: DARK, bold: false, anchor: Anchor::Middle };
const TICK: f64 = 5.0;
/// Room for the numbers of an axis on the right.
const RIGHT: f64 = 62.0;

/// A frame with two axes, and what is drawn over it, in the order in which it is added. What
/// leaves the frame is cut, but for texts.
#[derive(Debug, Clone)]
pub struct Panel {
    x: Axis,
    y: Axis,
    top: Option<Axis>,
    right: Option<Axis>,
    heading: Option<Label>,
    height: f64,
    to_scale: bool,
    bare: bool,
    items: Vec<Item>,
    /// Names of curves, and the places at which these end.
    names: Vec<(Name, Point)>,
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
    pub fn new(x: Axis, y: Axis) -> Self {
        let (top, right, heading, items, names) = (None, None, None, Vec::new(), Vec::new());
        let (height, to_scale, bare) = (380.0, false, false);
        Self { x, y, top, right, heading, height, to_scale, bare, items, names }
    }

    /// With another axis above, in place of a heading: the same range in another unit.
    #[must_use]
    pub fn top(self, axis: Axis) -> Self {
        Self { top: Some(axis), ..self }
    }

    /// With another axis on the right: the same range in another unit.
    #[must_use]
    pub fn right(self, axis: Axis) -> Self {
        Self { right: Some(axis), ..self }
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

    /// Whether a point lies within its axes: what does not is not seen.
    #[must_use]
    pub fn holds(&self, [x, y]: Point) -> bool {
        [(x, self.x.range), (y, self.y.range)]
            .into_iter()
            .all(|(value, [from, to])| (from.min(to)..=from.max(to)).contains(&value))
    }

    /// Adds a line.
    #[must_use]
    pub fn curve(self, points: Vec<Point>, pen: Pen) -> Self {
        self.with(Item::Curve(points, pen))
    }

    /// Adds a line with its name beside its last point, outside of the frame where it ends near its
    /// right side. Names that would touch are moved apart; where a frame is too low for all of
    /// them, they go to the legend.
    #[must_use]
    pub fn named(self, points: Vec<Point>, pen: Pen, label: Label) -> Self {
        match points.last().copied() {
            Some(end) => self.curve(points, pen).name(end, pen, label),
            None => self,
        }
    }

    /// Adds the name of what ends at a place, as [`Panel::named`] does.
    #[must_use]
    pub fn name(mut self, end: Point, pen: Pen, label: Label) -> Self {
        self.names.push((Name { label, pen }, end));
        self
    }

    /// Adds the borders of closed polygons, in one pen.
    #[must_use]
    pub fn outlines(self, polygons: &[Vec<Point>], pen: Pen) -> Self {
        polygons.iter().cloned().map(closed).fold(self, |panel, border| panel.curve(border, pen))
    }

    /// Adds lines in one pen.
    #[must_use]
    pub fn curves(self, lines: &[Vec<Point>], pen: Pen) -> Self {
        lines.iter().cloned().fold(self, |panel, line| panel.curve(line, pen))
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
    pub(crate) fn margins(&self) -> [f64; 2] {
        match (self.bare, self.heading.is_some()) {
            (true, false) => [6.0, 6.0],
            (true, true) => [36.0, 6.0],
            _ => [
                if self.top.is_some() { 60.0 } else { 38.0 },
                if self.x.is_shared { 12.0 } else { 62.0 },
            ],
        }
    }

    /// Room on the right of the frame.
    pub(crate) fn right_margin(&self) -> f64 {
        let names = self.names.iter().filter(|(_, end)| self.has_room() && self.ends_right(*end));
        self.axis_margin() + names::room(names.map(|(name, _)| name))
    }

    fn axis_margin(&self) -> f64 {
        if self.right.is_some() { RIGHT } else { 0.0 }
    }

    /// Whether a curve ends near the frame's right side.
    fn ends_right(&self, end: Point) -> bool {
        names::is_outside(self.x.share(end[0]))
    }

    /// Whether all names of curves have their place; a panel to scale is tall enough.
    fn has_room(&self) -> bool {
        self.to_scale || names::fit(self.names.len(), self.height)
    }

    /// Names that are to go to the legend.
    pub(crate) fn names_without_room(&self) -> impl Iterator<Item = (Pen, &Label)> {
        let without = self.names.iter().filter(|_| !self.has_room());
        without.map(|(name, _)| (name.pen, &name.label))
    }

    /// Height of the frame in a sheet that leaves it this width.
    pub(crate) fn frame_height(&self, width: f64) -> f64 {
        if self.to_scale { width * self.y.span() / self.x.span() } else { self.height }
    }

    pub(crate) fn draw(&self, scene: &mut Scene, frame: Frame) {
        let view = View { panel: self, frame };
        if !self.bare {
            view.grid(scene);
        }
        for item in &self.items {
            view.item(scene, item);
        }
        if !self.bare {
            view.axes(scene);
        }
        if self.has_room() {
            view.names(scene);
        }
        if let Some(heading) = &self.heading {
            let (x, anchor) = if self.bare {
                (frame.centre()[0], Anchor::Middle)
            } else {
                (frame.to[0], Anchor::End)
            };
            scene.text([x, frame.from[1] - 17.0], WORDS.anchored(anchor), heading);
        }
    }
}

/// A frame on the sheet and its panel.
struct View<'a> {
    panel: &'a Panel,
    frame: Frame,
}

impl View<'_> {
    fn at(&self, [x, y]: Point) -> Point {
        [self.across(self.panel.x.share(x)), self.up(self.panel.y.share(y))]
    }

    fn across(&self, share: f64) -> f64 {
        self.frame.from[0] + share * (self.frame.to[0] - self.frame.from[0])
    }

    fn up(&self, share: f64) -> f64 {
        self.frame.to[1] - share * (self.frame.to[1] - self.frame.from[1])
    }

    fn grid(&self, scene: &mut Scene) {
        let Frame { from: [left, top], to: [right, bottom] } = self.frame;
        let ink = |value: f64| match value {
            0.0 => Ink::line(GREY, 1.0),
            _ => Ink::line(PALE, 0.8),
        };
        for (value, _) in self.panel.x.numbers() {
            let [x, _] = self.at([value, 0.0]);
            scene.line(&[[x, top], [x, bottom]], ink(value));
        }
        for (value, _) in self.panel.y.numbers() {
            let [_, y] = self.at([0.0, value]);
            scene.line(&[[left, y], [right, y]], ink(value));
        }
    }

    fn axes(&self, scene: &mut Scene) {
        let Frame { from: [left, top], to: [right, bottom] } = self.frame;
        scene.rectangle([left, top], [right - left, bottom - top], 0.0, Ink::line(GREY, 1.2));
        let middle = f64::midpoint(left, right);
        if !self.panel.x.is_shared {
            self.level(scene, &self.panel.x, [bottom, bottom + TICK], bottom + TICK + 19.0);
            scene.text([middle, bottom + 48.0], WORDS, self.panel.x.label());
        }
        self.upright(scene, &self.panel.y, [left - TICK, left], left - TICK - 4.0, Anchor::End);
        let names = if let Some(axis) = &self.panel.top {
            self.level(scene, axis, [top - TICK, top], top - TICK - 6.0);
            scene.text([middle, top - 39.0], WORDS, axis.label());
            top - 39.0
        } else {
            top - 17.0
        };
        scene.text([left - 34.0, names], WORDS.anchored(Anchor::Start), self.panel.y.label());
        if let Some(axis) = &self.panel.right {
            let numbers = right + TICK + 4.0;
            self.upright(scene, axis, [right, right + TICK], numbers, Anchor::Start);
            let at = [right + RIGHT, names];
            scene.text(at, WORDS.anchored(Anchor::End), axis.label());
        }
    }

    /// Names of curves, inside the frame and beside it.
    fn names(&self, scene: &mut Scene) {
        let Frame { from, to } = self.frame;
        let place = |(name, end)| -> (&Name, Point) {
            let [x, y]: Point = self.at(end);
            (name, [x, y.clamp(from[1], to[1])])
        };
        let all = self.panel.names.iter().map(|(name, end)| (name, *end));
        let (right, inside): (Vec<_>, Vec<_>) =
            all.partition(|(_, end)| self.panel.ends_right(*end));
        names::inside(scene, &inside.into_iter().map(place).collect::<Vec<_>>());
        let right: Vec<_> = right.into_iter().map(place).collect();
        names::outside(scene, self.frame, self.panel.axis_margin(), &right);
    }

    /// Ticks and numbers of an axis above or below.
    fn level(&self, scene: &mut Scene, axis: &Axis, [from, to]: [f64; 2], baseline: f64) {
        for (value, text) in axis.numbers() {
            let x = self.across(axis.share(value));
            scene.line(&[[x, from], [x, to]], Ink::line(GREY, 1.2));
            scene.text([x, baseline], NUMBERS, &Label::default().number(&text));
        }
    }

    /// Ticks and numbers of an axis on the left or the right.
    fn upright(
        &self,
        scene: &mut Scene,
        axis: &Axis,
        [from, to]: [f64; 2],
        numbers: f64,
        anchor: Anchor,
    ) {
        for (value, text) in axis.numbers() {
            let y = self.up(axis.share(value));
            scene.line(&[[from, y], [to, y]], Ink::line(GREY, 1.2));
            let style = NUMBERS.anchored(anchor);
            scene.text([numbers, y + 5.5], style, &Label::default().number(&text));
        }
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
