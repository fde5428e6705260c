//! A wheelset in motion: backwards, driven, with independent wheels, in curves, on rails that move, under loads
//! that are not equal, with friction by the place.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use creepage_study::{
    Load, PitchRate, SolvedWheel, SolvedWheelset, WheelsetCase, WheelsetError, WheelsetFile,
    WheelsetFileError, WheelsetPose, WheelsetReport, WheelsetVelocity,
};

/// The Manchester benchmark's profiles and track.
const BASE: &str = "
wheel = { profile = 'S1002', radius = 0.46 }
rail = { profile = 'UIC60', cant = 0.024994793618920 RAIL }
track = { gauge = 1.435, gauge_height = 0.014 TRACK }
wheelset = { back_to_back = 1.36 WHEELSET }
motion = { speed = 2.0 MOTION }
contact = { friction = 0.3 CONTACT }
materials = { shear_modulus = 82e9, poisson = 0.28 }
solve = { SOLVE }
";
const FAST: &str = "theory = 'exact', resolution = 'fast'";

/// The benchmark with pairs of a place and what stands there.
fn read(parts: &[(&str, &str)]) -> Result<WheelsetCase, WheelsetFileError> {
    let mut text = BASE.to_owned();
    for (place, given) in parts {
        let comma = if *place == "SOLVE" { "" } else { ", " };
        text = text.replace(&format!(" {place} "), &format!("{comma}{given} "));
    }
    for place in ["RAIL", "TRACK", "WHEELSET", "MOTION", "CONTACT"] {
        text = text.replace(&format!(" {place} "), " ");
    }
    let text = text.replace("SOLVE", FAST);
    WheelsetFile::read(&text).map_err(WheelsetFileError::from)?.case(Path::new(""))
}

fn solved(parts: &[(&str, &str)]) -> WheelsetReport {
    read(parts).unwrap().solve().unwrap()
}

fn force(wheel: Option<&SolvedWheel>) -> [f64; 3] {
    wheel.unwrap().on_rail().force
}

fn forces(solved: &SolvedWheelset) -> [[f64; 3]; 2] {
    [force(solved.left.as_ref()), force(solved.right.as_ref())]
}

#[track_caller]
fn near(found: [f64; 3], right: [f64; 3], within: f64) {
    for (found, right) in found.iter().zip(right) {
        assert!((found - right).abs() < within, "{found} for {right}, {:.1}", found - right);
    }
}

/// The right wheel alone of the reference cases: y 2 mm, yaw 3 mrad, 10 kN, a given pitch rate.
const ALONE: &str = "side = 'right', roll = 0.0, y = 0.002, yaw = 0.003, wheel_load = 10e3";
const RATE: &str = "pitch_rate = 4.3481181";
/// Of mu N: the reference program's grid errs by .3 %, the fast one here by as much.
const REFERENCE: f64 = 0.01 * 3000.0;

/// Shifts, turns and velocities of a rail, against an independent program's exact kinematics and its forces
/// (sheet 8, A1).
#[test]
fn rails_that_move_have_the_reference_forces() {
    let cases = [
        ("dy = 0.0", [-1176.7, -1905.8]),
        ("dy = 0.001", [-959.5, -2102.1]),
        ("dz = 0.0003", [-1176.7, -1905.8]),
        ("droll = 0.01", [-1358.6, -1728.0]),
        ("dy_rate = 0.005", [-702.0, -2064.1]),
        ("dz_rate = 0.02", [-1470.0, -1759.3]),
        ("droll_rate = 0.1", [-1163.0, -1911.6]),
    ];
    for (rail, [x, y]) in cases {
        let solved = solved(&[("RAIL", rail), ("WHEELSET", ALONE), ("MOTION", RATE)]);
        near(force(solved.right.as_ref()), [x, y, 10e3], REFERENCE);
    }
    let curve = ("TRACK", "curve_radius = 300.0");
    let solved = solved(&[curve, ("WHEELSET", ALONE), ("MOTION", RATE)]);
    near(force(solved.right.as_ref()), [-2296.7, -1076.2, 10e3], REFERENCE);
    let creepage = solved.right.as_ref().unwrap().contacts()[0].creepage;
    assert!((creepage.longitudinal + 0.003_842_4).abs() < 2e-6, "{creepage:?}");
    assert!((creepage.spin + 0.1703).abs() < 2e-4, "{creepage:?}");
}

