//! Fig. 20: areas of adhesion in pure spin, and traction and slip on the axis.

use std::f64::consts::FRAC_PI_4;

use creepage::Ellipse;
use creepage::variational::{Start, Variational, Weight};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig20", "Fig. 20. Areas of adhesion and slip in pure spin", make);

/// The unit of slip of (4.21), `(1 - sigma) E/2` of the circle.
const A: f64 = (1.0 - STEEL) * FRAC_PI_4;
/// `A chi` of the parts a to e: round numbers, whose `chi` the thesis prints to two decimals.
const A_CHI: [f64; 5] = [0.3, 0.7, 1.1, 1.5, 1.9];
/// Their spins.
pub(crate) const SPINS: [f64; 5] =
    [A_CHI[0] / A, A_CHI[1] / A, A_CHI[2] / A, A_CHI[3] / A, A_CHI[4] / A];
/// That of part f, by its place in [`SPINS`].
const ON_THE_AXIS: usize = 3;

/// What one theory has to say of one spin.
struct View {
    adhesion: Vec<Polygon>,
    share: f64,
    /// `Y` and `Q` on the `x`-axis.
    axis: [Vec<[f64; 2]>; 2],
}

impl View {
    fn new(circle: Ellipse, field: &Field, slip_unit: f64) -> Self {
        let (adhesion, share) = contact::adhesion(circle, field);
        let positions: Vec<_> = spaced(-0.998, 0.998, 160).into_iter().map(|x| [x, 0.0]).collect();
        let points = field(&positions);
        let traction = points.iter().map(|point| [point.position[0], point.traction[1]]).collect();
        let slip = points.iter().map(|point| [point.position[0], slip_unit * point.slip[1]]);
        Self { adhesion, share, axis: [traction, slip.collect()] }
    }
}

fn make() -> Result<Reproduction, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let theory = chapter_5(1.0, STEEL, 3, Weight::Elliptic)?;
    let full = contact::detailed(1.0, STEEL)?;
    let (mut of_1967, mut today) = (Vec::new(), Vec::new());
    for chi in SPINS {
        let creepage = rolling_at([0.0, 0.0, chi]);
        let unit = theory.slip_scale();
        of_1967.push(View::new(circle, &contact::chapter_5(&theory, creepage), unit));
        today.push(View::new(circle, &contact::full(&full, creepage), unit));
    }
    let mut data = Data::new(["curve", "chi", "x", "y"]);
    for (name, views) in [("M = 3", &of_1967), ("full theory", &today)] {
        collect(&mut data, circle, name, views);
    }
    let printed_pieces = SPINS.map(|chi| pieces_on_the_mesh(&theory, chi));
    let agreement = agreement(circle, printed_pieces, &of_1967[ON_THE_AXIS], &today);
    Ok(Reproduction::figure(&sheet(circle, &of_1967, &today), caption(&today), data, agreement))
}

fn collect(data: &mut Data, circle: Ellipse, name: &str, views: &[View]) {
    let mut add = |kind: &str, chi: f64, line: &[[f64; 2]]| {
        data.points(&format!("{kind}, {name}"), &[chi], line);
    };
    for (chi, view) in SPINS.into_iter().zip(views) {
        for line in contact::separatrix(circle, &view.adhesion) {
            add("separatrix", chi, &line);
        }
    }
    add("Y on the x-axis", SPINS[ON_THE_AXIS], &views[ON_THE_AXIS].axis[0]);
    add("Q on the x-axis", SPINS[ON_THE_AXIS], &views[ON_THE_AXIS].axis[1]);
}

fn caption(today: &[View]) -> String {
    let shares: Vec<_> = today.iter().map(|view| format!("{:.1}", 100.0 * view.share)).collect();
    format!(
        "Circular contact, σ = 0.28, no creepage. The spins of the print are those at which Aχ, A = (1 − σ)E/2, \
         is 0.3, 0.7, 1.1, 1.5 and 1.9; chapter 5 with M = 3, W = W₁, its separatrix \
         T = S. Dashed, the separatrix of the full theory, in which {} % of the contact adhere. It \
         has one area of adhesion up to χ = 1.95, at the leading edge. In the end an island \
         remains about the point without slip, much smaller than that of 1967: see the item islands. Part f in the \
         thesis's units, Y over its largest bound and Q in units of μf₀₀.",
        shares.join(", ")
    )
}

/// Separate areas of adhesion among the mesh points, as the programme of 1967 counted them.
fn pieces_on_the_mesh(theory: &Variational, chi: f64) -> usize {
    let creepage = rolling_at([0.0, 0.0, chi]);
    let found = theory.solve_from(creepage, &Start::FullSliding);
    let stuck = found.points.iter().filter(|point| point.t > point.s);
    let mut left: Vec<_> = stuck.map(|point| point.field.position).collect();
    let mut pieces = 0;
    while let Some(first) = left.pop() {
        pieces += 1;
        let mut piece = vec![first];
        while let Some([x, y]) = piece.pop() {
            // Neighbours along the lines and columns, which are 0.2 apart.
            let near = |p: &[f64; 2]| (p[0] - x).abs() + (p[1] - y).abs() < 0.21;
            piece.extend(left.iter().copied().filter(near));
            left.retain(|p| !near(p));
        }
    }
    pieces
}

