//! `creepage roll` on good and bad input.

use std::fs;
use std::path::Path;

use crate::place::{CASE, Place};

const COLUMNS: &str = "distance_m,xi,eta,chi,fx,fy,mz,longitudinal_n,lateral_n,moment_n_m,\
                       adhesion_share,status";

fn example(name: &str) -> String {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/roll");
    fs::read_to_string(examples.join(name)).unwrap()
}

/// The case of the other commands without its creepage, and few elements.
fn case() -> String {
    let end = CASE.find("[creepage]").unwrap();
    format!("{}[solve]\nresolution = [8, 8]\n", &CASE[..end])
}

/// A column of the result.
fn column(csv: &str, name: &str) -> Vec<f64> {
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some(COLUMNS));
    let place = COLUMNS.split(',').position(|column| column == name).unwrap();
    lines.map(|line| line.split(',').nth(place).unwrap().parse().unwrap()).collect()
}

fn rolled(case: &str, history: &str) -> String {
    let place = Place::new();
    place.write("case.toml", case);
    place.write("h.csv", history);
    place.run(&["roll", "case.toml", "--history", "h.csv"]).done()
}

#[test]
fn one_row_a_row_of_the_history() {
    let csv = rolled(&case(), "distance,longitudinal,eta\n0.002,-1e-3,0.1\n0.02,-1e-3,0.1\n");
    assert_eq!(column(&csv, "distance_m"), [0.002, 0.02]);
    let (fx, newtons) = (column(&csv, "fx"), column(&csv, "longitudinal_n"));
    assert!(fx[1] < fx[0] && fx[0] < 0.0, "{csv}");
    // mu N.
    assert!((newtons[1] / fx[1] - 24e3).abs() < 1e-6 * 24e3);
    assert!(csv.lines().skip(1).all(|line| line.ends_with(",solved")), "{csv}");
}

/// A force that sets in at once shifts the bodies before they roll.
#[test]
fn a_history_of_forces_gives_creepages() {
    let history = "distance,longitudinal_force,lateral_force\n0.003,-9e3,1e3\n0.06,-9e3,1e3\n";
    let csv = rolled(&case(), history);
    assert!(column(&csv, "longitudinal_n").iter().all(|force| (force + 9e3).abs() < 1.0), "{csv}");
    assert!(column(&csv, "xi").iter().all(|xi| *xi < 0.0), "{csv}");
}

/// What is steady stays so; the forces of a shift fade without creepage.
#[test]
fn starts_differ() {
    let history = "distance,xi\n0.001,0.4\n0.004,0.4\n";
    let with = |start: &str| format!("{}\n[start]\n{start}\n", case());
    let steady = column(&rolled(&with("traction = \"steady\""), history), "fx");
    assert!((steady[0] - steady[1]).abs() < 1e-6, "{steady:?}");
    let shift = with("traction = \"shift\"\nlongitudinal_force = 12e3");
    let fading = column(&rolled(&shift, "distance\n0.0001\n0.01\n0.1\n"), "fx");
    assert!(fading[0] > 0.45 && fading[1] < 0.4 && fading[2].abs() < 0.01, "{fading:?}");
}

#[test]
fn the_load_goes_to_zero_and_back() {
    // The bodies meet again within a hundredth of a millimetre.
    let history = "distance,xi,normal_force\n0.005,0.5,80e3\n0.006,0.5,0\n0.00601,0.5,80e3\n\
                   0.01101,0.5,80e3\n";
    for solve in ["resolution = [8, 8]", "theory = \"fastsim\""] {
        let csv = rolled(&case().replace("resolution = [8, 8]", solve), history);
        let fx = column(&csv, "fx");
        assert!(fx[1] == 0.0 && (fx[0] - fx[3]).abs() < 0.01, "{fx:?}");
    }
}

#[test]
fn the_examples_roll() {
    for (name, history) in [
        ("wheel-pulls.toml", "pulls.csv"),
        ("cylinders.toml", "cylinders.csv"),
        ("crowned-roller.toml", "crowned-roller.csv"),
    ] {
        let csv = rolled(&example(name), &example(history));
        assert!(csv.lines().skip(1).all(|line| line.ends_with(",solved")), "{name}: {csv}");
    }
}

