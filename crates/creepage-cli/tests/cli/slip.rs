//! `[contact] slip`: rigid slip from place to place, by the command.

use std::fmt::Write as _;

use crate::gap;
use crate::place::{CASE, Place, json};

/// A slip by place as CSV, on a grid that covers the contact.
fn slips(slip: impl Fn(f64, f64) -> [f64; 2]) -> String {
    let mut text = "x,y,longitudinal,lateral\n".to_owned();
    for i in -8..=8 {
        for j in -8..=8 {
            let (x, y) = (f64::from(i) * 1e-3, f64::from(j) * 1e-3);
            let [along, across] = slip(x, y);
            writeln!(text, "{x:e},{y:e},{along:e},{across:e}").unwrap();
        }
    }
    text
}

/// The full theory of an ellipse and of any shape, with a slip and without some of the creepage.
fn cases() -> [[String; 2]; 2] {
    let ellipse = CASE.replace("theory = \"variational\"\ndegree = 3", "resolution = \"fast\"");
    [ellipse, gap::CASE.to_owned()].map(|whole| {
        let rest = whole
            .replace("longitudinal = -1.5e-3", "longitudinal = -0.5e-3")
            .replace("friction = 0.3", "friction = 0.3\nslip = \"slip.csv\"");
        [whole, rest]
    })
}

/// How far the contact reaches across (m).
fn half_width(report: &serde_json::Value) -> f64 {
    let contact = &report["contact"];
    contact["semi_axis_lateral_m"].as_f64().unwrap_or_else(|| {
        let patches = report.pointer("/patches/0/extent_m/y");
        let y = patches.or(contact.pointer("/patches/0/extent_m/y")).unwrap();
        [0, 1].map(|end| y[end].as_f64().unwrap().abs()).into_iter().fold(0.0, f64::max)
    })
}

fn forces(place: &Place, case: &str) -> Vec<f64> {
    place.write("case.toml", case);
    let report = json(&place.run(&["solve", "case.toml", "--json"]).done());
    let names = ["longitudinal_n", "lateral_n", "moment_n_m"];
    names.map(|name| report["lower_body"][name].as_f64().unwrap()).to_vec()
}

/// A slip that is the same everywhere is a creepage, by a file and by columns; another one is not.
#[test]
fn a_uniform_slip_is_a_creepage() {
    for [whole, rest] in cases() {
        let place = Place::new();
        place.write("slip.csv", slips(|_, _| [-1e-3, 0.0]));
        let [by_creepage, by_slip] = [&whole, &rest].map(|case| forces(&place, case));
        for (one, other) in by_creepage.iter().zip(&by_slip) {
            // Both solved to a ten millionth of mu N (24 kN), moments to that times millimetres.
            assert!((one - other).abs() < 0.01, "{by_creepage:?} {by_slip:?}");
        }
        let columns = "slip = { x = [0.0], y = [0.0], longitudinal = [-1e-3], lateral = [0.0] }";
        let inline = forces(&place, &rest.replace("slip = \"slip.csv\"", columns));
        assert!((inline[0] - by_slip[0]).abs() < 0.01, "{inline:?}");
        // Of a groove: more outside than inside.
        place.write("slip.csv", slips(|_, y| [-50.0 * y * y, 0.0]));
        let grooved = forces(&place, &rest);
        assert!((grooved[0] - by_slip[0]).abs() > 240.0, "{grooved:?} {by_slip:?}");
        let report = json(&place.run(&["solve", "case.toml", "--json"]).done());
        let largest = report["details"]["added_slip"]["value"].as_f64().unwrap();
        // That of the outermost elements of the contact, not of the grid: within 2 b/10 of its edge, as strips are wide.
        let half = half_width(&report);
        let [inner, edge] = [0.8 * half, half].map(|y| 50.0 * y * y);
        assert!(half > 2e-3 && half < 8e-3, "{half}");
        assert!((inner..=edge).contains(&largest), "{inner} {largest} {edge}");
    }
}

/// Rolling in steps goes to the steady solution, and starts from it.
#[test]
fn histories_have_it() {
    for [_, rest] in cases() {
        let place = Place::new();
        place.write("slip.csv", slips(|x, y| [-50.0 * y * y, 0.1 * x]));
        let steady = forces(&place, &rest);
        let (head, tail) = (rest.find("[creepage]").unwrap(), rest.find("[solve]").unwrap());
        let solve = rest[tail..].replace("\"fast\"", "[10, 10]");
        let rolls = format!("{}{solve}", &rest[..head]);
        place.write("history.csv", "distance,longitudinal,lateral,spin\n0.06,-0.5e-3,1e-3,0.2\n");
        for start in ["none", "steady"] {
            place.write("rolls.toml", format!("{rolls}[start]\ntraction = \"{start}\"\n"));
            let rows = place.run(&["roll", "rolls.toml", "--history", "history.csv"]).done();
            let last: Vec<&str> = rows.lines().last().unwrap().split(',').collect();
            for (cell, steady) in last[7..9].iter().zip(&steady) {
                // Few elements: a hundredth of mu N.
                assert!((cell.parse::<f64>().unwrap() - steady).abs() < 240.0, "{rows} {steady}");
            }
        }
    }
}

