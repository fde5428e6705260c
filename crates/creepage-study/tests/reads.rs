//! What a case file may say, and what comes of it.
#![allow(clippy::unwrap_used)]

use creepage::coulomb::Constraints;
use creepage::theory::{NamedResolution, ResolutionSpec, VariationalOptions};
use creepage::variational::Weight;
use creepage::{SiCreepage, TheorySpec};
use creepage_study::{Case, CaseError, CaseFile, Given, json_schema, theory_spec};

mod common;
use common::{WHEEL_ON_RAIL, edited};

fn read(text: &str) -> Case {
    CaseFile::read(text).unwrap().case().unwrap()
}

#[test]
fn si_creepage_and_its_dimensionless_form_are_the_same_case() {
    let [xi, eta, chi] = read(WHEEL_ON_RAIL).creepage().unwrap().components();
    let dimensionless = edited(
        "longitudinal = -1.5e-3\nlateral = 1e-3\nspin = 0.2",
        &format!("xi = {xi}\neta = {eta}\nchi = {chi}"),
    );
    let case = read(&dimensionless);
    let back: SiCreepage = case.contact.scaling().si_creepage(case.creepage().unwrap());
    // Two roundings of the unit of slip.
    assert!((back.longitudinal + 1.5e-3).abs() < 1e-17);
    assert!((back.lateral - 1e-3).abs() < 1e-17);
    assert!((back.spin - 0.2).abs() < 1e-15);
}

#[test]
fn creepage_that_is_left_out_is_zero() {
    let text = edited("lateral = 1e-3\nspin = 0.2", "");
    let [xi, eta, chi] = read(&text).creepage().unwrap().components();
    assert!(xi < 0.0 && eta == 0.0 && chi == 0.0);
}

#[test]
fn semi_axes_in_place_of_radii_give_that_ellipse() {
    let text = edited("radius_rolling = 0.46\nradius_lateral = \"flat\"", "")
        .replace("radius_rolling = \"flat\"\nradius_lateral = 0.3", "")
        .replace("friction", "semi_axis_rolling = 6e-3\nsemi_axis_lateral = 4e-3\nfriction");
    let ellipse = read(&text).hertz.ellipse();
    assert!((ellipse.a() - 6e-3).abs() < 1e-18 && (ellipse.b() - 4e-3).abs() < 1e-18);
}

#[test]
fn young_modulus_and_shear_modulus_say_the_same() {
    let young = 82e9 * 2.0 * 1.28;
    let text = WHEEL_ON_RAIL.replace("shear_modulus = 82e9", &format!("young_modulus = {young}"));
    let [one, two] =
        [WHEEL_ON_RAIL, &text].map(|text| CaseFile::read(text).unwrap().hertz().unwrap());
    assert!((one.ellipse().a() / two.ellipse().a() - 1.0).abs() < 1e-15);
}

#[test]
fn whole_numbers_are_numbers() {
    let text = edited("normal_force = 80e3", "normal_force = 80000").replace("0.46", "1");
    assert!(CaseFile::read(&text).unwrap().case().is_ok());
}

#[test]
fn options_of_the_theory_are_read() {
    let text = format!(
        "{WHEEL_ON_RAIL}\n[solve]\ntheory = \"variational\"\ndegree = 5\nmesh = [12, 8]\n\
         weight = \"uniform\"\n"
    );
    let options = VariationalOptions {
        degree: Some(5),
        mesh: Some([12, 8]),
        weight: Weight::Uniform,
        ..VariationalOptions::default()
    };
    assert_eq!(read(&text).theory, TheorySpec::Variational(options));
}

#[test]
fn the_contact_alone_needs_neither_friction_nor_creepage() {
    let text = edited("friction = 0.3", "");
    let text = &text[..text.find("[creepage]").unwrap()];
    let file = CaseFile::read(text).unwrap();
    assert!(file.hertz().is_ok());
    assert!(matches!(file.case(), Err(CaseError::Missing { key, .. }) if key == "friction"));
}

