//! The tubes of constant creepage in the space of forces and spin (5.29), cut along.

use creepage::Creepage;
use creepage::coulomb::{Exact, Resolution};
use creepage::variational::{Start, Weight};
use rayon::prelude::*;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("tubes", "Tubes of constant creepage over force and spin, section 5.33", make);

/// Sizes of the creepage, and their pens.
const SIZES: [(f64, Pen); 3] = [(0.3, SECOND), (0.9, FULL), (1.7, THIRD)];
const PURE_SPIN: Pen = Pen::OUTLINE;

/// The tubes of one ratio, cut by their plane of symmetry `fx = 0`.
struct Cut {
    a_over_b: f64,
    pure_spin: Curve,
    /// For each size `fy` at `eta = upsilon` and at `eta = -upsilon`, over the spin.
    walls: Vec<[Curve; 2]>,
    /// Half the width along `fx`, at `xi = upsilon`, of the middle size.
    across: Curve,
    /// By chapter 5, at the spins of the catalogue.
    of_1967: Vec<[f64; 2]>,
}

fn spins() -> Vec<f64> {
    // Denser where the forces change most.
    spaced(0.0, 1.0, 40).into_iter().map(|s| 10.0 * s.powf(1.6)).collect()
}

impl Cut {
    fn new(a_over_b: f64, catalogue: &[f64]) -> Result<Self, GalleryError> {
        let exact = Exact::new(&like_bodies(a_over_b, STEEL)?, Resolution::STANDARD)?;
        let line = |[xi, eta]: [f64; 2]| -> Vec<creepage::Force> {
            let creepages: Vec<_> = spins().iter().map(|chi| rolling_at([xi, eta, *chi])).collect();
            exact.curve(&creepages).iter().map(|found| found.force).collect()
        };
        let lateral = |eta: f64| points(&spins(), &line([0.0, eta]), |force| force.fy);
        Ok(Self {
            a_over_b,
            pure_spin: lateral(0.0),
            walls: SIZES.map(|(size, _)| [lateral(size), lateral(-size)]).to_vec(),
            across: points(&spins(), &line([SIZES[1].0, 0.0]), |force| force.fx),
            of_1967: of_1967(a_over_b, catalogue)?,
        })
    }

    /// Half the height of a tube along `fy`.
    fn half(&self, size: usize) -> Vec<f64> {
        let [above, below] = &self.walls[size];
        above.iter().zip(below).map(|(above, below)| 0.5 * (above[1] - below[1])).collect()
    }
}

/// Chapter 5 at the spins of the catalogue.
fn of_1967(a_over_b: f64, catalogue: &[f64]) -> Result<Vec<[f64; 2]>, GalleryError> {
    let theory = chapter_5(a_over_b, STEEL, 3, Weight::Elliptic)?;
    let walls = SIZES.iter().flat_map(|(size, _)| [*size, -*size]);
    let cases = walls.flat_map(|eta| catalogue.iter().map(move |chi| [0.0, eta, *chi]));
    let solve = |creepage: Creepage| {
        let force = theory.solve_from(creepage, &Start::FullSliding).solution.force;
        [creepage.chi(), force.fy]
    };
    Ok(cases.map(rolling_at).map(solve).collect())
}

