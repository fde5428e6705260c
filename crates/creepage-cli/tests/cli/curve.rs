//! `creepage curve`: what is varied, how far, and what is written.

use crate::place::{CASE, Place};

/// A place with a case of those creepages, and no option of any theory.
fn place(creepages: &str) -> Place {
    let place = Place::new();
    let contact = &CASE[..CASE.find("[creepage]").unwrap()];
    place.write("case.toml", format!("{contact}[creepage]\n{creepages}\n"));
    place
}

fn curve<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    [&["curve", "case.toml"], arguments].concat()
}

/// Column `name` of a CSV.
fn column(csv: &str, name: &str) -> Vec<String> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let place = reader.headers().unwrap().iter().position(|head| head == name).unwrap();
    reader.records().map(|row| row.unwrap()[place].to_owned()).collect()
}

fn numbers(csv: &str, name: &str) -> Vec<f64> {
    column(csv, name).iter().map(|cell| cell.parse().unwrap()).collect()
}

#[test]
fn three_files_the_same_each_time() {
    let place = place("longitudinal = 1e-3\nspin = 0.2");
    for out in ["one", "deep/two"] {
        let theories = "variational,fastsim,fastrip,polach,linear";
        let ran = place.run(&curve(&["--theory", theories, "--out", out]));
        // A caution on linear theory, and the files.
        assert_eq!(ran.stderr.lines().count(), 4, "{}", ran.stderr);
        assert_eq!(ran.done(), "");
    }
    for file in ["curve.csv", "curve.svg", "curve.png"] {
        let [one, two] =
            ["one", "deep/two"].map(|out| std::fs::read(place.path(out).join(file)).unwrap());
        assert!(one == two && one.len() > 10_000, "{file}");
    }
}

#[test]
fn the_quantity_of_the_case_from_zero_well_into_sliding() {
    for (creepages, axis, force) in [
        ("xi = -0.3\nchi = 0.1", "xi", "fx"),
        ("xi = -0.1\neta = 0.3", "eta", "fy"),
        ("eta = 0.1\nchi = 1.0", "chi", "mz"),
    ] {
        let csv = place(creepages).run(&curve(&["--theory", "fastrip"])).done();
        let (values, forces) = (numbers(&csv, axis), numbers(&csv, force));
        assert_eq!(values.len(), 201);
        assert!(values.is_sorted() && values.contains(&0.0), "{creepages}");
        let largest = values.iter().zip(&forces).max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        let (value, force) = largest.unwrap();
        // The force has the sense of its creepage, and is near its limit; in pure spin of the
        // circle that is 3 pi/16 = .59.
        assert!(value * force > 0.0 && force.abs() > 0.5, "{creepages}: {value} {force}");
    }
}

#[test]
fn range_and_unit_follow_the_quantity() {
    let place = place("longitudinal = 1e-3\nlateral = 2e-3");
    let run = |arguments: &[&str]| place.run(&curve(arguments)).done();
    let si = run(&["--vary", "lateral", "--from", "-1e-3", "--to", "3e-3", "--points", "5"]);
    let values = numbers(&si, "lateral");
    for (value, expected) in values.iter().zip([-1e-3, 0.0, 1e-3, 2e-3, 3e-3]) {
        // Two roundings of the unit.
        assert!((value - expected).abs() < 1e-17, "{values:?}");
    }
    let own = run(&["--vary", "eta", "--to", "2", "--points", "3"]);
    assert_eq!(numbers(&own, "eta"), [0.0, 1.0, 2.0]);
    assert!(numbers(&own, "longitudinal").iter().all(|value| (value - 1e-3).abs() < 1e-17));
    assert_eq!(column(&own, "theory"), ["exact"; 3]);
}

#[test]
fn options_of_the_case_reach_the_theory_that_has_them() {
    let place = place("xi = 1.0\n[solve]\ntheory = \"fastsim\"\ngrid = [5, 5]");
    let both = place.run(&curve(&["--theory", "fastsim,linear"]));
    assert!(both.stderr.starts_with("caution: linear knows no slip"), "{}", both.stderr);
    assert_eq!(both.stderr.lines().count(), 1, "{}", both.stderr);
    let other = place.run(&curve(&["--theory", "linear"]));
    assert!(other.stderr.contains("[solve] are those of fastsim"), "{}", other.stderr);
    let coarse = both.done();
    place.write("case.toml", place.read("case.toml").replace("[5, 5]", "[50, 50]"));
    assert_ne!(coarse, place.run(&curve(&["--theory", "fastsim,linear"])).done());
}

#[test]
fn bad_arguments_are_refused_and_nothing_is_written() {
    let place = place("xi = 1.0");
    let refused = |arguments: &[&str], parts: &[&str]| {
        let command = [&curve(arguments)[..], &["--out", "out"]].concat();
        place.run(&command).refused(parts);
        assert_eq!(place.files(), ["case.toml"]);
    };
    refused(&["--theory", "linear,magic"], &["unknown theory `magic`"]);
    refused(&["--vary", "sideways"], &["sideways", "longitudinal"]);
    refused(&["--to", "1"], &["--vary"]);
    refused(&["--vary", "xi", "--from", "1", "--to", "1"], &["to = 1 is not valid"]);
    refused(&["--vary", "xi", "--to", "nan"], &["to = NaN is not valid"]);
    refused(&["--vary", "xi", "--from", "inf"], &["from = inf is not valid"]);
    refused(&["--vary", "xi", "--to", "1e101"], &["xi = 1"]);
    refused(&["--points", "1"], &["1", "2..=10001"]);
    refused(&["--points", "-1"], &["-1", "2..=10001"]);
    place.run(&["curve", "nowhere.toml"]).refused(&["cannot read nowhere.toml"]);
    place.write("file", "in the way");
    place.run(&curve(&["--out", "file/out"])).refused(&["cannot write file/out"]);
}
