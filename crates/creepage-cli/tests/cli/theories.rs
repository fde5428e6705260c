//! Every theory by name: in `solve`, in `batch`, with its options, and measured.

use std::f64::consts::PI;
use std::fmt::Write;

use serde_json::Value;

use crate::place::{CASE, Place, json};

/// The case of the common tests without any option of a theory.
fn plain_case() -> String {
    CASE[..CASE.find("[solve]").unwrap()].to_owned()
}

/// The names in the first column of `creepage theories`.
fn names(place: &Place) -> Vec<String> {
    let table = place.run(&["theories"]).done();
    let lines = table.lines().skip(1).take_while(|line| !line.is_empty());
    lines.map(|line| line.split_whitespace().next().unwrap().to_owned()).collect()
}

#[test]
fn ten_theories_and_their_options_fit_a_terminal() {
    let place = Place::new();
    assert_eq!(names(&place).len(), 10);
    let table = place.run(&["theories"]).done();
    assert!(table.lines().all(|line| line.chars().count() <= 110), "{table}");
    for words in ["\nOPTIONS in [solve]", "  grid  ", "blended", " 3.5 %"] {
        assert!(table.contains(words), "{words}");
    }
}

#[test]
fn the_facts_of_every_theory_are_there_for_programs() {
    let place = Place::new();
    let facts = json(&place.run(&["theories", "--json"]).done());
    let told: Vec<_> = facts.as_array().unwrap().iter().map(|one| &one["name"]).collect();
    assert_eq!(told, names(&place).iter().collect::<Vec<_>>());
    assert_eq!(facts[0]["dissimilar_bodies"], true);
}

#[test]
fn another_theory_has_its_default_options_whatever_the_case_file_says() {
    let place = Place::new();
    let force = |options: &str| {
        place.write("case.toml", plain_case() + "[solve]\n" + options);
        let command = ["solve", "case.toml", "--theory", "fastrip", "--json"];
        json(&place.run(&command).done())["lower_body"].clone()
    };
    assert_eq!(force("theory = \"fastsim\"\ngrid = [4, 4]"), force(""));
    assert_ne!(force("theory = \"fastrip\"\ngrid = [4, 4]"), force(""));
}

#[test]
fn every_theory_solves_a_case_with_all_files() {
    let place = Place::new();
    place.write("case.toml", plain_case());
    for name in names(&place) {
        let command = ["solve", "case.toml", "--theory", &name, "--json", "--out", &name];
        let report = json(&place.run(&command).done());
        assert_eq!(report["theory"], name);
        // Pure traction and a little spin: all but linear theory stay within friction.
        let fx = report["dimensionless"]["fx"].as_f64().unwrap();
        assert!(fx < -0.3 && (fx > -1.0 || name == "linear"), "{name}: {fx}");
        let points = place.read(&format!("{name}/points.csv"));
        assert!(points.lines().count() > 60, "{name}");
        assert!(place.path(&name).join("contact.png").is_file(), "{name}");
        let vtk = place.read(&format!("{name}/contact.vtk"));
        assert!(vtk.contains("VECTORS traction_pa") && !vtk.contains("NaN"), "{name}");
    }
}

#[test]
fn every_theory_answers_extremes_in_batch_without_nan() {
    let extremes = ["0", "-0.0", "1e-300", "1e-6", "0.3", "1", "40", "1e100", "-1e100"];
    let mut input = String::from("a_over_b,poisson,xi,eta,chi\n");
    for (ratio, creepage) in extremes.iter().flat_map(|r| extremes.map(|c| (r, c))) {
        writeln!(input, "{ratio},0.28,{creepage},1,1\n{ratio},0.5,1,1,{creepage}").unwrap();
    }
    let place = Place::new();
    for name in names(&place) {
        let ran = place.run_on(&["batch", "--theory", &name], input.clone());
        assert_eq!(ran.code, Some(3), "{}", ran.stderr);
        let header: Vec<_> = ran.stdout.lines().next().unwrap().split(',').collect();
        let status = header.iter().position(|column| *column == "status").unwrap();
        let mut solved = 0;
        for line in ran.stdout.lines().skip(1) {
            let row: Vec<_> = line.split(',').collect();
            let finite = |text: &&str| text.parse::<f64>().is_ok_and(f64::is_finite);
            let numbers = &row[5..status];
            assert!(row[status] == "invalid" || numbers.iter().all(finite), "{name} {line}");
            solved += usize::from(row[status] != "invalid");
        }
        // At least the three ratios of contacts that occur.
        assert!(solved >= 3 * 2 * extremes.len(), "{name}: {solved}");
    }
}

