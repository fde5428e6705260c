//! Bounding boxes of everything in a picture: what tests ask whether it is legible.

use resvg::usvg::{Group, Node, Rect};

use crate::clip::Frame;
use crate::raster::{PlotError, tree};

/// The boxes around the texts and the shapes of a picture, in units of its sheet.
#[derive(Debug, Clone)]
pub struct Boxes {
    /// Of the sheet.
    pub size: [f64; 2],
    /// Around each text, as laid out in the bundled font.
    pub texts: Vec<Frame>,
    /// Around each shape with its outline.
    pub shapes: Vec<Frame>,
}

impl Boxes {
    /// The boxes of an SVG.
    ///
    /// # Errors
    /// [`PlotError::Picture`] when it is not an SVG.
    pub fn of(svg: &str) -> Result<Self, PlotError> {
        let tree = tree(svg)?;
        let size = [tree.size().width(), tree.size().height()].map(f64::from);
        let mut boxes = Self { size, texts: Vec::new(), shapes: Vec::new() };
        boxes.collect(tree.root());
        Ok(boxes)
    }

    fn collect(&mut self, group: &Group) {
        for node in group.children() {
            match node {
                Node::Group(group) => self.collect(group),
                Node::Text(text) => self.texts.push(frame(text.abs_bounding_box())),
                other => self.shapes.push(frame(other.abs_stroke_bounding_box())),
            }
        }
    }

    /// The first box that leaves the sheet.
    #[must_use]
    pub fn off_the_sheet(&self) -> Option<Frame> {
        let inside = |b: &Frame| (0..2).all(|i| b.from[i] >= 0.0 && b.to[i] <= self.size[i]);
        self.texts.iter().chain(&self.shapes).find(|b| !inside(b)).copied()
    }

    /// The first two texts that touch each other.
    #[must_use]
    pub fn touching(&self) -> Option<[Frame; 2]> {
        // Ascenders and descenders may share a pixel row.
        let rows = [0.0, 2.0];
        let touch = |b: &Frame, c: &Frame| {
            (0..2).all(|i| b.from[i] + rows[i] < c.to[i] && c.from[i] + rows[i] < b.to[i])
        };
        self.texts
            .iter()
            .enumerate()
            .find_map(|(k, b)| self.texts[k + 1..].iter().find(|c| touch(b, c)).map(|c| [*b, *c]))
    }
}

fn frame(rect: Rect) -> Frame {
    Frame {
        from: [rect.left(), rect.top()].map(f64::from),
        to: [rect.right(), rect.bottom()].map(f64::from),
    }
}
