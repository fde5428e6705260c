//! The key below the panels: what each line, mark and area stands for.

use super::ink::{Fill, Mark, Pen};
use crate::label::Label;
use crate::scene::{Ink, Point, Scene, Type};
use crate::sheet::{DARK, MARGIN};

const SIZE: f64 = 16.0;
const ROW: f64 = 26.0;
const SAMPLE: f64 = 44.0;
/// White between a sample and its words, and between words and the next sample.
const GAPS: [f64; 2] = [9.0, 24.0];

/// What an entry of the key shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sample {
    /// A line.
    Line(Pen),
    /// A mark.
    Point(Mark),
    /// An area.
    Area(Fill),
    /// An arrow of a colour.
    Arrow(&'static str),
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

/// Draws the entries in columns of equal width, over `room` from the margin; gives their height.
pub(super) fn draw(scene: &mut Scene, top: f64, room: f64, entries: &[(Sample, Label)]) -> f64 {
    let longest = entries.iter().map(|(_, label)| label.width(SIZE)).fold(0.0, f64::max);
    let fit = (room + GAPS[1]) / (SAMPLE + GAPS[0] + longest + GAPS[1]);
    let fit = (1..=entries.len()).rev().find(|count| *count as f64 <= fit).unwrap_or(1);
    // As many rows as that takes, filled evenly.
    let columns = entries.len().div_ceil(entries.len().div_ceil(fit).max(1)).max(1);
    let pitch = (room + GAPS[1]) / columns as f64;
    for (k, (sample, label)) in entries.iter().enumerate() {
        let at = [MARGIN + (k % columns) as f64 * pitch, top + (0.5 + (k / columns) as f64) * ROW];
        show(scene, at, *sample);
        let words = [at[0] + SAMPLE + GAPS[0], at[1] + 5.5];
        scene.text(words, Type::new(SIZE, DARK), label);
    }
    entries.len().div_ceil(columns) as f64 * ROW
}

fn show(scene: &mut Scene, [x, y]: Point, sample: Sample) {
    match sample {
        Sample::Line(pen) => scene.line(&[[x, y], [x + SAMPLE, y]], pen.ink()),
        Sample::Point(mark) => mark.draw(scene, [x + 0.5 * SAMPLE, y]),
        Sample::Arrow(colour) => scene.arrow([x + 6.0, y], [x + SAMPLE - 6.0, y], 1.8, colour),
        Sample::Area(fill) => {
            let (left, right) = (x + 4.0, x + SAMPLE - 4.0);
            let corners =
                vec![[left, y - 9.0], [right, y - 9.0], [right, y + 9.0], [left, y + 9.0]];
            fill.draw(scene, std::slice::from_ref(&corners));
            scene.area(&[corners], Ink::line(DARK, 1.1));
        }
    }
}
