//! What a wheelset finds for itself: its pitch rate, alone and from a position close by.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use creepage_study::{
    SolvedContact, SolvedWheel, SolvedWheelset, Stance, WheelsetCase, WheelsetFile,
};

/// S1002 on UIC 60 with 200 kN; roll and pitch rate are free.
fn case(solve: &str) -> WheelsetCase {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/wheelset");
    let text = std::fs::read_to_string(examples.join("s1002-on-uic60.toml")).unwrap();
    let text = format!("{text}\n[solve]\n{solve}\n");
    WheelsetFile::read(&text).unwrap().case(&examples).unwrap()
}

/// Moment of a contact's friction about the axle (N m), by the cross product of arm and force.
fn about_axle(contact: &SolvedContact, solved: &SolvedWheelset, radius: f64) -> f64 {
    let position = solved.position();
    let ((sin, cos), (sin_roll, cos_roll)) = (position.yaw.sin_cos(), position.roll.sin_cos());
    let axle = [-sin, cos * cos_roll, cos * sin_roll];
    let [x, y, z] = contact.reference;
    let arm = [x, y - position.y, z - (position.z - radius)];
    let (down, along) = contact.angle.sin_cos();
    let (force, own) = (contact.force, contact.force.moment);
    let on_rail = [force.longitudinal, force.lateral * along, force.lateral * down];
    let normal = [0.0, -down, along];
    let moment = |i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        arm[j] * on_rail[k] - arm[k] * on_rail[j] + own * normal[i]
    };
    (0..3).map(|i| axle[i] * moment(i)).sum()
}

/// Of what all friction could have: what is promised of a free pitch rate.
#[test]
fn friction_has_no_moment_about_the_axle() {
    for solve in ["theory = \"fastsim\"", "resolution = \"fast\""] {
        let case = case(solve);
        let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
        let radius = case.running.wheelset().radius();
        for y in [0.001, 0.0055, 0.0065] {
            let at = |y: f64| Stance { y, ..case.stance };
            let alone = solver.solve(&at(y), &travel).unwrap();
            let next = solver.next(&alone, &at(y + 1e-5), &travel).unwrap();
            for solved in [alone, next] {
                let contacts = || solved.wheels().flat_map(SolvedWheel::contacts);
                let moment: f64 = contacts().map(|one| about_axle(one, &solved, radius)).sum();
                let most: f64 = contacts().map(|one| solved.friction * one.load() * radius).sum();
                assert!(moment.abs() < 1e-5 * most, "{solve} {y}: {moment} of {most}");
            }
        }
    }
}
