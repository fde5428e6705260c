//! The full theory between unlike bodies: the pressure adds to the slip (6.4).

use std::f64::consts::PI;

use creepage::Ellipse;
use creepage::coulomb::{Automatic, Constraints, Exact, Resolution};
use creepage::halfspace::{DisplacementField, Edge, Polynomial, Traction};
use creepage::theory::Solved;
use creepage::{Contact, Creepage, Force, Region, Status, Theory};
use proptest::prelude::*;

use crate::common::at;
use crate::support::{self, components, exact, solve};

fn unlike(ratio: f64, poisson: f64, resolution: Resolution, kappa_over_mu: f64) -> Exact {
    Exact::new(&support::unlike(ratio, poisson, kappa_over_mu), resolution).unwrap()
}

#[test]
fn like_bodies_are_a_case_of_unlike_ones_to_the_bit() {
    let like = exact(0.7, 0.3, Resolution::FAST);
    let same = unlike(0.7, 0.3, Resolution::FAST, 0.0);
    for case in [[0.4, 0.0, 0.0], [-0.3, 0.5, 1.2], [0.0, 0.0, -2.0], [1e3, -1.0, 3.0]] {
        assert_eq!(solve(&like, case), solve(&same, case));
    }
}

/// Creepage over `kappa/mu` at which a slender contact rolls freely, everything adhering.
fn free_rolling(ratio: f64, poisson: f64) -> f64 {
    // No element slides yet, and the force is linear in both.
    let small = 1e-7;
    let by_pressure = solve(&unlike(ratio, poisson, Resolution::FINE, small), [0.0; 3]).force.fx;
    let like = exact(ratio, poisson, Resolution::FINE);
    -by_pressure / solve(&like, [small, 0.0, 0.0]).force.fx
}

/// `mu c / rho` over `mu` times the peak pressure over `G`, (4.20), for a slender contact.
fn slip_unit(ratio: f64, poisson: f64) -> f64 {
    (1.0 - poisson) / (2.0 * ratio.sqrt())
}

/// Small kappa, everything adheres, and every strip of a slender contact is plane: a traction that
/// begins with zero at the leading edge has as force the integral of the slip times
/// `((l + x)/(l - x))^(1/2)`, which for the creepage is `pi l`. The slip by the pressure is taken
/// from the quadrature over chords.
#[test]
fn slender_unlike_bodies_roll_freely_with_creepage() {
    let (ratio, poisson, count) = (1.0 / 64.0_f64, 0.3, 40);
    let (ellipse, none) = (Ellipse::from_ratio(ratio).unwrap(), Polynomial::zero(0));
    let one = Polynomial::new(vec![1.0]).unwrap();
    let hertz = Traction::new(ellipse, Edge::Vanishing, [&none, &none, &one]).unwrap();
    let slope = hertz.x_derivative().unwrap();
    let [unlike, like] =
        [0.5, 0.0].map(|kappa| DisplacementField::new(&slope, poisson, kappa).unwrap());
    let angle = |k: usize| PI * (k as f64 + 0.5) / count as f64;
    let (mut by_pressure, mut by_creepage) = (0.0, 0.0);
    for (j, i) in (0..count).flat_map(|j| (0..count).map(move |i| (j, i))) {
        // `y = b cos`, `l = a sin`, `dy = b sin`; `x = l cos`, its weight `l (1 + cos)`.
        let ((sin, cos), (_, along)) = (angle(j).sin_cos(), angle(i).sin_cos());
        let at = [ellipse.a() * sin * along, ellipse.b() * cos];
        let weight = sin * sin * (1.0 + along);
        by_pressure += weight * (unlike.at(at)[0] - like.at(at)[0]) / 0.5;
        by_creepage += weight;
    }
    let strips = -by_pressure / by_creepage / slip_unit(ratio, poisson);
    let found = free_rolling(ratio, poisson);
    // Sixteen elements along resolve adhesion to a few tenths of a per cent.
    assert!((found / strips - 1.0).abs() < 0.005, "{found} {strips}");
}

/// In the limit the slip by the pressure is that of cylinders too, `-2 kappa Z / G`; on a strip the
/// root has the weight `2 l` against the creepage's `pi l`, and its factor goes as `l`: over all
/// strips `xi = (4/pi) kappa f00 int l^2 dy / int l dy`. What lacks is of order `a/b ln(b/a)`.
#[test]
fn ever_more_slender_bodies_tend_to_cylinders() {
    let [coarse, fine] = [1.0 / 16.0, 1.0 / 64.0].map(|ratio| {
        let cylinders = 4.0 / PI * (2.0 / 3.0) / (PI / 4.0) / slip_unit(ratio, 0.3);
        1.0 - free_rolling(ratio, 0.3) / cylinders
    });
    assert!(fine > 0.0 && fine < 0.05 && fine < coarse / 2.0, "{coarse} {fine}");
}

