//! Fig. 24: lines of constant size and of constant direction of the creepage, over the force.

use creepage::variational::Weight;
use creepage::{Creepage, Force};

use crate::prelude::*;

pub(crate) const A: Item =
    Item::new("fig24a", "Fig. 24a. Creepage over force, no spin", || make(A.title, 0.0));
pub(crate) const B: Item =
    Item::new("fig24b", "Fig. 24b. Creepage over force, spin near the peak", || make(B.title, 2.0));
pub(crate) const C: Item =
    Item::new("fig24c", "Fig. 24c. Creepage over force, large spin", || make(C.title, 5.0));

/// Sizes of the creepage on the rings.
const SIZES: [f64; 7] = [0.3, 0.5, 0.7, 0.9, 1.1, 1.3, 1.7];

/// The forces along a line.
struct Line {
    /// `upsilon` of a ring, `alpha` in degrees of a ray.
    value: f64,
    creepages: Vec<Creepage>,
    /// By chapter 5, by the full theory.
    forces: [Vec<Force>; 2],
}

/// Rings of constant `upsilon` and rays of constant `alpha` at one spin.
struct Net {
    chi: f64,
    rings: Vec<Line>,
    rays: Vec<Line>,
}

impl Net {
    fn new(chi: f64) -> Result<Self, GalleryError> {
        let theory = chapter_5(1.0, STEEL, 3, Weight::Elliptic)?;
        let line = |value: f64, polar: Vec<(f64, f64)>| -> Result<Line, GalleryError> {
            let creepages: Vec<_> =
                polar.into_iter().map(|(upsilon, alpha)| at(chi, upsilon, alpha)).collect();
            let forces = [chained(&theory, &creepages), full(1.0, STEEL, &creepages)?];
            Ok(Line { value, creepages, forces })
        };
        let ring = |upsilon: f64| {
            line(
                upsilon,
                spaced(lowest(chi), 90.0, 36).into_iter().map(|alpha| (upsilon, alpha)).collect(),
            )
        };
        // To a creepage of 12, crowded below 1.
        let sizes = || spaced(0.0, 1.0, 64).into_iter().map(|s| 0.05 + 0.95 * s + 11.0 * s.powi(5));
        let ray = |alpha: f64| line(alpha, sizes().map(|upsilon| (upsilon, alpha)).collect());
        let rings = SIZES.into_iter().map(ring).collect::<Result<_, _>>()?;
        let rays = angles(chi).iter().map(|alpha| ray(*alpha)).collect::<Result<_, _>>()?;
        Ok(Self { chi, rings, rays })
    }

    /// The largest distance of chapter 5 from the full theory on the rings.
    fn apart(&self) -> f64 {
        let pairs = self.rings.iter().flat_map(|ring| ring.forces[0].iter().zip(&ring.forces[1]));
        pairs.map(|(one, two)| (one.fx - two.fx).hypot(one.fy - two.fy)).fold(0.0, f64::max)
    }

    fn data(&self) -> Data {
        let mut data = Data::new(["curve", "xi", "eta", "fx", "fy"]);
        for (kind, lines) in [("upsilon", &self.rings), ("alpha", &self.rays)] {
            for line in lines {
                for (theory, forces) in ["M = 3", "full theory"].into_iter().zip(&line.forces) {
                    let name = format!("{kind} = {}, {theory}", line.value);
                    for (creepage, force) in line.creepages.iter().zip(forces) {
                        data.points(
                            &name,
                            &[creepage.xi(), creepage.eta()],
                            [&[force.fx, force.fy]],
                        );
                    }
                }
            }
        }
        data
    }
}

/// (5.30), the angle in degrees.
fn at(chi: f64, upsilon: f64, alpha: f64) -> Creepage {
    let (sin, cos) = alpha.to_radians().sin_cos();
    rolling_at([upsilon * cos, upsilon * sin, chi])
}

/// The lowest direction in degrees: without spin, one quarter tells all.
fn lowest(chi: f64) -> f64 {
    if chi > 0.0 { -90.0 } else { 0.0 }
}

fn angles(chi: f64) -> &'static [f64] {
    if chi > 0.0 { &[-60.0, -30.0, 0.0, 30.0, 60.0] } else { &[30.0, 60.0] }
}

