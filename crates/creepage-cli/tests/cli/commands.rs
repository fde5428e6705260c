//! The commands on good input, and what they print.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::place::{CASE, Place, json};

#[test]
fn solve_writes_its_files_and_prints_the_same_report() {
    let place = Place::new();
    place.write("case.toml", CASE);
    let printed = place.run(&["solve", "case.toml", "--json", "--out", "deep/out"]).done();
    for file in ["report.json", "points.csv", "contact.vtk", "contact.svg", "contact.png"] {
        assert!(place.path("deep/out").join(file).is_file(), "{file}");
    }
    assert_eq!(json(&printed), json(&place.read("deep/out/report.json")));
    assert!(place.read("deep/out/points.csv").lines().count() > 50);
}

#[test]
fn solve_prints_a_report_for_a_person() {
    let place = Place::new();
    place.write("case.toml", CASE);
    let report = place.run(&["solve", "case.toml"]).done();
    for words in ["variational", "on the lower body", "on the upper body", "adhesion"] {
        assert!(report.contains(words), "`{words}` is not in:\n{report}");
    }
    assert_eq!(place.files(), ["case.toml"]);
}

#[test]
fn the_theory_on_the_command_line_goes_before_that_of_the_case() {
    let place = Place::new();
    place.write("case.toml", CASE);
    let command = ["solve", "case.toml", "--theory", "linear"];
    assert!(place.run(&command).done().starts_with("Theory linear: solved"));
}

/// An upper body as soft as aluminium on steel.
#[test]
fn unlike_bodies_add_the_slip_by_the_pressure() {
    let place = Place::new();
    let solve = |text: String| {
        place.write("case.toml", text);
        json(&place.run(&["solve", "case.toml", "--theory", "exact", "--json"]).done())
    };
    let like = solve(CASE.into());
    assert!(like["details"]["kappa_over_mu"].is_null());
    let unlike = solve(CASE.replacen("82e9", "27e9", 1));
    let kappa_over_mu = unlike["details"]["kappa_over_mu"]["value"].as_f64().unwrap();
    // (2.10) with both Poisson's ratios 0.28, over friction.
    assert!((kappa_over_mu - 0.22 * (27.0 - 82.0) / (27.0 + 82.0) / 0.3).abs() < 1e-12);
    let power = |key: &str| unlike[key].as_f64().unwrap();
    let [by_force, by_slip] =
        ["frictional_power_per_metre_j_per_m", "frictional_power_per_metre_by_slip_j_per_m"]
            .map(power);
    // Heat in slip areas narrower than an element is counted.
    assert!((by_force - by_slip).abs() < 0.002 * by_force, "{by_force} {by_slip}");
}

/// The same bodies by theories that take them for like ones.
#[test]
fn what_is_left_out_between_unlike_bodies_is_told() {
    let place = Place::new();
    place.write("unlike.toml", CASE.replacen("82e9", "27e9", 1));
    // kappa/mu = -0.001: nobody would see it.
    place.write("nearly-like.toml", CASE.replacen("82e9", "81.74e9", 1));
    let solve = |case, theory| place.run(&["solve", case, "--theory", theory, "--json"]);
    let words = "takes the bodies for like ones (kappa/mu = -0.370)";
    let ran = solve("unlike.toml", "fastsim");
    assert!(ran.stderr.contains(&format!("caution: fastsim {words}")), "{}", ran.stderr);
    let caution = json(&ran.done())["caution"].as_str().unwrap().to_owned();
    assert!(caution.starts_with(&format!("fastsim {words}")), "{caution}");
    let text = place.run(&["solve", "unlike.toml", "--theory", "fastsim"]).done();
    assert!(text.contains("\nCAUTION: fastsim takes the bodies for like ones"), "{text}");
    let ran = solve("nearly-like.toml", "fastsim");
    assert!(!ran.stderr.contains("caution"), "{}", ran.stderr);
    assert!(json(&ran.done())["caution"].is_null());
    // `exact` counts the slip by the pressure, and leaves out what tractions do to the pressure.
    let caution =
        json(&solve("unlike.toml", "exact").done())["caution"].as_str().unwrap().to_owned();
    assert!(!caution.contains(words) && caution.contains("coupled = true counts it"), "{caution}");
    let curve = ["curve", "unlike.toml", "--theory", "exact,linear,polach", "--points", "2"];
    let said = place.run(&curve).stderr;
    assert_eq!(said.matches(words).count(), 2, "{said}");
    assert!(said.contains("caution: linear ") && said.contains("caution: polach "), "{said}");
}

