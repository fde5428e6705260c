//! Fig. 12: a page of the output of the programme of 1967.

use crate::page::{Page, PageStyle};
use creepage::Ellipse;
use creepage::variational::{Chain, Procedure, Settings, Variational, VariationalSolution};
use creepage::{Creepage, Region};

use super::printed_page::{Number, PrintedPage};
use crate::prelude::*;

pub(crate) const ITEM: Item = Item::new("fig12", "Fig. 12. A page of the output of 1967", make);

const A_OVER_B: f64 = 0.5;
const SPIN: f64 = 2.0;
/// Direction of the creepage (degrees).
const ALPHA: f64 = -30.0;
/// The chain of cases that leads to the page: found by trial, the thesis has the last only.
const CHAIN: [f64; 3] = [2.5, 2.0, 1.7];

fn make() -> Result<Reproduction, GalleryError> {
    let theory = Variational::new(&like_bodies(A_OVER_B, STEEL)?, Settings::default())?;
    let (creepage, found, text) = page(&theory)?;
    let numbers = PrintedPage::read()?.beside(&text);
    let mut data = Data::new(["list", "line", "place", "printed", "ours", "agrees"]);
    for number in &numbers {
        let agrees = if number.agrees() { "yes" } else { "no" };
        let [line, place] = [number.line, number.place].map(|count| (count + 1).to_string());
        data.push([
            (&number.list).into(),
            (&line).into(),
            (&place).into(),
            number.printed.into(),
            number.ours.into(),
            agrees.into(),
        ]);
    }
    let (full, share) = contact::full_adhesion(A_OVER_B, STEEL, creepage)?;
    let caption = format!(
        "The last page of a chain of three cases, creepages 2.5, 2.0 and 1.7, in the formats of \
         the Telefunken TR4. The thesis shows this page only, and its iteration is that of this \
         chain. a/b = 0.5, σ = 0.28, M = 3, W = W₁, 80 points. The picture shows the page's \
         points; the full theory's area of adhesion is {:.0} % of the contact, by the count of \
         points it is {:.0} %.",
        100.0 * share,
        100.0 * adhering(&found)
    );
    let sheet = sheet(&theory, creepage, &found, &full)?.panel(course(&numbers));
    let agreement = agreement(&numbers);
    let figure = Reproduction::figure(&sheet, caption, data, agreement);
    Ok(Reproduction { text: Some(text.trim_end().to_owned()), ..figure })
}

/// The last case of the chain, and its page.
fn page(theory: &Variational) -> Result<(Creepage, VariationalSolution, String), GalleryError> {
    let mut chain = Chain::new(theory, Procedure::OF_1967);
    let (sin, cos) = ALPHA.to_radians().sin_cos();
    let mut steps = Vec::new();
    let at = |size: f64| Creepage::new(size * cos, size * sin, SPIN);
    for size in &CHAIN[..2] {
        chain.solve(at(*size)?, None);
    }
    let creepage = at(CHAIN[2])?;
    let found = chain.solve(creepage, Some(&mut steps)).found;
    let page = Page {
        theory,
        loops: [SPIN, CHAIN[2], ALPHA],
        creepage,
        steps: &steps,
        found: &found,
        mesh: [10, 10],
        lines: &[-0.5, 0.5],
    };
    let text = page.text(PageStyle::Of1967);
    Ok((creepage, found, text))
}

fn adhering(found: &VariationalSolution) -> f64 {
    let adhering = found.points.iter().filter(|point| point.field.region == Region::Adhesion);
    adhering.count() as f64 / found.points.len() as f64
}

/// All numbers in one line, and each that is wrong in one of its own.
fn agreement(numbers: &[Number]) -> Vec<Comparison> {
    let wrong: Vec<_> = numbers.iter().filter(|number| !number.agrees()).collect();
    let ours = format!("{} of {} numbers", numbers.len() - wrong.len(), numbers.len());
    let all = Comparison::claim("all numbers of the page", "as printed", ours, wrong.is_empty());
    let mut lines = vec![all.misprint("those that differ follow")];
    for number in wrong {
        let place = (number.line + 1, number.place + 1);
        let quantity = format!("{} line {}, number {}", number.list, place.0, place.1);
        let right = number.is_known_slip();
        lines.push(Comparison {
            quantity,
            printed: number.printed.to_string(),
            ours: format!("{:.9}", number.ours),
            difference: Some(number.ours - number.printed),
            verdict: if right { Verdict::Misprint } else { Verdict::NotReproduced },
            note: "an error of the print or of the scan: the printed TAU gives our number".into(),
        });
    }
    lines
}