fn make(title: &str, chi: f64) -> Result<Reproduction, GalleryError> {
    let net = Net::new(chi)?;
    let agreement = if chi > 0.0 { with_spin(&net)? } else { without_spin(&net) };
    let words = match chi {
        0.0 => {
            "Symmetric about both axes: a quarter is enough. In the full theory the rays are \
            straight from υ = 0 on"
        }
        2.0 => {
            "The rays of α = −30° and −60° are wavy in chapter 5, and the thesis doubts that \
            they are: in the full theory they are smooth"
        }
        _ => {
            "The rings are egg-shaped, and narrower than with less spin; chapter 5 has their form \
            right, and puts them too low"
        }
    };
    let caption = format!(
        "Circular contact, σ = 0.28; chapter 5 with M = 3, W = W₁. Left the lines of constant \
         creepage υ, right those of constant direction α, with the circle of full sliding, υ = ∞. \
         {words}. Chapter 5 is within {:.3} of μN of the full theory on all rings.",
        net.apart()
    );
    Ok(Reproduction::figure(&sheet(title, &net), caption, net.data(), agreement))
}

/// Directions of the force in degrees along a ray, for a creepage up to 1.7 and from 0.3 on:
/// below, chapter 5 with its degree 3 is not to be trusted.
fn directions(ray: &Line, theory: usize) -> [f64; 2] {
    let pairs = ray.creepages.iter().zip(&ray.forces[theory]);
    let within =
        pairs.filter(|(creepage, _)| (0.3..1.7).contains(&creepage.xi().hypot(creepage.eta())));
    within.fold([180.0_f64, -180.0_f64], |[low, high], (_, force)| {
        let angle = force.fy.atan2(force.fx).to_degrees();
        [low.min(angle), high.max(angle)]
    })
}

fn without_spin(net: &Net) -> Vec<Comparison> {
    let mut lines = Vec::new();
    for ray in &net.rays {
        let [[low, high], [from, to]] = [0, 1].map(|theory| directions(ray, theory));
        let ours = format!("direction of the force from {low:.1}° to {high:.1}°, υ = 0.3 to 1.7");
        // As many degrees as (5.31a) allows for.
        let line = Comparison::claim(
            format!("line α = {}°", ray.value),
            "nearly straight up to υ = 1.7",
            ours,
            high - low < 3.7,
        );
        lines.push(line.remark(&format!("full theory: {from:.1}° to {to:.1}°")));
    }
    lines
}

fn with_spin(net: &Net) -> Result<Vec<Comparison>, GalleryError> {
    let ring = &net.rings[3];
    let [top, bottom] = [ring.creepages.len() - 1, 0].map(|end| roundness(&ring.forces[0], end));
    let flat = Comparison::claim(
        "lines of constant υ",
        "egg-shaped, with the flat end up",
        format!("radius of curvature {top:.2} at the top, {bottom:.2} at the bottom, υ = 0.9"),
        top > bottom,
    );
    let narrow = |chi: f64| -> Result<f64, GalleryError> {
        let theory = chapter_5(1.0, STEEL, 3, Weight::Elliptic)?;
        Ok(chained(&theory, &[at(chi, 0.9, 0.0)])[0].fx)
    };
    let widths = [narrow(0.0)?, narrow(2.0)?, narrow(5.0)?];
    let tube = Comparison::claim(
        "radius of the tube υ = constant with growing χ",
        "diminishes",
        format!(
            "f_x = {:.3}, {:.3}, {:.3} at χ = 0, 2, 5, υ = 0.9, α = 0",
            widths[0], widths[1], widths[2]
        ),
        widths[0] > widths[1] && widths[1] > widths[2],
    );
    Ok(vec![flat, tube, waves(net)])
}

/// Radius of curvature of a ring where it meets the `fy`-axis: from the three last points, whose
/// mirror images go on with it.
fn roundness(forces: &[Force], end: usize) -> f64 {
    let near = if end == 0 { 3 } else { end - 3 };
    let (tip, beside) = (forces[end], forces[near]);
    let (across, down) = (beside.fx, (tip.fy - beside.fy).abs());
    (across * across + down * down) / (2.0 * down)
}

/// Turns from left to right and back along a ray, by chapter 5 and by the full theory.
fn bends(ray: &Line, theory: usize) -> usize {
    let mut points: Vec<[f64; 2]> = Vec::new();
    for Force { fx, fy, .. } in &ray.forces[theory] {
        // Longer steps than the error of a force: its noise must not count as a bend.
        if points.last().is_none_or(|last| (fx - last[0]).hypot(fy - last[1]) > 0.06) {
            points.push([*fx, *fy]);
        }
    }
    let turn = |three: &[[f64; 2]]| {
        let step = |k: usize| [0, 1].map(|i| three[k + 1][i] - three[k][i]);
        let ([x, y], [u, v]) = (step(0), step(1));
        (x * v - y * u).atan2(x * u + y * v).to_degrees()
    };
    let turns: Vec<_> = points.windows(3).map(turn).filter(|turn| turn.abs() > 2.0).collect();
    turns.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count()
}

