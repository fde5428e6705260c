//! Fig. 22: tractions for creepage and spin together.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use creepage::Ellipse;
use creepage::variational::Weight;

use super::tractions::{self, View};
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig22", "Fig. 22. Tractions in creepage and spin together", make);

/// `A upsilon = A chi`, with `A` the unit of slip of (4.21), `(1 - sigma) E/2` of the circle: the print
/// has `xi = -eta = .50`, `chi = .70`, and the pole on the circle.
const A_UPSILON: f64 = 0.4;
const CHI: f64 = A_UPSILON / ((1.0 - STEEL) * FRAC_PI_4);
const CREEPAGE: [f64; 3] = [CHI * FRAC_1_SQRT_2, -CHI * FRAC_1_SQRT_2, CHI];
const POLE: Mark = Mark::open(Shape::Diamond, "#b3261e");
const LEAST_TRACTION: Mark = Mark::full(Shape::Circle, "#b3261e");

fn make() -> Result<Reproduction, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let theory = chapter_5(1.0, STEEL, 3, Weight::Elliptic)?;
    let detailed = contact::detailed(1.0, STEEL)?;
    let mut data = Data::new(["curve", "chi", "x", "y"]);
    let mut sheet = Sheet::new(ITEM.title)
        .note(axes::setting(&[
            ("a/b", "1"),
            ("σ", "0.28"),
            ("ξ = −η", "0.50"),
            ("χ", "0.71"),
            ("Aχ", "0.4"),
        ]))
        .columns(2);
    let fields = [
        contact::chapter_5(&theory, rolling_at(CREEPAGE)),
        contact::full(&detailed, rolling_at(CREEPAGE)),
    ];
    let least = fields.each_ref().map(|field| least(circle, field));
    let headings = [axes::degree(3), Label::new("full theory")];
    let names = [("M = 3", contact::EDGE), ("full theory", contact::EDGE_OF_ELEMENTS)];
    for ((field, heading), (at, (name, edge))) in
        fields.iter().zip(headings).zip(least.iter().zip(names))
    {
        let view = View::new(circle, field, edge);
        view.collect(&mut data, name, CREEPAGE[2]);
        data.points(&format!("least, {name}"), &[CREEPAGE[2]], [&at.0]);
        sheet = sheet.panel(panel(circle, heading, &view, at.0));
    }
    let sheet = tractions::key(sheet)
        .key(LEAST_TRACTION, Label::new("least traction over its bound"))
        .key(POLE, Label::new("spin pole of the rigid bodies"));
    Ok(Reproduction::figure(&sheet, caption(least), data, agreement(least)))
}

fn pole() -> [f64; 2] {
    [-CREEPAGE[1] / CREEPAGE[2], CREEPAGE[0] / CREEPAGE[2]]
}

fn panel(circle: Ellipse, heading: Label, view: &View, least: [f64; 2]) -> Panel {
    let panel = view.draw(contact::panel(circle, heading), |_| true);
    contact::edge(panel, circle).marks(vec![least], LEAST_TRACTION).marks(vec![pole()], POLE)
}

/// Where the traction over its bound is least in the inner part of the contact, to 0.005, and
/// that least.
fn least(circle: Ellipse, field: &Field) -> ([f64; 2], f64) {
    let steps = || (-180..=180).map(|k| 0.005 * f64::from(k));
    let positions: Vec<_> = steps()
        .flat_map(|x| steps().map(move |y| [x, y]))
        .filter(|[x, y]| x.hypot(*y) < 0.9)
        .collect();
    let points = field(&positions);
    let sizes = points.iter().map(|point| (point.position, contact::reduced(circle, point)));
    sizes.min_by(|one, two| one.1.total_cmp(&two.1)).unwrap_or(([0.0; 2], f64::NAN))
}

fn caption([of_1967, today]: [([f64; 2], f64); 2]) -> String {
    format!(
        "Circular contact, σ = 0.28; chapter 5 with M = 3, W = W₁. Lines of constant traction in \
         per cent of Coulomb's bound, and the traction's direction. A = (1 − σ)E/2; with \
         Aυ = Aχ = 0.4 the spin pole lies on the contact's edge. The traction is least at ({:.2}, {:.2}) a by chapter 5 and at ({:.2}, \
         {:.2}) a by the full theory, with {:.1} and {:.1} % of its bound. In the full theory the \
         area of adhesion, where the lines run, borders on the leading edge, and the directions in \
         it are not erratic.",
        of_1967.0[0],
        of_1967.0[1],
        today.0[0],
        today.0[1],
        100.0 * of_1967.1,
        100.0 * today.1
    )
}

fn agreement([of_1967, today]: [([f64; 2], f64); 2]) -> Vec<Comparison> {
    let remark = |i: usize| format!("full theory: {:.2}", today.0[i]);
    let approximate = "the thesis says “approximately”; the traction is small all around";
    vec![
        Comparison::number("spin pole, x/a", "0.71", pole()[0]),
        Comparison::number("spin pole, y/a", "0.71", pole()[1]),
        Comparison::number("X = Y = 0 about at x/a", "0.25", of_1967.0[0])
            .within(0.05, approximate)
            .remark(&remark(0)),
        Comparison::number("X = Y = 0 about at y/a", "0.50", of_1967.0[1])
            .within(0.05, approximate)
            .remark(&remark(1)),
    ]
}
