//! Fig. 16: areas, tractions and slip in longitudinal creepage, beside strip theory.

use creepage::Ellipse;
use creepage::approximate::strip::StripTheory;
use creepage::variational::Weight;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig16", "Fig. 16. Areas and tractions in longitudinal creepage", make);

const POISSON: f64 = 0.5;
const CREEPAGE: [f64; 3] = [0.9, 0.0, 0.0];
/// Lines along the rolling direction.
const LINES: [f64; 3] = [0.0, 0.4, 0.8];

/// What a theory says.
struct View {
    name: &'static str,
    pen: Pen,
    adhesion: Vec<Polygon>,
    /// `|(X, Y)|` on [`LINES`].
    tractions: [Curve; 3],
    /// The slip `P` on the `x`-axis, in units of `mu f00`.
    slip: Curve,
}

impl View {
    fn new(
        name: &'static str,
        pen: Pen,
        field: &Field,
        slip_unit: f64,
    ) -> Result<Self, GalleryError> {
        let circle = Ellipse::from_ratio(1.0)?;
        let points = LINES.map(|y| field(&along(y)));
        let size = |t: [f64; 2]| t[0].hypot(t[1]);
        let tractions = points.each_ref().map(|points| {
            points.iter().map(|point| [point.position[0], size(point.traction)]).collect()
        });
        let slip = points[0].iter().map(|point| [point.position[0], slip_unit * point.slip[0]]);
        let (slip, adhesion) = (slip.collect(), contact::adhesion(circle, field).0);
        Ok(Self { name, pen, adhesion, tractions, slip })
    }

    /// The separatrix as `x` over `y`.
    fn edge_of_slip(&self, y: f64) -> f64 {
        let points = self.adhesion.iter().flatten().filter(|point| (point[1] - y).abs() < 0.02);
        points.map(|point| point[0]).fold(f64::INFINITY, f64::min)
    }
}

fn along(y: f64) -> Vec<[f64; 2]> {
    let end = 0.9995 * (1.0 - y * y).sqrt();
    spaced(-end, end, 160).into_iter().map(|x| [x, y]).collect()
}

fn make() -> Result<Reproduction, GalleryError> {
    let theory = chapter_5(1.0, POISSON, 3, Weight::Elliptic)?;
    let (strips, detailed) =
        (StripTheory::new(&like_bodies(1.0, POISSON)?), contact::detailed(1.0, POISSON)?);
    let unit = theory.slip_scale();
    let views = [
        View::new("M = 3", OF_1967, &contact::chapter_5(&theory, rolling_at(CREEPAGE)), unit)?,
        View::new("strip theory", SECOND, &contact::of(&strips, rolling_at(CREEPAGE)), unit)?,
        View::new("full theory", FULL, &contact::full(&detailed, rolling_at(CREEPAGE)), unit)?,
    ];
    let mut data = Data::new(["curve", "x", "y"]);
    for view in &views {
        for (y, curve) in LINES.iter().zip(&view.tractions) {
            data.curve(&format!("traction on y = {y}, {}", view.name), curve);
        }
        data.curve(&format!("P on y = 0, {}", view.name), &view.slip);
        for line in contact::separatrix(Ellipse::from_ratio(1.0)?, &view.adhesion) {
            data.curve(&format!("separatrix, {}", view.name), &line);
        }
    }
    let agreement = agreement(&views);
    Ok(Reproduction::figure(&sheet(&views)?, caption(&views), data, agreement))
}

/// The root of the mean square distance of two curves.
fn apart(one: &Curve, two: &Curve) -> f64 {
    let squares = one.iter().zip(two).map(|(p, q)| (p[1] - q[1]).powi(2));
    (squares.sum::<f64>() / one.len() as f64).sqrt()
}

fn caption(views: &[View; 3]) -> String {
    let off = |k: usize| apart(&views[0].tractions[k], &views[2].tractions[k]);
    format!(
        "Circular contact, σ = 0.5; chapter 5 with M = 3, W = W₁, its separatrix T = S. Above, the \
         areas by chapter 5 and by the full theory, in both the separatrix of Haines's and \
         Ollerton's strip theory. Below, the traction over its largest bound on three lines, and \
         the slip P in units of μf₀₀. The root mean square distance of chapter 5 from the full \
         theory is {:.3}, {:.3} and {:.3} on the three lines. Haines and Ollerton found their \
         stresses by strip theory and by photoelasticity. {EXPERIMENTS}",
        off(0),
        off(1),
        off(2)
    )
}

