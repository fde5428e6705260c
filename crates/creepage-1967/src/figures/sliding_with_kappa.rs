//! Gross sliding of unlike bodies, proposition III: the area is shifted, then elliptic.

use std::f64::consts::TAU;

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
    let all: Vec<Curve> = solved.iter().map(middles).collect();
    for (q, curve) in Q.iter().zip(&all) {
        data.curve(&format!("middles of lines, q = {q}"), curve);
    }
    let caption = "Unlike bodies that slide over each other under a constant load, their frictionless \
        contact a circle, the traction on the lower body towards +x, q = κμ/(1 - σ). Above: the \
        pressure along the sliding direction. Below: shift of the area, growth of its semi-axis along \
        the sliding direction and of the approach, by the full solution (points) and by the first term \
        of proposition III's expansion, worked out (lines): -q/π, (1/9 + 1/(3π²)) q², (1/9 - 1/(6π²)) q². \
        Across, the area does not grow. At the bottom: how far the middles of lines along the sliding direction lie \
        from that of the middle line, over q³; in an ellipse they would not. The curves of different q nearly fall together, for it is the \
        third power that first makes the area no ellipse, as the proposition says: an egg. What is linear in q there is an error of the \
        strips, for to first order the area is only shifted, and is taken off by that of q = 0.1.";
    let agreement = agreement(&solved, &all);
    let sheet = sheet(frictionless, pressures, &changes).panel(egg(&all));
    let sheet = BENT.iter().fold(sheet, |sheet, (k, pen)| {
        let label = Label::new("middles of lines, ").symbol("q").plain(" = ");
        sheet.key(*pen, label.number(&Q[*k].to_string()))
    });
    Ok(Reproduction::figure(&sheet, caption, data, agreement))
}

fn pressures(sliding: &GrossSliding) -> Curve {
    let [[trailing, leading], _] = sliding.extents();
    // The ends of the finer mesh are extrapolated: a little inside them.
    let within = spaced(-0.999, 0.999, 80).into_iter();
    let x = within.map(|s| f64::midpoint(trailing, leading) + 0.5 * (leading - trailing) * s);
    x.map(|x| [x, sliding.pressure([x, 0.0])]).collect()
}

/// Whose middles are drawn.
const BENT: [(usize, Pen); 3] = [(2, OF_1967), (3, THIRD), (4, TANGENT)];

/// How far the middle of each line along the sliding direction lies from that of the middle line, over
/// `y/b`: zero for every ellipse with an axis along it.
fn middles(sliding: &GrossSliding) -> Curve {
    /// A quarter of the edge, without the tips, where lines are too short to tell.
    const QUARTER: usize = 30;
    const SHOWN: usize = 18;
    let outline = sliding.outline(4 * QUARTER);
    let middle = |k: usize| f64::midpoint(outline[k][0], outline[2 * QUARTER - k][0]);
    let angle = |k: usize| TAU * k as f64 / (4 * QUARTER) as f64;
    (0..=SHOWN).map(|k| [angle(k).sin(), middle(k) - middle(0)]).collect()
}

/// The same over `q^3`. To first order in `q` the area is only shifted: what the smallest `q` has is the
/// error of the strips, in proportion to `q`, and is taken off.
fn bends(all: &[Curve], k: usize) -> Curve {
    let (q, least) = (Q[k], Q[0]);
    let unit = q.powi(3) - q * least * least;
    let both = all[k].iter().zip(&all[0]);
    both.map(|([t, own], [_, first])| [*t, (own - q / least * first) / unit]).collect()
}

fn egg(all: &[Curve]) -> Panel {
    let most = BENT.iter().flat_map(|(k, _)| bends(all, *k)).map(|p| p[1]).fold(0.0, f64::max);
    let x = Axis::new([0.0, 0.9], Label::default().symbol("y").plain("/").symbol("b"));
    let name = Label::new("middle of a line across ").symbol("y").plain(" beyond that of ");
    let y = Axis::new(
        [-0.1 * most, 1.15 * most],
        name.symbol("y").plain(" = 0, over ").symbol("q").plain("³").symbol("a"),
    );
    let panel = Panel::new(x, y).height(220.0).curve(vec![[0.0, 0.0], [0.9, 0.0]], Pen::GUIDE);
    BENT.iter().fold(panel, |panel, (k, pen)| panel.curve(bends(all, *k), *pen))
}

/// What proposition III says, at the smallest `q`; of higher powers at the largest.
fn agreement(solved: &[GrossSliding], all: &[Curve]) -> Vec<Comparison> {
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
        higher(all),
    ]
}

fn higher(all: &[Curve]) -> Comparison {
    let last = |k: usize| bends(all, k).last().map_or(f64::NAN, |point| point[1]);
    let [low, most] = [2, 4].map(last);
    let size = |k: usize| last(k) * (Q[k].powi(3) - Q[k] * Q[0] * Q[0]);
    let power = (size(4) / size(2)).ln() / (Q[4] / Q[2]).ln();
    Comparison::claim(
        "area at higher orders",
        "not elliptic",
        format!(
            "an egg: towards the tips the middles of lines lie forward by {most:.3} q³ a at q = 0.5, {low:.3} at 0.3: as q to the {power:.1}"
        ),
        most > 0.0 && (2.4..3.6).contains(&power),
    )
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
