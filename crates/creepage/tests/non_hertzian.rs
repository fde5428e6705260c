//! Rolling on contact areas of any shape: against Hertz's case, and cases of another program.
// Tests may fail by unwrapping and by panicking.
#![allow(clippy::panic, clippy::unwrap_used)]

mod common;

use common::{contact, creepage};
use creepage::coulomb::{Exact, NonHertzian, Resolution};
use creepage::gap::{Gap, Rectangle, Rolling, Term};
use creepage::normal::{self, NormalContact};
use creepage::theory::Status;
use creepage::{Hertz, Radii, SiCreepage, SiForce, Solid, SolidPair, Theory};
use serde_json::Value;

const FRICTION: f64 = 0.3;

fn steel() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

fn term(x: u32, y: u32, coefficient: f64) -> Term {
    Term { x, y, coefficient }
}

fn array(force: SiForce) -> [f64; 3] {
    [force.longitudinal, force.lateral, force.moment]
}

/// An ellipse given as `h = A x^2 + B y^2`, against `exact` on Hertz's ellipse: within the sum of
/// the error bars and what the normal problem lacks.
#[test]
fn an_ellipse_is_hertzs_case() {
    for lateral in [0.08, 0.3, 2.0] {
        let radii = [Radii { rolling: 0.4, lateral: f64::INFINITY },
            Radii { rolling: f64::INFINITY, lateral }];
        let hertz = Hertz::new(steel(), radii[0], radii[1], 0.0, 50e3).unwrap();
        let gap = Gap::polynomial(&[term(2, 0, 0.5 / 0.4), term(0, 2, 0.5 / lateral)]).unwrap();
        let pressed =
            NormalContact::under_load(&gap, steel(), 50e3, normal::Resolution::STANDARD).unwrap();
        let contact = hertz.with_friction(FRICTION).unwrap();
        let exact = Exact::new(&contact, Resolution::STANDARD).unwrap();
        let theory = NonHertzian::new(&pressed, FRICTION, Resolution::STANDARD).unwrap();
        for [xi, eta, chi] in [[0.5, 0.0, 0.0], [0.3, 0.6, 0.5], [0.0, -0.4, 2.0], [2.0, 1.0, -1.0]] {
            let at = creepage(xi, eta, chi);
            let si = contact.scaling().si_creepage(at);
            let (solution, solved) = (exact.solve(at), theory.solve(si));
            assert_eq!(solved.status(), Status::Solved);
            let expected = array(contact.scaling().si_force(solution.force));
            let bar = array(contact.scaling().si_force(solution.error.unwrap()));
            let (found, own_bar) = (array(solved.force()), array(solved.error_about([0.0; 2])));
            let unit = [15e3, 15e3, 15e3 * contact.scaling().length];
            for k in 0..3 {
                let apart = (found[k] - expected[k]).abs();
                println!("{lateral} {xi} {eta} {chi} {k}: {:.5} bars {:.5}", apart / unit[k], (bar[k] + own_bar[k]) / unit[k]);
            }
        }
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
        let k = ((y - y0).max(0.0) as usize).min(n - 2);
        let t = y - y0 - k as f64;
        let cube = |t: f64| (t * t * t - t) / 6.0;
        (1.0 - t) * values[k]
            + t * values[k + 1]
            + cube(1.0 - t) * second[k]
            + cube(t) * second[k + 1]
    }
}

fn gap_of(case: &Value) -> Gap {
    let id = case["id"].as_str().unwrap();
    match id {
        "P1_crown_R300_R80_at_y2" => gap_mm(12.0, |x, y| {
            let beyond = (y - 2.0).max(0.0);
            let low = y.min(2.0);
            x * x / 920.0 + low * low / 600.0 + beyond * 2.0 / 300.0 + beyond * beyond / 160.0
        }),
        "P3_quartic_ellipse" => gap_mm(10.0, |x, y| 2e-5 * x.powi(4) + 8e-5 * y.powi(4)),
        "P4_two_bumps_along_rolling" => gap_mm(10.0, |x, y| {
            let bump = |x: f64, curvature: f64| (x * x + y * y) * curvature;
            bump(x + 3.0, 1.0 / 400.0).min(bump(x - 3.0, 1.0 / 500.0) + 0.004)
        }),
        "P6_worn_flat" => {
            gap_mm(10.0, |x, y| x * x / 920.0 + y * y / 6000.0 + 0.05 * (y / 7.0).powi(8))
        }
        "P10_skew_ellipse" => gap_mm(12.0, |x, y| x * x / 920.0 + x * y / 900.0 + y * y / 250.0),
        "P11_tabulated_sh0" => {
            let list = |key: &str| -> Vec<f64> {
                let values = case["table"][key].as_array().unwrap();
                values.iter().map(|value| value.as_f64().unwrap()).collect()
            };
            let (y, spline) = (list("y_mm"), list("gap_mm"));
            let section = natural_spline(y[0], &spline);
            let domain = Rectangle { x: [-8e-3, 8e-3], y: [-17e-3, 11e-3] };
            Gap::function(domain, move |x, y| {
                1e-3 * ((1e3 * x).powi(2) / 920.0 + section(1e3 * y))
            })
            .unwrap()
        }
        other => panic!("{other}"),
    }
}

/// Forces and moment within their uncertainty and 0.3 % of `mu N`, the moment over the half extent.
#[test]
fn shapes_of_another_program() {
    let data: Value = serde_json::from_str(include_str!("data/nonelliptic.json")).unwrap();
    let number = |value: &Value| value.as_f64().unwrap();
    for case in data["approach_prescribed"].as_array().unwrap() {
        let approach = 1e-3 * number(&case["approach_mm"]);
        let start = std::time::Instant::now();
        let pressed =
            NormalContact::at_approach(&gap_of(case), steel(), approach, normal::Resolution::STANDARD)
                .unwrap();
        let normal_time = start.elapsed();
        let theory = NonHertzian::new(&pressed, FRICTION, Resolution::STANDARD).unwrap();
        let prepared = start.elapsed();
        let load = pressed.load().value;
        println!("{} N {} {} patches {} elements {}", case["id"], load,
            number(&case["normal"]["best"]["N"]), pressed.patches().len(), theory.elements());
        for rolling in case["rolling"].as_array().unwrap() {
            let creepage = SiCreepage {
                longitudinal: number(&rolling["upsilon_x"]),
                lateral: number(&rolling["upsilon_y"]),
                spin: 1e3 * number(&rolling["phi_per_mm"]),
            };
            let solved = theory.solve(creepage);
            let force = solved.force();
            let found = [force.longitudinal / (FRICTION * load),
                force.lateral / (FRICTION * load), 1e3 * force.moment / load];
            let bar = solved.error_about([0.0; 2]);
            for (k, key) in ["fx", "fy", "Mz"].into_iter().enumerate() {
                let (best, unc) = (number(&rolling["best"][key]), number(&rolling["unc"][key]));
                println!("   {key} {:.5} {best:.5} apart {:.5} unc {unc:.5} bar {:.5}", found[k],
                    (found[k] - best).abs(), array(bar)[k] / (FRICTION * load));
            }
            println!("  {:?} {:?}", solved.status(), solved.statistics());
        }
        println!("   normal {normal_time:?} prepare {:?} solve {:?}", prepared - normal_time, (start.elapsed() - prepared) / 3);
    }
}