/// Both rails shifted to the right are the wheelset shifted to the left; lowered, it follows.
#[test]
fn both_rails_moved_are_the_wheelset_moved() {
    let wheelset = "y = 0.002, yaw = 0.003, axle_load = 20e3, roll = 'free'";
    let one = solved(&[("RAIL", "dy = -0.001, dz = 0.0004"), ("WHEELSET", wheelset)]);
    let moved = "y = 0.003, yaw = 0.003, axle_load = 20e3, roll = 'free'";
    let other = solved(&[("WHEELSET", moved)]);
    // The same contacts to rounding; the search ends where each carries its load to 1e-4.
    for (one, other) in forces(&one).into_iter().zip(forces(&other)) {
        near(one, other, 2.0);
    }
    assert!((one.position().z - other.position().z - 0.0004).abs() < 1e-8);
}

/// Backwards is the mirror image fore and aft (sheet 8, A4), also from a start and for derivatives.
#[test]
fn backwards_is_the_mirror_image() {
    let alone = ALONE.replace("yaw = 0.003", "yaw = -0.003");
    let ahead = solved(&[("WHEELSET", &alone), ("MOTION", RATE)]);
    near(force(ahead.right.as_ref()), [-1387.3, 3544.3, 10e3], REFERENCE);
    let mut case = read(&[("WHEELSET", ALONE), ("MOTION", "pitch_rate = -4.3481181")]).unwrap();
    let travel = WheelsetVelocity { speed: -2.0, ..case.travel.unwrap() };
    case.travel = Some(travel);
    let back = case.solve().unwrap();
    let ([x, y, z], [bx, by, bz]) = (force(ahead.right.as_ref()), force(back.right.as_ref()));
    assert_eq!([-x, y, z].map(f64::to_bits), [bx, by, bz].map(f64::to_bits));
    let (ahead, back) = (ahead.solved.right.unwrap(), back.solved.right.unwrap());
    let (ahead, back) = (ahead.on_rail().moment, back.on_rail().moment);
    assert_eq!([ahead[0], -ahead[1], -ahead[2]].map(f64::to_bits), back.map(f64::to_bits));
    assert!(back[1].abs() > 1.0);

    // With all free, walked to, and differentiated.
    let parts = [("WHEELSET", "y = 0.003, yaw = 0.002, roll = 'free', axle_load = 170e3")];
    let case = read(&parts).unwrap();
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    let (backward, turned) = (WheelsetVelocity { speed: -2.0, ..travel }, |y: f64| WheelsetPose {
        y,
        yaw: -0.002,
        ..case.stance
    });
    let first = solver.solve(&turned(0.003), &backward).unwrap();
    let walked = solver.next(&first, &turned(0.003_02), &backward).unwrap();
    let ahead = solver.solve(&case.stance, &travel).unwrap();
    let next = solver.next(&ahead, &WheelsetPose { y: 0.003_02, ..case.stance }, &travel).unwrap();
    for (one, other) in [(&first, &ahead), (&walked, &next)] {
        for ([x, y, z], back) in forces(other).into_iter().zip(forces(one)) {
            assert_eq!([-x, y, z].map(f64::to_bits), back.map(f64::to_bits));
        }
        assert!((one.motion.pitch_rate + other.motion.pitch_rate).abs() < 1e-12);
    }
    let one = solver.derivatives(&first, &turned(0.003), &backward).unwrap().values();
    let other = solver.derivatives(&ahead, &case.stance, &travel).unwrap().values();
    // By y: along x the other way; by yaw: along x the same way, along y the other.
    assert!((one[1][0][0] + other[1][0][0]).abs() < 1e-9 * other[1][0][0].abs());
    assert!((one[1][0][3] - other[1][0][3]).abs() < 1e-9 * other[1][0][3].abs());
    assert!((one[1][1][3] + other[1][1][3]).abs() < 1e-9 * other[1][1][3].abs());
}

