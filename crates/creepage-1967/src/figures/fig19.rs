//! Fig. 19: which way the traction points in creepage without spin.

use creepage::Creepage;
use creepage::Ellipse;
use creepage::coulomb::{Exact, Resolution};
use creepage::variational::Weight;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("fig19", "Fig. 19. Direction of the traction without spin", make);

const ALONG: [f64; 3] = [0.8, 0.0, 0.0];
const ACROSS: [f64; 3] = [0.0, 0.8, 0.0];
/// Broad and pale below, narrow and dark above: both are seen.
const OF_1967: &str = "#8fb4dc";
const TODAY: &str = "#c62828";
/// Angles are drawn this many times larger.
const STRETCH: f64 = 3.0;

fn make() -> Result<Reproduction, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let theory = chapter_5(1.0, STEEL, 3, Weight::Elliptic)?;
    let full = Exact::new(&like_bodies(1.0, STEEL)?, Resolution::FINE)?;
    let mut data = Data::new(["curve", "x", "y", "angle"]);
    let mut sheet = Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "1"), ("σ", "0.28"), ("χ", "0")]))
        .note(Label::new("Angles are drawn three times as large."))
        .columns(2);
    let mut angles = Vec::new();
    for (creepage, heading) in [(ALONG, heading("a", "ξ")), (ACROSS, heading("b", "η"))] {
        let creepage = rolling_at(creepage);
        let fields = [contact::chapter_5(&theory, creepage), contact::full(&full, creepage)];
        let mut panel = contact::edge(contact::panel(circle, heading), circle);
        for ((field, pen), name) in
            fields.iter().zip([(OF_1967, 4.5), (TODAY, 1.4)]).zip(["M = 3", "full theory"])
        {
            let name = format!("{name}, xi = {}, eta = {}", creepage.xi(), creepage.eta());
            panel = arrows(panel, field, creepage, pen, |[x, y], angle| {
                data.push([(&name).into(), x.into(), y.into(), angle.into()]);
            });
        }
        angles.push(fields.map(|field| [-0.7, 0.7].map(|x| range(&field, creepage, x))));
        sheet = sheet.panel(panel);
    }
    let sheet = sheet
        .key(Sample::arrow(OF_1967), axes::degree(3))
        .key(Sample::arrow(TODAY), Label::new("full theory"));
    Ok(Reproduction::figure(&sheet, CAPTION, data, agreement(&angles)?))
}

const CAPTION: &str = "Circular contact, σ = 0.28; chapter 5 with M = 3, W = W₁. Traction on the \
    lower body, all arrows of one length. Behind, where it slips, both theories agree on the \
    angles to a degree or two. In front, where the traction is far below its bound, the directions \
    of chapter 5 are erratic, as the thesis suspects. Those of the full theory stay close to that \
    of the creepage.";

fn heading(letter: &str, symbol: &str) -> Label {
    Label::new(letter).plain(")  ").symbol(symbol).plain(" = 0.8")
}

/// Angle of the traction to the creepage in degrees, as the thesis counts it from the `x`-axis
/// (gamma) or the `y`-axis (beta).
fn angle(traction: [f64; 2], creepage: Creepage) -> f64 {
    let [along, across] = if creepage.xi() > 0.0 { traction } else { [traction[1], traction[0]] };
    across.atan2(along).to_degrees()
}

