//! `[contact] friction` as a law, `[layer]`, `[damage]`.

use serde_json::Value;

use crate::place::{Place, json};

/// The case of the reference: a circle of 5 mm, steel, 1.025e9 Pa.
fn case(friction: &str, creepage: &str, more: &str) -> String {
    format!(
        "upper = {{ shear_modulus = 82e9, poisson = 0.28 }}
        lower = {{ shear_modulus = 82e9, poisson = 0.28 }}
        [contact]
        normal_force = 53668.8745
        semi_axis_rolling = 5e-3
        semi_axis_lateral = 5e-3
        friction = {friction}
        [creepage]
        {creepage}
        {more}"
    )
}

fn solve(text: &str) -> Value {
    let place = Place::new();
    place.write("case.toml", text);
    json(&place.run(&["solve", "case.toml", "--json"]).done())
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

const LAW: &str =
    "{ law = \"exponential\", kinetic = 0.18, terms = [{ drop = 0.12, half_speed = 0.1 }]";

/// CONTACT v25.2, extrapolated: .68947 +- .00225 without memory, .74204 +- .00201 with.
#[test]
fn reference_cases() {
    let memory = ", memory_distance = 2e-5, memory_speed = 1e-3 }";
    for (end, force, uncertainty) in [(" }", 0.689_472, 0.002_251), (memory, 0.742_042, 0.002_011)]
    {
        let report = solve(&case(&format!("{LAW}{end}"), "longitudinal = 0.002\nspeed = 30", ""));
        assert_eq!(report["status"], "solved");
        assert!((report["friction"].as_f64().unwrap() - 0.3).abs() < 1e-15);
        assert_eq!(report["friction_law"]["kinetic"], 0.18);
        let found = report["dimensionless"]["fx"].as_f64().unwrap();
        assert!((found - force).abs() < 0.005 + uncertainty, "{found}");
    }
}

#[test]
fn a_constant_law_is_a_number() {
    let number = solve(&case("0.3", "longitudinal = 0.002", ""));
    let law = "{ law = \"constant\", kinetic = 0.3 }";
    let table = solve(&case(law, "longitudinal = 0.002", ""));
    assert_eq!(number, table);
    assert!(number["friction_law"].is_null());
}

/// Friction that differs across the contact: the largest is the unit, full sliding is the mean, and it
/// turns about the normal.
#[test]
fn friction_across_the_contact() {
    let report = solve(&case("{ across = [[-5e-3, 0.1], [5e-3, 0.4]] }", "xi = 50", ""));
    assert!((number(&report["friction"]) - 0.4).abs() < 1e-15);
    assert_eq!(report["friction_law"]["across"][0][1], 0.1);
    let used = number(&report["dimensionless"]["fx"]);
    // Strips take friction at their middle, exact for a linear one but for the strips' own ends.
    assert!((used - 0.625).abs() < 2e-3, "{used}");
    assert!(number(&report["dimensionless"]["mz"]) < -0.07);
}

#[test]
fn what_is_wrong_with_a_law_is_named() {
    let place = Place::new();
    let refused = |friction: &str, creepage: &str, more: &str, parts: &[&str]| {
        place.write("case.toml", case(friction, creepage, more));
        place.run(&["solve", "case.toml"]).refused(parts);
    };
    let (whole, at_speed) = (format!("{LAW} }}"), "longitudinal = 0.002\nspeed = 30");
    refused(&whole, "longitudinal = 0.002", "", &["[creepage] speed is missing"]);
    refused(
        &whole.replace("exponential", "steep"),
        at_speed,
        "",
        &["friction", "steep", "rational"],
    );
    refused(&whole.replace("0.18", "-0.18"), at_speed, "", &["kinetic = -0.18"]);
    refused(&whole.replace("half_speed", "half"), at_speed, "", &["unknown field `half`"]);
    let half = format!("{LAW}, memory_distance = 1e-5 }}");
    refused(&half, at_speed, "", &["memory_speed is missing"]);
    refused("\"dry\"", at_speed, "", &["friction = \"dry\"", "a number"]);
    let across = "{ across = [[1e-3, 0.3], [0.0, 0.4]] }";
    refused(across, at_speed, "", &["y of friction across = 0", "above the one before"]);
    refused("{ across = [[0.0, 0.3]] }", at_speed, "", &["across = 1", "two to seven"]);
    let layer = "[layer]\nthickness = -1e-6\nshear_modulus = 1e9";
    refused("0.3", at_speed, layer, &["[layer] thickness = -1e-6"]);
    let layer = "[layer]\nthickness = 1e-6\nshear_modulus = 1e9\nslope = 1e9";
    refused("0.3", at_speed, layer, &["[layer] yield_stress is missing"]);
    refused("0.3", at_speed, "[damage]\ndensity = 0", &["[damage] density = 0"]);
    refused("0.3", at_speed, "[damage.archard]\nhard = 1", &["unknown field `hard`"]);
}

/// Theories that take friction as constant, or leave the layer out, say so.
#[test]
fn cautions() {
    let place = Place::new();
    let layer = "[layer]\nthickness = 2e-5\nshear_modulus = 1e8";
    place.write("case.toml", case(&format!("{LAW} }}"), "xi = 0.5\nspeed = 30", layer));
    for (theory, cautious) in [("exact", false), ("fastsim", false), ("polach", true)] {
        let run = place.run(&["solve", "case.toml", "--theory", theory, "--json"]);
        let caution = json(&run.done())["caution"].clone();
        let words = caution.as_str().unwrap_or_default();
        assert_eq!(words.contains("constant at its largest value"), cautious, "{theory}: {words}");
        assert_eq!(words.contains("leaves out the layer"), cautious, "{theory}: {words}");
    }
}

/// The maximum of a curve is found and marked.
#[test]
fn the_largest_force_of_a_curve() {
    let place = Place::new();
    let fast = "[solve]\nresolution = \"fast\"";
    place.write("case.toml", case(&format!("{LAW} }}"), "longitudinal = 0.002\nspeed = 30", fast));
    let run = place.run(&[
        "curve",
        "case.toml",
        "--vary",
        "xi",
        "--to",
        "4",
        "--points",
        "9",
        "--out",
        "curve",
    ]);
    assert!(run.stderr.contains("exact: largest force 0."), "{}", run.stderr);
    run.done();
    let svg = std::fs::read_to_string(place.path("curve/curve.svg")).unwrap();
    assert!(svg.contains("largest force"));
}

/// T gamma is the frictional power; wear is written; constants from memory are marked.
#[test]
fn wear_and_fatigue_numbers() {
    let place = Place::new();
    let wanted = "[damage]\nshear_yield = 290e6\nshakedown = true\n[solve]\nresolution = \"fast\"";
    let creepage = "longitudinal = -0.004\nlateral = 0.001\nspeed = 20";
    place.write("case.toml", case("0.3", creepage, wanted));
    let printed = place.run(&["solve", "case.toml", "--json", "--out", "out"]).done();
    let report = json(&printed);
    let damage = &report["damage"];
    let power = number(&report["frictional_power_per_metre_j_per_m"]);
    assert!((number(&damage["t_gamma_with_spin_n"]) / power - 1.0).abs() < 1e-12);
    let used = number(&report["dimensionless"]["friction_used"]);
    let index = 0.3 * used - 290e6 / number(&report["contact"]["peak_pressure_pa"]);
    assert!((number(&damage["surface_fatigue_index"]) - index).abs() < 1e-12);
    // At most the surface's own branch, p0/k = 1/mu in full sliding; and not far below.
    let factor = number(&damage["shakedown_load_factor"]) * 1025.0 / 290.0;
    assert!(factor < 1.01 / (0.3 * used) && factor > 0.9 / 0.3, "{damage}");
    assert_eq!(
        damage["unverified"],
        serde_json::json!(["archard", "bre", "wlrm", "ekberg", "dang_van"])
    );
    let table = std::fs::read_to_string(place.path("out/wear.csv")).unwrap();
    assert!(table.starts_with("y,usfd_depth,archard_depth,archard_zone\n"));
    assert_eq!(table.lines().count(), 61);
    for file in ["wear.svg", "wear.png", "shakedown.png"] {
        assert!(place.path(&format!("out/{file}")).is_file(), "{file}");
    }
    let map = std::fs::read_to_string(place.path("out/shakedown.svg")).unwrap();
    assert!(map.contains("Melan") && map.contains("ratchets"));
    let text = place.run(&["solve", "case.toml"]).done();
    assert!(text.contains("UNVERIFIED") && text.contains("T gamma"), "{text}");
}