/// Locked and spinning: creepage over the mean of both surface speeds (sheet 8, A4).
#[test]
fn locked_and_spinning_wheels_slide() {
    let locked = solved(&[("WHEELSET", ALONE), ("MOTION", "pitch_rate = 0.0")]);
    let contact = &locked.right.as_ref().unwrap().contacts()[0];
    assert!((contact.creepage.longitudinal - 2.0).abs() < 1e-9);
    near(force(locked.right.as_ref()), [3009.6, 800.7, 10e3], 0.004 * 3000.0);
    let mut case = read(&[("WHEELSET", ALONE), ("MOTION", RATE)]).unwrap();
    case.travel = Some(WheelsetVelocity { speed: 0.0, ..case.travel.unwrap() });
    let spins = case.solve().unwrap();
    near(force(spins.right.as_ref()), [-3009.4, 791.6, 10e3], 0.004 * 3000.0);
    case.travel = Some(WheelsetVelocity { pitch: PitchRate::Rigid(None), ..case.travel.unwrap() });
    assert!(case.travel.unwrap().checked().unwrap_err().to_string().contains("at rest"));
}

/// The reference wheelset of sheet 8, A3: 10 kN on either wheel, y 3 mm, yaw 5 mrad, roll 0.
const AXLE: &str =
    "y = 0.003, yaw = 0.005, roll = 0.0, wheel_load_left = 10e3, wheel_load_right = 10e3";

#[test]
fn torque_and_traction_are_met() {
    let rigid = solved(&[("WHEELSET", AXLE)]);
    let [left, right] = forces(&rigid);
    near(left, [628.5, -3057.7, 10e3], REFERENCE);
    near(right, [-598.1, -1970.7, 10e3], REFERENCE);
    // 1e-5 of what friction could have is worth 1e-8 of the rate; the reference differs by its grid.
    assert!((rigid.motion.pitch_rate - 4.345_314).abs() < 3e-5, "{}", rigid.motion.pitch_rate);
    let driven = solved(&[("WHEELSET", AXLE), ("MOTION", "torque = 1000.0")]);
    let [left, right] = forces(&driven);
    near(left, [-610.5, -3061.5, 10e3], REFERENCE);
    near(right, [-1533.9, -1608.7, 10e3], REFERENCE);
    let pulled = solved(&[("WHEELSET", AXLE), ("MOTION", "longitudinal_force = -2100.0")]);
    let sum: f64 = forces(&pulled).iter().map(|[x, ..]| x).sum();
    assert!((sum + 2100.0).abs() < 1e-5 * 6000.0, "{sum}");
    let too_much = read(&[("WHEELSET", AXLE), ("MOTION", "torque = 5000.0")]).unwrap().solve();
    assert!(
        matches!(too_much, Err(WheelsetFileError::Solve(WheelsetError::TractionNotFound { .. }))),
        "{too_much:?}"
    );
}

#[test]
fn independent_wheels_turn_by_themselves() {
    let apart = solved(&[("WHEELSET", AXLE), ("MOTION", "pitch_rate = ['free', 'free']")]);
    let [left, right] = forces(&apart);
    near(left, [15.06, -3124.2, 10e3], REFERENCE);
    near(right, [14.72, -2031.0, 10e3], REFERENCE);
    let rates = [&apart.left, &apart.right].map(|wheel| wheel.as_ref().unwrap().pitch_rate);
    assert!(
        (rates[0] - 4.349_755).abs() < 3e-5 && (rates[1] - 4.340_569).abs() < 3e-5,
        "{rates:?}"
    );
    let words = solved(&[("WHEELSET", AXLE), ("MOTION", "wheels = 'independent'")]);
    assert_eq!(forces(&words), forces(&apart));
    let given = format!("pitch_rate_left = {}, pitch_rate_right = 'free'", rates[0]);
    let given = solved(&[("WHEELSET", AXLE), ("MOTION", &given)]);
    near(forces(&given)[0], left, 1e-3);
    let text = apart.text();
    assert!(text.contains("pitch rate, left wheel") && text.contains("pitch rate, right wheel"));
}

