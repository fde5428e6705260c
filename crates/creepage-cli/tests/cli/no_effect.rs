//! Keys that would have no effect are refused by their name, and numbers that would be silent in another unit are told.

use crate::place::{Place, example, fastsim};

/// Writes a text, runs a command on it and expects that it is refused in these words.
#[track_caller]
fn refused(command: &[&str], text: &str, said: &[&str]) {
    let place = Place::new();
    place.write("case.toml", text);
    place.run(&[command, &["case.toml"]].concat()).refused(said);
}

#[test]
fn keys_without_an_effect_are_refused() {
    let die = example("statics/die-offset-load.toml");
    let with_friction = die.replace("[contact]", "[contact]\nfriction = 0.3");
    refused(&["statics"], &with_friction, &["[contact] friction", "\"die\""]);
    let wheelset = example("wheelset/s1002-on-uic60.toml");
    let canted = wheelset.replace("[track]", "[track]\nsuperelevation = 0.1");
    refused(&["wheelset"], &canted, &["superelevation", "axle_load"]);
    let points = "points = [[-0.05, 0.0], [0.0, 0.0], [0.05, 0.001]]\nreading = { unit = 0.001 }";
    let own = wheelset.lines().find(|line| line.starts_with("profile = \"S1002\"")).unwrap();
    let of_points = wheelset.replace(own, points);
    refused(&["wheelset"], &of_points, &["[wheel] reading.unit", "points are in metres"]);
    let accuracy = "\n[solve]\nresolution = \"fine\"\naccuracy = 1e-3\n";
    let fixed = example("gap/crowned-roller.toml") + accuracy;
    refused(&["solve"], &fixed, &["accuracy", "auto"]);
    let law = example("wheel-falling-friction.toml")
        .replace("law = \"exponential\"", "law = \"constant\"")
        .replace("terms = ", "# ");
    refused(&["solve"], &law, &["memory_distance", "constant"]);
    let map = wheelset + "\n[solve]\ntheory = \"fastsim\"\n";
    refused(&["map", "--out", "map.nc"], &map, &["[solve] theory other than \"exact\""]);
}

/// What moves in a history stands in its table, and a line has its own elements.
#[test]
fn histories_refuse_what_they_do_not_use() {
    let roll = |case: &str, said: &[&str]| {
        let place = Place::new();
        place.write("case.toml", case);
        place.write("h.csv", example("roll/cylinders.csv"));
        place.run(&["roll", "case.toml", "--history", "h.csv"]).refused(said);
    };
    let moves = "\n[motion]\nupper = { velocity = [1.0, 0.0, 0.0] }\nlower = { velocity = [1.01, 0.0, 0.0] }\n";
    let [gap, ellipse] = ["roll/crowned-roller.toml", "roll/wheel-pulls.toml"].map(example);
    roll(&(gap + moves), &["[motion]", "history"]);
    roll(&(ellipse.clone() + moves), &["[motion]", "history"]);
    let line = Place::new();
    line.write("case.toml", example("roll/cylinders.toml") + "\n[solve]\nresolution = \"fine\"\n");
    line.write("h.csv", example("roll/cylinders.csv"));
    let told = line.run(&["roll", "case.toml", "--history", "h.csv"]).stderr;
    assert!(told.contains("note: [solve] resolution has no effect"), "{told}");
    // 24 kN of friction on an arm of some 4 mm.
    let place = Place::new();
    place.write("case.toml", ellipse);
    for (moment, is_reached) in [("60", true), ("120", false)] {
        let table = format!("distance,moment\n1e-3,{moment}\n");
        let ran = place.run_on(&["roll", "case.toml", "--history", "-"], table);
        assert_eq!(ran.stderr.contains("N m, is not reachable"), !is_reached, "{ran:?}");
        assert_eq!(ran.code == Some(2), !is_reached, "{ran:?}");
    }
}

/// A groove's own slip is in `solve` alone, at one resolution.
#[test]
fn a_groove_is_solved_case_by_case() {
    let groove = example("gap/groove.toml");
    let given = groove
        .replace("[wanted]\nlongitudinal_force = 0.0", "#")
        .replace("[creepage]", "[creepage]\nlongitudinal = 1e-3");
    let place = Place::new();
    place.write("case.toml", &given);
    place
        .run(&["curve", "case.toml", "--vary", "spin"])
        .refused(&["surface = \"curved\"", "curves"]);
    place.write("points.csv", "longitudinal,longitudinal_force\n1e-3,1e3\n2e-3,2e3\n3e-3,2.4e3\n");
    place
        .run(&["fit", "--case", "case.toml", "points.csv"])
        .refused(&["surface = \"curved\"", "fits"]);
    refused(
        &["solve"],
        &given.replace("\"standard\"", "\"auto\""),
        &["surface = \"curved\"", "auto"],
    );
    let three = groove.replace("spin = 0.0", "longitudinal = 1e-3");
    refused(&["solve"], &three, &["at a given lateral creepage and spin"]);
}

