//! What stands around the commands: several files, standard input, silence, completions, manual, hints.

use crate::place::{CASE, Place, json};

#[test]
fn several_files_are_solved_one_after_the_other() {
    let place = Place::new();
    place.write("one.toml", CASE);
    place.write("two.toml", CASE.replace("80e3", "60e3"));
    let text = place.run(&["solve", "one.toml", "two.toml", "--theory", "polach", "--out", "out"]);
    let text = text.done();
    let parts: Vec<_> = text.split("== ").collect();
    assert!(parts[1].starts_with("one.toml\n") && parts[2].starts_with("two.toml\n"));
    assert!(parts[1].contains("80 kN") && parts[2].contains("60 kN"));
    assert_eq!(place.files_in("out"), ["one", "two"]);
    let report = place.read("out/two/report.json");
    assert_eq!(json(&report)["contact"]["normal_force_n"], 60e3);
}

#[test]
fn a_dash_is_standard_input() {
    let place = Place::new();
    let by_pipe = place.run_on(&["solve", "-", "--json"], CASE).done();
    place.write("case.toml", CASE);
    assert_eq!(by_pipe, place.run(&["solve", "case.toml", "--json"]).done());
    let rows = "a_over_b,poisson,xi,eta,chi\n1,0.3,1,0,0\n";
    let batch = ["batch", "--theory", "linear"];
    let [with, without] = [&[&batch[..], &["--in", "-"]].concat()[..], &batch]
        .map(|arguments| place.run_on(arguments, rows).done());
    assert_eq!(with, without);
}

#[test]
fn quiet_says_only_what_went_wrong() {
    let place = Place::new();
    place.write("case.toml", CASE.replace("lateral = 1e-3", "lateral = 2.0"));
    let solve = ["solve", "case.toml", "--theory", "polach"];
    let loud = place.run(&[&solve[..], &["--out", "out"]].concat());
    assert!(loud.stderr.contains("wrote") && loud.stderr.contains("caution: the lateral creepage"));
    let quiet = place.run(&[&solve[..], &["--out", "out", "--quiet"]].concat());
    assert_eq!((quiet.code, &quiet.stderr[..]), (Some(0), ""));
    assert_eq!(quiet.stdout, loud.stdout);
    let wrong = place.run(&["-q", "solve", "none.toml"]);
    wrong.refused(&["cannot read none.toml"]);
}

#[test]
fn numbers_in_other_units_are_cautions_everywhere() {
    let place = Place::new();
    let ball = CASE.replace("0.46", "6e-3").replace("\"flat\"\n\n[lower]", "6e-3\n\n[lower]");
    let ball =
        ball.replace("82e9", "82e3").replace("radius_lateral = 0.3", "radius_lateral = \"flat\"");
    place.write("case.toml", ball);
    let words = "of the smallest radius, 0.006 m: check the units";
    let report = place.run(&["solve", "case.toml", "--theory", "polach", "--json"]);
    assert!(report.stderr.contains(words), "{}", report.stderr);
    assert!(json(&report.done())["caution"].as_str().unwrap().contains(words));
    let text = place.run(&["solve", "case.toml", "--theory", "polach"]).done().replace('\n', " ");
    assert!(text.contains("CAUTION:") && text.contains(words), "{text}");
    let hertz = place.run(&["hertz", "case.toml", "--json"]);
    assert!(hertz.stderr.contains(words));
    assert!(json(&hertz.done())["caution"].as_str().unwrap().contains(words));
    assert!(place.run(&["curve", "case.toml", "--theory", "polach"]).stderr.contains(words));
    place.write("case.toml", CASE);
    let plain = json(&place.run(&["hertz", "case.toml", "--json"]).done());
    assert!(plain["caution"].is_null() && plain["approach_m"].is_number());
}

/// Friction in per cent, moduli a thousand times too large, a linear theory far beyond friction: each is a caution, in one file and
/// in rows.
#[test]
fn numbers_that_no_bodies_have_are_cautions() {
    let place = Place::new();
    let cautions = |theory: &str| {
        let ran = place.run(&["solve", "case.toml", "--theory", theory, "--json"]);
        let report = json(&ran.stdout);
        let words = report["caution"].as_str().unwrap_or_default().to_owned();
        let rows = ["batch", "--case", "case.toml", "--theory", theory];
        let rows = place.run_on(&rows, "longitudinal\n0.05\n").done();
        (words, rows)
    };
    place.write("case.toml", CASE.replace("friction = 0.3", "friction = 30"));
    let (words, rows) = cautions("polach");
    for told in [words, rows] {
        assert!(told.contains("friction of 30 is above 2"), "{told}");
    }
    place.write("case.toml", CASE.replace("82e9", "82e12"));
    let (words, rows) = cautions("polach");
    for told in [words, rows] {
        assert!(told.contains("modulus of 82 TPa is above that of diamond"), "{told}");
    }
    let (head, _) = CASE.split_once("[creepage]").unwrap();
    place.write("case.toml", format!("{head}[creepage]\nlongitudinal = 0.05\n"));
    let (words, rows) = cautions("linear");
    for told in [words, rows] {
        assert!(
            told.contains("linear knows no slip") && told.contains("what friction allows"),
            "{told}"
        );
    }
    let (words, rows) = cautions("polach");
    assert!(words.is_empty() && !rows.contains("friction allows"), "{words} {rows}");
}

/// Two balls of 6 mm, whose modulus is in megapascals by mistake.
const SOFT_BALLS: &str = "
[upper]
shear_modulus = 82e3
poisson = 0.28
radius_rolling = 6e-3
radius_lateral = 6e-3
[lower]
shear_modulus = 82e3
poisson = 0.28
radius_rolling = 6e-3
radius_lateral = 6e-3
[contact]
normal_force = 500
friction = 0.3
";

