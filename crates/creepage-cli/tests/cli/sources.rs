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
        ("batch --case case.toml --in loads.csv --out loads.csv", "loads.csv"),
        ("batch --case gap.toml --in loads.csv --out ./loads.csv", "loads.csv"),
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

/// A case file that has the name of a result, in the directory of the results.
#[test]
fn a_case_with_the_name_of_a_result_is_spared() {
    let example = |name: &str| {
        let path =
            std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
        fs::read_to_string(path).unwrap()
    };
    let case = CASE.replace("theory = \"variational\"\ndegree = 3", "theory = \"linear\"");
    let wheelset = example("wheelset/s1002-on-uic60.toml");
    for (command, name, text) in [
        ("solve points.csv --out .", "points.csv", &case),
        ("solve ./contact.svg --out ../k", "contact.svg", &case),
        ("stresses stresses.csv --out .", "stresses.csv", &case),
        ("curve curve.svg --out .", "curve.svg", &case),
        ("statics report.json --out .", "report.json", &example("statics/bolt-twist.toml")),
        ("wheelset report.json --out .", "report.json", &wheelset),
        ("conicity conicity.csv --out .", "conicity.csv", &wheelset),
    ] {
        let place = Place::new();
        fs::create_dir(place.path("k")).unwrap();
        let name = format!("k/{name}");
        place.write(&name, text);
        let words: Vec<_> = command.split(' ').collect();
        let mut run = place.command(&words);
        let ran = run.current_dir(place.path("k")).output().unwrap();
        let said = String::from_utf8(ran.stderr).unwrap();
        assert_eq!(ran.status.code(), Some(2), "{command}: {said}");
        assert!(said.contains("would be written over what was read"), "{command}: {said}");
        assert_eq!((place.files_in("k").len(), place.read(&name)), (1, text.clone()), "{command}");
    }
}

#[test]
fn two_cases_of_one_name_are_refused_before_any_is_solved() {
    let place = place();
    for directory in ["x", "y", "one"] {
        fs::create_dir(place.path(directory)).unwrap();
    }
    for name in ["x/a.toml", "y/a.toml", "one/points.csv"] {
        place.write(name, place.read("case.toml"));
    }
    let ran = place.run(&["solve", "x/a.toml", "case.toml", "y/a.toml", "--out", "out"]);
    assert_eq!(ran.stdout, "");
    ran.refused(&["x/a.toml and y/a.toml would both write to out/a"]);
    assert!(!place.path("out").exists());
    // The results of the first have the name of the second.
    place.write("one.toml", place.read("case.toml"));
    let ran = place.run(&["solve", "one.toml", "one/points.csv", "--out", "."]);
    // The head of its report is printed before it is solved.
    assert_eq!((ran.code, &ran.stdout[..]), (Some(2), "== one.toml\n"));
    assert!(ran.stderr.contains("one/points.csv would be written over"), "{}", ran.stderr);
    assert_eq!(place.read("one/points.csv"), place.read("case.toml"));
    // Without files they follow each other.
    place.run(&["solve", "x/a.toml", "y/a.toml"]).done();
}

/// Files that stand where a command keeps its work so far.
#[test]
fn working_files_of_others_stay() {
    for (command, name) in [
        ("sweep sweep.csv --out out.csv", "out.csv.journal"),
        ("roll roll.toml --history history.csv --out out", "out/history.csv.partial"),
        ("roll roll.toml --history history.csv --out out", "out/history.state"),
    ] {
        let place = place();
        fs::create_dir(place.path("out")).unwrap();
        place.write(name, "my own notes\n");
        let words: Vec<_> = command.split(' ').collect();
        place.run(&words).refused(&[name, "another file stands where the work so far is kept"]);
        assert_eq!(place.read(name), "my own notes\n");
        fs::remove_file(place.path(name)).unwrap();
        place.run(&words).done();
    }
}

#[test]
fn a_batch_spares_the_gaps_that_its_rows_name() {
    let place = place();
    place.write("rows.csv", "section,normal_force\npoints.csv,40e3\n");
    let before = place.read("points.csv");
    let batch = ["batch", "--case", "gap.toml", "--in", "rows.csv", "--out"];
    place
        .run(&[&batch[..], &["points.csv"]].concat())
        .refused(&["points.csv would be written over"]);
    assert_eq!(place.read("points.csv"), before);
    place.run(&[&batch[..], &["out.csv"]].concat()).done();
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
    std::os::unix::fs::symlink("loads.csv", place.path("link.csv")).unwrap();
    for (input, out) in [("loads.csv", "link.csv"), ("link.csv", "loads.csv")] {
        let batch = ["batch", "--case", "case.toml", "--in", input, "--out", out];
        place.run(&batch).refused(&[out, "would be written over what was read"]);
    }
    assert_eq!(place.read("loads.csv"), "normal_force\n80e3\n");
}
