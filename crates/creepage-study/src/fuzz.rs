//! Fuzz tests: whatever stands in a hostile file, an answer or a message comes of it, and no panic.
//!
//! `CREEPAGE_FUZZ=100 cargo test -p creepage-study fuzz` tries a hundred times as many.

use std::path::{Path, PathBuf};
use std::{env, fs};

use creepage::TheorySpec;
use creepage::table::{Axis, Intervals, Provenance, Spec, Table, build};
use creepage::theory::TheoryError;
use proptest::prelude::*;

use crate::{
    BulkCase, CaseFile, GapFile, History, RollFile, Solver, StaticsFile, Sweep, Varied,
    WheelsetFile, solve,
};

/// So many cases, times what the environment says.
fn config(cases: u32) -> ProptestConfig {
    let times = env::var("CREEPAGE_FUZZ").ok().and_then(|times| times.parse().ok()).unwrap_or(1);
    ProptestConfig { cases: cases * times, failure_persistence: None, ..ProptestConfig::default() }
}

fn examples(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(folder)
}

/// The corpus: the example files of one kind.
fn corpus(folder: &str) -> Vec<String> {
    let files = fs::read_dir(examples(folder)).unwrap().map(|entry| entry.unwrap().path());
    let files = files.filter(|path| path.extension().is_some_and(|extension| extension == "toml"));
    let texts: Vec<_> = files.map(|path| fs::read_to_string(path).unwrap()).collect();
    assert!(texts.len() > 1, "{folder}");
    texts
}

/// What numbers and words are replaced by.
const NASTY: [&str; 24] = [
    "nan",
    "inf",
    "-inf",
    "0",
    "-0.0",
    "1",
    "-1",
    "1e300",
    "-1e300",
    "1e-300",
    "5e-324",
    "0.5",
    "1e9",
    "99999999999999999999",
    "true",
    "'x'",
    "\"flat\"",
    "flat",
    "[]",
    "[1, 2]",
    "[nan, 1e99]",
    "{}",
    "\u{1f682}",
    "=",
];

/// One change of a text: a value replaced, a line dropped, twice or cut, a byte written over.
#[derive(Debug, Clone)]
enum Change {
    Value(usize, usize),
    Drop(usize),
    Twice(usize),
    Cut(usize),
    Byte(usize, char),
}

fn changes() -> impl Strategy<Value = Vec<Change>> {
    let place = any::<usize>;
    let change = prop_oneof![
        6 => (place(), 0..NASTY.len()).prop_map(|(at, nasty)| Change::Value(at, nasty)),
        1 => place().prop_map(Change::Drop),
        1 => place().prop_map(Change::Twice),
        1 => place().prop_map(Change::Cut),
        1 => (place(), any::<char>()).prop_map(|(at, other)| Change::Byte(at, other)),
    ];
    proptest::collection::vec(change, 1..4)
}

fn changed(text: &str, changes: &[Change]) -> String {
    let mut lines: Vec<String> = text.lines().map(ToOwned::to_owned).collect();
    for change in changes {
        let count = lines.len().max(1);
        match *change {
            Change::Value(at, nasty) => {
                let values: Vec<_> = (0..lines.len()).filter(|k| lines[*k].contains('=')).collect();
                if let Some(line) = values.get(at % values.len().max(1)) {
                    let key = lines[*line].split('=').next().unwrap_or_default().to_owned();
                    lines[*line] = format!("{key}= {}", NASTY[nasty]);
                }
            }
            Change::Drop(at) if !lines.is_empty() => drop(lines.remove(at % count)),
            Change::Twice(at) if !lines.is_empty() => {
                let line = lines[at % count].clone();
                lines.push(line);
            }
            Change::Cut(at) => lines.truncate(at % count),
            Change::Byte(at, other) if !lines.is_empty() => {
                let line = &mut lines[at % count];
                let mut letters: Vec<_> = line.chars().collect();
                let place = at / count % (letters.len() + 1);
                letters.insert(place, other);
                *line = letters.into_iter().collect();
            }
            _ => {}
        }
    }
    lines.join("\n")
}

/// What a message must be: words that a person can read.
fn readable(error: &dyn std::error::Error) {
    let words = error.to_string();
    assert!(!words.is_empty() && words.len() < 2000, "{words}");
}

#[test]
fn case_files() {
    let corpus = corpus("");
    let polach = TheorySpec::named("polach").unwrap();
    proptest!(config(400), |(which in any::<usize>(), changes in changes())| {
        let text = changed(&corpus[which % corpus.len()], &changes);
        match CaseFile::read(&text).and_then(|file| Ok((file.case()?, file))) {
            Err(error) => readable(&error),
            Ok((case, _)) if case.creepage().is_err() => {}
            Ok((case, _)) => match solve(&case, Some(&polach)) {
                Err(error) => readable(&error),
                Ok(solved) => {
                    let force = solved.solution().force;
                    prop_assert!(force.components().iter().all(|part| part.is_finite()));
                    prop_assert!(!solved.text().is_empty());
                    prop_assert!(solved.solution().force.magnitude() <= 1.0 + 1e-9);
                }
            }
        }
    });
}

