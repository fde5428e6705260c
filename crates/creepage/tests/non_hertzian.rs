//! Rolling on contact areas of any shape: against Hertz's case, and cases of another program.
// Tests may fail by unwrapping and by panicking.
#![allow(clippy::panic, clippy::print_stdout, clippy::unwrap_used)]

mod common;

use common::creepage;
use creepage::coulomb::{Constraints, Exact, NonHertzian, NonHertzianSolved, Resolution};
use creepage::gap::{Gap, Rectangle, Term};
use creepage::normal::{self, NormalContact};
use creepage::theory::{Region, Solved, Status};
use creepage::{Force, Hertz, Radii, SiCreepage, Solid, SolidPair, Theory};
use serde_json::Value;

const FRICTION: f64 = 0.3;

fn steel() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

fn term(x: u32, y: u32, coefficient: f64) -> Term {
    Term { x, y, coefficient }
}

fn pressed(gap: &Gap, load: f64) -> NonHertzian {
    let contact = NormalContact::under_load(gap, steel(), load, normal::Resolution::FINE);
    NonHertzian::new(&contact.unwrap(), FRICTION, Resolution::STANDARD).unwrap()
}

/// An ellipse given as `h = A x^2 + B y^2`, against `exact` on Hertz's ellipse: within the sum of
/// the error bars.
#[test]
fn an_ellipse_is_hertzs_case() {
    for lateral in [0.04, 0.08, 0.3, 2.0] {
        let flat = f64::INFINITY;
        let [upper, lower] =
            [Radii { rolling: 0.4, lateral: flat }, Radii { rolling: flat, lateral }];
        let hertz = Hertz::new(steel(), upper, lower, 0.0, 50e3).unwrap();
        let gap = Gap::polynomial(&[term(2, 0, 0.5 / 0.4), term(0, 2, 0.5 / lateral)]).unwrap();
        let contact = hertz.with_friction(FRICTION).unwrap();
        let exact = Exact::new(&contact, Resolution::STANDARD).unwrap();
        let (theory, one) = (pressed(&gap, 50e3), contact.scaling());
        for [xi, eta, chi] in [[0.5, 0.0, 0.0], [0.3, 0.6, 0.5], [0.0, -0.4, 2.0], [2.0, 1.0, -1.0]]
        {
            let at = creepage(xi, eta, chi);
            let other = theory.scaling();
            let mut solved = theory.solve(other.creepage(one.si_creepage(at)).unwrap());
            assert_eq!(solved.solution().status, Status::Solved);
            let (here, there) = (solved.solution(), exact.solve(at));
            let moment = other.length / one.length;
            let unit = |Force { fx, fy, mz }: Force| [fx, fy, mz * moment];
            let (found, own_bar) = (unit(here.force), unit(here.error.unwrap()));
            let bar = there.error.unwrap().components();
            let expected = there.force.components();
            for k in 0..3 {
                let apart = (found[k] - expected[k]).abs();
                assert!(apart <= bar[k] + own_bar[k], "{lateral} {at:?}: {found:?} {expected:?}");
            }
            // Elements about the same, and all of the load.
            let share: f64 = solved.elements().iter().map(|element| element.share).sum();
            assert!((share - 1.0).abs() < 1e-12);
            // 6 % has been seen on ellipses, where slip areas are narrower than an element.
            let (power, dissipation) = (solved.power(), solved.dissipation().unwrap());
            assert!((power - dissipation).abs() < 0.08 * power, "{power} {dissipation}");
            let jacobian = solved.jacobian().unwrap();
            let step = 1e-5;
            let moved = creepage(
                solved.creepage().xi() + step,
                solved.creepage().eta(),
                solved.creepage().chi(),
            );
            let ahead = theory.solve(moved).solution().force.components();
            for k in 0..3 {
                let slope = (ahead[k] - here.force.components()[k]) / step;
                // Tractions of 1e-8 over the step; kinks of elements that change.
                assert!((slope - jacobian[k][0]).abs() < 0.02, "{slope} {jacobian:?}");
            }
        }
    }
}