#[test]
fn a_directory_gets_the_table_and_the_pictures() {
    let place = Place::new();
    place.write("case.toml", case());
    place.write("h.csv", "distance,xi\n0.002,0.4\n0.004,0.4\n");
    let printed = place.run(&["roll", "case.toml", "--history", "h.csv"]).done();
    place.run(&["roll", "case.toml", "--history", "h.csv", "--out", "out"]).done();
    assert_eq!(place.read("out/history.csv"), printed);
    let pictures = ["adhesion.png", "adhesion.svg", "history.csv", "history.png", "history.svg"];
    assert_eq!(place.files_in("out"), [&pictures[..], &["rolling.png"]].concat());
}

/// The animation's number of pictures and of rounds, by the chunk that an APNG has.
fn animation(png: &[u8]) -> [u32; 2] {
    let at = png.windows(4).position(|four| four == b"acTL").unwrap() + 4;
    [at, at + 4].map(|at| u32::from_be_bytes(png[at..at + 4].try_into().unwrap()))
}

#[test]
fn the_animation_has_a_hundred_rows_at_most_and_none_without_traction() {
    let place = Place::new();
    place.write("case.toml", case());
    for (rows, pictures) in [(3, 3), (100, 100), (150, 100)] {
        let row = |k: u32| format!("{},{}\n", 5e-4 * f64::from(k), 0.3 + 0.1 * f64::from(k % 9));
        place.write("h.csv", format!("distance,xi\n{}", (1..=rows).map(row).collect::<String>()));
        place.run(&["roll", "case.toml", "--history", "h.csv", "--out", "out"]).done();
        let png = fs::read(place.path("out").join("rolling.png")).unwrap();
        assert_eq!(animation(&png), [pictures, 0]); // round and round
        assert!(png.len() < 1_000_000, "{}", png.len());
    }
}

/// A line contact has its traction as a curve; FASTSIM has no elements to show.
#[test]
fn a_line_is_animated_too() {
    let place = Place::new();
    place.write("case.toml", example("cylinders.toml"));
    place.write("h.csv", example("cylinders.csv"));
    place.run(&["roll", "case.toml", "--history", "h.csv", "--out", "out"]).done();
    assert_eq!(animation(&fs::read(place.path("out").join("rolling.png")).unwrap()), [4, 0]);
    place.write("case.toml", case().replace("resolution = [8, 8]", "theory = \"fastsim\""));
    place.write("h.csv", "distance,xi\n0.002,0.4\n");
    place.run(&["roll", "case.toml", "--history", "h.csv", "--out", "fast"]).done();
    assert_eq!(place.files_in("fast"), ["history.csv", "history.png", "history.svg"]);
}

#[track_caller]
fn refused(case: &str, history: &str, parts: &[&str]) {
    let place = Place::new();
    place.write("case.toml", case);
    place.write("h.csv", history);
    place.run(&["roll", "case.toml", "--history", "h.csv", "--out", "out"]).refused(parts);
    assert!(!place.path("out").exists());
}

/// FASTSIM forgets within a contact length, and ends at its steady force.
#[test]
fn fastsim_ends_at_its_steady_force() {
    let fastsim = case().replace("resolution = [8, 8]", "theory = \"fastsim\"\ngrid = [50, 50]");
    let history = "distance,longitudinal,spin\n1e-3,-1e-3,0.2\n0.04,-1e-3,0.2\n0.05,-1e-3,0.2\n";
    let csv = rolled(&fastsim, history);
    let place = Place::new();
    let steady =
        fastsim.replace("[solve]", "[creepage]\nlongitudinal = -1e-3\nspin = 0.2\n[solve]");
    place.write("case.toml", steady);
    let report: serde_json::Value =
        serde_json::from_str(&place.run(&["solve", "case.toml", "--json"]).done()).unwrap();
    for name in ["fx", "fy", "mz"] {
        let (rolled, steady) =
            (column(&csv, name), report["dimensionless"][name].as_f64().unwrap());
        // Steps of finite length: one part in a thousand of mu N, as its own documentation has it.
        assert!((rolled[1] - steady).abs() < 1e-3, "{name} {rolled:?} {steady}");
        assert!((rolled[1] - rolled[2]).abs() < 1e-9, "{name} {rolled:?}");
    }
    let fx = column(&csv, "fx");
    assert!(fx[0] < 0.0 && fx[0] > 0.8 * fx[1], "{fx:?}");
    let shift = format!("{fastsim}[start]\ntraction = \"shift\"\n");
    refused(&shift, "distance\n1\n", &["shift", "fastsim"]);
}