/// Boxes that press alike need no moment where wheels that press alike need one (sheet 8, A3); with that moment
/// both are the same, and with another it is carried.
#[test]
fn a_moment_shares_the_load() {
    let free = AXLE.replace("roll = 0.0", "roll = 'free'");
    let apart = solved(&[("WHEELSET", &free)]);
    let moment = -apart.wrench(0.46)[1][0];
    let wheelset = "y = 0.003, yaw = 0.005, roll = 'free', axle_load = 20e3";
    for moment in [moment, 0.0, 1500.0] {
        let asked = format!("{wheelset}, roll_moment = {moment}");
        let case = read(&[("WHEELSET", &asked)]).unwrap();
        let solved = case.solve().unwrap();
        let wrench = solved.wrench(0.46);
        assert!((wrench[0][2] + 20e3).abs() < 4.0, "{wrench:?}");
        // Loads are shared to 1e-4 at levers of .75 m.
        assert!((wrench[1][0] + moment).abs() < 2e-4 * 20e3 * 0.75, "{moment} {wrench:?}");
        let near_by = WheelsetPose { y: 0.003_01, ..case.stance };
        let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
        let next = solver.next(&solved, &near_by, &travel).unwrap();
        let alone = solver.solve(&near_by, &travel).unwrap();
        for (next, alone) in forces(&next).into_iter().zip(forces(&alone)) {
            near(next, alone, 0.002 * 3000.0);
        }
    }
    let lifted = format!("{wheelset}, roll_moment = 20e3");
    let error = read(&[("WHEELSET", &lifted)]).unwrap().solve().unwrap_err();
    assert!(error.to_string().contains("lifts the left wheel"), "{error}");
}

#[test]
fn a_lifted_wheel_carries_nothing_and_says_how_far_it_hangs() {
    let loads = "y = 0.0, yaw = 0.0, wheel_load_left = 0.0, wheel_load_right = 20e3";
    let lifted = solved(&[("WHEELSET", &format!("{loads}, roll = 0.001"))]);
    let [left, right] = forces(&lifted);
    assert!(left.iter().all(|part| part.abs() < f64::MIN_POSITIVE));
    assert!((right[2] - 20e3).abs() < 2.0);
    let by_height = "y = 0.0, yaw = 0.0, z = 0.0005, roll = 0.001";
    let lifted = solved(&[("WHEELSET", by_height)]);
    let clearance = lifted.left.as_ref().unwrap().clearance.unwrap();
    // That much lower, and a micrometre, it touches, and not before.
    let carries = |more: f64| {
        let z = 0.0005 + clearance + more;
        let lower = solved(&[("WHEELSET", &format!("y = 0.0, yaw = 0.0, z = {z}, roll = 0.001"))]);
        force(lower.left.as_ref())[2]
    };
    assert!(carries(-1e-6).abs() < f64::MIN_POSITIVE && carries(1e-6) > 0.0, "{clearance}");
    assert!(lifted.right.as_ref().unwrap().clearance.is_none());
    assert!(lifted.text().contains("hangs above its rail by"));
    let error = read(&[("WHEELSET", &format!("{loads}, roll = 'free'"))]).unwrap().solve();
    assert!(
        matches!(error, Err(WheelsetFileError::Solve(WheelsetError::Hangs { .. }))),
        "{error:?}"
    );
    // Rolled the other way, it touches before the right one carries its load.
    let error = read(&[("WHEELSET", &format!("{loads}, roll = -0.001"))]).unwrap().solve();
    let sinks = WheelsetError::Sinks { side: creepage_rail::Side::Left };
    assert!(error.unwrap_err().to_string().ends_with(&sinks.to_string()));
}

