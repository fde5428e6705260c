//! Imports an input file of the reference program and solves its wheels on rails: forces on the rail in track axes, to
//! lay beside that program's own. A second theory or resolution tells who is right.
//!
//!     cargo run -p creepage-import --example solve_imported -- FILE.inp [RESOLUTION] [CASE ...]
#![allow(missing_docs, clippy::print_stdout, clippy::unwrap_used)]

use std::path::Path;
use std::time::Instant;

use creepage_import::import;
use creepage_study::WheelsetFile;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let input = arguments.next().ok_or("which file?")?;
    let resolution = arguments.next().unwrap_or_else(|| "standard".into());
    let only: Vec<String> = arguments.collect();
    let place = tempfile::tempdir()?;
    let imported = import(Path::new(&input), place.path())?;
    for file in &imported.profiles {
        std::fs::write(place.path().join(&file.name), &file.contents)?;
    }
    for (number, case) in (1..).zip(&imported.cases) {
        if !only.is_empty() && !only.contains(&number.to_string()) {
            continue;
        }
        match &case.written {
            Err(cause) => println!("{number}: not imported: {cause}"),
            Ok(written) => {
                let text = String::from_utf8_lossy(&written.files[0].contents).into_owned();
                if !WheelsetFile::is_one(&text) {
                    continue;
                }
                let text = text.replace(
                    "theory = \"exact\"",
                    &format!("theory = \"exact\"\nresolution = \"{resolution}\""),
                );
                solve(number, &text, place.path());
            }
        }
    }
    Ok(())
}

fn solve(number: usize, text: &str, place: &Path) {
    let start = Instant::now();
    let case = match WheelsetFile::read(text).map(|file| file.case(place)) {
        Ok(Ok(case)) => case,
        Ok(Err(error)) => return println!("{number}: no case: {error}"),
        Err(error) => return println!("{number}: no case: {error}"),
    };
    match case.solve() {
        Err(error) => println!("{number}: not solved: {error}"),
        Ok(solved) => {
            for wheel in solved.wheels() {
                let [x, y, z] = wheel.on_rail().force;
                let load: f64 =
                    wheel.contacts().iter().map(creepage_study::SolvedContact::load).sum();
                println!(
                    "{number}: {} FX {x:.1} FY {y:.1} FZ {z:.1} (mu N {:.1}), z {:.5} mm, {:.2} s",
                    solved.status().name(),
                    solved.friction * load,
                    1e3 * wheel.position.z,
                    start.elapsed().as_secs_f64()
                );
                for one in wheel.contacts() {
                    let creepage = one.creepage;
                    println!(
                        "    {} N {:.1} delta {:.4} p_max {:.1} MPa y_r {:.3} mm, xi {:.5} eta {:.5} phi {:.5}/mm",
                        if one.is_on_guard { "guard rail" } else { "rail" },
                        one.load(),
                        one.angle,
                        1e-6 * one.normal.peak_pressure().value,
                        1e3 * one.y_rail,
                        creepage.longitudinal,
                        creepage.lateral,
                        1e-3 * creepage.spin
                    );
                }
            }
            for words in solved.caution_words() {
                println!("    caution: {words}");
            }
        }
    }
}