#[test]
fn statics_files() {
    let corpus = corpus("statics");
    proptest!(config(150), |(which in any::<usize>(), changes in changes())| {
        let text = changed(&corpus[which % corpus.len()], &changes);
        match StaticsFile::read(&text) {
            Err(error) => readable(&error),
            Ok(file) => {
                if let Err(error) = file.solve() {
                    readable(&error);
                }
            }
        }
    });
}

#[test]
fn gap_files() {
    let (corpus, directory) = (corpus("gap"), examples("gap"));
    proptest!(config(150), |(which in any::<usize>(), changes in changes())| {
        let text = changed(&corpus[which % corpus.len()], &changes);
        if let Err(error) = GapFile::read(&text).and_then(|file| file.case(&directory)) {
            readable(&error);
        }
    });
}

#[test]
fn wheelset_files() {
    let (corpus, directory) = (corpus("wheelset"), examples("wheelset"));
    proptest!(config(150), |(which in any::<usize>(), changes in changes())| {
        let text = changed(&corpus[which % corpus.len()], &changes);
        match WheelsetFile::read(&text) {
            Err(error) => readable(&error),
            Ok(file) => {
                if let Err(error) = file.case(&directory) {
                    readable(&error);
                }
            }
        }
    });
}

#[test]
fn roll_files_and_histories() {
    let corpus = corpus("roll");
    let histories = ["cylinders.csv", "pulls.csv"];
    let histories = histories.map(|name| fs::read_to_string(examples("roll").join(name)).unwrap());
    let which = || any::<usize>();
    proptest!(config(150), |(which in (which(), which()), file in changes(), rows in changes())| {
        let text = changed(&corpus[which.0 % corpus.len()], &file);
        match RollFile::read(&text).and_then(|file| file.case(".".as_ref())) {
            Err(error) => readable(&error),
            Ok(case) => {
                let rows = changed(&histories[which.1 % histories.len()], &rows);
                if let Err(error) = History::read(rows.as_bytes(), &case) {
                    readable(&error);
                }
            }
        }
    });
}

#[test]
fn sweep_files() {
    let corpus = corpus("catalogue");
    proptest!(config(200), |(which in any::<usize>(), changes in changes())| {
        let text = changed(&corpus[which % corpus.len()], &changes);
        match Sweep::read(&text) {
            Err(error) => readable(&error),
            Ok(sweep) => prop_assert!(sweep.cases() > 0),
        }
    });
}

#[test]
fn rows_of_a_case() {
    let text = &corpus("")[0];
    let text = text.split("[wanted]").next().unwrap();
    let text = format!("{}\n[creepage]\nspin = 0.1\n", text.split("[creepage]").next().unwrap());
    let file = CaseFile::read(&text).unwrap();
    let solver = Solver::new(TheorySpec::named("polach").unwrap());
    let number = prop_oneof![
        any::<f64>(),
        (-3.0..3.0_f64),
        (-12.0..12.0_f64).prop_map(|power| 10_f64.powf(power)),
    ];
    let row = proptest::collection::vec(number, Varied::ALL.len());
    let chosen = proptest::collection::vec(any::<bool>(), Varied::ALL.len());
    proptest!(config(2000), |(values in row, chosen in chosen)| {
        let varied = Varied::ALL.into_iter().zip(&chosen);
        let varied = varied.filter_map(|(varied, chosen)| chosen.then_some(varied)).collect();
        match BulkCase::new(&file, varied) {
            Err(error) => readable(&error),
            Ok(bulk) => match bulk.solve_one(&solver, &values) {
                Err(error) => readable(&error),
                Ok(answer) => {
                    let force = answer.reply.solution.force;
                    prop_assert!(force.components().iter().all(|part| part.is_finite()));
                    prop_assert!(force.magnitude() <= 1.0 + 1e-9);
                }
            },
        }
    });
}

#[test]
fn table_files() {
    let spec = Spec {
        a_over_b: Axis { low: 0.5, high: 2.0, nodes: 2 },
        poisson: Axis::fixed(0.28),
        intervals: Intervals { theta: 4, phi: 4, t: 4 },
        places: 4,
        provenance: Provenance::default(),
    };
    let polach = TheorySpec::named("polach").unwrap();
    let prepare =
        |contact: &creepage::Contact| -> Result<_, TheoryError> { polach.prepare(contact) };
    let bytes = build(&spec, prepare, &|| {}).unwrap().to_bytes().unwrap();
    let place = any::<usize>;
    let edits = proptest::collection::vec((place(), any::<u8>()), 1..6);
    proptest!(config(300), |(edits in edits, cut in proptest::option::weighted(0.3, place()))| {
        let mut bytes = bytes.clone();
        for (at, byte) in edits {
            let at = at % bytes.len();
            bytes[at] = byte;
        }
        bytes.truncate(cut.map_or(bytes.len(), |at| at % bytes.len()));
        if let Err(error) = Table::from_bytes(bytes) {
            readable(&error);
        }
    });
}
