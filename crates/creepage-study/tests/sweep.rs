//! Sweep files: the loops of (5.16), and what is refused.
#![allow(clippy::unwrap_used)]

use creepage::variational::{Limits, Method};
use creepage_study::{Sweep, sweep_json_schema};

const SWEEP: &str = "
[contact]
a_over_b = 0.5
poisson = 0.28
[solve]
method = \"newton\"
degree = 3
mesh_length = [0.1, 0.2]
[creepage]
chi = [2.0, 1.0]
alpha = { from = -30, step = 30, to = 30 }
upsilon = [2.5, 1.7]
[chain]
through = \"alpha\"
";

#[track_caller]
fn refused(text: &str, parts: &[&str]) {
    let message = Sweep::read(text).unwrap_err().to_string();
    for part in parts {
        assert!(message.contains(part), "`{part}` is not in: {message}");
    }
}

#[test]
fn the_loops_run_as_in_1967() {
    let sweep = Sweep::read(SWEEP).unwrap();
    assert_eq!((sweep.cases(), sweep.chain_length()), (12, 6));
    assert_eq!(sweep.settings.mesh, [10, 10]);
    assert_eq!(sweep.procedure.method, Method::Newton);
    assert_eq!(sweep.procedure.limits, Limits::OF_1967);
    let mut index = 0;
    for chi in [2.0_f64, 1.0] {
        for alpha in [-30.0_f64, 0.0, 30.0] {
            for upsilon in [2.5_f64, 1.7] {
                let case = sweep.case(index);
                let expected = [chi, upsilon * alpha.to_radians().cos()];
                let found = [case.creepage.chi(), case.creepage.xi()];
                assert!(found.iter().zip(expected).all(|(one, two)| (one - two).abs() < 1e-15));
                assert!((case.creepage.eta() - upsilon * alpha.to_radians().sin()).abs() < 1e-15);
                index += 1;
            }
        }
    }
}

#[test]
fn a_range_meets_its_end() {
    let spin = "chi = { from = 10.0, step = -0.05, to = 0.05 }";
    let sweep = Sweep::read(&SWEEP.replace("chi = [2.0, 1.0]", spin)).unwrap();
    assert_eq!(sweep.cases(), 200 * 6);
    assert!((sweep.case(sweep.cases() - 1).chi - 0.05).abs() < 1e-12);
}

#[test]
fn starting_values_are_two_polynomials() {
    let with = |values: &str| format!("{SWEEP}starting_values = {values}\n");
    assert!(Sweep::read(&with("[1, 0, 0, 0, 0, 0]")).unwrap().starting_values.is_some());
    refused(&with("[1, 0, 0]"), &["[chain]", "starting_values", "2 coefficients"]);
}

#[test]
fn what_makes_no_sense_is_named() {
    refused(&SWEEP.replace("0.28", "0.6"), &["[contact]", "poisson", "0.6"]);
    refused(&SWEEP.replace("0.5", "nan"), &["[contact]", "a_over_b"]);
    refused(&SWEEP.replace("[0.1, 0.2]", "[0.3, 0.2]"), &["[solve]", "mesh_length", "0.3"]);
    refused(&SWEEP.replace("[0.1, 0.2]", "[1e-9, 0.2]"), &["[solve]", "mesh"]);
    refused(&SWEEP.replace("[0.1, 0.2]", "[0.1, 0.2, 0.3]"), &["mesh_length", "two numbers"]);
    refused(&SWEEP.replace("degree = 3", "degree = 99"), &["[solve]", "degree = 99"]);
    refused(&SWEEP.replace("degree = 3", "delta = -1"), &["[solve]", "delta", "-1"]);
    refused(&SWEEP.replace("[2.5, 1.7]", "[]"), &["[creepage]", "upsilon"]);
    refused(&SWEEP.replace("[2.5, 1.7]", "[inf]"), &["[creepage]", "upsilon"]);
    refused(&SWEEP.replace("step = 30", "step = 0"), &["[creepage]", "alpha"]);
    refused(&SWEEP.replace("step = 30", "step = -1"), &["[creepage]", "alpha"]);
    refused(&SWEEP.replace("step = 30", "step = 1e-9"), &["alpha", "too many"]);
    refused(&SWEEP.replace("step = 30", "stop = 30"), &["from, step, to"]);
    refused(&SWEEP.replace("degree", "degre"), &["degre", "did you mean `degree`"]);
    refused(&SWEEP.replace("newton", "magic"), &["magic", "newton"]);
}

#[test]
fn the_schema_describes_every_key() {
    let schema = sweep_json_schema();
    assert_eq!(schema["required"], serde_json::json!(["contact", "creepage"]));
    assert!(!schema.to_string().contains("null"));
    for (section, form) in schema["properties"].as_object().unwrap() {
        assert_eq!(form["additionalProperties"], false, "{section}");
        for (key, kind) in form["properties"].as_object().unwrap() {
            assert!(kind["description"].is_string(), "{section}.{key} is not described");
        }
    }
}

#[test]
fn unlike_bodies_are_another_contact() {
    let unlike = SWEEP.replace("poisson = 0.28", "poisson = 0.28\nkappa_over_mu = 0.3");
    let force = |text: &str| {
        let sweep = Sweep::read(text).unwrap();
        let theory = sweep.theory().unwrap();
        sweep.chain(&theory, 0).solve(sweep.case(0).creepage, None).found.solution.force
    };
    let [one, two] = [force(SWEEP), force(&unlike)];
    assert!((one.fx - two.fx).hypot(one.fy - two.fy) > 1e-3, "{one:?} {two:?}");
    refused(&unlike.replace("0.3", "nan"), &["[contact]", "kappa_over_mu"]);
}

/// (5.15) with weights of its own in the area of adhesion.
#[test]
fn areas_have_two_weights() {
    let areas = SWEEP.replace("newton", "areas");
    let two = areas.replace("degree = 3", "degree = 3\nadhesion_weight = \"uniform\"");
    let forces = [&areas, &two].map(|text| {
        let sweep = Sweep::read(text).unwrap();
        let (theory, at) = (sweep.theory().unwrap(), sweep.case(3));
        sweep.chain(&theory, 3).solve(at.creepage, None).found.solution.force
    });
    assert!((forces[0].fx - forces[1].fx).abs() > 1e-4, "{forces:?}");
    assert!((forces[0].fx - forces[1].fx).abs() < 0.2, "{forces:?}");
    let newton = SWEEP.replace("degree = 3", "degree = 3\nadhesion_weight = \"uniform\"");
    refused(&newton, &["[solve] adhesion_weight", "areas"]);
}
