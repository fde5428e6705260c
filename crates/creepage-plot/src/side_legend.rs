//! A legend of one column, beside or below what it explains.

use crate::label::Label;
use crate::legend::{SAMPLE, Sample, show};
use crate::mark::{Fill, Ink};
use crate::scene::{Point, Scene, Type};
use crate::theme::{DARK, GREY};

const ROW: f64 = 30.0;
/// Height of a band's sample.
const BAND: f64 = 20.0;
/// From the samples to the words.
const INDENT: f64 = SAMPLE + 14.0;
const SIZE: f64 = 15.0;

/// A part of the legend.
#[derive(Debug, Clone)]
pub(crate) enum Row {
    /// A sample and its meaning.
    Entry(Sample, Label),
    /// Words by themselves.
    Words(Label),
    /// Small grey words that go on with the row above.
    Remark(Label),
    /// Bands from the highest to the lowest, and the levels between them.
    Bands(Vec<&'static str>, Vec<Label>),
}

impl Row {
    pub(crate) fn height(&self) -> f64 {
        match self {
            Self::Entry(..) => ROW,
            Self::Words(_) => 26.0,
            Self::Remark(_) => 20.0,
            Self::Bands(shades, _) => BAND * shades.len() as f64 + 14.0,
        }
    }

    fn draw(&self, scene: &mut Scene, [x, y]: Point) {
        let words = Type::new(SIZE, DARK);
        match self {
            Self::Entry(sample, label) => {
                show(scene, [x, y + 10.5], *sample);
                scene.text([x + INDENT, y + 16.0], words, label);
            }
            Self::Words(label) => scene.text([x, y + 14.0], words, label),
            Self::Remark(label) => {
                scene.text([x + INDENT, y + 6.0], Type::new(SIZE - 1.0, GREY), label);
            }
            Self::Bands(shades, levels) => bands(scene, [x, y], shades, levels),
        }
    }
}

pub(crate) fn height(rows: &[Row]) -> f64 {
    rows.iter().map(Row::height).sum()
}

pub(crate) fn draw(scene: &mut Scene, [x, mut y]: Point, rows: &[Row]) {
    for row in rows {
        row.draw(scene, [x, y]);
        y += row.height();
    }
}

fn bands(scene: &mut Scene, [x, y]: Point, shades: &[&'static str], levels: &[Label]) {
    let at = |row: usize| y + BAND * row as f64;
    for (row, shade) in shades.iter().enumerate() {
        let (top, bottom) = (at(row), at(row + 1));
        let corners = [[x, top], [x + 42.0, top], [x + 42.0, bottom], [x, bottom]];
        Fill::plain(shade).draw(scene, &[corners.to_vec()]);
    }
    scene.rectangle([x, y], [42.0, BAND * shades.len() as f64], 0.0, Ink::line(DARK, 1.2));
    for (row, level) in levels.iter().enumerate() {
        let line = at(row + 1);
        scene.line(&[[x, line], [x + 48.0, line]], Ink::line(DARK, 1.0));
        scene.text([x + INDENT, line + 5.0], Type::new(SIZE, DARK), level);
    }
}
