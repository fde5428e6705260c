//! Positions that are followed: on a coarse grid, corrected by what a fine one added nearby.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss
)]

use std::path::Path;

use creepage_study::{
    Load, SolvedContact, SolvedWheel, SolvedWheelset, WheelsetCase, WheelsetFile, WheelsetPose,
    WheelsetVelocity,
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

    /// Against the fine grid from the same position before.
    #[test]
    fn friction_is_inside_its_error_bars(
        worn in any::<bool>(),
        y in -0.006..0.006_f64,
        yaw in -3e-3..3e-3_f64,
        steps in prop::collection::vec((-2e-5..2e-5_f64, -2e-5..2e-5_f64), 8),
    ) {
        let case = example(if worn { "worn-wheels.toml" } else { "s1002-on-uic60.toml" }, "");
        let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
        let mut stance = WheelsetPose { y, yaw, ..case.stance };
        let mut walked = solver.solve(&stance, &travel).unwrap();
        for (shift, turn) in steps {
            stance = WheelsetPose { y: stance.y + shift, yaw: stance.yaw + turn, ..stance };
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

/// A walk: its example, from and to where (mm), by what steps (um), at what yaw (mrad).
type Walk = (&'static str, [f64; 2], f64, f64);

const STRAIGHT: &str = "s1002-on-uic60.toml";
const WORN: &str = "worn-wheels.toml";
/// The first four are those with which the correction's constants were chosen.
const WALKS: [Walk; 8] = [
    (STRAIGHT, [0.0, 8.0], 10.0, 0.0),
    (STRAIGHT, [8.0, 0.0], 10.0, 3.0),
    (STRAIGHT, [0.0, 6.0], 15.0, -4.0),
    (WORN, [0.0, 8.0], 10.0, 0.0),
    (STRAIGHT, [-1.0, 1.0], 3.0, 0.0),
    (STRAIGHT, [-7.5, -3.0], 8.0, 1.5),
    (WORN, [-7.0, 3.0], 17.0, -2.0),
    ("curve-with-flange-contact.toml", [2.0, 7.0], 12.0, 5.0),
];

/// What followed positions of a walk are off by, in parts of their error bars: of all of it, or of so many pieces of five
/// steps. The fine grid's bars may be narrower, for that knows the border of adhesion.
fn off_along((name, [from, to], step, yaw): Walk, parts: usize) -> Vec<f64> {
    let case = example(name, "");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let count = (1e3 * (to - from).abs() / step) as usize;
    let at = |k: usize| {
        let y = 1e-3 * from + 1e-6 * (to - from).signum() * step * k as f64;
        WheelsetPose { y, yaw: 1e-3 * yaw, ..case.stance }
    };
    let mut off = Vec::new();
    for part in 0..parts {
        let first = part * count / parts;
        let length = if parts == 1 { count } else { 5 };
        let mut walked = solver.solve(&at(first), &travel).unwrap();
        let mut fine = walked.clone();
        for k in first + 1..=first + length {
            walked = solver.follow(&walked, &at(k), &travel).unwrap();
            fine = solver.next(&fine, &at(k), &travel).unwrap();
            if elements(&walked) < elements(&fine) {
                off.push(apart(&walked, &fine));
            }
        }
    }
    off.sort_by(f64::total_cmp);
    off
}

/// Eight walks in pieces of five steps; `CREEPAGE_WHOLE_WALKS=1 cargo test -p creepage-study --test wheelset_follow
/// walks -- --nocapture` goes all of them from end to end and prints what the guide says.
#[test]
fn followed_walks_keep_close_to_those_on_the_fine_grid() {
    let parts = if std::env::var_os("CREEPAGE_WHOLE_WALKS").is_some() { 1 } else { 8 };
    let mut all = Vec::new();
    for walk in WALKS {
        let off = off_along(walk, parts);
        let part = |part: f64| off[(part * (off.len() - 1) as f64) as usize];
        let [half, nine, most, worst] = [0.5, 0.9, 0.99, 1.0].map(part);
        println!("{walk:?}: {} followed, {half:.3} {nine:.3} {most:.3} {worst:.3}", off.len());
        // Up to a tenth in the guide, of many more positions.
        assert!(half < 0.15, "{walk:?}: {half}");
        all.extend(off);
    }
    let beyond = all.iter().filter(|off| **off > 0.5).count();
    println!("{} followed, {beyond} beyond half of the error bars", all.len());
    // One of 100 is promised: of few positions two may be.
    let each = if parts == 1 { 100 } else { 50 };
    assert!(each * beyond <= all.len(), "{beyond} of {}", all.len());
}

/// Of a walk in steps of 3 um most is followed.
#[test]
fn most_of_a_walk_is_followed() {
    const STEPS: u32 = 60;
    let case = example("s1002-on-uic60.toml", "");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let at = |step: u32| WheelsetPose { y: 3e-6 * f64::from(step), ..case.stance };
    let mut walked = solver.solve(&at(0), &travel).unwrap();
    let all = elements(&walked);
    let mut followed = 0;
    for step in 1..=STEPS {
        walked = solver.follow(&walked, &at(step), &travel).unwrap();
        followed += u32::from(2 * elements(&walked) < all);
    }
    assert!(followed > 3 * STEPS / 4, "{followed} of {STEPS}");
}

/// Beside a wheel on its flange the other slides nearly whole: the fine grid knows its friction to some 1e-4, which a coarse
/// one does not keep, and says so by a wider bar.
#[test]
fn the_flange_is_followed() {
    let case = example("s1002-on-uic60.toml", "");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let at = |y: f64| WheelsetPose { y, ..case.stance };
    let before = solver.solve(&at(6.49e-3), &travel).unwrap();
    let fine = solver.next(&before, &at(6.5e-3), &travel).unwrap();
    let followed = solver.follow(&before, &at(6.5e-3), &travel).unwrap();
    assert!(2 * elements(&followed) < elements(&fine), "not followed");
    let off = apart(&followed, &fine);
    assert!(off < 0.5, "{off}");
}

/// Where it moves on at one place, friction changes as well.
#[test]
fn other_motion_at_one_place_is_followed() {
    let case = example("s1002-on-uic60.toml", "");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let mut walked = solver.solve(&case.stance, &travel).unwrap();
    let all = elements(&walked);
    for step in 1..10 {
        let travel = WheelsetVelocity { lateral_velocity: 5e-4 * f64::from(step), ..travel };
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
        WheelsetPose { roll: Some(loaded.roll), load: Some(Load::Height(loaded.z)), ..case.stance };
    let solver = case.solver().unwrap();
    let mut walked = solver.solve(&case.stance, &travel).unwrap();
    let all = elements(&walked);
    for step in 1..4 {
        let stance = WheelsetPose { y: case.stance.y + 5e-6 * f64::from(step), ..case.stance };
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
        let stance = WheelsetPose { y: case.stance.y + step, ..case.stance };
        let forces = |solved: SolvedWheelset| {
            solved.wheels().map(|wheel| wheel.on_rail().force).collect::<Vec<_>>()
        };
        let followed = forces(solver.follow(&before, &stance, &travel).unwrap());
        assert_eq!(followed, forces(solver.next(&before, &stance, &travel).unwrap()));
    }
}
