//! Proposition I: with friction the field depends on the history, and on nothing else.

use creepage::coulomb::Resolution;
use creepage::statics::Compression;
use creepage::unsteady::{Motion, Rolling};
use creepage::{InvalidValue, Solid, SolidPair};

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("i-histories", "Proposition I. Two ways to one tangential force", make);

/// The force at the end over `mu N`, and what the second way goes through before.
const END: f64 = 0.3;
const THROUGH: f64 = 0.8;

/// Tractions on the line `y = 0` over `mu p_0`, and the ends of their elements.
fn shifted(way: &[f64], parts: usize) -> Result<(Curve, Curve), InvalidValue> {
    let mut bodies = Rolling::new(&like_bodies(1.0, 0.0)?, Resolution::STANDARD)?;
    let mut from = 0.0;
    for to in way {
        for part in 1..=parts {
            let share = part as f64 / parts as f64;
            bodies.shift(from + share * (to - from), 0.0)?;
        }
        from = *to;
    }
    // The strip nearest to the middle.
    let elements = bodies.elements();
    let nearest = elements.iter().map(|e| e.point.position[1].abs()).fold(f64::INFINITY, f64::min);
    let is_middle = |y: f64| y >= 0.0 && y < nearest + 1e-9;
    let middle = || elements.iter().filter(|element| is_middle(element.point.position[1]));
    let tractions = middle().map(|element| [element.point.position[0], element.point.traction[0]]);
    let ends = middle().map(|element| {
        let x = element.corners.map(|corner| corner[0]);
        [x.into_iter().fold(1.0, f64::min), x.into_iter().fold(-1.0, f64::max)]
    });
    Ok((tractions.collect(), ends.collect()))
}

/// Cattaneo's and Mindlin's traction, and Mindlin's and Deresiewicz's after unloading.
fn closed_form(x: f64, through: Option<f64>) -> f64 {
    let cap = |c: f64| (c * c - x * x).max(0.0).sqrt();
    let radius = |force: f64| (1.0 - force).cbrt();
    match through {
        None => cap(1.0) - cap(radius(END)),
        Some(peak) => {
            cap(1.0) - cap(radius(peak)) - 2.0 * (cap(1.0) - cap(radius(0.5 * (peak - END))))
        }
    }
}

/// The largest difference of pressure between two ways to one approach of like bodies, over the largest.
fn without_friction() -> Result<f64, InvalidValue> {
    let solid = Solid::new(1e6, 0.3)?;
    let new = || Compression::new(SolidPair::new(solid, solid), 0.1, 0.2, 6e-3, 40);
    let (mut direct, mut around) = (new()?, new()?);
    for k in 1..=20 {
        direct.press(1e-5 * f64::from(k))?;
    }
    for k in (1..=30).chain((20..30).rev()) {
        around.press(1e-5 * f64::from(k))?;
    }
    let largest = direct.rings().map(|(_, [p, _], _)| p).fold(0.0, f64::max);
    let pairs = direct.rings().zip(around.rings());
    let apart = pairs.map(|((_, [p, _], _), (_, [r, _], _))| (p - r).abs()).fold(0.0, f64::max);
    Ok(apart / largest)
}

/// Rolled on by less than it remembers, then through more than that: the forces of both ways.
fn rolled() -> Result<Vec<[f64; 3]>, InvalidValue> {
    let new = || Rolling::new(&like_bodies(1.0, 0.0)?, Resolution::STANDARD);
    let mut ways = [new()?, new()?];
    ways[0].shift(END, 0.0)?;
    ways[1].shift(THROUGH, 0.0)?;
    ways[1].shift(END, 0.0)?;
    (1..=40)
        .map(|k| {
            let [one, two] = ways.each_mut().map(|way| way.step(0.1, &Motion::forces(END, 0.0)));
            Ok([0.1 * f64::from(k), one?.creepage.xi(), two?.creepage.xi()])
        })
        .collect()
}

