//! The examples in C, Fortran and Octave: installed, compiled, linked and run as a user does, and
//! their numbers held against the library's, to the last digit.
//!
//! A C compiler and pkg-config are needed; gfortran, valgrind, cmake and Octave are used where they
//! are, and reported as not run where not (`./test` installs the first two if it can).
//! `CREEPAGE_RELEASE_TESTS=1` also builds and installs what users get, stripped, with the static
//! library.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use creepage::coulomb::{Exact, Resolution};
use creepage::table::{Axis, Intervals, Provenance, Spec, Table, build};
use creepage::theory::TheoryError;
use creepage::{Contact, Creepage, Ellipse, Theory, TheorySpec};
use creepage_study::{BulkCase, CaseFile, Solver, Varied, solve};
use tempfile::TempDir;

/// The interface installed.
struct Installed {
    place: TempDir,
}

static INSTALLED: LazyLock<Installed> = LazyLock::new(|| {
    let place = tempfile::tempdir().unwrap();
    // The library that cargo built for this test is beside it.
    let built = env::current_exe().unwrap().parent().unwrap().to_owned();
    let mut install = Command::new(here().join("install.sh"));
    run(install.arg("--built").arg(built).arg(place.path().join("first")));
    // Where it is moved, it is found.
    fs::rename(place.path().join("first"), place.path().join("moved")).unwrap();
    Installed { place }
});

impl Installed {
    fn path(&self, name: &str) -> PathBuf {
        self.place.path().join(name)
    }

    fn pkg_config(&self, arguments: &[&str]) -> String {
        let mut config = Command::new("pkg-config");
        config.args(arguments).arg("creepage");
        run(config.env("PKG_CONFIG_PATH", self.path("moved/lib/pkgconfig")))
    }

    /// Compiles sources with what pkg-config says.
    fn compile(&self, compiler: &str, sources: &[PathBuf], flags: &[&str], name: &str) -> PathBuf {
        let told = self.pkg_config(&["--cflags", "--libs"]);
        let out = self.path(name);
        let mut compile = Command::new(compiler);
        // Fortran's modules go to the working directory.
        compile.current_dir(self.place.path()).args(flags).args(sources);
        run(compile.args(told.split_whitespace()).arg("-o").arg(&out));
        out
    }

    fn compile_c(&self, flags: &[&str], name: &str) -> PathBuf {
        self.compile("cc", &[example("creep_force.c")], flags, name)
    }
}

/// A small table, and its file.
fn table() -> (Table, PathBuf) {
    let spec = Spec {
        a_over_b: Axis::fixed(1.0),
        poisson: Axis::fixed(0.28),
        intervals: Intervals { theta: 4, phi: 4, t: 4 },
        places: 20,
        provenance: Provenance::default(),
    };
    let prepare = |contact: &Contact| -> Result<Box<dyn Theory>, TheoryError> {
        TheorySpec::named("polach").unwrap().prepare(contact)
    };
    let table = build(&spec, prepare, &|| {}).unwrap();
    let path = INSTALLED.path("table.nc");
    fs::write(&path, table.to_bytes().unwrap()).unwrap();
    (table, path)
}

fn example(name: &str) -> PathBuf {
    here().join("examples").join(name)
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

fn file(path: &Path) -> CaseFile {
    CaseFile::read(&fs::read_to_string(path).unwrap()).unwrap()
}

/// The forces of the case by the library (N, N, N m).
fn forces_of_the_case() -> Vec<f64> {
    let solved = solve(&file(&case()).case().unwrap(), None).unwrap();
    let force = solved.scaling().si_force(solved.solution().force);
    vec![force.longitudinal, force.lateral, force.moment]
}

/// The unsteady contact from C: what was rejected is taken again with the same bits.
#[test]
fn a_program_in_c_rolls() {
    let program = INSTALLED.compile("cc", &[example("creep_roll.c")], &["-Wall"], "creep_roll");
    let case = here().join("../../examples/roll/wheel-pulls.toml");
    let printed = run(Command::new(program).arg(case));
    let steps: Vec<&str> = printed.lines().collect();
    assert_eq!(steps.len(), 3, "{printed}");
    assert_eq!(steps[1], steps[2]);
    // To the tolerance of a force that is found, 1e-7 of 24 kN.
    let force = numbers(steps[1], "step")[0];
    assert!((force - 9e3).abs() < 1e-2, "{printed}");
}

/// Bits of doubles: the same to the last digit.
fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|number| number.to_bits()).collect()
}

