//! What was silent or falsely told when wheelsets, lines and histories were tried as users do.

use std::fs;
use std::path::Path;

use crate::place::{Place, json};

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    fs::read_to_string(path).unwrap()
}

fn wheelset() -> String {
    example("wheelset/s1002-on-uic60.toml")
}

/// The vertical forces on both rails of a solved wheelset (N).
fn vertical(place: &Place, case: &str) -> [f64; 2] {
    let report = json(&place.run(&["wheelset", case, "--json"]).done());
    ["left", "right"].map(|side| report[side]["force"]["vertical_n"].as_f64().unwrap())
}

/// Linear theory has no slip: beyond `mu N` its force is told, on wheels and on curves too.
#[test]
fn a_force_beyond_friction_is_told_on_wheels_and_curves() {
    let place = Place::new();
    let text = wheelset().replace("pitch_rate = \"free\"", "pitch_rate = 60.0");
    place.write("linear.toml", text + "\n[solve]\ntheory = \"linear\"\n");
    let ran = place.run(&["wheelset", "linear.toml"]);
    assert!(ran.stdout.contains("linear knows no slip: its force is"), "{}", ran.stdout);
    let arguments = ["curve", "case.toml", "--theory", "linear", "--points", "3", "--to", "0.01"];
    place.write("case.toml", crate::place::CASE);
    let ran = place.run(&[&arguments[..], &["--vary", "longitudinal"]].concat());
    assert!(ran.stderr.contains("linear knows no slip: its force is"), "{}", ran.stderr);
}

/// A load in kN presses wheels by less than they are rough; one in N does not, nor a tenth of it.
#[test]
fn a_load_in_kilonewtons_is_told() {
    let place = Place::new();
    let axle = |load: &str| {
        let text = example("wheelset/s1002-on-uic60.toml");
        let own = text.lines().find(|line| line.starts_with("axle_load")).unwrap().to_owned();
        text.replace(&own, &format!("axle_load = {load}")) + "\n[solve]\ntheory = \"saturated\"\n"
    };
    for (load, is_told) in [("160", true), ("160e3", false), ("16e3", false)] {
        place.write("axle.toml", axle(load));
        let ran = place.run(&["wheelset", "axle.toml"]);
        let told =
            ran.stderr.matches("into each other, less than their surfaces are rough").count();
        // Once for each wheel.
        assert_eq!(told, if is_told { 2 } else { 0 }, "{}", ran.stderr);
    }
}

/// What a steel wheel flows under is told in rows and at rest, as by `solve`.
#[test]
fn a_metal_that_flows_is_told_by_every_door() {
    const FLOWS: &str = "times the shear yield stress";
    let place = Place::new();
    let text =
        crate::place::CASE.replace("theory = \"variational\"\ndegree = 3", "theory = \"fastsim\"");
    place.write("case.toml", &text);
    let rows = place.run_on(&["batch", "--case", "case.toml"], "normal_force\n80e3\n8e6\n").done();
    let told: Vec<_> = rows.lines().skip(1).map(|row| row.contains(FLOWS)).collect();
    assert_eq!(told, [false, true], "{rows}");
    let standing = example("statics/wheel-standing-on-slope.toml");
    let load = standing.lines().find(|line| line.starts_with("normal_force")).unwrap().to_owned();
    place.write("heavy.toml", standing.replace(&load, "normal_force = 8e6"));
    place.write("standing.toml", standing);
    assert!(place.run(&["statics", "heavy.toml"]).stderr.contains(FLOWS));
    assert!(!place.run(&["statics", "standing.toml"]).stderr.contains(FLOWS));
}

/// A row of a history in per cent is named.
#[test]
fn creepages_of_a_history_in_per_cent_are_told() {
    let place = Place::new();
    let text =
        crate::place::CASE.replace("theory = \"variational\"\ndegree = 3", "theory = \"fastsim\"");
    let text = text.replace("[creepage]\nlongitudinal = -1.5e-3\nlateral = 1e-3\nspin = 0.2\n", "");
    place.write("case.toml", text);
    for (value, is_told) in [("1.5", true), ("1.5e-2", false)] {
        place.write("rows.csv", format!("distance,longitudinal\n1e-3,1e-3\n2e-3,{value}\n"));
        let ran = place.run(&["roll", "case.toml", "--history", "rows.csv"]);
        assert_eq!(
            ran.stderr.contains("row 2: the longitudinal creepage of 1.5"),
            is_told,
            "{}",
            ran.stderr
        );
    }
}

/// Nothing of an earlier run is lost where a later one could not be written; a situation has numbers.
#[test]
fn wear_is_refused_before_its_first_step() {
    let place = Place::new();
    let text = example("wear/s1002.toml");
    place.write("case.toml", text.replace("vehicle.csv", "wear.csv"));
    place.write("wear.csv", example("wear/vehicle.csv"));
    place.write("wheel_left_000.json", "of an earlier run");
    let before = place.files();
    let words = ["wear", "case.toml", "--out", "."];
    place.run(&words).refused(&["wear.csv would be written over what was read"]);
    assert_eq!(place.files(), before);
    assert_eq!(place.read("wheel_left_000.json"), "of an earlier run");
    let table = text.lines().find(|line| line.starts_with("table")).unwrap().to_owned();
    let situation = "[[wear.situation]]\nshare = 1\ny = nan\n\n[solve]";
    place.write("case.toml", text.replace(&table, "").replace("[solve]", situation));
    let words = ["wear", "case.toml", "--out", "out"];
    place.run(&words).refused(&["[wear.situation] y", "a number"]);
}