/// Loads of a rigid vehicle in a canted curve (sheet 8, A2): 10 t, 25 m/s, 500 m, h 100 mm, 1.8 m.
#[test]
fn superelevation_shares_the_load() {
    let case = read(&[
        ("TRACK", "curve_radius = 500.0, superelevation = 0.1"),
        ("WHEELSET", "mass = 10e3, centre_height = 1.8"),
    ]);
    let mut case = case.unwrap();
    case.travel = None;
    let Some(Load::Wheels([left, right])) = case.stance.load else { panic!("{:?}", case.stance) };
    // At 2 m/s the outer, left wheel is the lighter one; the sum is the weight across the track.
    assert!(left < right && ((left + right) / 98_066.5 - 1.0).abs() < 3e-3);
    let fast = BASE.replace("speed = 2.0", "speed = 25.0");
    let fast = fast
        .replace("0.014 TRACK", "0.014, curve_radius = 500.0, superelevation = 0.1")
        .replace("1.36 WHEELSET", "1.36, mass = 10e3, centre_height = 1.8")
        .replace("MOTION", "")
        .replace("CONTACT", "")
        .replace("RAIL", "")
        .replace("SOLVE", "");
    let case = WheelsetFile::read(&fast).unwrap().case(Path::new("")).unwrap();
    let Some(Load::Wheels([left, right])) = case.stance.load else { panic!("{:?}", case.stance) };
    assert!((left - 56_476.0).abs() < 60.0 && (right - 42_239.0).abs() < 60.0, "{left} {right}");
}

/// Friction by the inclination of the rail (sheet 8, B): .2 on the gauge face, .3 on the tread. On one plane the
/// reference takes one coefficient; by rows, as here, its conformal solution.
#[test]
fn friction_follows_the_rail() {
    let contact = "side = 'right', y = 0.005, yaw = 0.012, roll = -0.0003554, wheel_load = 10e3";
    let rate = "pitch_rate = 4.3353637";
    let by_angle = BASE.replace(
        "friction = 0.3",
        "friction = { angle = [-0.349065850, -0.174532925], value = [0.2, 0.3] }",
    );
    let text = by_angle
        .replace("1.36 WHEELSET", &format!("1.36, {contact}"))
        .replace("2.0 MOTION", &format!("2.0, {rate}"))
        .replace("CONTACT", "")
        .replace("TRACK", "")
        .replace("RAIL", "")
        .replace("SOLVE", "theory = 'exact'");
    let case = WheelsetFile::read(&text).unwrap().case(Path::new("")).unwrap();
    let varied = case.solve().unwrap();
    let constant = solved(&[("WHEELSET", contact), ("MOTION", rate)]);
    let ([x, y, _], [cx, ..]) = (force(varied.right.as_ref()), force(constant.right.as_ref()));
    assert!(x.abs() < 0.9 * cx.abs(), "{x} {cx}");
    let bound: f64 = varied.wheels().flat_map(SolvedWheel::contacts).map(|c| 0.3 * c.load()).sum();
    assert!(x.hypot(y) < bound);
    // Friction that is the same at every place is constant friction.
    let same = text.replace("value = [0.2, 0.3]", "value = [0.3, 0.3]");
    let same = WheelsetFile::read(&same).unwrap().case(Path::new("")).unwrap().solve().unwrap();
    let plain = text.replace("{ angle = [-0.349065850, -0.174532925], value = [0.2, 0.3] }", "0.3");
    let plain = WheelsetFile::read(&plain).unwrap().case(Path::new("")).unwrap().solve().unwrap();
    near(force(same.right.as_ref()), force(plain.right.as_ref()), 1e-3 * 3000.0);
    // By fastsim too.
    let quick = text.replace("theory = 'exact'", "theory = 'fastsim'");
    let quick = WheelsetFile::read(&quick).unwrap().case(Path::new("")).unwrap().solve().unwrap();
    near(force(quick.right.as_ref()), force(varied.right.as_ref()), 0.15 * 3000.0);
    // On one rail alone.
    let wheelset = "y = 0.0, yaw = 0.002, roll = 'free', axle_load = 200e3";
    let greased = WheelsetFile::read(
        &BASE
            .replace("1.36 WHEELSET", &format!("1.36, {wheelset}"))
            .replace("MOTION", "")
            .replace("CONTACT", "")
            .replace("TRACK", "")
            .replace("RAIL", "")
            .replace("SOLVE", FAST)
            .replace("materials", "rail_left = { friction = 0.05 }\nmaterials"),
    );
    let greased = greased.unwrap().case(Path::new("")).unwrap().solve().unwrap();
    let [left, right] = forces(&greased);
    assert!(
        left[1].hypot(left[0]) < 0.06 * 100e3 + 4e3 && right[1].abs() > 6e3,
        "{left:?} {right:?}"
    );
}