/// A wheel that pulls under a load that grows.
#[test]
fn fastsim_meets_forces() {
    let fastsim = case().replace("resolution = [8, 8]", "theory = \"fastsim\"");
    let history = "distance,longitudinal_force,normal_force\n0.005,-9e3,80e3\n0.01,-30e3,160e3\n";
    let csv = rolled(&fastsim, history);
    let newtons = column(&csv, "longitudinal_n");
    // To 1e-9 of the friction force, 24 kN.
    assert!((newtons[0] + 9e3).abs() < 1e-3 && (newtons[1] + 30e3).abs() < 1e-3, "{csv}");
}

/// Areas of any shape, rolled for long, roll as `creepage solve` has it; their pictures show them.
#[test]
fn any_shape_ends_at_its_steady_force() {
    let case = example("crowned-roller.toml") + "\n[solve]\nresolution = \"fast\"\n";
    let place = Place::new();
    place.write("case.toml", &case);
    place.write("h.csv", "distance,longitudinal,spin\n0.002,5e-4,0.1\n0.08,5e-4,0.1\n");
    place.run(&["roll", "case.toml", "--history", "h.csv", "--out", "out"]).done();
    let csv = place.read("out/history.csv");
    let steady = case.replace("[solve]", "[creepage]\nlongitudinal = 5e-4\nspin = 0.1\n[solve]");
    place.write("case.toml", steady);
    let report: serde_json::Value =
        serde_json::from_str(&place.run(&["solve", "case.toml", "--json"]).done()).unwrap();
    let fx = column(&csv, "longitudinal_n");
    let of = |key: &str| report["lower_body"][key].as_f64().unwrap();
    // The error bar of steady rolling is that of fewer elements.
    assert!(
        (fx[1] - of("longitudinal_n")).abs() < 2.0 * of("longitudinal_error_n"),
        "{csv} {report}"
    );
    assert!(fx[0] < 0.8 * fx[1], "{csv}");
    assert_eq!(animation(&fs::read(place.path("out").join("rolling.png")).unwrap()), [2, 0]);
}

#[test]
fn what_any_shape_has_not_is_refused() {
    let (case, history) = (example("crowned-roller.toml"), "distance,xi\n0.01,0.2\n");
    let with = |text: &str| format!("{case}\n{text}\n");
    refused(&case, "distance,normal_force\n1,1\n", &["normal_force", "[gap]", "one load"]);
    refused(&with("[solve]\ntheory = \"fastsim\""), history, &["[gap]", "fastsim"]);
    refused(&with("[solve]\ntheory = \"linear\""), history, &["linear", "steady"]);
    refused(&with("[solve]\nresolution = \"auto\""), history, &["auto"]);
    refused(&with("[wanted]\nlateral_force = 1"), history, &["[wanted]"]);
    refused(&with("[damage]\nhardness = 1e9"), history, &["[damage]"]);
    refused(&case.replace("radius", "x"), "distance,xii\n1,1\n", &["xii"]);
    refused(&case.replace("[gap]", "[gap]\nsection = \"none.csv\""), history, &["section"]);
}

#[test]
fn wrong_tables_are_refused_and_nothing_is_written() {
    let case = case();
    for (history, parts) in [
        ("", &["distance"][..]),
        ("distance,xi\n", &["no rows"]),
        ("xi\n1\n", &["distance is missing"]),
        ("distance,xi,longitudinal\n1,1,1\n", &["xi", "longitudinal", "exclude"]),
        ("distance,xi,xi\n1,1,1\n", &["column xi is there twice"]),
        ("distance,distance\n1,1\n", &["column distance is there twice"]),
        ("distance;xi\n0,1;0,1\n0,2;x\n", &["row 2", "xi = `x`"]),
        ("distance\txi\n1\t0\n2\tx\n", &["row 2", "xi = `x`"]),
        ("distance,lateral_force,lateral\n1,1,1\n", &["lateral_force", "lateral"]),
        ("distance,latteral\n1,1\n", &["latteral", "did you mean `lateral`"]),
        ("distance,xi\n1\n", &["row 1", "fields"]),
        ("distance,xi\n1,a\n", &["row 1", "xi", "`a`"]),
        ("distance,xi\n1,nan\n", &["row 1", "xi"]),
        ("distance,xi\n1,0\n1,0\n", &["row 2", "distance = 1", "greater than 1"]),
        ("distance,xi\n-1,0\n", &["row 1", "distance = -1"]),
        ("distance,longitudinal_force\n1,25e3\n", &["row 1", "24000"]),
        ("distance,normal_force\n1,-1\n", &["row 1", "normal_force = -1"]),
    ] {
        refused(&case, history, parts);
    }
}

