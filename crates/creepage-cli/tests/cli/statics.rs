//! `creepage statics` on good and bad input.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::place::{Place, json};

const SLIP: &str = r#"
[upper]
shear_modulus = 82e9
poisson = 0.28
[lower]
shear_modulus = 82e9
poisson = 0.28
[contact]
normal_force = 80e3
friction = 0.3
semi_axis_rolling = 6e-3
semi_axis_lateral = 4e-3
[statics]
problem = "partial-slip"
force_x = 21e3
"#;

fn examples() -> Vec<PathBuf> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/statics");
    fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path()).collect()
}

fn report(place: &Place, path: &str) -> Value {
    json(&place.run(&["statics", path, "--json"]).done())
}

fn number(report: &Value, key: &str) -> f64 {
    report["found"][key].as_f64().unwrap_or_else(|| panic!("{key} is not in {report}"))
}

#[test]
fn every_example_is_solved_and_every_problem_has_one() {
    let place = Place::new();
    let mut problems: Vec<String> = vec![];
    for path in examples() {
        let report = report(&place, path.to_str().unwrap());
        for (key, value) in report["found"].as_object().unwrap() {
            assert!(value.is_f64(), "{}: {key} is {value}", path.display());
        }
        problems.push(report["problem"].as_str().unwrap().into());
    }
    problems.sort();
    let all =
        ["compression", "die", "partial-slip", "sheared-rectangle", "shift", "shift-path", "twist"];
    assert_eq!(problems, all);
    assert!(place.files().is_empty());
}

#[test]
fn the_files_are_written_and_the_report_is_the_printed_one() {
    let place = Place::new();
    place.write("case.toml", SLIP);
    let printed = place.run(&["statics", "case.toml", "--json", "--out", "deep/out"]).done();
    assert_eq!(json(&printed), json(&place.read("deep/out/report.json")));
    for file in ["contact.svg", "contact.png"] {
        assert!(place.path("deep/out").join(file).is_file(), "{file}");
    }
    let points = place.read("deep/out/points.csv");
    assert!(points.starts_with("x_m,y_m,traction_x_pa,"));
    assert!(points.lines().count() > 1000);
}

/// Seven eighths of the limit leave half the axes for adhesion (3.62).
#[test]
fn partial_slip_is_that_of_the_thesis() {
    let place = Place::new();
    place.write("case.toml", SLIP);
    let report = report(&place, "case.toml");
    let close = |key: &str, expected: f64| {
        let value = number(&report, key);
        assert!((value / expected - 1.0).abs() < 1e-12, "{key} = {value}, not {expected}");
    };
    close("friction_used_percent", 87.5);
    close("adhesion_a_m", 3e-3);
    close("adhesion_percent", 25.0);
    // At the edge of adhesion the bound is that of r = 1/2.
    let bound = 0.3 * report["given"]["peak_pressure_pa"].as_f64().unwrap();
    close("peak_traction_pa", bound * 0.75_f64.sqrt());
    let text = place.run(&["statics", "case.toml"]).done();
    for words in ["adhesion, semi-axis along x", "3 mm", "slip to traction, at most"] {
        assert!(text.contains(words), "`{words}` is not in:\n{text}");
    }
}

/// The shift per force at vanishing force is the shift without slip (3.34).
#[test]
fn partial_slip_of_a_small_force_is_a_shift_without_slip() {
    let place = Place::new();
    place.write("slip.toml", SLIP.replace("21e3", "0.021"));
    let shift = SLIP.replace("partial-slip", "shift").replace("friction = 0.3", "");
    place.write("shift.toml", shift);
    let stiffness = number(&report(&place, "shift.toml"), "stiffness_x_n_per_m");
    let shift = number(&report(&place, "slip.toml"), "shift_x_m");
    // The first correction is a sixth of the share of friction used, 1e-6.
    assert!((0.021 / shift / stiffness - 1.0).abs() < 1e-6);
}

#[track_caller]
fn refused(old: &str, new: &str, parts: &[&str]) {
    assert!(SLIP.contains(old), "{old} is not in the case");
    let place = Place::new();
    place.write("case.toml", SLIP.replacen(old, new, 1));
    place.run(&["statics", "case.toml", "--out", "out"]).refused(parts);
    assert_eq!(place.files(), ["case.toml"]);
}