#[test]
fn options_of_the_theory_reach_it() {
    let place = Place::new();
    let force = |options: &str| {
        place.write("case.toml", CASE.replace("degree = 3", options));
        json(&place.run(&["solve", "case.toml", "--json"]).done())
    };
    let usual = force("degree = 3");
    assert_eq!(usual, force(""));
    for options in ["degree = 5", "mesh = [20, 20]", "weight = \"uniform\""] {
        assert_ne!(usual, force(options), "{options}");
    }
}

/// The full theory's case with these options.
fn exact(place: &Place, options: &str) -> Value {
    let case = CASE.replace("theory = \"variational\"\ndegree = 3", options);
    place.write("case.toml", case);
    json(&place.run(&["solve", "case.toml", "--json"]).done())
}

#[test]
fn the_full_theory_takes_any_number_of_elements() {
    let place = Place::new();
    let elements =
        |options: &str| exact(&place, options)["details"]["elements"]["value"].as_f64().unwrap();
    let standard = elements("");
    assert_eq!(elements("resolution = [22, 18]").to_bits(), standard.to_bits());
    // Four times as many; both numbers are rounded to even ones.
    let ratio = elements("resolution = [44, 36]") / standard;
    assert!((ratio - 4.0).abs() < 0.5, "{ratio}");
}

#[test]
fn an_automatic_resolution_meets_the_accuracy_that_is_wanted() {
    let place = Place::new();
    let bar_and_elements = |options: &str| {
        let report = exact(&place, options);
        let detail = |key: &str| report["details"][key]["value"].as_f64().unwrap();
        (detail("fx_error").max(detail("fy_error")), detail("elements"))
    };
    let mut last = 0.0;
    for named in ["fast", "standard", "fine"] {
        let (accuracy, most) = bar_and_elements(&format!("resolution = \"{named}\""));
        let options = format!("resolution = \"auto\"\naccuracy = {accuracy}");
        let (bar, elements) = bar_and_elements(&options);
        assert!(
            bar <= accuracy && elements <= most && elements > last,
            "{named}: {bar} {elements}"
        );
        last = elements;
    }
    let case = place.read("case.toml");
    place.write("case.toml", case.replace("accuracy = ", "accuracy = 1e-9 # "));
    let ran = place.run(&["solve", "case.toml"]);
    assert!(ran.stderr.contains("caution: at the finest resolution the error bars reach"));
    ran.done();
}

#[test]
fn a_speed_gives_watts_and_changes_nothing_else() {
    let place = Place::new();
    let slow = exact(&place, "");
    let case = place.read("case.toml");
    place.write("case.toml", case.replace("spin = 0.2", "spin = 0.2\nspeed = 30"));
    let mut fast = json(&place.run(&["solve", "case.toml", "--json", "--out", "out"]).done());
    let per_metre = fast["frictional_power_per_metre_j_per_m"].as_f64().unwrap();
    let watts = fast["frictional_power_w"].take().as_f64().unwrap();
    // One product.
    assert!((watts / (30.0 * per_metre) - 1.0).abs() < 1e-15);
    assert_eq!(fast["rolling_velocity_m_per_s"].take(), 30.0);
    assert_eq!(fast, slow);
    assert!(place.read("out/points.csv").lines().next().unwrap().ends_with("_w_per_m2"));
    assert!(place.read("out/contact.vtk").contains("SCALARS frictional_power_w_per_m2"));
}

#[test]
fn frictional_power_is_the_same_by_force_and_by_slip() {
    let place = Place::new();
    let report = exact(&place, "resolution = \"fine\"");
    let power = |key: &str| report[key].as_f64().unwrap();
    let by_force = power("frictional_power_per_metre_j_per_m");
    let by_slip = power("frictional_power_per_metre_by_slip_j_per_m");
    // The error of discretization; the force is extrapolated, the sum over elements is not.
    assert!((by_slip / by_force - 1.0).abs() < 0.02, "{by_slip} {by_force}");
}

#[test]
fn hertz_needs_the_contact_only() {
    let place = Place::new();
    place.write("case.toml", &CASE[..CASE.find("friction").unwrap()]);
    assert!(place.run(&["hertz", "case.toml"]).done().contains("6.677"));
    let contact = json(&place.run(&["hertz", "case.toml", "--json"]).done());
    let a = contact["semi_axis_rolling_m"].as_f64().unwrap();
    assert!((a - 6.677_289e-3).abs() < 1e-9, "{contact}");
    place.run(&["solve", "case.toml"]).refused(&["[contact] friction is missing"]);
}

