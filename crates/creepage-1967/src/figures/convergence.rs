//! The error of the full theory over the size of its elements.

use creepage::InvalidValue;
use creepage::coulomb::{Exact, ExactSolved, Resolution};
use creepage::{Force, Solved};
use rayon::prelude::*;

use crate::prelude::*;

pub(crate) const ITEM: Item =
    Item::new("convergence", "The full theory’s error over the size of its elements", make);

const CASES: [Case; 4] = [
    Case { name: "longitudinal", a_over_b: 1.0, at: [0.9, 0.0, 0.0] },
    Case { name: "that of Fig. 12", a_over_b: 0.5, at: [1.472_243, -0.85, 2.0] },
    Case { name: "pure spin", a_over_b: 1.0, at: [0.0, 0.0, 1.24] },
    Case { name: "spin pole inside", a_over_b: 2.0, at: [0.5, -0.5, 4.0] },
];

/// Elements along and across a circle.
const GRIDS: [[usize; 2]; 6] = [[8, 6], [12, 10], [16, 14], [22, 18], [28, 22], [36, 28]];
/// What stands for the true value.
const TRUTH: [usize; 2] = [60, 48];

struct Case {
    name: &'static str,
    a_over_b: f64,
    at: [f64; 3],
}

/// Errors of the force in parts of `mu N`, each over the size of the elements in units of `c`.
struct Errors {
    /// Of the finer of the two grids by itself.
    grid: Vec<[f64; 2]>,
    /// Extrapolated from both.
    extrapolated: Vec<[f64; 2]>,
    /// The error bar of the latter.
    bar: Vec<[f64; 2]>,
}

fn make() -> Result<Reproduction, GalleryError> {
    let errors: Vec<Errors> = CASES.par_iter().map(errors).collect::<Result<_, _>>()?;
    let mut data = Data::new(["curve", "size", "error"]);
    for (case, errors) in CASES.iter().zip(&errors) {
        data.curve(&format!("{}, one grid", case.name), &errors.grid);
        data.curve(&format!("{}, extrapolated", case.name), &errors.extrapolated);
        data.curve(&format!("{}, error bar", case.name), &errors.bar);
    }
    let caption = format!(
        "σ = 0.28. The error of (fx, fy) in per cent of μN over the mean size of an element in \
         units of c, for four cases, against {} by {} elements extrapolated. The error of one grid \
         falls about with the square of the size, as expected of its upstream differences. Two grids \
         extrapolated are better, and their error bar is above the error. The orders are slopes \
         fitted to all points. The points scatter because the edge of the area of adhesion moves \
         from element to element. Orders of one grid and of two: {}. About a point without slip \
         the traction turns round within an element or two, see the item islands: such a case is of \
         the first order. The thesis has nothing of this.",
        TRUTH[0],
        TRUTH[1],
        orders(&errors)
    );
    Ok(Reproduction::figure(&sheet(&errors), caption, data, Vec::new()))
}

fn errors(case: &Case) -> Result<Errors, InvalidValue> {
    let truth = solve(case, TRUTH)?.extrapolated;
    let off = |force: Force| (force.fx - truth.fx).hypot(force.fy - truth.fy);
    let [mut grid, mut extrapolated, mut bar] = [const { Vec::new() }; 3];
    for size in GRIDS {
        let found = solve(case, size)?;
        grid.push([found.size, off(found.grid)]);
        extrapolated.push([found.size, off(found.extrapolated)]);
        bar.push([found.size, found.bar.fx.hypot(found.bar.fy)]);
    }
    Ok(Errors { grid, extrapolated, bar })
}

struct SolvedGrids {
    size: f64,
    grid: Force,
    extrapolated: Force,
    bar: Force,
}

fn solve(case: &Case, [along, across]: [usize; 2]) -> Result<SolvedGrids, InvalidValue> {
    let theory = Exact::new(&like_bodies(case.a_over_b, STEEL)?, Resolution::new(along, across)?)?;
    let solved = theory.solve_contact(rolling_at(case.at));
    let solution = solved.solution();
    let [along, across] = theory.elements();
    let size = (std::f64::consts::PI / (along * across) as f64).sqrt();
    let grid = of_the_finer_grid(&solved);
    Ok(SolvedGrids {
        size,
        grid,
        extrapolated: solution.force,
        bar: solution.error.unwrap_or_default(),
    })
}

