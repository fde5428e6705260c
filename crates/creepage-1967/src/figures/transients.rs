//! Proposition IV, 3: transients at constant force die out within one to two contact widths.

use creepage::coulomb::Resolution;
use creepage::unsteady::{Motion, Rolling};
use rayon::prelude::*;

use super::rolling_on;
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("iv-3-transients", "Proposition IV, 3. Transients at constant force die out", make);

const FORCE: f64 = 0.64;
/// Contact widths rolled; in the last of them what there is counts as steady.
const WIDTHS: usize = 3;
/// Steps a contact width.
const STEPS_PER_WIDTH: usize = 24;

/// A contact and the direction of its force: `None` for cylinders.
struct Case {
    name: &'static str,
    a_over_b: Option<f64>,
    lateral: bool,
    pen: Pen,
}

const CASES: [Case; 5] = [
    Case { name: "cylinders", a_over_b: None, lateral: false, pen: OF_1967 },
    Case { name: "circle, along", a_over_b: Some(1.0), lateral: false, pen: FULL },
    Case { name: "circle, across", a_over_b: Some(1.0), lateral: true, pen: SECOND },
    Case { name: "a/b = 0.5, along", a_over_b: Some(0.5), lateral: false, pen: THIRD },
    Case { name: "a/b = 2, along", a_over_b: Some(2.0), lateral: false, pen: TANGENT.wide(2.4) },
];

/// Creepage over the steady one, over contact widths rolled.
fn transient(case: &Case) -> Result<Curve, GalleryError> {
    let [fx, fy] = if case.lateral { [0.0, FORCE] } else { [FORCE, 0.0] };
    let (mut rolling, a) = match case.a_over_b {
        None => (rolling_on::shifted(FORCE)?, 1.0),
        Some(ratio) => {
            let mut rolling = Rolling::new(&like_bodies(ratio, STEEL)?, Resolution::STANDARD)?;
            rolling.shift(fx, fy)?;
            (rolling, ratio.sqrt())
        }
    };
    let step = 2.0 * a / STEPS_PER_WIDTH as f64;
    let mut curve = Curve::new();
    for _ in 0..WIDTHS * STEPS_PER_WIDTH {
        let rolled = rolling.step(step, &Motion::forces(fx, fy))?;
        let creepage = if case.lateral { rolled.creepage.eta() } else { rolled.creepage.xi() };
        curve.push([rolled.distance / (2.0 * a), creepage]);
    }
    let end = &curve[(WIDTHS - 1) * STEPS_PER_WIDTH..];
    let steady = end.iter().map(|point| point[1]).sum::<f64>() / end.len() as f64;
    Ok(curve.into_iter().map(|[q, creepage]| [q, creepage / steady]).collect())
}

/// The largest part of the steady creepage that is missing, or too much, from some width on.
fn left(curve: &Curve, from: usize) -> f64 {
    let off = curve[from * STEPS_PER_WIDTH..].iter().map(|point| (point[1] - 1.0).abs());
    100.0 * off.fold(0.0, f64::max)
}

fn make() -> Result<Reproduction, GalleryError> {
    let curves = CASES.par_iter().map(transient).collect::<Result<Vec<_>, _>>()?;
    let mut data = Data::new(["contact", "contact widths rolled", "creepage over the steady one"]);
    let mut agreement = Vec::new();
    for (case, curve) in CASES.iter().zip(&curves) {
        data.curve(case.name, curve);
        let [one, two] = [1, 2].map(|width| left(curve, width));
        let claim = Comparison::claim(
            format!("transient of the creepage at constant force, {}", case.name),
            "almost died out after 1 to 2 contact widths",
            format!("{one:.1} % of the creepage are left after one, {two:.1} % after two"),
            // Small beside what creepage changes by, and beside what a test rig can tell.
            one < 5.0 && two < 1.0,
        );
        let line = claim.because("more is left than a measurement would miss");
        agreement.push(if case.a_over_b.is_none() {
            line
        } else {
            line.remark("the thesis speaks of cylinders alone")
        });
    }
    let caption = format!(
        "Creepage over its steady value, over the distance rolled in contact widths 2a: bodies that were \
         shifted by a force of {FORCE} μN and then roll under it. Full theory; cylinders, a circle with \
         the force along and across the rolling direction, and two ellipses, σ = 0.28. The peak is \
         where the last of the material that was in the contact while it was shifted slips. Ripples of a hundredth are the \
         border’s way from element to element. The thesis has the statement alone, of cylinders."
    );
    Ok(Reproduction::figure(&sheet(&curves), caption, data, agreement))
}

fn sheet(curves: &[Curve]) -> Sheet {
    let x = Label::new("distance rolled in contact widths, ").symbol("q").plain("/2").symbol("a");
    let y = Label::new("creepage over the steady one");
    let mut panel = Panel::new(Axis::new([0.0, WIDTHS as f64], x), Axis::new([0.4, 1.3], y))
        .height(380.0)
        .curve(vec![[0.0, 1.0], [WIDTHS as f64, 1.0]], Pen::GUIDE);
    let mut sheet = Sheet::new(ITEM.title);
    for (case, curve) in CASES.iter().zip(curves) {
        panel = panel.curve(curve.clone(), case.pen);
        sheet = sheet.key(case.pen, Label::new(case.name));
    }
    sheet.panel(panel)
}
