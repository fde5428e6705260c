//! `creepage table` on good and bad input.

use serde_json::Value;

use crate::place::{Place, json};

const SMALL: [&str; 8] =
    ["--theory", "fastsim", "--intervals", "8,12,12", "--places", "100", "--out", "t.nc"];

fn build(place: &Place, more: &[&str]) {
    place.run(&[&["table", "build"], &SMALL[..], more].concat()).done();
}

fn printed(place: &Place, arguments: &[&str]) -> Value {
    json(&place.run(&[arguments, &["--json"]].concat()).done())
}

#[test]
fn a_table_tells_what_it_is_and_gives_the_force() {
    let place = Place::new();
    build(&place, &[]);
    assert_eq!(place.files(), ["t.nc"]);
    let info = printed(&place, &["table", "info", "t.nc"]);
    assert_eq!(info["theory"], "fastsim");
    assert_eq!(info["error_places"], 100);
    assert!(place.run(&["table", "info", "t.nc"]).done().contains("random places"));
    let found = printed(&place, &["table", "eval", "t.nc", "--xi", "-0.9"]);
    let rows = "a_over_b,poisson,xi,eta,chi\n1,0.28,-0.9,0,0\n";
    place.write("rows.csv", rows);
    let solved = place.run(&["batch", "--theory", "fastsim", "--in", "rows.csv"]).done();
    let right: f64 = solved.lines().nth(1).unwrap().split(',').nth(5).unwrap().parse().unwrap();
    let off = found["fx"].as_f64().unwrap() - right;
    assert!(off.abs() < info["force_error"]["worst"].as_f64().unwrap(), "{off}");
    assert_eq!(found["fy"], 0.0);
    assert!(found["derivative"][0][0].as_f64().unwrap() > 0.0);
    assert!(place.run(&["table", "eval", "t.nc", "--chi", "1"]).done().contains("by chi"));
}

#[test]
fn a_table_of_shapes_must_be_told_the_shape() {
    let place = Place::new();
    build(&place, &["--a-over-b", "0.5,2", "--shapes", "3"]);
    place.run(&["table", "eval", "t.nc", "--xi", "1"]).refused(&["--a-over-b is needed"]);
    let found = printed(&place, &["table", "eval", "t.nc", "--xi", "1", "--a-over-b", "1.3"]);
    assert_eq!(found["a_over_b"], 1.3);
    place.run(&["table", "eval", "t.nc", "--a-over-b", "3"]).refused(&["a_over_b = 3"]);
}

#[test]
fn what_is_no_table_or_cannot_be_one_is_refused() {
    let place = Place::new();
    place.write("t.nc", "no table");
    place.run(&["table", "info", "t.nc"]).refused(&["t.nc", "no table"]);
    for (arguments, words) in [
        (&["--theory", "linear"][..], "infinite creepage"),
        (&["--theory", "saturated"], "in proportion"),
        (&["--theory", "fastsm"], "did you mean"),
        (&["--theory", "polach", "--intervals", "8,11,12"], "even"),
        (&["--theory", "polach", "--a-over-b", "2,1"], "a_over_b"),
        (&["--theory", "polach", "--poisson", "nan"], "poisson"),
        (&["--theory", "polach", "--places", "0"], "error is not known"),
        (&["--theory", "polach", "--places", "700000000000"], "between 1 and 1000000"),
        (
            &[
                "--theory",
                "polach",
                "--a-over-b",
                "0.2,5",
                "--shapes",
                "90",
                "--intervals",
                "300,300,300",
            ],
            "at most 100 million",
        ),
    ] {
        let out = ["table", "build", "--out", "new.nc"];
        place.run(&[&out[..], arguments].concat()).refused(&[words]);
    }
    assert_eq!(place.files(), ["t.nc"]);
    let nowhere = ["table", "build", "--theory", "polach", "--out", "no/t.nc"];
    place.run(&nowhere).refused(&["no/t.nc"]);
}

#[test]
fn a_table_of_the_full_theory_tells_its_elements() {
    let place = Place::new();
    let small = ["--resolution", "fast", "--intervals", "4,4,4", "--places", "8"];
    place.run(&[&["table", "build", "--out", "t.nc"], &small[..]].concat()).done();
    let info = printed(&place, &["table", "info", "t.nc"]);
    assert_eq!([&info["theory"], &info["options"]], ["exact", "resolution = fast"]);
    assert_eq!((&info["doubtful_nodes"], &info["error_places"]), (&0.into(), &8.into()));
    let text = place.run(&["table", "info", "t.nc"]).done();
    // The heads of the columns stand over their numbers.
    let ends: Vec<_> = text.lines().rev().take(3).map(str::len).collect();
    assert!(ends.iter().all(|end| *end == ends[0]), "{text}");
}
