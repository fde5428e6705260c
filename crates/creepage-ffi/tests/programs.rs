//! The examples in C and Fortran: installed, compiled, linked and run as a user does, and their
//! numbers held against the command's, to the last digit.
//!
//! A C compiler and pkg-config are needed; gfortran and valgrind are used where they are, and
//! reported as not run where not (`./test` installs them if it can).

// Helpers of tests fail like tests: by panicking. What was not run must be reported.
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stderr)]

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use creepage::coulomb::{Exact, Resolution};
use creepage::{Contact, Creepage, Ellipse, Theory};
use serde_json::Value;
use tempfile::TempDir;

/// The interface installed, and the command built.
struct Installed {
    place: TempDir,
    creepage: PathBuf,
}

static INSTALLED: LazyLock<Installed> = LazyLock::new(|| {
    let place = tempfile::tempdir().unwrap();
    // The test itself is in <target>/debug/deps.
    let debug = env::current_exe().unwrap().ancestors().nth(2).unwrap().to_owned();
    let target = debug.parent().unwrap();
    let cargo = env!("CARGO");
    let mut install = Command::new(here().join("install.sh"));
    install.arg("--debug").arg(place.path()).env("CARGO", cargo).env("CARGO_TARGET_DIR", target);
    run(&mut install);
    let mut build = Command::new(cargo);
    build.args(["build", "--quiet", "--locked", "-p", "creepage-cli", "--manifest-path"]);
    run(build.arg(here().join("../../Cargo.toml")).env("CARGO_TARGET_DIR", target));
    Installed { place, creepage: debug.join("creepage") }
});

impl Installed {
    fn path(&self, name: &str) -> PathBuf {
        self.place.path().join(name)
    }

    /// Compiles an example with what pkg-config says.
    fn compile(&self, compiler: &str, source: &str, flags: &[&str], program: &str) -> PathBuf {
        let mut config = Command::new("pkg-config");
        config.args(["--cflags", "--libs", "creepage"]);
        let told = run(config.env("PKG_CONFIG_PATH", self.path("lib/pkgconfig")));
        let out = self.path(program);
        let mut compile = Command::new(compiler);
        // Fortran's modules go to the working directory.
        compile.current_dir(self.place.path());
        compile.args(flags).arg(here().join("examples").join(source));
        run(compile.args(told.split_whitespace()).arg("-o").arg(&out));
        out
    }

    fn command(&self, arguments: &[&str]) -> Value {
        let text = run(Command::new(&self.creepage).args(arguments).arg("--json"));
        serde_json::from_str(&text).unwrap()
    }

    /// A small table by the command.
    fn table(&self) -> PathBuf {
        let path = self.path("table.nc");
        let words = ["table", "build", "--theory", "polach", "--intervals", "4,4,4"];
        run(Command::new(&self.creepage).args(words).args(["--places", "20", "--out"]).arg(&path));
        path
    }
}

fn here() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn case() -> PathBuf {
    here().join("../../examples/wheel-on-rail.toml").canonicalize().unwrap()
}

fn there(tool: &str) -> bool {
    Command::new(tool).arg("--version").output().is_ok()
}

/// What a program prints; it must end well and complain of nothing.
#[track_caller]
fn run(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let complaints = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {complaints}");
    String::from_utf8(output.stdout).unwrap()
}

/// The numbers of the line that begins with `name`.
fn numbers(text: &str, name: &str) -> Vec<f64> {
    let mut lines = text.lines().filter_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
    let words = lines.next().unwrap_or_else(|| panic!("no {name} in {text}")).split_whitespace();
    words.map(|word| word.parse().unwrap()).collect()
}

/// The forces of the case by the command (N, N, N m).
fn forces_by_command() -> Vec<f64> {
    let report = INSTALLED.command(&["solve", case().to_str().unwrap()]);
    let body = &report["lower_body"];
    ["longitudinal_n", "lateral_n", "moment_n_m"].map(|key| body[key].as_f64().unwrap()).to_vec()
}

/// Bits of doubles: the same to the last digit.
fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|number| number.to_bits()).collect()
}

