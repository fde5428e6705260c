//! What users must be told by every door, or refused: cautions in all outputs, numbers in other units.

use crate::place::{CASE, Place, example, fastsim, json};

/// Linear theory has no slip: no depth is worn by it, where `fastsim` has one.
#[test]
fn a_theory_without_slip_wears_no_depth() {
    let place = Place::new();
    place.write("wear.toml", example("wheel-wear.toml"));
    let damage = |theory: &str| {
        let ran = place.run(&["solve", "wear.toml", "--theory", theory, "--json"]);
        json(&ran.done())["damage"].clone()
    };
    let [linear, fastsim] = ["linear", "fastsim"].map(damage);
    for key in ["usfd_depth_m", "usfd_mass_kg_per_m", "archard_depth_m", "archard_zone"] {
        assert!(linear[key].is_null() && !fastsim[key].is_null(), "{key}: {linear} {fastsim}");
    }
    assert!(linear["t_gamma_n"].as_f64().unwrap() > 0.0);
}

/// Stresses say what is odd about their case in text and JSON, before files are written.
#[test]
fn stresses_have_the_cautions_of_their_case() {
    let place = Place::new();
    let friction = CASE.lines().find(|line| line.starts_with("friction")).unwrap();
    place.write("case.toml", fastsim().replace(friction, "friction = 3.0"));
    let text = place.run(&["stresses", "case.toml"]).done();
    assert!(text.contains("CAUTION: the coefficient of friction of 3"), "{text}");
    let report = json(&place.run(&["stresses", "case.toml", "--json"]).done());
    let words = report["caution"].as_str().unwrap();
    assert!(words.contains("coefficient of friction of 3"), "{words}");
    place.write("points.csv", "x,y,z\n0,0,1e-9\n0,0,1e-3\n");
    let arguments = ["stresses", "case.toml", "--points", "points.csv", "--json"];
    let report = json(&place.run(&arguments).done());
    let words = report["caution"].as_str().unwrap();
    assert!(words.contains("1; stresses there depend on the elements"), "{words}");
    place.write("usual.toml", fastsim());
    let report = json(&place.run(&["stresses", "usual.toml", "--json"]).done());
    assert!(report["caution"].is_null(), "{report}");
}

/// A table of a wheelset tells how many of its positions have cautions.
#[test]
fn a_table_of_a_wheelset_tells_its_cautions() {
    let place = Place::new();
    let case = example("wheelset/s1002-on-uic60.toml") + "\n[solve]\ntheory = \"saturated\"\n";
    place.write("w.toml", case);
    let table = |loads: [&str; 3]| {
        let arguments = ["wheelset", "w.toml", "--table", "t.nc", "--axle-load"];
        place.run(&[&arguments[..], &loads].concat()).stderr
    };
    let told = table(["60", "220", "2"]);
    assert!(told.contains("caution: 2 positions have cautions, the first:"), "{told}");
    assert!(told.contains("less than their surfaces are rough"), "{told}");
    let usual = table(["60e3", "120e3", "2"]);
    assert!(!usual.contains("caution"), "{usual}");
}

/// A column that is a key of the file alone is told, and so is a table's error.
#[test]
fn rows_are_told_what_is_not_used_and_how_far_a_table_errs() {
    let place = Place::new();
    let case = example("wheelset/s1002-on-uic60.toml") + "\n[solve]\ntheory = \"saturated\"\n";
    place.write("w.toml", case);
    let ran = place.run_on(&["batch", "--case", "w.toml"], "y,curvature\n0.002,0.003\n");
    let said = "caution: column `curvature` is not used: it is the file's in all rows";
    assert!(ran.stderr.contains(said), "{}", ran.stderr);
    let build = ["table", "build", "--theory", "fastsim", "--intervals", "4,4,4", "--places", "5"];
    let built = place.run(&[&build[..], &["--out", "t.nc"]].concat());
    assert!(built.stderr.contains("of the moment"), "{}", built.stderr);
    let rows = "a_over_b,poisson,xi,eta,chi\n1,0.25,0.1,0,0\n";
    let ran = place.run_on(&["batch", "--table", "t.nc"], rows);
    assert!(ran.stderr.contains("note: t.nc: largest error"), "{}", ran.stderr);
}

/// The largest creepage of a curve counts, not that of its case.
#[test]
fn curves_tell_a_creepage_that_no_wheel_has() {
    let place = Place::new();
    place.write("case.toml", fastsim());
    let curve = |to: &str| {
        let arguments =
            ["curve", "case.toml", "--vary", "longitudinal", "--from", "0", "--points", "3"];
        place.run(&[&arguments[..], &["--to", to]].concat()).stderr
    };
    assert!(curve("50").contains("longitudinal creepage"), "{}", curve("50"));
    assert!(!curve("0.01").contains("caution"), "{}", curve("0.01"));
}

/// Numbers that are those of no solid, wheel or contact are in another unit, and refused with their range.
#[test]
fn numbers_in_other_units_are_refused() {
    let place = Place::new();
    let replaced = |name: &str, key: &str, line: &str| {
        let text = example(name);
        let own = text.lines().find(|line| line.starts_with(key)).unwrap().to_owned();
        text.replace(&own, line)
    };
    let wear = |key: &str, line: &str| replaced("wheel-wear.toml", key, line);
    let friction = CASE.lines().find(|line| line.starts_with("friction")).unwrap();
    let across = "friction = { across = [[-3.0, 0.15], [3.0, 0.4]] }";
    let heat = "upper = { conductivity = 50.0, density = 7850.0, specific_heat = 0.45 }";
    for (case, said) in [
        (wear("hardness", "hardness = 300.0"), "at least 1e6 Pa"),
        (wear("wheel_diameter", "wheel_diameter = 920.0"), "at most 10 m"),
        (wear("shear_yield", "shear_yield = 300e9"), "at most 2e10 Pa"),
        (wear("shear_yield", "density = 7.85"), "at least 10 kg/m3"),
        (replaced("heat/sliding-wheel.toml", "upper", heat), "at least 10 J/(kg K)"),
        (
            replaced("wheel-falling-friction.toml", "memory_distance", "memory_distance = 20.0"),
            "at most 1 m",
        ),
        (fastsim().replace(friction, across), "within 1 m of the contact"),
    ] {
        place.write("case.toml", &case);
        place.run(&["solve", "case.toml"]).refused(&[said]);
    }
    let flat = example("wheelset/wheel-flat.toml").replace("angle = 0.0", "angle = 180.0");
    place.write("flat.toml", flat);
    place.run(&["wheelset", "flat.toml"]).refused(&["flat.angle", "within 2 pi rad"]);
}
