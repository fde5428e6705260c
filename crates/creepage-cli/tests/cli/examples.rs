//! The example cases of the repository: they solve, and they say what the format allows.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::place::{Place, json};

fn examples() -> Vec<PathBuf> {
    examples_in("")
}

fn examples_in(directory: &str) -> Vec<PathBuf> {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let directory = examples.join(directory);
    let entries = fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path());
    let cases: Vec<_> =
        entries.filter(|path| path.extension().is_some_and(|e| e == "toml")).collect();
    assert!(cases.len() >= 4);
    cases
}

#[test]
fn every_example_solves_and_shows_both_adhesion_and_slip() {
    let place = Place::new();
    for path in examples() {
        let printed = place.run(&["solve", path.to_str().unwrap(), "--json"]).done();
        let report = json(&printed);
        assert_eq!(report["status"], "solved", "{}", path.display());
        let share = report["areas"]["adhesion_share"].as_f64().unwrap();
        // Free rolling of unlike bodies slips in a twentieth of its area.
        assert!((0.05..0.98).contains(&share), "{}: adhesion {share}", path.display());
    }
}

#[test]
fn the_force_on_the_wheel_drives_in_traction_and_brakes_in_braking() {
    let place = Place::new();
    let force_on_wheel = |name: &str| {
        let path = examples().into_iter().find(|path| path.ends_with(name)).unwrap();
        let printed = place.run(&["solve", path.to_str().unwrap(), "--json"]).done();
        let report = json(&printed);
        report["upper_body"]["longitudinal_n"].as_f64().unwrap()
    };
    assert!(force_on_wheel("wheel-on-rail.toml") > 0.0);
    assert!(force_on_wheel("wheel-braking.toml") < 0.0);
}

/// What the example's comments say.
#[test]
fn unlike_bodies_brake_less_than_they_drive() {
    let place = Place::new();
    let path =
        examples().into_iter().find(|path| path.ends_with("steel-ball-on-polycarbonate.toml"));
    let driven = fs::read_to_string(path.unwrap()).unwrap();
    let force = |creepages: &[(&str, &str)]| {
        let edit = |text: String, (key, value): &(&str, &str)| {
            let start = text.find(&format!("\n{key} = ")).unwrap() + 1;
            let end = start + text[start..].find('\n').unwrap();
            format!("{}{key} = {value}{}", &text[..start], &text[end..])
        };
        place.write("case.toml", creepages.iter().fold(driven.clone(), edit));
        let printed = place.run(&["solve", "case.toml", "--json"]).done();
        let report: Value = serde_json::from_str(&printed).unwrap();
        report["lower_body"]["longitudinal_n"].as_f64().unwrap()
    };
    let resting = [("longitudinal", "0"), ("lateral", "0"), ("spin", "0")];
    for (creepages, newtons) in
        [(&[][..], -4.6), (&[("longitudinal", "0.003")], 1.1), (&resting, -2.4)]
    {
        // The error bar is 0.01 of mu N, 7.6 N; the comment has two digits.
        let found = force(creepages);
        assert!((found - newtons).abs() < 0.05 + 0.076, "{creepages:?}: {found}");
    }
}

#[test]
fn wanted_forces_are_met_by_the_creepage_that_is_found() {
    let place = Place::new();
    let solved = |name: &str| -> Value {
        let path = examples().into_iter().find(|path| path.ends_with(name)).unwrap();
        let printed = place.run(&["solve", path.to_str().unwrap(), "--json"]).done();
        json(&printed)
    };
    let number = |value: &Value| value.as_f64().unwrap();
    let ball = solved("ball-rolling-free.toml");
    // The solver finds forces to 1e-7 of mu N.
    assert!(number(&ball["dimensionless"]["fy"]).abs() < 1e-7);
    // Spin turns the front of the ball to the right: it must creep to the left.
    assert!(number(&ball["creepage"]["lateral"]) < -1e-4);
    assert!((number(&ball["creepage"]["spin_rad_per_m"]) - 15.0).abs() < 1e-12);
    let wheel = solved("wheel-tractive-effort.toml");
    assert!((number(&wheel["lower_body"]["longitudinal_n"]) + 15e3).abs() < 24e3 * 1e-7);
    assert_eq!(wheel["known"], serde_json::json!(["eta", "chi", "fx"]));
    assert!(number(&wheel["details"]["fx_error"]["value"]) < 1e-3);
}

#[test]
fn the_schema_accepts_every_example() {
    let place = Place::new();
    let schema = |of: &[&str]| -> Value { json(&place.run(&[&["schema"], of].concat()).done()) };
    let [cases, statics, sweeps] = ["case", "statics", "sweep"].map(|of| schema(&["--of", of]));
    assert_eq!(schema(&[]), cases);
    let init: Value = toml::from_str(&place.run(&["init"]).done()).unwrap();
    accepts(&cases, &init).unwrap();
    for (schema, directory) in [(&cases, ""), (&statics, "statics"), (&sweeps, "catalogue")] {
        for path in examples_in(directory) {
            let example = toml::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
            accepts(schema, &example).unwrap_or_else(|why| panic!("{}: {why}", path.display()));
        }
    }
    for (schema, wrong) in [
        (&cases, "upper = 1"),
        (&cases, "[upper]\n[lower]\n[contact]\n[other]\n"),
        (&statics, "[lower]\n"),
        (&sweeps, "[contact]\na_over_b = 1\npoisson = 0.28\n"),
        (&sweeps, "[contact]\na_over_b = 1\npoisson = \"a\"\n[creepage]\n"),
        (&sweeps, "[contact]\na_over_b = 1\npoisson = 0.28\n[creepage]\nchi = { frm = 1 }\n"),
    ] {
        assert!(accepts(schema, &toml::from_str(wrong).unwrap()).is_err(), "{wrong}");
    }
}

/// Validates by the part of JSON schema that ours uses.
fn accepts(schema: &Value, value: &Value) -> Result<(), String> {
    for choices in ["anyOf", "oneOf"] {
        if let Some(choices) = schema[choices].as_array()
            && !choices.iter().any(|choice| accepts(choice, value).is_ok())
        {
            return Err(format!("{value} is none of {choices:?}"));
        }
    }
    if !schema["const"].is_null() && schema["const"] != *value {
        return Err(format!("{value} is not {}", schema["const"]));
    }
    match schema["type"].as_str() {
        Some("object") => accepts_object(schema, value),
        Some("array") => {
            let items = value.as_array().ok_or(format!("{value} is no array"))?;
            items.iter().try_for_each(|item| accepts(&schema["items"], item))
        }
        Some("number") if !value.is_number() => Err(format!("{value} is no number")),
        Some("integer") if !value.is_u64() => Err(format!("{value} is no whole number")),
        Some("string") if !value.is_string() => Err(format!("{value} is no text")),
        _ => Ok(()),
    }
}

fn accepts_object(schema: &Value, value: &Value) -> Result<(), String> {
    let object = value.as_object().ok_or(format!("{value} is no object"))?;
    for key in schema["required"].as_array().into_iter().flatten() {
        object.get(key.as_str().unwrap()).ok_or(format!("{key} is missing"))?;
    }
    object.iter().try_for_each(|(key, value)| match schema["properties"].get(key) {
        Some(schema) => accepts(schema, value),
        None => Err(format!("{key} is unknown")),
    })
}