#[test]
fn wrong_cases_are_refused() {
    let history = "distance,xi\n1,0\n";
    refused(CASE, history, &["[creepage]"]);
    let with = |text: &str| format!("{}\n{text}\n", case());
    refused(&with("[wanted]\nfx = 0.1"), history, &["[wanted]"]);
    refused(&with("[start]\ntraction = \"some\""), history, &["some"]);
    refused(&with("[start]\nlongitudinal_force = 1"), history, &["[start]", "longitudinal_force"]);
    let far = with("[start]\ntraction = \"shift\"\nlateral_force = 25e3");
    refused(&far, history, &["[start]", "24000"]);
    let other = case().replace("resolution = [8, 8]", "theory = \"polach\"");
    refused(&other, history, &["polach"]);
    let both = case().replace("friction", "line_load = 1e6\nfriction");
    refused(&both, history, &["normal_force", "line_load"]);
    let line = example("cylinders.toml").replace("length = 0.2", "");
    refused(&line, history, &["xi", "length"]);
    refused(&example("cylinders.toml"), "distance,spin\n1,0\n", &["spin", "line contact"]);
}

/// Forces do not ask for a length.
#[test]
fn a_line_without_length_rolls_at_a_force() {
    let line = example("cylinders.toml").replace("length = 0.2", "");
    let csv = rolled(&line, "distance,longitudinal_force\n0.05,192e3\n");
    // Carter: fx = xi (8 - xi) / 16 at .64.
    assert!((column(&csv, "xi")[0] - 1.6).abs() < 0.01, "{csv}");
}

/// Three times as many rows as are rolled before the state is first written, after two seconds.
fn long_history() -> String {
    let row =
        |k: u32| format!("{},{}\n", 2e-5 * f64::from(k), 0.4 + 0.3 * (0.01 * f64::from(k)).sin());
    let rows: String = (1..=8_000).map(row).collect();
    format!("distance,xi\n{rows}")
}

fn long_roll(out: &str) -> [&str; 6] {
    ["roll", "case.toml", "--history", "h.csv", "--out", out]
}

/// Rolls into `out`, killed once the state is on the disk.
fn killed(place: &Place) {
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_creepage"))
        .current_dir(place.path(""))
        .args(long_roll("out"))
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    while !place.path("out/history.state").exists() && child.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(
        place.path("out/history.csv.partial").exists() && place.path("out/history.state").exists()
    );
}

/// The run that was killed is run again: all files have the bytes of a run that was not.
fn ends_as_undisturbed(place: &Place) {
    place.run(&long_roll("out")).done();
    place.run(&long_roll("undisturbed")).done();
    let files = place.files_in("undisturbed");
    assert_eq!(place.files_in("out"), files);
    for name in files {
        let [one, other] = ["out", "undisturbed"].map(|dir| fs::read(place.path(dir).join(&name)));
        assert!(one.unwrap() == other.unwrap(), "{name}");
    }
}

#[test]
fn a_killed_history_goes_on_to_the_same_bytes() {
    let place = Place::new();
    place.write("case.toml", case());
    place.write("h.csv", long_history());
    killed(&place);
    ends_as_undisturbed(&place);
}

/// What was rolled with another slip, whose file has changed since, is not gone on with.
#[test]
fn a_killed_history_begins_again_where_its_slip_has_changed() {
    let place = Place::new();
    place.write(
        "case.toml",
        case().replace("friction = 0.3", "friction = 0.3\nslip = \"slip.csv\""),
    );
    place.write("h.csv", long_history());
    let slip = |along: f64| format!("x,y,longitudinal,lateral\n0,0,{along:e},0\n");
    place.write("slip.csv", slip(1e-4));
    killed(&place);
    place.write("slip.csv", slip(-2e-4));
    ends_as_undisturbed(&place);
}

