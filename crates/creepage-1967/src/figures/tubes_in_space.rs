//! The tubes of constant creepage in the space of force and spin, as 5.33 describes them.

use creepage::coulomb::{Exact, Resolution};
use rayon::prelude::*;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("tubes-3d", "Tubes of constant creepage in the space of force and spin", make);

/// The tube that is drawn.
const SIZE: f64 = 0.9;
/// Directions of the creepage round a ring; sections between two spins that are marked.
const ROUND: u32 = 24;
const SECTIONS: u32 = 40;
const LARGEST: f64 = 10.0;
/// Where the spin's axis goes on paper, for the whole of it, and how `fx` is foreshortened: an oblique view.
const AXIS: [f64; 2] = [2.6, 0.62];
const DEPTH: [f64; 2] = [0.42, -0.30];

/// Closed sections `(fx, fy)` of one tube, and the line of pure spin within.
struct Tube {
    a_over_b: f64,
    spins: Vec<f64>,
    rings: Vec<Curve>,
    core: Curve,
}

/// Denser where the forces change most.
fn spins() -> Vec<f64> {
    spaced(0.0, 1.0, SECTIONS).into_iter().map(|s| LARGEST * s.powf(1.6)).collect()
}

impl Tube {
    fn new(a_over_b: f64) -> Result<Self, GalleryError> {
        let exact = Exact::new(&like_bodies(a_over_b, STEEL)?, Resolution::STANDARD)?;
        let spins = spins();
        let ring = |chi: &f64| -> Curve {
            // By symmetry (4.28) half of it is enough.
            let half = spaced(-90.0, 90.0, ROUND / 2).into_iter().map(|angle| {
                let (sin, cos) = angle.to_radians().sin_cos();
                rolling_at([SIZE * cos, SIZE * sin, *chi])
            });
            let half: Vec<_> = half.collect();
            let mut ring: Curve =
                exact.curve(&half).iter().map(|found| [found.force.fx, found.force.fy]).collect();
            let mirrored: Curve = ring.iter().rev().map(|[fx, fy]| [-fx, *fy]).collect();
            ring.extend_from_slice(&mirrored[1..mirrored.len() - 1]);
            ring
        };
        let core: Vec<_> = spins.iter().map(|chi| rolling_at([0.0, 0.0, *chi])).collect();
        Ok(Self {
            a_over_b,
            rings: spins.iter().map(ring).collect(),
            core: exact.curve(&core).iter().map(|found| [found.force.fx, found.force.fy]).collect(),
            spins,
        })
    }

    /// Area and mean of a section.
    fn section(&self, k: usize) -> [f64; 2] {
        let ring = &self.rings[k];
        let next = ring.iter().cycle().skip(1);
        let area: f64 = ring.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum();
        let (low, high) = ring.iter().fold((1.0_f64, -1.0_f64), |(low, high), point| {
            (low.min(point[1]), high.max(point[1]))
        });
        [0.5 * area.abs(), f64::midpoint(low, high)]
    }
}

/// A point of the space on paper.
fn seen(chi: f64, [fx, fy]: [f64; 2]) -> [f64; 2] {
    let along = chi / LARGEST;
    [along * AXIS[0] + DEPTH[0] * fx, along * AXIS[1] + DEPTH[1] * fx + fy]
}

fn make() -> Result<Reproduction, GalleryError> {
    let tubes =
        CATALOGUE.par_iter().map(|(ratio, _)| Tube::new(*ratio)).collect::<Result<Vec<_>, _>>()?;
    let mut data = Data::new(["curve", "a_over_b", "chi", "fx", "fy"]);
    for tube in &tubes {
        for ((chi, ring), core) in tube.spins.iter().zip(&tube.rings).zip(&tube.core) {
            data.points("ring", &[tube.a_over_b, *chi], ring);
            data.points("pure spin", &[tube.a_over_b, *chi], [core]);
        }
    }
    let caption = "σ = 0.28. The tube of constant creepage υ = 0.9 in the space of f_x, f_y and χ, seen obliquely, by \
        the full theory. There are a ring for each spin, and lines of constant direction of the creepage along it. The line inside \
        is pure spin, Fig. 23. The rings are symmetric about f_x = 0 (4.28). With spin the tube is lifted to where pure spin has its \
        force, is thinner behind, and closes in on the χ-axis as the spin grows.";
    let lines = tubes.iter().map(claims).collect::<Vec<_>>();
    Ok(Reproduction::figure(&sheet(&tubes), caption, data, lines))
}

