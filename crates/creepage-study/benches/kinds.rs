//! Cost of each further kind of contact beside the plain one: a groove's curve beside its plane, slices beside one
//! profile, wheels in steps beside steady ones, temperatures and friction that falls with them, cylinders that relax,
//! paths of shifts beside one shift. From the case to its answer, but for reading files.
#![allow(missing_docs, clippy::unwrap_used)]

use std::path::{Path, PathBuf};

use creepage_study::{
    AnyCase, AnyCaseFile, LineFile, StaticsFile, WheelStepsRun, WheelTable, WheelsetCase,
    WheelsetFile,
};
use divan::Bencher;

fn main() {
    // Unless more are asked for; with two cores both wheels are solved at a time.
    let threads = usize::from(std::env::var_os("RAYON_NUM_THREADS").is_none());
    rayon::ThreadPoolBuilder::new().num_threads(threads).build_global().unwrap();
    divan::main();
}

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// An example in which some words stand for others.
fn example(name: &str, changes: &[(&str, &str)]) -> String {
    let mut text = std::fs::read_to_string(examples().join(name)).unwrap();
    for (old, new) in changes {
        assert!(text.contains(old), "{name} has no {old}");
        text = text.replace(old, new);
    }
    text
}

fn case(text: &str) -> AnyCase {
    AnyCaseFile::read(text).unwrap().case(&examples()).unwrap()
}

#[divan::bench(args = ["plane", "curved"], sample_count = 10)]
fn groove_of_ten_millimetres(bencher: Bencher, surface: &str) {
    let surface = format!("\"{surface}\"");
    let changes =
        [("\"curved\"", &surface[..]), ("[wanted]\nlongitudinal_force = 0.0", "# by its slip")];
    let motion = ("lateral = 0.0", "longitudinal = 1e-3\nlateral = 0.0");
    let text = example("gap/groove.toml", &[changes[0], changes[1], motion]);
    let case = case(&text);
    bencher.bench_local(|| case.solve(None).unwrap());
}

#[divan::bench(args = ["none", "temperatures", "falling friction"], sample_count = 10)]
fn heat_of_a_sliding_wheel(bencher: Bencher, heat: &str) {
    let law = "{ cold = 0.3, hot = 0.12, temperatures = [100.0, 130.0] }";
    let section = "[heat]\nupper = { material = \"steel\" }\nlower = { material = \"steel\" }";
    let text = match heat {
        "none" => example("heat/sliding-wheel.toml", &[(law, "0.3"), (section, "")]),
        "temperatures" => example("heat/sliding-wheel.toml", &[(law, "0.3")]),
        _ => example("heat/sliding-wheel.toml", &[]),
    };
    let case = case(&text);
    // Temperatures come with the report.
    bencher.bench_local(|| case.solve(None).unwrap().report());
}

#[divan::bench(args = ["elastic", "viscoelastic"], sample_count = 10)]
fn polymer_rollers(bencher: Bencher, material: &str) {
    let relaxation = "[relaxation]             # slow loads find half of that modulus\nratio = 1.0\n\
                      time = 9e-3              # (s)";
    let changes: &[(&str, &str)] = if material == "elastic" { &[(relaxation, "")] } else { &[] };
    let case = LineFile::read(&example("line/polymer-rollers.toml", changes)).unwrap();
    let case = case.case().unwrap();
    bencher.bench_local(|| case.solve().unwrap());
}

#[divan::bench(args = ["one shift", "to and fro", "under loads that change"], sample_count = 10)]
fn shaken_ball(bencher: Bencher, path: &str) {
    let steps = "[{ force = 150.0 }, { force = -150.0 }, { force = 150.0 }, { force = 40.0 }, { shift = 0.0 }]";
    let own = match path {
        "one shift" => "[{ force = 150.0 }]",
        "to and fro" => steps,
        _ => {
            "[{ normal_force = 600.0, force = 150.0 }, { force = -150.0 }, { normal_force = 450.0, force = 150.0 }, \
             { normal_force = 550.0, force = 40.0 }, { shift = 0.0 }]"
        }
    };
    let file = StaticsFile::read(&example("statics/fretting-path.toml", &[(steps, own)])).unwrap();
    bencher.bench_local(|| file.solve().unwrap());
}

fn wheels(text: &str) -> WheelsetCase {
    let directory = examples().join("wheelset");
    WheelsetFile::read(text).unwrap().case(&directory).unwrap()
}

#[divan::bench(args = ["one profile", "slices"], sample_count = 10)]
fn wheel_on_a_rail(bencher: Bencher, rail: &str) {
    let slices = "slices = \"slices/rail-dip.toml\"";
    let own = if rail == "slices" { slices } else { "profile = \"UIC60\"" };
    let case = wheels(&example("wheelset/rail-dip.toml", &[(slices, own)]));
    let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
    bencher.bench_local(|| solver.solve(&case.stance, &travel).unwrap());
}

/// One row of a millimetre in steps, beside steady rolling there.
#[divan::bench(args = ["steady", "a step"], sample_count = 10)]
fn wheel_in_steps(bencher: Bencher, kind: &str) {
    let slices = "slices = \"slices/rail-dip.toml\"";
    let changes =
        [(slices, "profile = \"UIC60\""), ("pitch_rate = \"free\"", "pitch_rate = 43.522")];
    let case = wheels(&example("wheelset/rail-dip.toml", &changes));
    if kind == "steady" {
        let (solver, travel) = (case.solver().unwrap(), case.travel.unwrap());
        bencher.bench_local(|| solver.solve(&case.stance, &travel).unwrap());
    } else {
        let table = WheelTable::from_columns(&[("distance", &[1e-3])]).unwrap();
        bencher.bench_local(|| WheelStepsRun::new(&case, &table).unwrap().next_row().unwrap());
    }
}
