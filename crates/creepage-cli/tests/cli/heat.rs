//! `[heat]` by the command: reports, files, a wheelset, what is refused.

use std::fs;
use std::path::Path;

use crate::place::{Place, json};

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    fs::read_to_string(path).unwrap()
}

/// Friction falls from 100 degrees on: less than Coulomb's .3 N, and less than 153 K.
#[test]
fn the_example_is_hot_and_slips_the_easier() {
    let place = Place::new();
    place.write("case.toml", example("heat/sliding-wheel.toml"));
    let report = json(&place.run(&["solve", "case.toml", "--json"]).done());
    let used = report["dimensionless"]["friction_used"].as_f64().unwrap();
    assert!((used - 0.9).abs() < 0.01, "{used}");
    let highest = report["heat"]["contact_temperature_max_c"].as_f64().unwrap();
    assert!((highest - 118.0).abs() < 2.0, "{highest}");
    assert_eq!(report["friction_law"]["by_temperature"][1][1], 0.12);
    place.run(&["solve", "case.toml", "--out", "hot"]).done();
    for name in ["temperature.csv", "temperature.svg", "temperature.png"] {
        assert!(place.path(&format!("hot/{name}")).is_file(), "{name}");
    }
    let table = place.read("hot/temperature.csv");
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("x,y,heat,temperature_upper,temperature_lower"));
    let hottest = lines.map(|line| line.split(',').nth(3).unwrap().parse().unwrap());
    let hottest: f64 = hottest.fold(0.0, f64::max);
    // The table has places; the report the summit between them.
    assert!((hottest - highest).abs() < 0.01 * highest, "{hottest} {highest}");
}

/// Each contact of a wheelset has all heat of its slip, and a temperature above both bodies'.
#[test]
fn a_wheelset_has_temperatures_at_every_contact() {
    let place = Place::new();
    let heat = "\n[heat]\nupper = { material = \"steel\", bulk_temperature = 60.0 }\n\
        lower = { material = \"steel\", bulk_temperature = 20.0 }\n";
    place.write("set.toml", example("wheelset/s1002-on-uic60.toml") + heat);
    place.run(&["wheelset", "set.toml", "--out", "set"]).done();
    let report = json(&place.read("set/report.json"));
    for side in ["left", "right"] {
        for patch in report[side]["patches"].as_array().unwrap() {
            let number = |key: &str| patch["heat"][key].as_f64().unwrap();
            assert!(number("contact_temperature_max_c") > 40.0 - 1.0);
            let by_slip = 30.0 * patch["frictional_power_per_metre_j_per_m"].as_f64().unwrap();
            assert!((number("friction_w") / by_slip - 1.0).abs() < 0.05, "{by_slip}");
            // The colder rail takes what the wheel gives.
            assert!(number("into_lower_w") > number("friction_w"));
        }
    }
    let table = place.read("set/temperature.csv");
    assert!(
        table.starts_with("side,contact,x,y,heat,temperature_upper,temperature_lower\nleft,1,")
    );
    assert!(place.path("set/right_1_temperature.svg").is_file());
}

#[test]
fn what_cannot_be_is_refused_or_told() {
    let place = Place::new();
    let text = example("heat/sliding-wheel.toml");
    place.write("slow.toml", text.replace("speed = 30.0", ""));
    place.run(&["solve", "slow.toml"]).refused(&["speed, which [heat] needs"]);
    let constant = text.replace("friction = {", "friction = 0.3 # {");
    place.write("case.toml", constant);
    let rows = place.run_on(&["batch", "--case", "case.toml"], "longitudinal\n0.01\n");
    rows.refused(&["[heat] is for one case at a time"]);
    let axes = "semi_axis_rolling = 5.878886e-3\nsemi_axis_lateral = 10.540448e-3\n";
    let shaped = text.replace("friction = {", "friction = 0.3 # {").replace(axes, "");
    let shaped =
        shaped.replace("[contact]", "[gap]\npolynomial = [[2, 0, 1.0], [0, 2, 0.4]]\n[contact]");
    place.write("gap.toml", format!("{shaped}\n[solve]\nresolution = \"fast\"\n"));
    let rows = place.run_on(&["batch", "--case", "gap.toml"], "longitudinal\n0.01\n");
    assert_eq!((rows.code, &rows.stderr[..]), (Some(0), "1 rows: 1 solved\n"), "{rows:?}");
    // A row has the temperatures of its case alone.
    let row: Vec<&str> = rows.stdout.lines().nth(1).unwrap().split(',').collect();
    let number = |name: &str| {
        let header = rows.stdout.lines().next().unwrap();
        let place = header.split(',').position(|column| column == name).unwrap();
        row[place].parse::<f64>().unwrap()
    };
    let own = place.read("gap.toml");
    let longitudinal = own.lines().find(|line| line.starts_with("longitudinal")).unwrap();
    place.write("gap.toml", own.replace(longitudinal, "longitudinal = 0.01"));
    let alone = json(&place.run(&["solve", "gap.toml", "--json"]).done());
    for name in ["contact_temperature_max_c", "flash_max_k"] {
        let expected = alone["heat"][name].as_f64().unwrap();
        assert!(expected > 1.0 && (number(name) / expected - 1.0).abs() < 1e-12, "{name}");
    }
    let told = place.run(&["solve", "case.toml", "--theory", "polach"]);
    assert!(told.stderr.contains("polach has no slip"), "{told:?}");
}