fn arrows(
    mut panel: Panel,
    field: &Field,
    creepage: Creepage,
    (colour, width): (&'static str, f64),
    mut note: impl FnMut([f64; 2], f64),
) -> Panel {
    let steps = [-0.75, -0.45, -0.15, 0.15, 0.45, 0.75];
    let lattice = steps.iter().flat_map(|x| [-0.7, -0.35, 0.0, 0.35, 0.7].map(|y| [*x, y]));
    let inside: Vec<_> = lattice.filter(|[x, y]: &[f64; 2]| x.hypot(*y) < 0.88).collect();
    for point in field(&inside) {
        let angle = angle(point.traction, creepage);
        note(point.position, angle);
        let (sin, cos) = (STRETCH * angle).to_radians().sin_cos();
        let way = if creepage.xi() > 0.0 { [cos, sin] } else { [sin, cos] };
        let end = |share: f64| [0, 1].map(|i| point.position[i] + share * way[i]);
        panel = panel.arrow(end(-0.1), end(0.1), width, colour);
    }
    panel
}

/// Smallest and largest angle at the mesh points of a column with `y > 0`, but for those next to
/// the axis.
fn range(field: &Field, creepage: Creepage, x: f64) -> [f64; 2] {
    let points = field(&[0.3, 0.5, 0.7].map(|y| [x, y]));
    let angles = points.iter().map(|point| angle(point.traction, creepage).abs());
    angles.fold([f64::INFINITY, 0.0], |[low, high], angle| [low.min(angle), high.max(angle)])
}

fn agreement(angles: &[[[[f64; 2]; 2]; 2]]) -> Result<Vec<Comparison>, GalleryError> {
    let mut lines = Vec::new();
    let printed = [("γ", ["3", "3"], ["1, 3", "2, 4"]), ("β", ["7", "3"], ["1, 3", "2, 4"])];
    for ((name, degrees, which), [ours, full]) in printed.into_iter().zip(angles) {
        for k in 0..2 {
            let [low, high] = ours[k];
            let value: f64 = degrees[k].parse().unwrap_or(f64::NAN);
            let column = ["−0.7", "0.7"][k];
            let ours = format!(
                "{low:.1}° to {high:.1}° at the mesh points x/a = {column}, y/a = 0.3 to 0.7"
            );
            let quantity = format!("|{name}| at the points {}", which[k]);
            let line = Comparison::claim(
                quantity,
                format!("{value}°"),
                ours,
                low <= value && value <= high,
            );
            lines.push(line.remark(&format!(
                "where the points stand is in the picture of 1967 only; full theory: {:.1}° to {:.1}°",
                full[k][0], full[k][1]
            )));
        }
    }
    lines.extend(trends()?);
    Ok(lines)
}

/// The largest angle at the mesh points of chapter 5 that slip.
fn largest(a_over_b: f64, poisson: f64, creepage: [f64; 3]) -> Result<f64, GalleryError> {
    let creepage = rolling_at(creepage);
    let theory = chapter_5(a_over_b, poisson, 3, Weight::Elliptic)?;
    let positions: Vec<_> = theory.mesh().to_vec();
    let points = contact::chapter_5(&theory, creepage)(&positions);
    let sliding = points.iter().filter(|point| point.region == creepage::Region::Slip);
    Ok(sliding.map(|point| angle(point.traction, creepage).abs()).fold(0.0, f64::max))
}

fn trends() -> Result<Vec<Comparison>, GalleryError> {
    let at = |xi: f64| [xi, ALONG[1], ALONG[2]];
    let circle = largest(1.0, STEEL, ALONG)?;
    let (soft, fast, slender) =
        (largest(1.0, 0.5, ALONG)?, largest(1.0, STEEL, at(1.6))?, largest(0.2, STEEL, ALONG)?);
    let line = |what: &str, printed: &str, ours: f64, holds: bool| {
        let found = format!("at most {ours:.1}°, beside {circle:.1}°");
        Comparison::claim(format!("|γ| where it slips, {what}"), printed, found, holds)
    };
    let across = largest(1.0, STEEL, ACROSS)?;
    let infinitesimal = largest_of_infinitesimal_creepage();
    let same_order = Comparison::claim(
        "largest |γ| and |β|",
        "of the same order as θ of (4.46)",
        format!("{circle:.1}° and {across:.1}° where it slips; θ = {infinitesimal:.1}°"),
        (0.5..2.0).contains(&(circle / infinitesimal))
            && (0.5..2.0).contains(&(across / infinitesimal)),
    );
    Ok(vec![
        same_order,
        line("ξ = 1.6 beside 0.8", "decreases", fast, fast < circle),
        line("σ = 0.5 beside 0.28", "up to about 20°", soft, (17.0..23.0).contains(&soft)),
        line("a/b = 0.2 beside 1", "decreases for slender contacts", slender, slender < circle),
    ])
}

/// The largest angle between slip and traction in infinitesimal creepage, (4.45), in degrees.
fn largest_of_infinitesimal_creepage() -> f64 {
    (2.0 * (1.0 - STEEL).sqrt() / (2.0 - STEEL)).acos().to_degrees()
}