fn make() -> Result<Reproduction, GalleryError> {
    let cuts = CATALOGUE
        .par_iter()
        .map(|(a_over_b, catalogue)| Cut::new(*a_over_b, catalogue))
        .collect::<Result<Vec<_>, _>>()?;
    let mut data = Data::new(["curve", "a/b", "upsilon", "chi", "fy"]);
    for cut in &cuts {
        data.points("full theory", &[cut.a_over_b, 0.0], &cut.pure_spin);
        for ((size, _), [above, below]) in SIZES.iter().zip(&cut.walls) {
            data.points("full theory", &[cut.a_over_b, *size], above);
            data.points("full theory", &[cut.a_over_b, -size], below);
        }
        let rows = cut.of_1967.chunks(cut.of_1967.len() / (2 * SIZES.len()));
        let sizes = SIZES.iter().flat_map(|(size, _)| [*size, -*size]);
        for (size, row) in sizes.zip(rows) {
            data.points("M = 3", &[cut.a_over_b, size], row);
        }
    }
    let caption = "σ = 0.28. Surfaces of constant creepage υ in the space of f_x, f_y and χ, cut by their \
        plane of symmetry f_x = 0. Above the pure spin of Fig. 23 is the wall η = υ, below it the \
        wall η = −υ. υ negative in the data is the lower wall. The circles are chapter 5 with M = 3, W = W₁ at the \
        spins of the catalogue (5.29).";
    Ok(Reproduction::figure(&sheet(&cuts), caption, data, claims(&cuts)))
}

fn claims(cuts: &[Cut]) -> Vec<Comparison> {
    let (mut nested, mut shrinks, mut round) = (true, true, Vec::new());
    for cut in cuts {
        let halves = [0, 1, 2].map(|size| cut.half(size));
        nested &=
            (0..spins().len()).all(|k| halves[0][k] < halves[1][k] && halves[1][k] < halves[2][k]);
        shrinks &= halves[1].windows(2).all(|pair| pair[1] < pair[0] + 1e-3);
        let ratios = halves[1].iter().zip(&cut.across).map(|(half, across)| half / across[1]);
        round
            .push(ratios.fold([f64::INFINITY, 0.0], |[low, high], ratio| {
                [low.min(ratio), high.max(ratio)]
            }));
    }
    let one = |(cut, [low, high]): (&Cut, &[f64; 2])| {
        format!("{low:.2} to {high:.2} for a/b = {}", cut.a_over_b)
    };
    let words: Vec<_> = cuts.iter().zip(&round).map(one).collect();
    let yes = |holds: bool| if holds { "at all spins up to 10" } else { "not at all spins" };
    vec![
        Comparison::claim(
            "tubes of larger υ",
            "lie around those of smaller",
            format!("{}, for υ = 0.3, 0.9, 1.7", yes(nested)),
            nested,
        ),
        Comparison::claim(
            "radius of the tube, four ellipses, υ = 0.9",
            "decreases as |χ| increases",
            yes(shrinks),
            shrinks,
        )
        .because("between two neighbouring spins it grows by more than 0.001"),
        Comparison::claim(
            "cross-section of the tube, υ = 0.9",
            "roughly circular",
            format!("height over width {}", words.join("; ")),
            // An ellipse of 3 to 4 is one to the eye.
            round.iter().all(|[low, high]| *low > 0.75 && *high < 1.0 / 0.75),
        )
        .because(
            "“roughly” has no number in the thesis; with spin the tubes of a/b = 2 and 1 become \
            lower than they are wide, that of a/b = 0.2 higher",
        ),
    ]
}

fn sheet(cuts: &[Cut]) -> Sheet {
    let mut sheet = Sheet::new(ITEM.title).columns(2);
    for cut in cuts {
        let heading = Label::default().symbol("a/b").plain(" = ");
        let (x, y) = (Axis::new([0.0, 10.0], axes::chi()), Axis::new([-1.02, 1.02], axes::fy()));
        let mut panel = Panel::new(x, y)
            .height(260.0)
            .heading(heading.number(&cut.a_over_b.to_string()))
            .curve(cut.pure_spin.clone(), PURE_SPIN);
        for ((_, pen), walls) in SIZES.iter().zip(&cut.walls) {
            panel = panel.curves(walls, *pen);
        }
        sheet = sheet.panel(panel.marks(cut.of_1967.clone(), PRINTED));
    }
    for (size, pen) in SIZES {
        sheet = sheet.key(pen, Label::default().symbol("υ").plain(" = ").number(&size.to_string()));
    }
    sheet
        .key(PURE_SPIN, Label::default().symbol("υ").plain(" = 0: pure spin"))
        .key(PRINTED, axes::degree(3))
}
