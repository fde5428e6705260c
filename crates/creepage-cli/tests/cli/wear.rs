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

fn short(text: &str) -> String {
    text.replace("distance = 30e6", "distance = 3e6")
}

#[test]
fn the_example_wears_and_its_profiles_are_read() {
    let place = Place::new();
    // A tenth of its way: the guide's build runs all of it.
    example(&place, |text| short(&text));
    let report = json(&place.run(&["wear", "s1002.toml", "--out", "worn", "--json"]).done());
    let rows = report["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 8);
    let depth = |k: usize| rows[k]["depth_m"].as_f64().unwrap();
    assert!(depth(0) == 0.0 && depth(2) > 1e-5 && depth(6) > depth(2));
    assert_eq!(rows[6]["depth_m"], rows[7]["depth_m"]);
    let out = place.path("worn");
    let pictures = ["wheels.svg", "wheels.png", "wheels-moving.png"];
    for name in ["wear.csv", "profiles.csv", "report.json"].iter().chain(&pictures) {
        assert!(out.join(name).is_file(), "{name}");
    }
    assert!(!out.join("wear.state").exists() && !out.join("rails.svg").exists());
    // The wheelset with the worn wheels.
    let text = fs::read_to_string(place.path("s1002.toml")).unwrap();
    let (case, _) = text.split_once("[wear]").unwrap();
    let worn = case.replace("\"S1002\"", "\"worn/wheel_right_003.json\"");
    place.write("worn.toml", format!("{worn}\n[solve]\ntheory = \"fastsim\"\n"));
    place.run(&["wheelset", "worn.toml", "--json"]).done();
}

/// Killed three times on the way by the system, it ends with the same files as undisturbed, bit for bit.
#[test]
fn a_run_killed_three_times_ends_as_if_undisturbed() {
    let place = Place::new();
    example(&place, |text| short(&text).replace("stops = 3", "stops = 6"));
    place.run(&["wear", "s1002.toml", "--out", "whole"]).done();
    let state = place.path("killed/wear.state");
    for part in 1..=3 {
        let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_creepage"))
            .current_dir(place.path(""))
            .args(["wear", "s1002.toml", "--out", "killed"])
            .stdout(std::process::Stdio::null())
            .stderr(std::process::Stdio::null())
            .spawn()
            .unwrap();
        // Until it has kept a step more.
        let steps = || fs::read_to_string(&state).ok().and_then(|text| steps_of(&text));
        while steps().is_none_or(|steps| steps < part) {
            assert!(child.try_wait().unwrap().is_none(), "ended before it was killed");
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        child.kill().unwrap();
        child.wait().unwrap();
    }
    place.run(&["wear", "s1002.toml", "--out", "killed"]).done();
    let names = place.files_in("whole");
    assert!(names.len() > 10 && names == place.files_in("killed"), "{names:?}");
    for name in names {
        let [whole, killed] =
            ["whole", "killed"].map(|out| fs::read(place.path(out).join(&name)).unwrap());
        assert!(whole == killed, "{name}");
    }
}

fn steps_of(state: &str) -> Option<u64> {
    json(state)["steps"].as_u64()
}

#[test]
fn what_is_wrong_is_named_and_nothing_is_written() {
    let place = Place::new();
    for (old, new, said) in [
        ("distance = 30e6", "", "distance"),
        ("distance = 30e6", "distance = -1.0", "distance"),
        ("stops = 3", "stops = 0", "stops"),
        ("theory = \"fastsim\"", "theory = \"linear\"", "slip"),
        ("\"vehicle.csv\"", "\"nowhere.csv\"", "nowhere.csv"),
        ("law = \"usfd\"", "law = \"bre\"", "bre"),
        ("step_depth = 1e-4", "step_depht = 1e-4", "step_depth"),
        ("theory = \"fastsim\"", "theory = \"fastsim\"\n[wear.limits]\nhollow = -1.0", "hollow"),
        ("axle_load = 160e3", "wheel_load = 80e3\nroll = 0.0\nside = \"left\"", "mean"),
    ] {
        example(&place, |text| text.replace(old, new));
        place.run(&["wear", "s1002.toml", "--out", "worn"]).refused(&[said]);
        assert!(!place.path("worn").exists());
    }
    example(&place, |text| text);
    place.write("vehicle.csv", "share, hight\n1.0, 2.0\n");
    let wear = || place.run(&["wear", "s1002.toml", "--out", "worn"]);
    wear().refused(&["hight", "axle_load"]);
    place.write("vehicle.csv", "share,y,y\n1.0,0.0,0.003\n");
    wear().refused(&["[wear] table: vehicle.csv: column y is there twice"]);
    // Other separators are read, and commas between semicolons as decimal signs.
    place.write("vehicle.csv", "share;y\n0,5;0,001\n0,5;left\n");
    wear().refused(&["vehicle.csv: row 2, y: \"left\" is no number"]);
    place.write("vehicle.csv", "\u{feff}share\ty\n0.5\t0.001\nhalf\t0.0\n");
    wear().refused(&["vehicle.csv: row 2, share: \"half\" is no number"]);
    assert!(!place.path("worn").exists());
}