fn make() -> Result<Reproduction, GalleryError> {
    let direct = shifted(&[END], 1)?;
    let around = shifted(&[THROUGH, END], 8)?;
    let again = shifted(&[THROUGH, END], 4)?;
    let x = spaced(-1.0, 1.0, 200);
    let known = [None, Some(THROUGH)]
        .map(|through| x.iter().map(|x| [*x, closed_form(*x, through)]).collect::<Curve>());
    let rolled = rolled()?;
    let mut data = Data::new(["curve", "x_or_q", "traction_or_xi"]);
    data.curve("directly", &direct.0);
    data.curve("through more", &around.0);
    data.curve("directly, closed form", &known[0]);
    data.curve("through more, closed form", &known[1]);
    let creepages = [1, 2].map(|k| rolled.iter().map(|row| [row[0], row[k]]).collect::<Curve>());
    data.curve("creepage after directly", &creepages[0]);
    data.curve("creepage after through more", &creepages[1]);
    let off = |(found, ends): &(Curve, Curve), through: Option<f64>| {
        let mean = |[low, high]: [f64; 2]| {
            let places = spaced(low, high, 40);
            places.iter().map(|x| closed_form(*x, through)).sum::<f64>() / places.len() as f64
        };
        // The border of slip goes from element to element: those at its kinks do not count.
        let apart = found.iter().zip(ends).map(|([_, t], ends)| (t - mean(*ends)).abs());
        let mut apart: Vec<f64> = apart.collect();
        apart.sort_by(f64::total_cmp);
        apart[apart.len() * 4 / 5]
    };
    let [one, two] = [off(&direct, None), off(&around, Some(THROUGH))];
    let ways = farthest(&direct.0, &around.0);
    let steps = farthest(&around.0, &again.0);
    let pressed = without_friction()?;
    let end = rolled.last().map_or(f64::NAN, |row| (row[1] - row[2]).abs() / row[1]);
    let first = rolled.first().map_or(f64::NAN, |row| (row[1] - row[2]).abs() / row[1]);
    let agreement = vec![
        Comparison::claim(
            "pressure without friction, by two ways to one approach",
            "the field does not depend on the history",
            format!("the same within {pressed:.0e} of its peak"),
            pressed < 1e-9,
        ),
        Comparison::claim(
            "traction with friction, by two ways to one force",
            "the field depends on the history",
            format!(
                "up to {ways:.2} of μp₀ apart at the same force; four elements of five within {:.3} of the closed forms",
                one.max(two)
            ),
            ways > 0.3 && one.max(two) < 0.03,
        ),
        Comparison::claim(
            "traction with friction, one history in 8 and in 4 parts each way",
            "unique for a given history",
            format!("the same within {steps:.4} of μp₀"),
            steps < 0.01,
        ),
        Comparison::claim(
            "creepage after both, rolled on at that force",
            "(not said: rolling forgets, proposition IV, 3)",
            format!(
                "{:.0} % apart at first, {:.1} % after two contact widths",
                100.0 * first,
                100.0 * end
            ),
            end < 0.01,
        ),
    ];
    let caption = "Like bodies, a circle, σ = 0 (where the closed forms of Cattaneo and Mindlin, and of \
        Mindlin and Deresiewicz after unloading, are exact): a tangential force of 0.3 μN, reached directly and through \
        0.8 μN. Above: traction along the force on the middle line, by the full theory (points) and in closed form \
        (lines). Below: the creepage with which the bodies then roll under that force, which forgets its way within a contact \
        width or two.";
    Ok(Reproduction::figure(
        &sheet([direct.0, around.0], known, creepages),
        caption,
        data,
        agreement,
    ))
}

fn sheet(found: [Curve; 2], known: [Curve; 2], creepages: [Curve; 2]) -> Sheet {
    let pens = [SECOND, FULL];
    let x = Axis::new([-1.0, 1.0], Label::default().symbol("x").plain("/").symbol("a"));
    let y = Axis::new(
        [-1.0, 1.0],
        Label::default().symbol("X").plain("/").symbol("μ").indexed("p", "0"),
    );
    let mut tractions =
        Panel::new(x, y).height(330.0).curve(vec![[-1.0, 0.0], [1.0, 0.0]], Pen::GUIDE);
    for ((found, known), pen) in found.into_iter().zip(known).zip(pens) {
        tractions = tractions.curve(known, pen).marks(found, Mark::open(Shape::Circle, pen.colour));
    }
    let x = Label::new("distance rolled in contact widths, ").symbol("q").plain("/2").symbol("a");
    let y = Label::new("creepage ").symbol("ξ");
    let most = creepages.iter().flatten().map(|point| point[1]).fold(0.0, f64::max);
    let least = creepages.iter().flatten().map(|point| point[1]).fold(0.0, f64::min);
    let mut after =
        Panel::new(Axis::new([0.0, 2.0], x), Axis::new([1.1 * least, 1.1 * most], y)).height(220.0);
    for (curve, pen) in creepages.into_iter().zip(pens) {
        after = after.curve(curve.into_iter().map(|[q, xi]| [0.5 * q, xi]).collect(), pen);
    }
    Sheet::new(ITEM.title)
        .note(axes::setting(&[("a/b", "1"), ("σ", "0"), ("F/μN", "0.3")]))
        .panel(tractions)
        .panel(after)
        .key(SECOND, Label::new("directly"))
        .key(FULL, Label::new("through 0.8 of friction"))
        .key(Mark::open(Shape::Circle, FULL.colour), Label::new("full theory, element by element"))
}