/// The mirror that the solver uses changes where a creepage or the spin changes its sign; the
/// solution must not.
#[test]
fn nothing_jumps_where_the_mirror_changes() {
    let theory = unlike(1.4, 0.3, Resolution::FAST, 0.2);
    let places = [[0.3, 0.2], [-0.6, 0.4], [-0.2, -0.5], [0.8, -0.1]];
    for (base, axis) in [([0.0, 0.4, 0.9], 0), ([0.5, 0.3, 0.0], 2), ([0.3, 0.0, 0.0], 1)] {
        let [above, below] = [1e-8, -1e-8].map(|step| {
            let mut case = base;
            case[axis] = step;
            let solved = theory.solve_contact(at(case));
            (components(solved.solution().force), solved.field(&places))
        });
        // Tractions are iterated to 1e-8 and change by as much as the creepage.
        for k in 0..3 {
            assert!((above.0[k] - below.0[k]).abs() < 1e-6, "{base:?}: {above:?} {below:?}");
        }
        for (above, below) in above.1.iter().zip(&below.1) {
            for k in 0..2 {
                assert!((above.traction[k] - below.traction[k]).abs() < 1e-5, "{base:?}");
            }
        }
    }
}

/// Where rigid slip is thousand times as large, the pressure's slip turns no traction.
#[test]
fn full_sliding_is_that_of_like_bodies() {
    for case in [[8e3, 0.0, 0.0], [3e3, -4e3, 0.0], [0.0, 0.0, 2e4]] {
        let like = solve(&exact(1.3, 0.28, Resolution::FAST), case).force;
        let found = solve(&unlike(1.3, 0.28, Resolution::FAST, 0.3), case).force;
        for (found, like) in components(found).into_iter().zip(components(like)) {
            // Near the pole of the spin slip is small: an area of a thousandth.
            assert!((found - like).abs() < 1e-3, "{case:?} {found} {like}");
        }
    }
}

/// Very unlike bodies with little friction: the pressure's slip alone makes everything slide, and
/// the traction has its direction, inwards in the lower body for `kappa > 0`.
#[test]
fn very_unlike_bodies_slide_all_over() {
    let theory = unlike(1.0, 0.25, Resolution::STANDARD, 1e3);
    let solved = theory.solve_contact(Creepage::default());
    assert_eq!(solved.solution().status, Status::Solved);
    assert!(solved.elements().iter().all(|e| e.point.region == Region::Slip));
    // On the axis, in the middle, `d u / d x = -kappa f00`.
    let [x, y] = solved.field(&[[0.0, 0.0]])[0].slip;
    let slip_unit = (1.0 - 0.25) * PI / 4.0;
    // Elastic slip by tractions is a thousandth; interpolation between elements the rest.
    assert!((x * slip_unit / 1e3 + 1.0).abs() < 0.01 && y.abs() < 1.0, "{x} {y}");
}

/// Force times creepage and the power of the tractions on the pressure's slip make the heat.
#[test]
fn both_powers_agree() {
    for (ratio, kappa_over_mu) in [(0.3, 0.4), (1.0, 0.5), (1.0, -0.5), (4.0, -0.3)] {
        let theory = unlike(ratio, 0.28, Resolution::FINE, kappa_over_mu);
        for case in [[0.0, 0.0, 0.0], [0.5, 0.3, 1.0], [-1.0, -1.0, 2.0], [2.0, 0.5, 0.3]] {
            let found = solve(&theory, case);
            let apart = (found.power - found.dissipation).abs();
            assert!(found.dissipation > 0.0);
            // As for like bodies; without creepage twice that is seen.
            assert!(apart < 0.004 * found.power, "{ratio} {case:?} {found:?}");
        }
    }
}

/// Central differences of step 1e-5, away from kinks: their error is of order 1e-6.
#[test]
fn the_derivative_is_that_of_the_force() {
    let theory = unlike(0.8, 0.28, Resolution::FAST, -0.3);
    let (case, step) = ([-0.4, 0.3, 0.5], 1e-5);
    let derivative = theory.jacobian(at(case)).unwrap();
    for k in 0..3 {
        let [ahead, behind] = [step, -step].map(|step| {
            let mut moved = case;
            moved[k] += step;
            components(solve(&theory, moved).force)
        });
        for i in 0..3 {
            let slope = (ahead[i] - behind[i]) / (2.0 * step);
            // Tractions of 1e-8 over the step.
            assert!((slope - derivative[i][k]).abs() < 2e-3, "{i} {k} {slope} {derivative:?}");
        }
    }
}

