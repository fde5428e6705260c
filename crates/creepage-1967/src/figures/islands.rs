//! The open question of 5.322: is there an island of adhesion where the slip vanishes?

use creepage::Ellipse;
use creepage::coulomb::{Exact, Resolution};
use creepage::variational::Weight;
use creepage::{Creepage, Region};
use rayon::prelude::*;

use super::fig20;
use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("islands", "Is there an island of adhesion? The full theory’s answer to 5.322", make);

/// Beyond those of Fig. 20.
const BEYOND: f64 = 5.0;
/// The spins whose island is looked at closely.
const ENLARGED_SPINS: [f64; 3] = [fig20::SPINS[3], fig20::SPINS[4], BEYOND];
/// Elements along and across: an island is thin across.
const FINE: [usize; 2] = [36, 96];
/// Half as many strips: what an island is must not depend on the elements.
const COARSER: [usize; 2] = [36, 48];

/// An island about the point without slip.
struct Island {
    chi: f64,
    /// Corners of the elements that adhere, in units of `c`.
    elements: Vec<Polygon>,
    /// From where to where, in `x` and in `y`; not a number without an island.
    extent: [[f64; 2]; 2],
    of_1967: Vec<Polygon>,
}

fn make() -> Result<Reproduction, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let spins: Vec<f64> = fig20::SPINS.into_iter().chain([BEYOND]).collect();
    let full = contact::detailed(1.0, STEEL)?;
    let areas: Vec<_> = spins
        .par_iter()
        .map(|chi| contact::adhesion(circle, &contact::full(&full, spin(*chi))))
        .collect();
    let mut islands = Vec::new();
    for elements in [FINE, COARSER] {
        islands.push(look(elements)?);
    }
    let data = data(circle, &spins, &areas, &islands);
    let agreement = agreement(&areas, &islands);
    let sheet = sheet(circle, &spins, &areas, &islands[0]);
    Ok(Reproduction::figure(&sheet, caption(&islands), data, agreement))
}

fn spin(chi: f64) -> Creepage {
    rolling_at([0.0, 0.0, chi])
}

/// The islands of the spins that are looked at closely.
fn look([along, across]: [usize; 2]) -> Result<Vec<Island>, GalleryError> {
    let circle = Ellipse::from_ratio(1.0)?;
    let full = Exact::new(&like_bodies(1.0, STEEL)?, Resolution::new(along, across)?)?;
    let numerical = chapter_5(1.0, STEEL, 3, Weight::Elliptic)?;
    let island = |chi: &f64| {
        let solved = full.solve_contact(spin(*chi));
        let stuck = solved.elements().into_iter().filter(|element| {
            element.point.region == Region::Adhesion && element.point.position[0] < 0.0
        });
        let elements: Vec<_> = stuck.map(|element| element.corners.to_vec()).collect();
        let (of_1967, _) = contact::adhesion(circle, &contact::chapter_5(&numerical, spin(*chi)));
        Island { chi: *chi, extent: [0, 1].map(|i| extent(&elements, i)), elements, of_1967 }
    };
    Ok(ENLARGED_SPINS.par_iter().map(island).collect())
}

fn extent(elements: &[Polygon], axis: usize) -> [f64; 2] {
    let all = || elements.iter().flatten().map(|corner| corner[axis]);
    [all().fold(f64::NAN, f64::min), all().fold(f64::NAN, f64::max)]
}

fn size(island: &Island) -> [f64; 2] {
    island.extent.map(|[from, to]| if island.elements.is_empty() { 0.0 } else { to - from })
}

fn data(
    circle: Ellipse,
    spins: &[f64],
    areas: &[(Vec<Polygon>, f64)],
    islands: &[Vec<Island>],
) -> Data {
    let mut data = Data::new(["curve", "chi", "x", "y"]);
    for (chi, (area, _)) in spins.iter().zip(areas) {
        let line = contact::full_separatrix(circle, area);
        data.points("separatrix, full theory", &[*chi], line.iter().flatten());
    }
    for (islands, [along, across]) in islands.iter().zip([FINE, COARSER]) {
        let name = format!("length and width of the island, {along} by {across} elements");
        for island in islands {
            data.points(&name, &[island.chi], [&size(island)]);
        }
    }
    data
}