/// `[contact] friction` with a law in place of the number; `[creepage] speed` where it is given.
fn falling(memory: &str, speed: &str) -> String {
    let law = format!(
        "friction = {{ law = \"exponential\", kinetic = 0.18, \
         terms = [{{ drop = 0.12, half_speed = 0.1 }}]{memory} }}"
    );
    format!("{}{speed}", case().replace("friction = 0.3", &law))
}

/// Cold rail: where slip goes on, friction falls, and the force ends below Coulomb's.
#[test]
fn friction_falls_while_it_rolls() {
    let history = "distance,longitudinal\n0.002,-3e-3\n0.03,-3e-3\n";
    let memory = ", memory_distance = 2e-6, memory_speed = 1e-3";
    let falling = falling(memory, "[creepage]\nspeed = 30.0\n");
    let forces = [case(), falling].map(|case| column(&rolled(&case, history), "longitudinal_n"));
    assert!(forces[1][1].abs() < 0.95 * forces[0][1].abs(), "{forces:?}");
}

#[test]
fn falling_friction_needs_speed_and_memory() {
    let history = "distance,longitudinal\n0.002,-3e-3\n";
    let memory = ", memory_distance = 2e-6, memory_speed = 1e-3";
    let speed = "[creepage]\nspeed = 30.0\n";
    for (case, word) in [
        (falling(memory, ""), "[creepage] speed is missing"),
        (falling("", speed), "needs its memory_distance (m) and memory_speed (m/s)"),
        (falling(memory, "[creepage]\nspeed = 30.0\nlongitudinal = 1e-3\n"), "[creepage]"),
    ] {
        let place = Place::new();
        place.write("case.toml", &case);
        place.write("h.csv", history);
        place.run(&["roll", "case.toml", "--history", "h.csv"]).refused(&[word]);
    }
}

/// Chapter 5 with a memory: near the full theory, and clear about what it does not roll.
#[test]
fn chapter_5_rolls_ellipses_under_a_constant_load() {
    let history = "distance,xi\n0.002,0.9\n0.005,0.9\n0.03,0.9\n";
    let chapter_5 = case().replace("resolution = [8, 8]", "theory = \"variational\"\ndegree = 6");
    let [full, own] = [case(), chapter_5.clone()].map(|case| column(&rolled(&case, history), "fx"));
    // Within what degree 6 is off in steady rolling and on the way there.
    assert!(full.iter().zip(&own).all(|(one, two)| (one - two).abs() < 0.05), "{full:?} {own:?}");
    let held = "distance,longitudinal_force\n0.01,-9e3\n0.03,-9e3\n";
    let forces = column(&rolled(&chapter_5, held), "longitudinal_n");
    assert!(forces.iter().all(|force| (force + 9e3).abs() < 0.1), "{forces:?}");
    let refused = |case: &str, history: &str, parts: &[&str]| {
        let place = Place::new();
        place.write("case.toml", case);
        place.write("h.csv", history);
        place.run(&["roll", "case.toml", "--history", "h.csv"]).refused(parts);
    };
    let load = "distance,xi,normal_force\n0.002,0.9,70e3\n";
    refused(&chapter_5, load, &["column normal_force", "variational", "constant load"]);
    let bad = chapter_5.replace("degree = 6", "degree = 60");
    refused(&bad, history, &["[solve]", "degree = 60"]);
}

const CLAY: &str = include_str!("../../../../examples/roll/wheel-on-clay.toml");

