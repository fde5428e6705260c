//! Fig. 13: the force due to pure creepage on a circle.

use creepage::rolling::Creepage;
use creepage::rolling::variational::Weight;
use creepage_report::plot::{Label, Panel, Scale, Sheet};

use crate::axes;
use crate::comparison::Comparison;
use crate::data::Data;
use crate::error::GalleryError;
use crate::inks::{FULL, OF_1967, SECOND};
use crate::item::{EXPERIMENTS, Item, Reproduction};
use crate::theories::{STEEL, chained, chapter_5, farthest, full, points, spaced};

pub(crate) const ITEM: Item =
    Item::new("fig13", "Fig. 13. Force due to longitudinal and lateral creepage", make);

type Curve = Vec<[f64; 2]>;

fn make() -> Result<Reproduction, GalleryError> {
    let sizes = spaced(0.1, 3.0, 58);
    let along = sizes.iter().map(|&xi| Creepage { xi, ..Creepage::default() }).collect::<Vec<_>>();
    let across =
        sizes.iter().map(|&eta| Creepage { eta, ..Creepage::default() }).collect::<Vec<_>>();
    let mut by_degree: Vec<[Curve; 2]> = Vec::new();
    for degree in [2, 3, 4] {
        let theory = chapter_5(1.0, STEEL, degree, Weight::Uniform)?;
        let fx = points(&sizes, &chained(&theory, &along), |force| force.fx);
        let fy = points(&sizes, &chained(&theory, &across), |force| force.fy);
        by_degree.push([fx, fy]);
    }
    let full_fx = points(&sizes, &full(1.0, STEEL, &along)?, |force| force.fx);
    let full_fy = points(&sizes, &full(1.0, STEEL, &across)?, |force| force.fy);
    let (fx, fy) = (&by_degree[0][0], &by_degree[2][1]);
    let apart = [farthest(fx, &full_fx), farthest(fy, &full_fy)];
    let mut data = Data::new(["curve", "creepage", "force"]);
    data.curve("fx, M = 2", fx);
    data.curve("fy, M = 4", fy);
    data.curve("fx, full theory", &full_fx);
    data.curve("fy, full theory", &full_fy);
    let sheet = sheet([fx, fy, &full_fx, &full_fy].map(Clone::clone));
    let caption = format!(
        "Circular contact, σ = 0.28, no spin; chapter 5 with W = 1, M = 2 for fx and M = 4 for \
         fy, as the thesis shows them. The full theory lies within {:.3} and {:.3} of μN. Below \
         a creepage of 0.3 the curves of 1967 are too low: polynomials of so low a degree cannot \
         show a narrow area of slip. {EXPERIMENTS}",
        apart[0], apart[1]
    );
    Ok(Reproduction::figure(&sheet, caption, data, vec![coincidence(&by_degree)]))
}

/// "The theoretical curves for the degrees M = 2, 3, 4 nearly coincide."
fn coincidence(by_degree: &[[Curve; 2]]) -> Comparison {
    let from = |curve: &Curve| curve.iter().copied().filter(|p| p[0] > 0.399).collect::<Curve>();
    let mut spread: f64 = 0.0;
    for (one, two) in [(0, 1), (0, 2), (1, 2)] {
        for i in 0..2 {
            spread = spread.max(farthest(&from(&by_degree[one][i]), &from(&by_degree[two][i])));
        }
    }
    let ours = format!("within {spread:.3} of μN from a creepage of 0.4 on");
    // What can be told apart in a printed diagram some ten centimetres high.
    Comparison::claim("curves of M = 2, 3, 4", "nearly coincide", ours, spread < 0.05)
}

fn sheet([fx, fy, full_fx, full_fy]: [Curve; 4]) -> Sheet {
    let x = Scale::new([0.0, 3.0], axes::xi_or_eta());
    let y = Scale::new([0.0, 1.05], axes::fx_or_fy());
    let panel = Panel::new(x, y)
        .curve(full_fx, FULL)
        .curve(full_fy, FULL)
        .curve(fx, OF_1967)
        .curve(fy, SECOND);
    let words = |symbol, index, rest| Label::default().indexed(symbol, index).plain(rest);
    Sheet::new(ITEM.title)
        .note(
            Label::default()
                .symbol("a")
                .plain("/")
                .symbol("b")
                .plain(" = 1, ")
                .symbol("σ")
                .plain(" = 0.28, ")
                .symbol("χ")
                .plain(" = 0"),
        )
        .panel(panel)
        .key(OF_1967, words("f", "x", " over ξ, chapter 5, M = 2"))
        .key(SECOND, words("f", "y", " over η, chapter 5, M = 4"))
        .key(FULL, Label::new("full theory"))
}
