//! Shared computation of Figs 3a and 3b: coefficients over all ratios of the semi-axes, `a/b` growing to 1 on the left,
//! `b/a` falling from 1 on the right.

use creepage::InvalidValue;
use creepage::approximate::linear::CreepageCoefficients;

use crate::prelude::*;
use crate::tables::coefficients::Coefficient;

pub(super) const POISSON: [(f64, &str); 3] = [(0.0, "0"), (0.25, "1/4"), (0.5, "1/2")];
const PENS: [Pen; 3] = [OF_1967, SECOND, THIRD];
const MARKS: [Mark; 3] = [
    Mark::open(Shape::Circle, "#10243a"),
    Mark::open(Shape::Square, "#1565c0"),
    Mark::open(Shape::Triangle, "#2e7d32"),
];

/// A coefficient, its highest value in the picture, and how it is picked.
pub(super) struct Shown {
    pub(super) index: &'static str,
    pub(super) top: f64,
    pub(super) of: fn(CreepageCoefficients) -> f64,
}

/// Where a ratio stands on the axis: `a/b` from 0 to 1, then `2 - b/a`.
fn place(a_over_b: f64) -> f64 {
    if a_over_b <= 1.0 { a_over_b } else { 2.0 - a_over_b.recip() }
}

/// `(place, value)` of a converged coefficient.
fn curve(shown: &Shown, poisson: f64) -> Result<Vec<[f64; 2]>, InvalidValue> {
    let ratio = |place: f64| if place <= 1.0 { place } else { (2.0 - place).recip() };
    let mut points = Vec::new();
    for place in spaced(0.02, 1.94, 96) {
        points.push([
            place,
            (shown.of)(CreepageCoefficients::new(&like_bodies(ratio(place), poisson)?)?),
        ]);
    }
    Ok(points)
}

/// The picture, a panel a coefficient, and its numbers.
pub(super) fn picture(
    title: &str,
    all: &[Shown],
    printed: &[Coefficient],
) -> Result<(Sheet, Data), InvalidValue> {
    let mut data = Data::new(["curve", "poisson", "a_over_b", "value"]);
    let mut sheet = Sheet::new(title).columns(all.len().min(2)).width(900.0);
    for shown in all {
        let mut panel = Panel::new(axis(), scale(shown)).height(380.0);
        for (k, (poisson, name)) in POISSON.iter().enumerate() {
            let curve = curve(shown, *poisson)?;
            push(&mut data, &format!("C{}", shown.index), *poisson, &curve);
            panel = panel.named(
                curve,
                PENS[k],
                Label::default().symbol("σ").plain(&format!(" = {name}")),
            );
        }
        for (k, (poisson, _)) in POISSON.iter().enumerate() {
            let points = points(printed, shown, *poisson);
            push(&mut data, &format!("C{}, Table 3", shown.index), *poisson, &points);
            panel = panel.marks(points, MARKS[k]);
        }
        sheet = sheet.panel(panel);
    }
    for (k, (_, name)) in POISSON.iter().enumerate() {
        sheet =
            sheet.key(MARKS[k], Label::default().symbol("σ").plain(&format!(" = {name}, Table 3")));
    }
    Ok((sheet, data))
}

fn push(data: &mut Data, name: &str, poisson: f64, points: &[[f64; 2]]) {
    let ratio = |place: f64| if place <= 1.0 { place } else { (2.0 - place).recip() };
    for [place, value] in points {
        data.points(name, &[poisson], [&[ratio(*place), *value]]);
    }
}

fn points(printed: &[Coefficient], shown: &Shown, poisson: f64) -> Vec<[f64; 2]> {
    printed
        .iter()
        .filter(|one| {
            one.name == format!("C{}", shown.index) && (one.poisson - poisson).abs() < 1e-9
        })
        .filter_map(|one| Some([place(one.a_over_b), one.entry.printed.parse().ok()?]))
        .collect()
}

fn axis() -> Axis {
    let numbers = [0.0, 0.2, 0.4, 0.6, 0.8, 1.0].map(|place| (place, place.to_string()));
    let falling = [0.8, 0.6, 0.4, 0.2, 0.0].map(|share: f64| (2.0 - share, share.to_string()));
    let label = Label::default()
        .symbol("a/b")
        .plain("  rising to 1, then  ")
        .symbol("b/a")
        .plain("  falling");
    Axis::new([0.0, 2.0], label).ticks(numbers.into_iter().chain(falling).collect())
}

fn scale(shown: &Shown) -> Axis {
    Axis::new([0.0, shown.top], Label::default().indexed("C", shown.index))
}