#[test]
fn bad_input_is_refused_and_nothing_is_written() {
    refused("force_x", "force_z", &["case.toml", "`force_z` in [statics]", "did you mean"]);
    refused("21e3", "25e3", &["case.toml", "[statics] force_x", "25000 N", "24000 N"]);
    refused("21e3", "nan", &["[statics] force_x = NaN"]);
    refused("0.28", "0.8", &["[upper] poisson = 0.8", "between 0 and 0.5"]);
    refused("friction = 0.3", "", &["[contact] friction is missing"]);
    refused("\"partial-slip\"", "\"roll\"", &["roll", "twist"]);
    refused("[lower]", "[lower", &["line 5"]);
}

/// Spence's ball: half of the radius sticks, to a ring of a hundred; CONTACT's approach at .4705 N is 98.74 um.
#[test]
fn balls_that_are_pressed_together() {
    let place = Place::new();
    let path = examples().into_iter().find(|path| path.ends_with("soft-ball-pressed.toml"));
    let case = fs::read_to_string(path.unwrap()).unwrap();
    place.write("ball.toml", case.replace("= 0.47 ", "= 0.4705 "));
    let found = report(&place, "ball.toml");
    let ratio = number(&found, "adhesion_radius_m") / number(&found, "contact_radius_m");
    assert!((ratio - 0.5).abs() < 0.011, "{ratio}");
    assert!((number(&found, "approach_m") / 98.74e-6 - 1.0).abs() < 0.01, "{found}");
    let refuse = |old: &str, new: &str, parts: &[&str]| {
        assert!(case.contains(old), "{old}");
        place.write("wrong.toml", case.replacen(old, new, 1));
        place.run(&["statics", "wrong.toml"]).refused(parts);
    };
    refuse("radius_lateral = 0.1215", "radius_lateral = 0.2", &["bodies of revolution", "a/b"]);
    refuse("friction = 0.2986", "", &["[contact] friction is missing"]);
    refuse("\"compression\"", "\"compression\"\nforce_x = 1.0", &["none but the normal force"]);
}

#[test]
fn a_die_that_lifts_off() {
    let place = Place::new();
    let path = examples().into_iter().find(|path| path.ends_with("die-offset-load.toml")).unwrap();
    let case = fs::read_to_string(path).unwrap();
    assert!(case.contains("offset_x = 6e-3"));
    place.write("case.toml", case.replace("offset_x = 6e-3", "offset_x = 12e-3"));
    let ran = place.run(&["statics", "case.toml", "--out", "out"]);
    ran.refused(&["[statics] offset_x = 0.012", "lifts off", "times too far out"]);
    assert_eq!(place.files(), ["case.toml"]);
}

#[test]
fn a_file_that_is_not_there_and_a_place_that_cannot_be_written() {
    let place = Place::new();
    place.run(&["statics", "nowhere.toml"]).refused(&["cannot read nowhere.toml"]);
    place.write("case.toml", SLIP);
    let ran = place.run(&["statics", "case.toml", "--out", "case.toml"]);
    ran.refused(&["cannot write case.toml"]);
    assert_eq!(place.read("case.toml"), SLIP);
}

/// Force over shift is drawn and told; the loop of the example closes, and its third stop is its first.
#[test]
fn a_path_leaves_its_steps_and_its_picture() {
    let place = Place::new();
    let example =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/statics/fretting-path.toml");
    let words = ["statics", example.to_str().unwrap(), "--json", "--out", "out"];
    place.run(&words).done();
    let report = json(&fs::read_to_string(place.path("out/report.json")).unwrap());
    let shift = |k: usize| report["steps"][k]["shift_m"].as_f64().unwrap();
    // Rounding.
    assert!((shift(2) / shift(0) - 1.0).abs() < 1e-12);
    assert!(shift(4).abs() < 1e-12 * shift(0));
    for file in ["path.csv", "path.svg", "path.png", "report.json", "contact.svg"] {
        assert!(place.files_in("out").iter().any(|name| name == file), "{file}");
    }
}

const CLAY: &str = include_str!("../../../../examples/statics/clay-sheared.toml");