/// What was read is not written over, numbers that leave the slip out are refused, and a grid that is too small is told.
#[test]
fn a_slip_is_kept_and_what_it_does_not_cover_is_told() {
    for [_, case] in cases() {
        let place = Place::new();
        let points = slips(|_, y| [-50.0 * y * y, 0.0]);
        for own in ["points.csv", "report.json"] {
            place.write(own, &points);
            place.write("own.toml", case.replace("slip.csv", own));
            place.run(&["solve", "own.toml", "--out", "."]).refused(&["written over"]);
            assert_eq!(place.read(own), points);
            if case.contains("[gap]") {
                let rows = ["batch", "--case", "own.toml", "--out", own];
                place.run_on(&rows, "longitudinal\n0.01\n").refused(&["written over"]);
                assert_eq!(place.read(own), points);
            }
        }
        place.write("slip.csv", &points);
        let body = "{ material = \"steel\", bulk_temperature = 20.0 }";
        place.write("both.toml", format!("{case}\n[heat]\nupper = {body}\nlower = {body}\n"));
        place.run(&["solve", "both.toml"]).refused(&["[heat]"]);
        let damaged = case.replace("[creepage]", "[damage]\n[creepage]");
        place.write("both.toml", damaged);
        place.run(&["solve", "both.toml"]).refused(&["[contact] slip with [damage]"]);
        let curve = ["curve", "case.toml", "--vary", "xi", "--from", "0", "--to", "1"];
        place.write("case.toml", &case);
        place.run(&curve).done();
        let narrow = "slip = { x = [0.0], y = [-1e-3, 1e-3], longitudinal = [1e-3, 2e-3], lateral = [0.0, 0.0] }";
        let narrow = narrow.replace("x = [0.0]", "x = [0.0, 0.0]");
        let narrow_case = case.replace("slip = \"slip.csv\"", &narrow);
        place.write("case.toml", &narrow_case);
        let told = place.run(&["solve", "case.toml"]);
        assert!(told.stderr.contains("beyond the points of [contact] slip along y"), "{told:?}");
        assert!(!told.stderr.contains("along x"), "{told:?}");
        let (head, tail) =
            (narrow_case.find("[creepage]").unwrap(), narrow_case.find("[solve]").unwrap());
        let rolls = format!("{}{}", &narrow_case[..head], &narrow_case[tail..]);
        place.write("rolls.toml", rolls.replace("\"fast\"", "[10, 10]"));
        place.write("history.csv", "distance,longitudinal\n0.001,1e-3\n");
        let told = place.run(&["roll", "rolls.toml", "--history", "history.csv"]);
        assert!(told.stderr.contains("beyond the points of [contact] slip along y"), "{told:?}");
    }
}

#[test]
fn what_is_wrong_with_a_slip_is_told() {
    let [[_, ellipse], [_, areas]] = cases();
    for case in [&ellipse, &areas] {
        let place = Place::new();
        place.write("case.toml", case);
        let solve = || place.run(&["solve", "case.toml"]);
        solve().refused(&["[contact] slip = \"slip.csv\"", "cannot read it"]);
        place.write("slip.csv", "x,y,longitudinal\n0,0,0\n");
        solve().refused(&["column lateral is missing"]);
        place.write("slip.csv", "x,y,longitudinal,lateral\n0,0,0,0\n1e-3,1e-3,0,0\n");
        solve().refused(&["no point at"]);
        place.write("slip.csv", "x,y,longitudinal,lateral\n0,0,fast,0\n");
        solve().refused(&["line 2: longitudinal"]);
        place.write("slip.csv", slips(|_, _| [1e-3, 0.0]));
        for theory in ["fastsim", "saturated"] {
            let other = place.run(&["solve", "case.toml", "--theory", theory]);
            assert_eq!(other.code, Some(2), "{}", other.stderr);
            assert!(other.stderr.contains("exact, without coupling"), "{}", other.stderr);
        }
        // The file is read, and not written over.
        let over = place.run(&["solve", "case.toml", "--out", "."]);
        assert_eq!(over.code, Some(0), "{}", over.stderr);
        assert_eq!(place.read("slip.csv"), slips(|_, _| [1e-3, 0.0]));
    }
    let place = Place::new();
    place.write("case.toml", &ellipse);
    place.write("slip.csv", slips(|_, _| [1e-3, 0.0]));
    let rows = place.run_on(&["batch", "--case", "case.toml"], "longitudinal\n0.01\n");
    rows.refused(&["slip is for one case at a time"]);
}
