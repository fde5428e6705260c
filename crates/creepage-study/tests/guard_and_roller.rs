//! The back of the flange on a guard rail, and a roller in place of the rail.
#![allow(clippy::unwrap_used)]

use std::fmt::Write as _;
use std::path::Path;

use creepage_study::{
    Caution, SolvedWheel, WheelsetCase, WheelsetFile, WheelsetFileError, WheelsetReport,
};

/// The Manchester benchmark's profiles and track.
const BASE: &str = "
wheel = { profile = 'S1002', radius = 0.46 }
rail = { profile = 'UIC60', cant = 0.024994793618920 RAIL }
track = { gauge = 1.435, gauge_height = 0.014 }
wheelset = { back_to_back = 1.36 WHEELSET }
motion = { speed = 2.0 MOTION }
contact = { friction = 0.3 }
materials = { shear_modulus = 82e9, poisson = 0.28 }
solve = { theory = 'exact', resolution = 'fast' }
";

fn read(parts: &[(&str, &str)]) -> Result<WheelsetCase, WheelsetFileError> {
    let mut text = BASE.to_owned();
    for (place, given) in parts {
        text = text.replace(&format!(" {place} "), &format!(", {given} "));
    }
    for place in ["RAIL", "WHEELSET", "MOTION"] {
        text = text.replace(&format!(" {place} "), " ");
    }
    WheelsetFile::read(&text).map_err(WheelsetFileError::from)?.case(Path::new(""))
}

fn solved(parts: &[(&str, &str)]) -> WheelsetReport {
    read(parts).unwrap().solve().unwrap()
}

fn right(report: &WheelsetReport) -> &SolvedWheel {
    report.right.as_ref().unwrap()
}

#[track_caller]
fn near(found: f64, right: f64, within: f64) {
    assert!((found - right).abs() <= within, "{found} for {right}, within {within}");
}

const ALONE: &str = "side = 'right', roll = 0.0, y = 0.002, yaw = 0.003, wheel_load = 10e3";
const RATE: &str = "pitch_rate = 4.3481181";

/// Creepages are exact first principles (sheet 8, D: < 1e-18 against an independent program where the contact is the
/// same; its reference point is not ours, which moves them by parts of 1e-3), forces within 1 % of mu N: its grid errs
/// by .3 %, the fast one here by as much, and it leaves out what the pressure pushes along, below .2 %.
#[test]
fn rollers_have_the_reference_creepages_and_forces() {
    let table = [
        (0.3, [-0.003_533_0, -0.003_015_7, -0.439_7], [-2185.9, -1192.9], 29.72e-6, -0.831e-3),
        (0.5, [-0.002_667_8, -0.003_014_1, -0.333_2], [-1893.5, -1468.4], 28.28e-6, -1.098e-3),
        (1.0, [-0.002_018_7, -0.003_012_9, -0.253_3], [-1584.3, -1691.5], 26.88e-6, -1.442e-3),
        (100.0, [-0.001_375_9, -0.003_011_7, -0.174_2], [-1180.9, -1903.9], 25.0e-6, -2.1e-3),
    ];
    for (radius, [xi, eta, phi], [x, y], approach, along) in table {
        let rail = format!("roller_radius = {radius:?}");
        let solved = solved(&[("RAIL", &rail), ("WHEELSET", ALONE), ("MOTION", RATE)]);
        let wheel = right(&solved);
        let contact = &wheel.contacts()[0];
        near(contact.creepage.longitudinal, xi, 5e-3 * xi.abs());
        near(contact.creepage.lateral, eta, 5e-3 * eta.abs());
        near(contact.creepage.spin, phi, 2e-2 * phi.abs());
        near(contact.reference[0], along, 2e-5);
        near(contact.normal.approach().value, approach, 0.01 * approach);
        let force = wheel.on_rail().force;
        // Off the top the normal leans, and the pressure pushes along: first principles (sheet 8, D), and left out there.
        near(force[0], x - contact.load() * contact.reference[0] / radius, 30.0);
        near(force[1], y, 30.0);
        near(force[2], 10e3, 1.0);
    }
}

