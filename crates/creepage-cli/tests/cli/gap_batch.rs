//! `batch` over contacts of any shape.

use crate::place::{Place, json};

const CASE: &str = r#"
upper = { shear_modulus = 82e9, poisson = 0.28 }
lower = { shear_modulus = 82e9, poisson = 0.28 }
gap = { polynomial = [[2, 0, 1.0869565217391304], [0, 4, 5e4]] }
contact = { normal_force = 40e3, friction = 0.3 }
creepage = { longitudinal = 1e-3, lateral = 5e-4, spin = 0.1, speed = 20.0 }
solve = { theory = "fastsim" }
"#;

/// The table of `rows.csv`, of which some rows are no case.
fn answered(place: &Place) -> Vec<Vec<String>> {
    let ran = place.run(&["batch", "--case", "case.toml", "--in", "rows.csv"]);
    assert_eq!(ran.code, Some(3), "{}", ran.stderr);
    ran.stdout.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// Each row has the numbers of `solve` to the last bit; what is no case says why.
#[test]
fn a_row_is_the_case_with_its_values() {
    let place = Place::new();
    place.write("case.toml", CASE);
    place.write("flat.csv", "y,gap\n-0.02,0.0004\n-0.01,0.0001\n0,0\n0.01,0.0001\n0.02,0.0004\n");
    place.write(
        "rows.csv",
        "name,approach,section,radius_rolling,lateral\n\
         one,2e-5,flat.csv,0.5,1e-3\n\
         two,nan,flat.csv,0.5,0\n\
         three,2e-5,none.csv,0.5,0\n\
         four,2e-5,flat.csv,,0\n",
    );
    let table = answered(&place);
    let column = |name: &str| table[0].iter().position(|known| known == name).unwrap();
    let (load, force) = (column("normal_force_n"), column("lateral_n"));
    let one = CASE
        .replace(
            "polynomial = [[2, 0, 1.0869565217391304], [0, 4, 5e4]]",
            "section = \"flat.csv\", radius_rolling = 0.5",
        )
        .replace("normal_force = 40e3", "approach = 2e-5")
        .replace("lateral = 5e-4", "lateral = 1e-3");
    place.write("one.toml", &one);
    let report = json(&place.run(&["solve", "one.toml", "--json"]).done());
    let number = |at: usize| table[1][at].parse::<f64>().unwrap();
    assert_eq!(Some(number(load)), report["contact"]["normal_force_n"].as_f64());
    assert_eq!(Some(number(force)), report["lower_body"]["lateral_n"].as_f64());
    assert!(number(column("frictional_power_w")) > 0.0);
    let (status, message) = (column("status"), column("message"));
    for (row, words) in [(2, "approach = NaN"), (3, "none.csv"), (4, "radius_rolling is empty")] {
        assert_eq!(table[row][status], "invalid");
        assert!(table[row][message..].join(",").contains(words), "{:?}", table[row]);
    }
}

/// The full theory has error bars, and finds wanted forces row by row.
#[test]
fn forces_that_are_wanted_differ_too() {
    let place = Place::new();
    let wants = CASE
        .replace("longitudinal = 1e-3, ", "")
        .replace("theory = \"fastsim\"", "theory = \"exact\", resolution = [10, 10]");
    place.write("case.toml", &wants);
    place.write("rows.csv", "longitudinal_force\n2e3\n5e3\n5e5\n");
    let table = answered(&place);
    let column = |name: &str| table[0].iter().position(|known| known == name).unwrap();
    let number = |row: usize, name: &str| table[row][column(name)].parse::<f64>().unwrap();
    for (row, wanted) in [(1, 2e3), (2, 5e3)] {
        // Found to 1e-6 of mu N or better.
        assert!((number(row, "longitudinal_n") - wanted).abs() < 0.02);
        assert!(number(row, "longitudinal_error_n") > 0.0);
    }
    assert!(number(1, "longitudinal_creepage") < number(2, "longitudinal_creepage"));
    assert_eq!(table[3][column("status")], "invalid");
}

#[test]
fn columns_that_mean_nothing_here_are_refused() {
    let place = Place::new();
    place.write("case.toml", CASE);
    place.write("rows.csv", "upper_radius_rolling\n0.46\n");
    place
        .run(&["batch", "--case", "case.toml", "--in", "rows.csv"])
        .refused(&["none of the columns", "longitudinal_force"]);
    place.write("rows.csv", "lateral,lateral_n\n0,0\n");
    place
        .run(&["batch", "--case", "case.toml", "--in", "rows.csv"])
        .refused(&["lateral_n is there already"]);
    place.write("rows.csv", "lateral\n0\n");
    place
        .run(&["batch", "--case", "case.toml", "--in", "rows.csv", "--theory", "polach"])
        .refused(&["needs an ellipse"]);
}
