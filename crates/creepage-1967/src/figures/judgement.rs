//! Chapter 5 judged by the full theory over the catalogue of the thesis.

use std::fmt::Write;

use creepage::Force;
use creepage::coulomb::{Exact, Resolution};
use creepage::variational::{Settings, Variational};
use rayon::prelude::*;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("chapter-5", "Chapter 5 judged by the full theory over its catalogue", make);

/// (5.29): the ratios, and the spins of each.
const CATALOGUE: [(f64, [f64; 6]); 4] = [
    (2.0, [0.0, 0.5, 1.0, 2.0, 3.5, 7.0]),
    (1.0, [0.0, 0.5, 1.0, 2.0, 5.0, 10.0]),
    (0.5, [0.0, 1.0, 2.0, 3.0, 5.0, 10.0]),
    (0.2, [0.0, 0.5, 1.0, 2.0, 5.0, 10.0]),
];
/// "Variable xi and eta": sizes and directions (degrees) of the creepage.
const SIZES: [f64; 8] = [0.1, 0.2, 0.4, 0.7, 1.1, 1.7, 2.8, 5.0];
const DIRECTIONS: [f64; 5] = [-90.0, -45.0, 0.0, 45.0, 90.0];
const DEGREES: [usize; 2] = [3, 8];

/// A case, and the errors of the degrees in parts of `mu N`.
#[derive(Clone, Copy)]
struct Case {
    a_over_b: f64,
    size: f64,
    direction: f64,
    chi: f64,
    errors: [f64; 2],
}

fn make() -> Result<Reproduction, GalleryError> {
    let mut cases = Vec::new();
    for (a_over_b, spins) in CATALOGUE {
        cases.extend(of_ratio(a_over_b, &spins)?);
    }
    let mut data = Data::new(["a_over_b", "upsilon", "alpha", "chi", "error_m3", "error_m8"]);
    for case in &cases {
        let Case { a_over_b, size, direction, chi, errors: [three, eight] } = *case;
        data.push([a_over_b, size, direction, chi, three, eight].map(Into::into));
    }
    let groups = groups(&cases);
    let figure = Reproduction::figure(&sheet(&cases, &groups), caption(&cases), data, Vec::new());
    Ok(Reproduction { text: Some(table(&groups)), ..figure })
}

/// Line by line of equal direction, on all cores.
fn of_ratio(a_over_b: f64, spins: &[f64]) -> Result<Vec<Case>, GalleryError> {
    let full = Exact::new(&like_bodies(a_over_b, STEEL)?, Resolution::STANDARD)?;
    let [three, eight] = DEGREES.map(|degree| {
        Variational::new(&like_bodies(a_over_b, STEEL)?, Settings::of_degree(degree))
    });
    let theories = [three?, eight?];
    let lines: Vec<(f64, f64)> =
        spins.iter().flat_map(|chi| directions(*chi).map(|angle| (*chi, angle))).collect();
    let line = |&(chi, direction): &(f64, f64)| {
        let (sin, cos) = direction.to_radians().sin_cos();
        let creepages = SIZES.map(|size| rolling_at([size * cos, size * sin, chi]));
        let truth = full.curve(&creepages);
        let found = theories.each_ref().map(|theory| chained(theory, &creepages));
        let case = |k: usize| {
            let off =
                |force: Force| (force.fx - truth[k].force.fx).hypot(force.fy - truth[k].force.fy);
            let errors = [off(found[0][k]), off(found[1][k])];
            Case { a_over_b, size: SIZES[k], direction, chi, errors }
        };
        (0..SIZES.len()).map(case).collect::<Vec<_>>()
    };
    Ok(lines.par_iter().flat_map_iter(line).collect())
}

/// Without spin the others are mirror images.
fn directions(chi: f64) -> impl Iterator<Item = f64> {
    DIRECTIONS.into_iter().filter(move |angle| chi > 0.0 || *angle >= 0.0)
}

/// The distribution of the errors of one degree.
struct Spread {
    median: f64,
    rms: f64,
    p95: f64,
    worst: f64,
}

impl Spread {
    fn new<'a>(cases: impl Iterator<Item = &'a Case>, degree: usize) -> Self {
        let mut errors: Vec<_> = cases.map(|case| 100.0 * case.errors[degree]).collect();
        errors.sort_unstable_by(f64::total_cmp);
        let at =
            |hundredths: usize| errors.get(errors.len() * hundredths / 100).copied().unwrap_or(0.0);
        let squares = errors.iter().map(|error| error * error).sum::<f64>();
        let rms = (squares / errors.len().max(1) as f64).sqrt();
        Self { median: at(50), rms, p95: at(95), worst: errors.last().copied().unwrap_or(0.0) }
    }
}

/// Cases alike in one quantity.
struct Group {
    /// Which quantity, and its value.
    quantity: &'static str,
    value: f64,
    spreads: [Spread; 2],
}

/// What cases are told apart by.
type Quantity = fn(&Case) -> f64;

