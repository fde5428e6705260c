//! Fig. 2: the tangential traction by Carter's theory.

use creepage::approximate::carter::Carter;

use super::slender::Middle;
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig2", "Fig. 2. Tangential traction by Carter's theory", make);

/// Creepage 0.003, `rho/a` = 200, `mu` = 0.3: the thesis's example below (1.2).
const CREEPAGE: f64 = 0.003 * 200.0 / 0.3;
/// The subtracted semicircle.
const LESS: Pen = SECOND;
const BOUND: Pen = Pen { colour: "#5d6a76", dashes: "7 4", width: 1.8 };

fn make() -> Result<Reproduction, GalleryError> {
    let carter = Carter::new(CREEPAGE)?;
    let full = Middle::new()?.tractions(CREEPAGE);
    let edge = carter.trailing_edge();
    // Close where one semicircle is steep, and where the other is.
    let mut places = [circle(-1.0, 1.0), circle(edge, 1.0)].concat();
    places.sort_by(|one, two| one[0].total_cmp(&two[0]));
    let traction: Vec<_> = places.iter().map(|[x, _]| [*x, carter.at(*x).traction[0]]).collect();
    let mut data = Data::new(["curve", "x_over_a", "traction"]);
    data.curve("bound", &circle(-1.0, 1.0));
    data.curve("subtracted", &circle(edge, 1.0));
    data.curve("Carter", &traction);
    data.curve("full theory, a/b = 1/32, middle", &full);
    let apart = full.iter().map(|[x, t]| (carter.at(*x).traction[0] - t).abs());
    let caption = format!(
        "Two cylinders; creepage 0.003, ρ/a = 200, μ = 0.3, the example of the thesis: \
         υρ/(μa) = {CREEPAGE}. The traction is the semicircle of its bound less a smaller one over \
         the area of adhesion, which borders on the leading edge x = a. The points are the full \
         theory in the middle of an elliptic contact with a/b = 1/32; they lie within {:.3} of \
         Carter's curve.",
        apart.fold(0.0, f64::max)
    );
    let sheet = sheet(carter, &traction, full);
    Ok(Reproduction::figure(&sheet, caption, data, claims(carter)?))
}

/// A semicircle between two places, its points close where it is steep.
fn circle(from: f64, to: f64) -> Vec<[f64; 2]> {
    let (middle, radius) = (f64::midpoint(from, to), 0.5 * (to - from));
    let at = |angle: f64| [middle - radius * angle.cos(), radius * angle.sin()];
    spaced(0.0, std::f64::consts::PI, 120).into_iter().map(at).collect()
}

fn claims(carter: Carter) -> Result<Vec<Comparison>, GalleryError> {
    let free = Carter::new(0.0)?;
    // From the tractions, not from the formula: the least creepage without adhesion.
    let steps = || spaced(3.0, 5.0, 2000).into_iter();
    let slides =
        |creepage: &f64| Carter::new(*creepage).is_ok_and(|carter| carter.at(0.999).slip[0] > 0.0);
    let sliding = steps().find(slides).unwrap_or(f64::NAN);
    Ok(vec![
        Comparison::number(
            "share of adhesion at υ = 0.003 (ρ/a = 200, μ = 0.3)",
            "0.5",
            carter.adhesion_half_width(),
        ),
        Comparison::number(
            "υ of gross sliding (ρ/a = 200, μ = 0.3)",
            "0.006",
            sliding * 0.3 / 200.0,
        ),
        Comparison::number("b/a in free rolling", "-1", free.trailing_edge()),
    ])
}

fn sheet(carter: Carter, traction: &[[f64; 2]], full: Vec<[f64; 2]>) -> Sheet {
    let edge = carter.trailing_edge();
    let below = |from: f64, to: f64| {
        let mut area: Vec<_> =
            traction.iter().copied().filter(|[x, _]| (from..=to).contains(x)).collect();
        area.push([to, 0.0]);
        area.push([from, 0.0]);
        vec![area]
    };
    let x = Axis::new([-1.15, 1.15], Label::default().symbol("x").plain("/").symbol("a"));
    let y = Axis::new(
        [0.0, 1.12],
        Label::new("traction over ").symbol("μ").plain(" times peak pressure"),
    );
    let panel = Panel::new(x, y)
        .to_scale()
        .area(below(-1.0, edge), Fill::SLIP)
        .area(below(edge, 1.0), Fill::ADHESION)
        .curve(circle(-1.0, 1.0), BOUND)
        .curve(circle(edge, 1.0), LESS)
        .curve(traction.to_vec(), OF_1967)
        .marks(full, FULL_MARK)
        .text([-0.55, 0.12], Anchor::Middle, Label::new("slip"))
        .text([0.5, 0.12], Anchor::Middle, Label::new("adhesion"))
        .text([0.92, 1.02], Anchor::End, Label::new("rolling"))
        .arrow([0.93, 1.04], [1.1, 1.04], 1.8, "#17212b");
    Sheet::new(ITEM.title)
        .panel(panel)
        .key(OF_1967, Label::new("Carter's traction"))
        .key(BOUND, Label::new("bound ").symbol("μZ"))
        .key(LESS, Label::new("less this, over the area of adhesion"))
        .key(FULL_MARK, Label::new("full theory, ").symbol("a/b").plain(" = 1/32, middle"))
}