/// A cylinder on a crowned roller is Hertz's: 705.19 `MPa`, approach .025273 mm, semi-axes 2.8046 across and 2.4142 along
/// (sheet 8, D), and the pressure pushes along by nothing.
#[test]
fn a_cylinder_on_a_crowned_roller_is_hertzian() {
    let crown: Vec<[f64; 2]> = (-40..=40)
        .map(|k| {
            let y = 1e-3 * f64::from(k);
            [y, 0.3 - (0.09 - y * y).sqrt()]
        })
        .collect();
    let flat: Vec<[f64; 2]> = (-40..=40).map(|k| [-1e-3 * f64::from(k), 0.0]).collect();
    let text = format!(
        "wheel = {{ points = {flat:?}, radius = 0.46, flange_back = 0.0 }}\n\
         rail = {{ points = {crown:?}, roller_radius = 0.5 }}\n\
         track = {{ rail_position = 0.75 }}\n\
         wheelset = {{ back_to_back = 1.5, side = 'right', roll = 0.0, wheel_load = 10e3 }}\n\
         motion = {{ speed = 1.0 }}\ncontact = {{ friction = 0.3 }}\n\
         materials = {{ shear_modulus = 82e9, poisson = 0.28 }}\n"
    );
    let case = WheelsetFile::read(&text).unwrap().case(Path::new("")).unwrap();
    let solved = case.solve().unwrap();
    let contact = &right(&solved).contacts()[0];
    let peak = contact.normal.peak_pressure();
    // The lattice of the gap and the strips err by parts of 1e-3.
    near(peak.value, 705.19e6, 2e-3 * 705.19e6 + peak.error);
    near(contact.normal.approach().value, 25.273e-6, 2e-3 * 25.273e-6);
    let [[back, front], [low, high]] = contact.extent();
    near(0.5 * (front - back), 2.4142e-3, 0.01 * 2.4142e-3);
    near(0.5 * (high - low), 2.8046e-3, 0.01 * 2.8046e-3);
    near(right(&solved).on_rail().force[0], 0.0, 1.0);
}

/// A roller rig runs backwards as the mirror image, and is no place for what takes straight rails.
#[test]
fn a_roller_runs_backwards_and_refuses_what_it_is_not() {
    let rail = ("RAIL", "roller_radius = 0.5");
    let ahead = solved(&[rail, ("WHEELSET", ALONE), ("MOTION", RATE)]);
    let mut case = read(&[
        rail,
        ("WHEELSET", &ALONE.replace("yaw = 0.003", "yaw = -0.003")),
        ("MOTION", "pitch_rate = -4.3481181"),
    ])
    .unwrap();
    case.travel.as_mut().unwrap().speed = -2.0;
    let back = case.solve().unwrap();
    let [one, other] = [&ahead, &back].map(|solved| right(solved).on_rail().force);
    assert_eq!([-one[0], one[1], one[2]].map(f64::to_bits), other.map(f64::to_bits));
    for (wrong, words) in [
        ("roller_radius = 0.0", "0.1 mm at least"),
        ("roller_radius = 0.5, droll = 0.01", "axle lies along y"),
        (
            "roller_radius = 0.5, corrugation = [{ wavelength = 0.05, amplitude = 1e-5 }]",
            "left out",
        ),
        ("roller_radius = 0.02", "larger than the profile is deep"),
    ] {
        let error = read(&[("RAIL", wrong), ("WHEELSET", ALONE)]).unwrap_err().to_string();
        assert!(error.contains(words), "{wrong}: {error}");
    }
}

/// A bull nose: a flat head, 10 mm round, and a face that falls at 80 degrees.
fn nose() -> Vec<[f64; 2]> {
    let mut points = vec![[-0.05, 0.0], [-0.04, 0.0], [-0.03, 0.0], [-0.02, 0.0], [-0.01, 0.0]];
    points.extend((0..=40).map(|k| {
        let angle = 80f64.to_radians() * f64::from(k) / 40.0;
        [0.01 * angle.sin(), 0.01 * (1.0 - angle.cos())]
    }));
    let ([y, z], (sin, cos)) = (points[points.len() - 1], 80f64.to_radians().sin_cos());
    points.extend((1..=45).map(|k| [y + 1e-3 * f64::from(k) * cos, z + 1e-3 * f64::from(k) * sin]));
    points
}

