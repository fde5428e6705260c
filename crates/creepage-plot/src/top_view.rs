//! An ellipse seen from above, with its legend and a table at the foot.

use crate::axis::Axis;
use crate::format::significant;
use crate::head::Head;
use crate::label::Label;
use crate::legend::{Legend, Sample};
use crate::panel::Panel;
use crate::plane::{Arrows, Layout, Plane, WIDTH};
use crate::scene::{Anchor, Point, Scene, Type};
use crate::table::Table;
use crate::theme::{DARK, GREY, HATCHING};

/// How far around the ellipse the panel reaches.
const REACH: f64 = 1.1;

/// A picture of an ellipse seen from above: `x` forward to the right, `y` to the right of that, down
/// the sheet. A slender ellipse is drawn wider than it is, and the picture says so.
#[derive(Debug, Clone)]
pub struct TopView {
    head: Head,
    plane: Plane,
    ground: Panel,
    figure: Panel,
    is_rolling: bool,
    legend: Legend,
    table: Table,
}

impl TopView {
    /// An ellipse with semi-axes (m) along `x` and `y`, under a title.
    #[must_use]
    pub fn new(title: &str, semi_axes: [f64; 2]) -> Self {
        let head = Head { title: title.into(), ..Head::default() };
        let (plane, table) = (Plane::new(semi_axes), Table::new(&[]));
        let panel = Self::panel();
        let (ground, legend) = (panel.clone(), Legend::default());
        Self { head, plane, ground, figure: panel, is_rolling: false, legend, table }
    }

    /// An empty panel for [`TopView::ground`] and [`TopView::figure`], in units of the semi-axes:
    /// `(x/a, y/b)`.
    #[must_use]
    pub fn panel() -> Panel {
        let axis = |range| Axis::new(range, Label::default());
        Panel::new(axis([-REACH, REACH]), axis([REACH, -REACH])).bare()
    }

    /// Words at the right of the title.
    #[must_use]
    pub fn aside(mut self, words: &str) -> Self {
        self.head.aside = words.into();
        self
    }

    /// Adds a line of small words below the title.
    #[must_use]
    pub fn note(mut self, note: Label) -> Self {
        self.head.notes.push(note);
        self
    }

    /// A warning across the sheet.
    #[must_use]
    pub fn banner(mut self, words: &str) -> Self {
        self.head.banner = Some(words.into());
        self
    }

    /// What lies below the axes: areas.
    #[must_use]
    pub fn ground(self, ground: Panel) -> Self {
        Self { ground, ..self }
    }

    /// What lies over the axes: arrows and marks.
    #[must_use]
    pub fn figure(self, figure: Panel) -> Self {
        Self { figure, ..self }
    }

    /// With the rolling direction and the names of the edges.
    #[must_use]
    pub fn rolling(self) -> Self {
        Self { is_rolling: true, ..self }
    }

    /// Adds an entry to the legend.
    #[must_use]
    pub fn key(mut self, sample: impl Into<Sample>, label: Label) -> Self {
        self.legend.push(sample, label);
        self
    }

    /// With a table at the foot.
    #[must_use]
    pub fn table(self, table: Table) -> Self {
        Self { table, ..self }
    }

    /// Where the arrows of a field stand, as `(x/a, y/b)`.
    #[must_use]
    pub fn lattice(&self) -> Vec<Point> {
        self.plane.lattice()
    }

    /// A field as arrows: places as `(x/a, y/b)`, each with the field there.
    #[must_use]
    pub fn arrows(&self, field: Vec<(Point, [f64; 2])>) -> Arrows {
        Arrows::new(self.plane, field)
    }

    /// Centre and semi-axes of the ellipse on the sheet.
    #[must_use]
    pub fn on_the_sheet(&self) -> [Point; 2] {
        [self.layout().centre, self.plane.semi_axes]
    }

    fn layout(&self) -> Layout {
        Layout::new(self.plane.semi_axes, self.head().height(), &self.legend)
    }

    /// With a line on how the picture is to be looked at.
    fn head(&self) -> Head {
        let label = Label::new("seen from above: ").symbol("x").plain(" forward, ").symbol("y");
        let label = label.plain(" to the right, ").symbol("z");
        let mut label = label.plain(" down into the lower body");
        if !self.plane.is_to_scale() {
            let stretch = self.plane.stretch();
            let (axis, times) = if stretch > 1.0 { ("x", stretch) } else { ("y", stretch.recip()) };
            label = label.plain("; ").symbol(axis).plain(" enlarged ");
            label = label.number(&significant(times, 3)).plain(" times");
        }
        let mut head = self.head.clone();
        head.notes.push(label);
        head
    }

    /// The picture as SVG, described in words for those who cannot see it.
    #[must_use]
    pub fn svg(&self, description: &str) -> String {
        let mut scene = Scene::new();
        scene.hatching("hatching", HATCHING, 7.0, 1.3);
        let layout = self.layout();
        self.head().draw(&mut scene, WIDTH);
        let frame = self.plane.around(layout.centre, REACH);
        self.ground.draw(&mut scene, frame);
        self.plane.axes(&mut scene, layout.centre);
        if self.is_rolling {
            self.edges(&mut scene, layout.centre);
            rolling_direction(&mut scene, layout.plot.from);
        }
        self.figure.draw(&mut scene, frame);
        let corner = [layout.plot.from[0] + 6.0, layout.plot.to[1] - 14.0];
        self.plane.scale_bars(&mut scene, corner);
        let (corner, room) = layout.legend;
        self.legend.draw(&mut scene, corner, room);
        self.table.draw(&mut scene, layout.table, WIDTH);
        scene.finish([WIDTH, layout.table + self.table.height()], description)
    }

    /// Names the edges where material enters and leaves.
    fn edges(&self, scene: &mut Scene, [x, y]: Point) {
        let style = Type::new(12.5, GREY);
        let reach = self.plane.semi_axes[0] + 9.0;
        for (words, below) in [(["leading", "trailing"], -7.0), (["edge", "edge"], 20.0)] {
            scene.text([x + reach, y + below], style, &Label::new(words[0]));
            let style = style.anchored(Anchor::End);
            scene.text([x - reach, y + below], style, &Label::new(words[1]));
        }
    }
}

/// The upper body rolls to the right.
fn rolling_direction(scene: &mut Scene, [x, y]: Point) {
    scene.text([x, y + 16.0], Type::new(15.0, DARK), &Label::new("rolling direction"));
    scene.arrow([x + 124.0, y + 11.0], [x + 190.0, y + 11.0], 3.2, DARK);
}