#[test]
fn the_example_in_c_gives_the_numbers_of_the_library() {
    let strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-g"];
    let program = INSTALLED.compile_c(&strict, "c");
    let (table, path) = table();
    let text = run(Command::new(program).arg(case()).arg(&path).arg(case()));
    assert_eq!(bits(&numbers(&text, "case")), bits(&forces_of_the_case()));
    let creepage = Creepage::new(0.9, -0.3, 0.5).unwrap();
    let right = table.at(1.0, 0.28).unwrap().force(creepage).components();
    assert_eq!(bits(&numbers(&text, "table")), bits(&right));
    assert!(text.contains("mistake 3 unknown theory `exactly`"), "{text}");
    assert!(text.contains("status 0") && text.contains(env!("CARGO_PKG_VERSION")), "{text}");
    assert_eq!(numbers(&text, "derivative").len(), 9);
    let hertz = file(&case()).hertz().unwrap();
    let right = [hertz.ellipse().a(), hertz.ellipse().b(), hertz.peak_pressure(), hertz.approach()];
    assert_eq!(bits(&numbers(&text, "hertz")[..4]), bits(&right));
    let varied = [Varied::Longitudinal, Varied::Lateral, Varied::Spin, Varied::NormalForce];
    let bulk = BulkCase::new(&file(&case()), varied.to_vec()).unwrap();
    let solver = Solver::new(TheorySpec::named("fastsim").unwrap());
    let rows = [[-1e-3, 5e-4, 0.1, 70e3], [-2e-3, 0.0, 0.2, 90e3]];
    let forces = rows.map(|row| bulk.solve_one(&solver, &row).unwrap().force());
    let forces = forces.map(|force| [force.longitudinal, force.lateral, force.moment]);
    assert_eq!(bits(&numbers(&text, "history")), bits(forces.as_flattened()));
}

#[test]
fn the_example_in_c_finds_the_creepage_of_the_library() {
    let program = INSTALLED.compile_c(&["-std=c99"], "c-wanted");
    let path = here().join("../../examples/ball-rolling-free.toml").canonicalize().unwrap();
    let text = run(Command::new(program).arg(&path));
    let solved = solve(&file(&path).case().unwrap(), None).unwrap();
    let found = solved.scaling().si_creepage(solved.creepage());
    let found = [found.longitudinal, found.lateral, found.spin];
    assert_eq!(bits(&numbers(&text, "creepage")), bits(&found));
}

/// The sanitizer watches what C reads, and everything that is allocated, ours too: a leak or an
/// invalid access ends the program with a complaint.
#[test]
fn the_address_sanitizer_finds_nothing() {
    let flags = ["-std=c99", "-g", "-fsanitize=address,undefined", "-fno-omit-frame-pointer"];
    let program = INSTALLED.compile_c(&flags, "c-sanitized");
    let mut command = Command::new(program);
    command.env("ASAN_OPTIONS", "detect_leaks=1").arg(case()).arg(table().1).arg(case());
    assert_eq!(bits(&numbers(&run(&mut command), "case")), bits(&forces_of_the_case()));
}

#[test]
fn valgrind_finds_nothing() {
    if !there("valgrind") {
        eprintln!(
            "NOT TESTED: valgrind is not installed; the address sanitizer's test stands alone"
        );
        return;
    }
    let program = INSTALLED.compile_c(&["-std=c99", "-g"], "c-watched");
    let mut command = Command::new("valgrind");
    command.args(["--error-exitcode=9", "--leak-check=full", "--errors-for-leak-kinds=definite"]);
    let text = run(command.arg(program).arg(case()));
    assert_eq!(numbers(&text, "case").len(), 3);
}

