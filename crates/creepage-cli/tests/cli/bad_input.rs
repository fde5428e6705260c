//! Bad input: a message that names the field, exit code 2, and nothing written.

use crate::place::{CASE, Place};

/// Solves the case with the first `old` replaced by `new`; it must be refused.
#[track_caller]
fn refused(old: &str, new: &str, parts: &[&str]) {
    assert!(CASE.contains(old), "{old} is not in the case");
    let place = Place::new();
    place.write("case.toml", CASE.replacen(old, new, 1));
    place.run(&["solve", "case.toml", "--out", "out"]).refused(parts);
    assert_eq!(place.files(), ["case.toml"]);
}

#[test]
fn a_missing_file() {
    let place = Place::new();
    for command in ["solve", "hertz"] {
        place.run(&[command, "nowhere.toml"]).refused(&["cannot read nowhere.toml"]);
    }
    place
        .run(&["batch", "--theory", "variational", "--in", "x.csv", "--out", "y.csv"])
        .refused(&["cannot read x.csv"]);
    assert!(place.files().is_empty());
}

#[test]
fn a_directory_or_bytes_in_place_of_a_case() {
    let place = Place::new();
    place.run(&["solve", "."]).refused(&["cannot read ."]);
    place.run(&["batch", "--theory", "variational", "--in", "."]).refused(&["cannot read ."]);
    place.write("case.toml", [0xff, 0xfe, 0x00]);
    place.run(&["solve", "case.toml"]).refused(&["case.toml", "UTF-8"]);
}

#[test]
fn broken_toml() {
    refused("[lower]", "[lower", &["case.toml", "line 8", "[lower"]);
}

#[test]
fn an_unknown_key() {
    refused("friction", "fricton", &["case.toml", "`fricton` in [contact]", "`friction`?"]);
}

#[test]
fn not_a_number() {
    refused("spin = 0.2", "spin = nan", &["[creepage] spin = NaN"]);
    refused("80e3", "nan", &["[contact] normal_force = NaN"]);
}

#[test]
fn a_negative_radius_that_no_flat_body_can_touch() {
    refused("0.46", "-0.46", &["[upper] radius_rolling = -0.46", "cannot touch"]);
}

#[test]
fn a_negative_semi_axis() {
    let place = Place::new();
    let lines = CASE.lines().filter(|line| !line.starts_with("radius"));
    let case = lines.collect::<Vec<_>>().join("\n");
    let axes = "semi_axis_rolling = -6e-3\nsemi_axis_lateral = 5e-3\nfriction";
    place.write("case.toml", case.replace("friction", axes));
    place.run(&["solve", "case.toml"]).refused(&["[contact] semi_axis_rolling = -0.006"]);
}

#[test]
fn a_poisson_ratio_above_a_half() {
    refused("0.28", "0.6", &["[upper] poisson = 0.6", "between 0 and 0.5"]);
}

#[test]
fn a_negative_friction() {
    refused("friction = 0.3", "friction = -1", &["[contact] friction = -1", "greater than zero"]);
}

#[test]
fn no_load() {
    refused("80e3", "0.0", &["[contact] normal_force = 0", "greater than zero"]);
}

#[test]
fn two_hollow_bodies() {
    let place = Place::new();
    let hollow = CASE.replace("0.46", "-0.46").replace("0.3\n\n", "-0.3\n\n");
    place.write("case.toml", hollow);
    for command in ["solve", "hertz"] {
        place.run(&[command, "case.toml"]).refused(&["radius_lateral = -0.3", "cannot touch"]);
    }
}

#[test]
fn a_degree_of_99() {
    refused("degree = 3", "degree = 99", &["[solve] degree = 99", "between 0 and 12"]);
    refused("degree = 3", "mesh = [2, 2]", &["[solve] mesh = 2 x 2"]);
}

#[test]
fn an_unknown_theory() {
    refused(
        "\"variational\"",
        "\"variatonal\"",
        &["unknown theory", "did you mean `variational`?"],
    );
    let place = Place::new();
    place.write("case.toml", CASE);
    let ran = place.run(&["solve", "case.toml", "--theory", "magic"]);
    ran.refused(&["unknown theory `magic`", "known are exact, "]);
    place.run(&["batch", "--theory", "magic", "--out", "o.csv"]).refused(&["`magic`"]);
    assert_eq!(place.files(), ["case.toml"]);
}

#[test]
fn an_out_that_cannot_be_written() {
    let place = Place::new();
    place.write("case.toml", CASE);
    place.write("file", "in the way");
    place.run(&["solve", "case.toml", "--out", "file/out"]).refused(&["cannot write file/out"]);
    place.run(&["solve", "case.toml", "--out", "file"]).refused(&["cannot write file"]);
    place.run(&["init", "--out", "file/case.toml"]).refused(&["cannot write file/case.toml"]);
    let batch = |out| {
        let command = ["batch", "--theory", "variational", "--out", out];
        place.run_on(&command, "a_over_b,poisson,xi,eta,chi\n1,0.3,1,0,0\n")
    };
    batch("file/out.csv").refused(&["cannot write file/out.csv"]);
    batch("nowhere/out.csv").refused(&["cannot write nowhere/out.csv"]);
    batch(".").refused(&["cannot write ."]);
    assert_eq!(place.files(), ["case.toml", "file"]);
    assert_eq!(place.read("file"), "in the way");
}

#[test]
fn all_cases_are_read_before_the_first_is_solved() {
    let place = Place::new();
    place.write("good.toml", CASE);
    place.write("bad.toml", CASE.replace("friction = 0.3", "friction = -1"));
    place.write("line.toml", "[contact]\nline_load = -1.0\n");
    let files = place.files();
    for (bad, words) in [
        ("bad.toml", "bad.toml: [contact] friction = -1"),
        ("line.toml", "line.toml: "),
        ("none.toml", "cannot read none.toml"),
    ] {
        place.run(&["solve", "good.toml", bad]).refused(&[words]);
        place.run(&["solve", "good.toml", bad, "--out", "out"]).refused(&[words]);
    }
    let magic = ["solve", "good.toml", "good.toml", "--theory", "magic"];
    place.run(&magic).refused(&["unknown theory `magic`"]);
    assert_eq!(place.files(), files);
}

#[test]
fn standard_input_is_one_case() {
    let place = Place::new();
    place.write("case.toml", CASE);
    let twice = place.run_on(&["solve", "-", "case.toml", "-"], CASE);
    twice.refused(&["standard input (-) is given twice"]);
    let once = place.run_on(&["solve", "-", "case.toml", "--theory", "linear"], CASE).done();
    assert!(once.starts_with("== -\n") && once.contains("\n== case.toml\n"), "{once}");
}

#[test]
fn a_wrong_command_line() {
    let place = Place::new();
    for arguments in [&["solve"][..], &["bach"], &["batch"], &["hertz", "a", "b"], &[]] {
        assert_eq!(place.run(arguments).code, Some(2), "{arguments:?}");
    }
}
