//! `creepage sweep`: results that do not depend on threads or interruptions, and the catalogue.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::time::Duration;

use crate::place::{Place, json};

/// 2,000 cases in 100 chains.
const SWEEP: &str = "
[contact]
a_over_b = 0.7
poisson = 0.28
[creepage]
chi = { from = 0.5, step = 0.5, to = 5 }
alpha = { from = -90, step = 20, to = 90 }
upsilon = { from = 4.0, step = -0.2, to = 0.2 }
";

fn sweep(place: &Place, out: &str) -> std::process::Command {
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_creepage"));
    command.current_dir(place.path("")).args(["sweep", "sweep.toml", "--out", out]);
    command.stderr(Stdio::null());
    command
}

fn is_running(child: &mut Child) -> bool {
    child.try_wait().unwrap().is_none()
}

#[test]
fn a_sweep_killed_ten_times_ends_as_if_undisturbed() {
    let place = Place::new();
    place.write("sweep.toml", SWEEP);
    assert!(sweep(&place, "undisturbed.csv").status().unwrap().success());
    let whole = fs::metadata(place.path("undisturbed.csv")).unwrap().len();
    assert!(whole > 100_000);
    // Moments from the start into the middle of the work, in a fixed but irregular order.
    let (mut killed, mut moment) = (0, 7_u64);
    let journal = place.path("killed.csv.journal");
    let mut solved = 0;
    while killed < 10 {
        moment = (moment * 37 + 11) % 53;
        let mut child = sweep(&place, "killed.csv").spawn().unwrap();
        std::thread::sleep(Duration::from_millis(1 + moment / 4));
        if is_running(&mut child) {
            child.kill().unwrap();
            killed += 1;
        }
        child.wait().unwrap();
        if place.path("killed.csv").exists() {
            // It came to its end between two kills: begin again.
            fs::remove_file(place.path("killed.csv")).unwrap();
        } else if let Ok(data) = fs::metadata(&journal) {
            assert!(data.len() >= solved, "nothing solved may be lost");
            solved = data.len();
        }
        if !journal.exists() {
            solved = 0;
        }
    }
    assert!(sweep(&place, "killed.csv").status().unwrap().success());
    assert_eq!(place.read("killed.csv"), place.read("undisturbed.csv"));
    assert!(!journal.exists());
    let left = place.files();
    let partial = left.iter().filter(|name| name.ends_with(".journal"));
    assert_eq!(partial.count(), 0, "{left:?}");
}

#[test]
fn the_result_is_the_same_on_any_number_of_threads() {
    let place = Place::new();
    place.write("sweep.toml", SWEEP);
    for threads in ["1", "2", "5"] {
        let mut command = sweep(&place, &format!("{threads}.csv"));
        assert!(command.env("RAYON_NUM_THREADS", threads).status().unwrap().success());
    }
    assert_eq!(place.read("1.csv"), place.read("2.csv"));
    assert_eq!(place.read("1.csv"), place.read("5.csv"));
}

#[test]
fn a_damaged_journal_costs_only_the_damaged_cases() {
    let place = Place::new();
    place.write("sweep.toml", SWEEP);
    assert!(sweep(&place, "whole.csv").status().unwrap().success());
    // A directory in the way of the result leaves the journal complete.
    fs::create_dir(place.path("out.csv")).unwrap();
    assert!(!sweep(&place, "out.csv").status().unwrap().success());
    let journal = place.path("out.csv.journal");
    let mut bytes = fs::read(&journal).unwrap();
    for at in [5_000, 50_000, 200_000] {
        bytes[at] ^= 0x40;
    }
    bytes.truncate(400_000);
    fs::write(&journal, bytes).unwrap();
    fs::remove_dir(place.path("out.csv")).unwrap();
    assert!(sweep(&place, "out.csv").status().unwrap().success());
    assert_eq!(place.read("out.csv"), place.read("whole.csv"));
}