/// A layer that never yields is the elastic one, a layer that yields bears less; loads stay, and approximate theories
/// say what rolls with a layer.
#[test]
fn a_layer_rolls_on_with_the_wheel() {
    let history = "distance,longitudinal\n0.002,-10e-3\n0.03,-10e-3\n0.031,0\n";
    let last = |case: &str| column(&rolled(case, history), "longitudinal_n");
    let strong = CLAY.replace("yield_stress = 200e6", "yield_stress = 900e6");
    let elastic = CLAY.split("yield_stress").next().unwrap();
    let bare = CLAY.split("[layer]").next().unwrap();
    let [clay, strong, elastic, bare] = [CLAY, &strong, elastic, bare].map(last);
    for (strong, elastic) in strong.iter().zip(&elastic) {
        assert!((strong - elastic).abs() < 1e-6 * 40e3, "{strong} {elastic}");
    }
    assert!(clay[1].abs() < 0.9 * elastic[1].abs(), "{clay:?} {elastic:?}");
    assert!(elastic[0].abs() < 0.9 * bare[0].abs(), "{elastic:?} {bare:?}");
    let place = Place::new();
    let table = |text: &str| place.write("h.csv", text);
    for (case, history, word) in [
        (
            CLAY.into(),
            "distance,longitudinal,normal_force\n0.002,-3e-3,9e4\n",
            "column normal_force does not go with [layer]",
        ),
        (
            format!("{CLAY}[solve]\ntheory = \"fastsim\"\n"),
            history,
            "section [layer] does not go with theory = \"fastsim\"",
        ),
        (
            format!("{CLAY}[solve]\ntheory = \"variational\"\n"),
            history,
            "section [layer] does not go with theory = \"variational\"",
        ),
        (CLAY.replace("slope = 435e9", "slope = -6e12"), history, "slope"),
    ] {
        place.write("case.toml", &case);
        table(history);
        place.run(&["roll", "case.toml", "--history", "h.csv"]).refused(&[word]);
    }
}

/// What a contact is in doubt for is said of its history as of its steady rolling.
#[test]
fn doubts_about_the_contact_are_said() {
    let said = |case: &str| {
        let place = Place::new();
        place.write("case.toml", case);
        place.write("h.csv", "distance,longitudinal\n0.002,-1e-3\n");
        let ran = place.run(&["roll", "case.toml", "--history", "h.csv"]);
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        ran.stderr
    };
    let line = case().replace("normal_force = 80e3", "line_load = 4e6\nlength = 0.1");
    let line =
        line.replacen("radius_lateral = \"flat\"\n", "", 1).replace("radius_lateral = 0.3\n", "");
    let layer = |thickness: f64| {
        let case = case();
        format!("{case}[layer]\nthickness = {thickness}\nshear_modulus = 1e9\n")
    };
    for (case, word) in [
        (layer(5e-3), "of the contact's half-width"),
        (case().replace("normal_force = 80e3", "normal_force = 80e9"), "check the unit"),
        (line.replacen("shear_modulus = 82e9", "shear_modulus = 26e9", 1), "like ones"),
    ] {
        assert!(said(&case).contains(word), "{word}: {}", said(&case));
    }
    let line = line.replace("resolution = [8, 8]\n", "");
    for case in [case(), line, layer(5e-4)] {
        assert_eq!(said(&case), "");
    }
}

/// One wheel of S1002 on UIC 60.
const WHEEL: &str = "[wheel]\nprofile = \"S1002\"\nradius = 0.46\n[rail]\nprofile = \"UIC60\"\ncant = 0.025\n[track]\n\
                     gauge = 1.435\ngauge_height = 0.014\n[wheelset]\nback_to_back = 1.360\nside = \"right\"\nroll = 0.0\n\
                     wheel_load = 50e3\n[motion]\nspeed = 20.0\npitch_rate = 43.522\n[contact]\nfriction = 0.3\n\
                     [materials]\nshear_modulus = 82e9\npoisson = 0.28\n[solve]\nresolution = \"fast\"\n";