fn guarded(flangeway: f64) -> String {
    let mut text = String::new();
    let points = nose();
    write!(
        text,
        "guard = {{ points = {points:?}, flangeway = {flangeway:?}, height = 0.025, cant = 0.0 }}"
    )
    .unwrap();
    text
}

/// A flangeway far wider than the flange needs (m), and a wheel at a given roll: one that a guard rail lifts is no
/// longer level.
const FAR: f64 = 0.060;
const PRESSED: &str = "side = 'right', roll = 0.0, y = -0.004, yaw = 0.002, wheel_load = 50e3";

/// The flangeway at which the back of the flange overlaps the guard's face by 40 um.
fn pressed() -> f64 {
    let far = solved(&[("RAIL", &guarded(FAR)), ("WHEELSET", PRESSED)]);
    FAR - right(&far).guard_clearance.unwrap() / 80f64.to_radians().sin() - 4e-5
}

/// Rail and guard rail shifted to the right are the wheelset shifted to the left: they go together.
#[test]
fn a_guard_rail_goes_with_its_rail() {
    let rail = guarded(pressed());
    let plain = solved(&[("RAIL", &rail), ("WHEELSET", PRESSED)]);
    let moved = PRESSED.replace("y = -0.004", "y = -0.003");
    let shifted = solved(&[("RAIL", &format!("{rail}, dy = 0.001")), ("WHEELSET", &moved)]);
    let [one, other] = [&plain, &shifted].map(|report| right(report).on_guard().unwrap().force);
    // Places are sampled elsewhere; of mu N.
    for (one, other) in one.into_iter().zip(other) {
        near(one, other, 2e-3 * 0.3 * 50e3);
    }
    assert!(one[1] < -100.0, "{one:?}");
}

/// Far off it says how far and changes no bit; closer the clearance closes by as much, and then the back of the flange
/// is pushed to the gauge's side while the running rail carries the rest.
#[test]
fn the_back_of_the_flange_runs_on_a_guard_rail() {
    let wheelset = "y = -0.004, yaw = 0.002, axle_load = 100e3, roll = 'free'";
    let alone = solved(&[("WHEELSET", wheelset)]);
    let far = solved(&[("RAIL", &guarded(FAR)), ("WHEELSET", wheelset)]);
    for (one, other) in alone.wheels().zip(far.wheels()) {
        assert_eq!(one.on_rail().force.map(f64::to_bits), other.on_rail().force.map(f64::to_bits));
        assert!(other.on_guard().unwrap().force.iter().all(|part| part.abs() < f64::MIN_POSITIVE));
    }
    let says = |report: &WheelsetReport| {
        let all = report.cautions().into_iter();
        all.filter(|(_, caution)| matches!(caution, Caution::GuardApart { .. })).count()
    };
    assert_eq!(says(&far), 2);
    let clearance = |report: &WheelsetReport| right(report).guard_clearance.unwrap();
    let nearer = solved(&[("RAIL", &guarded(FAR - 0.002)), ("WHEELSET", wheelset)]);
    // The back is upright and the nearest place steep: lateral and least distance differ by the cosine.
    near((clearance(&far) - clearance(&nearer)) / 0.002, 1.0, 0.03);

    let solved = solved(&[("RAIL", &guarded(pressed())), ("WHEELSET", PRESSED)]);
    let wheel = right(&solved);
    let guard = wheel.on_guard().unwrap().force;
    let steep = wheel.contacts().iter().find(|contact| contact.is_on_guard).unwrap();
    assert!(steep.angle > 1.2 && steep.angle < 1.45, "{}", steep.angle);
    // The force on the guard rail points to the track's middle.
    assert!(guard[1] < -100.0 && wheel.guard_clearance == Some(0.0), "{guard:?}");
    near(wheel.on_rail().force[2], 50e3, 50.0);
    assert_eq!(says(&solved), 0);
    let json = serde_json::to_value(solved.report()).unwrap();
    assert_eq!(json["right"]["guard"]["clearance_m"], 0.0);
    let patches = json["right"]["patches"].as_array().unwrap();
    assert!(patches.iter().any(|patch| patch["rail"] == "guard"));
    assert!(solved.text().contains("of which on the guard rail"), "{}", solved.text());
}

