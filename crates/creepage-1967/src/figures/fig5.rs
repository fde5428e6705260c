//! Fig. 5: adhesion and slip by the strip theory of Haines and Ollerton.

use creepage::Ellipse;
use creepage::approximate::strip::StripTheory;
use creepage::{Region, Theory};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig5", "Fig. 5. Areas of adhesion and slip by Haines and Ollerton", make);

/// Ratios of the semi-axes and creepage, our choice: the thesis states none.
const CASES: [(f64, f64); 2] = [(1.0, 0.8), (0.4, 0.5)];

/// The areas by strips, and the full theory's area of adhesion.
struct Case {
    a_over_b: f64,
    xi: f64,
    strips: Vec<Polygon>,
    full: Vec<Polygon>,
    shares: [f64; 2],
}

fn make() -> Result<Reproduction, GalleryError> {
    let [one, two] = CASES.map(|(a_over_b, xi)| case(a_over_b, xi));
    let cases = [one?, two?];
    let caption = "σ = 0.28, pure longitudinal creepage: narrow strips along the rolling direction, each by \
         Carter's theory. The area of adhesion is a lemon between the leading edge and the \
         trailing edge shifted forwards. The full theory (dashed) agrees for the slender contact, \
         for which the strips were made, and nearly for the circle. Ratios and creepages are \
         ours: the thesis states none.";
    let mut agreement = vec![shift()?];
    agreement.extend(cases.iter().map(share));
    Ok(Reproduction::figure(&sheet(&cases)?, caption, data(&cases), agreement))
}

/// The outlines of the areas.
fn data(cases: &[Case; 2]) -> Data {
    let mut data = Data::new(["area", "a_over_b", "xi", "x", "y"]);
    for case in cases {
        for (name, polygons) in
            [("adhesion, strips", &case.strips), ("adhesion, full theory", &case.full)]
        {
            data.points(name, &[case.a_over_b, case.xi], polygons.iter().flatten());
        }
    }
    data
}

fn case(a_over_b: f64, xi: f64) -> Result<Case, GalleryError> {
    let theory = StripTheory::new(&like_bodies(a_over_b, STEEL)?);
    let creepage = rolling_at([xi, 0.0, 0.0]);
    let ellipse = Ellipse::from_ratio(a_over_b)?;
    let (strips, share) = contact::adhesion(ellipse, &contact::of(&theory, creepage));
    let (full, full_share) = contact::full_adhesion(a_over_b, STEEL, creepage)?;
    Ok(Case { a_over_b, xi, strips, full, shares: [share, full_share] })
}

/// "The trailing edge of the contact area shifted parallel to itself in the rolling direction."
fn shift() -> Result<Comparison, GalleryError> {
    let (a_over_b, xi) = CASES[0];
    let theory = StripTheory::new(&like_bodies(a_over_b, STEEL)?);
    let creepage = rolling_at([xi, 0.0, 0.0]);
    let sticks = |x: f64, y: f64| {
        theory.field(creepage, &[[x, y]]).iter().all(|point| point.region == Region::Adhesion)
    };
    let mut shifts: Vec<f64> = Vec::new();
    for y in spaced(-0.7, 0.7, 28) {
        let edge = (1.0 - y * y).sqrt();
        let (mut slides, mut adheres) = (-edge, edge * (1.0 - 1e-9));
        if sticks(adheres, y) {
            for _ in 0..50 {
                let middle = f64::midpoint(slides, adheres);
                *(if sticks(middle, y) { &mut adheres } else { &mut slides }) = middle;
            }
            shifts.push(adheres + edge);
        }
    }
    let (low, high) = shifts.iter().fold((2.0_f64, 0.0_f64), |(l, h), s| (l.min(*s), h.max(*s)));
    let ours = format!("{low:.6} to {high:.6} of a in {} strips", shifts.len());
    Ok(Comparison::claim(
        "distance of the trailing edges, circle",
        "constant; leading edges coincide",
        ours,
        shifts.len() > 20 && high - low < 1e-6,
    ))
}

/// "In good agreement with practice, also when the contact area was not slender": within a tenth
/// of the contact, about what can be told from a photograph of fringes.
fn share(case: &Case) -> Comparison {
    let [strips, full] = case.shares;
    let ours = format!("{:.1} %, by the full theory {:.1} %", 100.0 * strips, 100.0 * full);
    let quantity = format!("share of adhesion, a/b = {}", case.a_over_b);
    Comparison::claim(
        quantity,
        "in good agreement with practice",
        ours,
        (strips - full).abs() < 0.1,
    )
    .remark("the thesis compares with photoelastic work")
}

fn sheet(cases: &[Case; 2]) -> Result<Sheet, GalleryError> {
    let mut sheet = Sheet::new(ITEM.title)
        .note(axes::setting(&[("σ", "0.28"), ("η", "0"), ("χ", "0")]))
        .columns(2);
    for case in cases {
        let ellipse = Ellipse::from_ratio(case.a_over_b)?;
        let heading = Label::default().symbol("a/b").plain(&format!(" = {}, ", case.a_over_b));
        let heading = heading.symbol("ξ").plain(&format!(" = {}", case.xi));
        let panel = contact::areas(contact::panel(ellipse, heading), ellipse, &case.strips);
        sheet = sheet.panel(contact::edge(panel.outlines(&case.full, FULL), ellipse));
    }
    Ok(sheet
        .key(Fill::ADHESION, Label::new("adhesion, strips"))
        .key(Fill::SLIP, Label::new("slip, strips"))
        .key(FULL, Label::new("adhesion, full theory")))
}