fn agreement(views: &[View; 3]) -> Vec<Comparison> {
    let [of_1967, strips, today] = views;
    let ys = spaced(-0.8, 0.8, 40);
    let shift = |one: &View, two: &View| {
        let apart = |y: &f64| (one.edge_of_slip(*y) - two.edge_of_slip(*y)).abs();
        ys.iter().map(apart).fold(0.0, f64::max)
    };
    let off = |k: usize| apart(&of_1967.tractions[k], &strips.tractions[k]);
    let shares = [0, 1, 2].map(|k| off(k) / (1.0 - LINES[k] * LINES[k]).sqrt());
    vec![
        Comparison::claim(
            "separatrix of chapter 5 and of strip theory",
            "quite close",
            format!("within {:.2} a of each other along x", shift(of_1967, strips)),
            // A tenth of the contact's length.
            shift(of_1967, strips) < 0.2,
        )
        .remark(&format!("full theory within {:.2} a of strip theory", shift(today, strips))),
        Comparison::claim(
            "traction of chapter 5 and of strip theory",
            "best for y = 0, worst for y = 0.80",
            format!(
                "apart by {:.3}, {:.3}, {:.3} of the line's largest bound on y = 0, 0.4, 0.8",
                shares[0], shares[1], shares[2]
            ),
            shares[0] < shares[1] && shares[1] < shares[2],
        ),
        slip(of_1967),
    ]
}

/// "It rises sharply in the slip zone, and winds itself about zero in the adhesion zone."
fn slip(view: &View) -> Comparison {
    let edge = view.edge_of_slip(0.0);
    let (stuck, sliding): (Curve, Curve) = view.slip.iter().partition(|point| point[0] > edge);
    let largest = |curve: &Curve| curve.iter().map(|point| point[1].abs()).fold(0.0, f64::max);
    let crossings = stuck.windows(2).filter(|pair| pair[0][1] * pair[1][1] < 0.0).count();
    let ours = format!(
        "to {:.2} where it slips; {crossings} zeros and at most {:.2} where it adheres",
        largest(&sliding),
        largest(&stuck)
    );
    let holds = crossings > 1 && largest(&sliding) > 3.0 * largest(&stuck);
    let printed = "rises sharply in slip, winds about zero in adhesion";
    Comparison::claim("slip P of chapter 5 on y = 0", printed, ours, holds)
}

fn sheet(views: &[View; 3]) -> Result<Sheet, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let settings = [("a/b", "1"), ("σ", "0.5"), ("ξ", "0.9"), ("η", "0"), ("χ", "0")];
    let mut sheet = Sheet::new(ITEM.title).note(axes::setting(&settings)).columns(2);
    let strips = contact::separatrix(circle, &views[1].adhesion);
    for (view, heading) in [(&views[0], axes::degree(3)), (&views[2], Label::new("full theory"))] {
        let panel = contact::panel(circle, heading);
        let adhesion = contact::smooth_area(&view.adhesion);
        let panel = contact::edge(contact::areas(panel, circle, &adhesion), circle);
        sheet = sheet.panel(panel.curves(&strips, SECOND));
    }
    for k in 0..LINES.len() {
        sheet = sheet.panel(tractions(views, k));
    }
    Ok(sheet
        .panel(slips(views))
        .key(OF_1967, axes::degree(3))
        .key(SECOND, Label::new("strip theory"))
        .key(FULL, Label::new("full theory"))
        .key(Pen::GUIDE, Label::new("Coulomb’s bound"))
        .key(Fill::ADHESION, Label::new("adhesion"))
        .key(Fill::SLIP, Label::new("slip")))
}

fn over_a() -> Axis {
    Axis::new([-1.0, 1.0], Label::default().symbol("x").plain("/").symbol("a"))
}

fn tractions(views: &[View; 3], k: usize) -> Panel {
    let heading = Label::default().symbol("y").plain("/").symbol("a").plain(" = ");
    let y = Axis::new(
        [0.0, 1.05],
        Label::new("|(").symbol("X").plain(", ").symbol("Y").plain(")|/").indexed("μp", "0"),
    );
    let bound = |[x, y]: [f64; 2]| [x, (1.0 - x * x - y * y).max(0.0).sqrt()];
    let bound = along(LINES[k]).into_iter().map(bound).collect();
    let panel =
        Panel::new(over_a(), y).height(210.0).heading(heading.number(&LINES[k].to_string()));
    let panel = panel.curve(bound, Pen::GUIDE);
    [1, 2, 0]
        .into_iter()
        .fold(panel, |panel, i| panel.curve(views[i].tractions[k].clone(), views[i].pen))
}

fn slips(views: &[View; 3]) -> Panel {
    let y =
        Axis::new([-0.2, 1.2], Label::new("slip ").symbol("P").plain(" over ").indexed("μf", "00"));
    let heading = Label::default().symbol("y").plain("/").symbol("a").plain(" = 0");
    let panel = Panel::new(over_a(), y).height(210.0).heading(heading);
    // Strip theory's slip is that of a plane: of another kind than the others'.
    [2, 0].into_iter().fold(panel, |panel, i| panel.curve(views[i].slip.clone(), views[i].pen))
}
