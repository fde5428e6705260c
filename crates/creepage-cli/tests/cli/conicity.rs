//! `creepage conicity` on good and bad input.

use std::fs;
use std::path::Path;

use crate::place::Place;

/// Wheels and rails A of EN 15302.
fn standard() -> String {
    example("en15302-a.toml")
}

fn example(name: &str) -> String {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/wheelset");
    fs::read_to_string(examples.join(name)).unwrap()
}

/// The two columns below the heading.
fn rows(csv: &str, heading: &str) -> Vec<[f64; 2]> {
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some(heading));
    let number = |text: &str| text.parse().unwrap();
    lines.map(|line| line.split_once(',').map(|(x, y)| [number(x), number(y)]).unwrap()).collect()
}

#[test]
fn both_examples_have_a_conicity_for_every_amplitude() {
    let place = Place::new();
    for name in ["en15302-a.toml", "s1002-on-uic60.toml"] {
        place.write("case.toml", example(name));
        let csv = place.run(&["conicity", "case.toml"]).done();
        let rows = rows(&csv, "amplitude_m,conicity");
        assert_eq!((rows.len(), rows[0][0], rows[65][0]), (66, 0.001, 0.0075));
        assert!(rows.iter().all(|[_, conicity]| (0.0..1.0).contains(conicity)), "{name}: {csv}");
    }
}

/// Like wheels on like rails: the difference changes its sign with the side.
#[test]
fn the_radius_difference_is_odd_and_rises_to_the_right() {
    let place = Place::new();
    place.write("case.toml", standard());
    let csv = place.run(&["conicity", "case.toml", "--radius-difference"]).done();
    let rows = rows(&csv, "y_m,radius_difference_m");
    let mirrored = rows.iter().rev();
    for (row, image) in rows.iter().zip(mirrored) {
        // Printed to 1e-12 m; the place of contact is found to some 1e-9 m.
        assert!((row[0] + image[0]).abs() < 1e-9 && (row[1] + image[1]).abs() < 1e-8, "{row:?}");
    }
    let at = |y: f64| rows.iter().find(|row| (row[0] - y).abs() < 1e-9).unwrap()[1];
    assert!(at(0.003) > at(0.001) && at(0.001) > 0.0);
}

#[track_caller]
fn refused(old: &str, new: &str, parts: &[&str]) {
    assert!(standard().contains(old), "{old} is not in the case");
    let place = Place::new();
    place.write("case.toml", standard().replacen(old, new, 1));
    place.run(&["conicity", "case.toml"]).refused(parts);
}

#[test]
fn what_is_wrong_is_named() {
    refused("back_to_back", "back_to_bak", &["[wheelset]", "did you mean `back_to_back`?"]);
    refused("[wheel]", "[wheels]", &["`wheels` in the file", "did you mean"]);
    refused("1.360", "-1.360", &["[wheelset] back_to_back = -1.36"]);
    refused("0.46", "0.0", &["[wheel] radius = 0 "]);
    refused("0.750", "nan", &["[track] rail_position = NaN", "positive, at most 10 m"]);
    refused("rail_position = 0.750", "gauge = 1.435", &["[track] gauge_height is missing"]);
    refused("EN15302-A", "EN15302-X", &["[wheel] profile = \"EN15302-X\"", "S1002"]);
    refused("EN15302-rail-A", "S1002", &["[rail] profile = \"S1002\" is that of a wheel"]);
    refused("1.360", "1.360\nz = 0\nwheel_load = 1", &["[wheelset] wheel_load", "exclude"]);
    refused("1.360", "1.360\nroll = \"fre\"", &["number or \"free\""]);
}
