//! Fig. 18: strip theory's separatrix in creepage without spin.

use creepage::Ellipse;
use creepage::approximate::strip::StripTheory;
use creepage::variational::{Start, Variational, Weight};
use creepage::{Creepage, Region, Theory};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig18", "Fig. 18. The separatrix without spin, by strip theory", make);

/// Size and direction of the creepage, and what that is called.
const CASES: [(f64, f64, &str); 6] = [
    (0.5, 0.0, "longitudinal"),
    (0.5, 90.0, "lateral"),
    (0.5, 45.0, "both"),
    (1.0, 0.0, "longitudinal"),
    (1.0, 90.0, "lateral"),
    (1.0, 45.0, "both"),
];

/// The adhesion areas of strip theory, chapter 5 and the full theory, and their shares.
struct View {
    areas: [Vec<Polygon>; 3],
    shares: [f64; 3],
}

fn creepage((size, angle, _): (f64, f64, &str)) -> Creepage {
    let (sin, cos) = angle.to_radians().sin_cos();
    rolling_at([size * cos, size * sin, 0.0])
}

fn make() -> Result<Reproduction, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let theory = chapter_5(1.0, STEEL, 3, Weight::Elliptic)?;
    let (strips, detailed) =
        (StripTheory::new(&like_bodies(1.0, STEEL)?), contact::detailed(1.0, STEEL)?);
    let mut data = Data::new(["curve", "xi", "eta", "x", "y"]);
    let mut views = Vec::new();
    for at in CASES.map(creepage) {
        let found = [
            contact::of(&strips, at),
            contact::chapter_5(&theory, at),
            contact::full(&detailed, at),
        ]
        .map(|field| contact::adhesion(circle, &field));
        let shares = found.each_ref().map(|(_, share)| *share);
        let view = View { areas: found.map(|(areas, _)| areas), shares };
        collect(&mut data, circle, at, &view);
        views.push(view);
    }
    let agreement = agreement(&strips, &theory, &views);
    Ok(Reproduction::figure(&sheet(circle, &views), caption(&views), data, agreement))
}

fn collect(data: &mut Data, circle: Ellipse, at: Creepage, view: &View) {
    for (name, areas) in ["strip theory", "M = 3", "full theory"].into_iter().zip(&view.areas) {
        let line = contact::separatrix(circle, areas);
        data.points(name, &[at.xi(), at.eta()], line.iter().flatten());
    }
}

fn caption(views: &[View]) -> String {
    let shares = |k: usize| {
        let words: Vec<_> = views.iter().map(|v| format!("{:.0}", 100.0 * v.shares[k])).collect();
        words.join(", ")
    };
    format!(
        "Circular contact, σ = 0.28; chapter 5 with M = 3, W = W₁, its separatrix T = S. Strip \
         theory shifts the trailing edge along x. Adhesion covers {} % of the contact by strip \
         theory. It covers {} % by chapter 5 and {} % by the full theory, in the order of the pictures. \
         Strip theory has the form right, and too much adhesion, above all across.",
        shares(0),
        shares(1),
        shares(2)
    )
}

fn agreement(strips: &StripTheory, theory: &Variational, views: &[View]) -> Vec<Comparison> {
    let spread = spread_of_shift(strips);
    // Without one of the creepages: "in the cases of purely longitudinal or purely lateral".
    let pure = || [0, 1, 3, 4].into_iter().map(|k| &views[k]);
    let uneven = |k: usize| pure().map(|view| unevenness(&view.areas[k])).fold(0.0, f64::max);
    let off =
        |k: usize| pure().map(|view| (view.shares[0] - view.shares[k]).abs()).fold(0.0, f64::max);
    let asymmetry = asymmetry(theory);
    vec![
        Comparison::claim(
            "separatrix of strip theory",
            "the trailing edge shifted along x",
            format!("shift the same on all lines within {spread:.3} a"),
            spread < 1e-3,
        ),
        Comparison::claim(
            "form of the adhesion area, longitudinal or lateral",
            "well predicted by strip theory",
            format!("shift even to {:.2} a by chapter 5, in the middle half", uneven(1)),
            // A tenth of the contact's length.
            uneven(1) < 0.2,
        )
        .remark(&format!(
            "to {:.2} a by the full theory; the share of adhesion is off by {:.2} and {:.2}",
            uneven(2),
            off(1),
            off(2)
        )),
        Comparison::claim(
            "area of adhesion, both creepages",
            "approximately symmetric about the x-axis",
            format!("{:.0} % of the mesh points unlike their mirror images", 100.0 * asymmetry),
            asymmetry < 0.1,
        ),
        Comparison::claim(
            "area of adhesion with growing creepage",
            "smaller and smaller",
            format!(
                "share of the contact {:.2}, then {:.2}",
                views[0].shares[1], views[3].shares[1]
            ),
            (0..3).all(|k| (0..3).all(|i| views[i].shares[k] > views[i + 3].shares[k])),
        ),
    ]
}

