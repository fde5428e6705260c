//! The words above and below the contact picture.

use creepage::Hertz;
use creepage::rolling::Status;

use crate::format::{Scale, fixed, quantity, significant};
use crate::label::Label;
use crate::report::Report;
use crate::scene::{Anchor, Ink, Scene, Type};
use crate::sheet::{DARK, GREY, MARGIN, PALE, RED, WIDTH};
use crate::text::status_words;

/// Height of title and subtitle.
pub(crate) const TITLE_HEIGHT: f64 = 104.0;
/// The same with the banner of a case that is not solved.
pub(crate) const BANNER_BOTTOM: f64 = 150.0;
/// Height of the table at the foot.
pub(crate) const TABLE_HEIGHT: f64 = 190.0;

/// Longer names of theories are cut: the sheet has an edge.
const LONGEST_NAME: usize = 40;
/// Where the table's three columns start.
const COLUMNS: [f64; 3] = [226.0, 468.0, 714.0];

/// Title, subtitle, and a banner unless the case is solved.
pub(crate) fn title(scene: &mut Scene, report: &Report) {
    let name: String = report.answer.theory_name.chars().take(LONGEST_NAME).collect();
    let title = Type::new(25.0, DARK).bold();
    scene.text(
        [MARGIN, 54.0],
        title,
        &Label::new("Adhesion, slip and traction in rolling contact"),
    );
    scene.text(
        [WIDTH - MARGIN, 54.0],
        Type::new(15.0, GREY).anchored(Anchor::End),
        &Label::new(&format!("theory: {name}")),
    );
    scene.text([MARGIN, 82.0], Type::new(15.5, GREY), &contact(report.contact, report.friction));
    let status = report.answer.solution.status;
    if status != Status::Solved {
        let size = [WIDTH - 2.0 * MARGIN, 32.0];
        scene.rectangle([MARGIN, 100.0], size, 4.0, Ink::fill("#fdecea").outlined(RED, 1.5));
        let style = Type::new(15.5, RED).bold().anchored(Anchor::Middle);
        scene.text([0.5 * WIDTH, 121.5], style, &Label::new(status_words(status)));
    }
}

/// Load, friction, semi-axes and pressure.
pub(crate) fn contact(contact: &Hertz, friction: f64) -> Label {
    let ellipse = contact.ellipse();
    let gap = "\u{2003}";
    let is = |label: Label, value: &str| label.plain(" = ").number(value);
    let label = is(Label::default().symbol("N"), &quantity(contact.normal_force(), "N", 4));
    let label = is(label.plain(gap).symbol("μ"), &significant(friction, 4));
    let label = is(label.plain(gap).symbol("a"), &quantity(ellipse.a(), "m", 4));
    let label = is(label.plain(gap).symbol("b"), &quantity(ellipse.b(), "m", 4));
    let label = label.plain(gap).plain("peak pressure ");
    label.number(&quantity(contact.peak_pressure(), "Pa", 4))
}

/// Creepages and forces, in SI units and dimensionless.
pub(crate) fn table(scene: &mut Scene, top: f64, report: &Report) {
    let rule = |scene: &mut Scene, y: f64| {
        scene.line(&[[MARGIN, y], [WIDTH - MARGIN, y]], Ink::line(PALE, 1.0));
    };
    rule(scene, top + 8.0);
    let head = Type::new(15.0, GREY);
    for (column, words) in COLUMNS.into_iter().zip(["longitudinal", "lateral", "spin"]) {
        scene.text([column, top + 32.0], head, &Label::new(words));
    }
    let [creepage, xi] = creepages(report);
    let [force, shares] = forces(report);
    let units = Label::new("in units of ").symbol("μN").plain(", ").symbol("μNc");
    let rows = [
        (0.0, Label::new("creepage"), creepage),
        (24.0, Label::new("dimensionless"), xi),
        (58.0, Label::new("force on the lower body"), force),
        (82.0, units, shares),
    ];
    for (down, name, cells) in rows {
        let y = top + 62.0 + down;
        scene.text([MARGIN, y], head, &name);
        for (column, cell) in COLUMNS.into_iter().zip(cells) {
            scene.text([column, y], Type::new(15.5, DARK), &cell);
        }
    }
    rule(scene, top + TABLE_HEIGHT - 26.0);
}

/// The SI row and the dimensionless row.
fn creepages(report: &Report) -> [[Label; 3]; 2] {
    let creepage = report.answer.creepage;
    let si = report.scaling.si_creepage(creepage);
    let is = |label: Label, value: f64| label.plain(" = ").number(&significant(value, 4));
    let symbol = |symbol: &str| Label::default().symbol(symbol);
    let indexed = |index: &str| Label::default().indexed("υ", index);
    [
        [
            is(indexed("x"), si.longitudinal),
            is(indexed("y"), si.lateral),
            is(symbol("φ"), si.spin).plain(" rad/m"),
        ],
        [
            is(symbol("ξ"), creepage.xi),
            is(symbol("η"), creepage.eta),
            is(symbol("χ"), creepage.chi),
        ],
    ]
}

/// The SI row and the dimensionless row.
fn forces(report: &Report) -> [[Label; 3]; 2] {
    let (force, scaling) = (report.answer.solution.force, &report.scaling);
    let si = scaling.si_force(force);
    let newton = Scale::of(scaling.force, "N", 4);
    let newton_metre = Scale::of(scaling.force * scaling.length, "N m", 4);
    let is = |symbol: &str, index: &str, value: String| {
        Label::default().indexed(symbol, index).plain(" = ").number(&value)
    };
    [
        [
            is("F", "x", newton.write(si.longitudinal)),
            is("F", "y", newton.write(si.lateral)),
            is("M", "z", newton_metre.write(si.moment)),
        ],
        [
            is("f", "x", fixed(force.fx, 4)),
            is("f", "y", fixed(force.fy, 4)),
            is("m", "z", fixed(force.mz, 4)),
        ],
    ]
}