/// From the tractions of one creepage to another: the same force as from nothing.
#[test]
fn going_on_leads_where_starting_anew_does() {
    let gap = Gap::polynomial(&[term(2, 0, 0.5 / 0.4), term(0, 2, 0.5 / 0.3)]).unwrap();
    let theory = pressed(&gap, 50e3);
    let mut solved = theory.solve(creepage(0.3, -0.2, 0.5));
    for [xi, eta, chi] in [[0.301, -0.2, 0.5], [0.5, 0.1, 0.4], [-2.0, 1.0, 0.0], [0.0; 3]] {
        let at = creepage(xi, eta, chi);
        solved.resolve_at(at, |_| [0.0; 2]);
        assert_eq!(solved.creepage(), at);
        let anew = theory.solve(at).solution();
        assert_eq!(solved.solution().status, Status::Solved);
        let pairs = solved.solution().force.components().into_iter().zip(anew.force.components());
        // Tractions obey friction to 1e-6 of their bound by either road, forces to some 5e-8.
        assert!(pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) < 2e-7, "{at:?}");
    }
}

/// From the tractions of a contact close by: the same force as from nothing, in fewer sweeps. One with other
/// elements starts from nothing, to the last bit.
#[test]
fn a_contact_close_by_leads_where_starting_anew_does() {
    let contact = |lateral: f64| {
        let gap = Gap::polynomial(&[term(2, 0, 0.5 / 0.4), term(0, 2, 0.5 / lateral)]).unwrap();
        NormalContact::under_load(&gap, steel(), 50e3, normal::Resolution::FINE).unwrap()
    };
    let theory = |lateral: f64, resolution: Resolution| {
        NonHertzian::new(&contact(lateral), FRICTION, resolution).unwrap()
    };
    let [known, close] = [0.3, 0.301].map(|lateral| theory(lateral, Resolution::STANDARD));
    let other = theory(0.301, Resolution::FAST);
    for [xi, eta, chi] in [[0.3, -0.2, 0.5], [0.1, 0.4, -2.0], [2.0, 1.0, 0.0]] {
        let at = creepage(xi, eta, chi);
        let near = known.solve(at).tractions();
        let (found, anew) = (close.solve_near(at, |_| [0.0; 2], &near), close.solve(at));
        let (found, anew) = (found.solution(), anew.solution());
        assert_eq!(found.status, Status::Solved);
        let pairs = found.force.components().into_iter().zip(anew.force.components());
        // As when it goes on from one creepage to another.
        assert!(pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) < 2e-7, "{at:?}");
        let [warm, cold] = [found, anew].map(|solution| solution.statistics.iterations);
        assert!(warm < cold, "{at:?}: {warm} {cold}");
        let found = other.solve_near(at, |_| [0.0; 2], &near).solution().force;
        assert_eq!(found, other.solve(at).solution().force);
    }
}

/// A gap in metres from one in millimetres.
fn gap_mm(half: f64, h: impl Fn(f64, f64) -> f64 + Send + Sync + 'static) -> Gap {
    let domain = Rectangle { x: [-1e-3 * half, 1e-3 * half], y: [-1e-3 * half, 1e-3 * half] };
    Gap::function(domain, move |x, y| 1e-3 * h(1e3 * x, 1e3 * y)).unwrap()
}

