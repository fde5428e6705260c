//! `creepage profile` on good and bad input.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::place::{Place, json};

/// A sample of the reader's own tests.
fn sample(name: &str) -> Vec<u8> {
    let samples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../creepage-rail/samples");
    fs::read(samples.join(name)).unwrap()
}

fn with(names: &[&str]) -> Place {
    let place = Place::new();
    for name in names {
        place.write(name, sample(name));
    }
    place
}

#[test]
fn what_a_file_holds_is_said_in_words_and_in_json() {
    let place = with(&["s1002.prw", "worn_rail.ban"]);
    let text = place.run(&["profile", "s1002.prw", "worn_rail.ban"]).done();
    assert!(text.contains("s1002.prw: wheel, Simpack, ") && text.contains("zig-zag"), "{text}");
    let printed = place.run(&["profile", "--json", "s1002.prw", "worn_rail.ban"]).done();
    let facts = json(&printed);
    assert_eq!((&facts[0]["role"], &facts[1]["role"]), (&"wheel".into(), &"rail".into()));
    assert_eq!(facts[1]["format"], "MiniProf");
    // 130 mm wide, and down and up the flange.
    let length = facts[0]["length_m"].as_f64().unwrap();
    assert!((0.14..0.17).contains(&length), "{length}");
}

/// A measured profile that is smoothed into its own folder, and two of one name: nothing is lost.
#[test]
fn no_profile_is_written_over_another() {
    let place = with(&["s1002.prw"]);
    let measured = place.read("s1002.prw");
    let smoothed = ["profile", "s1002.prw", "--convert", "simpack", "--smooth", "0.006"];
    place
        .run(&[&smoothed[..], &["--out", "."]].concat())
        .refused(&["s1002.prw would be written over", "--out"]);
    assert_eq!(place.read("s1002.prw"), measured);
    assert_eq!(place.files(), ["s1002.prw"]);
    fs::create_dir(place.path("other")).unwrap();
    place.write("other/s1002.prw", measured);
    let twice = ["profile", "s1002.prw", "other/s1002.prw", "--out", "out"];
    place.run(&twice).refused(&["s1002.svg", "twice"]);
    assert!(place.files().iter().all(|name| name != "out"), "{:?}", place.files());
}

/// Pictured and converted as files are, and not with options for reading one.
#[test]
fn standard_profiles_go_by_their_names() {
    let place = Place::new();
    let text = place.run(&["profile", "S1002", "cone-1:20"]).done();
    assert!(
        text.contains("S1002: wheel, standard, ") && text.contains("cone-1:20: wheel"),
        "{text}"
    );
    let convert = ["profile", "--convert", "columns", "--out", "out", "cone-1:20", "UIC60"];
    place.run(&convert).done();
    let names = ["UIC60.png", "UIC60.svg", "UIC60.txt", "cone-1-20.png", "cone-1-20.svg"];
    let files = place.files_in("out");
    assert!(names.iter().all(|name| files.contains(&(*name).to_owned())), "{files:?}");
    let length =
        |arguments: &[&str]| json(&place.run(arguments).done())[0]["length_m"].as_f64().unwrap();
    let standard = length(&["profile", "--json", "UIC60"]);
    let written = length(&["profile", "--json", "out/UIC60.txt", "--role", "rail"]);
    // Chords of half a millimetre on radii from 13 mm on are shorter by 6e-5 of their length at most.
    assert!((written / standard - 1.0).abs() < 6e-5, "{written} {standard}");
    place.run(&["profile", "S1002", "--unit", "0.001"]).refused(&["S1002", "--unit"]);
    place.run(&["profile", "S1003"]).refused(&["S1003", "S1002", "UIC60"]);
}