/// Areas in planes of their own carry more at a given height where each is pressed alone: on rails canted 1:20
/// tread and flange touch so.
#[test]
fn patches_apart_carry_more_at_a_height() {
    let at = |y: f64, pressed: &str, patches: &str| {
        let text = BASE
            .replace("0.024994793618920 RAIL", "0.0499584")
            .replace(
                "1.36 WHEELSET",
                &format!("1.36, side = 'right', y = {y}, yaw = 0.0, roll = -0.00013, {pressed}"),
            )
            .replace("0.3 CONTACT", &format!("0.3, patches = '{patches}'"))
            .replace("MOTION", "")
            .replace("TRACK", "")
            .replace("SOLVE", "theory = 'fastsim'");
        WheelsetFile::read(&text).unwrap().case(Path::new("")).unwrap().solve().unwrap()
    };
    let mut found = 0;
    for y in [0.00605, 0.0061, 0.00615] {
        let together = at(y, "wheel_load = 60e3", "together");
        let wheel = together.right.as_ref().unwrap();
        if wheel.contacts().len() == 2 && wheel.contacts()[1].load() > 3e3 {
            let apart = at(y, &format!("z = {}", wheel.position.z), "apart");
            assert!(force(apart.right.as_ref())[2] > 61e3, "{y}");
            found += 1;
        }
    }
    assert!(found > 0);
}

/// A rail's origin at a height of its own: as much as the highest point lies above it changes nothing.
#[test]
fn a_rail_has_its_height() {
    let text = |track: &str| {
        BASE.replace("gauge = 1.435, gauge_height = 0.014 TRACK", track)
            .replace(
                "1.36 WHEELSET",
                "1.36, y = 0.001, yaw = 0.001, roll = 'free', axle_load = 20e3",
            )
            .replace("MOTION", "")
            .replace("CONTACT", "")
            .replace("RAIL", "")
            .replace("SOLVE", FAST)
    };
    let read = |track: &str| WheelsetFile::read(&text(track)).unwrap().case(Path::new("")).unwrap();
    let highest = read("rail_position = 0.7525");
    let [_, z] = highest.running.track().right.origin();
    let given = read(&format!("rail_position = 0.7525, rail_height = {}", z + 0.001));
    let (one, other) = (highest.solve().unwrap(), given.solve().unwrap());
    for (one, other) in forces(&one).into_iter().zip(forces(&other)) {
        near(one, other, 2.0);
    }
    assert!((other.position().z - one.position().z - 0.001).abs() < 1e-8);
}

