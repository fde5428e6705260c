//! `creepage batch --case`: rows in SI units, what has no column is the case file's.

use std::fmt::Write;
use std::io::{BufRead, BufReader, Write as _};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::place::{CASE, Place, Ran, json};

const FASTSIM: [&str; 5] = ["batch", "--case", "case.toml", "--theory", "fastsim"];
const SI: [&str; 4] =
    ["longitudinal_n", "lateral_n", "moment_n_m", "frictional_power_per_metre_j_per_m"];

/// A place with the case of a wheel.
fn place() -> Place {
    let place = Place::new();
    place.write("case.toml", CASE);
    place
}

/// Rows by the names of their columns.
fn rows(text: &str) -> (Vec<String>, Vec<csv::StringRecord>) {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let names = reader.headers().unwrap().iter().map(ToOwned::to_owned).collect();
    (names, reader.records().map(Result::unwrap).collect())
}

/// The cell of a row.
fn cell<'a>(
    (names, rows): &'a (Vec<String>, Vec<csv::StringRecord>),
    row: usize,
    name: &str,
) -> &'a str {
    let column = names.iter().position(|own| own == name).unwrap_or_else(|| panic!("no {name}"));
    &rows[row][column]
}

fn number(table: &(Vec<String>, Vec<csv::StringRecord>), row: usize, name: &str) -> u64 {
    cell(table, row, name).parse::<f64>().unwrap().to_bits()
}

/// The report of the case with other values, by the command `solve`.
fn solved(place: &Place, changes: &[(&str, &str)], theory: &str) -> serde_json::Value {
    let mut case = CASE.to_owned();
    for (old, new) in changes {
        assert!(case.contains(old), "{old}");
        case = case.replacen(old, new, 1);
    }
    place.write("one.toml", case);
    json(&place.run(&["solve", "one.toml", "--theory", theory, "--json"]).done())
}

#[test]
fn rows_are_cases_to_the_last_bit() {
    let place = place();
    let input = "t,longitudinal,spin,normal_force,friction\n\
                 0,-2e-3,0.2,80e3,0.3\n\
                 1,5e-4,-0.1,62e3,0.35\n";
    let table = rows(&place.run_on(&FASTSIM, input).done());
    let expected = ["fx", "fy", "mz", "status", "message"];
    assert_eq!(table.0[5..], [&SI[..], &expected[..]].concat());
    let changes: [&[_]; 2] = [
        &[("longitudinal = -1.5e-3", "longitudinal = -2e-3")],
        &[
            ("longitudinal = -1.5e-3", "longitudinal = 5e-4"),
            ("spin = 0.2", "spin = -0.1"),
            ("80e3", "62e3"),
            ("friction = 0.3", "friction = 0.35"),
        ],
    ];
    for (row, changes) in changes.into_iter().enumerate() {
        let report = solved(&place, changes, "fastsim");
        let bits = |value: &serde_json::Value| value.as_f64().unwrap().to_bits();
        for name in &SI[..3] {
            assert_eq!(number(&table, row, name), bits(&report["lower_body"][name]), "{name}");
        }
        assert_eq!(number(&table, row, SI[3]), bits(&report[SI[3]]));
        for name in ["fx", "fy", "mz"] {
            assert_eq!(number(&table, row, name), bits(&report["dimensionless"][name]), "{name}");
        }
    }
}

/// A case that wants wear and fatigue numbers has them row by row, as `solve` gives them.
#[test]
fn wear_and_fatigue_row_by_row() {
    let place = place();
    place.write("case.toml", CASE.to_owned() + "\n[damage]\n");
    let table = rows(&place.run_on(&FASTSIM, "longitudinal\n-2e-3\nnan\n").stdout);
    let change = ("longitudinal = -1.5e-3", "longitudinal = -2e-3");
    let with = ("[solve]", "[damage]\n[solve]");
    let damage = &solved(&place, &[change, with], "fastsim")["damage"];
    for name in ["t_gamma_n", "usfd_rate_ug_per_m_mm2", "wlrm_damage", "surface_fatigue_index"] {
        assert_eq!(number(&table, 0, name), damage[name].as_f64().unwrap().to_bits(), "{name}");
        assert_eq!(cell(&table, 1, name), "");
    }
}