#[test]
fn every_format_has_every_case() {
    let place = Place::new();
    place.write(
        "sweep.toml",
        "[contact]\na_over_b = 1\npoisson = 0.28\n[creepage]\nchi = [2, 1]\nupsilon = [1.5, 1]",
    );
    for (name, format) in
        [("a.csv", "csv"), ("a.json", "json"), ("a.nc", "netcdf"), ("a.txt", "page")]
    {
        place.run(&["sweep", "sweep.toml", "--out", name]).done();
        place.run(&["sweep", "sweep.toml", "--out", "same", "--format", format]).done();
        let [one, two] = [name, "same"].map(|name| fs::read(place.path(name)).unwrap());
        assert_eq!(one, two, "{format}");
    }
    let json = json(&place.read("a.json"));
    let cases = json["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 4);
    let csv = place.read("a.csv");
    let mut lines = csv.lines();
    let header: Vec<_> = lines.next().unwrap().split(',').collect();
    let column = header.iter().position(|name| *name == "fy").unwrap();
    for (line, case) in lines.zip(cases) {
        let fy: f64 = line.split(',').nth(column).unwrap().parse().unwrap();
        assert!((fy - case["fy"].as_f64().unwrap()).abs() < f64::MIN_POSITIVE);
        assert_eq!(case["status"], "solved");
    }
    assert!(fs::read(place.path("a.nc")).unwrap().starts_with(b"CDF\x02"));
    assert_eq!(place.read("a.txt").matches("\nconverged\n").count(), 4);
}

#[test]
fn wrong_sweeps_are_refused() {
    let place = Place::new();
    place.write("sweep.toml", SWEEP);
    place.run(&["sweep", "sweep.toml", "--out", "a.what"]).refused(&["a.what", "--format"]);
    place.run(&["sweep", "none.toml", "--out", "a.csv"]).refused(&["none.toml"]);
    place.write("sweep.toml", SWEEP.replace("a_over_b", "a_over_c"));
    place.run(&["sweep", "sweep.toml", "--out", "a.csv"]).refused(&[
        "sweep.toml",
        "unknown key `a_over_c` in [contact]",
        "a_over_b",
    ]);
    assert_eq!(place.files(), ["sweep.toml"]);
}

#[test]
fn a_case_that_does_not_converge_is_named() {
    let place = Place::new();
    let solve = "[solve]\nmethod = \"newton\"\nmax_iterations = 1\n[creepage]";
    place.write("sweep.toml", SWEEP.replace("[creepage]", solve));
    let ran = place.run(&["sweep", "sweep.toml", "--out", "a.csv"]);
    assert_eq!(ran.code, Some(3));
    assert!(ran.stderr.contains("not converged"), "{}", ran.stderr);
    assert!(place.read("a.csv").contains("not_converged"));
}

fn catalogue() -> Vec<PathBuf> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/catalogue");
    let mut files: Vec<_> =
        fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

/// The catalogue of the thesis (5.29): every case converges.
#[test]
fn the_catalogue_converges() {
    let place = Place::new();
    let mut cases = 0;
    for path in catalogue() {
        place.run(&["sweep", path.to_str().unwrap(), "--out", "out.csv", "--format", "csv"]).done();
        let table = place.read("out.csv");
        for row in table.lines().skip(1) {
            let converged = row.ends_with(",solved") || row.ends_with(",creepage_too_small");
            assert!(converged, "{}: {row}", path.display());
            cases += 1;
        }
    }
    // Two thirds of the tubes' 7,296 cases are new by symmetry alone; the thesis had fewer.
    assert!(cases > 3_000, "{cases}");
}

/// The thesis needed 3.9, 4.4 and 4.7 iterations a case for degrees 2, 3, 4 (5.12).
#[test]
fn the_shipped_files_count_the_iterations_of_1967() {
    let place = Place::new();
    for (degree, thesis) in [(2, 3.9), (3, 4.4), (4, 4.7)] {
        let (mut cases, mut iterations) = (0, 0);
        for half in ["lateral", "spin"] {
            let name = format!("iterations-{half}-{degree}.toml");
            let path = catalogue().into_iter().find(|path| path.ends_with(&name)).unwrap();
            place.run(&["sweep", path.to_str().unwrap(), "--out", "out.csv"]).done();
            let table = place.read("out.csv");
            let mut lines = table.lines();
            let column = lines.next().unwrap().split(',').position(|name| name == "iterations");
            for line in lines {
                cases += 1;
                iterations += line.split(',').nth(column.unwrap()).unwrap().parse::<u32>().unwrap();
            }
        }
        assert_eq!(cases, 33);
        let mean = f64::from(iterations) / f64::from(cases);
        assert!((mean - thesis).abs() < 0.5, "M = {degree}: {mean}");
    }
}
