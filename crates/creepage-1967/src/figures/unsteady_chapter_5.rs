//! The last project of 6.2: chapter 5 for rolling that is not steady, beside the full theory.

use creepage::coulomb::Resolution;
use creepage::unsteady::{Motion, Rolled, Rolling, RollingVariational};
use creepage::variational::{Settings, TractionBound};
use rayon::prelude::*;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("unsteady-chapter-5", "6.2. Chapter 5 for rolling that is not steady", make);

/// Degrees, and whether the bound is kept.
const THEORIES: [(&str, usize, TractionBound, Pen); 3] = [
    ("M = 3", 3, TractionBound::Kept, OF_1967),
    ("M = 6", 6, TractionBound::Kept, SECOND),
    ("M = 6, (5.9) alone", 6, TractionBound::Unchecked, THIRD),
];
/// A step over the semi-axis, and how far it rolls in contact widths.
const STEP_LENGTH: f64 = 0.1;
const WIDTHS: f64 = 3.0;
/// Of a force that is held (proposition IV, 3).
const FORCE: f64 = 0.64;

/// What is prescribed, and what is looked at.
struct Case {
    name: &'static str,
    /// Creepages from no traction, or a force that has shifted the bodies.
    creepage: Option<[f64; 3]>,
}

const CASES: [Case; 3] = [
    Case { name: "creepage \u{3be} = 0.9 from no traction", creepage: Some([0.9, 0.0, 0.0]) },
    Case { name: "spin \u{3c7} = 1 from no traction", creepage: Some([0.0, 0.0, 1.0]) },
    Case { name: "force 0.64 \u{3bc}N after a shift", creepage: None },
];

/// A way to roll on.
type Rolls<'a> = Box<dyn FnMut(f64, &Motion) -> Result<Rolled, GalleryError> + 'a>;

fn curve(case: &Case, mut roll: Rolls) -> Result<Curve, GalleryError> {
    let motion = match case.creepage {
        Some(parts) => Motion::from(rolling_at(parts)),
        None => Motion::forces(FORCE, 0.0),
    };
    let steps = (2.0 * WIDTHS / STEP_LENGTH).round();
    let mut points = Curve::new();
    let mut done = 0.0;
    while done < steps {
        done += 1.0;
        let rolled = roll(STEP_LENGTH, &motion)?;
        let value = match case.creepage {
            Some([_, _, chi]) if chi != 0.0 => rolled.solution.force.fy,
            Some(_) => rolled.solution.force.fx,
            None => rolled.creepage.xi(),
        };
        points.push([0.5 * rolled.distance, value]);
    }
    Ok(points)
}

fn full_curve(case: &Case) -> Result<Curve, GalleryError> {
    let mut rolling = Rolling::new(&like_bodies(1.0, STEEL)?, Resolution::STANDARD)?;
    if case.creepage.is_none() {
        rolling.shift(FORCE, 0.0)?;
    }
    curve(case, Box::new(move |length, motion| Ok(rolling.step(length, motion)?)))
}

fn chapter_5_curve(
    case: &Case,
    degree: usize,
    bound: TractionBound,
) -> Result<Curve, GalleryError> {
    let settings = Settings { bound, ..Settings::of_degree(degree) };
    let mut rolling = RollingVariational::new(&like_bodies(1.0, STEEL)?, settings)?;
    if case.creepage.is_none() {
        rolling.shift(FORCE, 0.0)?;
    }
    curve(case, Box::new(move |length, motion| Ok(rolling.step(length, motion)?)))
}

