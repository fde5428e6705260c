//! `creepage batch`: what goes in comes out, row by row, with the answer appended.

use std::fmt::Write;

use creepage::coulomb::{Exact, Resolution};
use creepage::variational::{Settings, Variational};
use creepage::{Contact, Creepage, Ellipse, Theory};

use crate::place::{Place, Ran};

const HEADER: &str = "a_over_b,poisson,xi,eta,chi\n";
const BATCH: [&str; 3] = ["batch", "--theory", "variational"];

fn batch(input: impl Into<Vec<u8>>) -> Ran {
    Place::new().run_on(&BATCH, input)
}

/// Header and rows of a table without quotes.
fn table(text: &str) -> Vec<Vec<&str>> {
    text.lines().map(|line| line.split(',').collect()).collect()
}

#[test]
fn forces_are_those_of_the_library_to_the_last_bit() {
    let ratios = [0.5, 1.0, 2.0];
    let creepages = [[1.0, 0.5, 0.0], [0.3, -0.2, 1.5], [-2.0, 1e-3, -0.7]];
    let mut input = HEADER.to_owned();
    for ([xi, eta, chi], ratio) in creepages.iter().flat_map(|c| ratios.map(|r| (c, r))) {
        writeln!(input, "{ratio},0.28,{xi},{eta},{chi}").unwrap();
    }
    let output = batch(input).done();
    let rows = table(&output);
    assert_eq!(rows.len(), 10);
    for row in &rows[1..] {
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        let theory = Variational::new(&contact(number(0), number(1)), Settings::default()).unwrap();
        let creepage = Creepage::new(number(2), number(3), number(4)).unwrap();
        let force = theory.solve(creepage).force;
        let printed = [number(5), number(6), number(7)].map(f64::to_bits);
        assert_eq!(printed, [force.fx, force.fy, force.mz].map(f64::to_bits));
        assert_eq!(row[8..], ["solved", ""]);
    }
}

fn contact(a_over_b: f64, poisson: f64) -> Contact {
    Contact::new(Ellipse::from_ratio(a_over_b).unwrap(), poisson).unwrap()
}

/// The same ratio and material, like and unlike.
const UNLIKE: &str = "kappa_over_mu,a_over_b,poisson,xi,eta,chi\n\
                      0,1.3,0.28,0.4,0.1,0.2\n\
                      0.3,1.3,0.28,0.4,0.1,0.2\n\
                      -0.3,1.3,0.28,0.4,0.1,0.2\n\
                      0.001,1.3,0.28,0.4,0.1,0.2\n";

#[test]
fn the_full_theory_counts_unlike_bodies() {
    let command = ["batch", "--theory", "exact", "--option", "resolution=fast"];
    let ran = Place::new().run_on(&command, UNLIKE);
    assert_eq!(ran.stderr, "4 rows: 4 solved\n");
    let output = ran.done();
    for row in &table(&output)[1..] {
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        let unlike = contact(1.3, 0.28).with_kappa_over_mu(number(0)).unwrap();
        let theory = Exact::new(&unlike, Resolution::FAST).unwrap();
        let found = theory.solve(Creepage::new(0.4, 0.1, 0.2).unwrap()).force;
        let printed = [number(6), number(7), number(8)].map(f64::to_bits);
        assert_eq!(printed, [found.fx, found.fy, found.mz].map(f64::to_bits));
        assert_eq!(row[12..], ["solved", ""]);
    }
}

#[test]
fn other_theories_tell_what_they_leave_out_between_unlike_bodies() {
    let ran = Place::new().run_on(&["batch", "--theory", "polach"], UNLIKE);
    assert_eq!(ran.code, Some(0));
    let said = "4 rows: 4 solved\ncaution: 2 rows are of unlike bodies, which the theory takes for";
    assert!(ran.stderr.starts_with(said), "{}", ran.stderr);
    let rows = table(&ran.stdout);
    for (row, told) in rows[1..].iter().zip([false, true, true, false]) {
        assert_eq!(row[6..9], rows[1][6..9]);
        assert_eq!(row[9], "solved");
        let words = format!("polach takes the bodies for like ones (kappa/mu = {}00)", row[0]);
        assert!(row[10].starts_with(&words) == told && row[10].is_empty() != told, "{row:?}");
    }
}

