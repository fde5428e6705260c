//! Statics files: what they say, and every way to write a wrong one.

// Helpers of tests fail like tests: by panicking.
#![allow(clippy::unwrap_used)]

use creepage_study::{Caution, StaticsCase, StaticsFile, StaticsProblem, statics_json_schema};

const BODIES: &str = r#"
[upper]
shear_modulus = 82e9
poisson = 0.28
radius_rolling = 0.46
radius_lateral = "flat"

[lower]
shear_modulus = 40e9
poisson = 0.3
radius_rolling = "flat"
radius_lateral = 0.3
"#;

const DIE: &str = r#"
[lower]
shear_modulus = 40e9
poisson = 0.3

[contact]
normal_force = 20e3
semi_axis_rolling = 6e-3
semi_axis_lateral = 9e-3

[statics]
problem = "die"
offset_x = 1e-3
offset_y = -1e-3
"#;

fn with(contact: &str, statics: &str) -> String {
    format!("{BODIES}\n[contact]\n{contact}\n[statics]\n{statics}\n")
}

fn slip() -> String {
    with("normal_force = 80e3\nfriction = 0.3", "problem = \"partial-slip\"\nforce_x = 12e3")
}

fn solved(text: &str) -> StaticsCase {
    StaticsFile::read(text).unwrap().solve().unwrap()
}

/// All of `parts` must be in the message.
#[track_caller]
fn refused(text: &str, parts: &[&str]) {
    let message = match StaticsFile::read(text) {
        Err(error) => error.to_string(),
        Ok(file) => file.solve().unwrap_err().to_string(),
    };
    for part in parts {
        assert!(message.contains(part), "`{part}` is not in: {message}");
    }
}

#[test]
fn each_problem_is_solved() {
    let StaticsProblem::Die { offset, die, .. } = solved(DIE).problem else { panic!("not a die") };
    assert!(offset[0] > 0.0 && offset[1] < 0.0);
    assert!(die.tilt()[0] > 0.0 && die.tilt()[1] < 0.0);

    let shift = solved(&with("normal_force = 80e3", "problem = \"shift\"\nforce_y = -2e3"));
    let StaticsProblem::Shift { force, bonded, .. } = shift.problem else { panic!("not a shift") };
    assert!(force[0].abs() < 1e-9 && (force[1] + 2e3).abs() < 1e-9);
    assert!(bonded.shift()[1] < 0.0);

    let twist = solved(&with("normal_force = 80e3", "problem = \"twist\"\nmoment = 5.0"));
    let StaticsProblem::Twist { bonded, .. } = twist.problem else { panic!("not a twist") };
    assert!(bonded.twist() > 0.0);

    let StaticsProblem::PartialSlip { contact, partial, .. } = solved(&slip()).problem else {
        panic!("no partial slip")
    };
    // Half of the limit of friction leaves the cube root of a half.
    let scale = partial.adhesion().a() / contact.ellipse().a();
    assert!((scale.powi(3) - 0.5).abs() < 1e-14);
}

#[test]
fn given_semi_axes_need_no_load_where_nothing_slips() {
    let bodies: Vec<_> = BODIES.lines().filter(|line| !line.starts_with("radius")).collect();
    let bodies = bodies.join("\n");
    let axes = "semi_axis_rolling = 5e-3\nsemi_axis_lateral = 4e-3";
    let text = format!("{bodies}\n[contact]\n{axes}\n[statics]\nproblem = \"shift\"\nforce_x = 1");
    let StaticsProblem::Shift { ellipse, .. } = solved(&text).problem else {
        panic!("not a shift")
    };
    assert!((ellipse.a() - 5e-3).abs() < 1e-18 && (ellipse.b() - 4e-3).abs() < 1e-18);
    // With a load they say the same.
    let loaded = text.replace("[contact]", "[contact]\nnormal_force = 1e3");
    let StaticsProblem::Shift { ellipse: same, .. } = solved(&loaded).problem else {
        panic!("not a shift")
    };
    assert_eq!(ellipse, same);
    refused(
        &text.replace("[lower]", "[lower]\nradius_rolling = 1.0"),
        &["[contact] semi_axis_rolling", "[lower] radius_rolling", "exclude"],
    );
    refused(&text.replace("semi_axis_lateral = 4e-3", ""), &["normal_force is missing"]);
}

