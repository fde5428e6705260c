//! `creepage fit`, and `creepage curve --data`.

use crate::place::{CASE, Place};

const POINTS: &str = "longitudinal,longitudinal_coefficient\n\
    5e-4,0.071\n1e-3,0.127\n2e-3,0.196\n3e-3,0.218\n4e-3,0.221\n6e-3,0.219\n8e-3,0.05\n";

fn place(points: &str) -> Place {
    let place = Place::new();
    let contact = &CASE[..CASE.find("[creepage]").unwrap()];
    let rest = "[creepage]\nlongitudinal = 0\n[solve]\ntheory = 'fastsim'\n";
    place.write("case.toml", format!("{contact}{rest}"));
    place.write("points.csv", points);
    place
}

const FIT: [&str; 4] = ["fit", "points.csv", "--case", "case.toml"];

#[test]
fn a_report_and_four_files_the_same_each_time() {
    let place = place(POINTS);
    for out in ["one", "two"] {
        let ran = place.run(&[&FIT[..], &["--slope", "--out", out]].concat());
        let text = ran.done();
        assert!(text.contains("mu ") && text.contains("factor of the slope"), "{text}");
        assert!(text.contains("row 7 lies"), "{text}");
    }
    for file in ["fit.json", "fit.csv", "fit.svg", "fit.png"] {
        let [one, two] =
            ["one", "two"].map(|out| std::fs::read(place.path(out).join(file)).unwrap());
        assert!(one == two && one.len() > 100, "{file}");
    }
    let json = place.run(&[&FIT[..], &["--json"]].concat()).done();
    let report: serde_json::Value = serde_json::from_str(&json).unwrap();
    let mu = report["friction"]["value"].as_f64().unwrap();
    assert!((mu - 0.22).abs() < 0.01, "{mu}");
    assert_eq!(report["points"][6]["use"], "bad");
}

#[test]
fn rows_that_are_no_points_are_named_and_the_code_is_three() {
    let place = place(&format!("{POINTS}9e-3,n/a\n"));
    let ran = place.run(&FIT);
    assert_eq!(ran.code, Some(3), "{}", ran.stderr);
    assert!(ran.stderr.contains("row 8, column longitudinal_coefficient: `n/a`"), "{}", ran.stderr);
}

#[test]
fn wrong_input_is_refused_by_its_cause_and_nothing_is_written() {
    for (points, theory, words) in [
        ("longitudinal\n1e-3\n", "fastsim", "a force is needed"),
        ("longitudnal,lateral_force\n1,2\n", "fastsim", "did you mean `longitudinal`?"),
        ("longitudinal,lateral_force\n1e-3,2\n", "fastsim", "at least 3 are needed"),
        (POINTS, "linear", "do not determine mu"),
        (POINTS, "fastsym", "did you mean"),
    ] {
        let place = place(points);
        let ran = place.run(&[&FIT[..], &["--theory", theory, "--out", "made"]].concat());
        assert_eq!((ran.code, ran.stdout.as_str()), (Some(2), ""), "{}", ran.stderr);
        assert!(ran.stderr.contains(words), "{}", ran.stderr);
        assert!(!place.path("made").exists());
    }
}

#[test]
fn measured_points_lie_over_curves() {
    let place = place(POINTS);
    let data =
        ["curve", "case.toml", "--theory", "fastsim", "--data", "points.csv", "--out", "made"];
    place.run(&data).done();
    let csv = std::fs::read_to_string(place.path("made").join("curve.csv")).unwrap();
    assert_eq!(csv.lines().filter(|line| line.starts_with("measured,,")).count(), 7);
    let svg = std::fs::read_to_string(place.path("made").join("curve.svg")).unwrap();
    assert!(svg.contains(">measured<"));
    let ran = place.run(&["curve", "case.toml", "--data", "points.csv", "--vary", "spin"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("points.csv: column spin is missing"), "{}", ran.stderr);
}