#[test]
fn how_unlike_the_bodies_are_must_be_a_number() {
    for theory in ["exact", "polach"] {
        let rows = ["nan", "1e7", "", "much", "inf"].map(|word| format!("{word},1,0.28,1,0,0\n"));
        let input = format!("kappa_over_mu,{HEADER}{}", rows.concat());
        let ran = Place::new().run_on(&["batch", "--theory", theory], input);
        assert_eq!(ran.code, Some(3));
        let mut reader = csv::Reader::from_reader(ran.stdout.as_bytes());
        let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
        let reasons =
            ["= NaN is not valid", "= 10000000 is", "is empty", "= `much` is", "= inf is"];
        for (row, reason) in rows.iter().zip(reasons) {
            let message = &row[row.len() - 1];
            assert_eq!(&row[row.len() - 2], "invalid");
            assert!(message.contains(&format!("kappa_over_mu {reason}")), "{message}");
        }
    }
    let twice = format!("kappa_over_mu,kappa_over_mu,{HEADER}");
    batch(twice).refused(&["column kappa_over_mu is there twice"]);
}

#[test]
fn columns_stand_in_any_order_and_others_pass_through() {
    let input = "id,chi, eta ,note,xi,poisson,a_over_b\n\
                 7,0,0.5,\"a, \"\"quoted\"\"\nnote\",1,0.28,1\n\
                 8,0,0.5,  spaces  ,1.0, 0.28 ,1e0\n";
    let output = batch(input).done();
    let straight = batch(format!("{HEADER}1,0.28,1,0.5,0\n")).done();
    let answer = straight.lines().nth(1).unwrap().strip_prefix("1,0.28,1,0.5,0,").unwrap();
    let expected = format!(
        "id,chi, eta ,note,xi,poisson,a_over_b,fx,fy,mz,status,message\n\
         7,0,0.5,\"a, \"\"quoted\"\"\nnote\",1,0.28,1,{answer}\n\
         8,0,0.5,  spaces  ,1.0, 0.28 ,1e0,{answer}\n"
    );
    assert_eq!(output, expected);
}

#[test]
fn a_wrong_row_says_why_and_the_rest_go_on() {
    let wrong = [
        ("0,0.28,1,0,0", "a_over_b = 0 is not valid"),
        ("nan,0.28,1,0,0", "a_over_b = NaN is not valid"),
        ("1,0.6,1,0,0", "poisson = 0.6 is not valid: it must be between 0 and 0.5"),
        ("1,0.28,inf,0,0", "xi = inf is not valid: it must be between -1e100 and 1e100"),
        ("1,0.28,1,NaN,0", "eta = NaN is not valid"),
        ("1,0.28,1,0,fast", "chi = `fast` is not a number"),
        ("1,,1,0,0", "poisson is empty"),
        ("1,0.28,1,0", "the row has 4 fields, but the header 5"),
        ("1,0.28,1,0,0,9", "the row has 6 fields, but the header 5"),
    ];
    let good = "1,0.28,1,0,0\n";
    let lines = wrong.map(|(line, _)| format!("{line}\n")).join(good);
    let ran = batch(format!("{HEADER}{good}{lines}{good}"));
    assert_eq!(ran.code, Some(3));
    assert!(ran.stderr.contains("19 rows: 10 solved, 9 invalid"), "{}", ran.stderr);
    let mut reader = csv::Reader::from_reader(ran.stdout.as_bytes());
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 19);
    for (i, row) in rows.iter().enumerate() {
        if i % 2 == 0 {
            assert_eq!(&row[8], "solved");
        } else {
            let (line, reason) = wrong[i / 2];
            assert_eq!([&row[5], &row[6], &row[7], &row[8]], ["", "", "", "invalid"]);
            assert!(row[9].contains(reason), "{line}: {}", &row[9]);
        }
    }
}

#[test]
fn extreme_numbers_give_an_answer_or_a_reason_but_no_nan() {
    let extremes =
        ["0", "-0.0", "1e-300", "1e-6", "1", "1e6", "1e100", "-1e100", "1e308", "-1e308"];
    let mut input = HEADER.to_owned();
    for (ratio, creepage) in extremes.iter().flat_map(|r| extremes.map(|c| (r, c))) {
        writeln!(input, "{ratio},0.28,{creepage},1,1").unwrap();
        writeln!(input, "{ratio},0.5,1,1,{creepage}").unwrap();
    }
    let ran = batch(input);
    assert_eq!(ran.code, Some(3));
    for row in &table(&ran.stdout)[1..] {
        let finite = |text: &&str| text.parse::<f64>().is_ok_and(f64::is_finite);
        assert!(row[8] == "invalid" || row[5..8].iter().all(finite), "{row:?}");
    }
}

#[test]
fn no_input_at_all_is_refused() {
    batch("").refused(&["standard input: the input is empty", "a_over_b"]);
    batch("\n\n").refused(&["the input is empty"]);
}