/// On the left it is the mirror image; with friction of its own it carries that.
#[test]
fn a_guard_rail_on_the_left_is_the_mirror_image() {
    let rail = guarded(pressed());
    let wheelset = PRESSED;
    let one = solved(&[("RAIL", &rail), ("WHEELSET", wheelset)]);
    let mirrored = wheelset.replace("'right'", "'left'").replace("-0.004", "0.004");
    let mirrored = mirrored.replace("0.002", "-0.002");
    let other = solved(&[("RAIL", &rail), ("WHEELSET", &mirrored)]);
    let [a, b] = [right(&one).on_rail().force, other.left.as_ref().unwrap().on_rail().force];
    // Sums go the other way round.
    for (one, other) in [a[0], -a[1], a[2]].into_iter().zip(b) {
        near(one, other, 1e-3 * 0.3 * 50e3);
    }
    let slick = rail.replace("cant = 0.0 }", "cant = 0.0, friction = 0.01 }");
    let slick = solved(&[("RAIL", &slick), ("WHEELSET", wheelset)]);
    let on = |report: &WheelsetReport| {
        let contacts = right(report).contacts();
        contacts
            .iter()
            .find(|contact| contact.is_on_guard)
            .map(|contact| contact.force.longitudinal.hypot(contact.force.lateral) / contact.load())
    };
    // It slides, but spin turns the slip within the area, so that less than all of its friction adds up.
    for (report, friction) in [(&slick, 0.01), (&one, 0.3)] {
        let part = on(report).unwrap() / friction;
        assert!(part > 0.85 && part < 1.001, "{part}");
    }
}

/// A grooved rail is its head with its lip as a guard rail.
#[test]
fn a_grooved_rail_is_a_rail_with_a_guard() {
    // Lip, groove and head: a nose, a floor 45 mm deep and a round head.
    let mut points = nose();
    let [y, z] = points[points.len() - 1];
    points.extend((1..8).map(|k| [y + 2e-3 + 2.5e-3 * f64::from(k), z + 4e-3]));
    let start = points[points.len() - 1][0] + 4e-3;
    let head: Vec<[f64; 2]> = (0..=70)
        .map(|k| {
            let s = 1e-3 * f64::from(k);
            let round = if s < 0.013 {
                0.013 - (0.013f64.powi(2) - (0.013 - s).powi(2)).sqrt()
            } else {
                0.0
            };
            [start + s, round + (s - 0.035).powi(2) * 0.5]
        })
        .collect();
    points.extend(&head);
    let rail = |keys: String| {
        format!(
            "wheel = {{ profile = 'S1002', radius = 0.46 }}\nrail = {{ {keys} }}\n\
             track = {{ rail_position = 0.685, rail_height = 0.0 }}\n\
             wheelset = {{ back_to_back = 1.36, side = 'right', roll = 0.0, y = 0.0, yaw = 0.001, wheel_load = 50e3 }}\n\
             motion = {{ speed = 2.0 }}\ncontact = {{ friction = 0.3 }}\n\
             materials = {{ shear_modulus = 82e9, poisson = 0.28 }}\nsolve = {{ resolution = 'fast' }}\n"
        )
    };
    let solve = |keys: String| {
        WheelsetFile::read(&rail(keys)).unwrap().case(Path::new("")).unwrap().solve().unwrap()
    };
    let grooved = solve(format!("points = {points:?}, guard = {{ grooved = true }}"));
    let apart = solve(format!(
        "points = {head:?}, guard = {{ points = {:?}, position = [0.685, 0.0] }}",
        nose()
    ));
    let [one, other] = [&grooved, &apart].map(right);
    near(one.guard_clearance.unwrap(), other.guard_clearance.unwrap(), 2e-5);
    // The splines are not the same where one of them goes on.
    for (one, other) in one.on_rail().force.into_iter().zip(other.on_rail().force) {
        near(one, other, 30.0);
    }
    let none = "profile = 'UIC60', guard = { grooved = true }".to_owned();
    let error = WheelsetFile::read(&rail(none)).unwrap().case(Path::new("")).unwrap_err();
    assert!(error.to_string().contains("no groove"), "{error}");
    let both = "profile = 'UIC60', guard = { grooved = true, flangeway = 0.04 }".to_owned();
    let error = WheelsetFile::read(&rail(both)).unwrap().case(Path::new("")).unwrap_err();
    assert!(error.to_string().contains("flangeway"), "{error}");
}