#[test]
fn the_theory_is_the_files_unless_another_is_given() {
    let place = place();
    let input = "normal_force,speed\n80e3,20\n";
    let own = rows(&place.run_on(&["batch", "--case", "case.toml"], input).done());
    let report = solved(&place, &[("[solve]", "speed = 20.0\n[solve]")], "variational");
    let watts = report["frictional_power_w"].as_f64().unwrap().to_bits();
    assert_eq!(number(&own, 0, "frictional_power_w"), watts);
    let force = report["lower_body"]["longitudinal_n"].as_f64().unwrap().to_bits();
    assert_eq!(number(&own, 0, "longitudinal_n"), force);
    let exact =
        ["batch", "--case", "case.toml", "--theory", "exact", "--option", "resolution=fast"];
    let exact = rows(&place.run_on(&exact, input).done());
    assert!(cell(&exact, 0, "fx_error").parse::<f64>().unwrap() > 0.0);
    assert_ne!(number(&exact, 0, "longitudinal_n"), force);
    let orphan = ["batch", "--case", "case.toml", "--option", "degree=5"];
    assert_eq!(place.run_on(&orphan, input).code, Some(2));
}

#[test]
fn radii_and_semi_axes_have_columns() {
    let place = place();
    let radii = "upper_radius_rolling,upper_radius_lateral,lower_radius_rolling,lower_radius_lateral\n\
                 0.46,flat,inf,0.3\n0.5,-0.6,flat,0.3\n";
    let table = rows(&place.run_on(&FASTSIM, radii).done());
    let same = solved(&place, &[], "fastsim")["lower_body"]["longitudinal_n"].as_f64().unwrap();
    assert_eq!(number(&table, 0, "longitudinal_n"), same.to_bits());
    assert_ne!(number(&table, 1, "longitudinal_n"), same.to_bits());
    // Semi-axes stand for the file's radii; one of them alone is no ellipse.
    let axes = "semi_axis_rolling,semi_axis_lateral\n6e-3,5e-3\n6e-3,nan\n";
    let ran = place.run_on(&FASTSIM, axes);
    assert_eq!(ran.code, Some(3));
    let table = rows(&ran.stdout);
    assert_eq!(cell(&table, 0, "status"), "solved");
    assert!(cell(&table, 1, "message").contains("[contact] semi_axis_lateral = NaN"));
    let one = place.run_on(&FASTSIM, "semi_axis_rolling\n6e-3\n");
    one.refused(&["case.toml: [contact] semi_axis_lateral is missing"]);
    let both = place.run_on(&FASTSIM, "semi_axis_rolling,semi_axis_lateral,upper_radius_rolling\n");
    both.refused(&["exclude each other"]);
}

#[test]
fn a_wrong_row_says_why() {
    let place = place();
    let input =
        "longitudinal,normal_force\n1e-3,80e3\nnan,80e3\n1e-3,-1\n1e-3,\n\"1,5\",1\nx,1\n1,2,3\n";
    let ran = place.run_on(&FASTSIM, input);
    assert_eq!(ran.code, Some(3));
    assert!(ran.stderr.contains("7 rows: 1 solved, 6 invalid"), "{}", ran.stderr);
    let table = rows(&ran.stdout);
    for (row, words) in [
        (1, "[creepage] longitudinal = NaN is not valid"),
        (2, "[contact] normal_force = -1 is not valid"),
        (3, "normal_force is empty"),
        (4, "longitudinal = `1,5` is not a number: decimals follow a point"),
        (5, "longitudinal = `x` is not a number"),
        (6, "the row has 3 fields, but the header 2"),
    ] {
        assert_eq!([cell(&table, row, "status"), cell(&table, row, "fx")], ["invalid", ""]);
        assert!(cell(&table, row, "message").contains(words), "{}", cell(&table, row, "message"));
    }
}

