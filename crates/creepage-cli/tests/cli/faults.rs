//! What goes wrong on the way: a full disk, a kill, a name that cannot be given.

use std::collections::BTreeMap;
use std::fs;
use std::process::Command;
use std::time::Duration;

use crate::place::{CASE, Place, Ran, json};

/// The command where no file may grow beyond so many blocks of 512 bytes: writing more fails as on a
/// full disk.
fn on_a_full_disk(place: &Place, blocks: u32, arguments: &str) -> Ran {
    let program = env!("CARGO_BIN_EXE_creepage");
    let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec {program} {arguments}");
    let mut command = Command::new("sh");
    command.current_dir(place.path("")).args(["-c", &script]);
    command.output().unwrap().into()
}

/// Every file of a directory here, with its contents.
fn contents(place: &Place, directory: &str) -> BTreeMap<String, Vec<u8>> {
    let names = place.files_in(directory).into_iter();
    let read = |name: String| {
        let bytes = fs::read(place.path(directory).join(&name)).unwrap();
        (name, bytes)
    };
    names.map(read).collect()
}

/// A wheel on a rail by a quick theory, under some load.
fn case(load: &str) -> String {
    CASE.replace("80e3", load)
        .replace("theory = \"variational\"\ndegree = 3", "theory = \"polach\"")
}

/// Files that every command here reads.
fn place() -> Place {
    let place = Place::new();
    place.write("case.toml", case("80e3"));
    let pressed = CASE.split("[creepage]").next().unwrap();
    place.write("shift.toml", format!("{pressed}[statics]\nproblem = \"shift\"\nforce_x = 1e3\n"));
    let rows = (0..2000).map(|k| format!("1,0.3,{},0,0\n", f64::from(k) / 1e3));
    place.write("rows.csv", format!("a_over_b,poisson,xi,eta,chi\n{}", rows.collect::<String>()));
    let creepage = "[creepage]\nupsilon = { from = 4.0, step = -0.1, to = 0.1 }\nchi = [0, 1]\n";
    place.write("sweep.toml", format!("[contact]\na_over_b = 1\npoisson = 0.28\n{creepage}"));
    place
}

const WRITING: [&str; 6] = [
    "solve case.toml --out out",
    "statics shift.toml --out out",
    "curve case.toml --out out",
    "batch --theory polach --in rows.csv --out out/rows.csv",
    "sweep sweep.toml --out out/sweep.csv",
    "table build --theory polach --intervals 4,4,4 --places 8 --out out/t.nc",
];

#[test]
fn a_full_disk_leaves_what_was_there() {
    for arguments in WRITING {
        let place = place();
        fs::create_dir(place.path("out")).unwrap();
        let words: Vec<_> = arguments.split(' ').collect();
        place.run(&words).done();
        let before = contents(&place, "out");
        assert!(!before.is_empty(), "{arguments}");
        for blocks in [0, 4] {
            let ran = on_a_full_disk(&place, blocks, arguments);
            assert_eq!(ran.code, Some(1), "{arguments}: {}", ran.stderr);
            assert!(ran.stderr.contains("error: cannot write"), "{arguments}: {}", ran.stderr);
            let mut after = contents(&place, "out");
            // Solved cases of a sweep are kept for the next try.
            after.remove("sweep.csv.journal");
            assert!(after == before, "{arguments}: {:?}", after.keys());
        }
        place.run(&words).done();
        assert!(contents(&place, "out").keys().eq(before.keys()), "{arguments}");
    }
}

#[test]
fn a_full_disk_leaves_no_new_directory_and_no_empty_example() {
    let place = place();
    for (directory, arguments) in
        [("deep", "solve case.toml --out deep/out"), ("new.toml", "init --out new.toml")]
    {
        let ran = on_a_full_disk(&place, 0, arguments);
        assert_eq!(ran.code, Some(1), "{}", ran.stderr);
        assert!(!place.path(directory).exists(), "{arguments}");
    }
    let printed = on_a_full_disk(&place, 0, "hertz case.toml > printed.txt");
    assert_eq!(printed.code, Some(1), "{}", printed.stderr);
}

#[test]
fn a_file_that_cannot_be_replaced_leaves_all_others() {
    let place = place();
    let solve = ["solve", "case.toml", "--out", "out"];
    place.run(&solve).done();
    fs::remove_file(place.path("out/contact.svg")).unwrap();
    fs::create_dir_all(place.path("out/contact.svg/in the way")).unwrap();
    let report = place.read("out/report.json");
    let names = place.files_in("out");
    place.write("case.toml", case("60e3"));
    place.run(&solve).refused(&["out/contact.svg"]);
    assert_eq!((place.read("out/report.json"), place.files_in("out")), (report, names));
}

#[test]
fn a_run_that_is_killed_leaves_whole_files() {
    let place = place();
    let solve = ["solve", "case.toml", "--out", "out"];
    let loads = ["80e3", "60e3"];
    let results = loads.map(|load| {
        place.write("case.toml", case(load));
        place.run(&solve).done();
        contents(&place, "out")
    });
    for k in 0..20_usize {
        place.write("case.toml", case(loads[k % 2]));
        let mut child = Command::new(env!("CARGO_BIN_EXE_creepage"))
            .current_dir(place.path(""))
            .args(solve)
            .stdout(std::process::Stdio::null())
            .stderr(std::process::Stdio::null())
            .spawn()
            .unwrap();
        // Moments from the start to about the end, in an irregular order.
        std::thread::sleep(Duration::from_millis((k as u64 * 37 + 11) % 200));
        child.kill().unwrap();
        child.wait().unwrap();
        let left = contents(&place, "out");
        for name in results[0].keys() {
            assert!(results.iter().any(|result| result[name] == left[name]), "{name} is not whole");
        }
    }
    place.write("case.toml", case(loads[0]));
    place.run(&solve).done();
    let left = contents(&place, "out");
    assert!(results[0].iter().all(|(name, bytes)| left[name] == *bytes));
    assert_eq!(json(&place.read("out/report.json"))["contact"]["normal_force_n"], 80e3);
}