#[test]
fn options_change_the_answer() {
    let place = Place::new();
    let forces = |options: &str| {
        place.write("case.toml", plain_case() + "[solve]\n" + options);
        json(&place.run(&["solve", "case.toml", "--json"]).done())["dimensionless"].clone()
    };
    for (theory, options) in [
        ("fastsim", &["grid = [10, 10]", "flexibility = \"three\"", "bound = \"parabolic\""][..]),
        ("fastrip", &["grid = [10, 10]", "variant = \"original\""]),
        ("polach", &["reduction = [0.6, 0.3]", "reduction = [1, 0.3]"]),
        ("variational", &["bound = \"kept\"", "weight = \"uniform\""]),
    ] {
        let theory = format!("theory = \"{theory}\"\n");
        let usual = forces(&theory);
        for option in options {
            assert_ne!(usual, forces(&format!("{theory}{option}")), "{option}");
        }
    }
    let [said, unsaid] = ["flexibility = \"blended\"\nbound = \"elliptic\"\ngrid = [50, 50]", ""];
    let theory = "theory = \"fastsim\"\n";
    assert_eq!(forces(&format!("{theory}{said}")), forces(&format!("{theory}{unsaid}")));
    for (theory, said) in
        [("polach", "reduction = [1, 1]"), ("variational", "bound = \"automatic\"")]
    {
        let theory = format!("theory = \"{theory}\"\n");
        assert_eq!(forces(&format!("{theory}{said}")), forces(&theory));
    }
}

#[test]
fn an_option_of_another_theory_is_refused() {
    let place = Place::new();
    let refused = |options: &str, arguments: &[&str], parts: &[&str]| {
        place.write("case.toml", plain_case() + "[solve]\n" + options);
        let command = [&["solve", "case.toml", "--out", "out"], arguments].concat();
        place.run(&command).refused(parts);
        assert_eq!(place.files(), ["case.toml"]);
    };
    let words = ["case.toml: [solve] `grid` is an option of fastrip and fastsim, not of linear"];
    refused("theory = \"linear\"\ngrid = [9, 9]", &[], &words);
    let words = ["`grid` is an option of fastrip and fastsim, not of exact"];
    refused("grid = [9, 9]", &["--theory", "fastsim"], &words);
    let words = ["`bound` is an option of variational and fastsim, not of exact"];
    refused("bound = \"elliptic\"", &[], &words);
    let words = ["[solve] bound = \"kept\" is not valid for fastsim", "`parabolic` or `elliptic`"];
    refused("theory = \"fastsim\"\nbound = \"kept\"", &[], &words);
    let words = ["[solve] bound = \"elliptic\" is not valid for variational", "`unchecked`"];
    refused("theory = \"variational\"\nbound = \"elliptic\"", &[], &words);
    refused("theory = \"variational\"\nbound = \"round\"", &[], &["round", "`automatic`"]);
    for (reduction, value) in
        [("[1.5, 1]", "1.5"), ("[0.5, 0.7]", "0.7"), ("[0.5, 0]", "0"), ("[nan, 1]", "NaN")]
    {
        let value = format!("[solve] reduction = {value} is not valid");
        let options = format!("theory = \"polach\"\nreduction = {reduction}");
        refused(&options, &[], &[&value, "[adhesion, slip] with 0 < slip <= adhesion <= 1"]);
    }
    refused("theory = \"polach\"\nreduction = [1]", &[], &["reduction = [1]", "length 2"]);
    refused("theory = \"fastsim\"\ngrid = [0, 9]", &[], &["[solve]", "grid", "0"]);
    refused("resolution = [3, 20]", &[], &["[solve] resolution = 3", "between 4 and 200"]);
    refused("resolution = \"coarse\"", &[], &["coarse", "\"standard\""]);
    refused("accuracy = 0.01", &[], &["[solve] `accuracy` needs resolution = \"auto\""]);
    refused("resolution = \"auto\"\naccuracy = 0", &[], &["[solve] accuracy = 0", "than zero"]);
    refused("theory = \"fastsim\"\nflexibility = \"two\"", &[], &["two", "blended"]);
}

#[test]
fn options_of_a_theory_that_is_replaced_are_ignored_aloud() {
    let place = Place::new();
    place.write("case.toml", CASE);
    let ran = place.run(&["solve", "case.toml", "--theory", "fastsim"]);
    assert!(
        ran.stderr.contains("note: the options in [solve] are those of variational"),
        "{ran:?}"
    );
    assert!(ran.done().contains("fastsim"));
    assert_eq!(place.run(&["solve", "case.toml", "--theory", "variational"]).stderr, "");
}

#[test]
fn coefficients_of_the_circle_in_closed_form() {
    let place = Place::new();
    let command = ["coefficients", "--a-over-b", "1", "--poisson", "0", "--json"];
    let found = json(&place.run(&command).done());
    let values = [
        ("c11", 32.0 / (3.0 * PI)),
        ("c22", 32.0 / (3.0 * PI)),
        ("c23", 4.0 / 3.0),
        ("c32", -4.0 / 3.0),
        ("c33", 512.0 / (135.0 * PI)),
    ];
    for (name, value) in values {
        // As exact as the library says of this case.
        assert!((found[name].as_f64().unwrap() - value).abs() < 1e-12, "{name}");
    }
    let text = place.run(&command[..5]).done();
    assert!(text.contains("C11       3.395305  longitudinal force by"), "{text}");
}