fn waves(net: &Net) -> Comparison {
    let count = |theory: usize| net.rays[..2].iter().map(|ray| bends(ray, theory)).sum::<usize>();
    let (of_1967, today) = (count(0), count(1));
    let found = format!("{of_1967} bends back in chapter 5, {today} in the full theory");
    let quantity = "lines α = −30° and −60°";
    if net.chi < 3.0 {
        Comparison::claim(
            quantity,
            "some waviness, perhaps of the calculation",
            found,
            of_1967 > today,
        )
    } else {
        Comparison::claim(quantity, "waviness completely gone", found, of_1967 == 0)
    }
}

fn sheet(title: &str, net: &Net) -> Sheet {
    let note = axes::setting(&[("a/b", "1"), ("σ", "0.28"), ("χ", &net.chi.to_string())]);
    Sheet::new(title)
        .note(note)
        .columns(2)
        .panel(rings(net))
        .panel(rays(net))
        .key(OF_1967, axes::degree(3))
        .key(FULL.wide(1.7), Label::new("full theory"))
        .key(Pen::THIN, Label::new("full sliding, ").symbol("υ").plain(" = ∞"))
}

fn frame(net: &Net, heading: Label) -> Panel {
    let bottom = if net.chi > 0.0 { -1.02 } else { 0.0 };
    let angles = spaced(lowest(net.chi), 90.0, 90);
    let circle = angles.iter().map(|angle| angle.to_radians().sin_cos());
    Panel::new(Axis::new([0.0, 1.19], axes::fx()), Axis::new([bottom, 1.02], axes::fy()))
        .to_scale()
        .heading(heading)
        .curve(circle.map(|(sin, cos)| [cos, sin]).collect(), Pen::THIN)
}

fn curves(panel: Panel, line: &Line) -> Panel {
    let [of_1967, today] = line
        .forces
        .each_ref()
        .map(|forces| forces.iter().map(|force| [force.fx, force.fy]).collect::<Vec<_>>());
    panel.curve(of_1967, OF_1967.wide(2.0)).curve(today, FULL.wide(1.7))
}

fn rings(net: &Net) -> Panel {
    let panel = frame(net, Label::new("constant ").symbol("υ"));
    let panel = net.rings.iter().fold(panel, curves);
    if net.chi > CROWDED {
        return fanned(panel, net);
    }
    net.rings.iter().fold(panel, |panel, ring| {
        // With spin the rings are farthest apart where creepage and spin oppose each other.
        let forces = &ring.forces[0];
        let end = if net.chi > 0.0 { forces.first() } else { forces.last() };
        let end = end.map_or([0.0; 2], |force| [force.fx, force.fy]);
        panel.name(end, OF_1967, Label::default().number(&ring.value.to_string()))
    })
}

/// The spin beyond which the rings are too small for their names at their ends.
const CROWDED: f64 = 3.0;

/// The names round the rings, each with a line to its own that crosses the others at right angles.
fn fanned(panel: Panel, net: &Net) -> Panel {
    const FAR: f64 = 0.56;
    let height = |force: Option<&Force>| force.map_or(0.0, |force| force.fy);
    let smallest = &net.rings[0].forces[0];
    let centre = f64::midpoint(height(smallest.first()), height(smallest.last()));
    let count = net.rings.len() as f64;
    net.rings.iter().enumerate().fold(panel, |panel, (k, ring)| {
        // From above for the smallest to below for the largest.
        let angle = (66.0 - 132.0 * k as f64 / (count - 1.0)).to_radians();
        let (sin, cos) = angle.sin_cos();
        let off = |force: &&Force| ((force.fy - centre).atan2(force.fx) - angle).abs();
        let nearest = ring.forces[0].iter().min_by(|one, two| off(one).total_cmp(&off(two)));
        let from = nearest.map_or([0.0; 2], |force| [force.fx, force.fy]);
        let name = Label::default().number(&ring.value.to_string());
        panel.curve(vec![from, [FAR * cos, centre + FAR * sin]], Pen::GUIDE).text(
            [(FAR + 0.02) * cos, centre + (FAR + 0.02) * sin - 0.02],
            Anchor::Start,
            name,
        )
    })
}

fn rays(net: &Net) -> Panel {
    let panel = frame(net, Label::new("constant ").symbol("α"));
    let panel = net.rays.iter().fold(panel, curves);
    net.rays.iter().fold(panel, |panel, ray| {
        let (sin, cos) = ray.value.to_radians().sin_cos();
        let name = Label::default().number(&format!("{}°", ray.value));
        panel.text([1.02 * cos, 1.02 * sin - 0.01], Anchor::Start, name)
    })
}
