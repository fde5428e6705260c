//! Every case file that is written is one by the readers of case files: what was read is solved.

#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests

use std::fs;
use std::path::Path;

use creepage_import::{Imported, Written, import};
use creepage_study::{AnyCaseFile, RollFile, StaticsFile, WheelsetFile};

/// Words of a case of module 3 before its kinematics.
fn digits(first: &str, second: &str, third: &str) -> String {
    format!(
        " 3 MODULE\n {first} PBTNFS\n {second} VLDCMZE\n {third} HGIAOWR\n 50 50 30 1 1e-6 settings\n"
    )
}

const ROLLING: &str = " 0.0 0.2 20000. CHI, DQ, VELOC\n";
const STEEL: &str = " .28 .28 82000. 82000. material\n";
const HEATED: &str = " 20. 450. 50e-3 7.85e-6 body 1\n 150. 450. 50e-3 7.85e-6 body 2\n";
const GRID: &str = " 1 IPOTCN\n 9 9 -0.9 -0.9 0.2 0.2 grid\n";
const SPHERE: &str = " 1 1 kinds\n .005 .0 .005 .0 .0 .0 shape\n";
const COULOMB: &str = " 0.3 0.3 friction\n";
const LOAD: &str = " 1000. .002 .001 .0002 load\n";

/// A file of one case.
fn read(text: &str) -> Imported {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("own.inp");
    fs::write(&path, text).unwrap();
    import(&path, &place.path().join("out")).unwrap()
}

/// Reads what was written by the command's own reader; the files stand in `place`.
fn reads(written: &Written, place: &Path) {
    for file in &written.files {
        fs::write(place.join(&file.name), &file.contents).unwrap();
    }
    let text = String::from_utf8(written.files[0].contents.clone()).unwrap();
    let command = written.command.split(' ').nth(1).unwrap();
    let problem = match command {
        "solve" => {
            AnyCaseFile::read(&text).and_then(|file| file.case(place)).err().map(|e| e.to_string())
        }
        "hertz" => AnyCaseFile::read(&text).err().map(|e| e.to_string()),
        "roll" => RollFile::read(&text).err().map(|e| e.to_string()),
        "statics" => StaticsFile::read(&text).err().map(|e| e.to_string()),
        "wheelset" => WheelsetFile::read(&text).err().map(|e| e.to_string()),
        other => panic!("creepage {other} is no command that was known here"),
    };
    assert_eq!(problem, None, "{text}");
}

/// The text of the only case, which is read back.
fn text_of(input: &str) -> String {
    let imported = read(input);
    assert_eq!(imported.cases.len(), 1);
    let place = tempfile::tempdir().unwrap();
    let written = imported.cases[0].written.as_ref().unwrap();
    reads(written, place.path());
    String::from_utf8(written.files[0].contents.clone()).unwrap()
}

#[test]
fn every_kind_of_motion_law_and_shape_is_read_back() {
    let motions =
        [("203100", LOAD), ("203110", " 1000. -.5 .001 .0002\n"), ("203120", " 1000. -.5 .2 .0\n")];
    let laws = [
        ("0", COULOMB),
        ("2", " .2 .1 500. .0 1. linear\n .0 1. memory\n"),
        ("3", " .2 .1 500. .0 1. rational\n .01 1. memory\n"),
        ("4", " .2 .1 500. .0 1. exponential\n .0 1. memory\n"),
    ];
    let shapes = [
        SPHERE,
        " 1 1 kinds\n .005 .001 .005 .0 .0 .0 turned\n",
        " 2 1 kinds\n 3 0. 100. -.9 .9 circular\n .01 .0 .01\n",
    ];
    for (first, load) in motions {
        for (law, friction) in laws {
            for shape in shapes {
                let head = digits(first, &format!("{law}22020"), "0000341");
                let input = head + load + friction + ROLLING + STEEL + GRID + shape;
                text_of(&input);
            }
        }
    }
    for grid in [
        "-1 kind\n 9 9 .005 .003 1.2\n",
        "-2 kind\n 9 9 .005 1.5 1.2\n",
        "-3 kind\n 9 9 1. 2. 1.2\n",
    ] {
        text_of(
            &(digits("203100", "022020", "0000341")
                + LOAD
                + COULOMB
                + ROLLING
                + STEEL
                + " "
                + grid),
        );
    }
}

/// The units of heat: W/(mm K) and kg/mm3; the upper body is the first.
#[test]
fn heat_and_friction_by_temperature() {
    let head = digits("203100", "022020", "3000341");
    let text = text_of(&(head + LOAD + COULOMB + ROLLING + STEEL + HEATED + GRID + SPHERE));
    let body =
        "{ conductivity = 50.0, density = 7850.0, specific_heat = 450.0, bulk_temperature = ";
    for line in [format!("upper = {body}20.0 }}"), format!("lower = {body}150.0 }}")] {
        assert!(text.lines().any(|other| other == line), "{line}\n{text}");
    }
    let by_heat = " .3 100. -.18 30. FREF, TREF, DFHEAT, DTHEAT\n .0 1. memory\n";
    let head = digits("203100", "622020", "3000341");
    let text = text_of(&(head + LOAD + by_heat + ROLLING + STEEL + HEATED + GRID + SPHERE));
    let law = "friction = { cold = 0.3, hot = 0.12, temperatures = [100.0, 130.0] }";
    assert!(text.lines().any(|line| line == law), "{text}");
    // What is left out stays: the second case has the heat of the first.
    let first = digits("203100", "022020", "3000340")
        + LOAD
        + COULOMB
        + ROLLING
        + STEEL
        + HEATED
        + GRID
        + SPHERE;
    let second = " 203100 PBTNFS\n 100000 VLDCMZE\n 1100341 HGIAOWR\n 2000. .003 .0 .0\n";
    let imported = read(&(first + second));
    let written = imported.cases[1].written.as_ref().unwrap();
    assert!(String::from_utf8(written.files[0].contents.clone()).unwrap().contains("[heat]"));
    // At rest there is none, and that is told.
    let imported = read(
        &(digits("200100", "022020", "3000341") + LOAD + COULOMB + STEEL + HEATED + GRID + SPHERE),
    );
    assert!(imported.cases[0].notes.iter().any(|note| note.contains("temperature (H)")));
}