#[test]
fn coefficients_of_degree_5_are_those_of_table_3() {
    let place = Place::new();
    let command = ["coefficients", "--a-over-b", "0.5", "--poisson", "0.25", "--degree", "5"];
    let degree_5 = json(&place.run(&[&command[..], &["--json"]].concat()).done());
    let converged = json(&place.run(&[&command[..5], &["--json"]].concat()).done());
    assert_eq!(degree_5["degree"], 5);
    assert!(converged["degree"].is_null());
    let c11 = |found: &Value| found["c11"].as_f64().unwrap();
    // Three printed digits.
    assert!((c11(&degree_5) - 3.62).abs() < 0.005, "{degree_5}");
    assert!((c11(&degree_5) - c11(&converged)).abs() > 1e-6);
}

#[test]
fn coefficients_without_sense_are_refused() {
    let place = Place::new();
    let refused = |ratio: &str, poisson: &str, part: &str| {
        let command = ["coefficients", "--a-over-b", ratio, "--poisson", poisson];
        place.run(&command).refused(&[part]);
    };
    refused("0", "0.3", "a_over_b = 0");
    refused("-1", "0.3", "a_over_b = -1");
    refused("nan", "0.3", "a_over_b = NaN");
    refused("1e4", "0.3", "between 1e-3 and 1e3");
    refused("1", "0.6", "poisson = 0.6");
    let command = ["coefficients", "--a-over-b", "1", "--poisson", "0.3", "--degree", "1"];
    place.run(&command).refused(&["degree = 1", "between 2 and 100"]);
}

#[test]
fn the_accuracy_table_has_a_row_for_each_theory_and_is_plausible() {
    let place = Place::new();
    let table = place.run(&["accuracy"]).done();
    let rows: Vec<Vec<_>> = table
        .lines()
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    assert!(rows.iter().all(|row| row.len() == 12), "{table}");
    assert!(rows[1].iter().all(|cell| cell.contains("--")));
    for name in names(&place) {
        assert!(rows.iter().any(|row| row[0] == name), "{name}");
    }
    for row in &rows[2..] {
        let numbers: Vec<f64> = row[1..].iter().map(|cell| cell.parse().unwrap()).collect();
        for spread in [&numbers[..5], &numbers[5..10]] {
            let [mean, rms, p95, worst, median] = spread else { unreachable!("{row:?}") };
            assert!(mean <= rms && p95 <= worst && rms <= worst && median <= worst, "{row:?}");
        }
    }
    let rms = |name: &str| {
        let row = rows.iter().find(|row| row[0].starts_with(name)).unwrap();
        row[2].parse::<f64>().unwrap()
    };
    // Of FASTSIM over other sets of cases: 2.3 to 2.6 blended, 5 with three flexibilities.
    assert!((2.0..4.0).contains(&rms("fastsim")));
    assert!((4.0..6.0).contains(&rms("fastsim, three")));
    assert!(rms("fastrip") < rms("fastsim") && rms("fastsim") < rms("polach"));
}

#[test]
fn accuracy_of_some_theories_in_json() {
    let place = Place::new();
    let found = json(&place.run(&["accuracy", "--theory", "linear,strip", "--json"]).done());
    let rows = found.as_array().unwrap();
    assert_eq!(rows.len(), 2);
    assert_eq!((&rows[0]["theory"], &rows[0]["cases"]), (&"linear".into(), &132.into()));
    assert!(rows[1]["doubtful"].as_u64().unwrap() > 10);
    assert!(rows[1]["force"]["rms"].as_f64().unwrap() < 0.5);
    place.run(&["accuracy", "--theory", "linear,magic"]).refused(&["unknown theory `magic`"]);
}

/// Long waves have the steady coefficients; those shorter than elements are refused.
#[test]
fn coefficients_of_waves() {
    let run = |wavelength: &str| {
        let command = ["coefficients", "--a-over-b", "1", "--poisson", "0.28", "--json"];
        Place::new().run(&[&command[..], &["--wavelength", wavelength]].concat())
    };
    let (long, short) = (json(&run("1000").done()), json(&run("2").done()));
    let part = |found: &Value, k: usize| found["c11"][k].as_f64().unwrap();
    let steady =
        Place::new().run(&["coefficients", "--a-over-b", "1", "--poisson", "0.28", "--json"]);
    let steady = json(&steady.done())["c11"].as_f64().unwrap();
    assert!((part(&long, 0) / steady - 1.0).abs() < 1e-3, "{long} {steady}");
    assert!(part(&short, 0) < 0.05 * steady && part(&short, 1) < 0.0, "{short}");
    for wavelength in ["0.1", "-1", "nan"] {
        run(wavelength).refused(&["wavelength", "half a semi-axis"]);
    }
}