#[test]
fn a_header_alone_gives_a_header() {
    let ran = batch(HEADER.trim_end());
    assert!(ran.stderr.contains("0 rows"));
    assert_eq!(ran.done(), "a_over_b,poisson,xi,eta,chi,fx,fy,mz,status,message\n");
}

#[test]
fn wrong_columns_are_refused_and_leave_no_file() {
    let place = Place::new();
    let batch = |header: &str| {
        let command = [&BATCH[..], &["--out", "out.csv"]].concat();
        place.run_on(&command, format!("{header}\n1,2,3,4,5,6\n"))
    };
    batch("a_over_b,poisson,xi,eta").refused(&["column chi is missing"]);
    batch("a,b,c").refused(&["column a_over_b is missing"]);
    batch("a_over_b,poisson,xi,eta,chi,xi").refused(&["column xi is there twice"]);
    batch("a_over_b,poisson,xi,eta,chi,fx").refused(&["column fx is there already"]);
    assert!(place.files().is_empty());
}

#[test]
fn files_from_other_systems_read_alike() {
    let expected = batch(format!("{HEADER}1,0.28,1,0,0\n2,0.3,0,1,0\n")).done();
    let crlf = "a_over_b,poisson,xi,eta,chi\r\n1,0.28,1,0,0\r\n2,0.3,0,1,0\r\n";
    assert_eq!(batch(crlf).done(), expected);
    assert_eq!(batch(format!("\u{feff}{crlf}")).done(), expected);
    assert_eq!(batch(crlf.replace("\r\n2", "\r\n\r\n2").trim_end()).done(), expected);
    let latin = [b"name,", HEADER.as_bytes(), b"\xe9t\xe9,1,0.28,1,0,0\n"].concat();
    let output = Place::new().command(&BATCH).write_stdin(latin).output().unwrap();
    assert!(output.stdout.windows(8).any(|bytes| bytes == b"\n\xe9t\xe9,1,0"));
}

#[test]
fn a_file_is_not_replaced_by_its_own_result() {
    let place = Place::new();
    place.write("cases.csv", format!("{HEADER}1,0.28,1,0,0\n"));
    let (files, cases) = (place.files(), place.read("cases.csv"));
    let command = [&BATCH[..], &["--in", "cases.csv", "--out", "cases.csv"]].concat();
    place.run(&command).refused(&["cases.csv would be written over what was read"]);
    assert_eq!((place.files(), place.read("cases.csv")), (files, cases));
}

#[test]
fn a_table_with_wrong_rows_still_becomes_a_whole_file() {
    let place = Place::new();
    let command = [&BATCH[..], &["--out", "out.csv"]].concat();
    let ran = place.run_on(&command, format!("{HEADER}x,0.28,1,0,0\n"));
    assert_eq!((ran.code, &ran.stdout[..]), (Some(3), ""));
    assert_eq!(place.files(), ["out.csv"]);
    assert!(place.read("out.csv").contains("a_over_b = `x` is not a number"));
}

#[cfg(unix)]
#[test]
fn a_pipe_is_written_to_in_place() {
    use std::os::unix::fs::FileTypeExt;
    let place = Place::new();
    let pipe = place.path("pipe");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || std::fs::read_to_string(pipe).unwrap()
    });
    let command = [&BATCH[..], &["--out", "pipe"]].concat();
    place.run_on(&command, format!("{HEADER}1,0.28,1,0,0\n")).done();
    assert_eq!(reader.join().unwrap().lines().count(), 2);
    assert!(std::fs::metadata(pipe).unwrap().file_type().is_fifo());
    assert_eq!(place.files(), ["pipe"]);
}

#[test]
fn the_full_theory_adds_its_error_bars() {
    let command = ["batch", "--theory", "exact", "--option", "resolution=fast"];
    let ran = Place::new().run_on(&command, format!("{HEADER}1.5,0.28,0.4,-0.2,0.7\nx,0,0,0,0\n"));
    let rows = table(&ran.stdout);
    let errors = ["fx_error", "fy_error", "mz_error"];
    assert_eq!(rows[0][5..], [&["fx", "fy", "mz"], &errors[..], &["status", "message"]].concat());
    let theory = Exact::new(&contact(1.5, 0.28), Resolution::FAST).unwrap();
    let creepage = Creepage::new(0.4, -0.2, 0.7).unwrap();
    let found = theory.solve(creepage);
    let expected = [found.force, found.error.unwrap()].map(|f| f.components()).concat();
    for (cell, expected) in rows[1][5..11].iter().zip(expected) {
        assert_eq!(cell.parse::<f64>().unwrap().to_bits(), expected.to_bits());
    }
    assert_eq!(rows[2][5..12], ["", "", "", "", "", "", "invalid"]);
    let taken = Place::new().run_on(&command, "a_over_b,poisson,xi,eta,chi,fx_error\n");
    taken.refused(&["column fx_error is there already"]);
}