/// Out to another format with a picture, and in again: the same points.
#[test]
fn conversions_are_read_back() {
    let place = with(&["uic60.rail"]);
    for (format, name, more) in [
        ("simpack", "uic60.prr", &[][..]),
        ("miniprof", "uic60.ban", &[]),
        ("vampire", "uic60.rai", &["--side", "left"]),
        ("gensys", "uic60.rail", &[]),
        ("columns", "uic60.txt", &["--role", "rail"]),
    ] {
        place.run(&["profile", "uic60.rail", "--convert", format, "--out", "out"]).done();
        let file = format!("out/{name}");
        let printed = place.run(&[&["profile", "--json", &file], more].concat()).done();
        let length = |printed: &str| json(printed)[0]["length_m"].as_f64().unwrap();
        let given = place.run(&["profile", "--json", "uic60.rail"]).done();
        assert!((length(&printed) - length(&given)).abs() < 1e-7, "{format}");
    }
    let files = place.files_in("out");
    assert!(files.contains(&"uic60.svg".to_owned()) && files.contains(&"uic60.png".to_owned()));
}

#[test]
fn what_the_file_does_not_say_can_be_said() {
    let place = with(&["s1002.txt", "s1002.whe"]);
    place.write("arc.txt", "-30 3\n-15 .75\n0 0\n15 .75\n30 3\n");
    place.run(&["profile", "arc.txt"]).refused(&["arc.txt", "a wheel or a rail", "--role"]);
    let shown = place.run(&["profile", "s1002.txt"]).done();
    assert!(shown.contains("found by its shape: a wheel"), "{shown}");
    place.run(&["profile", "s1002.txt", "--role", "rail"]).refused(&["says rail", "of a wheel"]);
    place.run(&["profile", "s1002.whe"]).refused(&["which side of the two"]);
    let text = place.run(&["profile", "s1002.txt", "--role", "wheel", "--unit", "0.001"]).done();
    assert!(!text.contains("unit found"), "{text}");
    let smooth = ["profile", "s1002.txt", "--role", "wheel", "--smooth", "0.003"];
    assert!(place.run(&smooth).done().contains("waves of 3.00 mm halved"));
    let wrong = ["profile", "s1002.txt", "--role", "wheel", "--unit", "1.0"];
    place.run(&wrong).refused(&["line 2", "m long"]);
    let negative = ["profile", "s1002.txt", "--role", "wheel", "--smooth=-1"];
    place.run(&negative).refused(&["smoothing wavelength = -1 m"]);
    for value in ["-1", "0", "nan"] {
        let unit = ["profile", "s1002.txt", "--role", "wheel", "--unit", value];
        place.run(&unit).refused(&["--unit must be positive and finite, got"]);
    }
    let apart = ["profile", "s1002.txt", "--role", "wheel", "--smooth", "-1"];
    place.run(&apart).refused(&["smoothing wavelength = -1 m"]);
    let survey = ["profile", "--survey", "*.txt", "--out", "s.csv", "--rail", "UIC60"];
    place.run(&[&survey[..], &["--gauge", "-1"]].concat()).refused(&["gauge = -1: must be above"]);
    // z is said to point up, and so the flange to lie above the tread.
    let over = ["profile", "s1002.txt", "--role", "wheel", "--z", "up", "--y", "field-side"];
    place.run(&over).refused(&["z = up contradicts the shape", "flange", "--z"]);
    place.run(&["profile", "no-such.prw"]).refused(&["cannot read no-such.prw"]);
}

/// A bad file among good ones keeps files from being written, not the words on the others.
#[test]
fn a_bad_file_does_not_silence_the_others() {
    let place = with(&["s1002.prw", "uic60.prr"]);
    place.write("bad.prw", "spline.begin\npoint.begin\n1 2\n3 x\npoint.end\n");
    let ran =
        place.run(&["profile", "s1002.prw", "bad.prw", "none.prw", "uic60.prr", "--out", "out"]);
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(ran.stdout.contains("s1002.prw: wheel") && ran.stdout.contains("uic60.prr: rail"));
    for words in ["bad.prw: line 4: column 2 is not a number", "cannot read none.prw"] {
        assert_eq!(ran.stderr.matches(words).count(), 1, "{}", ran.stderr);
    }
    assert_eq!(place.files(), ["bad.prw", "s1002.prw", "uic60.prr"]);
    let ran = place.run(&["profile", "--json", "bad.prw", "uic60.prr"]);
    let facts = json(&ran.stdout);
    assert_eq!((ran.code, &facts[1]["role"]), (Some(2), &"rail".into()));
    assert!(facts[0]["error"].as_str().unwrap().contains("line 4"), "{facts}");
}

