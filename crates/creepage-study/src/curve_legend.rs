//! Which line of the creep-force curves is which.

use creepage::rolling::Status;

use crate::curves::Curves;
use crate::format::significant;
use crate::label::Label;
use crate::scene::{Anchor, Ink, Point, Scene, Type};
use crate::sheet::{DARK, GREY, MARGIN, WIDTH};

/// Colour, dashes and width: different in grey print too.
pub(crate) const PENS: [(&str, &str, f64); 10] = [
    ("#10243a", "", 2.6),
    ("#c62828", "11 4", 2.4),
    ("#1565c0", "2.5 3.5", 2.8),
    ("#2e7d32", "13 4 2.5 4", 2.4),
    ("#8e24aa", "6 3", 2.2),
    ("#d07000", "14 3.5 2.5 3.5 2.5 3.5", 2.4),
    ("#00838f", "22 5", 2.2),
    ("#6d4c41", "2.5 7", 3.0),
    ("#78909c", "", 3.4),
    ("#ad1457", "6 3 6 3 2 3", 2.2),
];
/// Where the case lies.
pub(crate) const CASE: Ink = Ink::broken_line(GREY, 1.4, "3 4");

/// Width of a line that is not to be trusted.
const THIN: f64 = 0.9;

const COLUMNS: usize = 4;
const ROW: f64 = 25.0;
const SAMPLE: f64 = 48.0;
const WORDS: Type = Type { size: 15.0, colour: DARK, bold: false, anchor: Anchor::Start };
/// Longer names of theories are cut: the column has an end.
const LONGEST_NAME: usize = 21;

/// The pen of curve number `k`; thin where the theory does not stand for it.
pub(crate) fn pen(k: usize, solved: bool) -> Ink {
    let (colour, dashes, width) = PENS[k % PENS.len()];
    Ink::broken_line(colour, if solved { width } else { THIN }, dashes)
}

/// Draws the legend; gives its height.
pub(crate) fn draw(scene: &mut Scene, [left, top]: Point, curves: &Curves) -> f64 {
    let column = (WIDTH - 2.0 * MARGIN) / COLUMNS as f64;
    let place = |k: usize| [left + (k % COLUMNS) as f64 * column, top + (k / COLUMNS) as f64 * ROW];
    let mut next = 0;
    for (k, curve) in curves.lines.iter().enumerate() {
        let name: String = curve.theory.chars().take(LONGEST_NAME).collect();
        entry(scene, place(k), pen(k, true), &Label::new(&name));
        next = k + 1;
    }
    let case = curves.vary.of(curves.case);
    if curves.reach(case) {
        let [x, y] = place(next);
        let middle = x + 0.5 * SAMPLE;
        scene.line(&[[middle, y - 9.0], [middle, y + 9.0]], CASE);
        let label = Label::new("the case: ").symbol(curves.vary.symbol()).plain(" = ");
        words(scene, [x, y], &label.number(&significant(case, 4)));
        next += 1;
    }
    let mut solutions = curves.lines.iter().flat_map(|curve| &curve.solutions);
    if solutions.any(|solution| solution.status != Status::Solved) {
        // Its words take two columns.
        next += usize::from(next % COLUMNS == COLUMNS - 1);
        let label = Label::new("thin: beyond what the theory holds for");
        entry(scene, place(next), Ink::line(DARK, THIN), &label);
        next += 1;
    }
    next.div_ceil(COLUMNS) as f64 * ROW
}

fn entry(scene: &mut Scene, [x, y]: Point, pen: Ink, label: &Label) {
    scene.line(&[[x, y], [x + SAMPLE, y]], pen);
    words(scene, [x, y], label);
}

fn words(scene: &mut Scene, [x, y]: Point, label: &Label) {
    scene.text([x + SAMPLE + 9.0, y + 5.0], WORDS, label);
}