#[test]
fn the_example_in_c_gives_the_numbers_of_the_command() {
    let strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-g"];
    let program = INSTALLED.compile("cc", "creep_force.c", &strict, "c");
    let table = INSTALLED.table();
    let text = run(Command::new(program).arg(case()).arg(&table));
    assert_eq!(bits(&numbers(&text, "case")), bits(&forces_by_command()));
    let words = ["--xi", "0.9", "--eta", "-0.3", "--chi", "0.5"];
    let found =
        INSTALLED.command(&[&["table", "eval", table.to_str().unwrap()], &words[..]].concat());
    let right = ["fx", "fy", "mz"].map(|key| found[key].as_f64().unwrap());
    assert_eq!(bits(&numbers(&text, "table")), bits(&right));
    assert!(text.contains("mistake 3 unknown theory `exactly`"), "{text}");
    assert!(text.contains("status 0") && text.contains(env!("CARGO_PKG_VERSION")), "{text}");
    assert_eq!(numbers(&text, "derivative").len(), 9);
}

#[test]
fn the_example_in_c_finds_the_creepage_of_the_command() {
    let program = INSTALLED.compile("cc", "creep_force.c", &["-std=c99"], "c-wanted");
    let case = here().join("../../examples/ball-rolling-free.toml").canonicalize().unwrap();
    let text = run(Command::new(program).arg(&case));
    let report = INSTALLED.command(&["solve", case.to_str().unwrap()]);
    let found = ["longitudinal", "lateral", "spin_rad_per_m"]
        .map(|key| report["creepage"][key].as_f64().unwrap());
    assert_eq!(bits(&numbers(&text, "creepage")), bits(&found));
}

/// The sanitizer watches what C reads, and everything that is allocated, ours too: a leak or an
/// invalid access ends the program with a complaint.
#[test]
fn the_address_sanitizer_finds_nothing() {
    let flags = ["-std=c99", "-g", "-fsanitize=address,undefined", "-fno-omit-frame-pointer"];
    let program = INSTALLED.compile("cc", "creep_force.c", &flags, "c-sanitized");
    let mut command = Command::new(program);
    command.env("ASAN_OPTIONS", "detect_leaks=1").arg(case());
    assert_eq!(bits(&numbers(&run(&mut command), "case")), bits(&forces_by_command()));
}

#[test]
fn valgrind_finds_nothing() {
    if !there("valgrind") {
        eprintln!(
            "NOT TESTED: valgrind is not installed; the address sanitizer's test stands alone"
        );
        return;
    }
    let program = INSTALLED.compile("cc", "creep_force.c", &["-std=c99", "-g"], "c-watched");
    let mut command = Command::new("valgrind");
    command.args(["--error-exitcode=9", "--leak-check=full", "--errors-for-leak-kinds=definite"]);
    let text = run(command.arg(program).arg(case()));
    assert_eq!(numbers(&text, "case").len(), 3);
}

#[test]
fn the_example_in_fortran_gives_the_numbers_of_the_command() {
    if !there("gfortran") {
        eprintln!("NOT TESTED: gfortran is not installed, the example in Fortran was not compiled");
        return;
    }
    let strict = ["-std=f2018", "-Wall", "-Werror"];
    let program = INSTALLED.compile("gfortran", "creep_force.f90", &strict, "fortran");
    let text = run(Command::new(program).arg(case()));
    assert_eq!(bits(&numbers(&text, "case")), bits(&forces_by_command()));
    let forces: Vec<_> = text.lines().filter(|line| line.starts_with("curve")).collect();
    assert_eq!(forces.len(), 5);
    let contact = Contact::new(Ellipse::from_ratio(1.5).unwrap(), 0.28).unwrap();
    let theory = Exact::new(&contact, Resolution::FAST).unwrap();
    for line in forces {
        let [xi, fx, fy, mz] = numbers(line, "curve")[..] else { panic!("{line}") };
        let force = theory.solve(Creepage::new(xi, 0.0, 0.0).unwrap()).force;
        assert_eq!(bits(&[fx, fy, mz]), bits(&force.components()));
    }
}