#[test]
fn statics_in_other_units_has_cautions() {
    let place = Place::new();
    let caution = |text: &str| {
        place.write("case.toml", text);
        let ran = place.run(&["statics", "case.toml", "--json"]);
        let report = json(&ran.stdout);
        let words = report["caution"].as_str().unwrap_or_default().to_owned();
        assert_eq!(ran.stderr.contains("caution: "), !words.is_empty(), "{}", ran.stderr);
        let text = place.run(&["statics", "case.toml"]).done();
        assert_eq!(text.contains("CAUTION: "), !words.is_empty(), "{text}");
        words
    };
    let problem =
        |words: &str| format!("{SOFT_BALLS}[statics]\n{words}\n").replace("friction = 0.3", "");
    for words in [
        &format!("{SOFT_BALLS}[statics]\nproblem = \"partial-slip\"\nforce_x = 50\n"),
        &problem("problem = \"shift\"\nforce_x = 1e2"),
        &problem("problem = \"twist\"\nmoment = 0.1"),
    ] {
        let found = caution(words);
        assert!(found.contains("of the smallest radius, 0.006 m: check the units"), "{found}");
        // In pascals the balls are hard, and flow under their load as by `solve`: 5.2 GPa.
        let found = caution(&words.replace("82e3", "82e9"));
        assert!(found.starts_with("the peak pressure of 5.186 GPa is 17.3 times"), "{found}");
        assert!(!found.contains("check the units"), "{found}");
    }
    let die = "[lower]\nshear_modulus = 82e3\npoisson = 0.28\n[contact]\nnormal_force = 1e4\n\
               semi_axis_rolling = 5e-3\nsemi_axis_lateral = 1e-2\n[statics]\nproblem = \"die\"\n";
    let found = caution(die);
    assert!(found.contains("exceeds the shear modulus of 82 kPa: check the units"), "{found}");
    assert_eq!(caution(&die.replace("82e3", "82e9")), "");
}

#[test]
fn shells_and_manuals_know_every_command() {
    let place = Place::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = place.run(&["completions", shell]).done();
        assert!(script.contains("conicity"), "{shell}");
    }
    assert!(place.run(&["man"]).done().contains(".TH creepage 1"));
    place.run(&["man", "--out", "man"]).done();
    let pages = place.files_in("man");
    for page in ["creepage.1", "creepage-batch.1", "creepage-table-build.1"] {
        assert!(pages.contains(&page.to_owned()), "{pages:?}");
    }
    assert!(place.read("man/creepage-batch.1").contains("normal_force"));
}

#[test]
fn a_file_of_another_kind_says_where_it_belongs() {
    let place = Place::new();
    let statics = CASE.split("[creepage]").next().unwrap();
    place
        .write("statics.toml", format!("{statics}[statics]\nproblem = \"shift\"\nforce_x = 1e3\n"));
    place.run(&["solve", "statics.toml"]).refused(&["for `creepage statics`"]);
    place.write("case.toml", CASE);
    place.run(&["statics", "case.toml"]).refused(&["for `creepage solve`"]);
    place.write("wheels.toml", include_str!("../../../../examples/wheelset/s1002-on-uic60.toml"));
    for command in ["solve", "curve", "hertz"] {
        place.run(&[command, "wheels.toml"]).refused(&["for `creepage wheelset`"]);
    }
    place.write(
        "bearing.toml",
        include_str!("../../../../examples/bearing/angular-contact-7208.toml"),
    );
    place.run(&["solve", "bearing.toml"]).refused(&["for `creepage bearing`"]);
}

#[test]
fn messages_name_what_is_needed() {
    let place = Place::new();
    let refused = |old: &str, new: &str, words: &str| {
        place.write("case.toml", CASE.replacen(old, new, 1));
        place.run(&["solve", "case.toml"]).refused(&[words]);
    };
    refused("\"flat\"", "flat", "radius_lateral = flat is not valid: words are written in quotes");
    refused("[lower]", "[upper.x]", "section [lower] is missing");
    refused("poisson = 0.28", "poisson = 1e300", "poisson = 1e300 is not valid");
    place.write("case.toml", CASE.split("[lower]").next().unwrap());
    let needs = "section [lower] is missing: it needs poisson, shear_modulus or young_modulus";
    place.run(&["solve", "case.toml"]).refused(&[needs]);
}

#[test]
fn a_table_takes_the_options_of_its_theory_and_no_others() {
    let place = Place::new();
    let build = |more: &[&str]| {
        let small = ["table", "build", "--intervals", "4,4,4", "--places", "8", "--out", "t.nc"];
        place.run(&[&small[..], more].concat())
    };
    build(&["--theory", "fastsim", "--resolution", "fast"])
        .refused(&["--option: `resolution` is an option of exact, not of fastsim"]);
    build(&["--theory", "fastsim", "--option", "gird=[5,5]"]).refused(&["did you mean `grid`?"]);
    assert!(place.files().is_empty());
    build(&["--theory", "fastsim", "--option", "grid=[20,20]"]).done();
    let info = json(&place.run(&["table", "info", "t.nc", "--json"]).done());
    assert_eq!(info["options"], "grid = [20,20]");
}

#[test]
fn an_example_is_not_written_over() {
    let place = Place::new();
    place.run(&["init", "--out", "case.toml"]).done();
    place.run(&["init", "--out", "case.toml"]).refused(&["cannot write case.toml"]);
    place.run(&["solve", "case.toml"]).done();
    assert_eq!(place.files(), ["case.toml"]);
}