/// How far the shift of the trailing edge differs between lines where there is adhesion.
fn spread_of_shift(strips: &StripTheory) -> f64 {
    let at = creepage(CASES[2]);
    let shift = |y: f64| {
        let edge = -(1.0 - y * y).sqrt();
        let (mut low, mut high) = (edge, -edge);
        for _ in 0..40 {
            let middle = f64::midpoint(low, high);
            let sticks = strips.field(at, &[[middle, y]])[0].region == Region::Adhesion;
            *(if sticks { &mut high } else { &mut low }) = middle;
        }
        low - edge
    };
    let shifts: Vec<_> = spaced(-0.5, 0.5, 20).into_iter().map(shift).collect();
    let fold = |by: fn(f64, f64) -> f64| shifts.iter().copied().fold(shifts[0], by);
    fold(f64::max) - fold(f64::min)
}

/// How unevenly the separatrix is shifted from the trailing edge, for `|y| < 0.5`.
fn unevenness(areas: &[Polygon]) -> f64 {
    let circle = areas.iter().flatten().filter(|[x, y]| y.abs() < 0.5 && x.hypot(*y) < 0.97);
    // The leading part of the boundary is the contact's edge, and left out.
    let shifts = circle.map(|[x, y]| x + (1.0 - y * y).sqrt());
    let (low, high) = shifts
        .fold((f64::INFINITY, 0.0_f64), |(low, high), shift| (low.min(shift), high.max(shift)));
    high - low
}

/// The share of mesh points that adhere while their mirror image slips, or the reverse.
fn asymmetry(theory: &Variational) -> f64 {
    let points = theory.solve_from(creepage(CASES[2]), &Start::FullSliding).points;
    let unlike = points.iter().filter(|point| {
        let [x, y] = point.field.position;
        let mirror = |p: [f64; 2]| (p[0] - x).hypot(p[1] + y) < 1e-9;
        points
            .iter()
            .any(|other| mirror(other.field.position) && other.field.region != point.field.region)
    });
    unlike.count() as f64 / points.len() as f64
}

fn sheet(circle: Ellipse, views: &[View]) -> Sheet {
    let mut sheet = Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "1"), ("σ", "0.28"), ("χ", "0")]))
        .columns(3);
    for (case, view) in CASES.into_iter().zip(views) {
        sheet = sheet.panel(panel(circle, case, view));
    }
    sheet
        .key(SECOND, Label::new("strip theory"))
        .key(OF_1967, axes::degree(3))
        .key(FULL, Label::new("full theory"))
}

fn panel(circle: Ellipse, (size, _, direction): (f64, f64, &str), view: &View) -> Panel {
    let heading = Label::new(direction).plain(", ").symbol("υ").plain(" = ");
    let panel = contact::panel(circle, heading.number(&size.to_string()));
    let mut panel = contact::edge(panel, circle);
    for (areas, pen) in view.areas.iter().zip([SECOND, OF_1967]) {
        panel = panel.curves(&contact::separatrix(circle, areas), pen);
    }
    panel.curves(&contact::full_separatrix(circle, &view.areas[2]), FULL)
}
