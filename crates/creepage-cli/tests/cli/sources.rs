//! No result is written over a file that was read.

use std::fs;

use crate::gap;
use crate::place::{CASE, Place};

/// Files that commands here read, some of them by the names that results have.
fn place() -> Place {
    let place = Place::new();
    place.write(
        "case.toml",
        CASE.replace("theory = \"variational\"\ndegree = 3", "theory = \"linear\""),
    );
    let section = "section = 'points.csv'\nradius_rolling = 0.46";
    let gap = gap::CASE.replace(gap::POLYNOMIAL, section);
    place.write("gap.toml", gap.replace("resolution = \"fast\"", "theory = 'linear'"));
    let section = (-20..=20).map(|k| f64::from(k) * 1e-3).map(|y| format!("{y},{}\n", y * y / 0.6));
    place.write("points.csv", format!("y,gap\n{}", section.collect::<String>()));
    place.write("stresses.csv", "x,y,z\n0,0,1e-3\n");
    let pressed = CASE.split("[creepage]").next().unwrap();
    place.write("roll.toml", format!("{pressed}[solve]\nresolution = [8, 8]\n"));
    place.write("history.csv", "distance,xi\n0.001,0.1\n");
    place.write("loads.csv", "normal_force\n80e3\n");
    let creepage = "[creepage]\nupsilon = { from = 0.1, step = 0.1, to = 0.2 }\nchi = [0]\n";
    place.write("sweep.csv", format!("[contact]\na_over_b = 1\npoisson = 0.28\n{creepage}"));
    place
}

#[test]
fn a_result_spares_what_was_read() {
    let commands = [
        ("solve gap.toml --out .", "points.csv"),
        ("stresses case.toml --points stresses.csv --out .", "stresses.csv"),
        ("roll roll.toml --history history.csv --out .", "history.csv"),
        ("batch --case case.toml --in loads.csv --out ./case.toml", "case.toml"),
        ("sweep sweep.csv --out sweep.csv", "sweep.csv"),
    ];
    for (command, spared) in commands {
        let place = place();
        let (files, before) = (place.files(), place.read(spared));
        let words: Vec<_> = command.split(' ').collect();
        place.run(&words).refused(&[spared, "would be written over what was read"]);
        assert_eq!((place.files(), place.read(spared)), (files, before), "{command}");
        // The same elsewhere.
        fs::create_dir(place.path("out")).unwrap();
        let (out, kept) = words.split_last().unwrap();
        let elsewhere = if *out == "." { "out".into() } else { format!("out/{spared}") };
        place.run(&[kept, &[&elsewhere[..]]].concat()).done();
        assert!(place.files_in("out").contains(&spared.to_owned()), "{command}");
    }
}

#[cfg(unix)]
#[test]
fn a_link_to_what_was_read_is_no_other_file() {
    let place = place();
    fs::create_dir(place.path("out")).unwrap();
    std::os::unix::fs::symlink("../points.csv", place.path("out/points.csv")).unwrap();
    place
        .run(&["solve", "gap.toml", "--out", "out"])
        .refused(&["points.csv would be written over"]);
    assert!(place.read("points.csv").starts_with("y,gap"));
}