#[test]
fn wheels_roll_in_steps() {
    let values = |csv: &str, column: usize| -> Vec<f64> {
        csv.lines()
            .skip(1)
            .map(|line| line.split(',').nth(column).unwrap().parse().unwrap())
            .collect()
    };
    let rows: Vec<String> = (1..=20).map(|k| (0.002 * f64::from(k)).to_string()).collect();
    let csv = rolled(WHEEL, &format!("distance\n{}\n", rows.join("\n")));
    assert!(csv.starts_with("distance_m,left_longitudinal_n,"), "{csv}");
    let along = values(&csv, 8);
    // It drives: the rail is pushed back, more and more, to what steady rolling has.
    assert!(along.windows(2).all(|pair| pair[1] < pair[0] + 1.0), "{along:?}");
    let steady = rolled(&format!("{WHEEL}[start]\ntraction = \"steady\"\n"), "distance\n0.001\n");
    let missed = (values(&steady, 8)[0] - along[19]).abs() / (0.3 * 50e3);
    assert!(missed < 5e-3, "{missed}");

    let moved = rolled(WHEEL, "distance,y,wheel_load\n0.002,0.0,50e3\n0.004,0.001,55e3\n");
    assert!((values(&moved, 10)[1] / 55e3 - 1.0).abs() < 0.01);

    let place = Place::new();
    place.write("case.toml", format!("{WHEEL}[damage]\n"));
    place.write("h.csv", "distance\n0.001\n");
    let ran = place.run(&["roll", "case.toml", "--history", "h.csv"]);
    assert!(ran.stderr.contains("[damage] is left out"), "{}", ran.stderr);
    place.run(&["roll", "case.toml", "--history", "h.csv", "--out", "out"]).done();
    assert!(place.read("out/history.csv").lines().count() == 2);
    // Pictures go with their table, and nothing of another contact stands beside them.
    assert!(place.read("out/history.svg").contains("<svg"));
    assert!(place.path("out/history.png").is_file());
    place.write("out/adhesion.svg", "");
    let again = place.run(&["roll", "case.toml", "--history", "h.csv", "--out", "out"]);
    again.refused(&["adhesion.svg", "another --out"]);
}

#[test]
fn rails_on_springs_do_not_roll_in_steps() {
    let springs = "stiffness_y = 1e7\nstiffness_z = 1e7\nforce_y = 0.0\nforce_z = 0.0\n[track]";
    refused(
        &WHEEL.replacen("[track]", springs, 1),
        "distance\n0.001\n",
        &["stiffness_z", "rigid rails"],
    );
}

#[test]
fn wheels_that_cannot_roll_in_steps_are_told_so() {
    refused(WHEEL, "distance,z,wheel_load\n0.001,0.0,50e3\n", &["wheel_load", "z"]);
    refused(WHEEL, "distance,hight\n0.001,0.0\n", &["hight"]);
    refused(WHEEL, "distance;y\n0,002;0,0\n0,001;0,0\n", &["row 2", "distance = 0.001 m"]);
    let free = WHEEL.replace("pitch_rate = 43.522", "pitch_rate = \"free\"");
    refused(&free, "distance\n0.001\n", &["pitch_rate"]);
    refused(WHEEL, "distance,speed\n0.001,0\n", &["speed above zero"]);
    let simple = WHEEL.replace("resolution = \"fast\"", "theory = \"fastsim\"");
    refused(&simple, "distance\n0.001\n", &["exact"]);
}

#[test]
fn a_spreadsheets_separators_are_those_of_a_history() {
    let fastsim = case().replace("resolution = [8, 8]", "theory = \"fastsim\"\ngrid = [9, 9]");
    let expected = rolled(&fastsim, "distance,longitudinal\n0.003,-0.001\n0.006,0.001\n");
    let semicolons = "# a rig\ndistance;longitudinal\n0,003;-0,001\n0,006;1e-3\n";
    assert_eq!(rolled(&fastsim, semicolons), expected);
    let tabs = "\u{feff}distance\tlongitudinal\n0.003\t-0.001\n0.006\t0.001\n";
    assert_eq!(rolled(&fastsim, tabs), expected);
}

/// A component by force in one row and by creepage in the next: each row has one of the two.
#[test]
fn forces_and_creepages_take_turns() {
    let history = "distance,longitudinal_force,longitudinal\n0.003,-9e3,\n0.006,,-1e-3\n";
    let csv = rolled(&case(), history);
    let newtons = column(&csv, "longitudinal_n");
    assert!((newtons[0] + 9e3).abs() < 1.0, "{csv}");
    // The creepage of the second row in the contact's unit is that of a row by creepage.
    let plain = rolled(&case(), "distance,longitudinal\n0.006,-1e-3\n");
    assert!((column(&csv, "xi")[1] - column(&plain, "xi")[0]).abs() < 1e-12, "{csv}");
    for (row, words) in [("0.003,,", "0 are"), ("0.003,-9e3,-1e-3", "2 are")] {
        let place = Place::new();
        place.write("case.toml", case());
        place.write("h.csv", format!("distance,longitudinal_force,longitudinal\n{row}\n"));
        let ran = place.run(&["roll", "case.toml", "--history", "h.csv"]);
        ran.refused(&["row 1", "one of the two", words]);
    }
}