#[test]
fn a_load_of_another_problem_is_refused() {
    let text = DIE.replace("offset_x", "force_x");
    refused(&text, &["[statics] force_x", "\"die\"", "offset_x, offset_y"]);
    refused(&format!("{}moment = 1.0", slip()), &["[statics] moment", "\"partial-slip\""]);
    let text = format!("{DIE}\n[upper]\npoisson = 0.3\nshear_modulus = 1e9");
    refused(&text, &["[upper]", "the die is rigid"]);
}

#[test]
fn unknown_and_missing_keys_are_named() {
    refused(&DIE.replace("offset_x", "ofset_x"), &["`ofset_x` in [statics]", "`offset_x`?"]);
    refused(&DIE.replace("[statics]", "[static]"), &["`static` in the file", "`statics`?"]);
    refused(&DIE.replace("\"die\"", "\"dice\""), &["dice", "partial-slip"]);
    refused(&DIE.replace("problem = \"die\"", ""), &["[statics] problem is missing"]);
    refused(&DIE[..DIE.find("[statics]").unwrap()], &["section [statics] is missing"]);
    refused(&DIE.replace("normal_force = 20e3", ""), &["[contact] normal_force is missing"]);
    refused(&DIE.replace("semi_axis_lateral = 9e-3", ""), &["semi_axis_lateral is missing"]);
    refused(&slip().replace("friction = 0.3", ""), &["[contact] friction is missing"]);
    refused(&slip().replace("force_x = 12e3", ""), &["[statics] needs force_x or force_y"]);
    refused(&with("normal_force = 1", "problem = \"twist\""), &["[statics] moment is missing"]);
    let lower_only = slip().replace(&BODIES[..BODIES.find("[lower]").unwrap()], "");
    refused(&lower_only, &["section [upper] is missing"]);
    refused(&format!("{}\n[creepage]\nspin = 1.0", slip()), &["unknown key `creepage`"]);
}

#[test]
fn numbers_out_of_range_are_named_with_the_range() {
    refused(&DIE.replace("20e3", "-1"), &["[contact] normal_force = -1", "greater than zero"]);
    refused(&DIE.replace("= 6e-3", "= 0"), &["[contact] semi_axis_rolling = 0"]);
    refused(&DIE.replace("= 1e-3", "= nan"), &["[statics] offset_x = NaN", "finite"]);
    refused(&DIE.replace("= 0.3", "= 0.7"), &["[lower] poisson = 0.7", "between 0 and 0.5"]);
    refused(&slip().replace("12e3", "inf"), &["[statics] force_x = inf", "finite"]);
    refused(&slip().replace("12e3", "0"), &["[statics] force_x = 0", "other than zero"]);
    refused(&slip().replace("= 0.3\n[st", "= -0.3\n[st"), &["[contact] friction = -0.3"]);
    let twist = with("normal_force = 1e3", "problem = \"twist\"\nmoment = 0.0");
    refused(&twist, &["[statics] moment = 0", "other than zero"]);
    refused(&twist.replace("0.0", "nan"), &["[statics] moment = NaN"]);
}

#[test]
fn what_has_no_solution_says_how_far_one_may_go() {
    let text = DIE.replace("offset_x = 1e-3", "offset_x = 3e-3");
    refused(&text, &["[statics] offset_x = 0.003, offset_y = -0.001", "lifts off", "1.5366 times"]);
    refused(&slip().replace("12e3", "30e3"), &["[statics] force_x", "30000 N", "24000 N"]);
    refused(&slip().replace("12e3", "24e3"), &["the bodies slide"]);
}

/// The limit that the message gives is one.
#[test]
fn the_lift_off_limit_can_be_used() {
    let text = DIE.replace("offset_x = 1e-3", "offset_x = 3e-3");
    let message = StaticsFile::read(&text).unwrap().solve().unwrap_err().to_string();
    let limit = &message[message.find("up to ").unwrap() + 6..].replace(", ", "\n");
    let (lines, _) = text.split_once("offset_x").unwrap();
    let StaticsProblem::Die { die, .. } = solved(&format!("{lines}{limit}\n")).problem else {
        panic!("not a die")
    };
    // Five digits of the offset.
    assert!(die.margin() < 2e-4, "{}", die.margin());
}

