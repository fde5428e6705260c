//! `creepage wheelset` on good and bad input.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::place::{Place, json};

fn example(name: &str) -> String {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/wheelset");
    fs::read_to_string(examples.join(name)).unwrap()
}

/// A benchmark position of one wheel, coarsely: quick.
fn one_wheel() -> String {
    let text = example("s1002-on-uic60.toml")
        .replace("y = 0.002 ", "y = 0.003 ")
        .replace("yaw = 0.0 ", "yaw = 0.0072 ")
        .replace("roll = \"free\"", "roll = -1.803e-4\nside = \"right\"")
        .replace("axle_load = 200e3", "wheel_load = 10e3")
        .replace("speed = 30.0", "speed = 2.0")
        .replace("pitch_rate = \"free\"", "pitch_rate = 4.3451503");
    text + "\n[solve]\nresolution = \"fast\"\n"
}

fn solved(text: &str) -> Value {
    let place = Place::new();
    place.write("case.toml", text);
    json(&place.run(&["wheelset", "case.toml", "--json"]).done())
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// What the program CONTACT gives (open source, rev 2707; extrapolated over its grids).
#[test]
fn a_benchmark_position_has_the_forces_of_the_reference() {
    let report = solved(&one_wheel());
    assert!(report["left"].is_null());
    let (force, patch) = (&report["right"]["force"], &report["right"]["patches"][0]);
    // One per cent of mu N = 2932 N; its own uncertainty is 1.3 N.
    for (key, expected) in
        [("longitudinal_n", -417.43), ("lateral_n", -1988.51), ("vertical_n", 10000.0)]
    {
        assert!((number(&force[key]) - expected).abs() < 29.0, "{key}: {force}");
    }
    let close = |key: &str, expected: f64, part: f64| {
        let found = number(&patch[key]);
        assert!((found / expected - 1.0).abs() < part, "{key}: {found} {expected}");
    };
    close("normal_force_n", 9774.0, 2e-3);
    close("peak_pressure_pa", 713.4e6, 0.015);
    assert!((number(&patch["contact_angle_rad"]) + 0.09234).abs() < 1e-4);
    assert_eq!(report["right"]["patches"].as_array().unwrap().len(), 1);
    assert!((number(&report["z_m"]) - 0.114_281e-3).abs() < 1e-7);
    assert!((number(&report["pitch_rate_rad_per_s"]) - 4.345_150_3).abs() < 1e-12);
}

/// With the height that was found the same load comes out; and the mirror image on the other side.
#[test]
fn height_and_load_are_two_ways_to_say_one_thing() {
    let by_load = solved(&one_wheel());
    let z = format!("z = {:e}", number(&by_load["z_m"]));
    let by_height = solved(&one_wheel().replace("wheel_load = 10e3", &z));
    let force = |report: &Value, side: &str, key: &str| number(&report[side]["force"][key]);
    for key in ["longitudinal_n", "lateral_n", "vertical_n"] {
        let difference = force(&by_load, "right", key) - force(&by_height, "right", key);
        assert!(difference.abs() < 1.0, "{key} {difference}");
    }
    let mirrored = one_wheel()
        .replace("y = 0.003 ", "y = -0.003 ")
        .replace("yaw = 0.0072 ", "yaw = -0.0072 ")
        .replace("roll = -1.803e-4", "roll = 1.803e-4")
        .replace("\"right\"", "\"left\"");
    let mirrored = solved(&mirrored);
    for (key, sign) in [
        ("longitudinal_n", 1.0),
        ("lateral_n", -1.0),
        ("vertical_n", 1.0),
        ("moment_x_n_m", -1.0),
        ("moment_y_n_m", 1.0),
        ("moment_z_n_m", -1.0),
    ] {
        let (one, other) = (force(&by_load, "right", key), force(&mirrored, "left", key));
        assert!((one - sign * other).abs() < 1e-6 * 10e3, "{key} {one} {other}");
    }
}

/// Wear of a wheelset: T gamma is the frictional power, and the depths written add up to the mass.
#[test]
fn wear_of_a_wheelset_lies_on_its_profiles() {
    let place = Place::new();
    place.write("case.toml", one_wheel() + "[damage]\n");
    let report = json(&place.run(&["wheelset", "case.toml", "--json", "--out", "out"]).done());
    let patch = &report["right"]["patches"][0];
    let (damage, y_wheel) = (&patch["damage"], number(&patch["y_wheel_m"]));
    // By forces and by slip, which differ by the error of the elements.
    let power = number(&patch["frictional_power_per_metre_j_per_m"]);
    assert!((number(&damage["t_gamma_with_spin_n"]) / power - 1.0).abs() < 0.05, "{damage}");
    assert!((number(&damage["bre_area_m2_per_m"])) > 0.0);
    let csv = fs::read_to_string(place.path("out/wear.csv")).unwrap();
    let mut rows = csv::Reader::from_reader(csv.as_bytes());
    let depths = rows.records().map(|row| {
        let row = row.unwrap();
        assert_eq!(&row[0], "right");
        [&row[3], &row[4]].map(|cell| cell.parse::<f64>().unwrap())
    });
    let depths: Vec<_> = depths.collect();
    assert!(depths.iter().all(|[y, depth]| (y - y_wheel).abs() < 0.02 && *depth >= 0.0));
    let deepest = depths.iter().fold(0.0, |most: f64, [_, depth]| depth.max(most));
    assert!((deepest / number(&damage["usfd_depth_m"]) - 1.0).abs() < 1e-12);
    assert!(place.path("out/right_1_wear.png").is_file());
    place.write("case.toml", one_wheel() + "[damage]\nshakedown = true\n");
    let run = place.run(&["wheelset", "case.toml"]);
    run.refused(&["[damage] shakedown", "contact ellipses only"]);
}

/// Free roll: both rails carry the same; free pitch: friction has no moment about the axle.
#[test]
fn a_free_wheelset_is_in_balance_and_its_pictures_are_written() {
    let place = Place::new();
    let text = example("s1002-on-uic60.toml").replace("axle_load = 200e3", "axle_load = 160e3")
        + "\n[solve]\nresolution = \"fast\"\n";
    place.write("case.toml", text);
    let printed = place.run(&["wheelset", "case.toml", "--json", "--out", "out"]).done();
    let report = json(&printed);
    let force = |side: &str, key: &str| number(&report[side]["force"][key]);
    for side in ["left", "right"] {
        assert!((force(side, "vertical_n") - 80e3).abs() < 8.0, "{report}");
    }
    // No moment: the rails are pulled in opposite directions, nearly alike on like radii; spin
    // and sideways friction have some part in it.
    let pulls = ["left", "right"].map(|side| force(side, "longitudinal_n"));
    assert!((pulls[0] + pulls[1]).abs() < 0.02 * pulls[0].abs(), "{pulls:?}");
    assert_eq!(
        place.files_in("out"),
        [
            "left_1.csv",
            "left_1.png",
            "left_1.svg",
            "left_1.vtk",
            "report.json",
            "right_1.csv",
            "right_1.png",
            "right_1.svg",
            "right_1.vtk",
            "wheelset.png",
            "wheelset.svg"
        ]
    );
    assert_eq!(json(&place.read("out/report.json")), report);
    // The elements carry the contact's load and force: one coarse grid against the extrapolated value.
    let patch = &report["left"]["patches"][0];
    let mut sums = [0.0; 2];
    for row in csv::Reader::from_reader(place.read("out/left_1.csv").as_bytes()).records() {
        let row = row.unwrap();
        let column = |k: usize| row[k].parse::<f64>().unwrap();
        let [traction, pressure, area] = [2, 7, 8].map(column);
        sums = [sums[0] + traction * area, sums[1] + pressure * area];
    }
    let [traction, load] = sums;
    assert!((load / number(&patch["normal_force_n"]) - 1.0).abs() < 0.01, "{load} {patch}");
    assert!((traction / number(&patch["longitudinal_n"]) - 1.0).abs() < 0.03, "{traction} {patch}");
    // One contact a wheel: the longest arrow is the larger of two forces.
    let across = |side| force(side, "lateral_n").hypot(force(side, "vertical_n"));
    let words = format!("longest {:.0}", 1e-3 * across("left").max(across("right")));
    assert!(place.read("out/wheelset.svg").contains(&words), "{words}");
}

#[test]
fn a_table_is_written_whole() {
    let place = Place::new();
    place.write("case.toml", one_wheel());
    place.run(&["wheelset", "case.toml", "--table", "t.nc", "--y", "0.001", "0.003", "2"]).done();
    assert!(fs::read(place.path("t.nc")).unwrap().starts_with(b"CDF"));
    let heights = ["wheelset", "case.toml", "--table", "z.nc", "--z", "2e-4", "3e-4", "2"];
    place.run(&heights).done();
    fs::remove_file(place.path("z.nc")).unwrap();
    let wrong = ["wheelset", "case.toml", "--table", "u.nc", "--y", "0", "1", "0.5"];
    place.run(&wrong).refused(&["--y = 0.5", "a whole COUNT"]);
    let same = ["wheelset", "case.toml", "--table", "u.nc", "--y", "0.001", "0.001", "3"];
    place.run(&same).refused(&["--y = 0.001", "two different ends, or COUNT 1"]);
    let zero = ["wheelset", "case.toml", "--table", "u.nc", "--yaw", "0", "-0", "2"];
    place.run(&zero).refused(&["--yaw = ", "two different ends"]);
    let mut endless =
        vec!["wheelset", "case.toml", "--table", "u.nc", "--y", "0", "0.006", "40000"];
    endless.extend(["--yaw", "0", "0.01", "50000"]);
    place.run(&endless).refused(&["2000000000 positions are too many", "1000000 at most"]);
    assert_eq!(place.files(), ["case.toml", "t.nc"]);
}

#[track_caller]
fn refused(old: &str, new: &str, parts: &[&str]) {
    let text = one_wheel();
    assert!(text.contains(old), "{old} is not in the case");
    let place = Place::new();
    place.write("case.toml", text.replacen(old, new, 1));
    place.run(&["wheelset", "case.toml", "--out", "out"]).refused(parts);
    assert_eq!(place.files(), ["case.toml"]);
}

#[test]
fn what_is_wrong_is_named() {
    refused("wheel_load = 10e3", "", &["[wheelset] needs one of axle_load, wheel_load and z"]);
    refused("wheel_load = 10e3", "wheel_load = -1", &["[wheelset] wheel_load = -1", "positive"]);
    refused("wheel_load = 10e3", "axle_load = 1e3", &["axle_load makes no sense with side"]);
    refused("friction = 0.3", "friction = 0", &["[contact] friction = 0", "positive and finite"]);
    refused("friction = 0.3", "friction = 0.3\nslip = \"flt\"", &["slip", "`flat` or `curved`"]);
    refused("pitch_rate = 4.3451503", "torque = 1e9", &["torque", "it can carry"]);
    refused("speed = 2.0", "speed = 0.0\ntorque = 1.0", &["[motion] torque", "pitch_rate"]);
    refused("yaw = 0.0072 ", "yaw = 0.72 ", &["[wheelset] yaw = 0.72", "-0.5 to 0.5 rad"]);
    refused("y = 0.003 ", "y = 0.3 ", &["Right wheel", "y = 0.3 m"]);
    refused("resolution = \"fast\"", "theory = \"polach\"", &["\"polach\" needs an ellipse"]);
    refused("pitch_rate = 4.3451503", "pitch_rate = -40.0", &["[motion]", "roll forward"]);
    for section in ["[motion]", "[contact]", "[materials]"] {
        let text = one_wheel();
        let start = text.find(section).unwrap();
        let end = text[start + 1..].find("\n[").map_or(text.len(), |at| start + 1 + at);
        let place = Place::new();
        place.write("case.toml", format!("{}{}", &text[..start], &text[end..]));
        place.run(&["wheelset", "case.toml"]).refused(&[&format!("section {section} is missing")]);
    }
}

/// A wheel above its rail: no force, and no contact.
#[test]
fn a_wheel_may_hang_above_its_rail() {
    let report = solved(&one_wheel().replace("wheel_load = 10e3", "z = -0.001"));
    assert_eq!(report["right"]["patches"], Value::Array(vec![]));
    assert!(number(&report["right"]["force"]["vertical_n"]).abs() < 1e-12);
}

/// Free to roll, it hangs too.
#[test]
fn a_wheelset_may_hang_above_its_rails() {
    let text = example("s1002-on-uic60.toml").replace("axle_load = 200e3", "z = -0.01");
    let report = solved(&text);
    for side in ["left", "right"] {
        assert!(number(&report[side]["force"]["vertical_n"]).abs() < 1e-12);
        assert!(report[side]["patches"].as_array().unwrap().is_empty());
    }
}

/// The simplified theories on the exact pressures: within what they err by of the full theory, sliding at
/// the bound, and no error bars where a theory has none.
#[test]
fn simplified_theories_roll_on_the_same_contacts() {
    let by = |theory: &str| {
        let options = format!("theory = \"{theory}\"");
        solved(&one_wheel().replace("resolution = \"fast\"", &options))
    };
    let force = |report: &Value| {
        let force = &report["right"]["force"];
        ["longitudinal_n", "lateral_n", "vertical_n"].map(|key| number(&force[key]))
    };
    let exact = force(&solved(&one_wheel()));
    let limit = 0.3 * 9774.0;
    for theory in ["fastsim", "fastrip"] {
        let report = by(theory);
        assert_eq!(report["theory"], theory);
        assert!(report["right"]["force"]["longitudinal_error_n"].is_null());
        let found = force(&report);
        for k in 0..3 {
            // FASTSIM errs by up to 7 % of mu N on such areas.
            assert!((found[k] - exact[k]).abs() < 0.07 * limit, "{theory}: {found:?} {exact:?}");
        }
    }
    let patch = &by("saturated")["right"]["patches"][0];
    let [load, x, s] =
        ["normal_force_n", "longitudinal_n", "lateral_n"].map(|key| number(&patch[key]));
    let slides = x.hypot(s) / (0.3 * load);
    // With spin the slip turns within the contact, which takes a part of the force.
    assert!((0.8..1.0 + 1e-9).contains(&slides), "{slides}");
}

/// Under its load a wheel's height follows, and so has no derivative; what has one is in the report.
#[test]
fn derivatives_are_in_the_report() {
    let place = Place::new();
    place.write("case.toml", one_wheel());
    let report = json(&place.run(&["wheelset", "case.toml", "--json", "--derivatives"]).done());
    let derivatives = &report["right"]["derivatives"];
    assert!(derivatives["z_m"].is_null() && report["left"].is_null());
    for key in ["y_m", "roll_rad", "yaw_rad", "pitch_rate_rad_per_s", "lateral_velocity_m_per_s"] {
        // The load is kept to the rounding of stiffnesses of 1e9 N/m.
        assert!(number(&derivatives[key]["vertical_n"]).abs() < 1e-3, "{key}: {derivatives}");
        assert!(number(&derivatives[key]["lateral_n"]).abs() > 0.0, "{key}: {derivatives}");
    }
    // A wheel that turns faster pushes the rail back.
    assert!(number(&derivatives["pitch_rate_rad_per_s"]["longitudinal_n"]) < 0.0);
    assert!(solved(&one_wheel())["right"]["derivatives"].is_null());
    let text = place.run(&["wheelset", "case.toml", "--derivatives"]).done();
    assert!(text.contains("by lateral velocity") && !text.contains("by z "), "{text}");
}

/// Rows of positions, loads and friction have what the wheelset alone has; a row that is wrong says why, one
/// without a load is no contact.
#[test]
fn rows_of_a_wheelset_are_solved() {
    let text = example("s1002-on-uic60.toml") + "\n[solve]\ntheory = \"fastsim\"\n";
    let place = Place::new();
    place.write("case.toml", &text);
    place.write(
        "rows.csv",
        "name,y,axle_load,friction,speed\na,0.001,180e3,,\nb,0.001,180e3,0.2,-30\nc,,0,,\nd,0.5,,,\n",
    );
    let arguments = ["batch", "--case", "case.toml", "--in", "rows.csv", "--out", "out.csv"];
    assert_eq!(place.run(&arguments).code, Some(3));
    let out = place.read("out.csv");
    let rows: Vec<Vec<&str>> = out.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| rows[0].iter().position(|own| *own == name).unwrap();
    let one =
        text.replace("y = 0.002 ", "y = 0.001 ").replace("axle_load = 200e3", "axle_load = 180e3");
    let alone = solved(&one);
    let force = &alone["right"]["force"];
    for (key, name) in
        [("lateral_n", "right_lateral_n"), ("longitudinal_n", "right_longitudinal_n")]
    {
        let found: f64 = rows[1][column(name)].parse().unwrap();
        assert_eq!(found.to_bits(), number(&force[key]).to_bits(), "{name}");
    }
    let status = column("status");
    let words: Vec<&str> = rows[1..].iter().map(|row| row[status]).collect();
    assert_eq!(words, ["solved", "solved", "no_contact", "invalid"]);
    assert_eq!(rows[3][column("left_vertical_n")], "0.0");
    // Backwards the pitch rate has the other sign.
    assert!(rows[2][column("left_pitch_rate_rad_per_s")].starts_with('-'));
    place.write("none.csv", "name\na\n");
    let failure = place.run(&["batch", "--case", "case.toml", "--in", "none.csv"]);
    failure.refused(&["roll_moment"]);
}
