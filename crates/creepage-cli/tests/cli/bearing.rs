//! `creepage bearing`.

use crate::place::Place;

fn example() -> String {
    let path = "../../examples/bearing/angular-contact-7208.toml";
    std::fs::read_to_string(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

#[test]
fn a_bearing_is_solved_and_its_files_are_written() {
    let place = Place::new();
    place.write("case.toml", example() + "\n[solve]\nresolution = \"fast\"\n");
    let printed = place.run(&["bearing", "case.toml", "--json", "--out", "out"]).done();
    let report: serde_json::Value = serde_json::from_str(&printed).unwrap();
    let number = |key: &str| report[key].as_f64().unwrap();
    assert!((number("axial_load_n") - 2e3).abs() < 0.01, "{report}");
    let heat = number("inner_heat_w") + number("outer_heat_w");
    assert!((heat / number("heat_w") - 1.0).abs() < 1e-12, "{report}");
    let names = ["csv", "png", "svg", "vtk"].map(|kind| format!("inner.{kind}"));
    assert_eq!(place.files_in("out")[..4], names);
    assert_eq!(
        serde_json::from_str::<serde_json::Value>(&place.read("out/report.json")).unwrap(),
        report
    );
    // In words, by sliding friction: the heat of the hottest ball's contacts.
    place.write("case.toml", example() + "\n[solve]\ntheory = \"sliding\"\n");
    let text = place.run(&["bearing", "case.toml"]).done();
    assert!(text.contains("moment of friction") && text.contains("Each ball"), "{text}");
}

#[test]
fn what_is_wrong_is_named_and_nothing_is_written() {
    for (old, new, part) in [
        ("axial_load = 2e3", "axial_load = -1.0", "axial load"),
        ("axial_load = 2e3", "ball_load = 1.0\nradial_load = 2.0", "radial_load"),
        ("balls = 12", "balls = 40", "balls"),
        ("osculation = 0.52", "osculation = 0.4", "osculation"),
        ("friction = 0.07", "fricton = 0.07", "did you mean `friction`"),
        ("poisson = 0.30", "poisson = 0.7", "poisson"),
        ("speed = 628.31853", "speed = inf", "inner speed"),
    ] {
        let place = Place::new();
        assert!(example().contains(old), "{old}");
        place.write("case.toml", example().replacen(old, new, 1));
        place.run(&["bearing", "case.toml", "--out", "out"]).refused(&[part]);
        assert_eq!(place.files(), ["case.toml"]);
    }
}