fn make() -> Result<Reproduction, GalleryError> {
    let solved: Result<Vec<(Curve, Vec<Curve>)>, GalleryError> = CASES
        .par_iter()
        .map(|case| {
            let theories = THEORIES.par_iter();
            let own = theories.map(|(_, degree, bound, _)| {
                // (5.9) alone is not held to a force: it finds no creepage for it.
                let is_free = *bound == TractionBound::Unchecked && case.creepage.is_none();
                if is_free { Ok(Curve::new()) } else { chapter_5_curve(case, *degree, *bound) }
            });
            Ok((full_curve(case)?, own.collect::<Result<Vec<_>, _>>()?))
        })
        .collect();
    let solved = solved?;
    let mut data = Data::new(["case", "theory", "contact_widths", "value"]);
    for (case, (full, own)) in CASES.iter().zip(&solved) {
        let names = ["full theory"].into_iter().chain(THEORIES.map(|(name, ..)| name));
        for (name, curve) in names.zip([full].into_iter().chain(own)) {
            for [q, value] in curve {
                data.push([case.name.into(), name.into(), (*q).into(), (*value).into()]);
            }
        }
    }
    let caption = "Circular contact, \u{3c3} = 0.28, rolled from no traction at a creepage and at a spin, and under a force that has \
        shifted the bodies. The peak is where the last of the material that was shifted leaves (proposition IV, 3). Chapter 5 with the term \u{2202}u/\u{2202}q of (4.15b), a minimum a step. With (5.9) to the letter the forces \
        grow beyond friction: nothing slips then, which makes T S zero, however large the tractions are. With the bound (5.7) kept, by the \
        least loss of power, they follow the full theory. So the last project of 6.2 works, with one thing more than (5.9).";
    let agreement = claims(&solved);
    Ok(Reproduction::figure(&sheet(&solved), caption, data, agreement))
}

fn claims(solved: &[(Curve, Vec<Curve>)]) -> Vec<Comparison> {
    let apart = |case: usize, theory: usize| farthest(&solved[case].0, &solved[case].1[theory]);
    let end = |curve: &Curve| curve.last().map_or(f64::NAN, |point| point[1]);
    let [three, six] = [0, 1].map(|theory| [0, 1].map(|case| apart(case, theory)));
    let beyond = end(&solved[0].1[2]);
    let steady = end(&solved[2].0);
    let held = [0, 1].map(|theory| {
        let late = |curve: &Curve| curve.iter().filter(|p| p[0] > 1.0).copied().collect::<Curve>();
        farthest(&late(&solved[2].0), &late(&solved[2].1[theory])) / steady
    });
    vec![
        Comparison::claim(
            "chapter 5 in unsteady rolling, bound kept, from the full theory",
            "perhaps possible that the theory of ch. 5 can be adapted",
            format!(
                "force within {:.3} and {:.3} of \u{3bc}N (\u{3be} = 0.9), {:.3} and {:.3} (\u{3c7} = 1) with M = 3 and 6",
                three[0], six[0], three[1], six[1]
            ),
            three.into_iter().chain(six).all(|off| off < 0.1),
        ),
        Comparison::claim(
            "creepage at a constant force, bound kept",
            "(proposition IV, 3)",
            format!(
                "from one contact width on within {:.0} and {:.0} % of that of the full theory with M = 3 and 6",
                100.0 * held[0],
                100.0 * held[1]
            ),
            held.iter().all(|off| *off < 0.25),
        ),
        Comparison::claim(
            "(5.9) to the letter, M = 6, \u{3be} = 0.9, after three contact widths",
            "perhaps possible that the theory of ch. 5 can be adapted",
            format!("force {beyond:.1} \u{3bc}N: beyond friction"),
            beyond < 1.0,
        )
        .because(
            "T S vanishes where nothing slips under a traction beyond its bound; from rest polynomials can stick all over",
        ),
    ]
}

fn sheet(solved: &[(Curve, Vec<Curve>)]) -> Sheet {
    let mut sheet =
        Sheet::new(ITEM.title).note(axes::setting(&[("a/b", "1"), ("\u{3c3}", "0.28")]));
    for (k, (case, (full, own))) in CASES.iter().zip(solved).enumerate() {
        let x =
            Label::new("distance rolled in contact widths, ").symbol("q").plain("/2").symbol("a");
        let y = [axes::fx(), axes::fy(), axes::xi()][k].clone();
        let top = [1.05, 0.5, 1.1][k];
        let mut panel = Panel::new(Axis::new([0.0, WIDTHS], x), Axis::new([0.0, top], y))
            .height(230.0)
            .heading(Label::new(case.name))
            .curve(full.clone(), FULL);
        for ((.., pen), curve) in THEORIES.iter().zip(own) {
            panel = panel.curve(curve.clone(), *pen);
        }
        sheet = sheet.panel(panel);
    }
    let sheet = sheet.key(FULL, Label::new("full theory"));
    THEORIES.iter().fold(sheet, |sheet, (name, .., pen)| {
        let label = name.strip_prefix("M = ").map_or_else(
            || Label::new(name),
            |rest| Label::new("chapter 5, ").symbol("M").plain(" = ").plain(rest),
        );
        sheet.key(*pen, label)
    })
}