fn caption(islands: &[Vec<Island>]) -> String {
    let words = |k: usize| {
        let [length, width] = size(&islands[0][k]);
        format!("{length:.2} a by {width:.2} a at χ = {}", ENLARGED_SPINS[k])
    };
    format!(
        "Circular contact, σ = 0.28, no creepage. Above, the full theory's areas at the spins of \
         Fig. 20 and at χ = 5; below, enlarged, the elements that adhere about the point without \
         slip, with {} by {} elements in the contact, and the outline of chapter 5's island. 5.322 \
         doubts the small areas on the right of Fig. 20d: they do not exist. It also doubts the \
         island, and thinks a jump of the traction and a simple zero of the slip possible instead. \
         The island exists: if the traction turned at its full strength about a single point, the \
         displacement's gradient would have no bound there, and the slip could not vanish. But it \
         is small and thin, {}, {} and {}: one or two elements wide even on this fine grid, so its \
         size is known only roughly. It moves towards the middle as the spin grows.",
        FINE[0],
        FINE[1],
        words(0),
        words(1),
        words(2)
    )
}

fn agreement(areas: &[(Vec<Polygon>, f64)], islands: &[Vec<Island>]) -> Vec<Comparison> {
    let leading = areas[3].0.iter().flatten().filter(|point| point[0] > 0.0).count();
    let mut lines = vec![Comparison::claim(
        "small areas on the right, χ = 2.65",
        "it is doubtful whether they exist",
        if leading == 0 { "they do not exist" } else { "they exist" },
        leading == 0,
    )];
    for (k, chi) in ENLARGED_SPINS.into_iter().enumerate() {
        let ours = islands.iter().map(|islands| {
            let ([length, width], count) = (size(&islands[k]), islands[k].elements.len());
            match count {
                0 => "below resolution".to_owned(),
                _ => format!("{length:.2} a by {width:.2} a ({count} elements)"),
            }
        });
        let ours: Vec<_> = ours.collect();
        let holds = !islands[0][k].elements.is_empty();
        let quantity = format!("island about the point without slip, χ = {chi:.2}");
        let line = Comparison::claim(
            quantity,
            "exists, somewhat doubtful",
            format!("exists, {}", ours[0]),
            holds,
        );
        lines.push(
            line.remark(&format!("with {} strips instead of {}: {}", COARSER[1], FINE[1], ours[1])),
        );
    }
    lines
}

fn sheet(
    circle: Ellipse,
    spins: &[f64],
    areas: &[(Vec<Polygon>, f64)],
    islands: &[Island],
) -> Sheet {
    let heading = |chi: f64| Label::default().symbol("χ").plain(" = ").number(&format!("{chi:.2}"));
    let mut sheet = Sheet::new("Is there an island of adhesion?")
        .note(axes::setting(&[("a/b", "1"), ("σ", "0.28"), ("ξ", "0"), ("η", "0")]))
        .columns(3);
    for (chi, (area, _)) in spins.iter().zip(areas) {
        let panel = contact::areas(
            contact::panel(circle, heading(*chi)),
            circle,
            &contact::smooth_area(area),
        );
        let island = islands.iter().filter(|island| (island.chi - chi).abs() < 1e-9);
        let elements = island.map(|island| island.elements.concat());
        let panel = elements
            .filter(|corners| !corners.is_empty())
            .fold(panel, |panel, corners| contact::ringed(panel, &corners));
        sheet = sheet.panel(contact::edge(panel, circle));
    }
    for island in islands {
        sheet = sheet.panel(closely(circle, island, heading(island.chi)));
    }
    sheet
        .key(Fill::ADHESION, Label::new("adhesion, full theory"))
        .key(Fill::SLIP, Label::new("slip, full theory"))
        .key(OF_1967, Label::new("chapter 5’s island"))
        .key(RING, Label::new("around the island, full theory"))
}

/// The neighbourhood of an island.
fn closely(circle: Ellipse, island: &Island, heading: Label) -> Panel {
    let middle = island.extent[0][0].max(-0.98);
    // Round tenths, so that the axes' numbers stay short.
    let left = ((10.0 * middle).floor() * 0.1).max(-1.0);
    let ticks =
        |from: f64| [0.0, 0.2, 0.4].map(|step| from + step).map(|at| (at, format!("{at:.1}")));
    let over_a = |symbol| Label::default().symbol(symbol).plain("/").symbol("a");
    let x = Axis::new([left, left + 0.6], over_a("x")).ticks(ticks(left + 0.1).to_vec());
    let y = Axis::new([0.3, -0.3], over_a("y")).ticks(ticks(-0.2).to_vec());
    let mut panel = Panel::new(x, y).to_scale().heading(heading);
    for element in &island.elements {
        panel = panel
            .area(vec![element.clone()], Fill::ADHESION)
            .curve(closed(element.clone()), Pen::OUTLINE.wide(0.7));
    }
    let near = contact::separatrix(circle, &island.of_1967);
    panel.curve(contact::outline(circle), Pen::OUTLINE).curves(&near, OF_1967)
}