#[test]
fn the_example_in_fortran_gives_the_numbers_of_the_library() {
    if !there("gfortran") {
        eprintln!("NOT TESTED: gfortran is not installed, the example in Fortran was not compiled");
        return;
    }
    let strict = ["-std=f2018", "-Wall", "-Werror"];
    let module = PathBuf::from(INSTALLED.pkg_config(&["--variable=includedir"]).trim());
    let sources = [module.join("creepage.f90"), example("creep_force.f90")];
    let program = INSTALLED.compile("gfortran", &sources, &strict, "fortran");
    let text = run(Command::new(program).arg(case()));
    assert_eq!(bits(&numbers(&text, "case")), bits(&forces_of_the_case()));
    assert_eq!(numbers(&text, "history").len(), 6);
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

#[test]
fn cmake_finds_the_library() {
    if !there("cmake") {
        eprintln!("NOT TESTED: cmake is not installed");
        return;
    }
    let source = INSTALLED.path("cmake");
    fs::create_dir_all(&source).unwrap();
    let lists = format!(
        "cmake_minimum_required(VERSION 3.10)\nproject(trial C)\n\
         find_package(creepage {} REQUIRED)\nadd_executable(trial {})\n\
         target_link_libraries(trial creepage::creepage m)\n",
        env!("CARGO_PKG_VERSION"),
        example("creep_force.c").display()
    );
    fs::write(source.join("CMakeLists.txt"), lists).unwrap();
    let mut configure = Command::new("cmake");
    configure.arg("-S").arg(&source).arg("-B").arg(source.join("build"));
    let prefix = format!("-DCMAKE_PREFIX_PATH={}", INSTALLED.path("moved").display());
    run(configure.arg(prefix));
    run(Command::new("cmake").arg("--build").arg(source.join("build")));
    let text = run(Command::new(source.join("build/trial")).arg(case()));
    assert_eq!(bits(&numbers(&text, "case")), bits(&forces_of_the_case()));
}

#[test]
fn octave_gives_the_numbers_of_the_library() {
    if !there("mkoctfile") {
        eprintln!("NOT TESTED: Octave is not installed, the MEX function was not compiled");
        return;
    }
    let told = INSTALLED.pkg_config(&["--cflags", "--libs"]);
    let mut compile = Command::new("mkoctfile");
    compile.current_dir(INSTALLED.place.path()).arg("--mex").arg(example("creepage_force.c"));
    run(compile.args(told.split_whitespace()));
    let script = format!(
        "[f, s] = creepage_force('{}', 'fastsim', 'normal_force', [70e3, NaN]); \
         printf('octave %.17g %.17g %.17g\\nstatuses %d %d\\n', f(:, 1), s);",
        case().display()
    );
    let mut octave = Command::new("octave-cli");
    let text = run(octave.current_dir(INSTALLED.place.path()).args(["--norc", "--eval", &script]));
    let bulk = BulkCase::new(&file(&case()), vec![Varied::NormalForce]).unwrap();
    let solver = Solver::new(TheorySpec::named("fastsim").unwrap());
    let force = bulk.solve_one(&solver, &[70e3]).unwrap().force();
    let right = [force.longitudinal, force.lateral, force.moment];
    assert_eq!(bits(&numbers(&text, "octave")), bits(&right));
    assert!(text.contains("statuses 0 8"), "{text}");
}

#[cfg(target_os = "linux")]
#[test]
fn what_users_get_is_stripped_and_shows_its_own_names_alone() {
    if env::var_os("CREEPAGE_RELEASE_TESTS").is_none() {
        eprintln!("NOT TESTED: the release build; set CREEPAGE_RELEASE_TESTS=1 for it");
        return;
    }
    let prefix = INSTALLED.path("release");
    run(Command::new(here().join("install.sh")).arg(&prefix).env("CARGO", env!("CARGO")));
    let library = prefix.join("lib/libcreepage_ffi.so");
    // 2 MB in the year 2026, 17.6 MB with what belongs to debuggers.
    assert!(fs::metadata(&library).unwrap().len() < 6_000_000);
    let names =
        |arguments: &[&str], library: &Path| run(Command::new("nm").args(arguments).arg(library));
    let told = run(Command::new("readelf").arg("-d").arg(&library));
    let abi = env!("CARGO_PKG_VERSION").rsplit_once('.').unwrap().0;
    assert!(told.contains(&format!("[libcreepage_ffi.so.{abi}]")), "{told}");
    let archive = prefix.join("lib/libcreepage_ffi.a");
    for text in
        [names(&["-D", "--defined-only"], &library), names(&["-g", "--defined-only"], &archive)]
    {
        let own: Vec<_> = text.lines().filter_map(|line| line.split_whitespace().nth(2)).collect();
        assert!(own.len() > 15 && own.iter().all(|name| name.starts_with("creepage_")), "{own:?}");
    }
    let out = INSTALLED.path("static");
    let mut compile = Command::new("cc");
    compile.arg(example("creep_force.c")).arg(format!("-I{}", prefix.join("include").display()));
    run(compile.arg(archive).args(["-lm", "-lpthread", "-ldl", "-o"]).arg(&out));
    assert_eq!(bits(&numbers(&run(Command::new(out).arg(case())), "case")).len(), 3);
}