/// The natural cubic spline through points at steps of one.
fn natural_spline(y0: f64, values: &[f64]) -> impl Fn(f64) -> f64 + Send + Sync + 'static {
    let (n, values) = (values.len(), values.to_vec());
    // Second derivatives by elimination: m[i-1] + 4 m[i] + m[i+1] = 6 (second difference).
    let (mut factor, mut right) = (vec![0.0; n], vec![0.0; n]);
    for i in 1..n - 1 {
        let pivot = 4.0 - factor[i - 1];
        factor[i] = 1.0 / pivot;
        let difference = values[i + 1] - 2.0 * values[i] + values[i - 1];
        right[i] = (6.0 * difference - right[i - 1]) / pivot;
    }
    let mut second = vec![0.0; n];
    for i in (1..n - 1).rev() {
        second[i] = right[i] - factor[i] * second[i + 1];
    }
    move |y| {
        let k = (0..n - 2).find(|k| y < y0 + *k as f64 + 1.0).unwrap_or(n - 2);
        let t = y - y0 - k as f64;
        let cube = |t: f64| (t * t * t - t) / 6.0;
        (1.0 - t) * values[k]
            + t * values[k + 1]
            + cube(1.0 - t) * second[k]
            + cube(t) * second[k + 1]
    }
}

fn gap_of(case: &Value) -> Gap {
    match case["id"].as_str().unwrap() {
        id if id.starts_with("P1_crown_R300_R80_at_y2") => gap_mm(12.0, |x, y| {
            let beyond = (y - 2.0).max(0.0);
            let low = y.min(2.0);
            x * x / 920.0 + low * low / 600.0 + beyond * 2.0 / 300.0 + beyond * beyond / 160.0
        }),
        id if id.starts_with("P3_quartic_ellipse") => {
            gap_mm(10.0, |x, y| 2e-5 * x.powi(4) + 8e-5 * y.powi(4))
        }
        id if id.starts_with("P4_two_bumps_along_rolling") => gap_mm(10.0, |x, y| {
            let bump = |x: f64, curvature: f64| (x * x + y * y) * curvature;
            bump(x + 3.0, 1.0 / 400.0).min(bump(x - 3.0, 1.0 / 500.0) + 0.004)
        }),
        id if id.starts_with("P6_worn_flat") => {
            gap_mm(10.0, |x, y| x * x / 920.0 + y * y / 6000.0 + 0.05 * (y / 7.0).powi(8))
        }
        id if id.starts_with("P10_skew_ellipse") => {
            gap_mm(12.0, |x, y| x * x / 920.0 + x * y / 900.0 + y * y / 250.0)
        }
        id if id.starts_with("P11_tabulated_sh0") => {
            let list = |key: &str| -> Vec<f64> {
                let values = case["table"][key].as_array().unwrap();
                values.iter().map(|value| value.as_f64().unwrap()).collect()
            };
            let (y, spline) = (list("y_mm"), list("gap_mm"));
            let section = natural_spline(y[0], &spline);
            let domain = Rectangle { x: [-8e-3, 8e-3], y: [-17e-3, 11e-3] };
            Gap::function(domain, move |x, y| 1e-3 * ((1e3 * x).powi(2) / 920.0 + section(1e3 * y)))
                .unwrap()
        }
        other => panic!("{other}"),
    }
}

/// Which of the forces `[fx, fy]` over `mu N` and of the moment over `N` in mm are apart from the
/// reference by more than its uncertainty and 0.3 % of `mu N`, for the moment over 5 mm.
fn misses(
    theory: &NonHertzian,
    solved: &NonHertzianSolved,
    reference: &Value,
    case: &str,
) -> Vec<String> {
    assert_eq!(solved.solution().status, Status::Solved, "{case}");
    let found = in_print(theory, solved.solution().force);
    let tolerances = [("fx", 0.003), ("fy", 0.003), ("Mz", 0.003 * FRICTION * 5.0)];
    let missed = tolerances.into_iter().zip(found).filter(|((key, tolerance), found)| {
        let Some(best) = reference["best"][*key].as_f64() else { return false };
        let uncertainty = reference["unc"][*key].as_f64().unwrap();
        println!("{case:30} {key} {found:+.5} off {:+.5} of {uncertainty:.5}", found - best);
        (found - best).abs() > uncertainty + tolerance
    });
    missed.map(|((key, _), _)| format!("{case} {key}")).collect()
}