/// Stored forces of CONTACT 25.2 (Apache-2.0), four digits of each, at the first three stops of the example.
#[test]
fn a_sheared_layer_has_its_path_in_text_json_and_table() {
    let place = Place::new();
    place.write("clay.toml", CLAY);
    let run = place.run(&["statics", "clay.toml", "--json", "--out", "out"]);
    let report = json(&run.done());
    let steps = report["steps"].as_array().unwrap();
    for (step, force) in steps.iter().zip([200.0, 262.4, 82.43]) {
        assert!((step["force_n"].as_f64().unwrap() - force).abs() < 0.05, "{step}");
    }
    assert_eq!((steps.len(), &report["given"]["layer_slope_pa_per_m"]), (4, &Value::from(435e9)));
    // Hardening: the yield stress has grown by the slope times what has yielded.
    let grown = 200e6 + 435e9 * number(&report, "plastic_displacement_m");
    assert!((number(&report, "yield_stress_pa") / grown - 1.0).abs() < 1e-12);
    assert!(number(&report, "sliding_way_m").abs() < f64::MIN_POSITIVE);
    let table = place.read("out/path.csv");
    assert!(
        table.starts_with("force_n,shift_m,plastic_displacement_m,sliding_way_m,dissipated_j\n")
    );
    assert_eq!(table.lines().count(), 5);
    assert!(place.path("out/contact.svg").is_file() && !place.path("out/path.svg").exists());
    let points = place.read("out/points.csv");
    assert_eq!(points.lines().count(), 1601);
    assert!(place.run(&["statics", "clay.toml"]).done().contains("yielded (um)"));
}

#[test]
fn what_is_of_rectangles_alone_is_refused_elsewhere() {
    let place = Place::new();
    for (text, words) in [
        (
            SLIP.to_string() + "[layer]\nthickness = 1e-5\nshear_modulus = 1e9\n",
            "section [layer] has no place",
        ),
        (
            SLIP.replace("[statics]", "half_length_rolling = 1e-3\n[statics]"),
            "half_length_rolling has no place in problem \"partial-slip\"",
        ),
        (CLAY.replace("half_length_lateral = 0.5e-3", ""), "half_length_lateral is missing"),
        (CLAY.replace("half_length_lateral", "semi_axis_lateral"), "semi_axis_lateral"),
        (CLAY.replace("slope = 435e9", "slope = -5.2e12"), "[layer] slope"),
        (
            CLAY.replace("{ shift = 160e-6 }", "{ force = 700 }"),
            "the force of step 3, 700 N, is more than the 630",
        ),
    ] {
        place.write("case.toml", &text);
        place.run(&["statics", "case.toml"]).refused(&[words]);
    }
}

/// Pressed more and shifted in proportion: nothing slips; then the load falls. A step without a load keeps it.
#[test]
fn a_path_may_change_its_load() {
    let place = Place::new();
    let steps = "[{ normal_force = 160e3, force = 12e3 }, { force = -12e3 }, { normal_force = 120e3, force = 0.0 }]";
    let path = SLIP
        .replace("\"partial-slip\"", "\"shift-path\"")
        .replace("force_x = 21e3", &format!("along = \"x\"\nsteps = {steps}"));
    place.write("none.toml", path.replace(steps, "[]"));
    place
        .run(&["statics", "none.toml"])
        .refused(&["[statics] number of steps = 0 is not valid: it must be 1 or more"]);
    place.write("case.toml", &path);
    let report = report(&place, "case.toml");
    let steps = report["steps"].as_array().unwrap();
    let loads: Vec<f64> = steps.iter().map(|s| s["normal_force_n"].as_f64().unwrap()).collect();
    // Sums of parts.
    for (load, right) in loads.iter().zip([160e3, 160e3, 120e3]) {
        assert!((load / right - 1.0).abs() < 1e-12, "{loads:?}");
    }
    assert_eq!(steps[0]["dissipated_j"].as_f64(), Some(0.0));
    assert!(steps[1]["dissipated_j"].as_f64() > Some(0.0));
    assert!((report["found"]["end_normal_force_n"].as_f64().unwrap() / 120e3 - 1.0).abs() < 1e-12);
    assert!(place.run(&["statics", "case.toml"]).done().contains("load (N)"));
    place.run(&["statics", "case.toml", "--out", "out"]).done();
    assert!(place.read("out/path.csv").lines().next().unwrap().ends_with(",normal_force_n"));
    for (bad, words) in
        [("normal_force = -1.0", "normal_force = -1"), ("normal_force = 20e3", "step 1")]
    {
        place.write("case.toml", path.replace("normal_force = 160e3", bad));
        place.run(&["statics", "case.toml"]).refused(&["[statics]", words]);
    }
}
