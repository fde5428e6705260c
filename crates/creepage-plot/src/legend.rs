//! The legend: what each line, mark and area stands for.

use crate::ink::Ink;
use crate::label::Label;
use crate::mark::{Fill, Mark, Pen};
use crate::scene::{Point, Scene, Type};
use crate::theme::DARK;

const SIZE: f64 = 16.0;
const ROW: f64 = 26.0;
const SAMPLE: f64 = 44.0;
/// White between a sample and its words, and between words and the next sample.
const GAPS: [f64; 2] = [9.0, 24.0];

/// Sample of a legend's entry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sample {
    /// Nothing: the words stand by themselves.
    Blank,
    /// A line.
    Line(Pen),
    /// A mark.
    Point(Mark),
    /// An area.
    Area(Fill),
    /// An arrow.
    Arrow {
        /// As SVG has it.
        colour: &'static str,
        /// In units of the sheet.
        length: f64,
    },
}

impl Sample {
    /// An arrow of the usual length.
    #[must_use]
    pub const fn arrow(colour: &'static str) -> Self {
        Self::Arrow { colour, length: SAMPLE - 12.0 }
    }
}

impl From<Pen> for Sample {
    fn from(pen: Pen) -> Self {
        Self::Line(pen)
    }
}

impl From<Mark> for Sample {
    fn from(mark: Mark) -> Self {
        Self::Point(mark)
    }
}

impl From<Fill> for Sample {
    fn from(fill: Fill) -> Self {
        Self::Area(fill)
    }
}

/// Samples and their meanings, in columns of equal width.
#[derive(Debug, Clone, Default)]
pub(crate) struct Legend {
    entries: Vec<(Sample, Label)>,
}

impl Legend {
    pub(crate) fn push(&mut self, sample: impl Into<Sample>, label: Label) {
        self.entries.push((sample.into(), label));
    }

    /// The same unless it is there already.
    pub(crate) fn push_new(&mut self, sample: impl Into<Sample>, label: &Label) {
        if !self.entries.iter().any(|(_, known)| known.svg() == label.svg()) {
            self.push(sample, label.clone());
        }
    }

    /// As many columns as fit into `room`, but no more than the rows that this takes need.
    fn columns(&self, room: f64) -> usize {
        let count = self.entries.len();
        let longest = self.entries.iter().map(|(_, label)| label.width(SIZE)).fold(0.0, f64::max);
        let fit = (room + GAPS[1]) / (SAMPLE + GAPS[0] + longest + GAPS[1]);
        let fit = (1..=count).rev().find(|columns| *columns as f64 <= fit).unwrap_or(1);
        count.div_ceil(count.div_ceil(fit).max(1)).max(1)
    }

    pub(crate) fn height(&self, room: f64) -> f64 {
        self.entries.len().div_ceil(self.columns(room)) as f64 * ROW
    }

    /// Draws the entries into `room` from a corner.
    pub(crate) fn draw(&self, scene: &mut Scene, [left, top]: Point, room: f64) {
        let columns = self.columns(room);
        let pitch = (room + GAPS[1]) / columns as f64;
        for (k, (sample, label)) in self.entries.iter().enumerate() {
            let [column, row] = [k % columns, k / columns];
            let at = [left + column as f64 * pitch, top + (0.5 + row as f64) * ROW];
            show(scene, at, *sample);
            let words = [at[0] + SAMPLE + GAPS[0], at[1] + 5.5];
            scene.text(words, Type::new(SIZE, DARK), label);
        }
    }
}

fn show(scene: &mut Scene, [x, y]: Point, sample: Sample) {
    match sample {
        Sample::Blank => {}
        Sample::Line(pen) => scene.line(&[[x, y], [x + SAMPLE, y]], pen.ink()),
        Sample::Point(mark) => mark.draw(scene, [x + 0.5 * SAMPLE, y]),
        Sample::Arrow { colour, length } => {
            let from = x + 0.5 * (SAMPLE - length);
            scene.arrow([from, y], [from + length, y], 1.8, colour);
        }
        Sample::Area(fill) => {
            let (left, right) = (x + 4.0, x + SAMPLE - 4.0);
            let corners =
                vec![[left, y - 9.0], [right, y - 9.0], [right, y + 9.0], [left, y + 9.0]];
            fill.draw(scene, std::slice::from_ref(&corners));
            scene.area(&[corners], Ink::line(DARK, 1.1));
        }
    }
}
