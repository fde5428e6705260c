//! `creepage wear`: the example, a kill, and bad input.

use std::fs;
use std::path::Path;

use crate::place::{Place, json};

fn example(place: &Place, edit: impl Fn(String) -> String) {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/wear");
    for name in ["s1002.toml", "vehicle.csv"] {
        let text = fs::read_to_string(examples.join(name)).unwrap();
        place.write(name, &if name == "s1002.toml" { edit(text) } else { text });
    }
}

#[test]
fn the_example_wears_and_its_profiles_are_read() {
    let place = Place::new();
    example(&place, |text| text);
    let report = json(&place.run(&["wear", "s1002.toml", "--out", "worn", "--json"]).done());
    let rows = report["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 12);
    let depth = |k: usize| rows[k]["depth_m"].as_f64().unwrap();
    assert!(depth(0) == 0.0 && depth(2) > 1e-5 && depth(10) > depth(2));
    assert_eq!(rows[10]["depth_m"], rows[11]["depth_m"]);
    let out = place.path("worn");
    for name in ["wear.csv", "profiles.csv", "report.json", "wheels.svg", "wheels.png"] {
        assert!(out.join(name).is_file(), "{name}");
    }
    assert!(!out.join("wear.state").exists() && !out.join("rails.svg").exists());
    // The wheelset with the worn wheels.
    let text = fs::read_to_string(place.path("s1002.toml")).unwrap();
    let (case, _) = text.split_once("[wear]").unwrap();
    let worn = case.replace("\"S1002\"", "\"worn/wheel_right_005.json\"");
    place.write("worn.toml", &format!("{worn}\n[solve]\ntheory = \"fastsim\"\n"));
    place.run(&["wheelset", "worn.toml", "--json"]).done();
}

#[test]
fn what_is_wrong_is_named_and_nothing_is_written() {
    let place = Place::new();
    for (old, new, said) in [
        ("distance = 100e6", "", "distance"),
        ("distance = 100e6", "distance = -1.0", "distance"),
        ("stops = 5", "stops = 0", "stops"),
        ("\"vehicle.csv\"", "\"nowhere.csv\"", "nowhere.csv"),
        ("law = \"usfd\"", "law = \"bre\"", "bre"),
        ("step_depth = 1e-4", "step_depht = 1e-4", "step_depth"),
        ("axle_load = 160e3", "axle_load = 160e3\ny = 0.0\nroll = 0.0\nside = \"left\"", "mean"),
    ] {
        example(&place, |text| text.replace(old, new));
        place.run(&["wear", "s1002.toml", "--out", "worn"]).refused(&[said]);
        assert!(!place.path("worn").exists());
    }
    example(&place, |text| text);
    place.write("vehicle.csv", "share, hight\n1.0, 2.0\n");
    place.run(&["wear", "s1002.toml", "--out", "worn"]).refused(&["hight", "axle_load"]);
}
