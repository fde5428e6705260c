//! `creepage solve` with [wanted]: forces in, creepage out.

use serde_json::Value;

use crate::place::{CASE, Place, json};

/// The common case without creepage and theory, with these lines in place of both.
fn case(lines: &str) -> String {
    format!("{}{lines}", &CASE[..CASE.find("[creepage]").unwrap()])
}

fn solved(place: &Place, lines: &str) -> Value {
    place.write("case.toml", case(lines));
    json(&place.run(&["solve", "case.toml", "--json"]).done())
}

const CREEPAGES: [(&str, &str); 3] =
    [("longitudinal", "longitudinal"), ("lateral", "lateral"), ("spin", "spin_rad_per_m")];
const FORCES: [(&str, &str); 3] = [
    ("longitudinal_force", "longitudinal_n"),
    ("lateral_force", "lateral_n"),
    ("moment", "moment_n_m"),
];

/// Lines of a case file that give these quantities their values in a report.
fn lines(names: &[(&str, &str)], values: &Value) -> String {
    names
        .iter()
        .map(|(name, key)| format!("{name} = {}", values[key]))
        .collect::<Vec<_>>()
        .join("\n")
}

#[test]
fn every_mix_of_three_leads_back_to_the_same_case() {
    let place = Place::new();
    let direct = solved(&place, "[creepage]\nlongitudinal = -8e-4\nlateral = 5e-4\nspin = 0.1\n");
    let pick = |names: &[(&'static str, &'static str)], mask: usize| -> Vec<_> {
        (0..3).filter(|k| mask >> k & 1 == 1).map(|k| names[k]).collect()
    };
    for (creepages, forces) in [(6, 1), (5, 2), (4, 3), (4, 5), (3, 4), (2, 5), (1, 6), (0, 7)] {
        let [known, wanted] = [pick(&CREEPAGES, creepages), pick(&FORCES, forces)];
        let back = solved(
            &place,
            &format!(
                "[creepage]\n{}\n[wanted]\n{}",
                lines(&known, &direct["creepage"]),
                lines(&wanted, &direct["lower_body"])
            ),
        );
        let scale = [direct["creepage"]["longitudinal"].as_f64().unwrap().abs(), 0.1];
        for ((_, key), scale) in CREEPAGES.iter().zip([scale[0], scale[0], scale[1]]) {
            let [one, two] =
                [&direct, &back].map(|report| report["creepage"][key].as_f64().unwrap());
            // Forces are met to 1e-7 of mu N; the moment alone tells creepage ten times worse.
            assert!((one - two).abs() < 1e-5 * scale, "{known:?} {wanted:?} {key}: {one} {two}");
        }
    }
}

#[test]
fn dimensionless_quantities_do_as_well_and_the_report_tells_what_was_given() {
    let place = Place::new();
    let report = solved(&place, "[creepage]\neta = 0\nchi = 0.3\n[wanted]\nfx = 0.5\n");
    assert!((report["dimensionless"]["fx"].as_f64().unwrap() - 0.5).abs() < 1e-7);
    assert_eq!(report["known"], serde_json::json!(["eta", "chi", "fx"]));
    let text = place.run(&["solve", "case.toml"]).done();
    let words = |name: &str| {
        let line = text.lines().find(|line| line.trim_start().starts_with(name)).unwrap();
        line.split_whitespace().rev().take(3).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(words("given or found"), ["given", "given", "found"]);
    assert_eq!(words("wanted or found"), ["found", "found", "wanted"]);
}

#[test]
fn an_automatic_resolution_meets_forces_and_accuracy() {
    let place = Place::new();
    let report = solved(
        &place,
        "[creepage]\nlateral = 0\nspin = 0\n[wanted]\nlongitudinal_force = 12e3\n[solve]\n\
         resolution = \"auto\"\naccuracy = 0.002\n",
    );
    assert!((report["lower_body"]["longitudinal_n"].as_f64().unwrap() - 12e3).abs() < 24e3 * 1e-7);
    assert!(report["details"]["fx_error"]["value"].as_f64().unwrap() <= 0.002);
}

/// Must be refused, and leave no file.
#[track_caller]
fn refused(lines: &str, arguments: &[&str], parts: &[&str]) {
    let place = Place::new();
    place.write("case.toml", case(lines));
    place.run(&[&["solve", "case.toml", "--out", "out"], arguments].concat()).refused(parts);
    assert_eq!(place.files(), ["case.toml"]);
}

#[test]
fn forces_beyond_friction_are_refused_with_the_most_that_is_reached() {
    let straight = "[creepage]\nlateral = 0\nspin = 0\n[wanted]\n";
    let most = "longitudinal_force = -30000.0 is not reachable: friction gives at most 24000";
    refused(
        &format!("{straight}longitudinal_force = -30e3\n"),
        &[],
        &["case.toml: [wanted]", most],
    );
    refused(&format!("{straight}fx = 1.01\n"), &[], &["fx = 1.01", "at most 1"]);
    // Together they are beyond friction; with so much spin the lateral force is.
    let both =
        ["[wanted] is not reachable: at most longitudinal_force = ", "lateral_force", "moment"];
    refused("[wanted]\nfx = 0.8\nfy = 0.8\nmz = 0\n", &[], &both);
    let spin = "[creepage]\nxi = 0\nchi = 1e6\n[wanted]\nlateral_force = 12e3\n";
    refused(
        spin,
        &[],
        &["at most lateral_force = ", "was reached, at longitudinal = 0.0, lateral"],
    );
}

#[test]
fn too_little_and_too_much_are_refused() {
    refused("[wanted]\nfx = 0.1\n", &[], &["give 1 of six quantities (fx): exactly three"]);
    refused("[creepage]\nxi = 1\neta = 0\nchi = 0\n[wanted]\nfx = 0.1\n", &[], &["give 4 of six"]);
    refused("[wanted]\nfx = nan\nfy = 0\nmz = 0\n", &[], &["[wanted] fx = NaN"]);
    refused("[wanted]\nforce = 1\n", &[], &["unknown key `force` in [wanted]"]);
}

#[test]
fn only_the_full_theory_finds_creepages() {
    let lines = "[creepage]\nlateral = 0\nspin = 0\n[wanted]\nlongitudinal_force = 1e3\n";
    let words = "[wanted] needs the theory exact: fastsim does not find creepages";
    refused(lines, &["--theory", "fastsim"], &[words]);
    let place = Place::new();
    place.write("case.toml", case(lines));
    place.run(&["curve", "case.toml"]).refused(&["[wanted]", "[creepage]"]);
    place.run(&["hertz", "case.toml"]).done();
}