fn in_print(theory: &NonHertzian, Force { fx, fy, mz }: Force) -> [f64; 3] {
    [fx, fy, mz * FRICTION * 1e3 * theory.scaling().length]
}

fn reference() -> Value {
    serde_json::from_str(include_str!("data/nonelliptic.json")).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn si(row: &Value) -> SiCreepage {
    SiCreepage {
        longitudinal: row["upsilon_x"].as_f64().unwrap_or(0.0),
        lateral: number(&row["upsilon_y"]),
        spin: 1e3 * number(&row["phi_per_mm"]),
    }
}

#[test]
fn shapes_of_another_program() {
    let mut missed = Vec::new();
    let fineness = [normal::Resolution::STANDARD, normal::Resolution::FINE];
    for (case, resolution) in reference()["approach_prescribed"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(|c| fineness.map(|r| (c, r)))
    {
        let approach = 1e-3 * number(&case["approach_mm"]);
        let contact =
            NormalContact::at_approach(&gap_of(case), steel(), approach, resolution).unwrap();
        let theory = NonHertzian::new(&contact, FRICTION, Resolution::STANDARD).unwrap();
        for row in case["rolling"].as_array().unwrap() {
            let solved = theory.solve(theory.scaling().creepage(si(row)).unwrap());
            missed.extend(misses(&theory, &solved, row, case["id"].as_str().unwrap()));
        }
    }
    // Known to fall short at both: much spin and little creepage on the quartic's flat middle. f_y is
    // .4069 with 4,104 elements of ours (.4073 with 252), .0083 of mu N above the program's limit, .39863
    // +- .00381: that lies below its own two finest grids, .40169 and .40226, which rise. Square cells of
    // our own fall to .4083 at 160 a side (`creepage-study`, tests/square_grids.rs).
    assert_eq!(missed, ["P3_quartic_ellipse fy"; 2]);
}

/// A kink of curvature, a crowned roller, a quartic of revolution: the same program, five grids.
#[test]
fn more_shapes_of_another_program() {
    let arcs = |y: f64| {
        if y < -2.0 {
            4.0 / 600.0 - (2.0 / 300.0) * (y + 2.0) + (y + 2.0).powi(2) / 160.0
        } else if y > 3.0 {
            9.0 / 600.0 + (3.0 / 300.0) * (y - 3.0) + (y - 3.0).powi(2) / 60.0
        } else {
            y * y / 600.0
        }
    };
    let quartic = gap_mm(4.4, |x, y| 1e-4 * (x * x + y * y).powi(2));
    let kinked = gap_mm(7.0, move |x, y| x * x / 920.0 + arcs(y));
    let crowned = gap_mm(7.0, |x, y| x * x / 920.0 + y.powi(4) / 20_000.0);
    // Approach (um), creepage and spin (1/mm); f_x, f_y, M_z/N (mm) and their uncertainties.
    let cases = [
        (quartic, 30.0, [2e-3, 0.0, 0.0], [0.864_464, 0.0, 0.0], [3.46e-3, 5e-4, 1e-3]),
        (
            kinked,
            50.0,
            [1e-3, 0.0, 3e-4],
            [0.497_976, 0.342_488, 0.131_379],
            [2.48e-3, 3.98e-3, 1.92e-3],
        ),
        (
            crowned,
            50.0,
            [7e-4, 7e-4, -1e-4],
            [0.391_443, 0.238_926, -0.233_049],
            [3.86e-3, 9.4e-4, 1.5e-3],
        ),
    ];
    for (gap, approach, [longitudinal, lateral, spin], expected, scatter) in cases {
        let resolution = normal::Resolution::FINE;
        let contact =
            NormalContact::at_approach(&gap, steel(), 1e-6 * approach, resolution).unwrap();
        let theory = NonHertzian::new(&contact, FRICTION, Resolution::STANDARD).unwrap();
        let si = SiCreepage { longitudinal, lateral, spin: 1e3 * spin };
        let solved = theory.solve(theory.scaling().creepage(si).unwrap());
        let found = in_print(&theory, solved.solution().force);
        for k in 0..3 {
            // .3 % of mu N, for the moment over 5 mm.
            let most = scatter[k] + [0.003, 0.003, 0.003 * FRICTION * 5.0][k];
            assert!(
                (found[k] - expected[k]).abs() < most,
                "{approach} {k}: {found:?} {expected:?}"
            );
        }
    }
}

/// The load prescribed, and in two cases the longitudinal force.
#[test]
fn prescribed_forces_of_another_program() {
    for case in reference()["force_prescribed"].as_array().unwrap() {
        let theory = pressed(&gap_of(case), number(&case["N_prescribed"]));
        let start = theory.scaling().creepage(si(case)).unwrap();
        let solved = match case["fx_prescribed"].as_f64() {
            None => theory.solve(start),
            fx => {
                let (eta, chi) = (Some(start.eta()), Some(start.chi()));
                theory.find(Constraints { eta, chi, fx, ..Constraints::default() }).unwrap()
            }
        };
        let missed = misses(&theory, &solved, case, case["id"].as_str().unwrap());
        assert!(missed.is_empty(), "{missed:?}");
        if let Some(best) = case["best"]["upsilon_x"].as_f64() {
            let found = theory.scaling().si_creepage(solved.creepage()).longitudinal;
            let uncertainty = number(&case["unc"]["upsilon_x"]);
            // The force's 0.3 % over its slope.
            assert!((found - best).abs() <= uncertainty + 0.005 * best, "{found} {best}");
        }
    }
}

/// Creepage that varies as `-phi y` is the spin's part in `x`.
#[test]
fn creepage_along_y_is_as_spin() {
    let gap = Gap::polynomial(&[term(2, 0, 1.0), term(0, 2, 2.0), term(1, 1, 0.7)]).unwrap();
    let theory = pressed(&gap, 30e3);
    let spin = theory.solve(creepage(0.4, 0.2, 0.8)).solution().force.components();
    let curved = theory.solve_curved(creepage(0.4, 0.2, 0.0), |[_, y]| [-0.8 * y, 0.0]);
    let lateral = theory.solve_curved(creepage(0.4, 0.2, 0.8), |[_, y]| [0.8 * y, 0.0]);
    // Not the same, for the spin has a part in y; but the two parts change the force in proportion.
    let none = theory.solve(creepage(0.4, 0.2, 0.0)).solution().force.components();
    let [curved, lateral] = [curved, lateral].map(|s| s.solution().force.components());
    for k in 0..3 {
        let (whole, parts) = (spin[k] - none[k], curved[k] + lateral[k] - 2.0 * none[k]);
        assert!((whole - parts).abs() < 0.05, "{k} {whole} {parts}");
    }
}

/// Below the bound everywhere, at it in slip; a position off the areas is outside.
#[test]
fn fields_obey_coulomb() {
    let gap = Gap::polynomial(&[term(2, 0, 1.0), term(0, 4, 2e5), term(1, 1, 0.7)]).unwrap();
    let theory = pressed(&gap, 30e3);
    let solved = theory.solve(creepage(0.3, 0.2, 0.5));
    let elements = solved.elements();
    let positions: Vec<_> = elements.iter().map(|element| element.point.position).collect();
    for (element, point) in elements.iter().zip(solved.field(&positions)) {
        let size = element.point.traction[0].hypot(element.point.traction[1]);
        // Tractions are iterated to 1e-8 of the bound.
        assert!(size <= element.bound * (1.0 + 1e-6));
        if element.point.region == Region::Slip {
            assert!(size >= element.bound * (1.0 - 1e-6));
        }
        assert!(point.traction[0].hypot(point.traction[1]) <= 1.0 + 1e-6);
    }
    let far = solved.field(&[[10.0, 0.0], [0.0, 10.0]]);
    assert!(far.iter().all(|point| point.region == Region::Outside));
}