const SLIDING: Mark = Mark { size: 2.2, ..Mark::full(Shape::Circle, "#17212b") };
const STICKING: Mark = Mark { size: 3.4, ..Mark::full(Shape::Square, "#17212b") };
const ABERRATION: Mark = Mark { size: 5.0, ..Mark::open(Shape::Cross, "#17212b") };

fn sheet(
    theory: &Variational,
    creepage: Creepage,
    found: &VariationalSolution,
    full: &[Polygon],
) -> Result<Sheet, GalleryError> {
    let ellipse = Ellipse::from_ratio(A_OVER_B)?;
    let adheres = |points: &[[f64; 2]]| {
        let points = theory.points(creepage, &found.tau, points);
        points.iter().map(|point| point.field.region == Region::Adhesion).collect()
    };
    let (chapter_5, _) = contact::traced(ellipse, adheres);
    let all = contact::areas(contact::panel(ellipse, Label::default()), ellipse, &chapter_5);
    let all = contact::edge(all.outlines(full, FULL), ellipse);
    let all = marked(all, found);
    let parts = [("a/b", "0.5"), ("σ", "0.28"), ("υ", "1.7"), ("α", "-30°"), ("χ", "2")];
    Ok(Sheet::new(ITEM.title)
        .note(axes::setting(&parts))
        .columns(2)
        .panel(all)
        .key(SLIDING, Label::new("slip: . on the page"))
        .key(STICKING, Label::new("adhesion: H"))
        .key(ABERRATION, Label::new("aberration: A"))
        .key(Fill::ADHESION, Label::new("adhesion, ").symbol("T").plain(" > ").symbol("S"))
        .key(Fill::SLIP, Label::new("slip, ").symbol("T").plain(" < ").symbol("S"))
        .key(FULL, Label::new("adhesion, full theory"))
        .key(OF_1967, Label::new("ours"))
        .key(PRINTED, Label::new("printed")))
}

/// The largest change of an unknown in each step of the iteration, as printed and as computed.
fn course(numbers: &[Number]) -> Panel {
    let steps = |of: fn(&Number) -> f64| {
        let changes = numbers.iter().filter(|n| n.list == "TOEG GEV" && n.place == 1);
        changes.map(|n| [n.line as f64 + 1.0, of(n).log10()]).collect::<Vec<_>>()
    };
    let x = Axis::new([0.7, 4.3], Label::new("iteration"));
    let x = x.ticks([1, 2, 3, 4].map(|step| (f64::from(step), step.to_string())).to_vec());
    let y = Axis::new([-4.4, 0.4], Label::new("largest change of a coefficient"));
    let powers = [(-4.0, "0.0001"), (-3.0, "0.001"), (-2.0, "0.01"), (-1.0, "0.1"), (0.0, "1")];
    let y = y.ticks(powers.map(|(power, text)| (power, text.into())).to_vec());
    Panel::new(x, y)
        .curve(steps(|number| number.ours), OF_1967)
        .marks(steps(|number| number.printed), PRINTED)
        .height(330.0)
}

/// The points of the mesh as the page has them.
fn marked(panel: Panel, found: &VariationalSolution) -> Panel {
    let places = |kind: fn(Region, bool) -> bool| {
        let points = found.points.iter();
        let points = points.filter(|point| kind(point.field.region, point.aberrant));
        points.map(|point| point.field.position).collect()
    };
    panel
        .marks(places(|region, _| region == Region::Slip), SLIDING)
        .marks(places(|region, aberrant| region == Region::Adhesion && !aberrant), STICKING)
        .marks(places(|_, aberrant| aberrant), ABERRATION)
}
