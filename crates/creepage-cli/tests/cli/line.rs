//! `creepage solve` of line contacts: the examples, files, and bad input.

use std::fs;
use std::path::Path;

use crate::place::{Place, json};

fn example(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/line");
    fs::read_to_string(folder.join(name)).unwrap()
}

#[test]
fn the_examples_solve_and_leave_their_files() {
    let place = Place::new();
    for name in ["polymer-rollers.toml", "aluminium-on-steel.toml"] {
        place.write(name, example(name));
        let report = json(&place.run(&["solve", name, "--out", "out", "--json"]).done());
        assert_eq!((&report["status"], &report["caution"]), (&"solved".into(), &().into()));
        for file in ["report.json", "points.csv", "contact.svg", "contact.png"] {
            assert!(place.path("out").join(file).is_file(), "{file}");
        }
        let table = fs::read_to_string(place.path("out/points.csv")).unwrap();
        assert!(table.starts_with("x_m,pressure_pa,traction_pa,region\n"));
        assert!(table.contains("slip") && table.contains("adhesion"));
    }
    let printed = place.run(&["solve", "polymer-rollers.toml"]).done();
    assert!(printed.contains("rolling resistance"), "{printed}");
}

#[test]
fn carters_theory_says_what_it_leaves_out() {
    let place = Place::new();
    place.write("unlike.toml", example("aluminium-on-steel.toml"));
    let by_carter = place.run(&["solve", "unlike.toml", "--theory", "carter", "--json"]).done();
    assert!(json(&by_carter)["caution"].as_str().unwrap().contains("kappa/mu"));
    place.run(&["solve", "unlike.toml", "--theory", "fastsim"]).refused(&["fastsim", "carter"]);
}

#[test]
fn what_is_wrong_is_named_and_nothing_is_written() {
    let place = Place::new();
    for (old, new, said) in [
        ("line_load = 600e3", "line_load = -1.0", "load"),
        ("ratio = 1.0", "ratoi = 1.0", "ratio"),
        ("fx = 0.6", "fx = 1.5", "mu N"),
        ("speed = 1.0", "", "speed"),
        ("radius_rolling = 0.1     # (m)", "radius_rolling = 0.1\nradius_lateral = 0.3", "crown"),
        (
            "friction = 0.3",
            "friction = { static = 0.3, kinetic = 0.1, half_speed = 1.0 }",
            "friction",
        ),
        ("time = 9e-3", "time = 9e30", "V tau"),
    ] {
        place.write("case.toml", example("polymer-rollers.toml").replace(old, new));
        place.run(&["solve", "case.toml", "--out", "out"]).refused(&[said]);
        assert!(!place.path("out").exists());
    }
}

#[test]
fn its_schema_is_printed() {
    let schema = json(&Place::new().run(&["schema", "--of", "line"]).done());
    assert!(schema["properties"]["relaxation"].is_object());
}
