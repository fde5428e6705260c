//! Options that change what a file means: the side of a profile, unknown digits, the unit of forces, encodings.

use std::fs;

use creepage_import::{ImportError, import};

use crate::wheels::{WHEEL, read_wheel};
use crate::{ball, head, read, text};

/// A plane that falls to one side, in Simpack's format.
fn tilted() -> String {
    let point = |k: i32| format!("{} {} 1.0\n", 0.5 * f64::from(k), 0.025 * f64::from(k));
    let points = (-80..=80).map(point).collect::<Vec<_>>().concat();
    format!(
        "header.begin\n  version = 1\n  type = 0\nheader.end\nspline.begin\n  units.len.f = 1000.0\n  \
         units.ang.f = 1.0\npoint.begin\n{points}point.end\nspline.end\n"
    )
}

/// A rail does not show its side: MIRRORY says it, in every format.
#[test]
fn mirrory_turns_a_rail() {
    let of = |mirror: &str| {
        let place = tempfile::tempdir().unwrap();
        fs::write(place.path().join("tilted.prr"), tilted()).unwrap();
        let wheel = WHEEL.replace(
            "'Profiles\\RAIL.prr' 0 1. 0. 0 1",
            &format!("'tilted.prr' {mirror} 1. 0. 0 1"),
        );
        let imported = read_wheel(&wheel, place.path());
        text(&imported.cases[0], 0)
    };
    assert_eq!(of("0"), of("-1"));
    assert!(!of("0").contains("track-side"), "{}", of("0"));
    let rail = of("1");
    let section = rail.split("[rail]").nth(1).unwrap().split("\n\n").next().unwrap();
    assert!(section.contains("y = \"track-side\""), "{rail}");
}

/// A scale that is not positive carries a note.
#[test]
fn a_scale_below_zero_is_noted() {
    let place = tempfile::tempdir().unwrap();
    let imported =
        read_wheel(&WHEEL.replace("'wheel.PRW' 0 1. 1.", "'wheel.PRW' 0 -1. 1."), place.path());
    assert!(imported.cases[0].notes.iter().any(|note| note.contains("SCALE = -1.0")));
}

#[test]
fn digits_that_nobody_knows_are_named() {
    let case = |first: &str, second: &str| {
        let ball = ball(first, "1000. .002 .001 .0002", "0.0 0.2 2000. CHI");
        read(&ball.replacen("022020 LDCMZE", &format!("{second} LDCMZE"), 1)).map(|read| read.cases)
    };
    for (first, second, said, line) in [
        ("203100", "022920", "M from 0 to 5", 3),
        ("903100", "022020", "P from 0 to 3", 2),
        ("203500", "022020", "N from 0 to 1", 2),
        ("203140", "022020", "F from 0 to 3", 2),
        ("203100", "026020", "C from 0 to 4, or 9", 3),
        ("203100", "062020", "D from 0 to 5", 3),
    ] {
        match case(first, second) {
            Err(ImportError::Line { line: at, expected, .. }) => {
                assert!(at == line && expected.contains(said), "{at} {expected}");
            }
            other => panic!("{other:?}"),
        }
    }
    // F = 3 belongs to module 1.
    let cause = case("203130", "022020").unwrap()[0].written.clone().unwrap_err().to_string();
    assert!(cause.contains("F = 3"), "{cause}");
}

/// Forces are over `FSTAT FN`; under friction row by row over `FN`.
#[test]
fn forces_are_over_their_own_unit() {
    let wanted = |file: &str| {
        let imported = read(file).unwrap();
        let text = text(&imported.cases[0], 0);
        let line = text.lines().find(|line| line.starts_with("fx = ")).unwrap();
        line.trim_start_matches("fx = ").parse::<f64>().unwrap()
    };
    let case = ball("203110", "1000. 0.3 .001 .0002", "0.0 0.2 2000. CHI");
    assert!((wanted(&case) + 0.3).abs() < 1e-12);
    // 0.3 of 0.4 N, of 0.3 N the whole and a third more.
    let kinetic = case.replace(" 0.3 0.3 friction", " 0.4 0.3 friction");
    assert!((wanted(&kinetic) + 0.4).abs() < 1e-12);
    let rows: String = ["0.2 0.2", "0.25 0.25", "0.3 0.3", "0.35 0.35", "0.4 0.4"]
        .map(|row| format!(" {row} friction\n"))
        .concat();
    let by_row = head("203110", "3022020")
        + " 1000. 0.2 .001 .0002 load\n 0.0 0.2 2000. CHI\n 0.28 0.28 82000. 82000. material\n 1 IPOTCN\n \
           5 5 -10. -10. 4. 4. grid\n 1 1 kinds\n .005 .0 .005 .0 .0 .0 shape\n"
        + &rows;
    // 0.2 N is half of the largest friction, 0.4 N.
    assert!((wanted(&by_row) + 0.5).abs() < 1e-12);
}

#[test]
fn what_cannot_be_solved_is_not_written() {
    let cause = |file: &str| read(file).unwrap().cases[0].written.clone().unwrap_err().to_string();
    let case = |kinematics: &str| ball("203100", kinematics, "0.0 0.2 2000. CHI");
    assert!(cause(&case("0. .002 .001 .0002")).contains("(FN)"));
    let line = case("1000. .002 .001 .0002")
        .replace("9 9 -0.9 -0.9 0.2 0.2 grid", "9 1 -0.9 0. 0.2 2. grid")
        .replace(".005 .0 .005", ".005 .0 .0");
    assert!(cause(&line).contains("spin on a line contact"));
    let place = tempfile::tempdir().unwrap();
    let lifted = read_wheel(&WHEEL.replace("0. 3. 10000.", "0. 3. 0."), place.path());
    assert!(lifted.cases[0].written.clone().unwrap_err().to_string().contains("(FZ)"));
}

/// A byte order mark and UTF-16 are how an editor saves.
#[test]
fn encodings_are_those_of_editors() {
    let file = ball("203100", "1000. .002 .001 .0002", "0.0 0.2 2000. CHI");
    let plain = text(&read(&file).unwrap().cases[0], 0);
    let marked = format!("\u{feff}{file}");
    let wide: Vec<u8> = marked.encode_utf16().flat_map(u16::to_le_bytes).collect();
    for bytes in [marked.into_bytes(), wide] {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("own.inp");
        fs::write(&path, bytes).unwrap();
        let imported = import(&path, &place.path().join("out")).unwrap();
        assert_eq!(text(&imported.cases[0], 0), plain);
    }
}