#[test]
fn numbers_in_other_units_are_cautions() {
    let place = place();
    let ran = place.run_on(&FASTSIM, "lateral,normal_force\n1e-3,80e3\n2.0,80e3\n1e-3,4e234\n");
    assert!(ran.stderr.contains("caution: 2 rows are beyond any real contact"), "{}", ran.stderr);
    let table = rows(&ran.done());
    assert_eq!(cell(&table, 0, "message"), "");
    assert!(cell(&table, 1, "message").starts_with("the lateral creepage of 2 is above 0.3"));
    assert!(cell(&table, 2, "message").contains("more than 0.3 of the smallest radius, 0.3 m"));
}

#[test]
fn columns_that_are_none_are_refused() {
    let place = place();
    let refused = |input: &str, words: &str| place.run_on(&FASTSIM, input).refused(&[words]);
    refused("xi,eta\n1,1\n", "none of the columns differs from the case file");
    refused("spin,spin\n1,1\n", "column spin is there twice");
    refused("spin,moment_n_m\n1,1\n", "column moment_n_m is there already");
    let wanted = CASE.replace("[creepage]", "[wanted]\nfx = 0.1\n[creepage]");
    place.write("case.toml", wanted);
    refused("spin\n1\n", "section [wanted] asks for a creepage");
    let xi = CASE.replace("longitudinal = -1.5e-3\nlateral = 1e-3\nspin = 0.2", "xi = 1.0");
    place.write("case.toml", &xi);
    refused("spin\n1\n", "[creepage] spin and [creepage] xi exclude each other");
    place.run_on(&FASTSIM, "longitudinal\n1e-3\n").done();
    place.write("case.toml", xi.replace("xi = 1.0", ""));
    refused("normal_force\n1\n", "section [creepage] is missing");
    place.run_on(&FASTSIM, "longitudinal\n1e-3\n").done();
}

#[test]
fn a_table_answers_too() {
    let place = place();
    let build = ["table", "build", "--theory", "fastsim", "--a-over-b", "0.8,2", "--shapes", "3"];
    let small = ["--intervals", "8,12,12", "--places", "50", "--out", "t.nc"];
    place.run(&[&build[..], &small].concat()).done();
    let batch = ["batch", "--case", "case.toml", "--table", "t.nc"];
    let input = "lateral,normal_force\n1e-3,80e3\n1e-3,60e3\n";
    let (by_table, by_theory) =
        (rows(&place.run_on(&batch, input).done()), rows(&place.run_on(&FASTSIM, input).done()));
    for row in 0..2 {
        let [one, two] =
            [&by_table, &by_theory].map(|table| f64::from_bits(number(table, row, "fx")));
        // The error that this table says it has.
        assert!((one - two).abs() < 0.05 && one.to_bits() != two.to_bits(), "{one} {two}");
    }
    // Without dimensions; of what the table has but one, there need be no column.
    let many = ["table", "eval", "t.nc", "--in", "rows.csv"];
    place.write("rows.csv", "xi,eta,chi,a_over_b\n0.5,0,0,1\n0.5,0,0,3\n");
    let ran = place.run(&many);
    assert_eq!(ran.code, Some(3));
    let table = rows(&ran.stdout);
    let eval = ["table", "eval", "t.nc", "--xi", "0.5", "--a-over-b", "1", "--json"];
    let one = json(&place.run(&eval).done());
    assert_eq!(number(&table, 0, "fx"), one["fx"].as_f64().unwrap().to_bits());
    assert!(cell(&table, 1, "message").contains("a_over_b = 3"));
    place
        .run(&["table", "eval", "t.nc", "--xi", "0.5"])
        .refused(&["--a-over-b is needed: the table has values from 0.8 to 2"]);
}

#[test]
fn other_programs_files_are_read() {
    let place = place();
    let plain = place.run_on(&FASTSIM, "lateral,spin\n1e-3,0.1\n").done();
    for (delimiter, above) in [(";", ""), ("\t", "# by a logger\n"), (",", "# one\n# two\n")] {
        let input = format!("{above}lateral,spin\n1e-3,0.1\n").replace(',', delimiter);
        let output = place.run_on(&FASTSIM, input).done();
        assert_eq!(output, format!("{above}{plain}").replace(',', delimiter));
    }
    for bytes in [&b"\xff\xfel\0a\0"[..], b"l\0a\0t\0\n\0"] {
        place.run_on(&FASTSIM, bytes).refused(&["UTF-16"]);
    }
}