#[test]
fn a_tilted_ellipse_is_a_contact_but_no_rolling_case() {
    let file = CaseFile::read(&edited("friction", "angle = 30\nfriction")).unwrap();
    assert!(file.hertz().unwrap().angle().abs() > 0.1);
    assert!(matches!(file.case(), Err(CaseError::Tilted { angle, .. }) if angle > 29.9));
}

#[test]
fn an_angle_that_leaves_the_ellipse_straight_is_allowed() {
    // A quarter turn of the rail, and any turn of a body of equal radii.
    let quarter = edited("\"flat\"", "0.8").replace("friction", "angle = 90\nfriction");
    assert!(CaseFile::read(&quarter).unwrap().case().is_ok());
    let ball = WHEEL_ON_RAIL.replace("\"flat\"", "0.3").replace("0.46", "0.3");
    let turned = ball.replace("friction", "angle = 20\nfriction");
    assert!(CaseFile::read(&turned).unwrap().case().is_ok());
}

#[test]
fn the_schema_has_no_null_and_forbids_unknown_keys() {
    let schema = json_schema();
    assert!(!schema.to_string().contains("null"));
    assert_eq!(schema["required"], serde_json::json!(["upper", "lower", "contact"]));
    let all = schema["properties"].as_object().unwrap();
    let theories = schema["properties"]["solve"]["oneOf"].as_array().unwrap();
    assert_eq!(theories.len(), TheorySpec::all().len());
    let sections = all.iter().filter(|(name, _)| *name != "solve");
    let of_solve = theories.iter().map(|theory| ("solve", theory));
    for (section, form) in sections.map(|(name, form)| (&name[..], form)).chain(of_solve) {
        assert_eq!(form["additionalProperties"], false, "{section}");
        for (key, kind) in form["properties"].as_object().unwrap() {
            let described = kind["description"].is_string() || key == "theory";
            assert!(described, "{section}.{key} is not described");
        }
    }
    // Without a name the theory is the full one.
    let named =
        theories.iter().filter(|theory| theory["required"] == serde_json::json!(["theory"]));
    assert_eq!(named.count(), theories.len() - 1);
}

#[test]
fn wanted_forces_are_known_in_the_units_of_the_contact() {
    let [_, eta, chi] = read(WHEEL_ON_RAIL).creepage().unwrap().components();
    let text = edited("longitudinal = -1.5e-3\n", "speed = 20\n")
        + "[wanted]\nlongitudinal_force = -12e3\n";
    let case = read(&text);
    // mu N = 24 kN
    let [fx, eta, chi] = [-0.5, eta, chi].map(Some);
    let constraints = Constraints { fx, eta, chi, ..Constraints::default() };
    assert_eq!((case.given, case.speed), (Given::Constraints(constraints), Some(20.0)));
    assert!(matches!(case.creepage(), Err(CaseError::Wanted)));
}

#[test]
fn wanted_forces_may_be_dimensionless_and_creepages_not() {
    let text =
        edited("longitudinal = -1.5e-3\nlateral = 1e-3\n", "") + "[wanted]\nfx = 0\nmz = 0.1\n";
    let Given::Constraints(known) = read(&text).given else { panic!("no constraints") };
    assert_eq!((known.fx, known.fy, known.mz), (Some(0.0), None, Some(0.1)));
    assert!(known.chi.is_some() && known.xi.is_none() && known.eta.is_none());
}

#[test]
fn resolutions_are_words_or_numbers_of_elements() {
    let resolution = |option: &str| match theory_spec("exact", &[option]).unwrap() {
        TheorySpec::Exact(options) => options.resolution,
        other => panic!("{other:?}"),
    };
    let named = ResolutionSpec::Named;
    assert_eq!(resolution("resolution=fine"), named(NamedResolution::Fine));
    assert_eq!(resolution("resolution = \"auto\""), named(NamedResolution::Auto));
    assert_eq!(resolution("resolution=[30, 20]"), ResolutionSpec::Elements([30, 20]));
}
