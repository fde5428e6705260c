//! Gross sliding of unlike bodies, proposition III: the area is shifted, then elliptic.

use creepage::Ellipse;
use creepage::coulomb::{GrossSliding, SlidingError};
use rayon::prelude::*;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("sliding-with-kappa", "Gross sliding of unlike bodies, proposition III", make);

const Q: [f64; 5] = [0.1, 0.2, 0.3, 0.4, 0.5];
/// Whose pressures are drawn, after that without friction.
const DRAWN: [(usize, Pen); 2] = [(1, SECOND), (4, FULL)];

fn make() -> Result<Reproduction, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let solved: Result<Vec<_>, SlidingError> =
        Q.par_iter().map(|q| GrossSliding::new(circle, *q, 0.0)).collect();
    let solved = solved?;
    let curve = |of: fn(&GrossSliding) -> f64| -> Curve {
        Q.iter().zip(&solved).map(|(q, sliding)| [*q, of(sliding)]).collect()
    };
    let changes = [
        ("shift", curve(|s| s.shift()[0])),
        ("longer", curve(|s| s.semi_axes()[0] - 1.0)),
        ("deeper", curve(|s| s.approach() - 1.0)),
    ];
    let frictionless: Curve =
        spaced(-1.0, 1.0, 80).into_iter().map(|x| [x, (1.0 - x * x).max(0.0).sqrt()]).collect();
    let pressures = DRAWN.map(|(k, _)| pressures(&solved[k]));
    let mut data = Data::new(["curve", "q or x over a", "value"]);
    for (name, curve) in &changes {
        data.curve(name, curve);
    }
    for ((k, _), curve) in DRAWN.iter().zip(&pressures) {
        data.curve(&format!("pressure, q = {}", Q[*k]), curve);
    }
    let caption = "Unlike bodies that slide over each other under a constant load, their frictionless \
        contact a circle, the traction on the lower body towards +x, q = κμ/(1 - σ). Above: the \
        pressure along the sliding direction. Below: shift of the area, growth of its semi-axis along \
        the sliding direction and of the approach, by the full solution (points) and by the first term \
        of proposition III's expansion, worked out (lines): -q/π, (1/9 + 1/(3π²)) q², (1/9 - 1/(6π²)) q². \
        Across, the area does not grow.";
    let agreement = agreement(&solved);
    Ok(Reproduction::figure(&sheet(frictionless, pressures, &changes), caption, data, agreement))
}

fn pressures(sliding: &GrossSliding) -> Curve {
    let [[trailing, leading], _] = sliding.extents();
    // The ends of the finer mesh are extrapolated: a little inside them.
    let within = spaced(-0.999, 0.999, 80).into_iter();
    let x = within.map(|s| f64::midpoint(trailing, leading) + 0.5 * (leading - trailing) * s);
    x.map(|x| [x, sliding.pressure([x, 0.0])]).collect()
}

/// What proposition III says, at the smallest `q`.
fn agreement(solved: &[GrossSliding]) -> Vec<Comparison> {
    let (q, [shift, across]) = (Q[0], solved[0].shift());
    let [along, wide] = solved[0].semi_axes();
    vec![
        Comparison::claim(
            "area at first order in q",
            "shifted along the sliding direction",
            format!("shifted by {:.4} q a; {:.1e} across", shift / q, across),
            (shift / q / GrossSliding::SHIFT - 1.0).abs() < 0.01 && across.abs() < 1e-6,
        ),
        Comparison::claim(
            "area at second order",
            "elliptic",
            format!(
                "longer by {:.3} q² a, wider by {:.3} q² a",
                (along - 1.0) / q / q,
                (wide - 1.0) / q / q
            ),
            along > wide,
        ),
    ]
}

fn sheet(frictionless: Curve, pressures: [Curve; 2], changes: &[(&str, Curve)]) -> Sheet {
    let x = Label::default().symbol("x").plain("/").symbol("a");
    let y = Label::default().symbol("Z").plain("/").indexed("p", "0");
    let profile = Panel::new(Axis::new([-1.3, 1.1], x), Axis::new([0.0, 1.1], y))
        .curve(frictionless, TANGENT);
    let profile = DRAWN
        .iter()
        .zip(pressures)
        .fold(profile, |panel, ((_, pen), curve)| panel.curve(curve, *pen));
    let change = Label::new("change");
    let growth = Panel::new(
        Axis::new([0.0, 0.55], Label::default().symbol("q")),
        Axis::new([-0.18, 0.06], change),
    );
    let terms: [fn(f64) -> f64; 3] = [
        |q| GrossSliding::SHIFT * q,
        |q| GrossSliding::LENGTHENING * q * q,
        |q| GrossSliding::DEEPENING * q * q,
    ];
    let pens = [FULL, SECOND, THIRD];
    let growth =
        changes.iter().zip(terms).zip(pens).fold(growth, |panel, (((_, curve), term), pen)| {
            let line = spaced(0.0, 0.55, 40).into_iter().map(|q| [q, term(q)]).collect();
            panel.curve(line, pen).marks(curve.clone(), PRINTED)
        });
    let sheet = Sheet::new(ITEM.title).panel(profile).panel(growth);
    let sheet = sheet.key(TANGENT, Label::new("pressure without friction"));
    let sheet = DRAWN.iter().fold(sheet, |sheet, (k, pen)| {
        let label = Label::new("pressure, ").symbol("q").plain(" = ").number(&Q[*k].to_string());
        sheet.key(*pen, label)
    });
    sheet
        .key(FULL, Label::new("shift over ").symbol("a"))
        .key(SECOND, Label::new("growth of the semi-axis along ").symbol("x"))
        .key(THIRD, Label::new("growth of the approach"))
        .key(PRINTED, Label::new("full solution"))
}
