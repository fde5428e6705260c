//! Fig. 4: adhesion and slip by Johnson's theory, and where it contradicts itself.

use creepage::Ellipse;
use creepage::approximate::vermeulen_johnson::VermeulenJohnson;
use creepage::{Creepage, FieldPoint, Force, Region, Theory};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig4", "Fig. 4. Areas of adhesion and slip by Johnson", make);

/// Our choice: the thesis states none.
const CREEPAGES: [f64; 2] = [0.5, 1.0];
/// Where slip and traction do not match.
const ERROR: Fill = Fill::plain("#6b4a57");

/// One creepage: the areas by Johnson, where he errs, and the full theory's area of adhesion.
struct Case {
    xi: f64,
    adhesion: Vec<Polygon>,
    error: Vec<Polygon>,
    full: Vec<Polygon>,
}

fn make() -> Result<Reproduction, GalleryError> {
    let theory = VermeulenJohnson::new(&like_bodies(1.0, STEEL)?)?;
    let cases = CREEPAGES.map(|xi| case(&theory, xi));
    let [one, two] = cases;
    let cases = [one?, two?];
    let caption = "Circular contact, σ = 0.28, pure longitudinal creepage. Johnson's area of adhesion is an \
         ellipse similar to the contact and touches its edge at the foremost point. Shaded dark: slip \
         and traction point in opposite directions, against the law of friction. By the full \
         theory (dashed) adhesion reaches all of the leading edge. The creepages are ours: the \
         thesis states none.";
    let mut agreement = directions(&theory);
    agreement.push(lower()?);
    Ok(Reproduction::figure(&sheet(&cases)?, caption, data(&cases), agreement))
}

/// The outlines of the areas.
fn data(cases: &[Case; 2]) -> Data {
    let mut data = Data::new(["area", "xi", "polygon", "x", "y"]);
    for case in cases {
        for (name, polygons) in [
            ("adhesion, Johnson", &case.adhesion),
            ("error, Johnson", &case.error),
            ("adhesion, full theory", &case.full),
        ] {
            for (k, polygon) in polygons.iter().enumerate() {
                data.points(name, &[case.xi, k as f64], polygon);
            }
        }
    }
    data
}

fn at(xi: f64) -> Creepage {
    rolling_at([xi, 0.0, 0.0])
}

/// Traction times slip.
fn work(point: &FieldPoint) -> f64 {
    point.traction[0] * point.slip[0] + point.traction[1] * point.slip[1]
}

fn case(theory: &VermeulenJohnson, xi: f64) -> Result<Case, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let wrong = |points: &[[f64; 2]]| {
        theory.field(at(xi), points).iter().map(|point| work(point) < 0.0).collect()
    };
    Ok(Case {
        xi,
        adhesion: contact::adhesion(circle, &contact::of(theory, at(xi))).0,
        error: contact::traced(circle, wrong).0,
        full: contact::full_adhesion(1.0, STEEL, at(xi))?.0,
    })
}

/// Angles between slip and traction over the area of slip: opposite in the area of error, small
/// elsewhere.
fn directions(theory: &VermeulenJohnson) -> Vec<Comparison> {
    let (mut wrong, mut right) = (Vec::new(), Vec::new());
    let places: Vec<_> = spaced(-0.99, 0.99, 99)
        .iter()
        .flat_map(|x| spaced(-0.99, 0.99, 99).into_iter().map(|y| [*x, y]))
        .filter(|[x, y]| x.hypot(*y) < 0.995)
        .collect();
    for point in theory.field(at(CREEPAGES[0]), &places) {
        let size = point.traction[0].hypot(point.traction[1]) * point.slip[0].hypot(point.slip[1]);
        if point.region == Region::Slip && size > 0.0 {
            let angle = (work(&point) / size).clamp(-1.0, 1.0).acos().to_degrees();
            if angle > 90.0 { wrong.push(angle) } else { right.push(angle) }
        }
    }
    let mean = |angles: &[f64]| angles.iter().sum::<f64>() / angles.len() as f64;
    let (opposite, small) = (mean(&wrong), mean(&right));
    vec![
        Comparison::claim(
            "slip against traction in the shaded area",
            "almost opposite",
            format!("{opposite:.0}° apart on average"),
            opposite > 150.0,
        ),
        Comparison::claim(
            "slip against traction in the rest of the slip area",
            "a small angle",
            format!("{small:.1}° on average"),
            small < 15.0,
        ),
    ]
}

/// "The theoretical value of the creepage at a certain force is lower; at most 25 %."
fn lower() -> Result<Comparison, GalleryError> {
    let theory = VermeulenJohnson::new(&like_bodies(1.0, STEEL)?)?;
    let (mut least, mut most): (f64, f64) = (1.0, -1.0);
    let creepages: [fn(f64) -> Creepage; 2] = [at, |eta| rolling_at([0.0, eta, 0.0])];
    let components: [fn(&Force) -> f64; 2] = [|force| force.fx, |force| force.fy];
    for (creepage, of) in creepages.into_iter().zip(components) {
        let sizes = spaced(0.02, 2.4, 119);
        let creepages: Vec<_> = sizes.iter().map(|size| creepage(*size)).collect();
        for (size, force) in sizes.iter().zip(full(1.0, STEEL, &creepages)?) {
            if (0.05..=0.95).contains(&of(&force)) {
                let johnson = inverse(|size| of(&theory.solve(creepage(size)).force), of(&force));
                least = least.min(1.0 - johnson / size);
                most = most.max(1.0 - johnson / size);
            }
        }
    }
    let ours = format!(
        "lower by {:.0} to {:.0} % than by the full theory, f from 0.05 to 0.95",
        100.0 * least,
        100.0 * most
    );
    let holds = least > -0.02 && most < 0.25;
    Ok(Comparison::claim(
        "creepage by Johnson at equal force",
        "lower, by at most 25 %",
        ours,
        holds,
    )
    .remark("the thesis compares with experiment"))
}

/// Where a growing function reaches a value, by bisection.
fn inverse(function: impl Fn(f64) -> f64, value: f64) -> f64 {
    let (mut low, mut high) = (0.0, 4.0);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if function(middle) < value {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

fn sheet(cases: &[Case; 2]) -> Result<Sheet, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let mut sheet = Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "1"), ("σ", "0.28"), ("η", "0"), ("χ", "0")]))
        .columns(2);
    for case in cases {
        let heading = Label::default().symbol("ξ").plain(&format!(" = {:.1}", case.xi));
        let panel = contact::areas(contact::panel(circle, heading), circle, &case.adhesion);
        let panel = panel.area(case.error.clone(), ERROR);
        sheet = sheet.panel(contact::edge(panel.outlines(&case.full, FULL), circle));
    }
    Ok(sheet
        .key(Fill::ADHESION, Label::new("adhesion, Johnson"))
        .key(Fill::SLIP, Label::new("slip, Johnson"))
        .key(ERROR, Label::new("slip against traction"))
        .key(FULL, Label::new("adhesion, full theory")))
}