/// As for like bodies: the bar of the fast resolution against the fine one is made for 95 %.
#[test]
fn the_error_bar_holds() {
    let (mut inside, mut all) = (0, 0);
    for (ratio, kappa_over_mu) in [(0.2, 0.5), (0.6, -0.3), (1.0, 0.2), (1.7, 1.0), (5.0, 0.4)] {
        let [fast, fine] = [Resolution::FAST, Resolution::FINE]
            .map(|resolution| unlike(ratio, 0.25, resolution, kappa_over_mu));
        for k in 0..20 {
            let t = f64::from(k) + ratio;
            let case = [3.0 * (1.3 * t).sin(), 3.0 * (2.1 * t).cos(), 8.0 * (0.7 * t).sin()];
            let (found, truth) = (solve(&fast, case), solve(&fine, case));
            let [value, truth, bar] = [found.force, truth.force, found.error].map(components);
            for i in 0..3 {
                all += 1;
                inside += usize::from((value[i] - truth[i]).abs() <= bar[i]);
            }
        }
    }
    assert!(inside * 100 >= all * 95, "{inside} of {all}");
}

#[test]
fn finer_levels_know_of_the_dissimilarity() {
    let automatic = Automatic::new(&support::unlike(1.0, 0.28, 0.4), 0.002).unwrap();
    let creepage = at([0.3, 0.2, 0.6]);
    let solved = automatic.solve_contact(creepage);
    assert!(solved.theory().elements()[0] > 14);
    let (found, fine) = (
        solved.solution().force,
        solve(&unlike(1.0, 0.28, Resolution::FINE, 0.4), [0.3, 0.2, 0.6]).force,
    );
    assert!((found.fx - fine.fx).abs() < 0.002, "{found:?} {fine:?}");
    assert!((automatic.solve(creepage).force.fy - fine.fy).abs() < 0.002);
}

/// A prescribed force is found for whatever `kappa/mu` is accepted: free rolling creeps the more the
/// more dissimilar bodies are.
#[test]
fn any_dissimilarity_rolls_freely_at_some_creepage() {
    for kappa_over_mu in [0.1, 10.0, 1e3, 1e5, -1e6] {
        let theory = unlike(1.0, 0.3, Resolution::FAST, kappa_over_mu);
        let free =
            Constraints { fx: Some(0.0), eta: Some(0.0), chi: Some(0.0), ..Constraints::default() };
        let found = theory.find(free).unwrap();
        assert!(found.solution().force.fx.abs() < 1e-6);
        let over = found.creepage().xi() / kappa_over_mu;
        assert!(over > 0.1 && over < 10.0, "{kappa_over_mu} {over}");
    }
}

#[test]
fn senseless_dissimilarity_is_refused() {
    let like = Contact::new(Ellipse::from_ratio(1.0).unwrap(), 0.3).unwrap();
    for kappa_over_mu in [f64::NAN, f64::INFINITY, 1e9] {
        assert!(like.clone().with_kappa_over_mu(kappa_over_mu).is_err());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Exchange of the bodies, seen from the other side of the contact: `x` stays the rolling
    /// direction, `y` and the tractions turn about.
    #[test]
    fn exchange_of_the_bodies(
        ratio in (-1.9..1.8_f64).prop_map(f64::exp),
        [xi, eta, chi] in [-3.0..3.0_f64, -3.0..3.0_f64, -8.0..8.0_f64],
        kappa_over_mu in -1.0..1.0_f64,
    ) {
        let there = solve(&unlike(ratio, 0.3, Resolution::FAST, kappa_over_mu), [xi, eta, chi]);
        let back = solve(&unlike(ratio, 0.3, Resolution::FAST, -kappa_over_mu), [-xi, eta, chi]);
        let Force { fx, fy, mz } = there.force;
        let pairs = [(back.force.fx, -fx), (back.force.fy, fy), (back.force.mz, mz)];
        for (back, there) in pairs {
            prop_assert!((back - there).abs() < 1e-10);
        }
        let mirrored = solve(&unlike(ratio, 0.3, Resolution::FAST, kappa_over_mu), [xi, -eta, -chi]);
        let pairs = [(mirrored.force.fx, fx), (mirrored.force.fy, -fy), (mirrored.force.mz, -mz)];
        for (mirrored, there) in pairs {
            prop_assert!((mirrored - there).abs() < 1e-10);
        }
    }

    /// Whatever is asked, an answer comes: solved, finite, and no more than full friction.
    #[test]
    fn every_case_is_solved(
        ratio in (-3.9..3.9_f64).prop_map(f64::exp),
        poisson in 0.0..0.5_f64,
        size in (-9.0..6.9_f64).prop_map(f64::exp),
        cases in prop::collection::vec([-2.0..2.0_f64, -2.0..2.0_f64, -5.0..5.0_f64], 10),
    ) {
        let theory = unlike(ratio, poisson, Resolution::FAST, size);
        for case in cases {
            let found = solve(&theory, case);
            prop_assert_eq!(found.status, Status::Solved, "{:?}", case);
            // Rounding.
            prop_assert!(found.force.magnitude() <= 1.0 + 1e-12);
        }
    }
}
