//! Fig. 7: a point beside the edge of the contact; the slip there, and its angle with the traction.

use std::f64::consts::TAU;

use creepage::Ellipse;
use creepage::halfspace::{DisplacementField, Edge, Polynomial, Traction};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig7", "Fig. 7. The edge of the contact, and slip beside a singular edge", make);

const RATIO: f64 = 1.6;
/// What the thesis prints of (4.45): Poisson's ratio, the least cosine, the angle (degrees).
const PRINTED: [(f64, &str, &str); 2] = [(0.25, "0.987", "9"), (0.5, "0.941", "20")];
/// The strength of the singularity in the picture.
const STRENGTH: [f64; 2] = [1.0, 0.35];
const SLIP: &str = "#1565c0";
const TRACTION: &str = "#d07000";

/// The unit inner normal at `(a cos t, b sin t)`.
fn normal(ellipse: Ellipse, t: f64) -> [f64; 2] {
    let (x, y) = (-t.cos() / ellipse.a(), -t.sin() / ellipse.b());
    [x / x.hypot(y), y / x.hypot(y)]
}

/// The slip of (4.41) times `G B sqrt(u')/2`.
fn slip(poisson: f64, [cos, sin]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    let along = x * cos + y * sin;
    [cos * (x - poisson * along * cos), cos * (y - poisson * along * sin)]
}

/// The angle (degrees) between slip and traction by (4.45), at the trailing edge.
fn angle(poisson: f64, d: f64) -> f64 {
    let cosine = (1.0 - poisson * d) / (1.0 - poisson * (2.0 - poisson) * d).sqrt();
    cosine.min(1.0).acos().to_degrees()
}

fn make() -> Result<Reproduction, GalleryError> {
    let mut data = Data::new(["curve", "poisson", "D", "angle_deg"]);
    let mut agreement = Vec::new();
    let mut curves = Vec::new();
    for (poisson, cosine, degrees) in PRINTED {
        let curve: Curve =
            spaced(0.0, 1.0, 400).into_iter().map(|d| [d, angle(poisson, d)]).collect();
        data.points("angle between slip and traction", &[poisson], &curve);
        let largest = curve.iter().map(|point| point[1]).fold(0.0, f64::max);
        let closed = 2.0 * (1.0 - poisson).sqrt() / (2.0 - poisson);
        let reason = format!(
            "the minimum of (4.45) is 2 sqrt(1 - σ)/(2 - σ) = {closed:.4}, whose angle is {:.1}°",
            closed.acos().to_degrees()
        );
        let least = largest.to_radians().cos();
        let names =
            [format!("least |cos θ|, σ = {poisson}"), format!("its angle [deg], σ = {poisson}")];
        let [of_cosine, of_angle] = names;
        agreement.push(Comparison::number(of_cosine, cosine, least).misprint(&reason));
        agreement.push(Comparison::number(of_angle, degrees, largest).misprint(&reason));
        curves.push((poisson, curve));
    }
    agreement.push(slip_of_the_half_space()?);
    let caption = "Above left: the point (x', y') of the surface at the distance u' from the edge, and the axes \
        u, v of the thesis. Right: a traction that is singular all around (orange, on its edge), and the slip \
        that it causes outside (4.41), blue, σ = 0.5. The slip is nearly along the traction at the \
        trailing edge and nearly against it at the leading edge. There the singularity must therefore vanish. Below: the angle \
        between both by (4.45), over D, the square of the cosine between traction and normal.";
    Ok(Reproduction::figure(&sheet(&curves)?, caption, data, agreement))
}

/// (4.41) beside the half-space's own answer, all around an ellipse.
fn slip_of_the_half_space() -> Result<Comparison, GalleryError> {
    /// Over the smaller semi-axis; the relative error of the asymptote is of its root.
    const DISTANCE: f64 = 1e-6;
    const DIFFERENCE_STEP: f64 = 1e-8;
    let (ellipse, poisson) = (Ellipse::from_ratio(RATIO)?, 0.28);
    let constant = |value: f64| Polynomial::new(vec![value]);
    let (x, y) = (constant(STRENGTH[0]), constant(STRENGTH[1]));
    let (x, y, zero) = (x?, y?, Polynomial::zero(0));
    let traction = Traction::new(ellipse, Edge::Singular, [&x, &y, &zero])?;
    let field = DisplacementField::new(&traction, poisson, 0.0)?;
    let mut worst = 0.0_f64;
    for k in 0..24 {
        let t = TAU * (f64::from(k) + 0.5) / 24.0;
        let inner = normal(ellipse, t);
        let (sin, cos) = t.sin_cos();
        let at = [0, 1].map(|i| [ellipse.a() * cos, ellipse.b() * sin][i] - DISTANCE * inner[i]);
        let [before, after] =
            [-DIFFERENCE_STEP, DIFFERENCE_STEP].map(|step| field.at([at[0] + step, at[1]]));
        let found = [0, 1].map(|i| (after[i] - before[i]) / (2.0 * DIFFERENCE_STEP));
        // B^2 is twice the size of the gradient of r^2/2.
        let b = (2.0 * (cos / ellipse.a()).hypot(sin / ellipse.b())).sqrt();
        let by_4_41 = slip(poisson, inner, STRENGTH).map(|part| 2.0 * part / (b * DISTANCE.sqrt()));
        let off = (found[0] - by_4_41[0]).hypot(found[1] - by_4_41[1]);
        worst = worst.max(off / by_4_41[0].hypot(by_4_41[1]));
    }
    Ok(Comparison::claim(
        format!("slip at 1e-6 of the semi-axis from the edge, all around, a/b = {RATIO}"),
        "(4.41)",
        format!("within {worst:.1e} of the half-space's own"),
        worst < 0.01,
    )
    .remark("the bounded part left out in (4.41) is of the order of the root of the distance"))
}