#[test]
fn the_schema_describes_every_key() {
    let schema = statics_json_schema();
    assert_eq!(schema["required"], serde_json::json!(["lower", "statics"]));
    assert!(!schema.to_string().contains("null"));
    for (section, form) in schema["properties"].as_object().unwrap() {
        assert_eq!(form["additionalProperties"], false, "{section}");
        for (key, kind) in form["properties"].as_object().unwrap() {
            assert!(kind["description"].is_string(), "{section}.{key} is not described");
        }
    }
}

/// A path is cautioned for its largest load, and for bodies that are unlike.
#[test]
fn a_path_is_cautioned_for_its_largest_load_and_unlike_bodies() {
    let path = |steps: &str| {
        let case = with(
            "normal_force = 80e3\nfriction = 0.1",
            &format!("problem = \"shift-path\"\nalong = \"x\"\nsteps = [{steps}]"),
        );
        let words: Vec<String> = solved(&case).cautions.iter().map(ToString::to_string).collect();
        words.join("; ")
    };
    let steady = path("{ force = 2e3 }");
    assert!(steady.contains("kappa/mu") && !steady.contains("GPa"), "{steady}");
    let heavy = path(
        "{ force = 2e3 }, { force = 2e3, normal_force = 60e9 }, { force = 2e3, normal_force = 80e3 }",
    );
    assert!(heavy.contains("GPa"), "{heavy}");
}

#[test]
fn a_bad_load_of_a_step_is_named_with_its_number() {
    let steps = "problem = \"shift-path\"\nalong = \"x\"\nsteps = [{ force = 1.0 }, { force = 1.0, normal_force = 0.0 }]";
    refused(&with("normal_force = 80e3\nfriction = 0.3", steps), &["step 2", "normal_force"]);
}

/// Without slip any load is held; one beyond the friction of all bodies is told with the friction that it takes.
#[test]
fn loads_without_slip_beyond_friction_are_told() {
    let needs = |statics: &str| {
        let cautions = solved(&with("normal_force = 80e3", statics)).cautions;
        cautions.into_iter().find_map(|caution| match caution {
            Caution::NeedsFriction { friction } => Some(friction),
            _ => None,
        })
    };
    let shift =
        |force: f64| needs(&format!("problem = \"shift\"\nforce_x = {force}\nforce_y = {force}"));
    assert_eq!(shift(80e3), None);
    let friction = shift(240e3).unwrap();
    assert!((friction / (3.0 * 2_f64.sqrt()) - 1.0).abs() < 1e-12, "{friction}");
    // The semi-axes are some 8 mm: 80 kN hold some 400 N m by friction 1.
    let twist = |moment: f64| needs(&format!("problem = \"twist\"\nmoment = {moment}"));
    assert_eq!(twist(-300.0), None);
    let friction = twist(-3000.0).unwrap();
    assert!(friction > 5.0 && friction < 15.0, "{friction}");
}

/// A given coefficient is what counts, and a die has none.
#[test]
fn loads_beyond_the_friction_that_is_given_are_told() {
    let told = |force: f64| {
        let statics = format!("problem = \"shift\"\nforce_x = {force}\nforce_y = 0.0");
        let case = with("normal_force = 80e3\nfriction = 0.3", &statics);
        solved(&case).cautions.iter().any(|c| matches!(c, Caution::NeedsFriction { .. }))
    };
    assert!(!told(23.9e3) && told(24.1e3));
}

/// Loads in other units move bodies by more than their contact.
#[test]
fn bodies_that_are_moved_by_metres_are_told() {
    let moved = |force: f64| {
        let statics = format!("problem = \"shift\"\nforce_x = {force}\nforce_y = 0.0");
        solved(&with("normal_force = 80e3", &statics)).cautions.into_iter().find_map(|caution| {
            let Caution::LargeShift { shift, half_width } = caution else { return None };
            Some(shift / half_width)
        })
    };
    assert_eq!(moved(20e3), None);
    // A shift grows with its force.
    let [one, other] = [20e9, 40e9].map(|force| moved(force).unwrap());
    assert!(one > 0.3 && (other / one - 2.0).abs() < 1e-12, "{one}, {other}");
}