/// The force of the finer grid by itself: tractions over their bounds, weighted with the share of
/// the normal force.
fn of_the_finer_grid(solved: &ExactSolved) -> Force {
    let mut force = Force::default();
    for element in solved.elements() {
        force.fx += element.share * element.point.traction[0] / element.bound;
        force.fy += element.share * element.point.traction[1] / element.bound;
    }
    force
}

/// The slope of the line of least squares through the logarithms.
fn order(points: &[[f64; 2]]) -> f64 {
    let logs: Vec<_> = points.iter().map(|point| point.map(f64::ln)).collect();
    let count = logs.len() as f64;
    let mean = [0, 1].map(|i| logs.iter().map(|log| log[i]).sum::<f64>() / count);
    let moment =
        |i: usize| logs.iter().map(|log| (log[0] - mean[0]) * (log[i] - mean[i])).sum::<f64>();
    moment(1) / moment(0)
}

/// Of each case, in words.
fn orders(errors: &[Errors]) -> String {
    let words = CASES.iter().zip(errors).map(|(case, errors)| {
        let inside = errors.extrapolated.iter().zip(&errors.bar).filter(|(e, bar)| e[1] <= bar[1]);
        let [one, both] = [order(&errors.grid), order(&errors.extrapolated)];
        let (inside, all) = (inside.count(), errors.bar.len());
        format!("{}: {one:.1} and {both:.1}, {inside} of {all} errors within their bars", case.name)
    });
    words.collect::<Vec<_>>().join("; ")
}

const GRID_MARK: Mark = Mark::open(Shape::Square, "#10243a");
const FULL_MARK: Mark = Mark::full(Shape::Circle, "#c62828");

fn sheet(errors: &[Errors]) -> Sheet {
    let mut sheet = Sheet::new(ITEM.title).note(axes::force_error()).columns(2);
    for (case, errors) in CASES.iter().zip(errors) {
        sheet = sheet.panel(panel(case, errors));
    }
    sheet
        .key(OF_1967.wide(1.8), Label::new("one grid"))
        .key(FULL.wide(1.8), Label::new("extrapolated from two"))
        .key(TANGENT, Label::new("error bar"))
        .key(Pen::GUIDE, Label::new("slope 2"))
}

/// Both axes by powers of ten.
fn panel(case: &Case, errors: &Errors) -> Panel {
    let tick = |value: f64| (value.log10(), value.to_string());
    let x = Axis::new([-1.45, -0.35], Label::new("size of an element over ").symbol("c"))
        .ticks([0.05, 0.1, 0.2, 0.4].map(tick).to_vec());
    let y = Axis::new([-3.3, 1.5], Label::new("error in %"))
        .ticks([0.001, 0.01, 0.1, 1.0, 10.0].map(tick).to_vec());
    let logs = |points: &[[f64; 2]]| -> Vec<[f64; 2]> {
        points.iter().map(|[x, y]| [x.log10(), (100.0 * y).log10()]).collect()
    };
    let heading = Label::new(case.name)
        .plain(", ")
        .symbol("a")
        .plain("/")
        .symbol("b")
        .plain(" = ")
        .number(&case.a_over_b.to_string());
    let (grid, both) = (logs(&errors.grid), logs(&errors.extrapolated));
    let from = grid[0];
    let orders = [order(&errors.grid), order(&errors.extrapolated)];
    Panel::new(x, y)
        .height(250.0)
        .heading(heading)
        .curve(
            vec![[from[0] - 1.2, from[1] + 0.35 - 2.4], [from[0] + 0.2, from[1] + 0.75]],
            Pen::GUIDE,
        )
        .curve(logs(&errors.bar), TANGENT)
        .curve(grid.clone(), OF_1967.wide(1.8))
        .marks(grid, GRID_MARK)
        .curve(both.clone(), FULL.wide(1.8))
        .marks(both, FULL_MARK)
        .text([-0.4, -2.75], Anchor::End, Label::new(&format!("order {:.1}", orders[0])))
        .text([-0.4, -3.1], Anchor::End, Label::new(&format!("extrapolated {:.1}", orders[1])))
}
