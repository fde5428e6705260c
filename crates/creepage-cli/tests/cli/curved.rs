//! `[contact] surface = "curved"` by the command: the example, the plane beside it, what is refused.

use std::fs;
use std::path::Path;

use crate::place::{Place, json};

fn example() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/gap/groove.toml");
    fs::read_to_string(path).unwrap()
}

/// CONTACT's conformal elements, half-space: 348.7 N/mm2, .01742 mm, 10010 N along the normals.
#[test]
fn the_groove_of_the_example_is_followed() {
    let place = Place::new();
    place.write("groove.toml", example());
    let report = json(&place.run(&["solve", "groove.toml", "--json"]).done());
    let number = |section: &str, key: &str| report[section][key].as_f64().unwrap();
    assert_eq!(report["status"], "solved");
    assert!((number("contact", "peak_pressure_pa") / 348.7e6 - 1.0).abs() < 6e-3);
    assert!((number("contact", "approach_m") / 17.42e-6 - 1.0).abs() < 5e-3);
    assert!((number("contact", "normal_force_n") / 10_010.0 - 1.0).abs() < 5e-3);
    assert!((number("curved", "vertical_n") / 10e3 - 1.0).abs() < 1e-3);
    // Circles in a plane open faster than the parabolas of Hertz, 324.9 MPa, and slower than along the normals.
    let plane = number("curved", "plane_peak_pressure_pa");
    assert!(plane > 1.01 * 324.9e6 && plane < 0.98 * 348.7e6, "{plane}");
    // Rolls freely: the middle turns faster, for the sides have a smaller radius.
    assert!((number("creepage", "longitudinal") / -6.495e-4 - 1.0).abs() < 0.04);
    // In a plane it is that.
    place.write("plane.toml", example().replace("surface = \"curved\"", "surface = \"plane\""));
    let report = json(&place.run(&["solve", "plane.toml", "--json"]).done());
    assert!((report["contact"]["peak_pressure_pa"].as_f64().unwrap() / plane - 1.0).abs() < 0.01);
    assert!(report["curved"].is_null());
}

#[test]
fn what_is_not_rolled_along_a_curve_is_refused() {
    let place = Place::new();
    let refused = |changes: &[(&str, &str)], part: &str| {
        let text = changes.iter().fold(example(), |text, (from, to)| {
            assert!(text.contains(from), "{from}");
            text.replace(from, to)
        });
        place.write("case.toml", text);
        place.run(&["solve", "case.toml"]).refused(&[part]);
    };
    refused(&[("resolution = \"standard\"", "theory = \"fastsim\"")], "exact alone");
    refused(&[("outer = 10.05e-3", "outer = 9e-3")], "inner");
    refused(
        &[("lateral = 0.0\n", ""), ("= 0.0 # rolls", "= 0.0\nlateral_force = 1.0 # rolls")],
        "longitudinal_force alone",
    );
    refused(
        &[(
            "groove = { inner = 10e-3, outer = 10.05e-3, rolling = 420e-3 }",
            "polynomial = [[2, 0, 1.2], [0, 2, 0.5]]",
        )],
        "needs [gap] groove",
    );
    refused(&[("longitudinal_force = 0.0", "longitudinal_force = 1e6")], "longitudinal force");
}