#[test]
fn options_reach_the_theory() {
    let input = format!("{HEADER}0.8,0.28,0.5,0.1,0.3\n");
    let batch = |theory: &str, options: &[&str]| {
        let options: Vec<_> = options.iter().flat_map(|option| ["--option", option]).collect();
        let command = [&["batch", "--theory", theory], &options[..]].concat();
        Place::new().run_on(&command, input.clone()).done()
    };
    for (theory, option) in [
        ("variational", "degree=5"),
        ("variational", "weight = \"uniform\""),
        ("fastsim", "grid=[10, 10]"),
        ("fastsim", "bound=parabolic"),
        ("fastrip", "variant=original"),
        ("exact", "resolution=fine"),
        ("exact", "resolution=[30, 20]"),
    ] {
        assert_ne!(batch(theory, &[option]), batch(theory, &[]), "{option}");
    }
    let standard = batch("exact", &[]);
    let numbers: Vec<_> = standard.lines().nth(1).unwrap().split(',').collect();
    let bar = |column: usize| numbers[column].parse::<f64>().unwrap();
    let accuracy = format!("accuracy={}", bar(8).max(bar(9)));
    assert_eq!(standard, batch("exact", &["resolution=auto", &accuracy]));
}

#[test]
fn wrong_options_are_refused_before_a_row_is_read() {
    let place = Place::new();
    let refused = |options: &[&str], parts: &[&str]| {
        let options: Vec<_> = options.iter().flat_map(|option| ["--option", option]).collect();
        let command =
            [&["batch", "--theory", "fastsim", "--out", "out.csv"], &options[..]].concat();
        place.run_on(&command, format!("{HEADER}1,0.28,1,0,0\n")).refused(parts);
    };
    refused(&["gird=[9, 9]"], &["--option", "unknown key `gird`", "did you mean `grid`?"]);
    refused(&["grid=9"], &["--option: grid = 9 is not valid for fastsim"]);
    refused(&["grid=[0, 9]"], &["--option: grid", "0"]);
    refused(&["degree=3"], &["--option: `degree` is an option of variational, not of fastsim"]);
    refused(&["bound=round"], &["--option", "round", "elliptic"]);
    refused(&["bound"], &["--option", "bound"]);
    refused(&["grid=[9, 9]", "grid=[8, 8]"], &["--option", "duplicate"]);
    refused(&["theory=linear"], &["--option: `theory` is not an option of a theory"]);
    assert!(place.files().is_empty());
}

