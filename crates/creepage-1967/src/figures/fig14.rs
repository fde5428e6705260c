//! Fig. 14: the force due to pure spin on a circle.

use creepage::Theory;
use creepage::approximate::linear::Linear;
use creepage::variational::Weight;

use crate::prelude::*;

pub(crate) const ITEM: Item = Item::new("fig14", "Fig. 14. Force due to pure spin", make);

const DEGREES: [usize; 3] = [2, 3, 4];
const PENS: [Pen; 3] = [SECOND, OF_1967, THIRD];

fn make() -> Result<Reproduction, GalleryError> {
    let spins = spaced(0.0, 8.0, 160);
    let creepages: Vec<_> = spins.iter().map(|&chi| rolling_at([0.0, 0.0, chi])).collect();
    let mut by_degree = Vec::new();
    for degree in DEGREES {
        let theory = chapter_5(1.0, STEEL, degree, Weight::Elliptic)?;
        by_degree.push(points(&spins[1..], &chained(&theory, &creepages[1..]), |f| f.fy));
    }
    let found = full_solutions(1.0, STEEL, &creepages)?;
    let full: Curve = spins.iter().zip(&found).map(|(chi, found)| [*chi, found.force.fy]).collect();
    let band = band(&spins, &found, |force| force.fy, [0.0, 0.7]);
    let mut data = Data::new(["curve", "chi", "fy"]);
    for (degree, curve) in DEGREES.iter().zip(&by_degree) {
        data.curve(&format!("M = {degree}"), curve);
    }
    data.curve("full theory", &full);
    let apart: Vec<_> = by_degree.iter().map(|curve| farthest(curve, &full[1..])).collect();
    let caption = format!(
        "Circular contact, σ = 0.28, no creepage; chapter 5 with W = W₁. The greatest distance \
         from the full theory is {:.3}, {:.3} and {:.3} of μN for M = 2, 3 and 4. Up to the peak \
         M = 3 and M = 4 are near it; beyond, the lower the degree the more force is lost. \
         {EXPERIMENTS}",
        apart[0], apart[1], apart[2]
    );
    let linear = Linear::new(&like_bodies(1.0, STEEL)?)?;
    let slope = linear.solve(rolling_at([0.0, 0.0, 0.5])).force.fy / 0.5;
    let sheet = sheet(&by_degree, &full, band, slope);
    Ok(Reproduction::figure(&sheet, caption, data, claims(&by_degree, &full)))
}

/// A curve from `chi` to `chi`.
fn between(curve: &Curve, [from, to]: [f64; 2]) -> Curve {
    curve.iter().copied().filter(|p| p[0] > from - 1e-9 && p[0] < to + 1e-9).collect()
}

fn claims(by_degree: &[Curve], full: &Curve) -> Vec<Comparison> {
    let rise = |one: &Curve, two: &Curve, range| {
        let pairs = between(one, range).into_iter().zip(between(two, range));
        pairs
            .map(|(one, two)| one[1] - two[1])
            .fold([1.0_f64, -1.0], |[low, high], rise| [low.min(rise), high.max(rise)])
    };
    let [low, high] = rise(&by_degree[1], &by_degree[2], [0.7, 2.0]);
    let lower = Comparison::claim(
        "M = 4 below M = 3 from χ = 0.7 to 2",
        "somewhat lower",
        format!("lower by up to {high:.3}, nowhere higher by more than {:.4}", (-low).max(0.0)),
        low > -5e-3 && high > 0.02,
    );
    let apart = |from: &[f64; 2], to: &[f64; 2]| (from[1] - to[1]).abs() > 0.02;
    let mut pairs = by_degree[0].iter().zip(&by_degree[1]).filter(|(two, three)| apart(two, three));
    let leaves = pairs.next().map_or(0.0, |(two, _)| two[0]);
    let meets = pairs.next_back().map_or(8.0, |(two, _)| two[0]);
    let same = Comparison::claim(
        "M = 2 where it is not drawn",
        "follows M = 3",
        format!("within 0.02 up to χ = {leaves:.2}, and from {meets:.2} on"),
        leaves > 0.5 && meets < 5.0,
    );
    let [low, high] = rise(full, &by_degree[2], [0.7, 2.0]);
    let not_in_text = Comparison::without_data(
        "M = 4 against experiment from χ = 0.7 to 2",
        "still above the experimental values",
        format!("the full theory is above M = 4 by {low:.3} to {high:.3}"),
        "the method does not explain why the experiments are lower",
    );
    vec![lower, same, not_in_text]
}

fn sheet(by_degree: &[Curve], full: &Curve, band: Curve, slope: f64) -> Sheet {
    let x = Axis::new([0.0, 8.0], axes::chi());
    let y = Axis::new([0.0, 0.7], axes::fy());
    let linear = vec![[0.0, 0.0], [8.0, 8.0 * slope]];
    let mut panel = Panel::new(x, y).area(vec![band], BAND).curve(linear, TANGENT);
    for (degree, (curve, pen)) in DEGREES.iter().zip(by_degree.iter().zip(PENS)) {
        panel = panel.named(curve.clone(), pen, axes::short_degree(*degree));
    }
    Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "1"), ("σ", "0.28"), ("ξ", "0"), ("η", "0")]))
        .panel(panel.named(full.clone(), FULL, Label::new("full theory")))
        .key(TANGENT, Label::new("linear theory"))
        .key(BAND, Label::new("error bars of the full theory"))
}
