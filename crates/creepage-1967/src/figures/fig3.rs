//! Fig. 3: the force by Carter's theory.

use creepage::approximate::carter::Carter;

use super::slender::Middle;
use crate::prelude::*;

pub(crate) const ITEM: Item = Item::new("fig3", "Fig. 3. Force by Carter's theory", make);

fn make() -> Result<Reproduction, GalleryError> {
    let force = |creepage: f64| Carter::new(creepage).map(|carter| [creepage, carter.force()]);
    let curve = spaced(0.0, 6.0, 120).into_iter().map(force).collect::<Result<Vec<_>, _>>()?;
    let middle = Middle::new()?;
    let full: Vec<_> = spaced(0.25, 5.5, 14).into_iter().map(|k| [k, middle.force(k)]).collect();
    let mut apart: f64 = 0.0;
    for [creepage, of_full] in &full {
        apart = apart.max((force(*creepage)?[1] - of_full).abs());
    }
    let mut data = Data::new(["curve", "creepage", "force"]);
    data.curve("Carter", &curve);
    data.curve("full theory, a/b = 1/32, middle", &full);
    let caption = format!(
        "Two cylinders: a parabola, tangent to F = μN at υρ/(μa) = 4, where gross sliding sets in. \
         The points are the force of the middle strip of an elliptic contact with a/b = 1/32 by \
         the full theory; they lie within {apart:.3} of it."
    );
    Ok(Reproduction::figure(&sheet(curve, full), caption, data, claims()?))
}

/// (1.3) against the integral of the tractions of Fig. 2.
fn claims() -> Result<Vec<Comparison>, GalleryError> {
    let mut lines = Vec::new();
    for (creepage, printed) in [(1.0, "0.4375"), (2.0, "0.75"), (3.0, "0.9375"), (4.0, "1.000")] {
        let carter = Carter::new(creepage)?;
        // x = sin(angle): the integrand is smooth.
        let steps = 4000;
        let step = std::f64::consts::PI / f64::from(steps);
        let at = |k: u32| {
            let angle = -0.5 * std::f64::consts::PI + (f64::from(k) + 0.5) * step;
            carter.at(angle.sin()).traction[0] * angle.cos() * step
        };
        let force = (0..steps).map(at).sum::<f64>() / (0.5 * std::f64::consts::PI);
        let quantity = format!("F/μN by (1.3) at υρ/(μa) = {creepage}");
        let line = Comparison::number(quantity, printed, force);
        lines.push(line.remark("ours: the integral of the tractions"));
    }
    Ok(lines)
}

fn sheet(curve: Vec<[f64; 2]>, full: Vec<[f64; 2]>) -> Sheet {
    let x =
        Label::new("creepage ").indexed("υ", "x").symbol("ρ").plain("/(").symbol("μa").plain(")");
    let y = Label::default().indexed("F", "x").plain("/").symbol("μN");
    let panel = Panel::new(Axis::new([0.0, 6.0], x), Axis::new([0.0, 1.12], y))
        .curve(vec![[0.0, 0.0], [2.24, 1.12]], TANGENT)
        .curve(curve, OF_1967)
        .marks(full, FULL_MARK);
    Sheet::new(ITEM.title)
        .panel(panel)
        .key(OF_1967, Label::new("Carter"))
        .key(TANGENT, Label::new("without slip"))
        .key(FULL_MARK, Label::new("full theory, ").symbol("a/b").plain(" = 1/32, middle strip"))
}