#[test]
fn hertz_takes_a_turned_rail_and_solve_does_not() {
    let place = Place::new();
    place.write("case.toml", CASE.replace("friction", "angle = 30.0\nfriction"));
    place.run(&["hertz", "case.toml"]).done();
    place.run(&["solve", "case.toml"]).refused(&["[contact] angle = 30 degrees"]);
}

#[test]
fn theories_are_listed() {
    let table = Place::new().run(&["theories"]).done();
    assert!(table.starts_with("THEORY"));
    assert!(table.contains("\nvariational          1967  "));
}

#[test]
fn init_writes_a_case_that_solves_and_overwrites_nothing() {
    let place = Place::new();
    let example = place.run(&["init"]).done();
    place.run(&["init", "--out", "case.toml"]).done();
    assert_eq!(place.read("case.toml"), example);
    place.run(&["solve", "case.toml"]).done();
    place.write("case.toml", "mine");
    place.run(&["init", "--out", "case.toml"]).refused(&["cannot write case.toml", "exists"]);
    assert_eq!(place.read("case.toml"), "mine");
}

#[test]
fn what_init_shows_in_comments_is_a_case_too() {
    let place = Place::new();
    let example = place.run(&["init"]).done();
    let dimensionless = example
        .replace("longitudinal = ", "# longitudinal = ")
        .replace("\nlateral = ", "\n# lateral = ")
        .replace("\nspin = ", "\n# spin = ")
        .replace("# xi", "xi")
        .replace("# eta", "eta")
        .replace("# chi", "chi");
    place.write("dimensionless.toml", dimensionless);
    place.run(&["solve", "dimensionless.toml"]).done();
    let axes = example.replace("\nradius", "\n# radius").replace("# semi_axis", "semi_axis");
    place.write("axes.toml", axes);
    place.run(&["solve", "axes.toml"]).done();
    for (option, theory) in [
        ("reduction = ", "polach"),
        ("degree = ", "variational"),
        ("bound = \"kept\"", "variational"),
        ("grid = ", "fastsim"),
        ("bound = \"parabolic\"", "fastsim"),
    ] {
        let case = example
            .replace("\ntheory", "\n# theory")
            .replace("\nresolution", "\n# resolution")
            .replace(&format!("# theory = \"{theory}\""), &format!("theory = \"{theory}\""))
            .replace(&format!("# {option}"), option);
        place.write("option.toml", case);
        let report = place.run(&["solve", "option.toml"]).done();
        assert!(report.contains(&format!("Theory {theory}")), "{option}: {report}");
    }
    let wanted = example
        .replace("\nlongitudinal = ", "\n# longitudinal = ")
        .replace("# speed", "speed")
        .replace("# [wanted]", "[wanted]")
        .replace("# longitudinal_force", "longitudinal_force");
    place.write("wanted.toml", wanted);
    let report = place.run(&["solve", "wanted.toml"]).done();
    assert!(report.contains("-12.000 kN") && report.contains("frictional power"), "{report}");
}

#[test]
fn version_and_help() {
    let place = Place::new();
    assert_eq!(place.run(&["--version"]).done(), "creepage 0.1.0\n");
    assert!(place.run(&["--help"]).done().contains("Exit codes:"));
}

#[test]
fn nothing_is_coloured_where_there_is_no_terminal() {
    let place = Place::new();
    place.write("case.toml", CASE.replace("80e3", "0"));
    for arguments in [&["solve", "case.toml"][..], &["bach"], &["--help"]] {
        let ran = place.run(arguments);
        assert!(!ran.stdout.contains('\x1b') && !ran.stderr.contains('\x1b'), "{ran:?}");
    }
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    let mut input = String::from("a_over_b,poisson,xi,eta,chi\n");
    input.push_str(&"1,0.28,x,0,0\n".repeat(50_000));
    let place = Place::new();
    place.write("in.csv", input);
    let mut child = Command::new(env!("CARGO_BIN_EXE_creepage"))
        .args(["batch", "--theory", "variational", "--in", "in.csv"])
        .current_dir(place.path(""))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(line, "a_over_b,poisson,xi,eta,chi,fx,fy,mz,status,message\n");
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    assert_eq!(output.status.code(), Some(0));
}
