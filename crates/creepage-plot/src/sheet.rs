//! A title, panels side by side and below each other, and one legend.

use crate::clip::Frame;
use crate::head::Head;
use crate::label::Label;
use crate::legend::{Legend, Sample};
use crate::mark::Mark;
use crate::panel::Panel;
use crate::scene::{Point, Scene};
use crate::theme::{HATCHING, MARGIN};

/// Width of the sheet, unless another is asked for.
const WIDTH: f64 = 760.0;
/// Left of a frame: the numbers of its upright axis.
const NUMBERS: f64 = 40.0;
/// Between two panels.
const BETWEEN: f64 = 22.0;

/// A picture under construction.
#[derive(Debug, Clone)]
pub struct Sheet {
    head: Head,
    width: f64,
    columns: usize,
    panels: Vec<Panel>,
    legend: Legend,
}

impl Sheet {
    /// An empty sheet.
    #[must_use]
    pub fn new(title: &str) -> Self {
        let head = Head { title: title.into(), ..Head::default() };
        Self { head, width: WIDTH, columns: 1, panels: Vec::new(), legend: Legend::default() }
    }

    /// The same without its title, which is then only said to those who cannot see the picture: for
    /// where it stands above the picture already.
    #[must_use]
    pub fn without_title(mut self) -> Self {
        self.head.hides_title = true;
        self
    }

    /// Adds a line of small words below the title.
    #[must_use]
    pub fn note(mut self, note: Label) -> Self {
        self.head.notes.push(note);
        self
    }

    /// With another width than 760 units.
    #[must_use]
    pub fn width(self, width: f64) -> Self {
        Self { width, ..self }
    }

    /// With so many panels side by side; one unless told otherwise.
    #[must_use]
    pub fn columns(self, columns: usize) -> Self {
        Self { columns: columns.max(1), ..self }
    }

    /// Adds a panel.
    #[must_use]
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// Its panels, in the order in which they were added: row by row, each from the left.
    #[must_use]
    pub fn panels(&self) -> &[Panel] {
        &self.panels
    }

    /// Lays marks over one of its panels, counted from 0; of no effect where there is no such panel.
    #[must_use]
    pub fn marks_over(mut self, panel: usize, points: Vec<Point>, mark: Mark) -> Self {
        if let Some(panel) = self.panels.get_mut(panel) {
            *panel = panel.clone().marks(points, mark);
        }
        self
    }

    /// Adds an entry to the legend.
    #[must_use]
    pub fn key(mut self, sample: impl Into<Sample>, label: Label) -> Self {
        self.legend.push(sample, label);
        self
    }

    /// The picture as SVG.
    #[must_use]
    pub fn svg(&self) -> String {
        let mut scene = Scene::new();
        scene.hatching("hatching", HATCHING, 8.0, 2.6);
        self.head.draw(&mut scene, self.width);
        let mut top = self.head.height();
        for row in self.panels.chunks(self.columns) {
            top += self.row(&mut scene, top, row);
        }
        let room = self.width - 2.0 * MARGIN;
        let legend = self.whole_legend();
        legend.draw(&mut scene, [MARGIN, top + 4.0], room);
        scene.finish([self.width, top + legend.height(room) + 24.0], &self.head.title)
    }

    /// The legend, and the names for which panels have no room, each once.
    fn whole_legend(&self) -> Legend {
        let mut legend = self.legend.clone();
        for (pen, label) in self.panels.iter().flat_map(Panel::names_without_room) {
            legend.push_new(pen, label);
        }
        legend
    }

    /// Draws panels side by side; gives their height.
    fn row(&self, scene: &mut Scene, top: f64, row: &[Panel]) -> f64 {
        let columns = self.columns as f64;
        // One for all rows: panels below each other share an axis.
        let right = self.panels.iter().map(Panel::right_margin).fold(0.0, f64::max);
        let room = (self.width - 2.0 * MARGIN + BETWEEN) / columns - BETWEEN;
        let width = room - NUMBERS - right;
        let above = row.iter().map(|panel| panel.margins()[0]).fold(0.0, f64::max);
        let below = row.iter().map(|panel| panel.margins()[1]).fold(0.0, f64::max);
        let tallest = row.iter().map(|panel| panel.frame_height(width)).fold(0.0, f64::max);
        for (column, panel) in row.iter().enumerate() {
            let left = MARGIN + column as f64 * (room + BETWEEN) + NUMBERS;
            let tall = panel.frame_height(width);
            let top = top + above + 0.5 * (tallest - tall);
            panel.draw(scene, Frame { from: [left, top], to: [left + width, top + tall] });
        }
        above + tallest + below
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Anchor, Axis, Boxes, Fill, Mark, Pen, Shape};

    fn panel() -> Panel {
        let x = Axis::new([0.0, 2.0], Label::default().symbol("ξ"));
        let y = Axis::new([1.0, -1.0], Label::default().indexed("f", "x"));
        let curve: Vec<_> = (0..=20).map(|k| 0.2 * f64::from(k)).map(|x| [x, x.sin()]).collect();
        Panel::new(x, y)
            .area(vec![vec![[0.2, -0.5], [1.0, -0.5], [1.0, 0.5]]], Fill::SLIP)
            .curve(curve.clone(), Pen::of(1))
            .marks(curve, Mark::open(Shape::Diamond, "#c62828"))
            .arrow([0.0, 0.0], [1.0, 0.5], 2.0, "#10243a")
            .text([1.6, -0.5], Anchor::Middle, Label::new("here"))
    }

    #[test]
    fn nothing_is_clipped_or_covered() {
        for columns in [1, 2] {
            let sheet = Sheet::new("A title, long enough to be one").columns(columns);
            let mut sheet = sheet.note(Label::new("with a note"));
            for _ in 0..3 {
                sheet = sheet.panel(panel().heading(Label::new("of three")));
            }
            let axis = |name| Axis::new([5.0, -5.0], Label::new(name));
            sheet = sheet.panel(panel().top(axis("per cent")).right(axis("N")));
            for k in 0..5 {
                sheet = sheet.key(Pen::of(k), Label::new("an entry of some length"));
            }
            let sheet = sheet.panel(panel().to_scale().bare()).key(Fill::SLIP, Label::new("slip"));
            let boxes = Boxes::of(&sheet.svg()).unwrap();
            assert_eq!((boxes.off_the_sheet(), boxes.touching()), (None, None));
        }
    }

    #[test]
    fn a_panel_to_scale_has_the_height_of_its_range() {
        let x = Axis::new([-1.0, 1.0], Label::default());
        let y = Axis::new([0.0, 1.0], Label::default());
        let height = Panel::new(x, y).to_scale().frame_height(600.0);
        assert!((height - 300.0).abs() < 1e-12);
    }
}