fn groups(cases: &[Case]) -> Vec<Group> {
    let by: [(&'static str, Quantity); 3] =
        [("a/b", |case| case.a_over_b), ("υ", |case| case.size), ("χ", |case| case.chi)];
    let mut groups = Vec::new();
    for (quantity, of) in by {
        let mut values: Vec<_> = cases.iter().map(of).collect();
        values.sort_unstable_by(f64::total_cmp);
        values.dedup();
        for value in values {
            let alike = || cases.iter().filter(move |case| of(case).total_cmp(&value).is_eq());
            let spreads = [0, 1].map(|degree| Spread::new(alike(), degree));
            groups.push(Group { quantity, value, spreads });
        }
    }
    groups
}

fn table(groups: &[Group]) -> String {
    let mut text = String::from(
        "error of (fx, fy) in % of mu N against the full theory\n\n             M = 3                         M = 8\n             median   rms    95 %  worst   median   rms    95 %  worst",
    );
    let mut last = "";
    for Group { quantity, value, spreads } in groups {
        if *quantity != last {
            text.push('\n');
        }
        last = quantity;
        // Writing to a String cannot fail.
        let _ = write!(text, "\n{quantity:>4} = {value:<4}");
        for Spread { median, rms, p95, worst } in spreads {
            let _ = write!(text, "  {median:6.2} {rms:6.2} {p95:6.2} {worst:6.2}");
        }
    }
    text
}

fn caption(cases: &[Case]) -> String {
    let [three, eight] = [0, 1].map(|degree| Spread::new(cases.iter(), degree));
    let circle = || cases.iter().filter(|case| (case.a_over_b - 1.0).abs() < 1e-9);
    format!(
        "{} cases of the catalogue (5.29), σ = 0.28, with W = W₁. The mesh has 10 by 10 cells for \
         M = 3, as in 1967, and 20 by 20 for M = 8. Error of (fx, fy) against the full theory: \
         median {:.1} %, 95 of 100 below {:.1} %, worst {:.1} % of μN for M = 3; {:.1}, {:.1} and \
         {:.1} % for M = 8. For the circle alone, as in the thesis (Fig. 15), M = 3 errs by \
         {:.1} % at worst, and by more than 10 % in {} of {} cases. The error is largest with \
         strong spin, where the traction turns about a point of the contact faster than \
         polynomials can follow, and smallest where all slides.",
        cases.len(),
        three.median,
        three.p95,
        three.worst,
        eight.median,
        eight.p95,
        eight.worst,
        Spread::new(circle(), 0).worst,
        circle().filter(|case| case.errors[0] > 0.1).count(),
        circle().count()
    )
}

const MARKS: [Mark; 2] =
    [Mark::open(Shape::Square, "#10243a"), Mark::full(Shape::Circle, "#8e24aa")];
const PENS: [Pen; 2] = [OF_1967, Pen { colour: "#8e24aa", dashes: "6 3", width: 2.5 }];

fn sheet(cases: &[Case], groups: &[Group]) -> Sheet {
    let mut sheet = Sheet::new("Chapter 5 judged by the full theory")
        .note(axes::force_error().plain(" over the catalogue (5.29)"))
        .columns(2)
        .panel(distribution(cases));
    for (quantity, name) in [("a/b", "ratio "), ("υ", "creepage "), ("χ", "spin ")] {
        sheet = sheet.panel(panel(
            groups.iter().filter(|group| group.quantity == quantity),
            quantity,
            name,
        ));
    }
    sheet
        .key(PENS[0], degree(0, "95 of 100 below"))
        .key(PENS[1], degree(1, "95 of 100 below"))
        .key(MARKS[0], degree(0, "median"))
        .key(MARKS[1], degree(1, "median"))
}

fn degree(which: usize, what: &str) -> Label {
    Label::default().symbol("M").plain(&format!(" = {}: {what}", DEGREES[which]))
}

/// By powers of ten.
fn errors_scale(range: [f64; 2]) -> Axis {
    let tick = |value: f64| (value.log10(), value.to_string());
    let all = [0.01, 0.1, 1.0, 10.0, 100.0].map(tick);
    let inside = all.into_iter().filter(|(at, _)| (range[0]..=range[1]).contains(at));
    Axis::new(range, Label::new("error in %")).ticks(inside.collect())
}

fn log_of(error: f64) -> f64 {
    error.max(1e-4).log10()
}

/// The share of cases below an error.
fn distribution(cases: &[Case]) -> Panel {
    let y = Axis::new([0.0, 100.0], Label::new("cases below, in %"));
    let mut panel = Panel::new(errors_scale([-2.2, 1.6]), y).height(250.0);
    for (degree, pen) in PENS.into_iter().enumerate() {
        let mut errors: Vec<_> =
            cases.iter().map(|case| log_of(100.0 * case.errors[degree])).collect();
        errors.sort_unstable_by(f64::total_cmp);
        let count = errors.len() as f64;
        let curve = errors
            .into_iter()
            .enumerate()
            .map(|(k, error)| [error, 100.0 * (k + 1) as f64 / count]);
        panel = panel.curve(curve.collect(), pen);
    }
    panel
}

/// Medians, and what 95 of 100 cases are below, for each value of a quantity in turn.
fn panel<'a>(groups: impl Iterator<Item = &'a Group>, symbol: &str, name: &str) -> Panel {
    let groups: Vec<_> = groups.collect();
    let places = groups.iter().enumerate().map(|(k, group)| (k as f64, group.value.to_string()));
    let range = [-0.4, groups.len() as f64 - 0.6];
    let x = Axis::new(range, Label::new(name).symbol(symbol)).ticks(places.collect());
    let mut panel = Panel::new(x, errors_scale([-2.2, 1.6])).height(250.0);
    for degree in 0..2 {
        let of = |what: fn(&Spread) -> f64| {
            let points = groups.iter().enumerate();
            points
                .map(|(k, group)| [k as f64, log_of(what(&group.spreads[degree]))])
                .collect::<Vec<_>>()
        };
        panel = panel
            .curve(of(|spread| spread.p95), PENS[degree])
            .marks(of(|spread| spread.median), MARKS[degree]);
    }
    panel
}
