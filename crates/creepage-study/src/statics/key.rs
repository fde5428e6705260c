//! What the shades and signs of the picture mean.

use super::StaticsReport;
use super::arrows::Arrows;
use super::bands::shade;
use super::field::Field;
use crate::contact_view::pole_mark;
use crate::format::{Scale, quantity, round_below};
use crate::label::Label;
use crate::scene::{Anchor, Ink, Point, Scene, Type};
use crate::sheet::{DARK, GREY, TRACTION};

/// The line of a die's lift-off limit.
pub(super) const LIMIT: Ink = Ink::line(DARK, 1.8).dashed("6 4");

/// Height of a band's sample.
const BAND: f64 = 20.0;
const ROW: f64 = 30.0;
/// From the signs to the words.
const INDENT: f64 = 58.0;
const WORDS: Type = Type { size: 15.0, colour: DARK, bold: false, anchor: Anchor::Start };

/// Height of all of the key.
pub(super) fn height(report: &StaticsReport, levels: usize) -> f64 {
    let rows = match report.field {
        Field::Bonded(_) => 1.0,
        Field::Die { .. } | Field::PartialSlip(_) => 2.0,
    };
    head(report) + BAND * (levels + 1) as f64 + 14.0 + ROW * rows
}

/// Height of the words above the shades.
fn head(report: &StaticsReport) -> f64 {
    if report.field.is_singular() { 48.0 } else { 30.0 }
}

/// Shades, then signs.
pub(super) fn draw(
    scene: &mut Scene,
    [x, y]: Point,
    report: &StaticsReport,
    levels: &[f64],
    arrows: &Arrows,
) {
    let name = match report.field {
        Field::Die { .. } => "pressure",
        Field::Bonded(_) | Field::PartialSlip(_) => "traction on the lower body",
    };
    scene.text([x, y + 14.0], WORDS, &Label::new(name));
    if report.field.is_singular() {
        let words = Label::new("without bound at the edge");
        scene.text([x, y + 33.0], Type { size: 13.5, colour: GREY, ..WORDS }, &words);
    }
    let top = y + head(report);
    samples(scene, [x, top], levels);
    let next = top + BAND * (levels.len() + 1) as f64 + 14.0;
    match report.field {
        Field::Die { .. } => {
            pole_mark(scene, [x + 21.0, next + 10.0]);
            scene.text([x + INDENT, next + 15.0], WORDS, &Label::new("the load"));
            scene.ellipse([x + 21.0, next + ROW + 10.0], [20.0, 10.0], LIMIT);
            let words = "limit of lift-off";
            scene.text([x + INDENT, next + ROW + 15.0], WORDS, &Label::new(words));
        }
        Field::Bonded(_) => arrow(scene, [x, next], arrows),
        Field::PartialSlip(_) => {
            arrow(scene, [x, next], arrows);
            let ends = [[x, next + ROW + 10.0], [x + 42.0, next + ROW + 10.0]];
            scene.line(&ends, Ink::line(DARK, 2.6));
            let words = "edge of the adhesion";
            scene.text([x + INDENT, next + ROW + 15.0], WORDS, &Label::new(words));
        }
    }
}

/// The shades with the levels between them, the highest on top.
fn samples(scene: &mut Scene, [x, y]: Point, levels: &[f64]) {
    let count = levels.len() + 1;
    for row in 0..count {
        let top = y + BAND * row as f64;
        let shade = shade(count - 1 - row, levels.len());
        scene.rectangle([x, top], [42.0, BAND], 0.0, Ink::fill(shade));
    }
    scene.rectangle([x, y], [42.0, BAND * count as f64], 0.0, Ink::line(DARK, 1.2));
    let scale = Scale::of(levels.last().copied().unwrap_or(0.0), "Pa", 3);
    for (row, level) in levels.iter().rev().enumerate() {
        let line = y + BAND * (row + 1) as f64;
        scene.line(&[[x, line], [x + 48.0, line]], Ink::line(DARK, 1.0));
        let label = Label::default().number(&scale.write(*level));
        scene.text([x + INDENT, line + 5.0], WORDS, &label);
    }
}

/// The arrow of a round traction.
fn arrow(scene: &mut Scene, [x, y]: Point, arrows: &Arrows) {
    if arrows.largest > 0.0 {
        let round = round_below(arrows.largest);
        let length = round / arrows.largest * arrows.longest;
        let start = x + 0.5 * (42.0 - length);
        scene.arrow([start, y + 10.0], [start + length, y + 10.0], 1.9, TRACTION);
        let label = Label::default().number(&quantity(round, "Pa", 3));
        scene.text([x + INDENT, y + 15.0], Type { colour: GREY, ..WORDS }, &label);
    }
}