const VEHICLE: &str = "
[wheel]
profile = \"S1002\"
radius = 0.46
[rail]
profile = \"UIC60\"
cant = 0.025
[track]
gauge = 1.435
gauge_height = 0.014
curve_radius = 300
superelevation = 0.1
[wheelset]
back_to_back = 1.360
mass = 15e3
centre_height = 1.5
[motion]
speed = 20.0
[contact]
friction = 0.3
[materials]
shear_modulus = 82e9
poisson = 0.28
[solve]
theory = \"saturated\"
";

/// A row at another speed has the loads of that speed, as the file at it.
#[test]
fn loads_in_a_curve_follow_the_speed_of_each_row() {
    let place = Place::new();
    place.write("vehicle.toml", VEHICLE);
    place.write("slow.toml", VEHICLE.replace("speed = 20.0", "speed = 10.0"));
    let slow = vertical(&place, "slow.toml");
    // The outer, left wheel is the lighter one below the speed of balance, 15 m/s.
    let fast = vertical(&place, "vehicle.toml");
    assert!(slow[0] < slow[1] && fast[0] > fast[1], "{slow:?} {fast:?}");
    place.write("rows.csv", "speed\n10\n20\n");
    let rows = place.run(&["batch", "--case", "vehicle.toml", "--in", "rows.csv"]).done();
    let mut reader = csv::Reader::from_reader(rows.as_bytes());
    let names = reader.headers().unwrap().clone();
    for (row, wanted) in reader.records().map(Result::unwrap).zip([slow, fast]) {
        for (name, wanted) in ["left_vertical_n", "right_vertical_n"].iter().zip(wanted) {
            let at = names.iter().position(|one| one == *name).unwrap();
            // The same question: the last digits are those of the table.
            assert!((row[at].parse::<f64>().unwrap() / wanted - 1.0).abs() < 1e-9, "{row:?}");
        }
    }
    place.write("loads.csv", "axle_load\n150e3\n");
    let ran = place.run(&["batch", "--case", "vehicle.toml", "--in", "loads.csv"]);
    assert!(ran.stdout.contains("axle_load") && ran.stdout.contains("mass"), "{}", ran.stdout);
}

/// A theory without an integral of slip has the heat of its force and creepage.
#[test]
fn fastsim_has_heat_on_wheels() {
    let place = Place::new();
    place.write("case.toml", wheelset() + "\n[solve]\ntheory = \"fastsim\"\n");
    let report = json(&place.run(&["wheelset", "case.toml", "--json"]).done());
    let patch = &report["right"]["patches"][0];
    let number = |key: &str| patch[key].as_f64().unwrap();
    let parts = [
        ("longitudinal_n", "longitudinal_creepage"),
        ("lateral_n", "lateral_creepage"),
        ("moment_n_m", "spin_rad_per_m"),
    ];
    let wanted: f64 = parts.map(|(force, creepage)| number(force) * number(creepage)).iter().sum();
    // Rounding.
    let heat = number("frictional_power_per_metre_j_per_m");
    assert!(heat > 0.0 && (heat / wanted - 1.0).abs() < 1e-12, "{heat} {wanted}");
}

/// The keys and sections are those of the file.
#[test]
fn refusals_name_what_is_in_the_file() {
    let place = Place::new();
    let line = "[upper]\nshear_modulus = 82e9\npoisson = 0.28\nradius_rolling = -0.4\n\
                [lower]\nshear_modulus = 82e9\npoisson = 0.28\nradius_rolling = 0.5\n\
                [contact]\nline_load = 1e6\nfriction = 0.3\n[creepage]\nlongitudinal = 5e-4\n";
    place.write("line.toml", line);
    place.run(&["solve", "line.toml"]).refused(&["[upper] radius_rolling = -0.4 is not valid"]);
    let guard = "[rail_right.guard]\nprofile = \"UIC60\"\nflangeway = -0.04\n\n[track]";
    for (from, to, words) in [
        ("radius = 0.46", "radius = 460.0", "radius = 460"),
        ("[track]", guard, "[rail_right.guard]"),
        (
            "profile = \"UIC60\"",
            "profile = \"UIC60\"\nroller_radius = -0.4",
            "larger in size than the wheel's",
        ),
    ] {
        let text = wheelset();
        assert!(text.contains(from), "{from}");
        place.write("wrong.toml", text.replacen(from, to, 1));
        place.run(&["wheelset", "wrong.toml"]).refused(&["wrong.toml", words]);
    }
}

/// A column of friction that overrides different rails, and an option that unsteady rolling has not.
#[test]
fn nothing_given_is_passed_over() {
    let place = Place::new();
    place.write("two.toml", wheelset() + "\n[rail_right]\nfriction = 0.1\n");
    place.write("rows.csv", "friction\n0.2\n");
    let ran =
        place.run(&["batch", "--case", "two.toml", "--in", "rows.csv", "--theory", "saturated"]);
    assert!(ran.stderr.contains("note: the column friction holds on all rails"), "{}", ran.stderr);
    let solve = "theory = \"exact\"\nresolution = \"fast\"\ncoupled = true";
    let case = crate::place::CASE.replace("theory = \"variational\"\ndegree = 3", solve);
    let (bodies, motion) = case.split_once("[creepage]").unwrap();
    let solve = motion.split_once("[solve]").unwrap().1;
    place.write("case.toml", format!("{bodies}[solve]{solve}"));
    place.write("history.csv", "distance,longitudinal,lateral,spin\n0.001,5e-4,3e-4,0.1\n");
    place
        .run(&["roll", "case.toml", "--history", "history.csv"])
        .refused(&["[solve] coupled", "unsteadily"]);
}