/// Rows that come one by one are answered one by one.
#[test]
fn a_row_is_answered_at_once() {
    let place = place();
    let mut child = Command::new(env!("CARGO_BIN_EXE_creepage"))
        .args(FASTSIM)
        .current_dir(place.path(""))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let mut output = BufReader::new(child.stdout.take().unwrap()).lines();
    input.write_all(b"lateral\n").unwrap();
    for row in 0..3 {
        writeln!(input, "{row}e-3").unwrap();
        if row == 0 {
            assert!(output.next().unwrap().unwrap().starts_with("lateral,longitudinal_n"));
        }
        let start = Instant::now();
        assert!(output.next().unwrap().unwrap().starts_with(&format!("{row}e-3,")));
        // A fifth of a second, and a busy machine.
        assert!(start.elapsed() < Duration::from_secs(10));
    }
    drop(input);
    assert!(output.next().is_none() && child.wait().unwrap().success());
}

#[test]
fn a_history_is_the_same_on_any_number_of_cores() {
    let place = place();
    let mut input = "longitudinal,lateral,normal_force\n".to_owned();
    for i in 0..5000 {
        let (angle, load) = (f64::from(i) * 0.618, 5e4 + 10.0 * f64::from(i));
        writeln!(input, "{},{},{load}", 2e-3 * angle.cos(), 2e-3 * angle.sin()).unwrap();
    }
    place.write("in.csv", input);
    let [one, two] = ["1", "2"].map(|threads| {
        let command = [&FASTSIM[..], &["--in", "in.csv", "--option", "grid=[9,9]"]].concat();
        let mut command = place.command(&command);
        Ran::from(command.env("RAYON_NUM_THREADS", threads).output().unwrap()).done()
    });
    assert_eq!(one, two);
    assert_eq!(one.lines().count(), 5001);
}

/// Rows with anything in them: each is answered or says why not, and the rest of the table stands.
#[test]
fn hostile_rows_are_answered_each() {
    let words = [
        "nan",
        "inf",
        "-inf",
        "",
        " ",
        "0",
        "-0",
        "1e300",
        "-1e300",
        "5e-324",
        "1e-3",
        "80e3",
        "0.3",
        "x",
        "1,5",
        "\"a\"\"b\"",
        "0x10",
        "1e",
        "+1",
        "\u{221e}",
        "\u{1f682}",
        "1_000",
        "1e999",
    ];
    let mut state = 1967_u64;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        words[usize::try_from(state >> 33).unwrap() % words.len()]
    };
    let count = 20_000;
    let mut input = "row,longitudinal,lateral,spin,normal_force,friction\n".to_owned();
    for row in 0..count {
        let cells = [next(), next(), next(), next(), next()].join(",");
        writeln!(input, "{row},{cells}").unwrap();
    }
    let place = place();
    let polach = ["batch", "--case", "case.toml", "--theory", "polach"];
    let ran = place.run_on(&polach, input);
    assert_eq!(ran.code, Some(3));
    let mut reader = csv::ReaderBuilder::new().from_reader(ran.stdout.as_bytes());
    let mut solved = 0;
    for (row, record) in reader.records().enumerate() {
        let record = record.unwrap();
        assert_eq!(record[0], row.to_string());
        let (numbers, status) = (&record.iter().collect::<Vec<_>>()[6..13], &record[13]);
        if status == "invalid" {
            assert!(numbers.iter().all(|cell| cell.is_empty()) && !record[14].is_empty());
        } else {
            let finite = |cell: &&str| cell.parse::<f64>().is_ok_and(f64::is_finite);
            assert!(numbers[..3].iter().chain(&numbers[4..]).all(finite), "{record:?}");
            solved += 1;
        }
    }
    assert!(ran.stderr.starts_with(&format!("{count} rows: ")) && solved > 0, "{}", ran.stderr);
}
