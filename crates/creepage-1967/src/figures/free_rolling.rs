//! Free rolling of unlike bodies (6.7): from adhesion everywhere to slip everywhere.

use creepage::approximate::free_rolling::FreeRolling;
use creepage::coulomb::{Constraints, Coupled, Exact, Prescribed, Resolution};
use creepage::{Contact, Ellipse, Hertz, Solid, SolidPair, Solved};
use rayon::prelude::*;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("free-rolling", "Free rolling of unlike bodies, section 6.2", make);

const NOTHING: Constraints =
    Constraints { xi: None, eta: Some(0.0), chi: Some(0.0), fx: Some(0.0), fy: None, mz: None };
/// Semi-axes and the pens of their curves.
const ELLIPSES: [(f64, Pen); 3] = [(1.0, FULL), (0.5, SECOND), (2.0, THIRD)];
/// Where all slips, on a circle, as friction vanishes.
const ALL_SLIPS: f64 = 1.251_690_3;
const LARGEST: f64 = 5.0;

/// Creepage over `2 kappa p_0/(3 G)`, of `xi` at `kappa/mu`.
fn ratio(ellipse: Ellipse, poisson: f64, kappa_over_mu: f64, xi: f64) -> f64 {
    let slip_unit = (1.0 - poisson) * ellipse.integrals().e / (2.0 * ellipse.g().sqrt());
    1.5 * xi * slip_unit / kappa_over_mu
}

fn one_way(a_over_b: f64, kappa_over_mu: f64) -> Result<[f64; 2], GalleryError> {
    let ellipse = Ellipse::from_ratio(a_over_b)?;
    let contact = Contact::new(ellipse, STEEL)?.with_kappa_over_mu(kappa_over_mu)?;
    let xi = Exact::new(&contact, Resolution::STANDARD)?.find(NOTHING)?.creepage().xi();
    Ok([kappa_over_mu, ratio(ellipse, STEEL, kappa_over_mu, xi)])
}

/// Steel on a polymer, its friction such that `kappa/mu` is as given.
fn coupled(kappa_over_mu: f64) -> Result<[f64; 2], GalleryError> {
    let pair = SolidPair::new(Solid::new(82e9, 0.28)?, Solid::new(0.5e9, 0.25)?);
    let ellipse = Ellipse::from_ratio(1.0)?;
    let friction = pair.kappa() / kappa_over_mu;
    let contact = Hertz::from_ellipse(pair, ellipse, 1.0)?.with_friction(friction)?;
    let theory = Coupled::new(&contact, Resolution::FAST, Prescribed::Load)?;
    let xi = theory.find(NOTHING)?.creepage().xi();
    Ok([kappa_over_mu, ratio(ellipse, pair.poisson(), kappa_over_mu, xi)])
}

fn make() -> Result<Reproduction, GalleryError> {
    let unlike = spaced(0.1, LARGEST, 15);
    let curve = |(a_over_b, _): (f64, Pen)| {
        unlike.par_iter().map(|k| one_way(a_over_b, *k)).collect::<Result<Curve, _>>()
    };
    let curves = ELLIPSES.map(curve).into_iter().collect::<Result<Vec<Curve>, _>>()?;
    let marks = [0.25, 0.5, 1.0, 2.0, 4.0];
    let marks = marks.par_iter().map(|k| coupled(*k)).collect::<Result<Curve, _>>()?;
    let mut data = Data::new(["curve", "kappa over mu", "creepage over 2 kappa p0 / 3 G"]);
    for ((a_over_b, _), curve) in ELLIPSES.iter().zip(&curves) {
        data.curve(&format!("one-way, a/b = {a_over_b}"), curve);
    }
    data.curve("coupled, steel on a polymer, a/b = 1", &marks);
    let caption = format!(
        "The creepage with which unlike bodies roll that transmit no force, over 2κp₀/(3G). Where \
         friction is large nothing slips: {} on a circle, by potential theory. Where it vanishes all slips: \
         {ALL_SLIPS}. Between them the full theory, σ = 0.28, with Hertz's pressure (lines), and \
         coupled (points): steel on a polymer, κ = 0.247, σ = 0.25, whose tractions move pressure and \
         contact area. The thesis proposes the calculation and has no numbers.",
        FreeRolling::RATIO
    );
    Ok(Reproduction::figure(&sheet(curves, marks), caption, data, Vec::new()))
}

fn sheet(curves: Vec<Curve>, marks: Curve) -> Sheet {
    let x = Label::default().symbol("κ").plain("/").symbol("μ");
    let y = Label::new("creepage over 2").symbol("κp").plain("₀/(3").symbol("G").plain(")");
    let level = |ratio: f64| vec![[0.0, ratio], [LARGEST, ratio]];
    let panel = Panel::new(Axis::new([0.0, LARGEST], x), Axis::new([0.4, 1.5], y))
        .curve(level(FreeRolling::RATIO), TANGENT)
        .curve(level(ALL_SLIPS), TANGENT);
    let panel = ELLIPSES
        .iter()
        .zip(curves)
        .fold(panel, |panel, ((_, pen), curve)| panel.curve(curve, *pen))
        .marks(marks, FULL_MARK);
    let sheet = Sheet::new(ITEM.title).panel(panel);
    let sheet = ELLIPSES.iter().fold(sheet, |sheet, (a_over_b, pen)| {
        sheet.key(*pen, Label::default().symbol("a/b").plain(" = ").number(&a_over_b.to_string()))
    });
    sheet
        .key(TANGENT, Label::new("circle: nothing slips, all slips"))
        .key(FULL_MARK, Label::new("coupled, circle, steel on a polymer"))
}