/// Whatever stands beside the profile may be somebody's measurement.
#[test]
fn a_converted_profile_replaces_no_file() {
    let place = with(&["s1002.prw"]);
    place.write("s1002.txt", "somebody's own\n");
    let convert = ["profile", "s1002.prw", "--convert", "columns", "--out"];
    let into = |directory| [&convert[..], &[directory]].concat();
    place.run(&into(".")).refused(&["s1002.txt is there already", "--out"]);
    assert_eq!(place.read("s1002.txt"), "somebody's own\n");
    assert_eq!(place.files(), ["s1002.prw", "s1002.txt"]);
    // The same again writes the same.
    place.run(&into("out")).done();
    place.run(&into("out")).done();
}

#[test]
fn standard_profiles_are_listed_with_their_sources() {
    let listed = Place::new().run(&["profile", "--list"]).done();
    assert!(
        listed.contains("S1002") && listed.contains("EN 13674-1") && listed.lines().count() > 10
    );
}

/// A survey has a row for every file, bad ones with the cause, and goes on where it was.
#[test]
fn a_survey_measures_every_file() {
    let place = with(&["s1002.prw", "worn_rail.ban"]);
    place.write("bad.prw", "nothing\n");
    let survey = |out: &str| {
        let args =
            ["profile", "--survey", "*.prw", "*.ban", "--rail", "UIC60", "--reference", "S1002"];
        place.run(&[&args[..], &["--out", out]].concat())
    };
    assert_eq!(survey("fleet.csv").code, Some(3));
    let text = place.read("fleet.csv");
    let rows: Vec<&str> = text.lines().collect();
    assert_eq!(rows.len(), 4, "{text}");
    let wheel = rows.iter().find(|row| row.contains("s1002.prw")).unwrap();
    let cells: Vec<&str> = wheel.split(',').collect();
    let number = |k: usize| cells[k].parse::<f64>().unwrap();
    assert!((number(4) - 0.028).abs() < 2e-4 && (number(5) - 0.0325).abs() < 2e-4, "{wheel}");
    assert!(number(9) > 0.0 && number(9) < 0.5, "{wheel}");
    assert!(rows.iter().any(|row| row.contains("bad.prw") && !row.ends_with(',')));
    assert!(!place.files().contains(&".fleet.csv.survey".to_owned()));
    // A pattern that names nothing, and an output that is one of the files.
    place.run(&["profile", "--survey", "*.whl", "--out", "x.csv"]).refused(&["*.whl"]);
    place.run(&["profile", "--survey", "*.prw", "--out", "s1002.prw"]).refused(&["s1002.prw"]);
}

/// A wheel as a shop measures it: S1002 worn hollow by `hollow` (m) and shifted in its file.
fn measured(random: &mut u64) -> Vec<[f64; 2]> {
    let mut next = || {
        *random =
            random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*random >> 11) as f64 / (1_u64 << 53) as f64
    };
    let hollow = 2e-3 * next();
    let curve = creepage_rail::Standard::S1002.profile();
    let stations = curve.curve().stations(4e-4).into_iter();
    let points = stations.map(|s| {
        let point = curve.curve().at(s);
        let worn = hollow * (-(point.y / 0.015).powi(2)).exp();
        [1e3 * point.y + 2e-3 * (next() - 0.5), 1e3 * (point.z - worn) + 2e-3 * (next() - 0.5)]
    });
    points.collect()
}