#[test]
fn numbers_that_would_be_silent_are_refused_or_told() {
    let layer = "[layer]\nthickness = 1e-5\nshear_modulus = 1e9\nyield_stress = 300\n";
    refused(&["solve"], &(fastsim() + layer), &["[layer]", "yield_stress", "at least 1e3 Pa"]);
    let fast =
        example("wheel-falling-friction.toml").replace("half_speed = 0.1", "half_speed = 360");
    refused(&["solve"], &fast, &["half_speed", "at most 100 m/s"]);
    let worn = example("wheel-wear.toml") + "\n[damage.bre]\nplateau = [-1.0, 200.0]\n";
    refused(&["solve"], &worn, &["bre.plateau", "not negative"]);
    let said = |command: &[&str], text: &str| {
        let place = Place::new();
        place.write("case.toml", text);
        let ran = place.run(&[command, &["case.toml"]].concat());
        assert!(ran.code == Some(0) || ran.code == Some(3), "{ran:?}");
        format!("{}{}", ran.stdout, ran.stderr).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let spins = fastsim().replace("spin = 0.2", "spin = 1e3");
    assert!(said(&["solve"], &spins).contains("in radians per metre rolled"));
    let large = fastsim()
        .replace("0.46", "460.0")
        .replace("radius_lateral = 0.3", "radius_lateral = 300.0");
    assert!(said(&["solve"], &large).contains("radius of the bodies is 300 m"));
    assert!(!said(&["solve"], &fastsim()).contains("radius of the bodies"));
    let turned = example("wheelset/s1002-on-uic60.toml").replace("yaw = 0.0 ", "yaw = 0.2 ");
    let turned = turned + "\n[solve]\ntheory = \"saturated\"\n";
    assert!(said(&["wheelset"], &turned).contains("yaws by 0.2 rad, 11.5 degrees"));
    let guard = example("wheelset/guard-rail.toml");
    assert!(said(&["conicity"], &guard).contains("the guard rail is left out"));
}

/// What a fresh user met: a law of friction lost to a column, heavy rows, forces and moments that nothing gives together.
#[test]
fn what_rows_ask_is_told() {
    let place = Place::new();
    place.write("law.toml", example("wheel-falling-friction.toml"));
    let rows = "longitudinal,friction\n-1e-3,0.3\n";
    place
        .run_on(&["batch", "--case", "law.toml"], rows)
        .refused(&["friction is a law", "leave out the column"]);
    place.write("case.toml", fastsim());
    let said = place.run_on(&["batch", "--case", "case.toml"], "longitudinal,xi\n-1e-3,2\n").stderr;
    assert!(said.contains("column `xi` is not used"), "{said}");
    place.write("heavy.toml", fastsim().replace("80e3", "80e6"));
    let said = place.run(&["hertz", "heavy.toml"]).stderr;
    assert!(said.contains("times the shear yield stress"), "{said}");
    let pulls = example("roll/wheel-pulls.toml").replace("[start]", "#").replace("traction", "#");
    let pulls = pulls.replace("longitudinal_force", "#");
    place.write("pulls.toml", &pulls);
    let roll = |table: &str| place.run_on(&["roll", "pulls.toml", "--history", "-"], table);
    let said = roll("distance,longitudinal,normal_force\n0.002,-1e-3,2000e3\n").stderr;
    assert!(said.contains("row 1") && said.contains("shear yield stress"), "{said}");
    let ran = roll("distance,longitudinal_force,moment\n0.002,-20e3,50\n0.005,-20e3,50\n");
    assert!(ran.code == Some(3) && ran.stderr.contains("did not converge"), "{ran:?}");
}

#[test]
fn fatigue_needs_its_stresses() {
    let wear = example("wheel-wear.toml");
    let with = |line: &str| wear.replace("[damage]", &format!("[damage]\n{line}"));
    refused(&["solve"], &with("dang_van = { limit = 100e6 }"), &["dang_van.limit", "shakedown"]);
    let small = with("shakedown = true\ndang_van = { limit = 200 }");
    refused(&["solve"], &small, &["dang_van.limit", "at least 1e6 Pa"]);
    let die =
        example("statics/die-offset-load.toml").replace("[contact]", "[contact]\nfriction = 0");
    let place = Place::new();
    place.write("die.toml", die);
    place.run(&["statics", "die.toml"]).done();
    place.write("clay.toml", example("statics/clay-sheared.toml"));
    assert!(!place.run(&["statics", "clay.toml"]).stderr.contains("caution"));
}