fn agreement(
    circle: Ellipse,
    on_the_mesh: [usize; 5],
    on_the_axis: &View,
    today: &[View],
) -> Vec<Comparison> {
    let printed = [
        (1, "one area, the x-axis within it"),
        (1, "one area, narrow in y"),
        (2, "two parts"),
        (3, "island, and two small parts of doubtful existence"),
        (1, "island only"),
    ];
    let mut lines = Vec::new();
    for (k, (expected, words)) in printed.into_iter().enumerate() {
        let (ours, full) = (on_the_mesh[k], contact::pieces(circle, &today[k].adhesion));
        let quantity = format!("areas of adhesion at χ = {:.2}", SPINS[k]);
        let full = match full {
            0 => "the island, below resolution here, see the item islands".to_owned(),
            _ => full.to_string(),
        };
        let found = format!("{ours} on chapter 5's mesh; full theory: {full}");
        let doubtful = "on the right four points adhere, in a row at x/a = 0.9, all of them \
            aberrations; how T = S is drawn between them decides whether they are one part or two";
        lines.push(Comparison::claim(quantity, words, found, ours == expected).because(doubtful));
    }
    lines.push(zeros(on_the_axis));
    lines
}

/// "Slip and traction vanish at about the same point in the adhesion island on the left."
fn zeros(view: &View) -> Comparison {
    let zero = |line: &[[f64; 2]]| {
        let pair = line.windows(2).find(|pair| pair[0][1] < 0.0 && pair[1][1] >= 0.0);
        pair.map_or(f64::NAN, |pair| {
            let [[x, y], [u, v]] = [pair[0], pair[1]];
            x + (u - x) * y / (y - v)
        })
    };
    let [traction, slip] = view.axis.each_ref().map(|line| zero(line));
    Comparison::claim(
        "zeros of Y and Q on the x-axis at χ = 2.65",
        "at about the same point",
        format!("x/a = {traction:.2} and {slip:.2} by chapter 5"),
        // The island itself is some 0.2 wide.
        (traction - slip).abs() < 0.1,
    )
}

fn sheet(circle: Ellipse, of_1967: &[View], today: &[View]) -> Sheet {
    let mut sheet = Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "1"), ("σ", "0.28"), ("ξ", "0"), ("η", "0")]))
        .columns(3);
    for (k, letter) in ["a", "b", "c", "d", "e"].into_iter().enumerate() {
        let heading = Label::new(letter).plain(")  ").symbol("χ").plain(" = ");
        let heading = heading.number(&format!("{:.2}", SPINS[k])).plain(", ").symbol("Aχ");
        let heading = heading.plain(" = ").number(&A_CHI[k].to_string());
        let panel = contact::panel(circle, heading);
        let panel = contact::areas(panel, circle, &of_1967[k].adhesion);
        let island = |area: &&Polygon| k >= ON_THE_AXIS && area.iter().all(|point| point[0] < 0.0);
        let islands = of_1967[k].adhesion.iter().filter(island);
        let panel = islands.fold(panel, |panel, island| contact::ringed(panel, island));
        let panel = contact::edge(panel, circle);
        let separatrix = contact::full_separatrix(circle, &today[k].adhesion);
        sheet = sheet.panel(panel.curves(&separatrix, FULL));
    }
    sheet
        .panel(on_the_axis(&of_1967[ON_THE_AXIS], &today[ON_THE_AXIS]))
        .key(Fill::ADHESION, Label::new("adhesion, chapter 5"))
        .key(Fill::SLIP, Label::new("slip, chapter 5"))
        .key(RING, Label::new("around the island, chapter 5"))
        .key(FULL, Label::new("full theory; f) dotted: ").symbol("Q"))
        .key(OF_1967, Label::new("f) traction ").symbol("Y").plain(", chapter 5"))
        .key(SECOND, Label::new("f) slip ").symbol("Q").plain(", chapter 5"))
        .key(Pen::GUIDE, Label::new("f) Coulomb’s bound"))
}

fn on_the_axis(of_1967: &View, today: &View) -> Panel {
    let bound: Vec<_> =
        spaced(-1.0, 1.0, 200).into_iter().map(|x| [x, (1.0 - x * x).sqrt()]).collect();
    let below = bound.iter().map(|[x, y]| [*x, -y]).collect();
    let chi = format!("{:.2}", SPINS[ON_THE_AXIS]);
    let heading = Label::new("f)  ").symbol("χ").plain(" = ").number(&chi);
    let x = Axis::new([-1.0, 1.0], Label::default().symbol("x").plain("/").symbol("a"));
    let y = Label::default()
        .symbol("Y/")
        .indexed("μp", "0")
        .plain(", ")
        .symbol("Q/")
        .indexed("μf", "00");
    let y = Axis::new([-1.0, 2.0], y);
    Panel::new(x, y)
        .height(150.0)
        .heading(heading)
        .curve(bound, Pen::GUIDE)
        .curve(below, Pen::GUIDE)
        .curve(today.axis[0].clone(), FULL.wide(1.6))
        .curve(today.axis[1].clone(), Pen { dashes: "2.5 3", ..FULL.wide(1.8) })
        .curve(of_1967.axis[0].clone(), OF_1967)
        .curve(of_1967.axis[1].clone(), SECOND)
}