/// Comments, blank lines, values over several lines, tabs and commas say the same.
#[test]
fn how_a_file_is_set_out_does_not_matter() {
    let plain =
        digits("203100", "022020", "0000341") + LOAD + COULOMB + ROLLING + STEEL + GRID + SPHERE;
    let commented = plain.replace('\n', "  % a comment 1 2 3\n\n% a line of it\n   \n");
    let broken = plain
        .replace(" .28 .28 82000. 82000. material", " .28,\t.28 % two\n 2*82000.0d0")
        .replace(" .005 .0 .005 .0 .0 .0 shape", " .005 .0\n .5-02\n 3*0.");
    let windows = plain.replace('\n', "\r\n");
    let expected = text_of(&plain);
    for other in [commented, broken, windows] {
        assert_eq!(text_of(&other), expected);
    }
}

const WHEEL: &str = " 1 MODULE\n 0203100 CPBTNFS\n 1022033 VLDCMZE\n 3001321 HGIAOWR\n 99 99 30 1 1e-5 settings\n 2 NVF\n \
                     -20d .2 .2\n -10d .3 .3\n .28 .28 82000. 82000. material\n 20. 450. 50e-3 7.85e-6 rail\n \
                     80. 450. 50e-3 7.85e-6 wheel\n .2 .2 1. 90d 8. 4. grid\n 14. 0 1435. 0.025 track\n \
                     'rail.txt' 0 1. 0. 0 1 rail\n 0 150d 30d 6d 2. kinks\n 1. 2. .003 4. 5. .006 deviation\n \
                     1360. -70. 460. wheelset\n 'wheel.txt' 0 1. 1. wheel\n 0. 3. 10000. -.0001 .002 0. position\n \
                     2000. 1. 0. 0. 0. -4.35 velocity\n";

/// A wheel's temperature is that of body 2; its profile is smoothed by the spline's weight.
#[test]
fn a_wheel_on_a_rail_is_read_back() {
    let place = tempfile::tempdir().unwrap();
    fs::write(place.path().join("rail.txt"), "rail").unwrap();
    let points: Vec<_> = (0..40).map(|i| format!("{} 0.0", 0.25 * f64::from(i))).collect();
    fs::write(place.path().join("wheel.txt"), points.join("\n")).unwrap();
    fs::write(place.path().join("own.inp"), WHEEL).unwrap();
    let imported = import(&place.path().join("own.inp"), &place.path().join("out")).unwrap();
    let written = imported.cases[0].written.as_ref().unwrap();
    let to = tempfile::tempdir().unwrap();
    reads(written, to.path());
    let text = String::from_utf8(written.files[0].contents.clone()).unwrap();
    let upper = "upper = { conductivity = 50.0, density = 7850.0, specific_heat = 450.0, bulk_temperature = 80.0 }";
    assert!(text.lines().any(|line| line == upper), "{text}");
    // 1 mm3, whatever the distance of points.
    assert!(text.contains("smooth_weight = 1e-9 }"), "{text}");
}

/// What a broken file still gives is read back too.
#[test]
fn what_broken_files_give_is_read_back() {
    let heat = digits("203100", "622020", "3000341")
        + LOAD
        + " .3 100. -.18 30. FREF\n .0 1. memory\n"
        + ROLLING
        + STEEL
        + HEATED
        + GRID
        + SPHERE;
    let line = digits("203100", "022020", "0000341")
        + LOAD
        + COULOMB
        + ROLLING
        + STEEL
        + " 1 kind\n 9 1 -.9 0. .2 1.\n"
        + SPHERE;
    let whole = heat + &line;
    let words: Vec<&str> = whole.split(' ').collect();
    let (place, mut read_back) = (tempfile::tempdir().unwrap(), 0);
    for at in 0..words.len() {
        for change in ["-1.", "0.", "2.5", "7", "x"] {
            let mut words = words.clone();
            words[at] = change;
            let path = place.path().join("own.inp");
            fs::write(&path, words.join(" ")).unwrap();
            let Ok(imported) = import(&path, &place.path().join("out")) else { continue };
            for case in imported.cases {
                let Ok(written) = case.written else { continue };
                let text = String::from_utf8(written.files[0].contents.clone()).unwrap();
                // The form is always right; a number out of range is the case's own.
                let problem = match written.command.split(' ').nth(1).unwrap() {
                    "solve" | "hertz" => AnyCaseFile::read(&text).err().map(|e| e.to_string()),
                    "roll" => RollFile::read(&text).err().map(|e| e.to_string()),
                    "statics" => StaticsFile::read(&text).err().map(|e| e.to_string()),
                    other => panic!("{other}"),
                };
                assert_eq!(problem, None, "{text}");
                read_back += 1;
            }
        }
    }
    assert!(read_back > 100, "{read_back}");
}
