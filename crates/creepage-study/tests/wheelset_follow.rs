//! Positions that are followed: by few elements, and what these lacked nearby.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use creepage_study::{
    Load, SolvedContact, SolvedWheel, SolvedWheelset, Stance, Travel, WheelsetCase, WheelsetFile,
};
use proptest::prelude::*;

fn example(name: &str, solve: &str) -> WheelsetCase {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/wheelset");
    let text = std::fs::read_to_string(examples.join(name)).unwrap();
    let text = format!("{text}\n[solve]\n{solve}\n");
    WheelsetFile::read(&text).unwrap().case(&examples).unwrap()
}

fn contacts(solved: &SolvedWheelset) -> impl Iterator<Item = &SolvedContact> {
    solved.wheels().flat_map(SolvedWheel::contacts)
}

fn elements(solved: &SolvedWheelset) -> usize {
    contacts(solved).map(|contact| contact.elements().len()).sum()
}

/// The largest difference of the horizontal forces on the rails, in parts of the error bars of `one`.
fn apart(one: &SolvedWheelset, other: &SolvedWheelset) -> f64 {
    let wheels = one.wheels().zip(other.wheels());
    let off = wheels.flat_map(|(one, other)| {
        let (one, other) = (one.on_rail(), other.on_rail());
        let bars = one.force_error.unwrap();
        [0, 1].map(|i| (one.force[i] - other.force[i]).abs() / bars[i])
    });
    off.fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Against all elements from the same position before. What is promised: inside the error bars, and these
    /// grow by half at most, beside what they change by from where all elements were solved.
    #[test]
    fn friction_is_inside_its_error_bars(
        worn in any::<bool>(),
        y in -0.006..0.006_f64,
        yaw in -3e-3..3e-3_f64,
        steps in prop::collection::vec((-2e-5..2e-5_f64, -2e-5..2e-5_f64), 8),
    ) {
        let case = example(if worn { "worn-wheels.toml" } else { "s1002-on-uic60.toml" }, "");
        let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
        let mut stance = Stance { y, yaw, ..case.stance };
        let mut walked = solver.solve(&stance, &travel).unwrap();
        for (shift, turn) in steps {
            stance = Stance { y: stance.y + shift, yaw: stance.yaw + turn, ..stance };
            let all = solver.next(&walked, &stance, &travel).unwrap();
            walked = solver.follow(&walked, &stance, &travel).unwrap();
            let apart = apart(&walked, &all);
            prop_assert!(apart < 1.0, "{} {}: {apart}", stance.y, stance.yaw);
            // Heat has no error bar: of 2600 random contacts the worst was off by 2.3 %.
            let heat = |solved| contacts(solved).filter_map(|contact| contact.dissipation).sum();
            let [own, right]: [f64; 2] = [heat(&walked), heat(&all)];
            prop_assert!((own / right - 1.0).abs() < 0.03, "{} {}: {own} {right}", stance.y, stance.yaw);
        }
    }
}

/// Of a walk in steps of 3 um most is followed.
#[test]
fn most_of_a_walk_is_followed() {
    const STEPS: u32 = 60;
    let case = example("s1002-on-uic60.toml", "");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let at = |step: u32| Stance { y: 3e-6 * f64::from(step), ..case.stance };
    let mut walked = solver.solve(&at(0), &travel).unwrap();
    let all = elements(&walked);
    let mut followed = 0;
    for step in 1..=STEPS {
        walked = solver.follow(&walked, &at(step), &travel).unwrap();
        followed += u32::from(2 * elements(&walked) < all);
    }
    assert!(followed > 3 * STEPS / 4, "{followed} of {STEPS}");
}

/// Where it moves on at one place, friction changes as well.
#[test]
fn other_motion_at_one_place_is_followed() {
    let case = example("s1002-on-uic60.toml", "");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let mut walked = solver.solve(&case.stance, &travel).unwrap();
    let all = elements(&walked);
    for step in 1..10 {
        let travel = Travel { lateral_velocity: 5e-4 * f64::from(step), ..travel };
        let expected = solver.next(&walked, &case.stance, &travel).unwrap();
        walked = solver.follow(&walked, &case.stance, &travel).unwrap();
        let apart = apart(&walked, &expected);
        assert!(apart < 1.0, "{step}: {apart}");
    }
    assert!(2 * elements(&walked) < all, "not followed");
}

/// Where height and roll are given, and only friction is to be found.
#[test]
fn a_given_height_is_followed() {
    let mut case = example("s1002-on-uic60.toml", "");
    let travel = case.travel.unwrap();
    let loaded = case.solve().unwrap().position();
    case.stance =
        Stance { roll: Some(loaded.roll), load: Some(Load::Height(loaded.z)), ..case.stance };
    let solver = case.solver().unwrap();
    let mut walked = solver.solve(&case.stance, &travel).unwrap();
    let all = elements(&walked);
    for step in 1..4 {
        let stance = Stance { y: case.stance.y + 5e-6 * f64::from(step), ..case.stance };
        let expected = solver.next(&walked, &stance, &travel).unwrap();
        walked = solver.follow(&walked, &stance, &travel).unwrap();
        let apart = apart(&walked, &expected);
        assert!(apart < 1.0, "{step}: {apart}");
    }
    assert!(2 * elements(&walked) < all, "not followed");
}

/// Too far away, by a theory that has nothing to follow, or from what was solved by such a one.
#[test]
fn what_is_not_followed_is_solved_as_next() {
    let exact = example("s1002-on-uic60.toml", "");
    let fastsim = example("s1002-on-uic60.toml", "theory = \"fastsim\"");
    for (case, from, step) in
        [(&exact, &exact, 3e-5), (&fastsim, &fastsim, 1e-5), (&exact, &fastsim, 1e-5)]
    {
        let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
        let before = from.solver().unwrap().solve(&case.stance, &travel).unwrap();
        let stance = Stance { y: case.stance.y + step, ..case.stance };
        let forces = |solved: SolvedWheelset| {
            solved.wheels().map(|wheel| wheel.on_rail().force).collect::<Vec<_>>()
        };
        let followed = forces(solver.follow(&before, &stance, &travel).unwrap());
        assert_eq!(followed, forces(solver.next(&before, &stance, &travel).unwrap()));
    }
}
