//! Fig. 17: the separatrix of a ball that rolls freely with spin.

use creepage::Ellipse;
use creepage::Theory;
use creepage::approximate::strip::StripTheory;
use creepage::coulomb::{Constraints, Exact, Resolution};
use creepage::variational::{Start, Variational, Weight};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig17", "Fig. 17. Areas of adhesion with spin and no force across", make);

const POISSON: f64 = 0.5;
const CREEPAGE: [f64; 3] = [0.0, -0.57, 1.2];

fn make() -> Result<Reproduction, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let theory = chapter_5(1.0, POISSON, 3, Weight::Elliptic)?;
    let (strips, detailed) =
        (StripTheory::new(&like_bodies(1.0, POISSON)?), contact::detailed(1.0, POISSON)?);
    let areas = [
        contact::adhesion(circle, &contact::of(&strips, rolling_at(CREEPAGE))).0,
        contact::adhesion(circle, &contact::chapter_5(&theory, rolling_at(CREEPAGE))).0,
        contact::adhesion(circle, &contact::full(&detailed, rolling_at(CREEPAGE))).0,
    ];
    let mut data = Data::new(["curve", "x", "y"]);
    for (name, areas) in ["strip theory", "M = 3", "full theory"].into_iter().zip(&areas) {
        for line in contact::separatrix(circle, areas) {
            data.curve(name, &line);
        }
    }
    let full = Exact::new(&like_bodies(1.0, POISSON)?, Resolution::STANDARD)?;
    let no_lateral_force = Constraints {
        xi: Some(0.0),
        chi: Some(CREEPAGE[2]),
        fy: Some(0.0),
        ..Constraints::default()
    };
    let free = full.find(no_lateral_force).map_or(f64::NAN, |found| found.creepage().eta());
    let caption = format!(
        "Circular contact, σ = 0.5; chapter 5 with M = 3, W = W₁, its separatrix T = S. A rubber \
         ball that rolls with spin and no lateral force, for which the full theory needs η = \
         {free:.3}. All three theories are symmetric about the x-axis; the full theory's area of \
         adhesion is nearly that of strip theory, and chapter 5's is wider at the sides. Johnson's photograph is in the picture of 1967 \
         only. {EXPERIMENTS}"
    );
    let agreement = agreement(&theory, free);
    Ok(Reproduction::figure(&sheet(circle, &areas), caption, data, agreement))
}

fn agreement(theory: &Variational, free: f64) -> Vec<Comparison> {
    let fy = |eta: f64| theory.solve(rolling_at([CREEPAGE[0], eta, CREEPAGE[2]])).force.fy;
    let asymmetry = asymmetry(theory);
    vec![
        Comparison::number("η at which f_y = 0, χ = 1.20", "-0.57", root(fy, [-0.8, -0.3]))
            .remark(&format!("full theory: {free:.4}")),
        Comparison::number("f_y at η = −0.57", "0.00", fy(CREEPAGE[1])),
        Comparison::claim(
            "contour about the x-axis",
            "symmetric",
            format!("tractions at mirrored points the same within {asymmetry:.6}"),
            // The iteration ends within the square of 1e-6.
            asymmetry < 1e-9,
        ),
    ]
}

/// The zero of a rising function, bisected.
fn root(of: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..40 {
        let middle = f64::midpoint(low, high);
        *(if of(middle) < 0.0 { &mut low } else { &mut high }) = middle;
    }
    low
}

/// The largest difference of the traction over its bound at mirrored points.
fn asymmetry(theory: &Variational) -> f64 {
    let points = theory.solve_from(rolling_at(CREEPAGE), &Start::FullSliding).points;
    let mirrored = |at: [f64; 2]| {
        let same = |p: [f64; 2]| (p[0] - at[0]).hypot(p[1] + at[1]) < 1e-9;
        points.iter().find(|point| same(point.field.position))
    };
    let off = points.iter().filter_map(|point| {
        let other = mirrored(point.field.position)?;
        Some((point.reduced_traction - other.reduced_traction).abs())
    });
    off.fold(0.0, f64::max)
}

fn sheet(circle: Ellipse, [strips, of_1967, today]: &[Vec<Polygon>; 3]) -> Sheet {
    let settings = [("a/b", "1"), ("σ", "0.5"), ("ξ", "0"), ("η", "-0.57"), ("χ", "1.2")];
    let mut sheet = Sheet::new(ITEM.title).note(axes::setting(&settings)).columns(2);
    let strip_line = contact::separatrix(circle, strips);
    let full_line = contact::full_separatrix(circle, today);
    let today = contact::smooth_area(today);
    for (areas, heading) in [(of_1967, axes::degree(3)), (&today, Label::new("full theory"))] {
        let panel = contact::areas(contact::panel(circle, heading), circle, areas);
        let panel = contact::edge(panel, circle).curves(&strip_line, SECOND);
        sheet = sheet.panel(panel.curves(&full_line, FULL));
    }
    sheet
        .key(Fill::ADHESION, Label::new("adhesion"))
        .key(Fill::SLIP, Label::new("slip"))
        .key(SECOND, Label::new("separatrix, strip theory"))
        .key(FULL, Label::new("separatrix, full theory"))
}
