//! Free rolling of unlike bodies.

use creepage::approximate::free_rolling::FreeRolling;
use creepage::coulomb::{Constraints, Exact, Resolution};
use creepage::theory::Solved;
use creepage::{Contact, Ellipse};

use crate::support::{aluminium, contact, coupled, steel};

const NOTHING: Constraints =
    Constraints { xi: None, eta: None, chi: None, fx: Some(0.0), fy: Some(0.0), mz: Some(0.0) };

fn circle(kappa_over_mu: f64) -> Exact {
    let like = Contact::new(Ellipse::from_ratio(1.0).unwrap(), 0.25).unwrap();
    let unlike = like.with_kappa_over_mu(kappa_over_mu).unwrap();
    Exact::new(&unlike, Resolution::STANDARD).unwrap()
}

#[test]
fn without_slip_it_is_the_analytic_solution() {
    let kappa_over_mu = 1e-4;
    let analytic = FreeRolling::new(kappa_over_mu, 0.25).unwrap();
    let theory = circle(kappa_over_mu);
    let found = theory.find(NOTHING).unwrap();
    let found_over_analytic = found.creepage().xi() / analytic.creepage();
    // Twenty-two elements along a rim where the traction falls steeply.
    assert!((found_over_analytic - 1.0).abs() < 0.003, "{found_over_analytic}");
    let places = [[0.3, 0.0], [0.0, 0.5], [-0.5, 0.2], [0.4, -0.6]];
    for (place, point) in places.iter().zip(found.solved.field(&places)) {
        let r = place[0].hypot(place[1]);
        let q = analytic.traction(r);
        for k in 0..2 {
            // Of the traction at the place, or of its largest there.
            let apart = point.traction[k] - place[k] / r * q;
            assert!(apart.abs() < 0.03 * q, "{place:?}: {:?} {q}", point.traction);
        }
    }
}

#[test]
fn with_vanishing_friction_all_slips() {
    let kappa_over_mu = 300.0;
    let theory = circle(kappa_over_mu);
    let found = theory.find(NOTHING).unwrap().creepage().xi();
    let without_slip = FreeRolling::new(kappa_over_mu, 0.25).unwrap().creepage();
    let ratio = FreeRolling::RATIO * found / without_slip;
    // Elements between which the slip turns around, and friction of a three hundredth of kappa.
    assert!((ratio / 1.251_690_3 - 1.0).abs() < 0.005, "{ratio}");
}

/// Coupled bodies that roll freely: their force is zero to a twentieth of its error bar, also where friction is so small that
/// the solver's own scatter is larger than what Newton's method asks for.
#[test]
fn coupled_bodies_roll_freely() {
    for (ratio, friction) in [(0.5, 0.05), (1.0, 0.3)] {
        let contact = contact(steel(), aluminium(), ratio, friction);
        let theory = coupled(&contact, Resolution::FAST);
        let free =
            Constraints { eta: Some(0.0), chi: Some(0.0), fx: Some(0.0), ..Constraints::default() };
        let solution = theory.find(free).unwrap().solution();
        let bar = solution.error.unwrap().fx;
        assert!(
            solution.force.fx.abs() <= (0.05 * bar).max(1e-7),
            "{ratio} {friction}: {solution:?}"
        );
    }
}
