//! Fig. 15: the lateral force due to lateral creepage and spin on a circle.

use creepage::variational::Weight;
use creepage::{Creepage, Force};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig15", "Fig. 15. Force due to lateral creepage and spin", make);

/// The curves 1 to 5 of the caption.
const SPINS: [f64; 5] = [0.0, -0.561, -2.25, -4.78, -9.58];
/// Poisson's ratio as the caption has it, where all else of chapter 5 has 0.28.
const OF_THE_CAPTION: f64 = 0.23;
/// From the lowest to the highest force that is drawn.
const FRAME: [f64; 2] = [-1.05, 1.05];

fn make() -> Result<Reproduction, GalleryError> {
    let [mut curves, mut others, mut fulls, mut bands] = [const { Vec::new() }; 4];
    for chi in SPINS {
        let creepages = across(chi);
        curves.push(curve(&creepages, STEEL)?);
        others.push(curve(&creepages, OF_THE_CAPTION)?);
        let found = full_solutions(1.0, STEEL, &creepages)?;
        bands.push(band(&etas(), &found, |force| force.fy, FRAME));
        fulls.push(etas().iter().zip(&found).map(|(eta, found)| [*eta, found.force.fy]).collect());
    }
    let mut data = Data::new(["curve", "chi", "eta", "fy"]);
    for (name, set) in [("M = 3", &curves), ("full theory", &fulls)] {
        for (chi, curve) in SPINS.iter().zip(set) {
            data.points(name, &[*chi], curve);
        }
    }
    let worst = |set: &[Curve], other: &[Curve]| {
        set.iter().zip(other).map(|(one, two)| farthest(one, two)).collect::<Vec<_>>()
    };
    let apart = worst(&curves, &fulls);
    let poisson = worst(&curves, &others).into_iter().fold(0.0, f64::max);
    let caption = format!(
        "Circular contact; chapter 5 with M = 3, W = W₁. The greatest distances from the full \
         theory are {:.3}, {:.3}, {:.3}, {:.3} and {:.3} of μN for the curves 1 to 5. Computed \
         with σ = 0.28, as all of chapter 5; the caption in the scan has 0.23, which changes no \
         force by more than {poisson:.3}. {EXPERIMENTS}",
        apart[0], apart[1], apart[2], apart[3], apart[4]
    );
    Ok(Reproduction::figure(&sheet(&curves, &fulls, bands), caption, data, claims(&apart)))
}

fn etas() -> Vec<f64> {
    spaced(-3.0, 3.0, 120)
}

fn across(chi: f64) -> Vec<Creepage> {
    etas().into_iter().map(|eta| rolling_at([0.0, eta, chi])).collect()
}

/// By chapter 5, from either end to the middle: far creepage is the sure start.
fn curve(creepages: &[Creepage], poisson: f64) -> Result<Curve, GalleryError> {
    let theory = chapter_5(1.0, poisson, 3, Weight::Elliptic)?;
    let middle = creepages.len() / 2;
    let mut left: Vec<_> = creepages[..middle].iter().rev().copied().collect();
    let mut forces: Vec<Force> = chained(&theory, &left);
    forces.reverse();
    left.clear();
    forces.extend(chained(&theory, &creepages[middle..]));
    Ok(points(&etas(), &forces, |force| force.fy))
}

/// Chapter 6.1: "The error in the total force is at most about 10 %, see fig. 15."
fn claims(apart: &[f64]) -> Vec<Comparison> {
    let worst = apart.iter().copied().fold(0.0, f64::max);
    let line = Comparison::claim(
        "error of the force, in μN",
        "at most about 10 %",
        format!("{:.1} % against the full theory", 100.0 * worst),
        worst < 0.11,
    );
    let reason = "the thesis compares with Johnson's points, which are not in its text; the error is \
        largest on curve 3, where creepage and spin oppose each other; for the circle and the other \
        ellipses of the catalogue see the item chapter-5";
    vec![line.because(reason)]
}

fn sheet(curves: &[Curve], fulls: &[Curve], bands: Vec<Curve>) -> Sheet {
    let x = Axis::new([-3.0, 3.0], axes::eta());
    let y = Axis::new(FRAME, axes::fy());
    let mut panel = Panel::new(x, y).height(440.0).area(bands, BAND);
    for (k, (curve, full)) in curves.iter().zip(fulls).enumerate() {
        let name = Label::new(&format!("{}: ", k + 1)).symbol("χ").plain(" = ");
        let name = name.number(&SPINS[k].to_string());
        panel = panel.named(curve.clone(), PENS[k], name).curve(full.clone(), FULL.wide(1.5));
    }
    Sheet::new(ITEM.title)
        .note(
            axes::setting(&[("a/b", "1"), ("σ", "0.28"), ("ξ", "0")])
                .plain(", chapter 5 with ")
                .symbol("M")
                .plain(" = 3"),
        )
        .panel(panel)
        .key(FULL.wide(1.5), Label::new("full theory"))
        .key(BAND, Label::new("error bars of the full theory"))
}

/// Unlike the full theory's red dashes.
const PENS: [Pen; 5] = [
    Pen { colour: "#10243a", dashes: "", width: 2.6 },
    Pen { colour: "#1565c0", dashes: "2.5 3.5", width: 2.8 },
    Pen { colour: "#2e7d32", dashes: "13 4 2.5 4", width: 2.5 },
    Pen { colour: "#8e24aa", dashes: "6 3", width: 2.5 },
    Pen { colour: "#78909c", dashes: "", width: 3.4 },
];
