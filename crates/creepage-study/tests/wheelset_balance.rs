//! What a wheelset finds for itself: height, roll and pitch rate, alone and from positions close by.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use creepage_study::{
    Drive, Load, SolvedContact, SolvedWheel, SolvedWheelset, WheelsetCase, WheelsetFile,
    WheelsetPose, WheelsetVelocity, wheelset_caution_words,
};

/// S1002 on UIC 60 with 200 kN; roll and pitch rate are free.
fn case(solve: &str) -> WheelsetCase {
    example("s1002-on-uic60.toml", solve)
}

fn example(name: &str, solve: &str) -> WheelsetCase {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/wheelset");
    let text = std::fs::read_to_string(examples.join(name)).unwrap();
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
            let at = |y: f64| WheelsetPose { y, ..case.stance };
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

/// Where a pressure has two states, some tenths of a per cent apart, no height carries the load exactly: the nearest one within
/// its error bar is the answer.
#[test]
fn a_load_between_two_states_is_met_within_its_bar() {
    let case = case("resolution = \"fast\"");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let load = 65253.265;
    let pose = WheelsetPose {
        y: 4.730_425_53e-4,
        yaw: -5.703_478_22e-3,
        load: Some(Load::Axle(load)),
        ..case.stance
    };
    let solved = solver.solve(&pose, &travel).unwrap();
    for wheel in solved.wheels() {
        let (on_rail, missed) = (wheel.on_rail(), wheel.on_rail().force[2] - 0.5 * load);
        // The states are four thousandths apart.
        let bar = on_rail.force_error.unwrap()[2].max(1e-4 * load);
        assert!(missed.abs() < bar.min(5e-4 * load), "{missed} {bar}");
        // The wheel says so itself.
        assert!((wheel.missed_load - missed).abs() < 1e-9 * load, "{missed} {}", wheel.missed_load);
    }
    assert_eq!(wheelset_caution_words(&solved), Vec::<String>::new());
}

/// Where rails dip normals lean along the track: a longitudinal force that is asked for is that of pressure and friction.
#[test]
fn a_longitudinal_force_is_met_where_normals_lean() {
    let case = example("rail-dip.toml", "theory = \"fastsim\"");
    for wanted in [-3000.0, 3000.0] {
        let drive = Drive::Force(wanted);
        let travel = WheelsetVelocity { drive, ..case.travel.unwrap() };
        let solved = case.solver().unwrap().solve(&case.stance, &travel).unwrap();
        let sum: f64 = solved.wheels().map(|wheel| wheel.on_rail().force[0]).sum();
        let leans: f64 = solved
            .wheels()
            .flat_map(SolvedWheel::contacts)
            .map(|one| one.load() * one.slope.sin().abs())
            .sum();
        // To 1e-5 of what friction could have.
        let most: f64 =
            solved.wheels().map(|wheel| solved.friction * wheel.on_rail().force[2]).sum();
        assert!((sum - wanted).abs() < 1e-5 * most && leans > 100.0, "{wanted}: {sum}, {leans}");
    }
}

/// Far on the flange at large yaw wheel and rail do not part along rolling: the refusal says so, and names no key.
#[test]
fn surfaces_that_do_not_part_are_named() {
    let case = case("theory = \"fastsim\"");
    let pose = WheelsetPose {
        y: 0.010_179_058_296,
        yaw: 0.059_710_349_031,
        roll: Some(-9.064_317_568_5e-4),
        load: Some(Load::Height(-6.207_300_322e-4)),
        ..case.stance
    };
    let refused = case.solver().unwrap().solve(&pose, &case.travel.unwrap()).unwrap_err();
    let words = "right wheel: wheel and rail do not part along rolling there";
    assert!(refused.to_string().starts_with(words), "{refused}");
}

/// A wheel that carries another load than the one asked of it says so with both numbers, from a thousandth on.
#[test]
fn a_load_that_is_missed_is_told() {
    let case = case("resolution = \"fast\"");
    let mut solved = case.solver().unwrap().solve(&case.stance, &case.travel.unwrap()).unwrap();
    let right = solved.right.as_mut().unwrap();
    let load = right.on_rail().force[2];
    right.missed_load = -5e-4 * load;
    assert_eq!(wheelset_caution_words(&solved), Vec::<String>::new());
    solved.right.as_mut().unwrap().missed_load = -0.01 * load;
    let words = wheelset_caution_words(&solved);
    assert_eq!(words.len(), 1, "{words:?}");
    let begins = "right wheel: carries 1 kN less than the 101 kN asked of it";
    assert!(words[0].starts_with(begins), "{words:?}");
}

/// What is given has no error: where the pitch rate is found, one wheel's longitudinal force is the other's but for the
/// moments about the normals, and a wheel that slides wholly knows its own; vertical forces are the loads.
#[test]
fn error_bars_keep_what_is_given() {
    for y in [0.001, 0.004, 0.0065] {
        let case = case("resolution = \"fast\"");
        let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
        let radius = case.running.wheelset().radius();
        let pose = WheelsetPose { y, ..case.stance };
        let solved = solver.solve(&pose, &travel).unwrap();
        let bars: Vec<[f64; 3]> =
            solved.wheels().map(|wheel| wheel.on_rail().force_error.unwrap()).collect();
        let moments = solved
            .wheels()
            .flat_map(SolvedWheel::contacts)
            .map(|one| one.force_error.unwrap().moment * one.angle.sin().abs() / radius);
        // Levers of both contacts differ by the rolling radii, some per cent where the flange bears.
        let apart = moments.sum::<f64>() + 0.05 * bars[0][0];
        assert!((bars[0][0] - bars[1][0]).abs() <= apart, "{y}: {bars:?} {apart}");
        // Loads are met to 1e-4; friction's vertical part takes nothing from that.
        assert!(bars.iter().all(|bar| bar[2] <= 1e-4 * 1e5), "{y}: {bars:?}");
        // Given a pitch rate each wheel has its own.
        let pitch = creepage_study::PitchRate::Rigid(Some(solved.motion.pitch_rate));
        let given = WheelsetVelocity { pitch, ..travel };
        let own = solver.solve(&pose, &given).unwrap();
        let own: Vec<f64> =
            own.wheels().map(|wheel| wheel.on_rail().force_error.unwrap()[0]).collect();
        assert!(bars[0][0] <= 1.1 * own[0].hypot(own[1]), "{y}: {bars:?} {own:?}");
    }
}

/// To a fifth of its error bar, and to 1e-4.
#[track_caller]
fn carries_100_kn(wheel: &SolvedWheel) {
    let errors = wheel.contacts().iter().map(|one| one.normal.load().error);
    let missed = (wheel.on_rail().force[2] - 1e5).abs();
    assert!(missed < (0.2 * errors.sum::<f64>()).min(10.0), "{missed} N");
}

/// Where an area parts in two, at the gauge corner and on the flange, forth, back and by other steps: the
/// road leads to what is found from nothing, and every position carries its load.
#[test]
fn a_walk_finds_what_is_found_from_nothing() {
    const STEPS: [f64; 8] = [0.0, 10.0, 20.0, 30.0, 110.0, 190.0, 170.0, 175.0];
    let case = case("theory = \"fastsim\"");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    for from in [0.002, 0.00446, 0.0053, 0.0064, 0.007] {
        let at = |step: f64| WheelsetPose { y: from + 1e-6 * step, ..case.stance };
        let mut walked = solver.solve(&at(STEPS[0]), &travel).unwrap();
        for step in &STEPS[1..] {
            walked = solver.next(&walked, &at(*step), &travel).unwrap();
            let alone = solver.solve(&at(*step), &travel).unwrap();
            for (own, cold) in walked.wheels().zip(alone.wheels()) {
                carries_100_kn(own);
                assert_eq!(own.contacts().len(), cold.contacts().len(), "{from} {step}");
                for (own, cold) in own.contacts().iter().zip(cold.contacts()) {
                    let numbers =
                        [own, cold].map(|one| [one.normal.area(), one.normal.peak_pressure()]);
                    for (own, cold) in numbers[0].iter().zip(&numbers[1]) {
                        let apart = (own.value - cold.value).abs();
                        assert!(apart < own.error + cold.error, "{from} {step}: {own:?} {cold:?}");
                    }
                }
            }
        }
    }
}

/// Where a flange begins to climb, loads follow height and roll otherwise than stiffness tells, by friction and
/// by the place of contact: steps by stiffness led farther and farther away.
#[test]
fn a_flange_that_climbs_is_settled() {
    let case = case("theory = \"exact\"");
    let stance = WheelsetPose { y: -0.006_392, yaw: 0.005, ..case.stance };
    let solved = case.solver().unwrap().solve(&stance, &case.travel.unwrap()).unwrap();
    for wheel in solved.wheels() {
        carries_100_kn(wheel);
    }
}

/// What pressing errs by, the height makes up for under a given load, and does not where the height is given.
#[test]
fn a_given_load_errs_by_what_it_is_missed_by() {
    let mut case = case("resolution = \"fast\"");
    let loaded = case.solve().unwrap().solved;
    for wheel in loaded.wheels() {
        let (rail, bar) = (wheel.on_rail(), wheel.on_rail().force_error.unwrap()[2]);
        // A load is met to 1e-4.
        assert!((rail.force[2] - 1e5).abs() <= bar && bar < 10.0, "{rail:?}");
    }
    let stands = loaded.position();
    case.stance =
        WheelsetPose { roll: Some(stands.roll), load: Some(Load::Height(stands.z)), ..case.stance };
    let placed = case.solve().unwrap().solved;
    for wheel in placed.wheels() {
        let pressing: f64 = wheel.contacts().iter().map(|one| one.normal.load().error).sum();
        let bar = wheel.on_rail().force_error.unwrap()[2];
        // One contact at a few degrees: its own error, and a little of friction's.
        assert!(bar > 0.99 * pressing && bar < 1.5 * pressing, "{bar} {pressing}");
    }
}

/// On a flange friction carries part of the load: where it errs, the normal force errs by several times
/// what pressing does.
#[test]
fn error_bars_of_loads_know_of_friction() {
    let solved = |resolution: &str, y: f64| {
        let solve = format!("resolution = \"{resolution}\"");
        let case = example("curve-with-flange-contact.toml", &solve);
        let stance = WheelsetPose { y, yaw: -0.002, ..case.stance };
        case.solver().unwrap().solve(&stance, &case.travel.unwrap()).unwrap()
    };
    let mut over_pressing = 0.0f64;
    for y in [0.0062, 0.0068, 0.0072] {
        let [fast, fine] = ["fast", "fine"].map(|resolution| solved(resolution, y));
        let contacts = |solved: &SolvedWheelset| {
            solved.wheels().flat_map(SolvedWheel::contacts).cloned().collect::<Vec<_>>()
        };
        let (fast, fine) = (contacts(&fast), contacts(&fine));
        assert_eq!(fast.len(), fine.len());
        for (a, b) in fast.iter().zip(&fine) {
            let off = (a.load() - b.load()).abs();
            let bars = a.load_error + b.load_error;
            assert!(off < bars, "{y}: {off} of {bars}");
            over_pressing =
                over_pressing.max(off / (a.normal.load().error + b.normal.load().error));
        }
    }
    assert!(over_pressing > 2.0, "{over_pressing}");
}

/// An area in turned axes narrows to a waist of no width: the pressure there is zero, and was no number. Found among
/// 100,000 rows.
#[test]
fn a_waist_of_no_width_carries_nothing() {
    let case = case("theory = \"fastsim\"");
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let load = Some(Load::Axle(192_353.756));
    let stance = WheelsetPose { y: 0.004_860_521_09, yaw: 0.009_604_677_27, load, ..case.stance };
    let solved = solver.solve(&stance, &travel).unwrap();
    let carried: f64 = solved.wheels().map(|wheel| wheel.on_rail().force[2]).sum();
    // The promise of a load that is given.
    assert!((carried / 192_353.756 - 1.0).abs() < 2e-4, "{carried}");
}
