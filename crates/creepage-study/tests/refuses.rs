//! Every way to write a wrong case file, and the message that it gets.

use creepage_study::{CaseFile, theory_spec};

mod common;
use common::{WHEEL_ON_RAIL, edited};

fn message(text: &str) -> String {
    let error = match CaseFile::read(text) {
        Err(error) => error,
        Ok(file) => file.case().err().unwrap_or_else(|| unreachable!("not refused: {text}")),
    };
    error.to_string()
}

/// Replaces the first `old` by `new`; all of `parts` must be in the message.
#[track_caller]
fn refused(old: &str, new: &str, parts: &[&str]) {
    let message = message(&edited(old, new));
    for part in parts {
        assert!(message.contains(part), "`{part}` is not in: {message}");
    }
}

fn without_radii() -> String {
    let lines = WHEEL_ON_RAIL.lines().filter(|line| !line.starts_with("radius"));
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn broken_toml_is_shown_where_it_breaks() {
    refused("poisson = 0.28", "poisson = ", &["line 4", "poisson = "]);
    refused("[lower]", "[lower", &["line 8"]);
    refused("poisson = 0.28", "poisson = 0.28\npoisson = 0.3", &["duplicate key", "line 5"]);
}

#[test]
fn a_value_of_the_wrong_kind_is_shown_where_it_stands() {
    refused("= 0.46", "= \"round\"", &["radius_rolling", "metres or \"flat\""]);
    refused("= 0.28", "= \"steel\"", &["poisson", "expected f64"]);
}

#[test]
fn an_option_of_the_wrong_kind_is_named_with_its_value() {
    let refused = |option: &str, parts: &[&str]| {
        let solve = format!("[solve]\ntheory = \"variational\"\n{option}\n[creepage]");
        refused("[creepage]", &solve, &[&["[solve] "], parts].concat());
    };
    refused(
        "degree = 2.5",
        &[
            "degree = 2.5 is not valid for variational",
            "expected a whole number that is not negative",
        ],
    );
    refused("degree = -1", &["degree = -1"]);
    refused("mesh = [1, 2, 3]", &["mesh = [1, 2, 3]"]);
    refused("weight = \"heavy\"", &["heavy", "uniform"]);
    refused("grid = [9, 9]", &["`grid` is an option of fastrip and fastsim, not of variational"]);
    refused("gird = [9, 9]", &["unknown key `gird`", "did you mean `grid`?"]);
}

#[test]
fn unknown_keys_get_a_suggestion() {
    refused("friction", "fricton", &["`fricton` in [contact]", "`friction`?"]);
    refused("poisson", "poissons_ratio", &["[upper]", "did you mean `poisson`?"]);
    refused("[creepage]", "[creep]", &["`creep` in the file", "did you mean `creepage`?"]);
    refused("[creepage]", "poisson = 0.3\n[creepage]", &["did you mean `poisson` in [lower]?"]);
    refused("friction", "mu", &["`mu` in [contact]", "known are", "friction", "normal_force"]);
}

#[test]
fn missing_keys_and_sections_are_named() {
    refused("poisson = 0.28", "", &["[upper] poisson is missing"]);
    refused("shear_modulus = 82e9", "", &["[upper] needs shear_modulus or young_modulus"]);
    refused("radius_lateral = 0.3", "", &["[lower] radius_lateral is missing"]);
    refused("normal_force = 80e3", "", &["[contact] normal_force is missing"]);
    refused("friction = 0.3", "", &["[contact] friction is missing"]);
    let until = |section: &str| message(&WHEEL_ON_RAIL[..WHEEL_ON_RAIL.find(section).unwrap()]);
    assert!(until("[lower]").starts_with("section [lower] is missing"));
    assert!(until("[contact]").starts_with("section [contact] is missing"));
    assert!(until("[creepage]").starts_with("section [creepage] is missing: it needs longitud"));
    assert!(message("").starts_with("section [upper] is missing"));
}

#[test]
fn contradictions_name_both_sides() {
    let parts = &["[upper] shear_modulus", "[upper] young_modulus", "exclude each other"];
    refused("poisson", "young_modulus = 2e11\npoisson", parts);
    refused("spin", "chi", &["[creepage] longitudinal", "[creepage] chi"]);
    let axes = "semi_axis_rolling = 6e-3\nsemi_axis_lateral = 4e-3\nfriction";
    refused("friction", axes, &["[contact] semi_axis_rolling", "[upper] radius_rolling"]);
    let no_radii = without_radii();
    let turned = no_radii.replace("friction", &format!("angle = 3\n{axes}"));
    assert!(message(&turned).contains("[contact] angle"));
    let half = no_radii.replace("friction", "semi_axis_lateral = 4e-3\nfriction");
    assert_eq!(message(&half), "[contact] semi_axis_rolling is missing");
}

#[test]
fn numbers_out_of_range_are_named_with_the_range() {
    refused("0.28", "0.6", &["[upper] poisson = 0.6", "between 0 and 0.5"]);
    refused("0.28", "nan", &["[upper] poisson = NaN"]);
    refused("82e9", "-1", &["[upper] shear_modulus = -1", "greater than zero"]);
    refused("shear_modulus = 82e9", "young_modulus = inf", &["[upper] young_modulus = inf"]);
    refused("0.46", "0", &["[upper] radius_rolling = 0", "not zero"]);
    refused("0.46", "nan", &["[upper] radius_rolling = NaN"]);
    refused("0.46", "inf", &["[upper] radius_rolling = inf", "\"flat\""]);
    refused("80e3", "0", &["[contact] normal_force = 0", "greater than zero"]);
    refused("80e3", "1e999", &["line 15"]);
    refused("friction = 0.3", "friction = -1", &["[contact] friction = -1", "greater than zero"]);
    refused("friction = 0.3", "friction = nan", &["[contact] friction = NaN"]);
    refused("friction", "angle = nan\nfriction", &["[contact] angle = NaN"]);
    refused("spin = 0.2", "spin = nan", &["[creepage] spin = NaN", "finite"]);
    refused("lateral = 1e-3", "lateral = inf", &["[creepage] lateral = inf", "finite"]);
}

#[test]
fn bodies_without_a_contact_ellipse_are_shown_with_their_radii() {
    let parts = &["[upper] radius_rolling = -0.46", "[lower] radius_rolling = \"flat\"", "touch"];
    refused("0.46", "-0.46", parts);
    let hollow = WHEEL_ON_RAIL.replace("0.46", "-0.46").replace("0.3\n", "-0.3\n");
    assert!(message(&hollow).contains("cannot touch"));
    let line = edited("radius_lateral = 0.3", "radius_lateral = \"flat\"");
    assert!(message(&line).contains("line contact"));
}

#[test]
fn a_tilted_ellipse_is_refused_with_both_angles() {
    let message = message(&edited("friction", "angle = 30\nfriction"));
    assert!(message.starts_with("[contact] angle = 30 degrees turns the contact ellipse by"));
}

#[test]
fn semi_axes_out_of_range_are_named() {
    let radii_gone = without_radii();
    let with = |a: &str, b: &str| {
        let axes = format!("semi_axis_rolling = {a}\nsemi_axis_lateral = {b}\nfriction");
        message(&radii_gone.replace("friction", &axes))
    };
    assert!(with("-1", "1").starts_with("[contact] semi_axis_rolling = -1"));
    assert!(with("1", "nan").starts_with("[contact] semi_axis_lateral = NaN"));
    assert!(with("1", "1e-9").contains("between 1e-6 and 1e6"));
}

#[test]
fn wanted_forces_and_creepages_must_be_three() {
    let wanted = |lines: &str| {
        let text = format!("{WHEEL_ON_RAIL}\n[wanted]\n{lines}\n");
        CaseFile::read(&text).and_then(|file| file.case()).unwrap_err().to_string()
    };
    let four = wanted("longitudinal_force = 1e3");
    assert!(
        four.contains("give 4 of six quantities (longitudinal, lateral, spin, longitudinal_force)")
    );
    assert!(
        wanted("moment = nan")
            .contains("[wanted] moment = NaN is not reachable: friction gives at most 16")
    );
    assert!(
        wanted("fx = inf").contains("[wanted] fx = inf is not reachable: friction gives at most 1")
    );
    assert!(wanted("fx = 0.1\nmoment = 1").contains("[wanted] moment and [wanted] fx exclude"));
    let too_much =
        "[wanted] longitudinal_force = -25000.0 is not reachable: friction gives at most 24000";
    assert_eq!(wanted("longitudinal_force = -25e3"), too_much);
    assert!(wanted("mz = 1.2").contains("friction gives at most 1.15"));
    assert!(wanted("lateral = 1").contains("did you mean `lateral_force`?"));
    refused("[creepage]", "[wanteds]\n[creepage]", &["did you mean `wanted`?"]);
    let none = edited("spin = 0.2", "").replace("lateral = 1e-3", "").replace("longi", "# ");
    let text = format!("{none}\n[wanted]\nlateral_force = 0\n");
    let error = CaseFile::read(&text).unwrap().case().unwrap_err().to_string();
    assert!(error.contains("give 1 of six quantities (lateral_force)"), "{error}");
}

#[test]
fn a_speed_must_be_positive() {
    for speed in ["0", "-20", "inf", "nan"] {
        let text = format!("speed = {speed}\nspin = 0.2");
        refused("spin = 0.2", &text, &["[creepage] speed = ", "greater than zero"]);
    }
}

#[test]
fn a_resolution_is_a_word_or_two_numbers() {
    let solve = |value: &str| format!("[solve]\nresolution = {value}\n[creepage]");
    refused("[creepage]", &solve("\"coarse\""), &["coarse", "\"auto\""]);
    refused("[creepage]", &solve("[20]"), &["resolution = [20]", "two numbers of elements"]);
    refused("[creepage]", &solve("[20, 20, 20]"), &["[20, 20, 20]", "two numbers of elements"]);
    refused("[creepage]", &solve("20"), &["resolution = 20", "two numbers of elements"]);
}

#[test]
fn options_outside_a_file_are_checked_as_in_it() {
    let message = |option: &str| theory_spec("variational", &[option]).unwrap_err().to_string();
    assert!(message("grd=[1, 2]").contains("unknown key `grd` in [solve]: did you mean `grid`?"));
    assert!(message("weight=heavy").contains("heavy"));
    assert!(message("degree=x").contains("expected a whole number that is not negative"));
    assert!(message("degree").contains("degree"));
    let twice = theory_spec("variational", &["degree=3", "degree=4"]).unwrap_err();
    assert!(twice.to_string().contains("duplicate"));
}