#[test]
fn an_interrupted_run_leaves_the_earlier_result() {
    let place = Place::new();
    place.write("out.csv", "earlier");
    let command = [&BATCH[..], &["--out", "out.csv"]].concat();
    let mut first = std::process::Command::new(env!("CARGO_BIN_EXE_creepage"))
        .args(&command)
        .current_dir(place.path(""))
        .stdin(std::process::Stdio::piped())
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    // The table opens when its header is read; its rows never come.
    let mut rows = first.stdin.take().unwrap();
    std::io::Write::write_all(&mut rows, HEADER.as_bytes()).unwrap();
    while place.files().len() < 2 {
        assert!(first.try_wait().unwrap().is_none(), "it ended by itself");
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    first.kill().unwrap();
    first.wait().unwrap();
    assert_eq!(place.read("out.csv"), "earlier");
    // Another run is not disturbed by what the kill left.
    place.run_on(&command, format!("{HEADER}1,0.28,1,0,0\n")).done();
    assert_eq!(place.read("out.csv").lines().count(), 2);
}

/// Rows over several ratios, each with its number, some of them wrong.
fn many_rows(count: usize) -> String {
    let mut input = format!("row,{HEADER}");
    for i in 0..count {
        let ratio = [0.3, 0.7, 1.0, 1.9, 4.0][i % 5];
        let angle = i as f64 * 0.618;
        let [xi, eta] = [2.0 * angle.cos(), 2.0 * angle.sin()];
        let chi =
            if i % 1000 == 999 { "?".to_owned() } else { format!("{}", (i % 7) as f64 / 3.0) };
        writeln!(input, "{i},{ratio},0.28,{xi},{eta},{chi}").unwrap();
    }
    input
}

#[test]
fn twenty_thousand_rows_keep_their_order_on_any_number_of_cores() {
    let place = Place::new();
    place.write("in.csv", many_rows(20_000));
    let [one, two] = ["1", "2"].map(|threads| {
        let command = [&BATCH[..], &["--in", "in.csv", "--out", "out.csv"]].concat();
        let mut command = place.command(&command);
        let ran = Ran::from(command.env("RAYON_NUM_THREADS", threads).output().unwrap());
        assert_eq!(ran.code, Some(3), "{}", ran.stderr);
        assert!(ran.stderr.starts_with("20000 rows: ") && ran.stderr.contains("20 invalid"));
        place.read("out.csv")
    });
    assert_eq!(one, two);
    for (i, row) in table(&one)[1..].iter().enumerate() {
        assert_eq!(row[0], i.to_string());
        assert_eq!(row[9] == "invalid", i % 1000 == 999, "{row:?}");
    }
}

/// An unknown column is copied; one that looks like a misspelt known one carries a caution.
#[test]
fn a_misspelt_column_is_told() {
    let place = Place::new();
    place.write("case.toml", include_str!("../../src/example.toml"));
    let rows = ["batch", "--case", "case.toml", "--theory", "polach"];
    for (own, meant) in [("longitudnal", "longitudinal"), ("Longitudinal", "longitudinal")] {
        let ran = place.run_on(&rows, format!("{own},lateral\n0.001,0\n"));
        let told = format!("column `{own}` is not used");
        assert!(ran.stderr.contains(&told) && ran.stderr.contains(meant), "{}", ran.stderr);
    }
    let ran = place.run_on(&rows, "time,run,longitudinal,lateral\n1,2,0.001,0\n");
    assert!(!ran.stderr.contains("caution"), "{}", ran.stderr);
}

#[test]
fn an_open_quote_in_the_header_is_refused() {
    let place = Place::new();
    let command = [&BATCH[..], &["--out", "out.csv"]].concat();
    let words = "a quote that is opened in the header is not closed on its line";
    for (header, row) in [
        ("a_over_b,poisson,xi,eta,chi,\"note\n", "1,0.28,1,0,0,a\n"),
        ("a_over_b,poisson,xi,eta,chi,\"note\r\n", "1,0.28,1,0,0,a\r\n"),
        ("\"no\nte\",a_over_b,poisson,xi,eta,chi\n", "a,1,0.28,1,0,0\n"),
        ("a_over_b,poisson,xi,eta,chi,\"note", ""),
    ] {
        place.run_on(&command, format!("{header}{row}")).refused(&["standard input: ", words]);
    }
    assert!(place.files().is_empty());
    let closed = "a_over_b,poisson,xi,eta,chi,\"note, \"\"a\"\"\"\n1,0.28,1,0,0,a\n";
    assert_eq!(place.run_on(&BATCH, closed).done().lines().count(), 2);
}

/// Rows within a field are not answered: not all is done, though each row that is left is a case.
#[test]
fn rows_that_an_open_quote_takes_are_not_done() {
    let [a, b] = ["1,0.28,1,0,0,a\n", "1,0.28,1,0,0,b\n"];
    let last = "a_over_b,poisson,xi,eta,chi,note\n";
    let [c, d] = ["c,1,0.28,1,0,0\n", "d\",1,0.28,1,0,0\n"];
    for (input, rows) in [
        (format!("{last}1,0.28,1,0,0,\"a\n{a}{b}"), "1 rows: 1 solved"),
        (format!("{last}{a}1,0.28,1,0,0,\"a\n{b}"), "2 rows: 2 solved"),
        (format!("note,{HEADER}\"{c}\"{d}"), "1 rows: 1 solved"),
    ] {
        let ran = batch(input);
        assert_eq!(ran.code, Some(3), "{}", ran.stderr);
        assert!(ran.stderr.contains(rows), "{}", ran.stderr);
        assert!(ran.stderr.contains("1 row has a field that holds other rows"), "{}", ran.stderr);
    }
    // A note of several lines is one.
    let ran = batch(format!("{last}1,0.28,1,0,0,\"a, b\nc, d\"\n{b}"));
    assert!(!ran.stderr.contains("caution"), "{}", ran.stderr);
    assert_eq!(ran.code, Some(0));
}

/// An open quote takes the rows below it for one field, which is told.
#[test]
fn an_open_quote_is_told() {
    let ran = batch(format!("{HEADER}1,0.28,1,0,0\n1,0.28,\"1,0,0\n1,0.28,1,0,0\n1,0.28,1,0,0\n"));
    assert!(ran.stderr.contains("is a quote left open?"), "{}", ran.stderr);
    let ran = batch(format!("{HEADER}1,0.28,1,0,0\n"));
    assert!(!ran.stderr.contains("quote"), "{}", ran.stderr);
}
