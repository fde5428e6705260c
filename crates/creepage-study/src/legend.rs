//! What the signs of the contact picture mean, and how it is to be looked at.

use crate::contact_view::{View, pole_mark, spin_pole};
use crate::format::{fixed, quantity, significant};
use crate::label::Label;
use crate::plane::Plane;
use crate::report::Report;
use crate::scene::{Ink, Point, Scene, Type};
use crate::sheet::{ADHESION, DARK, GREY, SLIP, TRACTION};

/// White between the legend's two parts.
pub(crate) const GAP: f64 = 26.0;
/// Height of the axes and the words for them.
pub(crate) const ORIENTATION_HEIGHT: f64 = 96.0;

const ROW: f64 = 32.0;
/// From the signs to the words.
const INDENT: f64 = 58.0;
const WORDS: Type =
    Type { size: 15.0, colour: DARK, bold: false, anchor: crate::scene::Anchor::Start };

/// Height of the key: its last row is for a spin pole inside the contact.
pub(crate) fn key_height(report: &Report) -> f64 {
    if spin_pole(report).is_some() { 146.0 } else { 108.0 }
}

/// Areas, tractions, spin pole.
pub(crate) fn key(scene: &mut Scene, [x, y]: Point, report: &Report, view: &View) {
    let share = report.adhesion_share();
    let percent = |share: f64| format!("{} %", fixed(100.0 * share, 1));
    for (row, name, colour, share) in
        [(0.0, "adhesion", ADHESION, share), (1.0, "slip", SLIP, 1.0 - share)]
    {
        let top = y + row * ROW;
        let size = [42.0, 21.0];
        scene.rectangle([x, top], size, 2.0, Ink::fill(colour));
        if name == "slip" {
            scene.rectangle([x, top], size, 2.0, Ink::fill("url(#slip)"));
        }
        scene.rectangle([x, top], size, 2.0, Ink::line(DARK, 1.2));
        let words = format!("{name}, {} of area", percent(share));
        scene.text([x + INDENT, top + 16.0], WORDS, &Label::new(&words));
    }
    traction(scene, [x, y + 2.0 * ROW], report, view);
    if spin_pole(report).is_some() {
        let top = y + 3.0 * ROW + 19.0;
        pole_mark(scene, [x + 21.0, top + 10.0]);
        scene.text([x + INDENT, top + 16.0], WORDS, &Label::new("spin pole: no rigid slip"));
    }
}

/// The arrow of a round traction.
fn traction(scene: &mut Scene, [x, y]: Point, report: &Report, view: &View) {
    let words = "traction on the lower body";
    match view.reference(report.scaling.traction) {
        Some((traction, length)) => {
            let start = x + 0.5 * (42.0 - length);
            scene.arrow([start, y + 11.0], [start + length, y + 11.0], 1.9, TRACTION);
            let label = Label::new("").number(&quantity(traction, "Pa", 3));
            scene.text([x + INDENT, y + 16.0], WORDS, &label);
            scene.text([x + INDENT, y + 35.0], Type { colour: GREY, ..WORDS }, &Label::new(words));
        }
        None => scene.text([x + INDENT, y + 16.0], WORDS, &Label::new("no traction")),
    }
}

/// The three axes, and words for them.
pub(crate) fn orientation(scene: &mut Scene, [x, y]: Point, plane: &Plane) {
    let [centre_x, centre_y] = [x + 10.0, y + 14.0];
    scene.arrow([centre_x + 8.0, centre_y], [centre_x + 42.0, centre_y], 1.6, DARK);
    scene.arrow([centre_x, centre_y + 8.0], [centre_x, centre_y + 42.0], 1.6, DARK);
    // An arrow's tail feathers: z points away from the reader.
    scene.circle([centre_x, centre_y], 8.0, Ink::fill("#ffffff").outlined(DARK, 1.6));
    for sign in [-1.0, 1.0] {
        let d = 5.6;
        let ends = [[centre_x - d, centre_y - sign * d], [centre_x + d, centre_y + sign * d]];
        scene.line(&ends, Ink::line(DARK, 1.4));
    }
    let symbol = |text: &str| Label::default().symbol(text);
    scene.text([centre_x + 34.0, centre_y - 7.0], WORDS, &symbol("x"));
    scene.text([centre_x + 8.0, centre_y + 44.0], WORDS, &symbol("y"));
    scene.text([centre_x - 6.0, centre_y - 13.0], WORDS, &symbol("z"));
    words(scene, [x + INDENT + 12.0, y + 19.0], plane);
}

fn words(scene: &mut Scene, [x, y]: Point, plane: &Plane) {
    let mut lines = vec![
        Label::new("seen from above:"),
        Label::default().symbol("x").plain(" forward, ").symbol("y").plain(" to the right,"),
        Label::default().symbol("z").plain(" down into the lower body"),
    ];
    if !plane.to_scale() {
        let stretch = plane.stretch();
        let (axis, times) = if stretch > 1.0 { ("x", stretch) } else { ("y", stretch.recip()) };
        let label = Label::default().symbol(axis).plain(" enlarged ");
        lines.push(label.number(&significant(times, 3)).plain(" times"));
    }
    for (line, label) in lines.iter().enumerate() {
        let style = Type { size: 13.5, colour: if line < 3 { GREY } else { DARK }, ..WORDS };
        scene.text([x, y + 19.0 * line as f64], style, label);
    }
}