/// Profiles by their points, along them in either sense, are those by name: to the spacing of the points.
#[test]
fn profiles_may_be_points() {
    let points = |standard: creepage_rail::Standard, is_turned: bool| {
        let profile = standard.profile();
        let curve = profile.curve();
        let mut stations = curve.stations(1e-3);
        if is_turned {
            stations.reverse();
        }
        let points = stations.into_iter().map(|s| curve.at(s));
        let texts: Vec<String> = points.map(|p| format!("[{}, {}]", p.y, p.z)).collect();
        texts.join(", ")
    };
    let wheelset = "1.36, y = 0.001, yaw = 0.001, roll = 'free', axle_load = 20e3";
    let text = BASE.replace("1.36 WHEELSET", wheelset).replace("SOLVE", FAST);
    let text = ["RAIL", "TRACK", "MOTION", "CONTACT"]
        .iter()
        .fold(text, |text, place| text.replace(&format!(" {place}"), ""));
    let named = WheelsetFile::read(&text).unwrap().case(Path::new("")).unwrap().solve().unwrap();
    for is_turned in [false, true] {
        let wheel = points(creepage_rail::Standard::S1002, is_turned);
        let rail = points(creepage_rail::Standard::Uic60, is_turned);
        let text = text
            .replace("profile = 'S1002'", &format!("points = [{wheel}]"))
            .replace("profile = 'UIC60'", &format!("points = [{rail}]"));
        let case = WheelsetFile::read(&text).unwrap().case(Path::new("")).unwrap();
        let given = case.solve().unwrap();
        for (one, other) in forces(&named).into_iter().zip(forces(&given)) {
            near(one, other, 0.05 * 3000.0);
        }
    }
    let both = text.replace("profile = 'S1002'", "profile = 'S1002', points = [[0.0, 0.0]]");
    assert!(WheelsetFile::read(&both).unwrap().case(Path::new("")).is_err());
    let none = text.replace("profile = 'S1002'", "points = [[0.0, 0.0]]");
    let error = WheelsetFile::read(&none).unwrap().case(Path::new("")).unwrap_err();
    assert!(error.to_string().contains("[wheel] points"), "{error}");
}

/// A massless rail on springs (sheet 8, C): under a load, and at a given height.
#[test]
fn a_rail_on_springs_gives_way() {
    let springs = "stiffness_y = 2e7, stiffness_z = 2e7";
    let loaded = solved(&[("RAIL", springs), ("WHEELSET", ALONE), ("MOTION", RATE)]);
    near(force(loaded.right.as_ref()), [-1197.3, -1886.5, 10e3], REFERENCE);
    let [y, z] = loaded.right.as_ref().unwrap().deflection.unwrap();
    // Of forces that err by .3 % of mu N: half a micrometre.
    assert!((y + 94.327e-6).abs() < 0.6e-6 && (z - 0.5e-3).abs() < 0.1e-6, "{y} {z}");
    let height = ALONE.replace("wheel_load = 10e3", "z = 0.573337e-3");
    let placed = solved(&[("RAIL", springs), ("WHEELSET", &height), ("MOTION", RATE)]);
    // The fast grid's height for a load is right to a tenth of a micrometre, worth 60 N.
    near(force(placed.right.as_ref()), [-1215.1, -1914.7, 10149.6], 2.0 * REFERENCE);
    let [y, z] = placed.right.as_ref().unwrap().deflection.unwrap();
    assert!((y + 95.733e-6).abs() < 1.5e-6 && (z - 507.479e-6).abs() < 3e-6, "{y} {z}");
    // What the springs carry is what the wheel presses on them.
    let [_, fy, fz] = force(placed.right.as_ref());
    assert!((2e7 * y - fy).abs() < 0.2 && (2e7 * z - fz).abs() < 0.2);
    let half = read(&[("RAIL", "stiffness_y = 2e7"), ("WHEELSET", ALONE)]);
    assert!(half.unwrap_err().to_string().contains("stiffness_z"));
    let case = read(&[("RAIL", springs), ("WHEELSET", ALONE), ("MOTION", RATE)]).unwrap();
    assert!(matches!(case.solver(), Err(WheelsetFileError::RigidRails { .. })));
}
