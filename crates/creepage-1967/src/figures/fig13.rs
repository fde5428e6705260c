//! Fig. 13: the force due to pure creepage on a circle.

use creepage::Creepage;
use creepage::variational::Weight;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig13", "Fig. 13. Force due to longitudinal and lateral creepage", make);

const DEGREES: [usize; 3] = [2, 3, 4];
const PENS: [Pen; 3] = [SECOND, OF_1967, THIRD];
const CREEPAGES: [fn(f64) -> Creepage; 2] =
    [|xi| rolling_at([xi, 0.0, 0.0]), |eta| rolling_at([0.0, eta, 0.0])];

/// The curves over one creepage: by degree, and by the full theory.
struct Side {
    by_degree: Vec<Curve>,
    full: Curve,
}

fn make() -> Result<Reproduction, GalleryError> {
    let sides = [side(0, |force| force.fx)?, side(1, |force| force.fy)?];
    let mut data = Data::new(["curve", "creepage", "force"]);
    for (name, side) in ["fx", "fy"].iter().zip(&sides) {
        for (degree, curve) in DEGREES.iter().zip(&side.by_degree) {
            data.curve(&format!("{name}, M = {degree}"), curve);
        }
        data.curve(&format!("{name}, full theory"), &side.full);
    }
    let apart = sides.each_ref().map(|side| {
        let curves = side.by_degree.iter();
        curves.map(|curve| farthest(&grown(curve), &grown(&side.full))).fold(0.0, f64::max)
    });
    let caption = format!(
        "Circular contact, σ = 0.28, no spin; chapter 5 with W = 1. The thesis shows M = 2 for fx \
         and M = 4 for fy only. From a creepage of 0.4 on, all curves of 1967 are within {:.3} \
         (fx) and {:.3} (fy) of the full theory. Below they are too low: polynomials of so low a \
         degree cannot show a narrow area of slip. {EXPERIMENTS}",
        apart[0], apart[1]
    );
    Ok(Reproduction::figure(&sheet(&sides), caption, data, vec![coincidence(&sides)]))
}

fn side(number: usize, of: fn(&creepage::Force) -> f64) -> Result<Side, GalleryError> {
    let sizes = spaced(0.0, 3.0, 75);
    let creepages: Vec<_> = sizes.iter().map(|size| CREEPAGES[number](*size)).collect();
    let mut by_degree = Vec::new();
    for degree in DEGREES {
        let theory = chapter_5(1.0, STEEL, degree, Weight::Uniform)?;
        by_degree.push(points(&sizes[1..], &chained(&theory, &creepages[1..]), of));
    }
    let full = points(&sizes, &full(1.0, STEEL, &creepages)?, of);
    Ok(Side { by_degree, full })
}

/// What of a curve is above a creepage of 0.4, where chapter 5 holds.
fn grown(curve: &Curve) -> Curve {
    curve.iter().copied().filter(|point| point[0] > 0.399).collect()
}

/// "The theoretical curves for the degrees M = 2, 3, 4 nearly coincide."
fn coincidence(sides: &[Side; 2]) -> Comparison {
    let mut spread: f64 = 0.0;
    for side in sides {
        for (one, two) in [(0, 1), (0, 2), (1, 2)] {
            let [one, two] = [one, two].map(|k| grown(&side.by_degree[k]));
            spread = spread.max(farthest(&one, &two));
        }
    }
    let ours = format!("within {spread:.3} from a creepage of 0.4 on");
    // What can just be told apart in a printed diagram some ten centimetres high.
    Comparison::claim("forces with M = 2, 3, 4", "nearly coincide", ours, spread < 0.05)
}

fn sheet(sides: &[Side; 2]) -> Sheet {
    let mut sheet = Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "1"), ("σ", "0.28"), ("χ", "0"), ("W", "1")]))
        .columns(2)
        .width(920.0);
    let names = [(axes::xi(), axes::fx()), (axes::eta(), axes::fy())];
    for (side, (x, y)) in sides.iter().zip(names) {
        let mut panel = Panel::new(Axis::new([0.0, 3.0], x), Axis::new([0.0, 1.05], y));
        for (degree, (curve, pen)) in DEGREES.iter().zip(side.by_degree.iter().zip(PENS)).rev() {
            panel = panel.named(curve.clone(), pen, axes::short_degree(*degree));
        }
        let full = Label::new("full theory");
        sheet = sheet.panel(panel.named(side.full.clone(), FULL, full).height(340.0));
    }
    sheet
}
