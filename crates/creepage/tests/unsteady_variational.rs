//! Chapter 5 for rolling that is not steady (6.2).
#![allow(clippy::unwrap_used)]

use creepage::coulomb::Resolution;
use creepage::unsteady::{Motion, Rolled, Rolling, RollingVariational, SavedError};
use creepage::variational::{Settings, TractionBound, Variational};
use creepage::{Contact, Creepage, Ellipse, Status, Theory};

fn contact(a_over_b: f64) -> Contact {
    Contact::new(Ellipse::from_ratio(a_over_b).unwrap(), 0.28).unwrap()
}

fn rolling(a_over_b: f64, degree: usize) -> RollingVariational {
    RollingVariational::new(&contact(a_over_b), Settings::of_degree(degree)).unwrap()
}

fn motion([xi, eta, chi]: [f64; 3]) -> Motion {
    Motion::from(Creepage::new(xi, eta, chi).unwrap())
}

fn apart(one: &Rolled, two: &Rolled) -> f64 {
    let [one, two] = [one, two].map(|rolled| rolled.solution.force);
    (one.fx - two.fx).hypot(one.fy - two.fy)
}

/// From no traction to nearly steady rolling: within what the degrees err by in steady rolling and a
/// little more on the way.
#[test]
fn forces_follow_the_full_theory() {
    let cases = [[0.9, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 1.0], [0.5, -0.3, 0.7]];
    for (degree, most) in [(3, 0.09), (6, 0.03)] {
        for parts in if degree == 3 { &cases[..] } else { &cases[..1] } {
            let mut full = Rolling::new(&contact(1.0), Resolution::FAST).unwrap();
            let mut own = rolling(1.0, degree);
            for _ in 0..5 {
                let [full, own] = [
                    full.step(0.8, &motion(*parts)).unwrap(),
                    own.step(0.8, &motion(*parts)).unwrap(),
                ];
                let off = apart(&full, &own);
                assert!(off < most, "M = {degree}, {parts:?}, q = {}: {off}", own.distance);
                assert_eq!(own.solution.status, Status::Solved);
                assert!((full.adhesion_share - own.adhesion_share).abs() < 0.15, "{own:?}");
            }
        }
    }
}

/// What has rolled for long is the steady theory with the bound kept, and steady rolling stays so.
#[test]
fn where_nothing_changes_it_is_the_steady_theory() {
    let creepage = Creepage::new(0.6, -0.4, 0.8).unwrap();
    let kept = Settings { bound: TractionBound::Kept, ..Settings::default() };
    let steady = Variational::new(&contact(0.5), kept).unwrap().solve(creepage).force;
    let mut own = rolling(0.5, 3);
    let begun = own.start_steady(&Motion::from(creepage)).unwrap();
    let on = own.step(0.3, &Motion::from(creepage)).unwrap();
    assert!(apart(&begun, &on) < 1e-3, "{begun:?} {on:?}");
    let end = rolling(0.5, 3).step(8.0, &Motion::from(creepage)).unwrap().solution.force;
    for force in [begun.solution.force, end] {
        // The steady theory takes the slip of elastic energy as it is summed over no mesh at all.
        assert!((force.fx - steady.fx).hypot(force.fy - steady.fy) < 0.01, "{force:?} {steady:?}");
    }
}

/// With half the steps the error falls, of second order: most of it is that of the first step.
#[test]
fn shorter_steps_converge() {
    let at = |steps: u32| {
        let mut own = rolling(1.0, 3);
        let mut last = None;
        for _ in 0..steps {
            last = Some(own.advance(1.0 / f64::from(steps), &motion([0.9, 0.0, 0.3])).unwrap());
        }
        last.unwrap().solution.force.fx
    };
    let [four, eight, many] = [4, 8, 64].map(at);
    assert!((eight - many).abs() < 0.6 * (four - many).abs(), "{four} {eight} {many}");
    assert!((eight - many).abs() < 0.01, "{eight} {many}");
}

/// (5.9) alone sticks all over with tractions beyond their bound: why it is kept.
#[test]
fn without_the_bound_forces_grow_beyond_friction() {
    let settings = Settings { bound: TractionBound::Unchecked, ..Settings::of_degree(6) };
    let mut own = RollingVariational::new(&contact(1.0), settings).unwrap();
    let end = own.step(4.0, &motion([0.9, 0.0, 0.0])).unwrap();
    assert!(end.solution.force.fx > 1.2, "{end:?}");
}

/// Cattaneo's and Mindlin's shift by half of friction, and its stiffness.
#[test]
fn a_shift_is_that_of_partial_slip() {
    let contact = contact(1.0);
    let shift =
        RollingVariational::new(&contact, Settings::of_degree(8)).unwrap().shift(0.5, 0.0).unwrap();
    let full = Rolling::new(&contact, Resolution::STANDARD).unwrap().shift(0.5, 0.0).unwrap();
    let ratio = shift.creepage.xi() / full.creepage.xi();
    // Polynomials below the singular traction's: stiffer by the edge that they leave out.
    assert!((ratio - 1.0).abs() < 0.05, "{ratio}");
    assert!((shift.solution.force.fx - 0.5).abs() < 1e-6);
}

/// Held forces are met, and the creepage settles within a contact width or two (proposition IV, 3).
#[test]
fn a_force_that_is_held_finds_its_creepage() {
    let (mut full, mut own) =
        (Rolling::new(&contact(1.0), Resolution::FAST).unwrap(), rolling(1.0, 6));
    let held = Motion::forces(0.5, 0.2);
    for _ in 0..4 {
        let [full, own] = [full.step(1.0, &held).unwrap(), own.step(1.0, &held).unwrap()];
        let force = own.solution.force;
        assert!((force.fx - 0.5).abs() < 1e-6 && (force.fy - 0.2).abs() < 1e-6);
        let [one, two] = [full.creepage, own.creepage];
        let off = (one.xi() - two.xi()).hypot(one.eta() - two.eta());
        assert!(off < 0.12 * one.xi().hypot(one.eta()), "{one:?} {two:?}");
    }
}

/// Goes on from a state to the last bit, and from no other contact's.
#[test]
fn a_state_is_kept() {
    let mut own = rolling(2.0, 3);
    own.step(0.7, &motion([0.4, 0.1, 0.2])).unwrap();
    let kept = own.save();
    let first = own.step(0.4, &motion([0.5, 0.1, 0.2])).unwrap();
    own.restore(&kept).unwrap();
    assert_eq!(own.step(0.4, &motion([0.5, 0.1, 0.2])).unwrap(), first);
    assert_eq!(rolling(2.0, 4).restore(&kept), Err(SavedError::OtherElements));
    assert_eq!(own.restore(&kept[1..]), Err(SavedError::NoState));
}

#[test]
fn what_it_does_not_know_is_refused() {
    let mut own = rolling(1.0, 3);
    for distance in [0.0, -1.0, f64::NAN] {
        assert!(own.step(distance, &Motion::default()).is_err());
    }
    assert!(own.step(1.0, &Motion::forces(0.9, 0.9)).is_err());
    assert!(own.shift(1.0, 0.2).is_err() && own.shift(f64::NAN, 0.0).is_err());
    // Nothing drives it: nothing comes.
    let still = own.step(1.0, &Motion::default()).unwrap();
    assert!(still.solution.force.fx == 0.0 && still.solution.status == Status::Solved);
}
