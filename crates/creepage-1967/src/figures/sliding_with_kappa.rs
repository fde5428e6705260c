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
    let deviations: Vec<Curve> = solved.iter().map(deviation).collect();
    for (q, curve) in Q.iter().zip(&deviations) {
        data.curve(&format!("edge beyond the ellipse, q = {q}"), curve);
    }
    let caption = "Unlike bodies that slide over each other under a constant load, their frictionless \
        contact a circle, the traction on the lower body towards +x, q = κμ/(1 - σ). Above: the \
        pressure along the sliding direction. Below: shift of the area, growth of its semi-axis along \
        the sliding direction and of the approach, by the full solution (points) and by the first term \
        of proposition III's expansion, worked out (lines): -q/π, (1/9 + 1/(3π²)) q², (1/9 - 1/(6π²)) q². \
        Across, the area does not grow. At the bottom: how far the edge lies outside the ellipse through its four \
        extremes, over q³: an ellipse would be the zero line. The curves of different q nearly fall together, for it is the third \
        power that first makes the area no ellipse, as the proposition says: an egg, its front side fuller than its rear.";
    let agreement = agreement(&solved, &deviations);
    let sheet = sheet(frictionless, pressures, &changes).panel(egg(&deviations));
    Ok(Reproduction::figure(
        &DEVIATIONS.iter().fold(sheet, |sheet, (k, pen)| {
            let label = Label::new("edge beyond the ellipse, ").symbol("q").plain(" = ");
            sheet.key(*pen, label.number(&Q[*k].to_string()))
        }),
        caption,
        data,
        agreement,
    ))
}

fn pressures(sliding: &GrossSliding) -> Curve {
    let [[trailing, leading], _] = sliding.extents();
    // The ends of the finer mesh are extrapolated: a little inside them.
    let within = spaced(-0.999, 0.999, 80).into_iter();
    let x = within.map(|s| f64::midpoint(trailing, leading) + 0.5 * (leading - trailing) * s);
    x.map(|x| [x, sliding.pressure([x, 0.0])]).collect()
}

/// Whose edges are drawn.
const DEVIATIONS: [(usize, Pen); 3] = [(2, OF_1967), (3, THIRD), (4, TANGENT)];

/// How far the edge lies outside the ellipse through its extremes, along the ellipse's radius, over its
/// eccentric angle: all that is no shift and no stretch.
fn deviation(sliding: &GrossSliding) -> Curve {
    const POINTS: usize = 120;
    let ([x, y], [a, b]) = (sliding.shift(), sliding.semi_axes());
    let place = |k: usize| TAU * k as f64 / POINTS as f64;
    let beyond = |point: [f64; 2]| ((point[0] - x) / a).hypot((point[1] - y) / b) - 1.0;
    let outline = sliding.outline(POINTS).into_iter().enumerate();
    let mut curve: Curve =
        outline.map(|(k, point)| [place(k).to_degrees(), beyond(point)]).collect();
    curve.push([360.0, curve[0][1]]);
    curve
}

/// Half the range of a curve.
fn size(curve: &Curve) -> f64 {
    let (low, high) = curve
        .iter()
        .fold((0.0_f64, 0.0_f64), |(low, high), point| (low.min(point[1]), high.max(point[1])));
    0.5 * (high - low)
}

fn egg(deviations: &[Curve]) -> Panel {
    let x = Axis::new([0.0, 360.0], Label::new("angle from the sliding direction [°]"));
    let scaled = |k: usize| -> Curve {
        deviations[k].iter().map(|[angle, off]| [*angle, off / Q[k].powi(3)]).collect()
    };
    let most =
        DEVIATIONS.iter().flat_map(|(k, _)| scaled(*k)).map(|p| p[1].abs()).fold(0.0, f64::max);
    let y = Axis::new(
        [-1.15 * most, 1.15 * most],
        Label::new("edge beyond the ellipse over ").symbol("q").plain("³ a"),
    );
    let panel = Panel::new(x, y).height(220.0).curve(vec![[0.0, 0.0], [360.0, 0.0]], Pen::GUIDE);
    DEVIATIONS.iter().fold(panel, |panel, (k, pen)| panel.curve(scaled(*k), *pen))
}

/// What proposition III says, at the smallest `q`; of higher powers at the largest.
fn agreement(solved: &[GrossSliding], deviations: &[Curve]) -> Vec<Comparison> {
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
        higher(deviations),
    ]
}

fn higher(deviations: &[Curve]) -> Comparison {
    let [half, most] = [2, 4].map(|k| size(&deviations[k]));
    let power = (most / half).ln() / (Q[4] / Q[2]).ln();
    Comparison::claim(
        "area at higher orders",
        "not elliptic",
        format!(
            "the edge leaves the ellipse through its extremes by ±{half:.1e} a at q = 0.3 and ±{most:.1e} a at q = 0.5: as q to the {power:.1}"
        ),
        most > 1e-4 && (2.3..4.2).contains(&power),
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
