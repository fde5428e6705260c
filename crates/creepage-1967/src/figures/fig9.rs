//! Fig. 9: the spin pole of bodies that slide as if rigid, and the traction about it.

use creepage::approximate::saturated::Saturated;
use creepage::{Ellipse, Theory};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig9", "Fig. 9. Contact area with spin pole and traction", make);

const RATIO: f64 = 1.5;
const CREEPAGE: [f64; 3] = [0.45, -0.5, 1.0];
const POLE: Mark = Mark::full(Shape::Diamond, "#b3261e");
const ARROWS: &str = "#d07000";
const HALF: f64 = 0.1;
/// The arrow to which the line from the pole is drawn.
const EXAMPLE: usize = 14;

fn make() -> Result<Reproduction, GalleryError> {
    let ellipse = Ellipse::from_ratio(RATIO)?;
    let theory = Saturated::new(&like_bodies(RATIO, STEEL)?)?;
    let positions = lattice(ellipse);
    let points = theory.field(rolling_at(CREEPAGE), &positions);
    let pole = [-CREEPAGE[1] / CREEPAGE[2], CREEPAGE[0] / CREEPAGE[2]];
    let mut data = Data::new(["x", "y", "traction_x", "traction_y"]);
    let (mut askew, mut above) = (0.0_f64, 0.0_f64);
    let mut panel = panel(ellipse, pole, positions[EXAMPLE]);
    for point in &points {
        let ([x, y], [tx, ty]) = (point.position, point.traction);
        data.push([x, y, tx, ty].map(Into::into));
        let (size, [u, v]) = (tx.hypot(ty), [x - pole[0], y - pole[1]]);
        askew = askew.max((tx * u + ty * v).abs() / (size * u.hypot(v)));
        above = above.max((contact::reduced(ellipse, point) - 1.0).abs());
        let end = |sign: f64| [x + sign * HALF * tx / size, y + sign * HALF * ty / size];
        panel = panel.arrow(end(-1.0), end(1.0), 1.6, ARROWS);
    }
    let agreement = vec![
        Comparison::claim(
            "traction and the line from the spin pole (-cη/χ, cξ/χ), (4.93)",
            "perpendicular",
            format!("cosine below {askew:.0e}"),
            askew < 1e-12,
        ),
        Comparison::claim(
            "size of the traction",
            "μZ everywhere",
            format!("within {above:.0e} of it"),
            above < 1e-12,
        ),
    ];
    let caption = format!(
        "Large creepage and spin: elastic deformation counts no more, and the bodies slide about the spin pole \
         as if rigid. a/b = {RATIO}, ξ = {}, η = {}, χ = {}. The traction is perpendicular to the line from \
         the pole, and as large as friction allows.",
        CREEPAGE[0], CREEPAGE[1], CREEPAGE[2]
    );
    let sheet = Sheet::new(ITEM.title)
        .width(640.0)
        .note(axes::setting(&[("a/b", "1.5"), ("ξ", "0.45"), ("η", "-0.5"), ("χ", "1")]))
        .panel(panel)
        .key(POLE, Label::new("spin pole"))
        .key(Sample::arrow(ARROWS), Label::new("direction of the traction"));
    Ok(Reproduction::figure(&sheet, caption, data, agreement))
}

fn panel(ellipse: Ellipse, pole: [f64; 2], example: [f64; 2]) -> Panel {
    contact::edge(contact::panel(ellipse, Label::default()), ellipse)
        .curve(vec![pole, example], Pen::GUIDE.wide(1.8))
        .marks(vec![pole], POLE)
}

fn lattice(ellipse: Ellipse) -> Vec<[f64; 2]> {
    let mut positions = Vec::new();
    for (radius, count) in [(0.3, 7), (0.58, 13), (0.86, 20)] {
        for k in 0..count {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / f64::from(count)).sin_cos();
            positions.push([radius * ellipse.a() * cos, radius * ellipse.b() * sin]);
        }
    }
    positions
}