/// A wheel's file (mm) with a fault by its number: 0 has none, the last is an empty file.
fn faulty(index: usize, mut points: Vec<[f64; 2]>) -> Vec<u8> {
    const FAULTS: usize = 12;
    let fault = index % FAULTS;
    match fault {
        1 => points.iter_mut().for_each(|point| point[0] = -point[0]),
        2 => points.iter_mut().for_each(|point| point[1] = -point[1]),
        3 => points.reverse(),
        4 => points.truncate(points.len() / 3),
        5 => points = points.iter().flat_map(|point| [*point, *point]).collect(),
        6 => points.iter_mut().flatten().for_each(|value| *value *= 1e-3),
        7 => {
            let (sin, cos) = 0.05f64.sin_cos();
            for [y, z] in &mut points {
                (*y, *z) = (cos * *y - sin * *z, sin * *y + cos * *z);
            }
        }
        _ => {}
    }
    let lines: Vec<String> = points.iter().map(|[y, z]| format!("{y:.4} {z:.4}")).collect();
    let lines = lines.join("\n") + "\n";
    match fault {
        8 => format!("Wheel {index}\nmeasured by nobody; mm\n\n{lines}").into_bytes(),
        9 => lines.replace('.', ",").into_bytes(),
        10 => {
            let units = format!("\u{feff}{lines}");
            units.encode_utf16().flat_map(u16::to_le_bytes).collect()
        }
        11 => Vec::new(),
        _ => lines.into_bytes(),
    }
}

/// A fleet of so many files with all faults in turn, surveyed without a break and killed again and again: the same
/// table, and nothing hidden is left.
#[allow(clippy::print_stdout)] // the counts of the large run
fn survey_of_a_fleet(count: usize, kills: usize) {
    let place = Place::new();
    fs::create_dir(place.path("fleet")).unwrap();
    let mut random = 51;
    for index in 0..count {
        let content = faulty(index, measured(&mut random));
        place.write(&format!("fleet/wheel_{index:05}.whl"), content);
    }
    let survey = |out: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_creepage"));
        let arguments =
            ["profile", "--survey", "fleet/*.whl", "--rail", "UIC60", "--cant", "0.025"];
        command.current_dir(place.path("")).args(arguments);
        command.args(["--reference", "S1002", "--out", out]);
        command.stdout(Stdio::null()).stderr(Stdio::null());
        command
    };
    let start = Instant::now();
    // Some files are not read: the exit code says so.
    assert_eq!(survey("whole.csv").status().unwrap().code(), Some(3));
    let took = start.elapsed();
    let text = place.read("whole.csv");
    let mut rows = csv::Reader::from_reader(text.as_bytes());
    let rows: Vec<csv::StringRecord> = rows.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), count);
    let is_read = |row: &csv::StringRecord| row.get(13).is_some_and(str::is_empty);
    let mut by_fault = [[0; 2]; 12];
    for (index, row) in rows.iter().enumerate() {
        by_fault[index % 12][usize::from(!is_read(row))] += 1;
        if is_read(row) {
            // A flange of its right height, or none that was believed: a unit taken wrong would show here.
            let height: f64 = row[4].parse().unwrap();
            assert!((0.02..0.04).contains(&height), "{index}: {row:?}");
        } else {
            assert!(row[13].len() > 8, "{index}: {row:?}");
        }
    }
    println!("{count} files in {took:?}; read and not, by fault: {by_fault:?}");
    for k in 0..kills {
        let mut child = survey("killed.csv").spawn().unwrap();
        std::thread::sleep(
            took.mul_f64((0.5 + k as f64) / (kills as f64 + 1.0)).max(Duration::from_millis(5)),
        );
        child.kill().unwrap();
        child.wait().unwrap();
        let left = place.files();
        assert!(!left.iter().any(|name| name.ends_with(".partial")), "{left:?}");
    }
    survey("killed.csv").status().unwrap();
    assert_eq!(place.read("killed.csv"), text);
    assert_eq!(place.files(), ["fleet", "killed.csv", "whole.csv"]);
}

#[test]
fn a_survey_of_faulty_files_goes_on_after_a_kill() {
    survey_of_a_fleet(48, 3);
}

/// `cargo test -p creepage-cli --test cli five_thousand -- --ignored --nocapture`
#[test]
#[ignore = "thousands of files take minutes"]
fn a_survey_of_five_thousand_files_goes_on_after_kills() {
    survey_of_a_fleet(5000, 5);
}