fn sheet(curves: &[(f64, Curve)]) -> Result<Sheet, GalleryError> {
    let ellipse = Ellipse::from_ratio(RATIO)?;
    let angles = {
        let x = Axis::new([0.0, 1.0], Label::default().symbol("D"));
        let y = Axis::new([0.0, 22.0], Label::default().symbol("θ").plain(" [°]"));
        let panel = Panel::new(x, y).height(210.0).heading(Label::new("(4.45)"));
        curves.iter().enumerate().fold(panel, |panel, (k, (poisson, curve))| {
            let name = Label::default().symbol("σ").plain(&format!(" = {poisson}"));
            let top =
                curve.iter().copied().fold([0.0, 0.0], |m, p| if p[1] > m[1] { p } else { m });
            panel.curve(curve.clone(), Pen::of(k)).text(
                [top[0] - 0.25, top[1] + 0.6],
                Anchor::Start,
                name,
            )
        })
    };
    Ok(Sheet::new(ITEM.title)
        .columns(2)
        .panel(geometry(ellipse))
        .panel(directions(ellipse))
        .panel(angles)
        .key(Sample::arrow(TRACTION), Label::new("traction, as its strength"))
        .key(Sample::arrow(SLIP), Label::new("slip outside, σ = 0.5")))
}

/// A frame around the ellipse with its surroundings.
fn frame(ellipse: Ellipse, heading: &str) -> Panel {
    // y points down, as seen from above on the lower body.
    let (x, y) = (ellipse.a() + 0.62, ellipse.b() + 0.7);
    Panel::new(Axis::new([-x, x], Label::default()), Axis::new([y, -y], Label::default()))
        .to_scale()
        .bare()
        .heading(Label::new(heading))
        .outlines(&[contact::outline(ellipse)], Pen::OUTLINE)
}

fn geometry(ellipse: Ellipse) -> Panel {
    let t = 2.5_f64;
    let [cos, sin] = normal(ellipse, t);
    let foot = [ellipse.a() * t.cos(), ellipse.b() * t.sin()];
    let along = |length: f64| [foot[0] + length * cos, foot[1] + length * sin];
    let across = |length: f64| [foot[0] - length * sin, foot[1] + length * cos];
    let point = along(-0.42);
    frame(ellipse, "the edge")
        .curve(vec![[-1.15 * ellipse.a(), 0.0], [1.15 * ellipse.a(), 0.0]], Pen::GUIDE)
        .curve(vec![point, foot], Pen::THIN)
        .arrow(foot, along(0.55), 1.6, "#10243a")
        .arrow(foot, across(0.55), 1.6, "#10243a")
        .marks(vec![point], Mark::full(Shape::Circle, "#b3261e"))
        .text(along(0.62), Anchor::Start, Label::default().symbol("u"))
        .text(across(0.72), Anchor::Start, Label::default().symbol("v"))
        .text([point[0] - 0.08, point[1] + 0.06], Anchor::End, Label::default().symbol("x′, y′"))
        .text([1.18 * ellipse.a(), 0.04], Anchor::Start, Label::default().symbol("x"))
}

fn directions(ellipse: Ellipse) -> Panel {
    const HALF: f64 = 0.17;
    let size = STRENGTH[0].hypot(STRENGTH[1]);
    let traction = STRENGTH.map(|part| HALF * part / size);
    (0..16).fold(frame(ellipse, "traction and slip"), |panel, k| {
        let t = TAU * (f64::from(k) + 0.5) / 16.0;
        let inner = normal(ellipse, t);
        let edge = [ellipse.a() * t.cos(), ellipse.b() * t.sin()];
        let outside = [0, 1].map(|i| edge[i] - 0.36 * inner[i]);
        let slip = slip(0.5, inner, STRENGTH);
        let length = slip[0].hypot(slip[1]).max(f64::MIN_POSITIVE);
        let slip = slip.map(|part| HALF * part / length);
        let arrow = |panel: Panel, at: [f64; 2], half: [f64; 2], ink| {
            let end = |sign: f64| [0, 1].map(|i| at[i] + sign * half[i]);
            panel.arrow(end(-1.0), end(1.0), 1.6, ink)
        };
        arrow(arrow(panel, edge, traction, TRACTION), outside, slip, SLIP)
    })
}