fn claims(tube: &Tube) -> Comparison {
    let last = tube.rings.len() - 1;
    let areas: Vec<_> = (0..=last).map(|k| tube.section(k)[0]).collect();
    let falls = areas.windows(2).all(|pair| pair[1] < pair[0] * 1.005);
    Comparison::claim(
        format!("radius of the tube υ = 0.9, a/b = {}", tube.a_over_b),
        "decreases as |χ| increases",
        format!(
            "(area/π)^(1/2) of the section {:.3}, {:.3}, {:.3} at χ = 0, {:.1}, 10",
            (areas[0] / std::f64::consts::PI).sqrt(),
            (areas[last / 2] / std::f64::consts::PI).sqrt(),
            (areas[last] / std::f64::consts::PI).sqrt(),
            tube.spins[last / 2]
        ),
        falls,
    )
}

fn panel(tube: &Tube) -> Panel {
    let heading = Label::default().symbol("a/b").plain(" = ").number(&tube.a_over_b.to_string());
    let x = Axis::new([-0.75, 3.45], Label::default());
    let y = Axis::new([-1.15, 1.75], Label::default());
    let mut panel = Panel::new(x, y).to_scale().bare().heading(heading);
    // From behind: far rings first, each covers what lies behind it.
    let fill = Fill::plain("#eef3f9");
    for (chi, ring) in tube.spins.iter().zip(&tube.rings).rev() {
        let outline: Curve = ring.iter().map(|force| seen(*chi, *force)).collect();
        panel = panel.area(vec![outline], fill);
    }
    let thin = Pen { width: 0.9, ..OF_1967 };
    for (k, (chi, ring)) in tube.spins.iter().zip(&tube.rings).enumerate() {
        if k % 4 == 0 {
            let outline: Curve = ring.iter().map(|force| seen(*chi, *force)).collect();
            panel = panel.curve(closed(outline), if k == 0 { FULL } else { thin });
        }
    }
    for direction in (0..ROUND as usize).step_by(3) {
        let line = tube.spins.iter().zip(&tube.rings);
        let line: Curve = line.map(|(chi, ring)| seen(*chi, ring[direction])).collect();
        panel = panel.curve(line, Pen { width: 0.7, ..TANGENT });
    }
    let core = tube.spins.iter().zip(&tube.core).map(|(chi, force)| seen(*chi, *force));
    let arrow = |panel: Panel, to: [f64; 2], name: Label| {
        let end = [to[0] * 1.06, to[1] * 1.06];
        panel.arrow([0.0, 0.0], to, 1.2, OF_1967.colour).text(end, Anchor::Start, name)
    };
    let panel = panel.curve(core.collect(), SECOND);
    let panel = arrow(panel, seen(1.16 * LARGEST, [0.0; 2]), Label::default().symbol("χ"));
    let panel = arrow(panel, seen(0.0, [1.25, 0.0]), Label::default().indexed("f", "x"));
    arrow(panel, seen(0.0, [0.0, 1.25]), Label::default().indexed("f", "y"))
}

fn sheet(tubes: &[Tube]) -> Sheet {
    let sheet = tubes
        .iter()
        .fold(Sheet::new(ITEM.title).columns(2), |sheet, tube| sheet.panel(panel(tube)));
    sheet
        .note(axes::setting(&[("υ", "0.9"), ("σ", "0.28"), ("χ", "0 to 10")]))
        .key(FULL, Label::new("ring without spin"))
        .key(Pen { width: 0.9, ..OF_1967 }, Label::new("rings of constant spin"))
        .key(Pen { width: 0.7, ..TANGENT }, Label::new("constant direction of the creepage"))
        .key(SECOND, Label::new("pure spin"))
}
