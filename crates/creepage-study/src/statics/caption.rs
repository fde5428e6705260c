//! The words above and below the picture.

use super::StaticsReport;
use super::field::Field;
use crate::label::Label;
use crate::scene::{Anchor, Ink, Scene, Type};
use crate::sheet::{DARK, GREY, MARGIN, PALE, WIDTH};

/// Height of title and subtitle.
pub(super) const TITLE_HEIGHT: f64 = 104.0;
const ROW: f64 = 25.0;
/// Where the table's columns start: name and number, twice.
const COLUMNS: [[f64; 2]; 2] = [[MARGIN, 286.0], [530.0, 772.0]];

/// Title, what is shown, and what is given.
pub(super) fn title(scene: &mut Scene, report: &StaticsReport) {
    scene.text([MARGIN, 54.0], Type::new(25.0, DARK).bold(), &Label::new(report.title));
    let source = match report.field {
        Field::Die { .. } => "Kalker 1967, section 3.211",
        Field::Bonded(_) => "Cattaneo, Mindlin; Kalker 1967, section 3.212",
        Field::PartialSlip(_) => "Cattaneo, Mindlin; Kalker 1967, section 3.222",
    };
    let style = Type::new(15.0, GREY).anchored(Anchor::End);
    scene.text([WIDTH - MARGIN, 54.0], style, &Label::new(source));
    let equations = report.given.iter().filter_map(super::Quantity::equation);
    let line = equations.reduce(|line, next| line.plain("\u{2003}").joined(&next));
    scene.text([MARGIN, 82.0], Type::new(15.5, GREY), &line.unwrap_or_default());
}

/// Height of the table at the foot.
pub(super) fn table_height(report: &StaticsReport) -> f64 {
    ROW * report.found.len().div_ceil(2) as f64 + 66.0
}

/// What was found, in two columns.
pub(super) fn table(scene: &mut Scene, top: f64, report: &StaticsReport) {
    let rule = |scene: &mut Scene, y: f64| {
        scene.line(&[[MARGIN, y], [WIDTH - MARGIN, y]], Ink::line(PALE, 1.0));
    };
    rule(scene, top + 8.0);
    let rows = report.found.len().div_ceil(2);
    for (index, quantity) in report.found.iter().enumerate() {
        let [name, number] = COLUMNS[index / rows.max(1)];
        let y = top + 36.0 + ROW * (index % rows) as f64;
        scene.text(
            [name, y],
            Type::new(15.0, GREY),
            &Label::new(&quantity.name.replace("mu N", "μN")),
        );
        let label = Label::default().number(&quantity.written(4));
        scene.text([number, y], Type::new(15.5, DARK), &label);
    }
    rule(scene, top + table_height(report) - 26.0);
}
