//! What holds of rolling on any contact area: symmetries, scaling, superposition, reciprocity, order of
//! convergence.
// Tests may fail by unwrapping.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod common;

use common::creepage;
use creepage::coulomb::{NonHertzian, Resolution};
use creepage::gap::{Gap, Rectangle, Term};
use creepage::normal::{self, NormalContact};
use creepage::theory::Solved;
use creepage::{SiCreepage, Solid, SolidPair};

const FRICTION: f64 = 0.3;
const LOAD: f64 = 30e3;

/// Powers of x and y, and coefficients in metres: lopsided, skew and no ellipse.
const LOPSIDED: [(u32, u32, f64); 5] =
    [(2, 0, 1.0), (0, 2, 1.2), (1, 1, 0.7), (0, 3, 60.0), (0, 4, 4e4)];
const CASES: [[f64; 3]; 4] =
    [[0.5, 0.0, 0.0], [0.3, 0.6, 0.5], [0.0, -0.4, 2.0], [-1.5, 1.0, -0.6]];

fn steel() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

fn rolling(terms: &[(u32, u32, f64)], load: f64, resolution: Resolution) -> NonHertzian {
    let term = |&(x, y, coefficient): &(u32, u32, f64)| Term { x, y, coefficient };
    let gap = Gap::polynomial(&terms.iter().map(term).collect::<Vec<_>>()).unwrap();
    let contact = NormalContact::under_load(&gap, steel(), load, normal::Resolution::FINE).unwrap();
    NonHertzian::new(&contact, FRICTION, resolution).unwrap()
}

fn force(theory: &NonHertzian, [xi, eta, chi]: [f64; 3]) -> [f64; 3] {
    theory.solve(creepage(xi, eta, chi)).solution().force.components()
}

/// (4.28): creepage turned round turns the force round, and a mirrored area with mirrored creepage
/// has the mirrored force. Pressures are solved to 1e-6, tractions to 1e-6 of their bound.
#[test]
fn forces_have_the_symmetries_of_their_area() {
    let mirrored = LOPSIDED.map(|(x, y, h)| (x, y, if y % 2 == 1 { -h } else { h }));
    let theory = rolling(&LOPSIDED, LOAD, Resolution::STANDARD);
    let mirror = rolling(&mirrored, LOAD, Resolution::STANDARD);
    for case in CASES {
        let own = force(&theory, case);
        let turned = force(&theory, case.map(|part| -part));
        let seen = force(&mirror, [case[0], -case[1], -case[2]]);
        for k in 0..3 {
            let sign = if k == 0 { 1.0 } else { -1.0 };
            assert!((turned[k] + own[k]).abs() < 1e-6, "{case:?} {k}: {own:?} {turned:?}");
            assert!((seen[k] - sign * own[k]).abs() < 1e-5, "{case:?} {k}: {own:?} {seen:?}");
        }
    }
}

/// Bodies `k` times as large under `k^2` times the load: the same forces over `mu N`.
#[test]
fn size_does_not_matter() {
    const LARGER: f64 = 7.0;
    let scaled =
        |(x, y, h): (u32, u32, f64)| (x, y, h * LARGER.powi(1 - i32::try_from(x + y).unwrap()));
    let theory = rolling(&LOPSIDED, LOAD, Resolution::STANDARD);
    let large = rolling(&LOPSIDED.map(scaled), LOAD * LARGER * LARGER, Resolution::STANDARD);
    let ratio = large.scaling().length / theory.scaling().length;
    assert!((ratio / LARGER - 1.0).abs() < 1e-6, "{ratio}");
    for case in CASES {
        for (own, other) in force(&theory, case).into_iter().zip(force(&large, case)) {
            assert!((own - other).abs() < 1e-5, "{case:?}: {own} {other}");
        }
    }
}

/// On an area that is its own mirror image fore and aft, rolling backwards is rolling forwards, and
/// Betti's theorem makes the lateral force by spin the moment by lateral creepage turned round,
/// `C23 = -C32`, as on Kalker's ellipses. Elements know nothing of it: they break it by as much as they
/// err, less as they get finer.
#[test]
fn small_creepage_is_reciprocal() {
    let symmetric = [(2, 0, 1.0), (0, 2, 1.2), (0, 3, 60.0), (0, 4, 4e4)];
    let broken = [Resolution::STANDARD, Resolution::FINE].map(|resolution| {
        let theory = rolling(&symmetric, LOAD, resolution);
        let jacobian = theory.solve(creepage(1e-5, 1e-5, 1e-5)).jacobian().unwrap();
        let [by_spin, by_lateral] = [jacobian[1][2], jacobian[2][1]];
        println!("{by_spin} {by_lateral}");
        ((by_spin + by_lateral) / by_spin).abs()
    });
    assert!(broken[0] < 2e-3 && broken[1] < 0.5 * broken[0], "{broken:?}");
}

/// Errors fall with the elements as an order above 1.3: root mean square of the cases.
#[test]
fn forces_converge() {
    let theory = |along, across| {
        let resolution = Resolution::new(along, across).unwrap();
        rolling(&LOPSIDED, LOAD, resolution)
    };
    let best = theory(64, 52);
    let error = |along: usize, across: usize| {
        let theory = theory(along, across);
        let squares = CASES.iter().map(|&case| {
            let pairs = force(&theory, case).into_iter().zip(force(&best, case));
            pairs.map(|(own, best)| (own - best).powi(2)).sum::<f64>()
        });
        (squares.sum::<f64>() / CASES.len() as f64).sqrt()
    };
    let [coarse, fine] = [error(12, 10), error(30, 26)];
    println!("{coarse:e} {fine:e}");
    assert!(fine < coarse / 2.5_f64.powf(1.3), "{coarse} {fine}");
}

/// Two areas far apart roll as each alone, but with the creepage that the spin gives there.
#[test]
fn areas_far_apart_add_up() {
    let bumps = |centres: &'static [f64]| {
        let domain = Rectangle { x: [-0.01, 0.01], y: [-0.12, 0.12] };
        let gap = Gap::function(domain, move |x, y| {
            let bump = |centre: &f64| (x * x + (y - centre).powi(2)) / 0.8;
            centres.iter().map(bump).fold(f64::INFINITY, f64::min)
        });
        let contact =
            NormalContact::at_approach(&gap.unwrap(), steel(), 2e-5, normal::Resolution::STANDARD);
        NonHertzian::new(&contact.unwrap(), FRICTION, Resolution::STANDARD).unwrap()
    };
    let creepage = SiCreepage { longitudinal: 5e-4, lateral: 3e-4, spin: 0.02 };
    let force = |theory: &NonHertzian| {
        let solved = theory.solve(theory.scaling().creepage(creepage).unwrap());
        let force = theory.scaling().si_force(solved.solution().force);
        [force.longitudinal, force.lateral, force.moment]
    };
    let [both, one, other] =
        [&[-0.1, 0.1] as &[f64], &[-0.1], &[0.1]].map(|centres| force(&bumps(centres)));
    for k in 0..3 {
        // Areas of 6 mm at 200 mm: each feels the other's load by 6/200 of its depth.
        let (sum, size) = (one[k] + other[k], one[k].abs().max(other[k].abs()));
        assert!((both[k] - sum).abs() < 0.05 * size, "{k}: {both:?} {one:?} {other:?}");
    }
}
